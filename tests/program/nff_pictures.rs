//! Pictures of the Standard Procedural Databases beside those of their authors, where they are at hand.

use crate::bitmap::open;
use crate::shared::shared;
use glam::DVec3;
use raywalk::render::{Film, Settings, render};
use raywalk::scene::build;
use raywalk::scene::file::{self, schema::Sampling};
use std::path::Path;
use std::sync::atomic::AtomicBool;

/// How far two pictures of the same scene may be apart, as the root of the mean square of the differences from 0 to 1.
const NEAR: f64 = 0.10;

/// A picture: its width and its colours from 0 to 1, row by row.
struct Picture {
    width: usize,
    colors: Vec<DVec3>,
}

impl Picture {
    fn of_png(path: &Path) -> Picture {
        let picture = open(path);
        let colors = picture.pixels().map(|pixel| DVec3::from(pixel.0.map(f64::from)) / 255.0);
        Picture { width: picture.width() as usize, colors: colors.collect() }
    }

    fn of_film(film: &Film) -> Picture {
        let clipped = film.pixels().iter().map(|color| color.clamp(DVec3::ZERO, DVec3::ONE));
        Picture { width: film.width() as usize, colors: clipped.collect() }
    }

    fn mirrored(&self) -> Picture {
        let colors = self.colors.chunks(self.width).flat_map(|row| row.iter().rev().copied()).collect();
        Picture { width: self.width, colors }
    }

    fn distance(&self, other: &Picture) -> f64 {
        assert_eq!((self.width, self.colors.len()), (other.width, other.colors.len()));
        let squares: f64 = self.colors.iter().zip(&other.colors).map(|(a, b)| a.distance_squared(*b)).sum();
        (squares / (3 * self.colors.len()) as f64).sqrt()
    }
}

/// The scene as its authors trace it: the mean of the four corners of each pixel.
fn rendered(path: &Path) -> Picture {
    let mut scene = file::read(path).unwrap_or_else(|error| panic!("{}", error.report(false))).scene;
    scene.sampling = Sampling::Shared { n: 1 };
    let scene = build(&scene, &Default::default()).expect("a supported scene");
    let settings = Settings { threads: 2, ..Settings::whole(&scene) };
    Picture::of_film(&render(&scene, &settings, |_| (), &AtomicBool::new(false)).expect("a picture").film)
}

#[track_caller]
fn is_the_same_picture(scene: &str, image: &str) {
    let (Some(scene), Some(image)) = (shared(&format!("nff/{scene}")), shared(&format!("nff/images/{image}"))) else {
        return;
    };
    let (ours, theirs) = (rendered(&scene), Picture::of_png(&image));
    let (distance, mirrored) = (ours.distance(&theirs), ours.mirrored().distance(&theirs));
    println!("{}: {distance:.4}, mirrored {mirrored:.4}", image.display());
    assert!(distance <= NEAR, "{distance} from {}", image.display());
    assert!(mirrored >= 2.0 * distance, "mirrored {mirrored}, as it is {distance} from {}", image.display());
}

#[test]
fn tetra_is_the_picture_of_its_authors() {
    is_the_same_picture("tetra-6.nff.gz", "tetra.png");
}

#[test]
fn mount_is_the_picture_of_its_authors() {
    is_the_same_picture("mount-6.nff.gz", "mount.png");
}

#[test]
fn tree_is_the_picture_of_its_authors() {
    is_the_same_picture("tree-11.nff.gz", "tree.png");
}
