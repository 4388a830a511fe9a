//! What rows of the tree show where there is little room.

use super::*;
use crate::record::Arithmetic;
use crate::tui::testing::{lit_from_behind, log_of};

/// The rows of the tree alone on a screen this wide.
fn rows(log: &Log, width: u16) -> Vec<String> {
    let mut model = sized(log.clone(), width, 80);
    typed(&mut model, "E zo");
    let shown = dump(&frame(&model, width, 80, &Theme::new(Palette::None, false)));
    shown.lines().take(79).skip(1).map(|row| row.trim_end().to_owned()).collect()
}

/// The numbers in a row, as they are written; a name or a path has them, too.
fn numbers(row: &str) -> Vec<String> {
    let is_of_number = |c: char| c.is_ascii_digit() || "-.·".contains(c) || crate::report::number::RAISED.contains(c);
    let words = row.split(|c| !is_of_number(c)).map(|word| word.trim_matches('.'));
    words.filter(|word| word.contains(|c: char| c.is_ascii_digit())).map(str::to_owned).collect()
}

/// However narrow the pane: a number that is there is whole, and what isn't there has a mark.
#[test]
fn a_number_is_whole_or_left_out_with_a_mark() {
    for log in [log_of("total-reflection", Arithmetic::F64), textbook(), log_of("hall-of-mirrors", Arithmetic::F64)] {
        let whole = rows(&log, 240);
        let mut left_out = 0;
        for width in 20..120 {
            for (row, whole) in rows(&log, width).iter().zip(&whole) {
                let (shown, all) = (numbers(row), numbers(whole));
                let is_cut = row.ends_with('…') && !row.ends_with(" …");
                let known = if is_cut { shown.len().saturating_sub(1) } else { shown.len() }.min(shown.len());
                for number in &shown[..known] {
                    assert!(all.contains(number), "{number} in {width} columns:\n{row}\n{whole}");
                }
                let has_all = shown.len() == all.len();
                left_out += usize::from(!has_all);
                assert!(has_all || row.contains('…'), "{width} columns:\n{row}\n{whole}");
            }
        }
        assert!(left_out > 100, "{left_out}");
    }
}

/// A light that no shadow ray goes to says why.
#[test]
fn a_light_behind_the_surface_says_so() {
    let log = lit_from_behind();
    let light = rows(&log, 80).into_iter().find(|row| row.contains("light lamp")).expect("it has a row");
    assert!(light.ends_with("☼ light lamp  ○ behind the surface"), "{light}");
    let narrow = rows(&log, 26).into_iter().find(|row| row.contains("lamp")).expect("it has a row");
    assert!(narrow.ends_with("☼ lamp  ○ behind the …"), "{narrow}");
    let mut model = sized(log, 100, 24);
    model.language = Language::Spanish;
    let shown = dump(&frame(&model, 100, 24, &Theme::new(Palette::None, false)));
    assert!(shown.contains("detrás de la superficie"), "{shown}");
}

#[test]
fn values_are_aligned_at_the_right() {
    let values = rows(&textbook(), 60);
    assert_eq!(values[1], "└▾◉ C from the eye  ● plane      (394.134, 312.306, 370.850)");
    assert!(values[2].ends_with("   t = 12.685") && values[2].chars().count() == 60, "{}", values[2]);
    // Words go first, then the value as a whole.
    assert_eq!(rows(&textbook(), 40)[1], "└▾◉ C  ● …   (394.134, 312.306, 370.850)");
    assert_eq!(rows(&textbook(), 30)[1], "└▾◉ C from the eye  ● plane …");
}
