//! The plates of the gallery in `docs/pictures/` show what the program renders. `UPDATE_GALLERY=1 cargo test --test program gallery` makes
//! them again.

use crate::bitmap::open;
use image::imageops::{FilterType, replace, resize};
use image::{Rgb, RgbImage};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The picture of a scene by the program.
fn picture(folder: &Path, scene: &str, options: &[&str]) -> RgbImage {
    let file = folder.join("plate.png");
    let mut command = Command::new(env!("CARGO_BIN_EXE_raywalk"));
    command.args(["render", scene, "-q", "-o"]).arg(&file).args(options);
    assert!(command.status().expect("it runs").success(), "{scene} {options:?}");
    open(&file)
}

/// Each pixel as a square of this side, so that it can be seen.
fn enlarged(picture: &RgbImage, side: u32) -> RgbImage {
    resize(picture, picture.width() * side, picture.height() * side, FilterType::Nearest)
}

/// Pictures of one size, from left to right and from top to bottom, on white.
fn plate(pictures: &[RgbImage], across: u32) -> RgbImage {
    const GAP: u32 = 6;
    let (width, height) = pictures[0].dimensions();
    let down = (pictures.len() as u32).div_ceil(across);
    let size = [across * (width + GAP) - GAP, down * (height + GAP) - GAP];
    let mut plate = RgbImage::from_pixel(size[0], size[1], Rgb([255; 3]));
    for (number, picture) in (0..).zip(pictures) {
        let [left, top] = [number % across * (width + GAP), number / across * (height + GAP)];
        replace(&mut plate, picture, left.into(), top.into());
    }
    plate
}

/// Compares a plate with the one in the gallery, or puts it there.
#[track_caller]
fn is_in_gallery(name: &str, plate: &RgbImage) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/pictures").join(format!("{name}.png"));
    if std::env::var_os("UPDATE_GALLERY").is_some() {
        plate.save(&path).expect("a place for it");
    }
    let shown = open(&path);
    assert!(shown == *plate, "{name} isn't what is rendered: UPDATE_GALLERY=1 makes it anew");
}

#[test]
fn figures_16_to_20() {
    let folder = tempfile::tempdir().expect("a folder");
    for figure in ["figure-16", "figure-17", "figure-18", "figure-19", "figure-20"] {
        let by = |sampling: &str| enlarged(&picture(folder.path(), figure, &["--sampling", sampling]), 4);
        is_in_gallery(figure, &plate(&[by("none"), by("adaptive:threshold=0.02,depth=4")], 2));
    }
}

/// Above in colour, below the luminance alone: left an edge that only colour shows, right one of luminance.
#[test]
fn equal_luminance() {
    let folder = tempfile::tempdir().expect("a folder");
    let by = |sampling: &str| enlarged(&picture(folder.path(), "equal-luminance", &["--sampling", sampling]), 4);
    let colours = [by("none"), by("adaptive:threshold=0.02,depth=4")];
    let mut greys = colours.clone();
    greys
        .iter_mut()
        .flat_map(RgbImage::pixels_mut)
        .for_each(|pixel| pixel.0 = [crate::equal_luminance::level(pixel.0); 3]);
    is_in_gallery("equal-luminance", &plate(&[colours, greys].concat(), 2));
}

#[test]
fn frames_of_the_wheels() {
    let folder = tempfile::tempdir().expect("a folder");
    for (scene, sampling) in [("spoked-wheel", "regular:4"), ("spoked-wheel-open-shutter", "stochastic:36")] {
        let frame = |number: u32| {
            let number = number.to_string();
            picture(folder.path(), scene, &["--frames", &number, "--sampling", sampling, "--size", "201x68"])
        };
        is_in_gallery(&format!("{scene}-frames"), &plate(&[1, 2, 3, 4].map(frame), 2));
    }
}

#[test]
fn distributed_effects() {
    let folder = tempfile::tempdir().expect("a folder");
    for (scene, sampling) in [
        ("penumbra", "stochastic:36"),
        ("weighted-light", "stochastic:9"),
        ("polished-surface", "stochastic:36"),
        ("frosted-glass", "stochastic:36"),
        ("depth-of-field", "stochastic:36"),
        ("motion-blur", "stochastic:36"),
    ] {
        is_in_gallery(scene, &picture(folder.path(), scene, &["--sampling", sampling]));
    }
}

/// Where guided sampling takes its samples: at edges and in penumbrae.
#[test]
fn samples_of_a_pixel() {
    let folder = tempfile::tempdir().expect("a folder");
    let options = ["--sampling", "guided:tolerance=0.002,min=4,max=256", "--layers", "samples"];
    picture(folder.path(), "penumbra", &options);
    is_in_gallery("samples", &enlarged(&open(&folder.path().join("plate.samples.png")), 2));
}

/// The scene is the numeric example with another camera and another light, and nothing else.
#[test]
fn the_numeric_example_from_the_side() {
    let read = |name: &str| {
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(name);
        std::fs::read_to_string(path).expect("a scene")
    };
    let moved = [
        ("\"name\": \"textbook\"", "\"name\": \"numeric-example\""),
        ("\"position\": [16, 2, 7]", "\"position\": [30, -6, 12]"),
        ("\"direction\": [-12, 4, 1]", "\"look_at\": [8, 7, 5]"),
        ("\"position\": [9, 12, 16]", "\"position\": [29, 12, 13]"),
    ];
    let expected = moved.iter().fold(read("scenes/textbook.json"), |text, (from, to)| text.replace(from, to));
    assert_eq!(read("docs/pictures/numeric-example.json"), expected);
    let folder = tempfile::tempdir().expect("a folder");
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/pictures/numeric-example.json");
    let shown = picture(folder.path(), scene, &["--sampling", "regular:3", "--exposure", "-1.3"]);
    is_in_gallery("numeric-example", &shown);
    // What the README says is in it: the wall, its part in the shadow, the ball, and the ball in the mirror.
    let luminance = |x, y| shown.get_pixel(x, y).0.map(u32::from).iter().sum::<u32>();
    assert!(luminance(200, 200) > luminance(120, 150) + 60, "the shadow on the wall");
    assert!(luminance(270, 110) > luminance(225, 75) + 200, "the lit and the other side of the ball");
    assert!(luminance(110, 60) + 100 < luminance(160, 50), "the dark ball in the mirror");
}
