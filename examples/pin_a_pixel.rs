//! How a renderer's developer pins one pixel of a scene of their own: its log, rounded, is what a snapshot holds.
//!
//!     cargo run --example pin_a_pixel [SCENE.json [X,Y]]
//!
//! `docs/snapshot-testing.md` has the same as a test.

use raywalk::log::file::to_ndjson;
use raywalk::record::{self, Arithmetic};
use raywalk::report::{Language, Style, text};
use raywalk::scene::Scene;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let scene = match arguments.next() {
        Some(path) => Scene::open(path)?,
        None => Scene::built_in("textbook")?,
    };
    let pixel = match arguments.next().as_deref().map(|text| text.split_once(',')) {
        None => scene.camera.resolution.map(|side| side / 2),
        Some(Some((column, row))) => [column.parse()?, row.parse()?],
        Some(None) => return Err("expected the pixel as X,Y".into()),
    };
    let log = record::pixel(&scene, pixel, Arithmetic::F64);
    // For people: the steps with three decimals.
    println!("{}", text::text(Language::English, &log, Style::default()));
    // For programs: the same events with few digits, which every machine and compiler gives.
    println!("{}", String::from_utf8(to_ndjson(&log.rounded(6))?)?);
    Ok(())
}
