//! Pictures of eight bits a channel: read from files, put together, written.

use raywalk::render::export::{self, png_of_levels};
use std::fs;
use std::path::Path;

/// Red, green and blue of each pixel, row by row from the top.
#[derive(Clone, PartialEq)]
pub struct Bitmap {
    pub width: u32,
    pub pixels: Vec<[u8; 3]>,
}

impl Bitmap {
    /// Of one colour.
    pub fn filled([width, height]: [u32; 2], pixel: [u8; 3]) -> Bitmap {
        Bitmap { width, pixels: vec![pixel; width as usize * height as usize] }
    }

    #[track_caller]
    pub fn open(path: &Path) -> Bitmap {
        let picture = export::read(&fs::read(path).expect("a file")).expect("a picture");
        let [width, height] = picture.size();
        let pixel = |x, y| picture.pixel([x, y]).map(|level| (level * 255.0).round() as u8);
        Bitmap { width, pixels: (0..height).flat_map(|y| (0..width).map(move |x| pixel(x, y))).collect() }
    }

    pub fn save(&self, path: &Path) {
        fs::write(path, png_of_levels(self.pixels.as_flattened(), self.size()).expect("a PNG"))
            .expect("a place for it");
    }

    pub fn size(&self) -> [u32; 2] {
        [self.width, self.pixels.len() as u32 / self.width]
    }

    pub fn rows(&self) -> impl Iterator<Item = &[[u8; 3]]> {
        self.pixels.chunks(self.width as usize)
    }

    /// Every pixel changed.
    pub fn map(&self, of: impl Fn([u8; 3]) -> [u8; 3]) -> Bitmap {
        Bitmap { width: self.width, pixels: self.pixels.iter().map(|pixel| of(*pixel)).collect() }
    }

    /// Each pixel as a square of this side, so that it can be seen.
    pub fn enlarged(&self, side: usize) -> Bitmap {
        let row = |row: &[[u8; 3]]| row.iter().flat_map(|pixel| [*pixel].repeat(side)).collect::<Vec<_>>();
        let pixels = self.rows().flat_map(|of_row| row(of_row).repeat(side)).collect();
        Bitmap { width: self.width * side as u32, pixels }
    }

    /// Puts another one over it, with its top left corner there.
    pub fn put(&mut self, other: &Bitmap, [left, top]: [u32; 2]) {
        let mine = self.pixels.chunks_mut(self.width as usize).skip(top as usize);
        for (mine, theirs) in mine.zip(other.rows()) {
            mine[left as usize..][..theirs.len()].copy_from_slice(theirs);
        }
    }
}
