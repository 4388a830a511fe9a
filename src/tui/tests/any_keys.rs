//! Any keys in any order: nothing panics, and the place stays one that can be shown.

use super::*;
use crate::tui::keys;
use crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind};
use proptest::prelude::*;

/// A key of the table, a digit, a letter, a line that is typed, another size, a tick, a click, or another log.
fn happening() -> impl Strategy<Value = String> {
    let rows: Vec<_> = keys::rows().flat_map(|row| row.keys).filter(|key| !key.contains("letter")).collect();
    let row = prop::sample::select(rows.into_iter().map(|key| (*key).to_owned()).collect::<Vec<_>>());
    const LINES: [&str; 17] = [
        "/ s p h e r e Enter",
        "/ 1 Enter",
        "f l i g h t Enter",
        "f ^u Enter",
        "b h i t Enter",
        "b N * L < 0 Enter",
        "b h i t Space o r Space d e p t h > 0 Enter",
        ": w a t c h Space N * L Enter",
        ": w a t c h Enter",
        ": h i s t o r y Space d Enter",
        ": e v a l Space N * L Enter",
        ": 7 Enter",
        ": b r Tab Space d e p t h Space 1 Enter",
        "? / k e y",
        "m a",
        "' a",
        "' '",
    ];
    let line = prop::sample::select(LINES.map(str::to_owned).to_vec());
    let outside = prop::sample::select(["RESIZE", "TICK", "CLICK", "WHEEL", "SHOW"].map(str::to_owned).to_vec());
    prop_oneof![8 => row, 2 => "[0-9a-zA-Z]", 3 => line, 2 => outside]
}

fn happens(model: &mut Model, what: &str, number: u16) {
    let mouse = |kind| MouseEvent { kind, column: number % 100, row: number % 30, modifiers: KeyModifiers::NONE };
    let action = match what {
        "RESIZE" => Some(Action::Resize(number % 130, number % 37)),
        "TICK" => Some(Action::Walk(Walk::Tick)),
        "CLICK" => crate::tui::mouse::meant(model, mouse(MouseEventKind::Down(MouseButton::Left))),
        "WHEEL" => crate::tui::mouse::meant(model, mouse(MouseEventKind::ScrollDown)),
        "SHOW" => return live::show_log(model, if number.is_multiple_of(2) { textbook() } else { flat() }),
        keys => {
            typed(model, keys);
            None
        }
    };
    if let Some(action) = action {
        update(model, action);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_place_can_always_be_shown(happenings in prop::collection::vec((happening(), any::<u16>()), 1..60)) {
        let mut model = sized(textbook(), 100, 30);
        for (what, number) in &happenings {
            happens(&mut model, what, *number);
            let (tree, count) = (&model.tree, model.log.events.len());
            prop_assert!(model.event < count);
            prop_assert!(model.cursor < tree.nodes().len());
            prop_assert_eq!(model.fold.row_of(tree, model.cursor), model.cursor, "after {}", what);
            prop_assert_eq!(model.fold.row_of(tree, model.top), model.top, "after {}", what);
        }
        let (width, height) = model.size;
        frame(&model, width, height, &Theme::new(Palette::Indexed, false));
    }
}
