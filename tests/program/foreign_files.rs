//! Meshes, NFF and scenes as other programs write them: those of the collection beside the repository, and small ones of each
//! kind, plain and packed, in the commands that read them.

use crate::calls::raywalk;
use crate::shared::shared;
use flate2::{Compression, write::GzEncoder};
use ruzstd::encoding::{CompressionLevel, compress_to_vec};
use std::io::Write;
use std::path::Path;

/// A quad that the meshes below are, or the first of its two triangles.
const QUAD: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";

fn scene(mesh: &str) -> String {
    format!(
        "{{\"format\": \"raywalk-scene/1\", \"ambient\": [1, 1, 1],\n \"camera\": {{\"position\": [0.4, 0.45, 3], \"direction\": [0, 0, \
         -1], \"resolution\": [24, 18]}},\n \"materials\": {{\"m\": {{\"ambient\": [1, 1, 1]}}}},\n \"objects\": [{{\"name\": \
         \"mesh\", \"material\": \"m\", \"shape\": {{\"mesh\": {{\"path\": \"{mesh}\"}}}}}}]}}\n"
    )
}

/// What a command says and leaves, in this folder.
#[track_caller]
fn run(folder: &Path, arguments: &[&str]) -> (String, String) {
    let output = raywalk(arguments).current_dir(folder).output().expect("it runs");
    let (out, message) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{arguments:?}: {message}");
    (out.into_owned(), message.into_owned())
}

/// The picture of a mesh, and what every command that reads it says.
#[track_caller]
fn seen(name: &str, bytes: &[u8]) -> (Vec<u8>, String) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join(name), bytes).expect("written");
    std::fs::write(folder.path().join("s.json"), scene(name)).expect("written");
    let (_, warnings) = run(folder.path(), &["scene", "check", "s.json"]);
    let (_, said) = run(folder.path(), &["render", "s.json", "-o", "s.ppm"]);
    let first = |text: &str| text.lines().next().unwrap_or_default().to_owned();
    assert!(warnings.is_empty() || first(&warnings) == first(&said), "{warnings}\n{said}");
    let (log, _) = run(folder.path(), &["trace", "s.json", "--pixel", "12,9"]);
    assert!(log.contains("\"hit\""), "{log}");
    run(folder.path(), &["walk", "s.json", "--pixel", "12,9", "--screenshot", "s.svg", "-q"]);
    let picture = std::fs::read(folder.path().join("s.ppm")).expect("a picture");
    (picture, warnings)
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).expect("packed");
    encoder.finish().expect("packed")
}

/// The mesh is seen as the other one, plain and packed, and these are the warnings, without the file's name.
#[track_caller]
fn is_seen_as(name: &str, bytes: &[u8], expected: &str, warnings: &[&str]) {
    let expected = seen("expected.obj", expected.as_bytes()).0;
    let plain = (name.to_owned(), bytes.to_vec());
    let packed = [(format!("{name}.gz"), gzip(bytes)), (format!("{name}.zst"), zstd(bytes))];
    for (name, bytes) in [plain].into_iter().chain(packed) {
        let (picture, said) = seen(&name, &bytes);
        assert_eq!(picture, expected, "{name}");
        let found: Vec<_> = said.lines().filter(|line| line.starts_with("warning: ")).collect();
        let expected: Vec<_> = warnings.iter().map(|warning| format!("warning: {name}:{warning}")).collect();
        assert_eq!(found, expected, "{said}");
    }
}

fn zstd(bytes: &[u8]) -> Vec<u8> {
    compress_to_vec(bytes, CompressionLevel::Fastest)
}

const LEFT_OUT: &str = " the normals are left out, because some corners have none:";

#[test]
fn every_mesh_of_the_collection_is_read() {
    let Some(folder) = shared("cases/files") else { return };
    let no_number = format!("{LEFT_OUT} 1 normal is no number");
    let short = " 2 faces have fewer than 3 corners, such are left out";
    let cases: [(&str, &str, &[&str]); 14] = [
        ("strip.ply", QUAD, &[]),
        ("rs.ply", QUAD, &[]),
        ("extra.ply", QUAD, &["10:7: 6 lines have more values than the header says, such are left out"]),
        ("ind.ply", QUAD, &[&no_number]),
        ("nan.ply", QUAD, &[&no_number]),
        ("qnan.ply", QUAD, &[]),
        ("n0.obj", TRIANGLE, &[&format!("{LEFT_OUT} 1 corner names a normal that isn't there")]),
        (
            "nonormals.obj",
            TRIANGLE,
            &[
                &format!("{LEFT_OUT} 3 corners name normals that aren't there"),
                " 3 corners name texture coordinates that the file doesn't have, which counts as none",
            ],
        ),
        ("short.obj", TRIANGLE, &[short]),
        ("short.ply", QUAD, &[short]),
        ("bsspace.obj", TRIANGLE, &[]),
        ("vt.obj", TRIANGLE, &[]),
        ("hash.obj", TRIANGLE, &[]),
        ("ctrlz.obj", TRIANGLE, &[]),
    ];
    for (name, expected, warnings) in cases {
        let bytes = std::fs::read(folder.join(name)).expect("a mesh");
        is_seen_as(name, &bytes, expected, warnings);
    }
    let packed = std::fs::read(folder.join("ok.obj.zst")).expect("a mesh");
    assert_eq!(seen("ok.obj.zst", &packed), seen("expected.obj", TRIANGLE.as_bytes()));
}

/// A PLY file of the quad with normals and a property that nobody uses, in this encoding.
fn ply(format: &str, vertices: &[[f32; 7]; 4], element: &str, lists: &[&[i32]]) -> Vec<u8> {
    let floats: String =
        ["x", "y", "z", "nx", "ny", "nz", "quality"].map(|name| format!("property float {name}\n")).concat();
    let list = format!("element {element} {}\nproperty list uchar int vertex_indices\n", lists.len());
    let mut bytes = format!("ply\nformat {format} 1.0\nelement vertex 4\n{floats}{list}end_header\n").into_bytes();
    let is_big = format.contains("big");
    let mut put = |text: String, mut value: Vec<u8>| {
        if format == "ascii" {
            bytes.extend(text.bytes().chain([b'\n']));
        } else {
            if is_big {
                value.reverse();
            }
            bytes.extend(value);
        }
    };
    for value in vertices.iter().flatten() {
        put(value.to_string(), value.to_le_bytes().to_vec());
    }
    for list in lists {
        put(list.len().to_string(), vec![list.len() as u8]);
        for index in *list {
            put(index.to_string(), index.to_le_bytes().to_vec());
        }
    }
    bytes
}

const FORMATS: [&str; 3] = ["ascii", "binary_little_endian", "binary_big_endian"];

fn vertices(normal: f32, unused: f32) -> [[f32; 7]; 4] {
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| [x, y, 0.0, 0.0, normal, 1.0, unused])
}

#[test]
fn every_kind_of_ply_is_the_same_in_every_encoding() {
    let faces: [&[i32]; 2] = [&[0, 1, 2], &[0, 2, 3]];
    for format in FORMATS {
        for none in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            is_seen_as("m.ply", &ply(format, &vertices(0.0, none), "face", &faces), QUAD, &[]);
        }
        let bytes = ply(format, &vertices(f32::NAN, 1.0), "face", &faces);
        is_seen_as("m.ply", &bytes, QUAD, &[&format!("{LEFT_OUT} 4 normals are no number")]);
        let strips: [&[i32]; 1] = [&[0, 1, 3, 2, -1, 1]];
        let one = " 1 face has fewer than 3 corners, such are left out";
        is_seen_as("m.ply", &ply(format, &vertices(0.0, 1.0), "tristrips", &strips), QUAD, &[one]);
        let short: [&[i32]; 4] = [&[], &[0, 1, 2], &[3, 1], &[0, 2, 3]];
        let two = " 2 faces have fewer than 3 corners, such are left out";
        is_seen_as("m.ply", &ply(format, &vertices(0.0, 1.0), "face", &short), QUAD, &[two]);
    }
}

/// A mesh is refused with this message, which begins behind the file's name.
#[track_caller]
fn refuses(name: &str, bytes: &[u8], expected: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join(name), bytes).expect("written");
    std::fs::write(folder.path().join("s.json"), scene(name)).expect("written");
    for arguments in [&["scene", "check", "s.json"][..], &["render", "s.json", "-o", "s.png"]] {
        let output = raywalk(arguments).current_dir(folder.path()).output().expect("it runs");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.starts_with(&format!("error: {name}:{expected}")), "{message}");
    }
}

#[test]
fn what_is_wrong_with_a_position_is_refused_in_every_encoding() {
    let faces: [&[i32]; 2] = [&[0, 1, 2], &[0, 2, 3]];
    let mut bad = vertices(0.0, 1.0);
    bad[1][0] = f32::NAN;
    // Its place is a line, or a byte.
    let at = |format: &str, line: &str| if format == "ascii" { format!("{line}:") } else { String::new() };
    for format in FORMATS {
        let expected = format!("{} vertex 1: expected a finite `x`, found NaN", at(format, "21:1"));
        refuses("m.ply", &ply(format, &bad, "face", &faces), &expected);
        let expected = format!("{} face 0: there is no vertex 4", at(format, "44:1"));
        refuses("m.ply", &ply(format, &vertices(0.0, 1.0), "face", &[&[0, 4]]), &expected);
    }
}

const VIEW: &str =
    "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 5 5\nl 1 2 9\nf 1 1 1 1 0 1 0 1\n";

/// What `scene convert` makes of an NFF file, packed in every way, and what it says.
#[track_caller]
fn converted(text: &str) -> (String, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let forms = [
        ("a.nff", text.as_bytes().to_vec()),
        ("a.nff.gz", gzip(text.as_bytes())),
        ("a.nff.zst", zstd(text.as_bytes())),
    ];
    let answers = forms.map(|(name, bytes)| {
        std::fs::write(folder.path().join(name), bytes).expect("written");
        let (json, said) = run(folder.path(), &["scene", "convert", name]);
        run(folder.path(), &["scene", "check", name]);
        (json, said.replace(name, "a.nff"))
    });
    let [plain, gz, zst] = answers;
    assert_eq!(gz, plain);
    assert_eq!(zst, plain);
    plain
}

#[test]
fn words_of_a_dialect_of_nff_are_passed_over_with_one_warning() {
    let (json, said) =
        converted(&format!("{VIEW}number 2\ng -1 1 -1 1 0 1\ns 0 0 0 1\ng 0 1 0 1 0 1.#INF\ns 1 0 0 1\n\u{1a}"));
    assert_eq!(json, converted(&format!("{VIEW}s 0 0 0 1\ns 1 0 0 1\n")).0);
    let warnings: Vec<_> = said.lines().filter(|line| line.contains("warning")).collect();
    let expected =
        "warning: a.nff:10:1: `number` and `g` count and bound what follows, and are ignored (3 times in this file)";
    assert_eq!(warnings, [expected], "{said}");
    let Some(folder) = shared("cases/files") else { return };
    let (_, said) = run(&folder, &["scene", "convert", "dialect.nff"]);
    assert_eq!(said.matches("warning").count(), 1, "{said}");
}

#[test]
fn a_normal_of_nff_that_is_no_number_counts_as_none() {
    let patch = "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1.#IND\n0 1 0 0 0 1\n";
    let (json, said) = converted(&format!("{VIEW}{patch}{patch}"));
    let plain = "p 3\n0 0 0\n1 0 0\n0 1 0\n";
    assert_eq!(json, converted(&format!("{VIEW}{plain}{plain}")).0);
    let expected =
        "a normal that is no number counts as none, its polygon is taken without normals (2 times in this file)";
    assert!(said.contains(expected), "{said}");
}

#[test]
fn a_number_that_is_none_is_refused_where_it_stands() {
    let folder = tempfile::tempdir().expect("a folder");
    for number in ["1.#INF", "-1.#IND", "1.#QNAN", "1.#J", "nan(ind)", "-inf"] {
        for (before, at, of) in [
            ("s 0 0 0 ", 9, "the radius of `s`"),
            ("p 3 0 0 0 ", 11, "a corner of `p`"),
            ("l 1 2 ", 7, "the position of `l`"),
        ] {
            std::fs::write(folder.path().join("a.nff"), format!("{VIEW}{before}{number}\n")).expect("written");
            let output = raywalk(&["scene", "check", "a.nff"]).current_dir(folder.path()).output().expect("it runs");
            let message = String::from_utf8_lossy(&output.stderr);
            let expected = format!("error: a.nff:10:{at}: expected a number for {of}, found `{number}`\n");
            assert!(output.status.code() == Some(2) && message.starts_with(&expected), "{message}");
        }
    }
    let Some(shared) = shared("cases/files") else { return };
    let output = raywalk(&["trace", "msvc.nff", "--pixel", "2,2"]).current_dir(shared).output().expect("it runs");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && message.starts_with("error: msvc.nff:10:9: "), "{message}");
}

/// A scene with two balls of these names, packed in every way, whose names are shown as they are.
#[track_caller]
fn shows_names(names: [&str; 2]) {
    let ball = |name: &str| {
        format!("{{\"name\": \"{name}\", \"shape\": {{\"sphere\": {{\"center\": [0, 0, -3], \"radius\": 1}}}}}}")
    };
    let text = format!(
        "{{\"format\": \"raywalk-scene/1\",\n \"camera\": {{\"position\": [0, 0, 6], \"direction\": [0, 0, -1], \"resolution\": [3, 3]}},\n \
         \"objects\": [{}]}}\n",
        names.map(ball).join(", ")
    );
    let folder = tempfile::tempdir().expect("a folder");
    for (name, bytes) in [
        ("s.json", text.as_bytes().to_vec()),
        ("s.json.gz", gzip(text.as_bytes())),
        ("s.json.zst", zstd(text.as_bytes())),
    ] {
        std::fs::write(folder.path().join(name), bytes).expect("written");
        run(folder.path(), &["scene", "check", name]);
        let shown = run(folder.path(), &["scene", "show", name]).0;
        let log = run(folder.path(), &["trace", name, "--pixel", "1,1", "-o", "a.ndjson.zst"]);
        assert_eq!(log.0, "");
        let text = run(folder.path(), &["trace", "a.ndjson.zst", "--format", "text"]).0;
        run(folder.path(), &["walk", "a.ndjson.zst", "--screen", "100,30", "--screenshot", "s.svg", "-q"]);
        let screen = std::fs::read_to_string(folder.path().join("s.svg")).expect("a picture");
        for name in names {
            assert!([&shown, &text, &screen].iter().all(|text| text.contains(name)), "{name:?}:\n{text}\n{screen}");
        }
    }
}

#[test]
fn names_with_joiners_are_read_and_shown() {
    shows_names(["کره‌ی قرمز", "क्‍ष गोला"]);
    shows_names(["ന്‍", "👩‍🔬"]);
    let Some(folder) = shared("cases/files") else { return };
    for (scene, name) in [("persian.json", "کره‌ی قرمز"), ("hindi.json", "क्‍ष गोला")] {
        run(&folder, &["scene", "check", scene]);
        assert!(run(&folder, &["trace", scene, "--pixel", "5,3", "--format", "text"]).0.contains(name));
    }
}

#[test]
fn joiners_elsewhere_and_marks_that_turn_the_writing_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let marks =
        ["ba\u{200d}ll", "\u{200c}ی", "ی\u{202e}ی", "ی\u{61c}ی", "क\u{200d}\u{200d}", "ی\u{2066}", "ball\u{200d}"];
    for name in marks {
        let text = format!(
            "{{\"format\": \"raywalk-scene/1\", \"camera\": {{\"position\": [0, 0, 6], \"direction\": [0, 0, -1]}},\n \"objects\": \
             [{{\"name\": \"{name}\", \"shape\": {{\"sphere\": {{\"center\": [0, 0, 0], \"radius\": 1}}}}}}]}}"
        );
        std::fs::write(folder.path().join("s.json"), text).expect("written");
        let output = raywalk(&["scene", "check", "s.json"]).current_dir(folder.path()).output().expect("it runs");
        let message = String::from_utf8_lossy(&output.stderr);
        let expected = "error: s.json:2:23: objects[0].name: a name must not hold invisible characters, found \\u{";
        assert!(output.status.code() == Some(2) && message.starts_with(expected), "{name:?}: {message}");
    }
}
