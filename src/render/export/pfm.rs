//! PFM: the traced values as f32, little-endian, from the bottom row up.

use crate::render::Film;

pub(super) fn pfm(film: &Film) -> Vec<u8> {
    let mut out = format!("PF\n{} {}\n-1.0\n", film.width(), film.height()).into_bytes();
    for row in film.pixels().chunks(film.width().max(1) as usize).rev() {
        for value in row.iter().flat_map(|pixel| pixel.to_array()) {
            out.extend_from_slice(&(value as f32).to_le_bytes());
        }
    }
    out
}
