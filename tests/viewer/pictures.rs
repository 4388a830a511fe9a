//! The pictures of the viewer in the README and in `docs/viewer.md` are frames of the program as it is.
//! `UPDATE_GALLERY=1 cargo test --test viewer pictures` regenerates them.

use assert_cmd::Command;
use std::fs;
use std::path::Path;

/// The file, the walk, the keys and the size.
const PICTURES: [(&str, &[&str], &str, &str); 3] = [
    ("viewer", &["textbook", "--arithmetic", "decimal:3"], "30n", "110,30"),
    ("viewer-why", &["textbook"], "w", "100,28"),
    ("viewer-panes", &["glass-and-mirror"], "12n 2} Shift-Tab", "150,40"),
];

#[test]
fn pictures_of_the_viewer_are_frames_of_it() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, walk, keys, screen) in PICTURES {
        let made = folder.path().join(format!("{name}.svg"));
        let mut raywalk = Command::new(assert_cmd::cargo::cargo_bin!("raywalk"));
        raywalk.arg("walk").args(walk).args(["--keys", keys, "--screen", screen, "--screenshot"]).arg(&made);
        raywalk.assert().success();
        let made = fs::read_to_string(made).expect("a picture");
        let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("docs/pictures/{name}.svg"));
        if std::env::var_os("UPDATE_GALLERY").is_some() {
            fs::write(&kept, &made).expect("a place for the picture");
        }
        let kept = fs::read_to_string(&kept).unwrap_or_default();
        assert!(made == kept, "{name}.svg isn't a frame of the viewer: UPDATE_GALLERY=1 makes it anew");
    }
}
