//! What a search finds, and in which order.

use super::*;
use crate::log::{Log, RayKind};
use crate::report::language::Language;
use crate::tui::testing::{glass, lit_from_behind, log_of, nested, textbook};

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

/// What is given to a step is found by its symbol, its key and its value, and only where it is given.
#[test]
fn inputs_are_found() {
    let log = textbook();
    let given = |symbol: &str| {
        let has_it = |event: &usize| log.given(*event).iter().any(|(name, _)| name.symbol() == symbol);
        (0..log.events.len()).filter(has_it).map(|event| event as u32).collect::<Vec<_>>()
    };
    for (text, symbol) in
        [("S_c", "S_c"), ("sphere.center", "S_c"), ("K_d = (0.700, 0.500, 0.400)", "K_d"), ("S_c = (17, 9, 8)", "S_c")]
    {
        let (found, given) = (search(&log, text).found, given(symbol));
        assert!(!found.is_empty() && found.iter().all(|event| given.contains(event)), "{text}: {found:?} of {given:?}");
    }
    // The wall's diffuse coefficient; no computed value has it.
    let walls = search(&log, "0.700").found;
    assert!(
        !walls.is_empty()
            && walls.iter().all(|event| given("K_d").contains(event)
                || given("K_s").contains(event)
                || given("K_e").contains(event)),
        "{walls:?}"
    );
}

/// What the rows of the tree say of their nodes is found, and the numbers that decided.
#[test]
fn what_nodes_came_to_is_found() {
    let count = |log: &Log, is: &dyn Fn(&What) -> bool| log.events.iter().filter(|event| is(&event.what)).count();
    let glass = log_of("total-reflection", crate::record::Arithmetic::F64);
    finds(
        &glass,
        "total reflection",
        count(&glass, &|what| matches!(what, What::Mark(Decision::TotalInternalReflection))),
    );
    let weakened = search(&glass, "weakened by").found;
    finds(&glass, "weakened by", count(&glass, &|what| matches!(what, What::Mark(Decision::Attenuated { .. }))));
    assert!(!weakened.is_empty() && !search(&glass, "total reflection").found.is_empty());
    let log = textbook();
    let is_shadow = |event: &crate::log::Event| {
        matches!(event.what, What::Enter { step: Step::Ray { kind: RayKind::Shadow { .. }, .. }, .. })
    };
    // Nothing blocks a light in the numeric example.
    let ends = search(&log, "lit").found.into_iter().filter(|event| log.events[*event as usize].what == What::Leave);
    assert_eq!(ends.count(), log.events.iter().filter(|event| is_shadow(event)).count());
    finds(&log, "T2_A ≥ 0: 6.380 ≥ 0", 1);
    finds(&log, "r² − L2oc", search(&log, "T2_A").found.len());
    finds(&log, "V_d = -0.946", 1);
    finds(&log, "P = O + d·t", search(&log, "hit.point").found.len());
    finds(&log, "C R reflected", 1);
    let is_behind =
        |what: &What| matches!(what, What::Mark(Decision::Skipped { why: crate::log::SkipReason::Behind, .. }));
    let glass = lit_from_behind();
    let behind = count(&glass, &is_behind);
    assert!(behind > 0);
    finds(&glass, "behind the surface", behind);
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
