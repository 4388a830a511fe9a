//! Two logs beside each other: what is seen of them, and how one gets about.

use crate::support::{changed_scene, scene, snapshots};
use raywalk::log::{Log, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::report::diff::{Rows, Tolerance};
use raywalk::report::side_by_side::Run;
use raywalk::tui::beside::{self, Beside};
use raywalk::tui::keys::sequence;
use raywalk::tui::{Effect, Exit, Palette, Theme, dump::dump};

fn textbook(arithmetic: Arithmetic) -> Log {
    record::pixel(&scene("textbook"), [160, 120], arithmetic)
}

/// The frame of two logs after these keys.
fn frame_after(logs: &[Log; 2], keys: &str, (width, height): (u16, u16), theme: &Theme) -> String {
    let trees = [&logs[0], &logs[1]].map(|log| Tree::of(&log.events));
    let [a, b] = [0, 1].map(|k| Run { log: &logs[k], tree: &trees[k] });
    let rows = Rows::of(a, b, Tolerance { digits: Some(3), ..Tolerance::default() });
    let mut beside = Beside::new(rows, ["by hand".to_owned(), "exact".to_owned()]);
    beside.resize(height);
    for key in sequence(keys) {
        assert_eq!(beside.press(key), Effect::None, "{key:?}");
    }
    dump(&beside::frame(&beside, width, height, theme))
}

#[test]
fn two_arithmetics_beside_each_other() {
    let logs = [textbook(Arithmetic::Decimal(3)), textbook(Arithmetic::F64)];
    let theme = Theme::new(Palette::Indexed, false);
    snapshots().bind(|| {
        insta::assert_snapshot!("beside_120x30", frame_after(&logs, "", (120, 30), &theme));
        // Twenty differences on: the normal on the sphere.
        insta::assert_snapshot!("beside_next_80x24", frame_after(&logs, "nnnnnnnnnnnnnnnnnnnn", (80, 24), &theme));
    });
}

#[test]
fn what_only_one_log_has_leaves_the_other_side_blank() {
    let limited = changed_scene("textbook", |scene| scene.tracing.max_depth = 0);
    let logs = [textbook(Arithmetic::F64), record::pixel(&limited, [160, 120], Arithmetic::F64)];
    let theme = Theme::new(Palette::None, true);
    let frame = frame_after(&logs, "n", (100, 20), &theme);
    assert!(frame.lines().take(20).all(|line| line.is_ascii()), "{frame}");
    snapshots().bind(|| insta::assert_snapshot!("beside_depth_limit_100x20", frame));
}

#[test]
fn differences_are_gone_through_in_both_directions() {
    let logs = [textbook(Arithmetic::Decimal(3)), textbook(Arithmetic::F64)];
    let theme = Theme::new(Palette::None, false);
    let at = |keys: &str| {
        let frame = frame_after(&logs, keys, (120, 30), &theme);
        frame.lines().nth(29).expect("a bottom line").to_owned()
    };
    let first = at("");
    assert!(first.contains("1 of 38 differences"), "{first}");
    assert!(at("n").contains("2 of 38 differences"));
    assert_eq!(at("nnN"), at("n"));
    assert_eq!(at("N"), first);
    assert!(at("G").contains("38 of 38 differences"), "the result is the last row");
    assert_eq!(at("GNn"), at("G"));
    assert!(at("g").starts_with("row 1/"));
    assert_eq!(at("gjjk"), at("gj"));
}

/// Counts, the search, commands and the help do what they do in the viewer.
#[test]
fn keys_of_the_viewer_mean_the_same() {
    let logs = [textbook(Arithmetic::Decimal(3)), textbook(Arithmetic::F64)];
    let theme = Theme::new(Palette::None, false);
    let frame = |keys: &str, size| frame_after(&logs, keys, size, &theme);
    let at = |keys: &str| frame(keys, (120, 30)).lines().nth(29).expect("a bottom line").to_owned();
    assert_eq!(at("5j"), at("jjjjj"));
    assert_eq!(at("20n"), at("nnnnnnnnnnnnnnnnnnnn"));
    assert_eq!(at("20n 19N"), at("n"));
    assert!(at("12G").starts_with("row 12/") && at(":12<CR>").starts_with("row 12/"));
    assert!(frame("?", (120, 30)).contains("find in both logs"));
    assert_eq!(at("? j"), at(""), "any key closes the help");
    // The search goes through both logs, around the end.
    let found = at("/T2_A<CR>");
    let of_cursor = frame("/T2_A<CR>", (120, 30));
    assert!(of_cursor.contains("T2_A: ") && found != at(""), "{of_cursor}");
    assert_eq!(at("/T2_A<CR>;,"), found);
    assert!(at("/nowhere<CR>").contains("not found: nowhere"));
    assert!(at(":nonsense<CR>").contains("expected a row"));
    assert!(at("W").contains("no such key here"));
    // What doesn't fit has a mark, and is scrolled to.
    let narrow = frame("20n", (44, 24));
    assert!(narrow.contains('…') && narrow != frame("20n >", (44, 24)), "{narrow}");
    assert_eq!(frame("20n 3> 9<lt>", (44, 24)), narrow);
}

/// By hand a value has the decimals that it was rounded to, however many tell it from the other.
#[test]
fn values_by_hand_have_their_own_decimals() {
    let logs = [textbook(Arithmetic::Decimal(3)), textbook(Arithmetic::F64)];
    let theme = Theme::new(Palette::None, false);
    for keys in ["", "3n", "10n", "20n", "30n", "38n"] {
        let frame = frame_after(&logs, keys, (160, 40), &theme);
        // The left half of the rows, and the left log's computation.
        let left = frame.lines().take(30).map(|row| row.chars().take(78).collect::<String>());
        let computed = frame.lines().filter(|line| line.starts_with("A: ")).map(str::to_owned);
        for row in left.chain(computed) {
            let mut words =
                row.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(|word| word.split_once('.'));
            assert!(words.all(|(_, decimals)| decimals.len() <= 3), "{row}\n{frame}");
        }
    }
}

#[test]
fn any_size_can_be_drawn() {
    let logs = [textbook(Arithmetic::F64), textbook(Arithmetic::F32)];
    let theme = Theme::new(Palette::Indexed, false);
    for size in [(0, 0), (1, 1), (3, 2), (10, 5), (500, 3), (5, 200)] {
        let frame = frame_after(&logs, "Gn", size, &theme);
        assert!(frame.contains("styles:"), "{size:?}");
    }
}

#[test]
fn q_leaves() {
    let logs = [textbook(Arithmetic::F64), textbook(Arithmetic::F32)];
    let trees = [&logs[0], &logs[1]].map(|log| Tree::of(&log.events));
    let [a, b] = [0, 1].map(|k| Run { log: &logs[k], tree: &trees[k] });
    let mut beside = Beside::new(Rows::of(a, b, Tolerance::default()), [String::new(), String::new()]);
    for (key, exit) in [("q", Exit::Quit), ("<Esc>", Exit::Quit), ("<C-c>", Exit::Interrupted)] {
        assert_eq!(sequence(key).into_iter().map(|key| beside.press(key)).collect::<Vec<_>>(), [Effect::Leave(exit)]);
    }
}
