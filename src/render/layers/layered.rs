//! A picture with what is known of its pixels.

use super::PixelFacts;
use crate::render::Film;
use std::ops::Deref;

/// A picture with what pixels cost and see, and with the numbers of planes.
#[derive(Clone, Debug, PartialEq)]
pub struct Layered {
    pub(super) facts: Film<PixelFacts>,
    /// How many numbers each pixel has.
    count: usize,
    /// The numbers of all pixels, pixel by pixel.
    numbers: Vec<f64>,
}

impl Layered {
    /// A picture of the rectangle of which nothing is known, with this many numbers a pixel.
    pub fn new(area: [u32; 4], count: usize) -> Layered {
        let facts = Film::new(area);
        let numbers = vec![f64::NAN; facts.pixels().len() * count];
        Layered { facts, count, numbers }
    }

    /// A picture of the rectangle with these pixels, and with the numbers of each one after the other.
    pub fn of(area: [u32; 4], pixels: Vec<PixelFacts>, numbers: Vec<f64>) -> Layered {
        let count = numbers.len() / pixels.len().max(1);
        Layered { facts: Film::of(area, pixels), count, numbers }
    }

    /// The picture.
    pub fn film(&self) -> Film {
        self.facts.map(|pixel| pixel.color)
    }

    /// All numbers of a pixel, by its place in the list of pixels.
    pub fn numbers(&self, pixel: usize) -> &[f64] {
        &self.numbers[pixel * self.count..(pixel + 1) * self.count]
    }

    /// Of each pixel the number at this place of its own.
    pub fn numbers_of(&self, at: usize) -> impl Iterator<Item = f64> + '_ {
        self.numbers.iter().skip(at).step_by(self.count.max(1)).copied()
    }

    /// Puts the numbers of a pixel of the whole picture in their place.
    pub(super) fn put_numbers(&mut self, [column, row]: [u32; 2], numbers: &[f64]) {
        let [left, top, ..] = self.facts.area();
        let pixel = (row - top) as usize * self.facts.width() as usize + (column - left) as usize;
        self.numbers[pixel * self.count..(pixel + 1) * self.count].copy_from_slice(numbers);
    }

    /// Puts a piece of the picture, of which the same is known, in its place.
    pub fn put(&mut self, piece: &Layered) {
        let [left, top, ..] = piece.area();
        self.facts.put(piece.area(), piece.pixels());
        if piece.count != self.count || self.count == 0 {
            return;
        }
        let width = piece.width() as usize;
        for pixel in 0..piece.pixels().len() {
            let place = [left + (pixel % width) as u32, top + (pixel / width) as u32];
            self.put_numbers(place, piece.numbers(pixel));
        }
    }
}

impl Deref for Layered {
    type Target = Film<PixelFacts>;

    fn deref(&self) -> &Film<PixelFacts> {
        &self.facts
    }
}
