//! Searching, filtering, bookmarks, copying, commands, the mouse, the help.

use super::*;
use crate::tui::list::{Kind, listing};
use crate::tui::mouse;
use crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

fn said(model: &Model) -> &str {
    model.message.as_ref().map_or("", |message| &message.text)
}

/// Types a line behind a key and ends it.
fn line(model: &mut Model, key: &str, text: &str) -> Effect {
    begin(model, key, text);
    typed(model, "Enter")
}

/// Types a line behind a key.
fn begin(model: &mut Model, key: &str, text: &str) {
    typed(model, key);
    for character in text.chars() {
        let key = if character == ' ' { "Space".to_owned() } else { character.to_string() };
        typed(model, &key);
    }
}

/// The rows of the tree, as they are drawn.
fn rows(model: &Model) -> Vec<usize> {
    std::iter::successors(Some(0), |row| model.fold.below(&model.tree, *row)).collect()
}

#[test]
fn matches_are_gone_through() {
    let mut model = sized(textbook(), 100, 30);
    line(&mut model, "/", "T2_A");
    let first = model.step();
    let key = |model: &Model| match model.log.events[model.event].what {
        What::Note { name, .. } => name.key(),
        _ => "",
    };
    assert_eq!(key(&model), "sphere.t2_a");
    let shown = |model: &Model| dump(&frame(model, 120, 30, &Theme::new(Palette::None, false)));
    assert!(shown(&model).contains("match 1/"), "{}", shown(&model));
    typed(&mut model, ";");
    assert_eq!(key(&model), "sphere.t2_a");
    assert!(model.step() > first);
    typed(&mut model, ",");
    assert_eq!(model.step(), first);
    typed(&mut model, ",");
    assert_eq!(said(&model), "from the end again");
    typed(&mut model, ";");
    assert_eq!((model.step(), said(&model)), (first, "from the beginning again"));
    typed(&mut model, "n");
    assert!(shown(&model).contains("match -/"));
    typed(&mut model, "Esc Esc");
    assert!(model.guide.search.is_none());
    typed(&mut model, ";");
    assert_eq!(said(&model), "nothing is searched for; / searches");
    line(&mut model, "/", "no such text");
    assert_eq!(said(&model), "not found: no such text");
    typed(&mut model, "^u Enter");
    assert!(model.prompt.is_none());
    line(&mut model, "/", "");
    assert_eq!(said(&model), "");
}

#[test]
fn matches_are_underlined() {
    let mut model = sized(textbook(), 100, 30);
    line(&mut model, "/", "sphere");
    typed(&mut model, "g");
    let buffer = frame(&model, 100, 30, &Theme::new(Palette::None, false));
    let underlined = |cell: &&ratatui::buffer::Cell| cell.modifier.contains(ratatui::style::Modifier::UNDERLINED);
    let text: String = buffer.content().iter().filter(underlined).map(|cell| cell.symbol()).collect();
    assert!(text.starts_with("sphere") && text.len().is_multiple_of("sphere".len()), "{text}");
}

#[test]
fn the_filter_leaves_what_matches_and_what_is_around_it() {
    let mut model = sized(glass(), 100, 40);
    let all = rows(&model);
    line(&mut model, "f", "local model");
    let kept = rows(&model);
    assert!(kept.len() < all.len() && kept.len() > 3);
    for node in &kept {
        let inside = *node..model.tree.nodes()[*node].subtree_end;
        let is_shade = |node: usize| matches!(model.tree.nodes()[node].step, Some(Step::Shade { .. }));
        assert!(inside.clone().any(is_shade) || inside.contains(&model.cursor), "row {node}");
    }
    // Rows are walked, and what is stepped to is shown all the same.
    typed(&mut model, "g");
    for row in &kept[1..] {
        typed(&mut model, "j");
        assert_eq!(model.cursor, *row);
    }
    typed(&mut model, "0 9]");
    assert!(rows(&model).contains(&model.cursor));
    let text = dump(&frame(&model, 100, 40, &Theme::new(Palette::None, false)));
    assert!(text.contains("filtered"), "{text}");
    // It can be changed, also one that was a command, and ends with nothing typed.
    line(&mut model, ":", "filter local");
    typed(&mut model, "f Up");
    assert_eq!(model.prompt.as_ref().map(|prompt| prompt.line.value()), Some("local"));
    typed(&mut model, "Esc f Enter");
    assert_eq!(model.guide.filter, None);
    assert!(rows(&model).len() >= all.len());
    line(&mut model, "f", "no such text");
    assert_eq!((said(&model), model.guide.filter.as_ref()), ("no row matches: no such text", None));
}

#[test]
fn bookmarks_lead_back() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "7n");
    let there = model.step();
    typed(&mut model, "ma $");
    typed(&mut model, "'a");
    assert_eq!(model.step(), there);
    typed(&mut model, "''");
    assert_eq!(model.step(), model.log.events.len());
    typed(&mut model, "''");
    assert_eq!(model.step(), there);
    typed(&mut model, "'b");
    assert_eq!(said(&model), "no bookmark b; mb sets it, M lists all");
    typed(&mut model, "0 M Enter");
    assert_eq!(model.step(), there);
    // Letters of other keys are letters here.
    typed(&mut model, "mq $ 'q");
    assert_eq!(model.step(), there);
    assert_eq!(model.guide.bookmarks.len(), 2);
}

/// Types `keys` at the numeric example; the current step is then this one.
#[track_caller]
fn ends_at(keys: &str, step: usize) {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, keys);
    assert_eq!(model.step(), step, "after {keys}: {}", said(&model));
}

#[test]
fn a_jump_that_does_not_move_hides_none_that_did() {
    ends_at("50G 0 ''", 50);
    ends_at("50G 0 0 ''", 50);
    ends_at("50G 0 0 0 ''", 50);
    ends_at("50G 0 0 '' ''", 1);
    ends_at("50G 50G '' '' ''", 1);
    ends_at("50G 20G ^o ^o 0 ''", 50);
    ends_at("0 ''", 1);
    // A pixel that can't be traced is no jump.
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "50G");
    let refused = line(&mut model, ":", "pixel 3,4");
    model.answer(refused, &mut None);
    typed(&mut model, "''");
    assert_eq!(model.step(), 1);
}

#[test]
fn bookmarks_outlive_another_log() {
    let mut model = sized(glass(), 100, 30);
    line(&mut model, "/", "shade.n_dot_l");
    typed(&mut model, "4;");
    let (there, path) = (model.event, model.tree.path(model.cursor));
    typed(&mut model, "ma");
    model.show(textbook());
    typed(&mut model, "'a");
    assert!(said(&model).contains("this log has no"), "{}", said(&model));
    assert!(listing(&model, Kind::Bookmarks).entries[0].target.is_none());
    model.show(glass());
    typed(&mut model, "'a");
    assert_eq!((model.event, model.tree.path(model.cursor)), (there, path));
}

#[test]
fn every_address_leads_back() {
    for log in [glass(), textbook()] {
        let tree = crate::log::Tree::of(&log.events);
        for event in (0..log.events.len()).step_by(7) {
            let address = crate::tui::address::Address::of(&log, &tree, event);
            assert_eq!(address.find(&log, &tree), Some(event), "{}", address.text());
        }
    }
}

#[test]
fn values_and_addresses_are_copied() {
    let mut model = sized(glass(), 100, 30);
    line(&mut model, "/", "shade.n_dot_l");
    let What::Note { value, .. } = model.log.events[model.event].what else { panic!("a value was searched") };
    let Effect::Copy(text) = typed(&mut model, "y") else { panic!("it is copied") };
    assert_eq!(text.parse::<f64>().ok(), Some(value.components()[0]));
    assert_eq!(typed(&mut model, "Y"), Effect::Copy("C shade.n_dot_l".to_owned()));
    // Of a node what it came to; of a decision its words.
    let Effect::Copy(text) = typed(&mut model, "0y") else { panic!("it is copied") };
    assert!(text.starts_with('(') && text.ends_with(')'), "{text}");
    assert_eq!(typed(&mut model, "Y"), Effect::Copy("C camera".to_owned()));
    line(&mut model, "b", "hit");
    assert_eq!(typed(&mut model, "ry"), Effect::Copy("hit".to_owned()));
}

#[test]
fn commands() {
    let mut model = sized(textbook(), 100, 30);
    line(&mut model, ":", "42");
    assert_eq!(model.step(), 42);
    line(&mut model, ":", "4200");
    assert_eq!((model.step(), said(&model)), (96, "there are steps 1 to 96"));
    for (text, step) in [("0", 1), ("99999999999999999999999", 96), ("-3", 1), ("3.5", 1)] {
        line(&mut model, ":", text);
        assert_eq!((model.step(), said(&model)), (step, "there are steps 1 to 96"), ":{text}");
    }
    typed(&mut model, "Esc");
    line(&mut model, ":", "break T2_A < 0");
    assert_eq!(model.guide.breakpoints.len(), 1);
    line(&mut model, ":", "search plane");
    assert!(model.guide.search.is_some());
    line(&mut model, ":", "filter plane");
    assert_eq!(model.guide.filter.as_deref(), Some("plane"));
    line(&mut model, ":", "fil");
    assert_eq!(model.guide.filter, None);
    assert_eq!(line(&mut model, ":", "pixel 3,4"), Effect::Trace([3, 4]));
    assert_eq!(line(&mut model, ":", "pix 3 4"), Effect::Trace([3, 4]));
    for (text, expected) in [
        ("pixel 3", "expected a column and a row"),
        ("pixel 3,4,5", "expected a column and a row"),
        ("pixel -3,4", "expected a column and a row"),
        ("bookmark", "expected one letter"),
        ("bookmark ab", "expected one letter"),
        ("serach x", "did you mean :search?"),
        ("b", "may be :bookmark LETTER, :bookmarks, :break CONDITION"),
        ("xyzzy", "expected a step or a command: :bookmark LETTER"),
        ("quit now", "nothing stands behind :quit"),
        ("break object x", "no object"),
    ] {
        line(&mut model, ":", text);
        assert!(said(&model).contains(expected), ":{text}: {}", said(&model));
        typed(&mut model, "Esc");
    }
    line(&mut model, ":", "bookmark z");
    assert_eq!(model.guide.bookmarks[0].letter, 'z');
    line(&mut model, ":", "mouse");
    assert!(model.guide.has_mouse);
    line(&mut model, ":", "help");
    assert_eq!(model.overlay, Some(Overlay::Help { top: 0 }));
    typed(&mut model, "Esc");
    assert_eq!(line(&mut model, ":", "q"), Effect::Leave(Exit::Quit));
    assert_eq!(line(&mut model, ":", ""), Effect::None);
}

/// Types a line that is wrong; it then stays as it is, and what is wrong is said.
#[track_caller]
fn stays(key: &str, text: &str, expected: &str) {
    let mut model = sized(glass(), 100, 30);
    begin(&mut model, key, text);
    typed(&mut model, "Left Enter");
    let prompt = model.prompt.as_ref().map(|prompt| (prompt.line.value(), prompt.line.cursor()));
    assert_eq!(prompt, Some((text, text.len() - 1)), "{key}{text}");
    assert!(said(&model).contains(expected), "{key}{text}: {}", said(&model));
    let shown = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(shown.contains(text) && shown.contains(expected), "{shown}");
    typed(&mut model, "Right");
    assert_eq!(said(&model), "", "{key}{text}");
}

#[test]
fn lines_that_are_wrong_stay_to_be_mended() {
    stays("/", "no such text", "not found");
    stays("f", "no such text", "no row matches");
    stays("b", "object bal", "did you mean `ball`?");
    stays(":", "serach", "did you mean :search?");
    stays(":", "pixel 3", "expected a column and a row");
    stays("Q n =", "x", "no number");
}

#[test]
fn a_warning_gives_way_to_what_is_wrong_with_a_line() {
    let mut model = sized(glass(), 100, 30);
    model.warn("cut off");
    line(&mut model, ":", "serach");
    assert!(said(&model).contains("did you mean :search?"), "{}", said(&model));
    typed(&mut model, "Left");
    assert_eq!(said(&model), "cut off");
    typed(&mut model, "Enter Esc");
    assert_eq!((said(&model), model.prompt.is_none()), ("cut off", true));
}

/// Types `keys` after three searches, a filter and a breakpoint; the line is then this.
#[track_caller]
fn recalls(keys: &str, expected: &str) {
    let mut model = sized(glass(), 100, 30);
    for (key, text) in [("/", "ball"), ("/", "wall"), ("/", "wall"), ("f", "ball"), ("f", ""), ("b", "hit")] {
        line(&mut model, key, text);
    }
    typed(&mut model, keys);
    assert_eq!(model.prompt.as_ref().map(|prompt| prompt.line.value()), Some(expected), "after {keys}");
}

#[test]
fn lines_are_brought_back() {
    recalls("/ Up", "wall");
    recalls("/ Up Up", "ball");
    recalls("/ Up Up Up Up", "ball");
    recalls("/ Up Up Down", "wall");
    recalls("/ x y Up Down", "xy");
    recalls("/ x y Up Down Down", "xy");
    recalls("/ Down", "");
    recalls("/ Up s Up Down", "walls");
    recalls("/ x Up s Down", "x");
    recalls("/ x Up s Down Up", "walls");
    recalls("f Up", "ball");
    recalls("b Up", "hit");
    recalls(": Up", "");
    // What was wrong is the latest.
    recalls("/ q q q q Enter", "qqqq");
    recalls("/ q q q q Enter Up", "wall");
    recalls("/ q q q q Enter Esc / Up", "qqqq");
    // What mends it isn't lost.
    recalls("/ q q q q Enter s Up Down", "qqqqs");
    recalls("/ q q q q Enter Up Down", "qqqq");
    recalls("/ q q q q Enter Down", "qqqq");
    recalls("f q q q q Enter Up Up Down", "qqqq");
    recalls(": q q q q Enter s Up Down", "qqqqs");
}

/// Types a line and `Tab`; it then says this.
#[track_caller]
fn completes(key: &str, text: &str, expected: &str) {
    let mut model = sized(glass(), 100, 30);
    begin(&mut model, key, text);
    typed(&mut model, "Tab");
    assert_eq!(model.prompt.as_ref().map(|prompt| prompt.line.value()), Some(expected), "{key}{text}");
}

#[test]
fn lines_are_completed() {
    completes(":", "se", "search ");
    completes(":", "boo", "bookmark");
    completes(":", "brea", "break");
    completes(":", "break object b", "break object ball");
    completes("b", "light beh", "light behind the wall");
    completes("b", "total", "total-internal-reflection");
    completes("b", "shade.n_dot_l", "shade.n_dot_l");
    completes("/", "se", "se");
    completes(":", "nothing", "nothing");
}

#[test]
fn the_help_is_searched() {
    let mut model = sized(textbook(), 100, 60);
    let shown = |model: &Model| dump(&frame(model, 100, 60, &Theme::new(Palette::None, false)));
    typed(&mut model, "?");
    assert!(shown(&model).contains("half a page down"));
    begin(&mut model, "/", "bookmark");
    // Already while one types.
    let text = shown(&model);
    assert!(text.contains("list the bookmarks") && !text.contains("half a page down"), "{text}");
    typed(&mut model, "Enter");
    let text = shown(&model);
    assert!(text.contains("list the bookmarks") && !text.contains("half a page down"), "{text}");
    typed(&mut model, "Esc ?");
    assert!(shown(&model).contains("half a page down"));
    begin(&mut model, "/", "no such key");
    assert!(shown(&model).contains("no key does that"));
}

fn mouse_event(kind: MouseEventKind, column: u16, row: u16) -> MouseEvent {
    MouseEvent { kind, column, row, modifiers: KeyModifiers::NONE }
}

#[test]
fn the_mouse_selects_and_scrolls() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "^t");
    assert!(model.guide.has_mouse);
    let at = |model: &mut Model, kind, column, row| {
        if let Some(action) = mouse::meant(model, mouse_event(kind, column, row)) {
            update(model, action);
        }
    };
    let press = MouseEventKind::Down(MouseButton::Left);
    let body = crate::tui::layout::Layout::body(model.layout(model.size).area(Pane::Tree));
    at(&mut model, press, body.x + 5, body.y + 2);
    assert_eq!(model.cursor, 2);
    at(&mut model, press, body.x + 5, body.bottom() - 1);
    assert_eq!(model.cursor, 2, "there is no row below the last one");
    at(&mut model, MouseEventKind::ScrollDown, body.x, body.y);
    assert_eq!(model.cursor, 5);
    at(&mut model, MouseEventKind::ScrollUp, body.x, body.y);
    assert_eq!(model.cursor, 2);
    let other = model.layout(model.size).area(Pane::Computation);
    at(&mut model, press, other.x + 1, other.y + 1);
    assert_eq!(model.focus, Pane::Computation);
    let step = model.step();
    at(&mut model, MouseEventKind::ScrollDown, other.x + 1, other.y + 1);
    assert!(model.step() > step && model.cursor == 2);
    // What lies over the panes is scrolled itself; what is being typed isn't disturbed.
    typed(&mut model, "?");
    model.size = (100, 12);
    at(&mut model, MouseEventKind::ScrollDown, 1, 1);
    assert_eq!(model.overlay, Some(Overlay::Help { top: 1 }));
    typed(&mut model, "Esc :");
    let before = model.event;
    at(&mut model, press, 1, 1);
    assert!(model.prompt.is_some() && model.event == before);
}
