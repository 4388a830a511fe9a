//! PLY: the three encodings of one mesh, and what may be wrong with each.

use glam::DVec3;

use super::{reads, refuses, warns};

const HEADER: &str = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty double x\nproperty double y\n\
                      property double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
const BODY: &str = "0 0 0\n1 0 0\n1 1 0\n0 1.5 0\n3 0 1 2\n3 0 2 3\n";

/// The header of [`records`].
const RICH_HEADER: &str = "obj_info made by a test\r\nelement vertex 5\r\nproperty float x\r\nproperty double y\r\n\
    property float32 z\r\nproperty uint8 flags\r\nproperty float nx\r\nproperty float ny\r\nproperty float nz\r\n\
    element edge 2\r\nproperty list int ushort ends\r\nelement face 2\r\nproperty float64 quality\r\n\
    property list uchar int16 vertex_index\r\nend_header\r\n";

#[derive(Clone, Copy)]
enum Value {
    U8(u8),
    I16(i16),
    U16(u16),
    I32(i32),
    F32(f32),
    F64(f64),
}

/// A mesh of a square and a triangle with normals, and elements that are skipped.
fn records() -> Vec<Vec<Value>> {
    use Value::{F32, F64, I16, I32, U8, U16};
    let vertex = |x, y, z, flags| vec![F32(x), F64(y), F32(z), U8(flags), F32(0.0), F32(0.0), F32(1.0)];
    vec![
        vertex(0.1, 0.1, 0.0, 10),
        vertex(1.0, 0.0, -0.0, 13),
        vertex(1.0, 1.0, 0.0, 255),
        vertex(0.0, 1e-300, 0.0, 0),
        vertex(2.5, 3.0, 1e-3, 1),
        vec![I32(2), U16(7), U16(7)],
        vec![I32(0)],
        vec![F64(-1.0), U8(4), I16(0), I16(1), I16(2), I16(3)],
        vec![F64(0.5), U8(3), I16(1), I16(4), I16(2)],
    ]
}

impl Value {
    fn text(self) -> String {
        match self {
            Value::U8(value) => value.to_string(),
            Value::I16(value) => value.to_string(),
            Value::U16(value) => value.to_string(),
            Value::I32(value) => value.to_string(),
            Value::F32(value) => value.to_string(),
            Value::F64(value) => value.to_string(),
        }
    }

    fn little(self) -> Vec<u8> {
        match self {
            Value::U8(value) => value.to_le_bytes().to_vec(),
            Value::I16(value) => value.to_le_bytes().to_vec(),
            Value::U16(value) => value.to_le_bytes().to_vec(),
            Value::I32(value) => value.to_le_bytes().to_vec(),
            Value::F32(value) => value.to_le_bytes().to_vec(),
            Value::F64(value) => value.to_le_bytes().to_vec(),
        }
    }

    fn big(self) -> Vec<u8> {
        self.little().into_iter().rev().collect()
    }
}

pub(super) fn ascii() -> Vec<u8> {
    let line = |record: &Vec<Value>| record.iter().map(|value| value.text()).collect::<Vec<_>>().join(" ") + "\r\n";
    let body: String = records().iter().map(line).collect();
    format!("ply\r\nformat ascii 1.0\r\n{RICH_HEADER}{body}").into_bytes()
}

pub(super) fn little() -> Vec<u8> {
    let mut bytes = format!("ply\r\nformat binary_little_endian 1.0\r\n{RICH_HEADER}").into_bytes();
    bytes.extend(records().into_iter().flatten().flat_map(Value::little));
    bytes
}

pub(super) fn big() -> Vec<u8> {
    let mut bytes = format!("ply\r\nformat binary_big_endian 1.0\r\n{RICH_HEADER}").into_bytes();
    bytes.extend(records().into_iter().flatten().flat_map(Value::big));
    bytes
}

#[track_caller]
fn wrong_body(old: &str, new: &str, expected: &str) {
    assert!(BODY.contains(old));
    refuses(format!("{HEADER}{}", BODY.replacen(old, new, 1)), "a.ply", expected);
}

#[track_caller]
fn wrong_header(old: &str, new: &str, expected: &str) {
    assert!(HEADER.contains(old));
    refuses(format!("{}{BODY}", HEADER.replacen(old, new, 1)), "a.ply", expected);
}

#[test]
fn all_encodings_are_the_same_mesh() {
    let mesh = reads(ascii(), "a.ply").mesh;
    assert_eq!(mesh.positions[0], DVec3::new(f64::from(0.1_f32), 0.1, 0.0));
    assert_eq!(mesh.positions[3].y, 1e-300);
    assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3], [1, 4, 2]]);
    assert_eq!(mesh.corner_normals(2), Some([DVec3::Z; 3]));
    assert_eq!(reads(little(), "a.ply").mesh, mesh);
    assert_eq!(reads(big(), "a.ply").mesh, mesh);
}

#[test]
fn what_it_says_counts_more_than_its_name() {
    assert_eq!(reads(little(), "a.obj").mesh, reads(little(), "a").mesh);
    refuses(super::SQUARE, "a.ply", "1:1: expected a PLY file, whose first line is `ply`");
}

#[test]
fn empty_lines_and_a_missing_end_are_fine() {
    let body = BODY.replace("\n3", "\n\n \n3");
    assert_eq!(reads(format!("{HEADER}{}", body.trim_end()), "a.ply").mesh.faces.len(), 2);
}

#[test]
fn degenerate_triangles_keep_their_numbers() {
    let text = format!("{HEADER}{}", BODY.replace("3 0 1 2", "3 0 1 1"));
    assert_eq!(reads(&text, "a.ply").mesh.faces, [[0, 1, 1], [0, 2, 3]]);
    warns(text, "a.ply", &["warning: a.ply: 1 of 2 triangles has no area and is skipped"]);
}

#[test]
fn numbers_of_the_body() {
    wrong_body("1.5", "nan", "14:3: vertex 3: expected a finite `y`, found NaN");
    wrong_body("1.5", "x", "14:3: vertex 3: expected a number, found `x`");
    wrong_body("0 1.5 0", "0 1.5", "14:6: vertex 3: the line ends too early, expected a number");
    wrong_body("3 0 1 2", "3 0 1 4", "15:7: face 0: there is no vertex 4, the file has 4, counted from 0");
    wrong_body("3 0 1 2", "3 0 1 -1", "15:7: face 0: there is no vertex -1, the file has 4, counted from 0");
    wrong_body("3 0 1 2", "-3 0 1", "15:1: face 0: expected a whole number from 0 to 255, found `-3`");
    wrong_body(
        "3 0 1 2",
        "3 0 1 1.5",
        "15:7: face 0: expected a whole number from -2147483648 to 2147483647, found `1.5`",
    );
}

#[test]
fn counts_of_the_header_are_not_believed() {
    wrong_header(
        "vertex 4",
        "vertex 4000000000000",
        "4:1: the header promises 4000000000000 of `vertex`, the file has room for 7 at most",
    );
    wrong_header("vertex 4", "vertex 5", "17:1: face 1: the line ends too early, expected a number");
    wrong_header("vertex 4", "vertex -4", "4:16: expected the number of records, found `-4`");
    wrong_header("face 2", "face 0", "8:1: the file has no faces, expected at least one");
    let nothing = "element nothing 18446744073709551615\nelement face 2";
    assert_eq!(reads(format!("{}{BODY}", HEADER.replace("element face 2", nothing)), "a.ply").mesh.faces.len(), 2);
}

#[test]
fn headers() {
    wrong_header("ply\n", "plx\n", "1:1: expected a PLY file, whose first line is `ply`");
    let encodings = "expected `ascii`, `binary_little_endian` or `binary_big_endian`";
    wrong_header("ascii", "utf8", &format!("2:8: {encodings}, found `utf8`"));
    wrong_header("1.0", "2.0", "2:14: expected the version `1.0`, found `2.0`");
    wrong_header("format ascii 1.0\n", "", "1:1: the header has no `format`, expected such as `format ascii 1.0`");
    wrong_header(
        "double x",
        "duoble x",
        "5:10: unknown type `duoble`, did you mean `double`? expected `char`, `uchar`, `short`, `ushort`, `int`, `uint`, `float`, \
         `double`, `int8`, `uint8`, `int16`, `uint16`, `int32`, `uint32`, `float32` or `float64`",
    );
    wrong_header("double x", "double", "5:16: the line ends too early, expected the name of a property");
    wrong_header("double x", "double u", "4:1: expected the properties `x`, `y` and `z` of the element `vertex`");
    wrong_header("double y", "double x", "6:1: the property `x` occurs twice, expected it once");
    wrong_header("double x", "list uchar double x", "5:1: expected `x` to be a number");
    wrong_header("uchar int", "uchar float", "9:1: expected `vertex_indices` to be a list of whole numbers");
    wrong_header("list uchar int", "list float int", "9:15: expected a count of whole numbers");
    wrong_header("list uchar int", "int", "9:1: expected `vertex_indices` to be a list of whole numbers");
    wrong_header(
        "vertex_indices",
        "strip",
        "8:1: expected the property `list uchar int vertex_indices` of the element `face`",
    );
    wrong_header(
        "element face",
        "element strip",
        "1:1: the file has no faces, expected an element `face` or `tristrips` in its header",
    );
    wrong_header("element face", "element vertex", "8:1: the element `vertex` occurs twice, expected it once");
    wrong_header("element vertex 4\n", "", "4:1: expected an `element` before its properties");
    refuses(&HEADER[..37], "a.ply", "4:1: the header ends too early, expected `end_header`");
    refuses(HEADER.trim_end(), "a.ply", "10:11: the file ends with its header");
    wrong_header(
        "comment by hand",
        "\u{1b}[2J",
        "3:1: expected `format`, `comment`, `element`, `property` or `end_header`, found `\\u{1b}[2J`",
    );
}

#[test]
fn binary_files_end_too_early() {
    let bytes = little();
    let header = bytes.len() - records().into_iter().flatten().flat_map(Value::little).count();
    refuses(&bytes[..header + 40], "a.ply", "4:1: the header promises 5 of `vertex`, the file has room for 1 at most");
    let end = bytes.len() - 1;
    let expected = format!(" face 1: the file ends too early (at byte {})", end - 1);
    refuses(&bytes[..end], "a.ply", &expected);
}

#[test]
fn binary_files_name_what_is_not_there() {
    let mut bytes = little();
    let last = bytes.len() - 2;
    bytes[last] = 5;
    let expected = format!(" face 1: there is no vertex 5, the file has 5, counted from 0 (at byte {last})");
    refuses(bytes, "a.ply", &expected);
}

/// The square of [`HEADER`] with these lines for its body.
#[track_caller]
fn square_of(body: &str, warnings: &[&str]) {
    let text = format!("{HEADER}{body}");
    assert_eq!(reads(&text, "a.ply").mesh, reads(format!("{HEADER}{BODY}"), "a.ply").mesh, "{body}");
    warns(text, "a.ply", warnings);
}

#[test]
fn a_text_is_read_by_its_values() {
    for body in [
        "0 0\n0 1 0\n0 1 1 0 0 1.5\n0 3 0 1 2 3\n0 2 3",
        "0 0 0 1 0 0 1 1 0 0 1.5 0 3 0 1 2 3 0 2 3\n",
        "0 \n0 \n0 \n\n1 0\n0\n1\n1 0\n0 1.5\n0\n3\n0 1 2\n3 0 2 3\n",
        "0 0 0\n1 0 0\n1 1 0\n0 1.5 0\n3\n0 1 2\n3 0 2 3\n\u{1a}",
    ] {
        square_of(body, &[]);
    }
}

#[test]
fn what_a_line_has_more_is_left_out() {
    let warning = |place: &str, lines: &str| {
        format!("warning: a.ply:{place}: {lines} more values than the header says, such are left out")
    };
    let all = BODY.replace('\n', " 255 0.5 x\n");
    square_of(&all, &[&warning("11:7", "6 lines have")]);
    square_of(&BODY.replace("0 1.5 0", "0 1.5 0 0"), &[&warning("14:9", "1 line has")]);
    square_of(&BODY.replace("3 0 2 3", "3 0 2 3 1"), &[&warning("16:9", "1 line has")]);
    // As many more as would be another vertex.
    square_of(&BODY.replacen("\n1", " 1 1 1\n1", 2), &[&warning("11:7", "2 lines have")]);
    // A record on two lines, the second of which has more, lacks a value or has one too many: nobody knows.
    wrong_body("0 1.5 0", "0\n1.5 0 0", "14:2: vertex 3: the line ends too early, expected a number");
}

#[test]
fn what_nobody_uses_may_be_no_number() {
    let header =
        HEADER.replace("property double z\n", "property double z\nproperty uchar red\nproperty float quality\n");
    for unused in ["255 nan", "0.5 -nan(ind)", "300 -1.#IND", "-1 1.#QNAN0", "nan inf"] {
        let body = BODY.replace(" 0\n1 0 0", &format!(" 0 {unused}\n1 0 0")).replacen("1 0 0\n", "1 0 0 1 1\n", 1);
        let body = body.replace("1 1 0\n", "1 1 0 1 1\n").replace("1.5 0\n", "1.5 0 1 1\n");
        assert_eq!(reads(format!("{header}{body}"), "a.ply").mesh.faces.len(), 2, "{unused}");
        warns(format!("{header}{body}"), "a.ply", &[]);
    }
    wrong_body("1.5", "-1.#IND", "14:3: vertex 3: expected a finite `y`, found NaN");
    wrong_body("1.5", "-nan(ind)", "14:3: vertex 3: expected a finite `y`, found NaN");
    wrong_body(
        "3 0 1 2",
        "3 0 1 nan",
        "15:7: face 0: expected a whole number from -2147483648 to 2147483647, found `nan`",
    );
}

#[test]
fn normals_that_are_no_numbers_count_as_none() {
    let with = |none: [f32; 3], header: &str| {
        let mut records = records();
        for (value, none) in records[1][4..].iter_mut().zip(none) {
            *value = Value::F32(none);
        }
        let little = |value: Value| if header.contains("big") { value.big() } else { value.little() };
        let mut bytes = format!("ply\r\nformat {header} 1.0\r\n{RICH_HEADER}").into_bytes();
        match header {
            "ascii" => bytes.extend(
                String::from_utf8(ascii())
                    .unwrap()
                    .split_once("end_header\r\n")
                    .unwrap()
                    .1
                    .replace("13 0 0 1", "13 -1.#IND 0 1")
                    .bytes(),
            ),
            _ => bytes.extend(records.into_iter().flatten().flat_map(little)),
        }
        bytes
    };
    for none in [[f32::NAN; 3], [0.0, f32::INFINITY, 0.0], [0.0, 0.0, f32::NEG_INFINITY]] {
        for header in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let bytes = with(none, header);
            let mesh = reads(&bytes, "a.ply").mesh;
            assert_eq!((mesh.faces.len(), mesh.normals), (3, None), "{header}");
            let why = "the normals are left out, because some corners have none: 1 normal is no number";
            warns(&bytes, "a.ply", &[&format!("warning: a.ply: {why}")]);
        }
    }
}

#[test]
fn strips() {
    let header =
        HEADER.replace("element face 2\nproperty list uchar int", "element tristrips 1\nproperty list int int");
    let vertices = &BODY[..BODY.find("3 0").unwrap()];
    let strip = |list: &str| format!("{header}{vertices}{list}\n");
    #[track_caller]
    fn gives(text: String, faces: &[[u32; 3]], warnings: &[&str]) {
        assert_eq!(reads(&text, "a.ply").mesh.faces, faces);
        warns(text, "a.ply", warnings);
    }
    gives(strip("5 0 1 3 2 -1"), &[[0, 1, 3], [3, 1, 2]], &[]);
    gives(strip("4 0 1 3 2"), &[[0, 1, 3], [3, 1, 2]], &[]);
    gives(strip("9 -1 0 1 3 -1 -1 1 2 3"), &[[0, 1, 3], [1, 2, 3]], &[]);
    // Repeated corners lead on, and count for which way round the next triangle goes.
    gives(strip("6 0 1 2 2 3 0"), &[[0, 1, 2], [3, 2, 0]], &[]);
    let short = "warning: a.ply: 1 face has fewer than 3 corners, such are left out";
    gives(strip("5 0 1 2 -1 3"), &[[0, 1, 2]], &[short]);
    refuses(strip("5 0 1 2 -1 4"), "a.ply", "15:12: tristrips 0: there is no vertex 4, the file has 4, counted from 0");
    refuses(strip("4 0 1 2 -2"), "a.ply", "15:9: tristrips 0: there is no vertex -2, the file has 4, counted from 0");
    refuses(strip("2 0 1"), "a.ply", "15:1: expected a face of 3 corners or more, found 2");
    refuses(strip("3 0 1 1"), "a.ply", "8:1: the file has no faces, expected at least one");
    // Without signs -1 is the largest number.
    let header = header.replace("ascii", "binary_big_endian").replace("int int", "uchar uint");
    let mut bytes = header.into_bytes();
    bytes.extend(
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.5, 0.0]]
            .iter()
            .flatten()
            .flat_map(|x: &f64| x.to_be_bytes()),
    );
    bytes.push(7);
    bytes.extend([0, 1, 3, u32::MAX, 1, 2, 3].iter().flat_map(|index| index.to_be_bytes()));
    assert_eq!(reads(bytes, "a.ply").mesh.faces, [[0, 1, 3], [1, 2, 3]]);
}

#[test]
fn faces_of_too_few_corners_are_left_out() {
    let short = HEADER.replace("face 2", "face 4");
    for body in [BODY.replace("3 0 1 2", "2 0 1\n3 0 1 2\n0"), BODY.replace("3 0 1 2\n", "1 3\n3 0 1 2\n2 1 1\n")] {
        let text = format!("{short}{body}");
        assert_eq!(reads(&text, "a.ply").mesh.faces, [[0, 1, 2], [0, 2, 3]]);
        warns(text, "a.ply", &["warning: a.ply: 2 faces have fewer than 3 corners, such are left out"]);
    }
    let body = BODY.replace("3 0 1 2", "2 0 1").replace("3 0 2 3", "0");
    refuses(format!("{HEADER}{body}"), "a.ply", "15:1: expected a face of 3 corners or more, found 2");
    wrong_body("3 0 1 2", "1 4", "15:3: face 0: there is no vertex 4, the file has 4, counted from 0");
}
