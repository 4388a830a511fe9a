//! The plates of the gallery in `docs/pictures/` show what the program renders. `UPDATE_GALLERY=1 cargo test --test program gallery` makes
//! them anew.

use crate::bitmap::Bitmap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The picture of a scene by the program.
fn picture(folder: &Path, scene: &str, options: &[&str]) -> Bitmap {
    let file = folder.join("plate.png");
    let mut command = Command::new(env!("CARGO_BIN_EXE_raywalk"));
    command.args(["render", scene, "-q", "-o"]).arg(&file).args(options);
    assert!(command.status().expect("it runs").success(), "{scene} {options:?}");
    Bitmap::open(&file)
}

/// Pictures of one size, from left to right and from top to bottom, on white.
fn plate(pictures: &[Bitmap], across: u32) -> Bitmap {
    const GAP: u32 = 6;
    let [width, height] = pictures[0].size();
    let down = (pictures.len() as u32).div_ceil(across);
    let mut plate = Bitmap::filled([across * (width + GAP) - GAP, down * (height + GAP) - GAP], [255; 3]);
    for (number, picture) in (0..).zip(pictures) {
        plate.put(picture, [number % across * (width + GAP), number / across * (height + GAP)]);
    }
    plate
}

/// Compares a plate with the one in the gallery, or puts it there.
#[track_caller]
fn is_in_gallery(name: &str, plate: &Bitmap) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/pictures").join(format!("{name}.png"));
    if std::env::var_os("UPDATE_GALLERY").is_some() {
        plate.save(&path);
    }
    let shown = Bitmap::open(&path);
    assert!(shown == *plate, "{name} isn't what is rendered: UPDATE_GALLERY=1 makes it anew");
}

#[test]
fn figures_16_to_20() {
    let folder = tempfile::tempdir().expect("a folder");
    for figure in ["figure-16", "figure-17", "figure-18", "figure-19", "figure-20"] {
        let by = |sampling: &str| picture(folder.path(), figure, &["--sampling", sampling]).enlarged(4);
        is_in_gallery(figure, &plate(&[by("none"), by("adaptive:threshold=0.02,depth=4")], 2));
    }
}

/// Above in colour, below the luminance alone: left an edge that only colour shows, right one of luminance.
#[test]
fn equal_luminance() {
    let folder = tempfile::tempdir().expect("a folder");
    let by = |sampling: &str| picture(folder.path(), "equal-luminance", &["--sampling", sampling]).enlarged(4);
    let colours = [by("none"), by("adaptive:threshold=0.02,depth=4")];
    let greys = colours.clone().map(|picture| picture.map(|pixel| [crate::equal_luminance::level(pixel); 3]));
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
