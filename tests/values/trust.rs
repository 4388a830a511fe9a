//! Digits that can be trusted, on the command line.

use crate::calls::{prints, raywalk, says};
use std::fs;

#[test]
fn digits_that_can_be_trusted() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let trace = ["trace", "textbook", "--pixel", "160,120", "--arithmetic", "perturbed:1"];
    let walk = prints(&[&trace[..], &["--format", "text"]].concat());
    // Five runs say it to a digit or so.
    let digits =
        walk.split("result: (393.054, 311.666, 370.310) (").nth(1).and_then(|rest| rest.split(" digits").next());
    let digits = digits.unwrap_or_else(|| panic!("no result in: {walk}"));
    assert!(digits.split(", ").all(|digits| ["13", "14", "15"].contains(&digits)), "{digits}");
    for format in ["ndjson", "json"] {
        let log = path(format);
        prints(&[&trace[..], &["--format", format, "-o", &log]].concat());
        assert_eq!(prints(&["walk", &log]), walk, "{format}");
    }
    let zero = ["walk", "textbook", "--arithmetic"];
    assert_eq!(prints(&[&zero[..], &["perturbed"]].concat()), prints(&[&zero[..], &["perturbed:0"]].concat()));
    says(
        2,
        &["trace", "textbook", "--pixel", "0,0", "--arithmetic", "perturbed:-1"],
        "perturbed:SEED with a whole SEED from 0",
    );

    // Runs are compared when they are whole, so that such a log can't be written as it grows.
    let long = ["--sampling", "shared:160", "--arithmetic", "perturbed"];
    let message = "the log would have more than 1048576 events, expected fewer samples or a smaller --max-depth";
    says(2, &[&["trace", "textbook", "--pixel", "160,120"], &long[..]].concat(), message);
    let picture = path("viewer.svg");
    prints(&["walk", "textbook", "--arithmetic", "perturbed:1", "--screenshot", &picture]);
    assert!(fs::read_to_string(&picture).expect("a picture").contains("(15 digits)"));

    let (pfm, png) = (path("digits.pfm"), path("digits.png"));
    let render = ["render", "figure-6", "--size", "20x15", "--digits", "-o"];
    let statistics = prints(&[&render[..], &[&pfm, "--stats", "json", "--quiet"]].concat());
    // Five runs of one camera ray a pixel.
    assert!(statistics.contains("\"camera\":1500"), "{statistics}");
    let bytes = fs::read(&pfm).expect("the picture");
    let digits: Vec<f32> = bytes[bytes.len() - 3600..]
        .chunks(4)
        .map(|bytes| f32::from_le_bytes(bytes.try_into().expect("four bytes")))
        .collect();
    assert!(digits.iter().all(|digits| (10.0..=15.95).contains(digits)), "{digits:?}");
    let seeded = raywalk(&[&render[..], &[&png, "--arithmetic", "perturbed:1"]].concat()).output().expect("it runs");
    let note = String::from_utf8_lossy(&seeded.stderr).into_owned();
    assert!(seeded.status.success() && note.starts_with("note: digits: at least 1"), "{note}");
    says(
        2,
        &["render", "figure-6", "--digits", "-o", &png, "--arithmetic", "f32"],
        "expected --arithmetic perturbed:SEED",
    );
}

#[test]
fn causes_of_an_error_by_hand() {
    let trace = ["trace", "textbook", "--pixel", "160,120", "--causes"];
    let with = |more: &[&'static str]| [&trace[..], more].concat();
    let table = prints(&with(&["--arithmetic", "decimal:3"]));
    // The notes normalise R, which takes back most of what the rounding of the camera ray's direction does to it.
    assert!(table.contains("(+0.243, +0.152, +0.140)"), "{table}");
    let robust = prints(&with(&["--arithmetic", "decimal:3", "--formulas", "robust"]));
    assert!(robust.contains("(+1.030, +0.609, +0.514)"), "{robust}");
    assert!(prints(&with(&["--arithmetic", "f32", "--format", "json"])).starts_with("{\"arithmetic\":\"f32\""));
    says(
        2,
        &with(&[]),
        "expected --arithmetic decimal:N or f32, whose roundings of named quantities it studies, found f64",
    );
    says(2, &with(&["--arithmetic", "perturbed:3"]), "found perturbed:3");
    says(2, &with(&["--arithmetic", "decimal:3", "--format", "ndjson"]), "expected --format text or json");
}
