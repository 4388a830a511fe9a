//! Pictures in every format, wherever one is written or read, and how values become their levels.

use crate::calls::{fails, prints, raywalk, says};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Formats of integers that lose nothing.
const LOSSLESS: [&str; 8] = ["png", "ppm", "bmp", "tga", "qoi", "tiff", "tif", "webp"];

/// All others.
const OTHERS: [&str; 4] = ["jpg", "jpeg", "pfm", "exr"];

const SMALL: [&str; 6] = ["render", "figure-6", "--size", "24x18", "-q", "-o"];

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

fn path(folder: &TempDir, name: &str) -> String {
    folder.path().join(name).to_str().expect("UTF-8").to_owned()
}

fn bytes(path: &str) -> Vec<u8> {
    fs::read(path).expect("a picture")
}

/// What a call that ends with 0 says on standard error.
#[track_caller]
fn tells(arguments: &[&str]) -> String {
    let output = raywalk(arguments).output().expect("it runs");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(output.status.success(), "{arguments:?}: {said}");
    said
}

/// The picture of a background alone, in a scene of one's own.
fn background(folder: &TempDir, color: [f64; 3], output: &str) -> String {
    let path = path(folder, "background.json");
    let scene = format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [0, 0, -1], "resolution": [2, 1]}},
        "background": {color:?}, "objects": [], "output": {output}}}"#
    );
    fs::write(&path, scene).expect("written");
    path
}

#[test]
fn sixteen_bits_are_for_png_alone() {
    let folder = folder();
    let part = path(&folder, "a.part");
    prints(&["render", "figure-6", "--size", "8x6", "-q", "-o", &part, "--shard", "1/1"]);
    for ending in LOSSLESS.iter().chain(&OTHERS).filter(|ending| **ending != "png") {
        let picture = path(&folder, &format!("a.{ending}"));
        let expected = "--png16: only PNG has 16 bits a channel, expected .png, found";
        says(2, &["render", "figure-6", "--png16", "-o", &picture], expected);
        says(2, &["merge", &part, "--png16", "-o", &picture], expected);
        assert!(!Path::new(&picture).exists());
    }
    prints(&["merge", &part, "--png16", "-o", &path(&folder, "a.PNG")]);
}

/// A part has no bits a channel: whoever asks for them is told where to.
#[test]
fn parts_have_no_sixteen_bits() {
    let folder = folder();
    let part = path(&folder, "a.part");
    let call = ["render", "figure-6", "--size", "8x6", "-q", "-o", &part, "--shard", "1/1"];
    let expected = "--png16: a part holds the traced values themselves; expected --png16 at `raywalk merge`";
    for more in [&["--png16"][..], &["--png16", "--resume"], &["--png16", "--digits"]] {
        says(2, &[&call[..], more].concat(), expected);
        assert!(!Path::new(&part).exists());
    }
    prints(&call);
    prints(&["merge", &part, "--png16", "-o", &path(&folder, "a.png")]);
    prints(&["render", "figure-6", "--size", "8x6", "-q", "--png16", "-o", &path(&folder, "b.png")]);
    let bytes = |name: &str| bytes(&path(&folder, name));
    assert!(bytes("a.png") == bytes("b.png"));
}

/// Some of what the decoder of JPEG says ends with a line feed.
#[test]
fn what_a_decoder_says_is_one_line() {
    let folder = folder();
    let damaged = path(&folder, "damaged.jpg");
    // The length of the first segment can't be less than its own two bytes.
    fs::write(&damaged, b"\xff\xd8\xff\xe0\0\0JFIF\0").expect("written");
    let output = raywalk(&["diff", &damaged, &damaged]).output().expect("it runs");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.ends_with("the picture is damaged: Found a marker with invalid length:0\n"), "{said}");
}

#[test]
fn every_ending_is_written_and_compared() {
    let folder = folder();
    let reference = path(&folder, "reference.png");
    prints(&[&SMALL[..], &[&reference]].concat());
    for ending in LOSSLESS {
        let written = path(&folder, &format!("a.{}", ending.to_uppercase()));
        prints(&[&SMALL[..], &[&written]].concat());
        assert_eq!(prints(&["diff", &reference, &written]), "the same: 432 pixels, none differs\n", "{ending}");
    }
    for ending in ["jpg", "jpeg"] {
        let written = path(&folder, &format!("a.{ending}"));
        prints(&[&SMALL[..], &[&written]].concat());
        // Sharp edges of colour are where JPEG errs most.
        let output = raywalk(&["diff", &reference, &written, "--format", "json"]).output().expect("it runs");
        let found: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let rmse = found["rmse"].as_f64().expect("a number");
        assert!(rmse > 0.0 && rmse < 0.02, "{ending}: {rmse}");
    }
    for ending in ["pfm", "exr"] {
        let written = path(&folder, &format!("a.{ending}"));
        prints(&[&SMALL[..], &[&written]].concat());
        says(2, &["diff", &reference, &written], "holds the traced values and");
    }
    let [pfm, exr] = ["a.pfm", "a.exr"].map(|name| path(&folder, name));
    assert_eq!(prints(&["diff", &pfm, &exr]), "the same: 432 pixels, none differs\n");
}

#[test]
fn parts_frames_and_resumed_pictures_in_every_format() {
    let folder = folder();
    let parts = ["1/2", "2/2"].map(|shard| {
        let part = path(&folder, &format!("{}.part", &shard[..1]));
        prints(&[&SMALL[..], &[&part, "--shard", shard]].concat());
        part
    });
    for ending in LOSSLESS.iter().chain(&OTHERS) {
        let [whole, merged, resumed] =
            ["whole", "merged", "resumed"].map(|name| path(&folder, &format!("{name}.{ending}")));
        prints(&[&SMALL[..], &[&whole]].concat());
        prints(&["merge", "-q", "-o", &merged, &parts[0], &parts[1]]);
        prints(&[&SMALL[..], &[&resumed, "--resume"]].concat());
        assert!(bytes(&merged) == bytes(&whole) && bytes(&resumed) == bytes(&whole), "{ending}");
        assert!(!Path::new(&format!("{resumed}.checkpoint")).exists());
        let frames = path(&folder, &format!("f#.{ending}"));
        prints(&["render", "spoked-wheel", "--size", "12x4", "--frames", "2-3", "-q", "-o", &frames]);
        for frame in ["f2", "f3"] {
            assert!(Path::new(&path(&folder, &format!("{frame}.{ending}"))).exists(), "{frame} {ending}");
        }
    }
}

#[test]
fn the_longest_side_of_a_webp_is_said_before_the_work_begins() {
    let folder = folder();
    let webp = path(&folder, "a.webp");
    let call = ["render", "textbook", "-o", &webp, "--sampling", "sobol:1048576", "--size", "16384x16000"];
    says(2, &call, "the format has at most 16383 pixels along a side, found 16384 x 16000");
    // A part of it may be short enough.
    prints(&["render", "textbook", "-q", "-o", &webp, "--size", "16384x2", "--crop", "0,0,20,2"]);
    assert!(Path::new(&webp).exists());
}

/// White, transfer and exposure of the scene, of the call, and of the merging of parts.
#[test]
fn levels_are_values_times_two_to_the_exposure_over_white_through_the_curve() {
    let folder = folder();
    let scene = background(&folder, [0.25, 1.0, 9.0], r#"{"white": 2, "exposure": 1}"#);
    let [ppm, pfm, first, second] = ["a.ppm", "a.pfm", "1.part", "2.part"].map(|name| path(&folder, name));
    prints(&["render", &scene, "-q", "-o", &first, "--shard", "1/2"]);
    prints(&["render", &scene, "-q", "-o", &second, "--shard", "2/2"]);
    let cases: [(&[&str], [f64; 3]); 6] = [
        // 255 · x · 2^1 / 2, and so on.
        (&[], [0.25, 1.0, 9.0]),
        (&["--exposure", "-2.5"], [0.25, 1.0, 9.0].map(|x| x / 32.0_f64.sqrt() / 2.0)),
        (&["--exposure=-2"], [0.03125, 0.125, 1.125]),
        (&["--white", "18"], [0.25, 1.0, 9.0].map(|x| x / 9.0)),
        (&["--exposure", "0", "--white", "1e3"], [0.00025, 0.001, 0.009]),
        (&["--transfer", "linear", "--white", "9", "--exposure", "-0"], [0.25 / 9.0, 1.0 / 9.0, 1.0]),
    ];
    for (options, shown) in cases {
        let highest = 255.0;
        let levels = shown.map(|x| (x.min(1.0) * highest + 0.5).floor() as u8);
        // IEC 61966-2-1.
        let curve = |x: f64| if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 };
        let curved = shown.map(|x| (curve(x.min(1.0)) * highest + 0.5).floor() as u8);
        for (transfer, expected) in [("linear", levels), ("srgb", curved)] {
            let options: Vec<&str> =
                options.iter().copied().filter(|word| !["--transfer", "linear"].contains(word)).collect();
            let options = [&options[..], &["--transfer", transfer]].concat();
            prints(&[&["render", &scene, "-q", "-o", &ppm], &options[..]].concat());
            let expected = [b"P6\n2 1\n255\n", &expected.repeat(2)[..]].concat();
            assert_eq!(bytes(&ppm), expected, "{options:?}");
            prints(&[&["merge", "-q", "-o", &ppm, &first, &second], &options[..]].concat());
            assert_eq!(bytes(&ppm), expected, "merge {options:?}");
        }
        prints(&[&["render", &scene, "-q", "-o", &pfm], options].concat());
        let traced = [0.25_f32, 1.0, 9.0].map(f32::to_le_bytes).concat().repeat(2);
        assert_eq!(bytes(&pfm), [b"PF\n2 1\n-1.0\n", &traced[..]].concat(), "{options:?}");
    }
}

#[test]
fn a_scene_says_its_exposure_and_the_call_wins() {
    let folder = folder();
    let scene = background(&folder, [0.5, 0.5, 0.5], r#"{"exposure": -1.5, "transfer": "srgb"}"#);
    let shown: serde_json::Value = serde_json::from_str(&prints(&["scene", "show", &scene])).expect("JSON");
    assert_eq!(shown["output"], serde_json::json!({"white": 1, "transfer": "srgb", "exposure": -1.5}));
    let schema = prints(&["scene", "schema"]);
    assert!(schema.contains("\"exposure\""));
    let ppm = path(&folder, "a.ppm");
    prints(&["render", &scene, "-q", "-o", &ppm, "--exposure", "1", "--transfer", "linear"]);
    assert!(bytes(&ppm).ends_with(&[255; 6]));
}

#[test]
fn what_is_clipped_is_said_with_the_exposure_that_shows_it() {
    let folder = folder();
    let png = path(&folder, "a.png");
    let textbook = ["render", "textbook", "-o", &png];
    assert_eq!(
        tells(&textbook),
        "warning: 97 % of the pixels (75357 of 77361) were brighter than white and clipped; --exposure -1.2 shows all\n"
    );
    assert_eq!(tells(&[&textbook[..], &["--exposure", "-1.2"]].concat()), "");
    assert!(tells(&[&textbook[..], &["--exposure", "-1.1"]].concat()).starts_with("note: "));
    assert_eq!(tells(&[&textbook[..], &["-q"]].concat()), "");
    assert_eq!(tells(&["render", "textbook", "-o", &path(&folder, "a.pfm")]), "");
    // No exposure that may be asked for is low enough.
    let scene = background(&folder, [1e100, 0.0, 0.0], "{}");
    let said = tells(&["render", &scene, "-o", &png]);
    let warning = "warning: 100 % of the pixels (2 of 2) were brighter than white and clipped\n";
    assert!(said.ends_with(warning) && !said.contains("--exposure"), "{said}");
    // Parts and frames say it as pictures do.
    let part = path(&folder, "a.part");
    assert_eq!(tells(&["render", "textbook", "--size", "9x7", "-o", &part, "--shard", "1/1"]), "");
    let merged = tells(&["merge", &part, "-o", &png]);
    assert!(merged.starts_with("warning: ") && merged.ends_with(" shows all\n"), "{merged}");
    let counted = prints(&["render", "textbook", "-o", &png, "-q", "--stats", "json", "--exposure", "-1.2"]);
    let counted: serde_json::Value = serde_json::from_str(&counted).expect("JSON");
    assert_eq!(counted["clipped_pixels"], 0);
}

/// Thresholds are parts of white: it decides where cells are cut, and the exposure doesn't.
#[test]
fn white_moves_thresholds_and_exposure_does_not() {
    let folder = folder();
    let png = path(&folder, "a.png");
    let samples = |options: &[&str]| {
        let call = [
            "render",
            "penumbra",
            "--size",
            "64x48",
            "--sampling",
            "adaptive:threshold=0.1,depth=3",
            "-q",
            "-o",
            &png,
            "--stats",
            "json",
        ];
        let counted: serde_json::Value = serde_json::from_str(&prints(&[&call[..], options].concat())).expect("JSON");
        counted["samples"].as_u64().expect("a count")
    };
    let plain = samples(&[]);
    assert_eq!(samples(&["--exposure", "-8"]), plain);
    assert!(samples(&["--white", "1e6"]) < plain);
}

#[test]
fn parts_of_different_exposures_are_distinguished() {
    let folder = folder();
    let [plain, darker, png] = ["1.part", "2.part", "a.png"].map(|name| path(&folder, name));
    let call = ["render", "textbook", "--size", "60x40", "-q"];
    prints(&[&call[..], &["-o", &plain, "--shard", "1/2"]].concat());
    prints(&[&call[..], &["-o", &darker, "--shard", "2/2", "--exposure", "-1"]].concat());
    says(
        2,
        &["merge", "-o", &png, &plain, &darker],
        "are of different pictures, output: white 255, linear, exposure 0 against white 255, linear, exposure -1",
    );
    // A part of another exposure isn't the one that is asked for, though nothing but its header differs.
    prints(&[&call[..], &["-o", &darker, "--shard", "2/2"]].concat());
    prints(&["merge", "-q", "-o", &png, &plain, &darker, "--exposure", "-1"]);
    let whole = path(&folder, "whole.png");
    prints(&[&call[..], &["-o", &whole, "--exposure", "-1"]].concat());
    assert!(bytes(&whole) == bytes(&png));
}

#[test]
fn options_that_make_no_sense() {
    let folder = folder();
    let [png, log] = ["a.png", "a.ndjson"].map(|name| path(&folder, name));
    for (option, value, expected) in [
        ("--exposure", "101", "expected stops from -100 to 100, found `101`"),
        ("--exposure", "-100.5", "expected stops from -100 to 100, found `-100.5`"),
        ("--exposure", "nan", "expected stops from -100 to 100, found `nan`"),
        ("--exposure", "dark", "expected stops from -100 to 100, found `dark`"),
        ("--white", "0", "expected a number above 0, found `0`"),
        ("--white", "-1", "expected a number above 0, found `-1`"),
        ("--white", "inf", "expected a number above 0, found `inf`"),
        ("--transfer", "gamma", "[possible values: linear, srgb]"),
    ] {
        says(2, &["render", "textbook", "-o", &png, option, value], expected);
        says(2, &["trace", "textbook", "--pixel", "1,1", option, value], expected);
    }
    prints(&["trace", "textbook", "--region", "1,1,2,2", "--shard", "1/1", "--exposure", "-1", "-o", &log]);
    says(
        2,
        &["merge", &log, "-o", &path(&folder, "b.ndjson"), "--exposure", "1"],
        "--exposure: is for pictures, found logs",
    );
    // A log holds what is traced: it differs in the scene's digest alone.
    let other = path(&folder, "b.ndjson");
    prints(&["trace", "textbook", "--region", "1,1,2,2", "--shard", "1/1", "-o", &other]);
    let events = |path: &str| {
        let text = fs::read_to_string(path).expect("a log");
        text.lines().skip(1).filter(|line| !line.contains("\"end\"")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(events(&log), events(&other));
    assert!(fails(2, &["render", "textbook", "-o", "a"]).contains(".jpg, .webp, .pfm or .exr"));
}
