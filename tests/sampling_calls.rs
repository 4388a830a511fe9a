//! Sampling and animation on the command line.

use assert_cmd::Command;
use std::fs;
use std::path::Path;

fn raywalk(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("raywalk").expect("the program");
    command.args(arguments).env_remove("NO_COLOR").current_dir(folder);
    command
}

#[track_caller]
fn prints(folder: &Path, arguments: &[&str]) -> String {
    let output = raywalk(folder, arguments).output().expect("it runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[track_caller]
fn says(folder: &Path, arguments: &[&str], expected: &str) {
    let output = raywalk(folder, arguments).output().expect("it runs");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(message.contains(expected), "{arguments:?}: expected `{expected}` in: {message}");
}

fn samples(folder: &Path, arguments: &[&str]) -> u64 {
    let call = [&["render", "figure-19", "-o", "out.pfm", "--size", "4x4", "--stats", "json"], arguments].concat();
    let statistics: serde_json::Value = serde_json::from_str(&prints(folder, &call)).expect("JSON");
    assert_eq!(statistics["samples"], statistics["rays"]["camera"]);
    statistics["samples"].as_u64().expect("a number")
}

#[test]
fn a_picture_of_16_pixels_shares_25_samples() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    assert_eq!(samples(folder, &["--sampling", "shared:1"]), 25);
    assert_eq!(samples(folder, &["--sampling", "none", "--pixel-grid", "corners"]), 25);
    assert_eq!(samples(folder, &["--sampling", "none"]), 16);
    assert_eq!(samples(folder, &["--sampling", "stochastic:7"]), 7 * 16);
    says(
        folder,
        &["render", "figure-19", "-o", "out.pfm", "--pixel-grid", "corners"],
        "--pixel-grid corners: only with the sampling `none`, found `adaptive`",
    );
    says(
        folder,
        &["render", "figure-19", "-o", "out.pfm", "--sampling", "sobl:4"],
        "unknown sampling `sobl`, expected none, regular, shared, adaptive, stochastic, random, sobol, statistical; did you mean `sobol`?",
    );
}

#[test]
fn a_seed_is_an_option_and_stands_in_the_scene_and_the_log() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let picture = |arguments: &[&str]| {
        prints(folder, &[&["render", "figure-17", "-o", "out.pfm", "--sampling", "random:2"], arguments].concat());
        fs::read(folder.join("out.pfm")).expect("the picture")
    };
    assert_eq!(picture(&["--seed", "0"]), picture(&[]));
    assert_ne!(picture(&["--seed", "1"]), picture(&[]));
    assert_eq!(picture(&["--seed", "1"]), picture(&["--seed", "1", "--threads", "7"]));
    let scene = prints(folder, &["scene", "show", "figure-17"]);
    assert!(scene.contains("\"seed\": 0"), "{scene}");
    fs::write(folder.join("seeded.json"), scene.replace("\"seed\": 0", "\"seed\": 1")).expect("a file");
    prints(folder, &["render", "seeded.json", "-o", "seeded.pfm", "--sampling", "random:2"]);
    assert_eq!(fs::read(folder.join("seeded.pfm")).expect("the picture"), picture(&["--seed", "1"]));
    let log = prints(folder, &["trace", "seeded.json", "--pixel", "1,1"]);
    assert!(log.lines().next().expect("a header").contains("\"seed\":1"), "{log}");
}

#[test]
fn decisions_are_said_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let text = |sampling: &str, pixel: &str| {
        prints(folder, &["trace", "figure-19", "--pixel", pixel, "--sampling", sampling, "--format", "text"])
    };
    let adaptive = text("adaptive:threshold=0.05,depth=3", "8,8");
    for expected in [
        "sample 1: s_x = 0, s_y = 0\n",
        "→ the pixel is subdivided: A may lie in it, and no corner sees that\n",
        "→ the cell at (0, 0) with side 0.250 is accepted: the samples agree\n",
        "its corners differ by more than the threshold\n",
        "is accepted: it may not be cut further\n",
        "Δ_max = θ·w_o = 0.050·1 = 0.050   [cell.limit 1.4.2]\n",
    ] {
        assert!(adaptive.contains(expected), "expected `{expected}` in: {adaptive}");
    }
    let statistical = text("statistical:confidence=0.9,tolerance=0.1,min=8,max=16", "8,8");
    for expected in [
        "s_x = ",
        "h_m = t_m∘σ_m = (",
        "→ 8 samples are too few, the interval of their mean is too wide: 16 are taken\n",
        "→ the mean is accepted: ",
    ] {
        assert!(statistical.contains(expected), "expected `{expected}` in: {statistical}");
    }
    let stochastic = text("stochastic:4", "8,8");
    assert!(stochastic.contains("s_x = (i_s + ξ_x)/c_s = ("), "{stochastic}");
    assert!(stochastic.contains("col = col_0 + s_x = 8 + "), "{stochastic}");
}

/// A scene of four frames in which nothing moves yet.
fn animation(folder: &Path) {
    let scene = prints(folder, &["scene", "show", "figure-19"]);
    let frames = "\"frames\": {\"count\": 4, \"duration\": 2},\n  \"output\"";
    fs::write(folder.join("wheel.json"), scene.replacen("\"output\"", frames, 1)).expect("a file");
}

#[test]
fn frames_go_into_numbered_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    animation(folder);
    prints(folder, &["render", "wheel.json", "-o", "wheel-####.ppm", "--frames", "2-4", "-q"]);
    let mut names: Vec<_> = fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert_eq!(names, ["wheel-0002.ppm", "wheel-0003.ppm", "wheel-0004.ppm", "wheel.json"]);
    prints(folder, &["render", "wheel.json", "-o", "one.ppm", "--frames", "3", "-q"]);
    let statistics =
        prints(folder, &["render", "wheel.json", "-o", "#.ppm", "--frames", "1-4", "-q", "--stats", "json"]);
    assert_eq!(statistics.lines().count(), 4, "{statistics}");
}

#[test]
fn frames_that_are_not_there_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    animation(folder);
    let call = |scene: &'static str, name: &'static str, frames: &'static str| {
        ["render", scene, "-o", name, "--frames", frames]
    };
    says(folder, &call("wheel.json", "a-##.png", "1-5"), "--frames 1-5: the scene has 4 frames");
    says(
        folder,
        &call("wheel.json", "a.png", "1-4"),
        "expected #### in the name of the picture for the frame's number, found a.png",
    );
    says(
        folder,
        &call("figure-19", "a-#.png", "1-2"),
        "--frames 1-2: the scene is no animation, expected `frames` in it",
    );
    says(
        folder,
        &call("wheel.json", "a-#.png", "3-1"),
        "expected the first and the last frame, such as 1-24, found `3-1`",
    );
    says(
        folder,
        &call("wheel.json", "a-#.png", "0-1"),
        "expected the first and the last frame, such as 1-24, found `0-1`",
    );
}
