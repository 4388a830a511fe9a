//! What a search finds, and in which order.

use super::*;
use crate::log::RayKind;
use crate::tui::testing::{glass, nested, textbook};

fn search(log: &Log, text: &str) -> Search {
    let (model, mut search) = (Model::new(log.clone()), Search::new(text, 0, log.events.len()));
    look(&model, &mut search, usize::MAX);
    search
}

#[track_caller]
fn finds(log: &Log, text: &str, expected: usize) {
    assert_eq!(search(log, text).found.len(), expected, "{text}");
}

#[test]
fn what_is_searched() {
    let log = textbook();
    let count = |is: &dyn Fn(&What) -> bool| log.events.iter().filter(|event| is(&event.what)).count();
    let symbols = count(&|what| matches!(what, What::Note { name, .. } if name.symbol() == "T2_A"));
    assert!(symbols > 0);
    // The symbol, the key, the symbol in lower case.
    finds(&log, "T2_A", symbols);
    finds(&log, "sphere.t2_a", symbols);
    finds(&log, "t2_a", symbols);
    finds(&log, "T2_a", 0);
    // The words of a decision, the title of a node, a value, a symbol as it is written in ASCII.
    finds(&log, "nearest: sphere", 1);
    finds(&log, "local model on", count(&|what| matches!(what, What::Enter { step: Step::Shade { .. }, .. })));
    assert!(!search(&log, "13.24").found.is_empty());
    assert!(!search(&log, "N*L").found.is_empty());
    finds(&log, "no such text", 0);
}

#[test]
fn rays_are_found_by_path_and_by_what_they_are_for() {
    let log = glass();
    let rays = |is: &dyn Fn(RayKind) -> bool| {
        let is_ray = |what: &What| matches!(what, What::Enter { step: Step::Ray { kind, .. }, .. } if is(*kind));
        log.events.iter().filter(|event| is_ray(&event.what)).count()
    };
    finds(&log, "ray C T R", rays(&|_| true).min(search(&log, "C T R").found.len()));
    finds(&log, "shadow ray to behind the wall", rays(&|kind| kind == RayKind::Shadow { light: 1 }));
}

#[test]
fn matches_follow_one_another_around_the_end() {
    let log = nested("..(.)");
    // The third and the fifth event begin and end a node; all others are values.
    let search = search(&log, "v_d");
    assert_eq!(search.found, [0, 1, 3]);
    let next = |event, times| search.next(event, true, times);
    assert_eq!([next(0, 1), next(1, 1), next(2, 1)], [Some((1, false)), Some((3, false)), Some((3, false))]);
    assert_eq!([next(3, 1), next(0, 3), next(4, 2)], [Some((0, true)), Some((0, true)), Some((1, true))]);
    let previous = |event, times| search.next(event, false, times);
    assert_eq!(
        [previous(4, 1), previous(3, 1), previous(3, 2)],
        [Some((3, false)), Some((1, false)), Some((0, false))]
    );
    assert_eq!([previous(0, 1), previous(1, 2), previous(2, 3)], [Some((3, true)), Some((3, true)), Some((3, true))]);
    assert_eq!(search.next(0, true, usize::MAX).map(|(_, around)| around), Some(true));
    assert_eq!(search.next(0, false, usize::MAX).map(|(_, around)| around), Some(true));
    let status = &Language::English.texts().viewer.status;
    assert_eq!((search.place(1, status), search.place(2, status)), ("match 2/3".to_owned(), "match -/3".to_owned()));
}

/// Wherever a search begins and however far it has looked, what it knows of the next match is so.
#[test]
fn what_is_known_early_is_found_in_the_end() {
    let log = nested("..(.)..(...)((.)).");
    let whole = search(&log, "v_d");
    let count = log.events.len();
    let mut known_early = 0;
    for start in 0..count {
        let mut model = Model::new(log.clone());
        model.go_to_event(start);
        for slice in 1..=count {
            let mut search = new(&model, "v_d");
            while !search.is_complete() {
                look(&model, &mut search, slice);
                for event in (0..count).filter(|_| !search.is_complete()) {
                    let known = search.next_known(event);
                    known_early += usize::from(known.is_some());
                    let next = whole.next(event, true, 1).map(|(event, _)| event);
                    assert!(known.is_none() || known == next, "{start}, {slice}, {event}: {known:?} for {next:?}");
                }
            }
            assert_eq!(search.found, whole.found, "{start}, {slice}");
        }
    }
    assert!(known_early > 1000, "{known_early}");
}

#[test]
fn places_count_letters_whatever_their_bytes_and_case() {
    let letters = ["c", "o", "s", "φ", "_", "1", " ", "C", "O", "S"];
    assert_eq!(Pattern::of("cos").places(&letters), [0..3, 7..10]);
    assert_eq!(Pattern::of("COS").places(&letters).first(), Some(&(7..10)));
    assert_eq!(Pattern::of("φ_1").places(&letters).first(), Some(&(3..6)));
    assert!(Pattern::of("").places(&letters).is_empty());
}
