//! The picture as it was traced: linear, unbounded, in f64.

use crate::scene::Color;

/// A rectangle of pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    left: u32,
    top: u32,
    width: u32,
    height: u32,
    pixels: Vec<Color>,
}

impl Film {
    /// A black picture of the rectangle left, top, right, bottom (the last two exclusive).
    pub fn new([left, top, right, bottom]: [u32; 4]) -> Film {
        let (width, height) = (right - left, bottom - top);
        Film { left, top, width, height, pixels: vec![Color::ZERO; width as usize * height as usize] }
    }

    /// Pixels across.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels down.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The pixels, row by row from the top.
    pub fn pixels(&self) -> &[Color] {
        &self.pixels
    }

    /// The pixels themselves.
    pub fn into_pixels(self) -> Vec<Color> {
        self.pixels
    }

    /// Puts the pixels of a rectangle, row by row, into the picture.
    pub fn put(&mut self, [left, top, right, _]: [u32; 4], colors: &[Color]) {
        let tile_width = (right - left) as usize;
        for (row, line) in (top..).zip(colors.chunks(tile_width.max(1))) {
            let start = (row - self.top) as usize * self.width as usize + (left - self.left) as usize;
            self.pixels[start..start + line.len()].copy_from_slice(line);
        }
    }
}
