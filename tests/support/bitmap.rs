//! Pictures of eight bits a channel.

use image::RgbImage;
use std::path::Path;

/// Reads a file.
#[track_caller]
pub fn open(path: &Path) -> RgbImage {
    image::open(path).expect("a picture").to_rgb8()
}
