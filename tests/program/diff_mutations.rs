//! Damaged pictures and logs are compared or refused, and nothing panics.

use crate::mutator::{changed, changes};
use crate::support::scene;
use proptest::prelude::*;
use raywalk::log::file::{PixelReader, to_ndjson};
use raywalk::log::{Log, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::render::Film;
use raywalk::render::difference::difference;
use raywalk::render::export::{Format, Picture, encode, read};
use raywalk::report::diff::{Format as _, Numbering, Summary, Text, Tolerance, compare};
use raywalk::report::side_by_side::Run;
use raywalk::scene::{Color, Output, Transfer};
use std::sync::LazyLock;

/// A picture of 3 × 2 pixels in each of the formats.
fn picture(which: usize) -> Vec<u8> {
    let floats: Vec<u8> = (0..18_u8).flat_map(|k| f32::from(k).to_le_bytes()).collect();
    let levels: Vec<u8> = (0..18).map(|k| k * 14).collect();
    match which {
        0 => raywalk::render::export::png_of_levels(&levels, [3, 2]).expect("memory"),
        1 => [b"P6\n# a comment\n3 2\n255\n", &levels[..]].concat(),
        2 => [b"P6 3 2 65535\n", &levels[..], &levels[..]].concat(),
        3 => [b"PF\n3 2\n-1.0\n", &floats[..]].concat(),
        4 => [b"Pf\n3 6\n-1.0\n", &floats[..]].concat(),
        _ => encoded(Format::of_ending(ENDINGS[which - 5], false).expect("a format"), &levels),
    }
}

/// The formats beside, by their endings.
const ENDINGS: [&str; 6] = ["bmp", "tga", "qoi", "tiff", "jpg", "webp"];

/// These levels of 3 × 2 pixels in a format.
fn encoded(format: Format, levels: &[u8]) -> Vec<u8> {
    let mut film = Film::new([0, 0, 3, 2]);
    let colors: Vec<Color> =
        levels.as_chunks().0.iter().map(|color: &[u8; 3]| Color::from_array(color.map(f64::from))).collect();
    film.put([0, 0, 3, 2], &colors);
    let output = Output { white: 255.0, transfer: Transfer::Linear, exposure: 0.0 };
    encode(&film, format, &output).expect("memory").bytes
}

fn picture_answers(bytes: &[u8]) -> Result<(), TestCaseError> {
    match read(bytes) {
        Ok(picture) => {
            let [width, height] = picture.size();
            let found = difference(&picture, &picture, |a, b| a != b && !(a.is_nan() && b.is_nan()));
            prop_assert_eq!((found.differing, found.rmse), (0, 0.0), "{} x {}", width, height);
        }
        Err(error) => {
            let message = error.to_string();
            let has_control = message.chars().any(|c| c.is_control());
            prop_assert!(message.len() < 500 && !has_control, "{:?}", message);
        }
    }
    Ok(())
}

static LOG: LazyLock<Log> = LazyLock::new(|| record::pixel(&scene("transmission"), [150, 130], Arithmetic::F64));

/// Compares what can be read of a log with the log that it was, in both directions.
fn log_answers(bytes: &[u8]) -> Result<(), TestCaseError> {
    let Ok(mut reader) = PixelReader::open(bytes) else { return Ok(()) };
    let mut header = reader.header().clone();
    let numbering = Numbering::unify(&LOG.header, &mut header);
    while let Ok(Some(mut pixel)) = reader.next_pixel() {
        numbering.apply(&mut pixel.events);
        let damaged = Log { header: header.clone(), events: pixel.events };
        let (tree, damaged_tree) = (Tree::of(&LOG.events), Tree::of(&damaged.events));
        let good = Run { log: &LOG, tree: &tree };
        let damaged = Run { log: &damaged, tree: &damaged_tree };
        for (a, b) in [(good, damaged), (damaged, good)] {
            let found = compare(a, b, &Tolerance::default());
            let mut summary = Summary::default();
            summary.add(None, &found);
            let is_same = found.differences.is_empty();
            prop_assert_eq!(summary.is_same(), is_same);
            prop_assert_eq!(Text::new(None, false).pixel(None, &found).is_empty(), is_same);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(10_000) })]

    #[test]
    fn pictures(changes in changes(&["0", "-1", "1e999", "nan", "4294967296", "99999", "\n", "#", "P6", "PF", "IDAT", "VP8 ", "\u{0}"]), which in 0..5_usize) {
        picture_answers(&changed(&picture(which), &changes))?;
    }

    #[test]
    fn pictures_of_other_programs(
        changes in changes(&["\0\0", "\u{1}\0", "\u{7f}", "\u{10}", "VP8 ", "VP8X", "ALPH", "ANIM", "\0\u{1}\u{8}", "@@"]), which in 5..11_usize,
    ) {
        picture_answers(&changed(&picture(which), &changes))?;
    }
}

proptest! {
    // Each is compared, which takes longer than to read it.
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

    #[test]
    fn compared_logs(changes in changes(&["\"leave\":{}", "\"node\":", "1e150", "0", "-0", "\"hit\"", "\"miss\"", "\n", "{\"at\":1,"])) {
        log_answers(&changed(&to_ndjson(&LOG).expect("memory"), &changes))?;
    }
}

#[test]
fn what_is_damaged_was_whole() {
    let pictures: Vec<Picture> = (0..11).map(|which| read(&picture(which)).expect("a picture")).collect();
    let mut sizes = [[3, 2]; 11];
    sizes[4] = [3, 6];
    assert_eq!(pictures.iter().map(Picture::size).collect::<Vec<_>>(), sizes);
    // JPEG, the ninth, is only near.
    for which in [0, 1, 5, 6, 7, 8, 10] {
        assert_eq!(pictures[which].pixel([2, 1])[2], 238.0 / 255.0, "{which}");
    }
    // Rows of a PFM go from the bottom up, and one channel is grey.
    assert_eq!((pictures[3].pixel([0, 1]), pictures[4].pixel([1, 5])), ([0.0, 1.0, 2.0], [1.0; 3]));
}
