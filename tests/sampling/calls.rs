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
        "unknown sampling `sobl`, did you mean `sobol`? expected `none`, `regular`, `shared`, `adaptive`, `stochastic`, `random`, `sobol`, \
         `statistical` or `guided`",
    );
}

#[test]
fn a_seed_is_an_option_and_is_in_the_scene_and_the_log() {
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
        "→ the cell at (0, 0) with side 0.250 is accepted: the samples agree (Δ_I ≤ Δ_max: 0 ≤ 0.0500)\n",
        "its corners differ by more than the threshold (Δ_I > Δ_max: 0.800 > 0.0500)\n",
        "is accepted: it may not be cut further\n",
        "Δ_max = θ·w_o = 0.0500·1 = 0.0500   [cell.limit 1.4.2]\n",
    ] {
        assert!(adaptive.contains(expected), "expected `{expected}` in: {adaptive}");
    }
    let statistical = text("statistical:confidence=0.9,tolerance=0.1,min=8,max=16", "8,8");
    for expected in [
        "s_x = ",
        "h_m = t_m∘σ_m = (",
        "→ 8 samples are too few, the interval of their mean is too wide: 16 are taken (h_max > h_lim: ",
        "→ the mean is accepted: ",
    ] {
        assert!(statistical.contains(expected), "expected `{expected}` in: {statistical}");
    }
    // Beside a pixel with a small object.
    let guided = text("guided:tolerance=0.01,min=4,max=8", "9,8");
    for expected in [
        "σ_g = √(V_g + (0.25·K_g)²) = √(",
        "n_g = (σ_g/ε_g)^0.75 = (",
        "→ 4 samples are too few for what the first samples of the pixels around it saw: 8 are taken (n_g > n_p: ",
        "→ the mean is accepted: its samples are as many as the first samples of the pixels around it ask for (n_g ≤ n_p: ",
        "I_p = Σ_s(I)/n_p = ",
    ] {
        assert!(guided.contains(expected), "expected `{expected}` in: {guided}");
    }
    let guided = text("guided:tolerance=0.0001,min=4,max=8", "9,8");
    assert!(guided.contains("→ the mean is accepted: there may be no more samples (n_g > n_p: "), "{guided}");
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

/// What a frame shows, and what its log says: the same numbers, for some pixels of a turning wheel.
#[test]
fn a_frame_is_traced_as_it_is_rendered() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for (scene, frame, time) in
        [("spoked-wheel", "7", 6.0), ("spoked-wheel", "4", 3.0), ("spoked-wheel-open-shutter", "7", 6.0)]
    {
        let frames = format!("{frame}-{frame}");
        prints(folder, &["render", scene, "-o", "wheel.pfm", "--frames", &frames, "-q", "--size", "60x20"]);
        let picture = fs::read(folder.join("wheel.pfm")).expect("a picture");
        let mut differs_from_first = false;
        for (x, y) in (0..10).flat_map(|row| (0..15).map(move |column| (4 * column + 1, 2 * row))) {
            let pixel = format!("{x},{y}");
            let call = ["trace", scene, "--pixel", &pixel, "--size", "60x20"];
            let log = prints(folder, &[&call[..], &["--frames", frame]].concat());
            // Rows run from the bottom up, each of three floats a pixel, at the end of the file.
            let place = picture.len() - 4 * 3 * 60 * 20 + 4 * 3 * (60 * (19 - y) + x);
            let rendered = [0, 4, 8].map(|k| {
                let bytes = picture[place + k..place + k + 4].try_into().expect("four bytes");
                f32::from_le_bytes(bytes)
            });
            assert_eq!(result(&log).map(|channel| channel as f32), rendered, "{scene}: {x},{y}");
            assert_eq!(header(&log)["frame"]["number"].to_string(), frame);
            assert_eq!(header(&log)["frame"]["time"], time);
            differs_from_first |= result(&log) != result(&prints(folder, &call));
        }
        // By the seventh frame every wheel has turned by a multiple of the angle between its spokes.
        assert_eq!(differs_from_first, (scene, frame) != ("spoked-wheel", "7"));
    }
    let log = prints(folder, &["trace", "spoked-wheel", "--pixel", "1,1"]);
    assert_eq!(header(&log)["frame"], serde_json::json!({"number": 1, "time": 0.0}));
    assert!(header(&prints(folder, &["trace", "figure-19", "--pixel", "1,1"])).get("frame").is_none());
    let walk = prints(folder, &["walk", "spoked-wheel", "--plain", "--pixel", "1,1", "--frames", "3"]);
    assert!(walk.starts_with("spoked-wheel · frame 3, pixel 1,1 · "), "{walk}");
    for command in ["trace", "walk"] {
        let says = |scene: &str, frame: &str, expected: &str| {
            says(folder, &[command, scene, "--pixel", "1,1", "--frames", frame], expected);
        };
        says("figure-19", "1", "--frames 1: the scene is no animation, expected `frames` in it");
        says("spoked-wheel", "13", "--frames 13: the scene has 12 frames");
        says("spoked-wheel", "1-2", "expected the number of one frame, from 1, found `1-2`");
    }
    fs::write(folder.join("wheel.ndjson"), log).expect("a file");
    says(folder, &["walk", "wheel.ndjson", "--frames", "2"], "is a log, which is traced already");
}

fn header(log: &str) -> serde_json::Value {
    serde_json::from_str(log.lines().next().expect("a header")).expect("JSON")
}

/// The colour of the pixel that a log is about.
fn result(log: &str) -> [f64; 3] {
    let line = log.lines().rev().nth(1).expect("a result");
    let line: serde_json::Value = serde_json::from_str(line).expect("JSON");
    serde_json::from_value(line["result"]["color"].clone()).expect("a colour")
}

/// Adaptive sampling says that it is biased where corners draw more than their place, and only there.
#[test]
fn adaptive_sampling_warns_where_it_is_biased() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let adaptive = "adaptive:threshold=0.1,depth=1";
    let warning = |arguments: &[&str]| {
        let output = raywalk(folder, arguments).output().expect("it runs");
        assert!(output.status.success(), "{arguments:?}");
        String::from_utf8(output.stderr).expect("UTF-8")
    };
    let expected = |scene: &str, effects: &str| {
        format!(
            "warning: {scene}: adaptive sampling is biased with {effects}: cells whose corners agree by chance are not \
             cut; expected another sampling, such as sobol:64\n"
        )
    };
    for (scene, effects) in [
        ("depth-of-field", "a lens"),
        ("motion-blur", "motion"),
        ("penumbra", "area lights"),
        ("polished-surface", "blurred bounces"),
        ("frosted-glass", "blurred bounces"),
    ] {
        let trace = ["trace", scene, "--pixel", "1,1", "--size", "4x3", "--sampling"];
        assert_eq!(warning(&[&trace[..], &[adaptive]].concat()), expected(scene, effects));
        assert_eq!(warning(&[&trace[..], &[adaptive, "--quiet"]].concat()), "");
        assert_eq!(warning(&[&trace[..], &["sobol:2"]].concat()), "");
    }
    let render = ["render", "-o", "a-#.pfm", "--size", "4x3", "--progress", "never", "--sampling", adaptive];
    let wheel = "spoked-wheel-open-shutter";
    let frames = [&render[..], &[wheel, "--frames", "1-3"]].concat();
    assert_eq!(warning(&frames), expected(wheel, "motion"), "once, not once a frame");
    assert_eq!(warning(&[&render[..], &["spoked-wheel"]].concat()), "", "the shutter is closed");
    assert_eq!(warning(&[&render[..], &["figure-17"]].concat()), "");
    let walk = ["walk", "penumbra", "--plain", "--pixel", "1,1", "--size", "4x3", "--sampling", adaptive];
    assert_eq!(warning(&walk), expected("penumbra.json", "area lights"));
}

#[test]
fn seeds_and_grids_that_cannot_be_are_refused_with_what_was_expected() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for seed in ["1e3", "-1", "18446744073709551616", "1.5", "x"] {
        let expected = format!("expected a whole number from 0 to 18446744073709551615, found `{seed}`");
        says(folder, &["render", "figure-19", "-o", "out.pfm", "--seed", seed], &expected);
    }
    prints(folder, &["render", "figure-19", "-o", "out.pfm", "--size", "4x4", "--seed", "18446744073709551615"]);
    says(
        folder,
        &["render", "figure-19", "-o", "out.pfm", "--sampling", "shared:1", "--pixel-grid", "corners"],
        "--pixel-grid corners: only with the sampling `none`, found `shared`",
    );
}
