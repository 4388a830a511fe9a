//! Searching, filtering, bookmarks, copying, the mouse, the help.

use super::lines::{begin, line, said};
use super::*;
use crate::tui::listing::listing;
use crate::tui::mouse;
use crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

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
    live::answer(&mut model, refused, &mut None);
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
    live::show_log(&mut model, textbook());
    typed(&mut model, "'a");
    assert!(said(&model).contains("this log has no"), "{}", said(&model));
    assert!(listing(&model, Kind::Bookmarks).entries[0].target.is_none());
    live::show_log(&mut model, glass());
    typed(&mut model, "'a");
    assert_eq!((model.event, model.tree.path(model.cursor)), (there, path));
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
    let body = crate::tui::model::layout::Layout::body(model.layout(model.size).area(Pane::Tree));
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
    // A click selects the step of the line, whichever of its lines that is.
    typed(&mut model, "0 28n");
    let shown = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    let clicked = |line: usize, text: &str| text.lines().nth(line).unwrap_or_default().to_owned();
    let mut selected = Vec::new();
    for y in other.y + 1..other.bottom() {
        at(&mut model, press, other.x + 3, y);
        selected.push(model.event);
        // Each click is judged on the same screen.
        typed(&mut model, "0 28n");
    }
    let is_line = |event: usize, line: &str| match model.log.events[event].what {
        What::Note { name, .. } => line.contains(&format!("{} = ", name.symbol())),
        _ => false,
    };
    let hits = selected
        .iter()
        .enumerate()
        .filter(|(row, event)| is_line(**event, &clicked(usize::from(other.y) + 1 + row, &shown)));
    assert!(hits.count() >= 3, "{selected:?}\n{shown}");
    // In a list a click selects an entry.
    typed(&mut model, "0 29n d");
    let listed = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    let row = listed.lines().position(|line| line.contains("reflect.direction")).expect("the second operand") as u16;
    at(&mut model, press, 50, row);
    let Some(Overlay::List { selected, .. }) = model.overlay else { panic!("the list is open") };
    let marked = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(clicked(usize::from(row), &marked).contains("▶"), "{selected}:\n{marked}");
    typed(&mut model, "Esc");
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
