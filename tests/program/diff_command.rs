//! `raywalk diff` as its users meet it: logs, regions, pictures, and what can't be compared.

use crate::calls::{fails, prints, raywalk, says};
use crate::shared::shared;
use serde_json::Value;
use std::io::Write;
use std::path::Path;
use tempfile::TempDir;

/// A folder with files that are written by calls.
struct Folder(TempDir);

impl Folder {
    fn new() -> Folder {
        Folder(tempfile::tempdir().expect("a folder"))
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().expect("UTF-8").to_owned()
    }

    /// Writes a file by a call; gives its path.
    fn made(&self, name: &str, call: &[&str]) -> String {
        let path = self.path(name);
        let quiet: &[&str] = if call[0] == "render" { &["-q"] } else { &[] };
        prints(&[call, &["-o", &path], quiet].concat());
        path
    }

    fn textbook(&self, name: &str, options: &[&str]) -> String {
        self.made(name, &[&["trace", "textbook", "--pixel", "160,120"], options].concat())
    }
}

/// What a comparison prints, and its exit code.
fn diff(arguments: &[&str]) -> (String, i32) {
    let answer = raywalk(&[&["diff"], arguments].concat()).output().expect("it runs");
    let out = String::from_utf8(answer.stdout).expect("UTF-8");
    (out, answer.status.code().expect("an exit code"))
}

#[track_caller]
fn summary(arguments: &[&str]) -> Value {
    let (out, code) = diff(&[arguments, &["--format", "json"]].concat());
    let document: Value = serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {out}"));
    let summary = document.get("summary").cloned().unwrap_or(document);
    assert_eq!(summary["same"].as_bool(), Some(code == 0), "{summary}");
    summary
}

#[test]
fn the_same_logs_are_the_same_in_every_form() {
    let folder = Folder::new();
    let lines = folder.textbook("a.ndjson", &[]);
    for other in [folder.textbook("b.json", &["--format", "json"]), folder.textbook("b.ndjson.gz", &[])] {
        let (out, code) = diff(&[&lines, &other]);
        assert_eq!(code, 0, "{out}");
        assert!(out.ends_with("The same: 93 values compared, none differs\n"), "{out}");
    }
    // Tests that the tracer didn't need say nothing about the computation; they are still steps that one log lacks.
    let hand = folder.textbook("hand.ndjson", &["--arithmetic", "decimal:3"]);
    assert_eq!(diff(&[&lines, &hand]).1, 1);
}

#[test]
fn one_of_two_logs_comes_from_standard_input() {
    let folder = Folder::new();
    let log = folder.textbook("a.ndjson", &[]);
    let bytes = std::fs::read(&log).expect("the log");
    let piped = raywalk(&["diff", &log, "-"]).write_stdin(bytes).output().expect("it runs");
    assert_eq!(piped.status.code(), Some(0));
    says(2, &["diff", "-", "-"], "only one of the two");
}

#[test]
fn tolerances_let_pass_what_they_say() {
    let folder = Folder::new();
    let f64 = folder.textbook("a.ndjson", &[]);
    let f32 = folder.textbook("b.ndjson", &["--arithmetic", "f32"]);
    let differing = |options: &[&str]| {
        let summary = summary(&[&[&*f64, &*f32], options].concat());
        summary["values"]["differ"].as_u64().expect("a count")
    };
    let exactly = differing(&[]);
    let by_relative = differing(&["--rel", "1e-7"]);
    assert!(exactly > by_relative && by_relative > 0, "{exactly} {by_relative}");
    assert_eq!(differing(&["--rel", "0.01"]), 0);
    assert_eq!(differing(&["--abs", "0.001"]), 0);
    // Beyond both: the colours are large, and near in proportion.
    assert_eq!(differing(&["--abs", "1e-9", "--rel", "0.01"]), 0);
    assert_eq!(differing(&["--digits", "3"]), 0);
    says(2, &["diff", &f64, &f32, "--abs", "-1"], "-1");
    says(2, &["diff", &f64, &f32, "--rel", "inf"], "expected a number from 0 on");
}

#[test]
fn regions_are_compared_pixel_by_pixel() {
    let folder = Folder::new();
    let region = |name: &str, corners: &str, options: &[&str]| {
        folder.made(name, &[&["trace", "textbook", "--region", corners], options].concat())
    };
    let a = region("a.ndjson", "158,119,162,121", &[]);
    let b = region("b.ndjson.gz", "159,119,163,122", &[]);
    let pixels = summary(&[&a, &b])["pixels"].clone();
    let counts = ["compared", "differ", "only_in_a", "only_in_b"].map(|key| pixels[key].as_u64().expect("a count"));
    assert_eq!(counts, [6, 0, 2, 6]);
    let (out, code) = diff(&[&a, &b]);
    assert_eq!(code, 1);
    assert!(out.contains("\nOnly in A: pixel 158,119\n") && out.contains("\nOnly in B: pixel 162,121\n"), "{out}");
    // A pixel finds its place in a region.
    let pixel = folder.textbook("pixel.ndjson", &[]);
    assert_eq!(summary(&[&pixel, &a])["pixels"]["only_in_b"], 7);
    // In the other arithmetic the first divergence names its pixel.
    let hand = region("hand.json", "158,119,162,121", &["--arithmetic", "decimal:3", "--format", "json"]);
    let (out, _) = diff(&[&a, &hand, "--brief"]);
    assert!(out.contains("\nFirst divergence in pixel 158,119, C: camera.length\n"), "{out}");
    assert!(out.contains("\n  pixels: 8 compared, 8 differ; 0 only in A, 0 only in B\n"), "{out}");
    let ray = folder.made("ray.ndjson", &["trace", "textbook", "--ray", "16,2,7,-12,4,1"]);
    says(2, &["diff", &ray, &a], "expected two of a kind");
    assert_eq!(diff(&[&ray, &pixel]).1, 0);
}

/// The log of a tracer that doesn't record a quantity.
fn without(log: &str, quantity: &str) -> String {
    let is_kept = |line: &&str| !line.contains(&format!("\"note\":\"{quantity}\"")) && !line.starts_with("{\"end\"");
    ended(&log.lines().filter(is_kept).collect::<Vec<_>>())
}

/// The header and events with an end that counts them.
fn ended(lines: &[&str]) -> String {
    format!("{}\n{{\"end\":{{\"events\":{}}}}}\n", lines.join("\n"), lines.len() - 1)
}

#[test]
fn only_what_both_have_is_compared_on_demand() {
    let folder = Folder::new();
    let log = folder.textbook("a.ndjson", &[]);
    let fewer = folder.path("fewer.ndjson");
    let text = std::fs::read_to_string(&log).expect("the log");
    std::fs::write(&fewer, without(&text, "hit.point")).expect("written");
    assert_eq!(diff(&[&log, &fewer]).1, 1);
    let (out, code) = diff(&[&log, &fewer, "--common"]);
    // Of 93 two are missing, the points of both rays; three inputs that they are count by themselves now.
    assert!(code == 0 && out.ends_with("The same: 94 values compared, none differs\n"), "{out}");
    // What both have still counts.
    let hand = folder.textbook("hand.ndjson", &["--arithmetic", "decimal:3"]);
    assert_eq!(diff(&[&hand, &fewer, "--common"]).1, 1);
    // Of regions, what both show.
    let region = |name: &str, corners: &str| folder.made(name, &["trace", "textbook", "--region", corners]);
    let [large, small] = [region("large.ndjson", "158,119,162,121"), region("small.ndjson", "160,119,163,120")];
    assert_eq!((diff(&[&large, &small]).1, diff(&[&large, &small, "--common"]).1), (1, 0));
    let away = region("away.ndjson", "10,10,11,11");
    let answer = raywalk(&["diff", &large, &away, "--common"]).output().expect("it runs");
    let message = String::from_utf8_lossy(&answer.stderr);
    assert!(answer.status.code() == Some(2) && message.contains("have no value in common"), "{message}");
    assert!(!String::from_utf8_lossy(&answer.stdout).contains("The same"));
}

#[test]
fn pixels_in_another_order_are_reported() {
    let folder = Folder::new();
    let log = folder.made("a.ndjson", &["trace", "textbook", "--region", "158,119,160,120"]);
    let text = std::fs::read_to_string(&log).expect("the log");
    let lines: Vec<&str> = text.lines().collect();
    let second = lines.iter().rposition(|line| line.contains("{\"pixel\":[159,119]}")).expect("a pixel");
    // The header, the second pixel, the first one.
    let swapped = ended(&[&lines[..1], &lines[second..lines.len() - 1], &lines[1..second]].concat());
    let other = folder.path("b.ndjson");
    std::fs::write(&other, swapped).expect("written");
    let answer = raywalk(&["diff", &log, &other]).output().expect("it runs");
    let message = String::from_utf8_lossy(&answer.stderr);
    let expected =
        "b.ndjson: its pixels don't follow one another row by row, so they can't all be found in the other log";
    assert!(answer.status.code() == Some(1) && message.contains(expected), "{message}");
    let same = raywalk(&["diff", &log, &log]).output().expect("it runs");
    assert_eq!((same.status.code(), &*same.stderr), (Some(0), &b""[..]));
}

#[test]
fn what_is_no_log_says_what_would_be_one() {
    let folder = Folder::new();
    let log = folder.textbook("a.ndjson", &[]);
    says(2, &["diff", &folder.path("none.ndjson"), &log], "no such file, expected a log or a picture");
    let scene = folder.path("scene.json");
    std::fs::write(&scene, raywalk::scene::builtin::text("textbook").expect("a scene")).expect("written");
    says(2, &["diff", &scene, &log], "found a scene; `raywalk trace` writes the log of one of its pixels");
    let other = folder.path("other");
    std::fs::write(&other, "").expect("written");
    says(2, &["diff", &log, &other], "found an empty file");
    std::fs::write(&other, "{\"log\":\"raywalk-log/9\"}\n").expect("written");
    says(2, &["diff", &log, &other], "this program reads `raywalk-log/1`");
    says(2, &["diff", &log, &log, "-o", &other], "a heat map is made of two pictures");
}

#[test]
fn a_log_that_was_cut_off_is_compared_up_to_there() {
    let folder = Folder::new();
    let log = folder.textbook("a.ndjson", &[]);
    let bytes = std::fs::read(&log).expect("the log");
    let cut = folder.path("cut.ndjson");
    std::fs::write(&cut, &bytes[..bytes.len() / 2]).expect("written");
    let answer = raywalk(&["diff", &cut, &log]).output().expect("it runs");
    assert_eq!(answer.status.code(), Some(2));
    let message = String::from_utf8_lossy(&answer.stderr);
    assert!(message.contains("warning: ") && message.contains("cut off"), "{message}");
    assert_eq!(summary(&[&cut, &log, "--allow-damaged"])["values"]["differ"], 0);
}

#[test]
fn pictures_are_compared_pixel_by_pixel() {
    let folder = Folder::new();
    let picture = |name: &str, options: &[&str]| {
        folder.made(name, &[&["render", "textbook", "--size", "40x30"], options].concat())
    };
    let (png, ppm, png16) = (picture("a.png", &[]), picture("a.ppm", &[]), picture("b.png", &["--png16"]));
    assert_eq!(diff(&[&png, &ppm]), ("the same: 1200 pixels, none differs\n".to_owned(), 0));
    let by_hand = picture("hand.png", &["--arithmetic", "decimal:1"]);
    let heat = folder.path("heat.png");
    let found = summary(&[&png, &by_hand, "-o", &heat]);
    let largest = &found["largest"];
    assert!(found["rmse"].as_f64() > Some(0.0) && largest["difference"].as_f64() > Some(0.0), "{found}");
    // 8 and 16 bits differ by no more than half a level of 8 bits.
    assert_eq!(diff(&[&png, &png16, "--abs", "0.00197"]).1, 0);
    assert_eq!(diff(&[&png, &png16]).1, 1);
    // White is where the difference is largest, black where there is none.
    let [x, y] = [0, 1].map(|axis| largest["pixel"][axis].as_u64().expect("a number") as u32);
    let heat = raywalk::render::export::read(&std::fs::read(&heat).expect("the heat map")).expect("a picture");
    assert_eq!((heat.size(), heat.pixel([x, y])), ([40, 30], [1.0; 3]));
    assert!((0..30).any(|y| (0..40).any(|x| heat.pixel([x, y]) == [0.0; 3])));
    let (float, single) = (picture("a.pfm", &[]), picture("b.pfm", &["--arithmetic", "f32"]));
    assert_eq!(diff(&[&float, &float]).1, 0);
    assert_eq!((diff(&[&float, &single]).1, diff(&[&float, &single, "--rel", "1e-4"]).1), (1, 0));
    says(2, &["diff", &png, &float], "expected two of a kind");
    let log = folder.textbook("a.ndjson", &[]);
    says(2, &["diff", &png, &log], "is a log and");
    says(2, &["diff", &png, &ppm, "--digits", "3"], "is for logs");
    says(2, &["diff", &png, &ppm, "-o", &folder.path("heat.ppm")], "expected a name that ends in .png");
    assert!(!Path::new(&folder.path("heat.ppm")).exists());
}

#[test]
fn the_known_difference_of_two_known_pictures() {
    let folder = Folder::new();
    let [a, b, wide] = ["a.ppm", "b.ppm", "wide.ppm"].map(|name| folder.path(name));
    std::fs::write(&a, b"P6\n# two pixels\n2 1\n255\n\x00\x00\x00\xff\xff\xff").expect("written");
    std::fs::write(&b, b"P6 2 1 255\n\x00\x33\x00\xff\xff\xff").expect("written");
    std::fs::write(&wide, b"P6 3 1 255\n\0\0\0\0\0\0\0\0\0").expect("written");
    let found = summary(&[&a, &b]);
    assert_eq!(found["differing_pixels"], 1);
    assert_eq!((&found["largest"]["pixel"], &found["largest"]["channel"]), (&serde_json::json!([0, 0]), &1.into()));
    assert_eq!(found["largest"]["difference"], 0.2);
    // √(0.2² / 6)
    assert!((found["rmse"].as_f64().expect("a number") - 0.081_649_658_092_772_6).abs() < 1e-15, "{found}");
    let (out, code) = diff(&[&a, &wide]);
    assert_eq!(code, 1);
    assert!(out.starts_with("different sizes: ") && out.contains("2 x 1") && out.contains("3 x 1"), "{out}");
    assert_eq!(summary(&[&a, &wide])["sizes"], serde_json::json!([[2, 1], [3, 1]]));
    std::fs::write(&wide, b"P6 3 1 255\n\0\0\0\0").expect("written");
    says(2, &["diff", &a, &wide], "expected 9 bytes behind the header, found 4");
    std::fs::write(&wide, b"P3\n3 1 # wide\n255\n1 2 3  4 256 6  7 8 9\n").expect("written");
    let expected =
        "wide.ppm:4:10: expected a level from 0 to 255, found `256`\n  |\n4 | 1 2 3  4 256 6  7 8 9\n  |          ^^^";
    says(2, &["diff", &a, &wide], expected);
}

/// The same pictures as other programs write them: in ASCII, grey, packed.
#[test]
fn pictures_of_other_programs_are_compared() {
    let folder = Folder::new();
    let written = |name: &str, bytes: &[u8]| {
        let path = folder.path(name);
        std::fs::write(&path, bytes).expect("written");
        path
    };
    let binary = written("a.ppm", b"P6 2 1 255\n\x07\x07\x07\xff\xff\xff");
    let ascii = b"P3\r\n# by hand\r\n2 1\r\n255\r\n7 7 7\r\n255 255 255\r\n";
    let packed = ruzstd::encoding::compress_to_vec(&ascii[..], ruzstd::encoding::CompressionLevel::Fastest);
    for (name, bytes) in [
        ("b.ppm", &ascii[..]),
        ("c.ppm.zst", &packed),
        ("d.pgm", b"P2 2 1 255 7 255"),
        ("e.pgm", b"P5\n2 1\n255\n\x07\xff"),
        ("f.pgm", b"P5\n2 1\n#wide\n65535\n\x07\x07\xff\xff"),
    ] {
        let other = written(name, bytes);
        assert_eq!(diff(&[&binary, &other]), ("the same: 2 pixels, none differs\n".to_owned(), 0), "{name}");
    }
    let float = written("a.pfm", b"PF 2 1 1.0\n\x3f\0\0\0\x3f\0\0\0\x3f\0\0\0\x40\0\0\0\x40\0\0\0\x40\0\0\0");
    let grey = written("b.pfm", b"Pf\n2 1\n-1.0\n\0\0\0\x3f\0\0\0\x40");
    assert_eq!(diff(&[&float, &grey]), ("the same: 2 pixels, none differs\n".to_owned(), 0));
    says(2, &["diff", &binary, &grey], "expected two of a kind");
}

#[test]
fn the_pictures_of_the_shared_cases() {
    let Some(files) = shared("cases/files") else { return };
    let file = |name: &str| files.join(name).to_string_lossy().into_owned();
    assert_eq!(diff(&[&file("grayref.pfm"), &file("y.exr")]), ("the same: 6 pixels, none differs\n".to_owned(), 0));
    let found = summary(&[&file("grayref.ppm"), &file("p3.ppm")]);
    assert_eq!((&found["differing_pixels"], &found["size"]), (&6.into(), &serde_json::json!([3, 2])));
    assert_eq!(
        found["largest"],
        serde_json::json!({"pixel": [0, 1], "channel": 0, "difference": 1.0, "a": 1.0, "b": 0.0})
    );
}

/// Whatever another program made of the order of its keys, a log is one to every command, packed and on standard input too.
#[test]
fn a_log_whose_keys_were_sorted_is_that_log() {
    let folder = Folder::new();
    let log = folder.textbook("a.ndjson", &[]);
    let lines = std::fs::read_to_string(&log).expect("the log");
    let value = |line: &str| serde_json::from_str::<Value>(line).expect("JSON");
    let sorted: String = lines.lines().map(|line| value(line).to_string() + "\n").collect();
    assert!(sorted.starts_with("{\"arithmetic\""));
    let pretty: String = lines.lines().map(|line| format!("{:#}\n", value(line))).collect();
    let document = value(&prints(&["trace", &log, "--format", "json"])).to_string();
    assert!(document.starts_with("{\"children\""));
    let walked = prints(&["walk", &log, "--plain"]);
    for (name, text) in [("sorted", sorted), ("pretty", pretty), ("document", format!("\u{feff}{document}"))] {
        let zstd = ruzstd::encoding::compress_to_vec(text.as_bytes(), ruzstd::encoding::CompressionLevel::Fastest);
        let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        gzip.write_all(text.as_bytes()).expect("memory");
        for bytes in [text.into_bytes(), zstd, gzip.finish().expect("memory")] {
            let other = folder.path(name);
            std::fs::write(&other, &bytes).expect("written");
            for (call, expected) in [
                (&["diff", &log, "-"][..], &*prints(&["diff", &log, &log])),
                (&["walk", "-", "--plain"], &walked),
                (&["trace", "-"], &lines),
            ] {
                let by_name: Vec<_> = call.iter().map(|word| if *word == "-" { &*other } else { word }).collect();
                for mut command in [raywalk(&by_name), raywalk(call)] {
                    let answer = command.write_stdin(bytes.clone()).output().expect("it runs");
                    assert_eq!(String::from_utf8_lossy(&answer.stderr), "", "{name} {call:?}");
                    assert!(answer.stdout == expected.as_bytes(), "{name} {call:?}");
                }
            }
            says(2, &["scene", "check", &other], "expected a scene, found a log");
        }
    }
}

/// Numbers that are spelt otherwise in some line, be it far behind the header, leave the log of a region whole; a changed one doesn't.
#[test]
fn the_log_of_a_region_with_other_numbers_is_whole() {
    let folder = Folder::new();
    let log = folder.path("a.ndjson");
    prints(&["trace", "textbook", "--region", "159,119,162,122", "-o", &log]);
    let text = std::fs::read_to_string(&log).expect("the log");
    let (before, behind) = text.rsplit_once(",\"value\":0.").expect("a fraction");
    let digits = behind.find(|c: char| !c.is_ascii_digit()).expect("the end of the number");
    let with = |ending: &str| [before, ",\"value\":0.", &behind[..digits], ending, &behind[digits..]].concat();
    for (text, warning) in [(with("e0"), ""), (with("e1"), "its digest fits neither its bytes nor its events")] {
        let zstd = ruzstd::encoding::compress_to_vec(text.as_bytes(), ruzstd::encoding::CompressionLevel::Fastest);
        for bytes in [text.into_bytes(), zstd] {
            let other = folder.path("b.ndjson");
            std::fs::write(&other, &bytes).expect("written");
            for name in [&*other, "-"] {
                let answer = raywalk(&["diff", &log, name]).write_stdin(bytes.clone()).output().expect("it runs");
                let said = String::from_utf8_lossy(&answer.stderr);
                assert!(said.contains(warning) && said.is_empty() == warning.is_empty(), "{name}: {said}");
                assert_eq!(answer.status.code(), Some(if warning.is_empty() { 0 } else { 2 }), "{name}");
            }
        }
    }
}

#[test]
fn utf_16_is_reported_as_walk_tells_it() {
    let folder = Folder::new();
    let log = folder.textbook("a.ndjson", &[]);
    let text = std::fs::read_to_string(&log).expect("the log");
    for (mark, encode) in
        [("\u{feff}", u16::to_le_bytes as fn(u16) -> [u8; 2]), ("\u{feff}", u16::to_be_bytes), ("", u16::to_le_bytes)]
    {
        let bytes: Vec<u8> = [mark, &text].concat().encode_utf16().flat_map(encode).collect();
        let other = folder.path("b.ndjson");
        std::fs::write(&other, bytes).expect("written");
        let message = fails(2, &["walk", &other]);
        assert!(message.contains("b.ndjson:1:1: the text is UTF-16, expected UTF-8"), "{message}");
        assert_eq!(fails(2, &["diff", &other, &log]), message);
        assert_eq!(fails(2, &["diff", &log, &other]), message);
    }
}
