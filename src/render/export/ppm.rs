//! PPM (P6): a header of text, then three bytes per pixel.

pub(super) fn ppm(levels: &[u8], [width, height]: [u32; 2]) -> Vec<u8> {
    let mut out = format!("P6\n{width} {height}\n255\n").into_bytes();
    out.extend_from_slice(levels);
    out
}
