//! PPM (P6): a line of text, then three bytes a pixel.

use crate::render::Film;

pub(super) fn ppm(film: &Film, levels: &[u16]) -> Vec<u8> {
    let mut out = format!("P6\n{} {}\n255\n", film.width(), film.height()).into_bytes();
    out.extend(levels.iter().map(|level| *level as u8));
    out
}
