//! The command line as its users meet it: results on standard output, messages on standard error, exit codes.

use crate::calls::{fails, prints, raywalk, says};
use std::fs;
use std::path::Path;

#[test]
fn without_a_terminal_the_main_job_prints_the_walk() {
    let walk = prints(&[]);
    assert!(walk.starts_with("textbook · pixel 160,120 · f64 · recursive, depth 1\n"), "{walk}");
    assert!(walk.contains("result: (393.054, 311.666, 370.310)"), "{walk}");
    assert_eq!(prints(&["walk"]), walk);
    assert_eq!(prints(&["walk", "textbook", "--pixel", "160,120"]), walk);
    assert_eq!(prints(&["trace", "textbook", "--pixel", "160,120", "--format", "text"]), walk);
}

#[test]
fn a_saved_log_walks_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("pixel.ndjson");
    let log = log.to_str().expect("UTF-8");
    prints(&["trace", "textbook", "--pixel", "160,120", "--arithmetic", "decimal:3", "-o", log]);
    let live = prints(&["walk", "textbook", "--arithmetic", "decimal:3"]);
    assert_eq!(prints(&["walk", log]), live);
    let piped = raywalk(&["walk", "-"]).write_stdin(fs::read(log).expect("the log")).output().expect("it runs");
    assert_eq!(String::from_utf8_lossy(&piped.stdout), live);
}

#[test]
fn a_rendered_pixel_is_its_trace_bit_for_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["textbook", "figure-6", "transmission"] {
        let picture = folder.path().join("picture.pfm");
        let file = picture.to_str().expect("UTF-8");
        prints(&["render", name, "--size", "40x30", "-o", file, "--quiet"]);
        let pixels = pfm(&picture);
        for [x, y] in [[0, 0], [39, 29], [20, 15], [7, 22]] {
            let log = prints(&["trace", name, "--size", "40x30", "--pixel", &format!("{x},{y}")]);
            let result = log.lines().rev().nth(1).expect("a result");
            let result: serde_json::Value = serde_json::from_str(result).expect("JSON");
            let traced: Vec<f32> =
                (0..3).map(|channel| result["result"]["color"][channel].as_f64().expect("a number") as f32).collect();
            assert_eq!(pixels[y][x].map(f32::to_bits), [traced[0], traced[1], traced[2]].map(f32::to_bits));
        }
    }
}

/// The pixels of a PFM file, from the top row down.
fn pfm(path: &Path) -> Vec<Vec<[f32; 3]>> {
    let bytes = fs::read(path).expect("a picture");
    let header_end = bytes.iter().enumerate().filter(|(_, byte)| **byte == b'\n').nth(2).expect("three lines").0 + 1;
    let header = String::from_utf8(bytes[..header_end].to_vec()).expect("text");
    let width: usize = header.split_whitespace().nth(1).expect("a width").parse().expect("a number");
    let floats: Vec<f32> = bytes[header_end..]
        .chunks_exact(4)
        .map(|four| f32::from_le_bytes(four.try_into().expect("four bytes")))
        .collect();
    let pixels: Vec<[f32; 3]> = floats.chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect();
    pixels.chunks(width).rev().map(<[_]>::to_vec).collect()
}

#[test]
fn a_crop_is_that_part_of_the_whole_on_any_threads() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    prints(&["render", "figure-6", "--size", "50x40", "-o", &path("whole.pfm"), "--quiet"]);
    prints(&[
        "render",
        "figure-6",
        "--size",
        "50x40",
        "--crop",
        "13,5,47,38",
        "--threads",
        "7",
        "-o",
        &path("part.pfm"),
        "-q",
    ]);
    let whole = pfm(Path::new(&path("whole.pfm")));
    let part = pfm(Path::new(&path("part.pfm")));
    assert_eq!((part.len(), part[0].len()), (33, 34));
    for (y, row) in part.iter().enumerate() {
        assert_eq!(row[..], whole[y + 5][13..47]);
    }
}

#[test]
fn the_formats_of_pictures() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, extra, start) in [
        ("a.png", None, b"\x89PNG".as_slice()),
        ("b.png", Some("--png16"), b"\x89PNG"),
        ("c.ppm", None, b"P6\n12 9\n255\n"),
        ("d.pfm", None, b"PF\n12 9\n-1.0\n"),
    ] {
        let path = folder.path().join(name);
        let mut arguments = vec!["render", "textbook", "--size", "12x9", "-q", "-o", path.to_str().expect("UTF-8")];
        arguments.extend(extra);
        prints(&arguments);
        assert!(fs::read(&path).expect("a picture").starts_with(start), "{name}");
    }
    let png16 = image_bits(&folder.path().join("b.png"));
    assert_eq!((image_bits(&folder.path().join("a.png")), png16), (8, 16));
}

/// Bits a channel, from a PNG's header.
fn image_bits(path: &Path) -> u8 {
    fs::read(path).expect("a picture")[24]
}

#[test]
fn statistics_count_rays() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.png");
    let path = path.to_str().expect("UTF-8");
    let statistics = prints(&["render", "textbook", "--size", "31x21", "-o", path, "--stats", "json", "-q"]);
    let statistics: serde_json::Value = serde_json::from_str(&statistics).expect("JSON");
    let rays = &statistics["rays"];
    let number = |value: &serde_json::Value| value.as_u64().expect("a count");
    assert_eq!(number(&rays["camera"]), 31 * 21);
    let kinds = ["camera", "reflected", "transmitted", "shadow"];
    assert_eq!(number(&rays["total"]), kinds.iter().map(|kind| number(&rays[*kind])).sum::<u64>());
    assert_eq!(number(&rays["transmitted"]), 0);
    // At depth 1 each camera ray that hits spawns one reflected ray: both materials reflect.
    assert_eq!(rays["reflected"], statistics["hits"]["camera"]);
    assert_eq!(statistics["by_depth"][1], rays["reflected"]);
    assert!(number(&statistics["tests"]["primitives"]) > number(&rays["camera"]));
    assert!(statistics["clipped_pixels"].as_u64().is_some_and(|pixels| pixels > 0));
}

#[test]
fn skipping_changes_no_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["figure-6", "glass-shadows", "hall-of-mirrors", "total-reflection", "transmission"] {
        let render = |file: &str, skip: &str| {
            let path = folder.path().join(file);
            let to = path.to_str().expect("UTF-8");
            prints(&["render", name, "--size", "32x24", "--skip", skip, "-o", to, "-q"]);
            fs::read(path).expect("a picture")
        };
        assert_eq!(render("all.pfm", "all"), render("none.pfm", "none"), "{name}");
    }
}

#[test]
fn scenes_are_listed_checked_and_shown() {
    let names = prints(&["scene", "list"]);
    assert!(names.lines().any(|name| name == "figure-6") && names.lines().count() >= 7, "{names}");
    for name in names.lines() {
        prints(&["scene", "check", name]);
        let shown = prints(&["scene", "show", name]);
        let again = raywalk(&["scene", "show", "-"]).write_stdin(shown.clone()).output().expect("it runs");
        assert_eq!(String::from_utf8_lossy(&again.stdout), shown, "{name}");
    }
}

#[test]
fn a_ray_may_have_leading_minus_signs() {
    let log = prints(&["trace", "textbook", "--ray", "-16,2,7,12,4,1"]);
    assert!(log.starts_with("{\"log\":\"raywalk-log/1\""));
    assert!(log.lines().next().expect("a header").contains("\"ray\":[-16.0,2.0,7.0,12.0,4.0,1.0]"), "{log}");
}

#[test]
fn files_named_like_the_built_in_scene_do_not_hide_the_main_job() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("textbook")).expect("a folder");
    for arguments in [&[][..], &["textbook"]] {
        let mut command = raywalk(arguments);
        command.current_dir(folder.path()).assert().success();
    }
}

#[test]
fn the_books_numbers_are_for_its_own_pixel() {
    says(2, &["trace", "textbook", "--pixel", "0,0", "--arithmetic", "printed"], "for the middle pixel only");
    says(2, &["render", "textbook", "-o", "a.png", "--arithmetic", "printed"], "one pixel");
    let deeper = ["walk", "textbook", "--max-depth", "4", "--arithmetic", "printed"];
    says(2, &deeper, "only for the built-in scene `textbook` as it is");
    assert!(prints(&["walk", "textbook", "--arithmetic", "printed"]).contains("result: (394.028, "));
}

#[test]
fn a_log_takes_no_options_of_tracing() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("pixel.json");
    let log = log.to_str().expect("UTF-8");
    prints(&["trace", "textbook", "--pixel", "160,120", "--format", "json", "-o", log]);
    says(2, &["walk", log, "--max-depth", "9"], "is traced already");
    // However a document is indented, it is a log.
    let text = fs::read_to_string(log).expect("the log").replacen('{', "{\n  ", 1);
    fs::write(log, text).expect("written");
    assert!(prints(&["walk", log]).contains("result: (393.054"));
    assert!(prints(&["walk", log, "--digits", "5"]).contains("result: (393.05433"));
}

#[test]
fn a_standard_error_that_is_full_spoils_nothing() {
    let Ok(full) = fs::OpenOptions::new().write(true).open("/dev/full") else {
        crate::shared::skipped("there is no /dev/full here");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let picture = folder.path().join("a.png");
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_raywalk"));
    command.args(["render", "textbook", "--size", "8x8", "--stats", "json", "-o"]).arg(&picture).stderr(full);
    let output = command.output().expect("it runs");
    assert!(output.status.success() && picture.exists() && !output.stdout.is_empty());
}

#[test]
fn wrong_calls_say_what_to_change() {
    says(2, &["trace", "textbook"], "expected --pixel X,Y, --ray");
    says(2, &["trace", "textbook", "--pixel", "321,0"], "outside the picture of 321 x 241 pixels");
    says(2, &["trace", "textbook", "--pixel", "1"], "expected 2 numbers separated by commas");
    says(2, &["trace", "textbook", "--ray", "0,0,0,0,0,0"], "a direction that is not zero");
    says(2, &["trace", "textbook", "--ray", "0,0,0,1e-200,0,0"], "a direction that is not zero");
    says(2, &["trace", "textbook", "--ray", "1e300,0,0,1,0,0"], "coordinates up to 1e100");
    says(2, &["walk", "--screenshot", "a.png"], "ends in .svg");
    says(2, &["trace", "textbok", "--pixel", "1,1"], "did you mean the built-in scene `textbook`?");
    says(2, &["trace", "no/such.json", "--pixel", "1,1"], "no/such.json: no such file or built-in scene\n");
    says(2, &["walk", "textbok"], "no such file or built-in scene; did you mean the built-in scene `textbook`?");
    says(2, &["walk", "textbook", "--pixel", "-1,5"], "expected 2 whole numbers from 0 on, found `-1`");
    says(2, &["trace", "textbook", "--region", "-1,0,5,5"], "expected 4 whole numbers from 0 on, found `-1`");
    says(
        2,
        &["render", "textbook", "-o", "a.gif"],
        "ends in .png, .ppm, .bmp, .tga, .qoi, .tiff, .jpg, .webp, .pfm or .exr",
    );
    says(2, &["render", "textbook", "-o", "src"], "unknown picture format");
    says(2, &["render", "textbook", "-o", "a.png", "--crop", "5,5,5,9"], "expected X0 < X1 <= 321");
    says(2, &["render", "textbook", "-o", "a.png", "--size", "0x9"], "each from 1 to 65535");
    says(2, &["render", "textbook", "-o", "a.png", "--arithmetic", "f16"], "unknown arithmetic `f16`");
    says(2, &["render", "textbook", "-o", "a.png", "--skip", "zero_wait"], "did you mean `zero_weight`?");
    says(2, &["render", "textbook", "-o", "a.png", "--skip", "blocked,zero_pth"], "did you mean `zero_path`?");
    says(2, &["render", "textbook", "-o", "a.png", "--threads", "x"], "invalid value 'x'");
    says(2, &["render", "figure-6", "-o", "a.png", "--arithmetic", "printed"], "one pixel");
    says(2, &["rendr"], "similar subcommand exists: 'render'");
    says(3, &["render", "textbook", "-o", "no/such/folder/a.png"], "cannot write");
}

#[test]
fn a_bad_scene_is_refused_where_it_is_bad() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bad.json");
    let text = fs::read_to_string("scenes/textbook.json").expect("a scene").replace("\"radius\": 3", "\"radius\": -1");
    fs::write(&path, text).expect("written");
    let path = path.to_str().expect("UTF-8");
    for command in
        [vec!["scene", "check", path], vec!["trace", path, "--pixel", "0,0"], vec!["render", path, "-o", "x.png"]]
    {
        let message = fails(2, &command);
        let expected = format!("error: {path}:34:77:");
        assert!(message.starts_with(&expected), "expected `{expected}` in: {message}");
        assert!(message.contains("objects[1].shape.sphere.radius: must be positive, found -1"), "{message}");
    }
}

#[test]
fn the_textbook_as_json_has_the_fields_of_the_contract() {
    let table: serde_json::Value = serde_json::from_str(&prints(&["textbook", "--format", "json"])).expect("JSON");
    let steps = table["steps"].as_array().expect("steps");
    let t2_a = steps.iter().find(|step| step["quantity"] == "sphere.t2_a").expect("step 5d");
    assert_eq!(t2_a["step"], "5d");
    assert_eq!((t2_a["printed"].as_f64(), t2_a["recomputed"].as_f64()), (Some(6.377), Some(6.377)));
    assert_eq!(t2_a["strict"].as_f64(), Some(6.380));
    assert_eq!(t2_a["verdict"], "agrees");
    let exact = t2_a["exact"].as_f64().expect("a number");
    assert!((exact - 6.304_347_826_086_957).abs() < 1e-12, "{exact}");
    assert_eq!(table["result"]["printed"].as_f64(), Some(394.028));
    assert_eq!(table["result"]["strict"].as_f64(), Some(394.134));
}

#[test]
fn stability_is_measured_on_files_or_the_own_sample() {
    let table = prints(&["stress"]);
    assert!(table.starts_with("family ") && table.contains("f13_slivers") && !table.contains("FAILS"), "{table}");
    let json: serde_json::Value = serde_json::from_str(&prints(&["stress", "--format", "json"])).expect("JSON");
    assert_eq!(json["rows"][0]["wrong"], 0);
    let answers = prints(&["stress", "--answers"]);
    let first: serde_json::Value = serde_json::from_str(answers.lines().next().expect("a line")).expect("JSON");
    assert!(first["id"].is_string() && first["out"]["hit"].is_boolean(), "{first}");
}

#[test]
fn a_case_that_is_none_stops_no_other_answer() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cases.json");
    let good = r#""in": {"o": [0, 0, 0], "d": [0, 0, 2], "c": [0, 0, 5], "r": 1}, "out": {"hit": true, "t": "4"}"#;
    let text = format!(
        r#"{{"family": "f01_own", "op": "sphere", "cases": [{{"id": "a", "in": {{}}, "out": {{"hit": true}}}},
        {{"id": "b", {good}}}]}}"#
    );
    fs::write(&path, text).expect("a file");
    let path = path.to_str().expect("UTF-8");
    let output = raywalk(&["stress", "--answers", path]).output().expect("it runs");
    let lines = String::from_utf8(output.stdout).expect("UTF-8");
    let lines: Vec<serde_json::Value> = lines.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert!(lines.len() == 2 && lines[0]["id"] == "a" && lines[0]["error"].is_string(), "{lines:?}");
    assert_eq!((lines[1]["id"].as_str(), lines[1]["out"]["t"].as_f64()), (Some("b"), Some(4.0)));
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn wrong_answers_and_files_that_are_none_have_their_exit_codes() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str, text: &str| -> String {
        let path = folder.path().join(name);
        fs::write(&path, text).expect("a file");
        path.to_str().expect("UTF-8").to_owned()
    };
    let sphere = |t: &str| {
        format!(
            r#"{{"family": "f01_own", "op": "sphere", "cases": [{{"id": "a",
            "in": {{"o": [0, 0, 0], "d": [0, 0, 2], "c": [0, 0, 5], "r": 1}}, "out": {{"hit": true, "t": "{t}"}}}}]}}"#
        )
    };
    assert!(prints(&["stress", &path("right.json", &sphere("4"))]).contains("holds"));
    let wrong = raywalk(&["stress", &path("wrong.json", &sphere("4.5"))]).output().expect("it runs");
    assert_eq!(wrong.status.code(), Some(1));
    says(2, &["stress", "nowhere.json"], "nowhere.json: no such file, expected a file of cases");
    says(2, &["stress", &path("text.json", "no JSON")], "text.json: ");
    says(2, &["stress", &path("op.json", &sphere("4").replace("\"sphere\"", "\"what\""))], "unknown operation `what`");
    says(2, &["stress", &path("in.json", &sphere("4").replace("\"r\"", "\"s\""))], "case `a`: in");
    says(
        2,
        &["stress", &path("none.json", r#"{"family": "f", "op": "mesh", "cases": []}"#.trim_end_matches('}'))],
        "none.json",
    );
}

/// What `scene check` says of the lights of a room: a floor, a ball on it, the eye above.
#[track_caller]
fn checks_lights(lights: &str, expected: &[&str]) {
    let scene = format!(
        r#"{{"format": "raywalk-scene/1", "name": "room", "camera": {{"position": [0, 2, 6], "look_at": [0, 1, 0]}},
  "lights": [{lights}],
  "materials": {{"clay": {{"diffuse": [0.7, 0.3, 0.2]}}, "unused": {{}}}},
  "objects": [{{"shape": {{"plane": {{"coefficients": [0, 1, 0, 0]}}}}, "material": "clay"}},
              {{"shape": {{"sphere": {{"center": [0, 1, 0], "radius": 1}}}}, "material": "clay"}}]}}"#
    );
    let output = raywalk(&["scene", "check", "-"]).write_stdin(scene).output().expect("it runs");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(output.status.success(), "{said}");
    let lines: Vec<_> = said.lines().filter(|line| line.starts_with("warning: ")).collect();
    let unused = "warning: <stdin>:3:55: materials.unused: no object has this material";
    let expected: Vec<_> = [unused].into_iter().chain(expected.iter().copied()).collect();
    assert_eq!(lines.len(), expected.len(), "{said}");
    assert!(lines.iter().zip(expected).all(|(line, expected)| line.starts_with(expected)), "{said}");
}

#[test]
fn lights_that_light_nothing_in_view_are_warned_of() {
    let at = |position: &str| format!(r#"{{"name": "lamp", "point": {{"position": {position}}}}}"#);
    let dark = "warning: <stdin>:2:14: lights[0]: lights nothing in view: reaches no surface seen through 3072 pixels";
    // In the ball, and under the floor.
    checks_lights(&at("[0, 1, 0]"), &[dark]);
    checks_lights(&at("[0, -1, 0]"), &[dark]);
    checks_lights(r#"{"directional": {"direction": [0, 1, 0]}}"#, &[dark]);
    // In view, and over the eye.
    checks_lights(&at("[1, 2, 1]"), &[]);
    checks_lights(
        &at("[1, 9, 1]"),
        &["warning: <stdin>:2:14: lights[0]: is outside the field of view, which it lights all the same"],
    );
    checks_lights(r#"{"directional": {"direction": [0, -1, 0]}}"#, &[]);
}

#[test]
fn the_schema_is_printed() {
    let schema = prints(&["scene", "schema"]);
    let schema: serde_json::Value = serde_json::from_str(&schema).expect("JSON");
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    assert_eq!(schema["properties"]["format"]["const"], "raywalk-scene/1");
}
