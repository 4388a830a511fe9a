//! Pictures in memory: colours as they were traced, linear, unbounded, in f64, or whatever else is known of pixels.

use crate::scene::Color;

/// A rectangle of pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Film<T = Color> {
    left: u32,
    top: u32,
    width: u32,
    height: u32,
    pixels: Vec<T>,
}

impl<T: Copy + Default> Film<T> {
    /// A black picture of the rectangle left, top, right, bottom (the last two exclusive).
    pub fn new(area: [u32; 4]) -> Film<T> {
        Film::filled(area, T::default())
    }
}

impl<T: Copy> Film<T> {
    /// A picture of the rectangle in which all pixels are this one.
    pub fn filled(area @ [left, top, right, bottom]: [u32; 4], pixel: T) -> Film<T> {
        Film::of(area, vec![pixel; (right - left) as usize * (bottom - top) as usize])
    }

    /// A picture of the rectangle with these pixels, row by row.
    pub fn of([left, top, right, bottom]: [u32; 4], pixels: Vec<T>) -> Film<T> {
        Film { left, top, width: right - left, height: bottom - top, pixels }
    }

    /// Pixels across.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels down.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Its rectangle in the whole picture.
    pub fn area(&self) -> [u32; 4] {
        [self.left, self.top, self.left + self.width, self.top + self.height]
    }

    /// The pixels, row by row from the top.
    pub fn pixels(&self) -> &[T] {
        &self.pixels
    }

    /// The pixels themselves.
    pub fn into_pixels(self) -> Vec<T> {
        self.pixels
    }

    /// Puts the pixels of a rectangle, row by row, into the picture.
    pub fn put(&mut self, [left, top, right, _]: [u32; 4], pixels: &[T]) {
        let tile_width = (right - left) as usize;
        for (row, line) in (top..).zip(pixels.chunks(tile_width.max(1))) {
            let start = (row - self.top) as usize * self.width as usize + (left - self.left) as usize;
            self.pixels[start..start + line.len()].copy_from_slice(line);
        }
    }

    /// The same rectangle with something made of each pixel.
    pub fn map<U: Copy>(&self, of_pixel: impl Fn(&T) -> U) -> Film<U> {
        Film::of(self.area(), self.pixels.iter().map(of_pixel).collect())
    }
}
