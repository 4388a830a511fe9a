//! Moving in lists that lie over the panes.

use super::*;
use crate::tui::listing::listing;

/// The selected entry of the list that is open, and how far it is scrolled.
fn selected(model: &Model) -> (String, usize) {
    let Some(Overlay::List { kind, selected, shift }) = model.overlay else { panic!("no list is open") };
    (listing(model, kind).entries[selected].text.clone(), shift)
}

/// A list of these entries; those that end with a colon are headings.
fn list_of(texts: &[&str], size: (u16, u16)) -> Model {
    let mut model = sized(textbook(), size.0, size.1);
    let entry = |text: &&str| match text.ends_with(':') {
        true => Entry::heading((*text).to_owned()),
        false => Entry::to(0, (*text).to_owned()),
    };
    let made = Listing { entries: texts.iter().map(entry).collect(), ..Listing::default() };
    typed(&mut model, "d");
    model.understanding.listing = Some((Kind::Operands, made));
    typed(&mut model, "g");
    model
}

#[track_caller]
fn selects(keys: &str, expected: &str) {
    let mut model = list_of(&["first:", "a", "b", "second:", "third:", "c", "last:"], (80, 24));
    typed(&mut model, keys);
    assert_eq!(selected(&model).0, expected, "after {keys}");
}

#[test]
fn headings_are_skipped() {
    selects("", "a");
    selects("k", "a");
    selects("j", "b");
    selects("jj", "c");
    selects("jjk", "b");
    selects("2j", "c");
    selects("3j", "c");
    selects("G", "c");
    selects("GG k", "b");
    selects("PgDn", "c");
    selects("G PgUp", "a");
    selects("99j", "c");
    selects("G 99k", "a");
}

#[test]
fn a_list_of_headings_alone_can_be_shown() {
    for texts in [&["only:"][..], &[]] {
        let mut model = list_of(texts, (80, 24));
        typed(&mut model, "j k G g > <");
        frame(&model, 80, 24, &Theme::new(Palette::None, false));
    }
}

#[test]
fn what_is_cut_is_scrolled_to() {
    let long = format!("begin {} end", "-".repeat(60));
    let mut model = list_of(&[&long, "short"], (40, 12));
    let shown = |model: &Model, ascii| dump(&frame(model, 40, 12, &Theme::new(Palette::None, ascii)));
    assert!(
        shown(&model, false).contains("begin ---") && shown(&model, false).contains("-…"),
        "{}",
        shown(&model, false)
    );
    assert!(
        shown(&model, true).contains("->") && shown(&model, true).contains("< > scroll"),
        "{}",
        shown(&model, true)
    );
    typed(&mut model, "99>");
    assert!(shown(&model, false).contains("…-") && shown(&model, false).contains("- end"), "{}", shown(&model, false));
    let (entry, shift) = selected(&model);
    assert_eq!((entry.len() - shift, entry), (34, long));
    typed(&mut model, "99<");
    assert_eq!(selected(&model).1, 0);
}

#[test]
fn what_enter_does_is_said_also_on_a_small_screen() {
    let mut model = sized(textbook(), 40, 12);
    for (keys, expected) in [
        ("5n d", "Enter goes, Esc closes"),
        ("D", "Enter goes, Esc closes"),
        ("w", "< > scroll, Enter goes, Esc closes"),
        ("m a M", "Enter goes, d deletes, Esc closes"),
        ("b h i t Enter B", "Enter next"),
        ("r L", "Enter goes, Esc closes"),
    ] {
        typed(&mut model, keys);
        let shown = dump(&frame(&model, 40, 12, &Theme::new(Palette::None, false)));
        assert!(shown.contains(expected), "{keys}:\n{shown}");
        typed(&mut model, "Esc");
    }
}

#[test]
fn every_cell_has_a_column() {
    let mut model = sized(glass(), 100, 30);
    for keys in ["w", "20n d", "20n D", "ma M"] {
        typed(&mut model, keys);
        let Some(Overlay::List { kind, .. }) = model.overlay else { panic!("no list after {keys}") };
        let listing = listing(&model, kind);
        let counts: Vec<_> =
            listing.entries.iter().map(|entry| entry.text.split(model::list::CELL_END).count()).collect();
        assert!(counts.iter().all(|count| *count == 1 || *count == listing.columns.len()), "{keys}: {counts:?}");
        assert!(counts.contains(&listing.columns.len()), "{keys}: {counts:?}");
        typed(&mut model, "Esc");
    }
}
