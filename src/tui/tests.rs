//! The viewer without a terminal: what keys do, and that every size of screen can be drawn.

mod any_keys;
mod finding;
mod lines;
mod lists;
mod messages;
mod places;
mod rows;
mod stepping;

use super::dump::dump;
use super::testing::{flat, glass, nested, sized, textbook, typed};
use super::*;
use crate::log::{Step, What};

/// Types `keys` at the numeric example; the selected node then has this title.
#[track_caller]
fn leads_to(keys: &str, title: &str) {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, keys);
    let found = crate::report::words::title(Language::English, &model.log, &model.tree, model.cursor);
    assert_eq!(found, title, "after {keys}");
}

#[test]
fn moving_in_the_tree() {
    leads_to("", "ray C, from the eye");
    leads_to("j", "test plane");
    leads_to("2j", "test sphere");
    leads_to("2jk", "test plane");
    leads_to("G", "weighted sum");
    leads_to("Gg", "pixel 160,120");
    leads_to("jJ", "test sphere");
    leads_to("2jK", "test plane");
    leads_to("jh", "ray C, from the eye");
    leads_to("l", "test plane");
    leads_to("k", "pixel 160,120");
    leads_to("99k99j", "weighted sum");
    leads_to("PgDn PgUp", "pixel 160,120");
}

#[test]
fn folding() {
    leads_to("h j", "ray C, from the eye");
    leads_to("Space l l", "test plane");
    leads_to("j G g j C j", "ray C, from the eye");
    leads_to("j c j", "test sphere");
    leads_to("g C G", "pixel 160,120");
    leads_to("g C E G", "weighted sum");
}

/// Types `keys` at the numeric example; the current step is then this quantity.
#[track_caller]
fn steps_to(keys: &str, key: &str) {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, keys);
    let What::Note { name, .. } = model.log.events[model.event].what else {
        panic!("after {keys} at {:?}", model.log.events[model.event]);
    };
    assert_eq!(name.key(), key, "after {keys}");
    assert_eq!(model.tree.owner(model.event), model.cursor);
    assert_eq!(model.fold.row_of(&model.tree, model.cursor), model.cursor);
}

#[test]
fn stepping() {
    steps_to("n", "ray.length");
    steps_to("3n", "plane.v_d");
    steps_to("3np", "ray.direction");
    steps_to("3nN", "ray.direction");
    steps_to("2n]]", "plane.v_d");
    steps_to("g C 3n", "plane.v_d");
    steps_to("3G", "ray.direction");
}

#[test]
fn stepping_stops_at_both_ends() {
    let mut model = sized(textbook(), 100, 30);
    let count = model.log.events.len();
    assert_eq!(typed(&mut model, "9999n"), Effect::None);
    assert_eq!(model.step(), count);
    assert_eq!(typed(&mut model, "n"), Effect::None);
    assert!(model.message.take().is_some_and(|message| message.text.contains("no more computed values")));
    assert_eq!(typed(&mut model, "9999["), Effect::None);
    assert_eq!(model.step(), 1);
    typed(&mut model, "[");
    assert!(model.message.is_some());
}

#[test]
fn rays_are_stepped_both_ways() {
    let mut model = sized(glass(), 100, 30);
    let mut there = vec![model.cursor];
    while model.message.is_none() {
        typed(&mut model, "}");
        there.push(model.cursor);
    }
    there.pop();
    assert!(there.len() > 20, "{} rays", there.len());
    for node in there.iter().rev().skip(1) {
        typed(&mut model, "{");
        assert_eq!(model.cursor, *node);
    }
}

#[test]
fn the_computation_is_walked_where_it_has_the_focus() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "j l");
    assert_eq!(model.focus, Pane::Computation);
    typed(&mut model, "j");
    assert_eq!(model.step(), 5);
    typed(&mut model, "99j");
    assert_eq!(model.log.events[model.event].what, What::Leave);
    typed(&mut model, "99k");
    assert_eq!(model.step(), 4);
    typed(&mut model, "h");
    assert_eq!(model.focus, Pane::Tree);
}

#[test]
fn leaving() {
    let mut model = sized(textbook(), 100, 30);
    assert_eq!(typed(&mut model, "?q"), Effect::None);
    assert_eq!(typed(&mut model, "q"), Effect::Leave(Exit::Quit));
    // What lies over the panes, and a line, are closed by it first.
    assert_eq!((typed(&mut model, "?^c"), model.overlay), (Effect::None, None));
    assert_eq!((typed(&mut model, "w^c"), model.overlay), (Effect::None, None));
    assert_eq!((typed(&mut model, "/ab^c"), model.prompt.is_none()), (Effect::None, true));
    assert_eq!(typed(&mut model, "^c"), Effect::Leave(Exit::Interrupted));
    assert_eq!(typed(&mut model, "Esc ^z"), Effect::Suspend);
}

#[test]
fn warnings_stay_until_they_are_dismissed() {
    let options = Options {
        theme: Theme::new(Palette::None, false),
        start: Some(1_000_000),
        warning: Some("cut off".to_owned()),
        note: None,
        numbers: Default::default(),
        language: Default::default(),
        controls: Default::default(),
    };
    let mut model = opened(textbook(), &options);
    assert_eq!(model.step(), model.log.events.len());
    let bottom =
        |model: &Model| dump(&frame(model, 100, 30, &options.theme)).lines().nth(29).unwrap_or_default().to_owned();
    typed(&mut model, "ppp");
    assert!(bottom(&model).ends_with("warning: cut off"), "{}", bottom(&model));
    // What a key answers hides it until the next one.
    typed(&mut model, "b");
    typed(&mut model, "nonsense Enter");
    assert!(bottom(&model).starts_with("break at: ") && model.message.is_some(), "{}", bottom(&model));
    typed(&mut model, "Esc y");
    assert!(bottom(&model).contains("sent to the terminal's clipboard: "), "{}", bottom(&model));
    typed(&mut model, "p");
    assert!(bottom(&model).ends_with("warning: cut off"), "{}", bottom(&model));
    typed(&mut model, "Esc");
    assert_eq!((&model.message, &model.warning), (&None, &None));
}

#[test]
fn positions_lead_back() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "7n");
    let back = position(&model);
    assert_eq!(back, Position { pixel: Some([160, 120]), at: model.step() as u32 });
}

const SIZES: [(u16, u16); 14] = [
    (0, 0),
    (1, 1),
    (0, 10),
    (10, 0),
    (19, 5),
    (20, 6),
    (21, 100),
    (40, 12),
    (79, 19),
    (80, 6),
    (80, 24),
    (81, 25),
    (200, 60),
    (300, 100),
];

#[test]
fn every_step_can_be_drawn_at_every_size() {
    for log in [textbook(), glass(), nested(""), nested("."), nested("((("), nested(")))")] {
        for (width, height) in SIZES {
            let mut model = sized(log.clone(), width, height);
            let stride = model.log.events.len() / 50 + 1;
            for (number, keys) in (0..model.log.events.len() / stride + 10)
                .zip([",", "?", "Esc Tab", "h", "/", "Esc t", "Esc B", "Esc :"].iter().cycle())
            {
                typed(&mut model, keys);
                let theme = Theme::new([Palette::None, Palette::Indexed, Palette::True][number % 3], number % 2 == 0);
                let buffer = frame(&model, width, height, &theme);
                assert_eq!(buffer.area, Rect::new(0, 0, width, height));
                // A frame of another size than the model knows of comes before a resize.
                frame(&model, height, width, &theme);
                typed(&mut model, &format!("Esc {stride}]"));
            }
        }
    }
}

#[test]
fn the_current_step_is_always_on_the_screen() {
    let theme = Theme::new(Palette::None, false);
    for (width, height) in [(20, 6), (40, 12), (40, 30), (80, 6), (80, 24), (200, 60)] {
        let mut model = sized(glass(), width, height);
        model.focus = Pane::Computation;
        for _ in 0..model.log.events.len() {
            let text = dump(&frame(&model, width, height, &theme));
            let marks = text.matches("▶ ").count();
            // The focus, the step, and on a large screen its line of the algorithm.
            let expected = if width >= 140 { 3 } else { 2 };
            assert_eq!(marks, expected, "step {} at {width}x{height}:\n{text}", model.step());
            typed(&mut model, "]");
        }
    }
}

#[test]
fn a_hit_shows_its_distance_whatever_else_is_named() {
    let model = sized(flat(), 100, 30);
    let tests =
        (1..model.tree.nodes().len()).filter(|node| matches!(model.tree.nodes()[*node].step, Some(Step::Test { .. })));
    let shown = |node: usize| match model.facts.value(node).map(|event| &model.log.events[event].what) {
        Some(What::Note { name, .. }) => name.key(),
        _ => "nothing",
    };
    assert_eq!(tests.map(shown).collect::<Vec<_>>(), ["disk.t", "polygon.t"]);
}

#[test]
fn ascii_is_ascii() {
    let mut model = sized(glass(), 120, 40);
    for _ in 0..60 {
        let text = dump(&frame(&model, 120, 40, &Theme::new(Palette::None, true)));
        assert!(text.is_ascii(), "{text}");
        typed(&mut model, "7n");
    }
    typed(&mut model, "?");
    assert!(dump(&frame(&model, 120, 40, &Theme::new(Palette::None, true))).is_ascii());
}

#[test]
fn without_colours_there_are_none() {
    let mut model = sized(glass(), 120, 40);
    typed(&mut model, "20n");
    let plain = frame(&model, 120, 40, &Theme::new(Palette::None, false));
    assert!(plain.content().iter().all(|cell| cell.fg == ratatui::style::Color::Reset));
    let colored = frame(&model, 120, 40, &Theme::new(Palette::True, false));
    let text = |buffer: &Buffer| buffer.content().iter().map(|cell| cell.symbol().to_owned()).collect::<String>();
    assert_eq!(text(&plain), text(&colored));
}

#[test]
fn pictures_show_the_viewer_after_some_keys() {
    let options = Options {
        theme: Theme::new(Palette::True, false),
        start: None,
        warning: None,
        note: None,
        numbers: Default::default(),
        language: Default::default(),
        controls: Default::default(),
    };
    let svg = picture(textbook(), &options, None, "3n", (80, 24));
    assert!(svg.contains("step 5/98"), "{svg}");
    assert!(svg.contains("V_d"), "{svg}");
}

#[test]
fn a_log_that_was_cut_off_claims_nothing_that_it_does_not_hold() {
    let whole = glass();
    let theme = Theme::new(Palette::None, false);
    let is_shadow = |event: &crate::log::Event| {
        matches!(event.what, What::Enter { step: Step::Ray { kind: crate::log::RayKind::Shadow { .. }, .. }, .. })
    };
    let begins = whole.events.iter().position(is_shadow).unwrap_or_default();
    let shown = |events: usize| {
        let mut log = whole.clone();
        log.events.truncate(events);
        let mut model = sized(log, 200, 60);
        typed(&mut model, "E");
        dump(&frame(&model, 200, 60, &theme))
    };
    assert!(!shown(begins + 1).contains("lit"));
    assert!(!shown(begins + 1).contains("local model on ball  ("));
    assert!(shown(whole.events.len()).contains("lit"));
}

#[test]
fn large_logs_stay_usable() {
    let log = nested(&"((.).)".repeat(170_000));
    assert!(log.events.len() > 1_000_000);
    let mut model = sized(log, 120, 40);
    let theme = Theme::new(Palette::None, false);
    // How long a frame takes is measured in `benches/viewer`.
    for keys in
        ["G", "g", "E", "G", "g", "1000j", "1000000G", "{", "PgUp", "/V_d Enter", ";", "f1700 Enter", "G", "gu", "999o"]
    {
        typed(&mut model, keys);
        for _ in 0..10 {
            frame(&model, 120, 40, &theme);
        }
        if keys == "1000000G" {
            assert_eq!(model.step(), 1_000_000);
        }
    }
    // Breakpoints and watches find their places once: a run and a frame look them up.
    typed(&mut model, "bplane.v_d>1000000 Space and Space sample Enter * 0r");
    assert_eq!(model.step(), 1_000_001);
    typed(&mut model, ":watch Space plane.v_d Enter");
    for keys in ["g", "G", "r", "#"] {
        typed(&mut model, keys);
        (0..10).for_each(|_| _ = frame(&model, 120, 40, &theme));
    }
    typed(&mut model, "Esc");
    // The search was made as far as it was asked for; what is left is looked at while nothing else is to be done.
    let place = |model: &Model| model.guide.search.as_ref().map(|search| search.place(0, &model.texts().status));
    assert_eq!(place(&model).as_deref(), Some("counting matches"));
    (0..8).for_each(|_| search::look_on(&mut model));
    // The search and the filter have found the one quantity that the log has, twice in each of its parts.
    assert!(place(&model).is_some_and(|place| place.ends_with("/340000")));
}
