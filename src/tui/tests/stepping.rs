//! What the keys of [`Walk`] do: stepping, breakpoints, playing, growing.

use super::lines::said;
use super::*;
use crate::log::RayKind;
use crate::tui::listing::listing;

/// Types `keys` at a model; the current step is then this one, from 1.
#[track_caller]
fn goes(model: &mut Model, keys: &str, step: usize) {
    assert_eq!(typed(model, keys), Effect::None, "{keys}");
    assert_eq!(model.step(), step, "after {keys}: {}", said(model));
    assert_eq!(model.fold.row_of(&model.tree, model.cursor), model.cursor, "after {keys}");
}

#[test]
fn into_over_and_out() {
    // Steps 1 to 12: ( . ( . . ) . ( . ) . )
    let mut model = sized(nested("(.(..).(.).)"), 100, 30);
    goes(&mut model, "s", 2);
    goes(&mut model, "s", 3);
    goes(&mut model, "So", 7);
    goes(&mut model, "O", 2);
    goes(&mut model, "2o", 11);
    goes(&mut model, "2O", 2);
    goes(&mut model, "3s", 5);
    goes(&mut model, "u", 7);
    goes(&mut model, "2SU", 2);
    goes(&mut model, "99s", 12);
    goes(&mut model, "99S", 1);
    goes(&mut model, "$", 12);
    goes(&mut model, "0", 1);
    goes(&mut model, "10s", 11);
    goes(&mut model, "1G", 1);
}

#[test]
fn every_way_to_step_says_where_it_ends() {
    let mut model = sized(nested("(.(..).(.).)"), 100, 30);
    for (at, key) in [("0", "S"), ("0", "O"), ("0", "U"), ("$", "s"), ("$", "o"), ("$", "u"), ("0", "u")] {
        typed(&mut model, at);
        let step = model.step();
        goes(&mut model, key, step);
        assert!(said(&model).contains("in this direction"), "{at}{key}: {}", said(&model));
    }
    let mut empty = sized(nested(""), 100, 30);
    for key in ["s", "S", "o", "O", "u", "U", "0", "$", "b", "Esc x", "r", "P", "t", "y", "Y", "mq", "'q", "''", ";"] {
        goes(&mut empty, key, 0);
    }
}

/// Types a line behind a key and ends it.
fn line(model: &mut Model, key: &str, text: &str) -> Effect {
    let spelled: Vec<_> = text.split(' ').map(|word| word.chars().map(String::from).collect::<Vec<_>>()).collect();
    let spelled: Vec<_> = spelled.iter().map(|word| word.join(" ")).collect();
    typed(model, &format!("{key} {} Enter", spelled.join(" Space ")))
}

#[test]
fn runs_stop_at_breakpoints() {
    let mut model = sized(glass(), 100, 30);
    typed(&mut model, "r");
    assert_eq!(said(&model), "no breakpoints; b sets one");
    line(&mut model, "b", "kind shadow");
    assert!(said(&model).starts_with("breakpoint: kind shadow"), "{}", said(&model));
    let is_shadow = |event: &crate::log::Event| {
        matches!(event.what, What::Enter { step: Step::Ray { kind: RayKind::Shadow { .. }, .. }, .. })
    };
    let shadows: Vec<_> =
        (1..).zip(&model.log.events).filter(|(_, event)| is_shadow(event)).map(|(at, _)| at).collect();
    assert!(shadows.len() > 3);
    goes(&mut model, "r", shadows[0]);
    assert!(said(&model).contains("stopped by kind shadow: ray C S1"), "{}", said(&model));
    goes(&mut model, "2r", shadows[2]);
    goes(&mut model, "R", shadows[1]);
    goes(&mut model, "9999r", *shadows.last().unwrap_or(&0));
    assert!(said(&model).ends_with("of 9999 times; no breakpoint stops after this step"), "{}", said(&model));
    goes(&mut model, "r", *shadows.last().unwrap_or(&0));
    assert_eq!(said(&model), "no breakpoint stops after this step");
    goes(&mut model, "9999R", shadows[0]);
    goes(&mut model, "R", shadows[0]);
    assert_eq!(said(&model), "no breakpoint stops before this step");
    assert!(model.guide.stops.len() > 3);
    // The log of stops opens at the latest, and leads back.
    typed(&mut model, "L");
    let stops = listing(&model, Kind::Stops).entries;
    assert!(stops[0].text.starts_with(&format!("{}\t\tkind shadow\tray C S1", shadows[0])), "{}", stops[0].text);
    goes(&mut model, "k Enter", shadows[1]);
    assert_eq!(model.overlay, None);
}

#[test]
fn mistakes_in_breakpoints_are_said() {
    let mut model = sized(glass(), 100, 30);
    line(&mut model, "b", "object bal");
    assert!(said(&model).contains("did you mean `ball`?"), "{}", said(&model));
    assert!(model.guide.breakpoints.is_empty());
    typed(&mut model, "Esc");
    line(&mut model, "b", "");
    assert_eq!((said(&model), model.guide.breakpoints.len()), ("", 0));
}

#[test]
fn breakpoints_are_toggled_where_one_is() {
    let mut model = sized(textbook(), 100, 30);
    let text = |model: &Model| model.guide.breakpoints.iter().map(|one| one.text.clone()).collect::<Vec<_>>();
    typed(&mut model, "nx");
    assert_eq!(text(&model), ["ray.length"]);
    typed(&mut model, "x");
    assert!(text(&model).is_empty());
    // The ray's node, from its end too; a decision.
    typed(&mut model, "0x");
    assert_eq!(text(&model), ["camera"]);
    typed(&mut model, "$x");
    assert_eq!(text(&model), ["camera", "result"]);
    line(&mut model, ":", "break hit");
    typed(&mut model, "0 r x");
    assert_eq!(text(&model), ["camera", "result"]);
}

#[test]
fn breakpoints_are_listed() {
    let mut model = sized(textbook(), 100, 30);
    for text in ["hit", "T2_A < 0", "V_d ~ 0"] {
        line(&mut model, "b", text);
    }
    typed(&mut model, "B");
    let texts = |model: &Model| {
        listing(model, Kind::Breakpoints).entries.into_iter().map(|entry| entry.text).collect::<Vec<_>>()
    };
    assert_eq!(texts(&model), ["on\t0\t2\thit", "on\t0\t2\tT2_A < 0", "on\t0\t0\tV_d ~ 0"]);
    typed(&mut model, "j Space");
    assert_eq!(texts(&model), ["on\t0\t2\thit", "off\t0\t2\tT2_A < 0", "on\t0\t0\tV_d ~ 0"]);
    typed(&mut model, "j d");
    assert_eq!(texts(&model), ["on\t0\t2\thit", "off\t0\t2\tT2_A < 0"]);
    assert_eq!(model.overlay, Some(Overlay::List { kind: Kind::Breakpoints, selected: 1, shift: 0 }));
    // Enter goes to the next place of one that is off, too, and around the end.
    let places = |model: &Model, text: &str| {
        let condition = crate::tui::model::breakpoint::parse(text, &model.log, &model.texts().breakpoints)
            .unwrap_or_else(|why| panic!("{why}"));
        let run = crate::report::side_by_side::Run { log: &model.log, tree: &model.tree };
        let held = (0..model.log.events.len()).filter(|event| condition.stops_at(run, *event, model.numbers));
        held.map(|event| event + 1).collect::<Vec<_>>()
    };
    let hits = places(&model, "hit");
    goes(&mut model, "k Enter", hits[0]);
    goes(&mut model, "$ B Enter", hits[0]);
    typed(&mut model, "B d d d");
    assert!(texts(&model).is_empty());
    typed(&mut model, "Esc");
    assert_eq!(model.overlay, None);
    line(&mut model, "b", "hit");
    typed(&mut model, "B Space Esc r");
    assert_eq!(said(&model), "all breakpoints are off; B lists them");
}

fn tick(model: &mut Model) {
    update(model, Action::Walk(Walk::Tick));
}

#[test]
fn playing_steps_by_values_until_something_stops_it() {
    let mut model = sized(textbook(), 100, 30);
    let interval = |model: &Model| crate::tui::play::interval(model).map(|time| time.as_millis());
    tick(&mut model);
    goes(&mut model, "", 1);
    typed(&mut model, "P");
    assert_eq!(interval(&model), Some(1000));
    tick(&mut model);
    let mut stepped = sized(textbook(), 100, 30);
    typed(&mut stepped, "n");
    assert_eq!(model.step(), stepped.step());
    typed(&mut model, "++");
    assert_eq!(interval(&model), Some(250));
    typed(&mut model, "+++++++++");
    assert_eq!(interval(&model), Some(31));
    typed(&mut model, "---------");
    assert_eq!(interval(&model), Some(1000));
    // It waits for lists and for lines, and goes on.
    typed(&mut model, "?");
    assert_eq!(interval(&model), None);
    typed(&mut model, "Esc :");
    assert_eq!(interval(&model), None);
    typed(&mut model, "Esc");
    assert_eq!(interval(&model), Some(1000));
    // A count that is being typed survives a tick.
    typed(&mut model, "5");
    tick(&mut model);
    assert_eq!(model.pending.count, Some(5));
    typed(&mut model, "Esc");
    assert_eq!(interval(&model), None);
}

#[test]
fn playing_ends_at_breakpoints_and_at_the_end() {
    let mut model = sized(textbook(), 100, 30);
    line(&mut model, "b", "hit");
    typed(&mut model, "P");
    (0..1000).for_each(|_| tick(&mut model));
    assert!(!model.guide.pace.is_playing);
    assert!(said(&model).starts_with("stopped by hit"), "{}", said(&model));
    typed(&mut model, "BdEsc P");
    (0..1000).for_each(|_| tick(&mut model));
    assert_eq!(said(&model), "played to the last computed value");
    assert!(!model.guide.pace.is_playing);
    typed(&mut model, "P");
    assert!(!model.guide.pace.is_playing && said(&model).contains("no more computed values"));
}

#[test]
fn the_tree_grows_with_the_steps() {
    let mut model = sized(textbook(), 100, 30);
    let rows =
        |model: &Model| std::iter::successors(Some(0), |row| model.fold.below(&model.tree, *row)).collect::<Vec<_>>();
    let all = rows(&model);
    typed(&mut model, "t");
    let mut before = rows(&model);
    assert_eq!(before, [0, 1]);
    for _ in 0..model.log.events.len() {
        typed(&mut model, "s");
        let now = rows(&model);
        assert!(now.starts_with(&before), "{now:?} after {before:?}");
        let begun = |node: &usize| model.tree.nodes()[*node].events.start <= model.event;
        assert!(now.iter().all(begun));
        before = now;
    }
    assert_eq!(before, all);
    typed(&mut model, "0");
    assert_eq!(rows(&model), [0, 1]);
    let text = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(text.contains("growing") && !text.contains("hit"), "{text}");
    for key in ["w", "a", "D"] {
        assert_eq!(typed(&mut model, key), Effect::None);
        assert!(model.overlay.is_none() && said(&model).contains("t shows the whole tree"), "{key}: {}", said(&model));
    }
    // At the end everything is shown, up to the pixel's colour; the end of a node where it has ended.
    typed(&mut model, "$ w");
    assert_eq!(model.overlay, Some(Overlay::List { kind: Kind::Contributions, selected: 0, shift: 0 }));
    typed(&mut model, "Esc S w");
    assert!(model.overlay.is_none(), "before the result");
    assert_eq!(typed(&mut model, "a"), Effect::Compare);
    // A bookmark that lies ahead again doesn't tell its value.
    typed(&mut model, "0 4n ma 0 M");
    let text = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(text.contains("not computed yet"), "{text}");
    typed(&mut model, "Esc");
    // Nothing that is to come is walked to, copied or counted as known.
    typed(&mut model, "99j J l l j");
    assert!(model.cursor <= 1 && model.event == 0);
    typed(&mut model, "h t");
    assert_eq!(rows(&model), all);
}
