//! Frames of the lists that explain, pinned with their styles.

use crate::frames::usual;
use crate::support::{scene, snapshots};
use raywalk::log::{Log, Subject};
use raywalk::record::{self, Arithmetic, Part};
use raywalk::tui::{self, Live, Palette, Refusal, Theme, dump::dump};

/// The numeric example, traced as often as somebody asks.
struct Example;

impl Live for Example {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        Ok(record::pixel(&scene("textbook"), pixel, Arithmetic::Decimal(3)))
    }

    fn compare(&mut self, _: Subject) -> Result<Vec<Log>, Refusal> {
        let arithmetics = [Arithmetic::Decimal(3), Arithmetic::F32, Arithmetic::F64, Arithmetic::Perturbed(0)];
        let log = |arithmetic| record::bounded(&scene("textbook"), Part::Pixel([160, 120]), arithmetic);
        arithmetics
            .into_iter()
            .map(|arithmetic| log(arithmetic).map_err(|cut_off| Refusal::Other(cut_off.to_string())))
            .collect()
    }
}

fn frame_after(keys: &str, width: u16, height: u16) -> String {
    let theme = Theme::new(Palette::Indexed, false);
    let options = usual(theme, Default::default());
    let log = record::pixel(&scene("textbook"), [160, 120], Arithmetic::Decimal(3));
    let model = tui::opened_with_keys(log, &options, Some(&mut Example), keys, (width, height));
    dump(&tui::frame(&model, width, height, &theme))
}

#[test]
fn why_a_pixel_has_its_colour() {
    snapshots().bind(|| {
        for (name, width, height) in [("40x12", 40, 12), ("80x24", 80, 24), ("200x60", 200, 60)] {
            insta::assert_snapshot!(format!("viewer_why_{name}"), frame_after("w", width, height));
        }
    });
}

#[test]
fn operands_arithmetics_and_a_quiz() {
    snapshots().bind(|| {
        insta::assert_snapshot!("viewer_operands", frame_after("31n d", 80, 24));
        insta::assert_snapshot!("viewer_arithmetics", frame_after("3n a", 80, 24));
        insta::assert_snapshot!("viewer_arithmetics_40x12", frame_after("3n a", 40, 12));
        insta::assert_snapshot!("viewer_arithmetics_scrolled_40x12", frame_after("3n a 99>", 40, 12));
        insta::assert_snapshot!("viewer_quiz", frame_after("Q 4n = 12", 80, 24));
    });
}
