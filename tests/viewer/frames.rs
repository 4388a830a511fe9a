//! The viewer's frames, pinned with their styles at three sizes.

use crate::support::{scene, snapshots};
use raywalk::log::Log;
use raywalk::record::{self, Arithmetic};
use raywalk::report::language::Language;
use raywalk::tui::{self, Options, Palette, Theme, dump::dump};

fn by_hand() -> Log {
    record::pixel(&scene("textbook"), [160, 120], Arithmetic::Decimal(3))
}

/// The viewer as it usually starts, with this look and language.
pub fn usual(theme: Theme, language: Language) -> Options {
    Options {
        theme,
        start: None,
        warning: None,
        note: None,
        numbers: Default::default(),
        language,
        controls: Default::default(),
    }
}

fn options(palette: Palette, ascii: bool) -> Options {
    usual(Theme::new(palette, ascii), Language::English)
}

fn frame_after(keys: &str, width: u16, height: u16, options: &Options) -> String {
    let model = tui::opened_with_keys(by_hand(), options, None, keys, (width, height));
    dump(&tui::frame(&model, width, height, &options.theme))
}

#[test]
fn frames_at_three_sizes() {
    snapshots().bind(|| {
        for (name, width, height) in [("40x12", 40, 12), ("80x24", 80, 24), ("200x60", 200, 60)] {
            // 28 values on, the reflected ray hits the sphere.
            let frame = frame_after("28n", width, height, &options(Palette::Indexed, false));
            insta::assert_snapshot!(format!("viewer_{name}"), frame);
        }
    });
}

#[test]
fn frames_without_colour_and_in_ascii() {
    snapshots().bind(|| {
        insta::assert_snapshot!("viewer_no_color", frame_after("28n", 80, 24, &options(Palette::None, false)));
        let ascii = frame_after("28n", 80, 24, &options(Palette::None, true));
        assert!(ascii.lines().take(24).all(|line| line.is_ascii()), "{ascii}");
        insta::assert_snapshot!("viewer_ascii", ascii);
        insta::assert_snapshot!("viewer_help", frame_after("?", 80, 24, &options(Palette::Indexed, false)));
    });
}

/// What lies over the panes, at the same sizes.
#[test]
fn overlays_at_three_sizes() {
    const OVERLAYS: [(&str, &str); 3] = [
        ("breakpoints", "bhit Enter bT2_A<0 Enter bobject Space sphere Enter B j Space"),
        ("search", "/sphere Enter 4;"),
        ("help_search", "? /breakpoint"),
    ];
    snapshots().bind(|| {
        for (name, keys) in OVERLAYS {
            for (size, width, height) in [("40x12", 40, 12), ("80x24", 80, 24), ("200x60", 200, 60)] {
                let frame = frame_after(keys, width, height, &options(Palette::Indexed, false));
                insta::assert_snapshot!(format!("viewer_{name}_{size}"), frame);
            }
        }
    });
}

/// The pixel of figure 19 that holds a lost object: its samples are drawn when the pixel or a sample is selected.
#[test]
fn the_samples_of_a_pixel_are_a_picture() {
    let log = || record::pixel(&scene("figure-19"), [20, 8], Arithmetic::F64);
    let frame = |keys: &str, width, height, ascii| {
        let options = options(Palette::None, ascii);
        let model = tui::opened_with_keys(log(), &options, None, keys, (width, height));
        dump(&tui::frame(&model, width, height, &options.theme))
    };
    snapshots().bind(|| insta::assert_snapshot!("viewer_samples", frame("g", 80, 30, false)));
    let ascii = frame("g", 80, 30, true);
    assert!(ascii.lines().take(30).all(|line| line.is_ascii()), "{ascii}");
    assert!(ascii.contains("samples in the pixel"), "{ascii}");
    for (width, height) in (0..90).step_by(3).flat_map(|width| (0..34).map(move |height| (width, height))) {
        frame("g", width, height, false);
    }
}

#[test]
fn no_size_is_too_small_to_be_drawn() {
    for width in 0..45 {
        for height in 0..16 {
            let options = options(Palette::True, false);
            for keys in ["", "5n", "?", "Tab 5n", "/sphere", "bhit Enter B", "? /key", "r r L", "t 5n"] {
                let model = tui::opened_with_keys(by_hand(), &options, None, keys, (width, height));
                tui::frame(&model, width, height, &options.theme);
            }
        }
    }
}
