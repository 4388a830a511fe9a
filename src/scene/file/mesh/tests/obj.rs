//! OBJ, with the catalogue of bad inputs, o01 to o12.

use glam::DVec3;

use super::{SQUARE, reads, refuses, warns};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[track_caller]
fn faces(text: &str, expected: &[[u32; 3]]) {
    assert_eq!(reads(text, "a.obj").mesh.faces, expected);
}

#[track_caller]
fn wrong(statement: &str, expected: &str) {
    refuses(format!("{TRIANGLE}{statement}\n"), "a.obj", expected);
}

#[test]
fn a_square() {
    let mesh = reads(SQUARE, "square.obj").mesh;
    assert_eq!(mesh.positions, [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y]);
    assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(mesh.normals, None);
}

#[test]
fn coordinates_are_double_precision() {
    let mesh = reads("v 0.1 1e-300 -1.0000000000000002\nv 1 0 0\nv 0 1 0\nf 1 2 3", "a.obj").mesh;
    assert_eq!(mesh.positions[0].to_array(), [0.1, 1e-300, -1.0000000000000002]);
}

#[test]
fn faces_of_many_corners_are_fans() {
    let pentagon = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\nf 3 4 5\n";
    faces(pentagon, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [2, 3, 4]]);
}

#[test]
fn weights_and_colours_of_vertices_are_skipped() {
    let mesh = reads("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 1 1 1 1\nf 1 2 3\n", "a.obj").mesh;
    assert_eq!(mesh.positions, [DVec3::ZERO, DVec3::X, DVec3::Y]);
}

#[test]
fn faces_may_come_first() {
    faces(&format!("f 1 2 3\n{TRIANGLE}"), &[[0, 1, 2]]);
}

#[test]
fn normals_are_taken_when_all_corners_have_one() {
    let text = format!("{TRIANGLE}vn 0 0 1\nvn 0 1 1\nf 1//1 2//2 3//-1\n");
    let mesh = reads(text, "a.obj").mesh;
    let normals = mesh.corner_normals(0).unwrap();
    assert_eq!(normals, [DVec3::Z, DVec3::new(0.0, 1.0, 1.0), DVec3::new(0.0, 1.0, 1.0)]);
}

#[test]
fn some_normals_are_left_out() {
    let text = format!("{TRIANGLE}vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 2//1 3\nf 1//1 3//1 2//1\n");
    assert_eq!(reads(&text, "a.obj").mesh.normals, None);
    warns(&text, "a.obj", &["warning: a.obj: the normals are left out, because some corners have none"]);
}

#[test]
fn normals_that_are_not_there_count_as_none() {
    let left_out = "warning: a.obj: the normals are left out, because some corners have none";
    let normal = format!("{TRIANGLE}vn 0 0 1\n");
    for (corners, lost) in [
        ("1//1 2//1 3//0", "1 corner names a normal that isn't there"),
        ("1//1 2//2 3//-2", "2 corners name normals that aren't there"),
        ("1//99999999999999999999 2//4294967298 3//1", "2 corners name normals that aren't there"),
    ] {
        let text = format!("{normal}f {corners}\n");
        faces(&text, &[[0, 1, 2]]);
        assert_eq!(reads(&text, "a.obj").mesh.normals, None);
        warns(&text, "a.obj", &[&format!("{left_out}: {lost}")]);
    }
    // One that comes later is there.
    assert!(reads(format!("{TRIANGLE}f 1//1 2//1 3//1\nvn 0 0 1\n"), "a.obj").mesh.normals.is_some());
    let textures =
        "warning: a.obj: 2 corners name texture coordinates that the file doesn't have, which counts as none";
    warns(format!("{TRIANGLE}vt 0 0\nf 1/1 2/2 3/0\n"), "a.obj", &[textures]);
}

#[test]
fn normals_that_are_no_numbers_count_as_none() {
    for none in ["nan nan nan", "0 0 -1.#IND", "1.#QNAN00 0 0 # c", "-nan(ind) 0 0", "inf 0 0", "1e999 0 0", "0 1.#J 0"]
    {
        let text = format!("{TRIANGLE}vn 0 0 1\nvn {none}\nf 1//1 2//1 3//2\n");
        assert_eq!(reads(&text, "a.obj").mesh.normals, None, "{none}");
        let why = "the normals are left out, because some corners have none: 1 normal is no number";
        warns(&text, "a.obj", &[&format!("warning: a.obj: {why}")]);
        // One that no corner has is no harm.
        let text = format!("{TRIANGLE}vn 0 0 1\nvn {none}\nf 1//1 2//1 3//1\n");
        assert_eq!(reads(&text, "a.obj").mesh.corner_normals(0), Some([DVec3::Z; 3]));
        warns(&text, "a.obj", &["warning: a.obj: 1 normal is no number, which counts as none"]);
    }
}

#[test]
fn faces_of_too_few_corners_are_left_out() {
    let text = format!("{TRIANGLE}f 1\nf\nf 1 2 3\nf 3//7 2\np 1\nl 1 2\npoints 1 2\n");
    faces(&text, &[[0, 1, 2]]);
    warns(
        &text,
        "a.obj",
        &[
            "warning: a.obj: 3 faces have fewer than 3 corners, such are left out",
            "warning: a.obj: 1 corner names a normal that isn't there, which counts as none",
        ],
    );
    warns(
        format!("{TRIANGLE}f 1 2 3\nf 1 2\n"),
        "a.obj",
        &["warning: a.obj: 1 face has fewer than 3 corners, such are left out"],
    );
    wrong("f 1 2 3\nf 1 9", "5:5: there is no vertex 9, the file has 3 vertices");
    wrong("p 1\nl 1 2", "1:1: the file has no faces, expected at least one such as `f 1 2 3`");
}

#[test]
fn lines_and_blanks_as_other_programs_write_them() {
    for (old, new) in [
        ("f 1 2 3", "f 1 2 \\ \t\n3"),
        ("f 1 2 3", "f 1 \\\r\n2 3 \\ "),
        ("v 1 0 0", "v\x0b1\x0c0 0\x0b"),
        ("v 1 0 0", "v 1 0 0.0#c"),
        ("f 1 2 3", "f 1 2 3# c"),
        ("f 1 2 3", "f 1 2 3\x1a"),
        ("f 1 2 3", "f 1 2 3\r\n\x1a\r\n"),
    ] {
        let text = format!("{TRIANGLE}f 1 2 3").replace(old, new);
        faces(&text, &[[0, 1, 2]]);
        warns(&text, "a.obj", &[]);
    }
}

#[test]
fn what_else_there_is_is_skipped() {
    let text = "# by hand\nmtllib a.mtl\no thing\ng one two\ns off\nusemtl red\nvt 0 0\nl 1 2\ncurv 0 1 \\\n 1 2 3\n";
    faces(&format!("{text}{TRIANGLE}f 1/1 2/1 3/1 # end"), &[[0, 1, 2]]);
    warns(format!("{text}{TRIANGLE}f 1 2 3"), "a.obj", &[]);
}

#[test]
fn unknown_words_are_somebodys_extension() {
    let expected = "warning: a.obj:4:1: unknown statement `sparkle`, such are skipped";
    warns(format!("{TRIANGLE}sparkle 3\nglow 4\nf 1 2 3"), "a.obj", &[expected]);
}

#[test]
fn o01_index_zero() {
    wrong("f 0 1 2", "4:3: there is no vertex 0, they count from 1");
}

#[test]
fn o02_index_high() {
    wrong("f 1 2 99", "4:7: there is no vertex 99, the file has 3 vertices");
    refuses("v 0 0 0\nf 1 1 2\n", "a.obj", "2:7: there is no vertex 2, the file has one vertex");
}

#[test]
fn o03_index_negative() {
    faces(&format!("{TRIANGLE}f -3 -2 -1\nv 5 5 5\nf -1 -2 1\n"), &[[0, 1, 2], [3, 2, 0]]);
    wrong("f -1 -2 -4", "4:9: there is no vertex -4, only 3 precede it");
}

#[test]
fn o04_index_overflow() {
    wrong("f 1 2 4294967297", "4:7: there is no vertex 4294967297");
    wrong("f 1 2 -9223372036854775808", "4:7: there is no vertex -9223372036854775808, only 3 precede it");
    let corner = "expected a corner such as `1`, `1/2`, `1//3` or `1/2/3`, found";
    wrong("f 1 2 99999999999999999999", &format!("4:7: {corner} `99999999999999999999`"));
}

#[test]
fn corners_that_are_none() {
    let corner = "expected a corner such as `1`, `1/2`, `1//3` or `1/2/3`, found";
    for word in ["x", "1.5", "/", "//1", "1/2/3/4", "1/x", "1//x", "\u{1b}[2J"] {
        let shown = crate::files::escape_hidden(word);
        wrong(&format!("f 1 2 {word}"), &format!("4:7: {corner} `{shown}`"));
    }
}

#[test]
fn o05_two_vertices() {
    // Where no face is left.
    wrong("f 1 2", "4:1: expected a face of 3 corners or more, found 2");
    wrong("f", "4:1: expected a face of 3 corners or more, found 0");
}

#[test]
fn o06_nan_vertex() {
    wrong("v 0 nan 0", "4:5: expected a finite number, found `nan`");
    wrong("v inf 0 0", "4:3: expected a finite number, found `inf`");
    wrong("v 0 0 1.#INF", "4:7: expected a finite number, found `1.#INF`");
    wrong("v -nan(ind) 0 0", "4:3: expected a finite number, found `-nan(ind)`");
    wrong("vn 0 0 x", "4:8: expected a finite number, found `x`");
    wrong("v 0 0,5 0", "4:5: expected a finite number, found `0,5`");
}

#[test]
fn o07_short_vertex() {
    wrong("v 1 2", "4:1: a vertex has three coordinates, found 2");
    wrong("vn", "4:1: a normal has three coordinates, found 0");
}

#[test]
fn o08_no_faces() {
    refuses(TRIANGLE, "a.obj", "1:1: the file has no faces, expected at least one such as `f 1 2 3`");
    refuses("", "a.obj", "1:1: the file has no faces, expected at least one such as `f 1 2 3`");
}

#[test]
fn o09_degenerate() {
    let text = format!("{TRIANGLE}v 2 0 0\nf 1 1 2\nf 1 2 3\nf 1 2 4\n");
    faces(&text, &[[0, 0, 1], [0, 1, 2], [0, 1, 3]]);
    warns(&text, "a.obj", &["warning: a.obj: 2 of 3 triangles have no area and are skipped"]);
    warns(format!("{TRIANGLE}f 1 1 1"), "a.obj", &["warning: a.obj: 1 of 1 triangles has no area and is skipped"]);
}

#[test]
fn o10_long_line() {
    let corners = " 1 2 3".repeat(100_000);
    assert_eq!(reads(format!("{TRIANGLE}f{corners}\n"), "a.obj").mesh.faces.len(), 299_998);
    let junk = "9".repeat(1_000_000);
    let error = super::parse(format!("{TRIANGLE}f 1 2 {junk}").as_bytes(), "a.obj").unwrap_err();
    assert!(error.report(false).len() < 1000, "{}", error.report(false));
}

#[test]
fn o11_crlf_and_slashes() {
    let text = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\nf 1/1/1 2//1 3/1/1\r\n";
    faces(text, &[[0, 1, 2]]);
    assert!(reads(text, "a.obj").mesh.normals.is_some());
}

#[test]
fn o12_binary() {
    let bytes: Vec<u8> = (0..=255).cycle().take(4096).collect();
    let expected = "1:1: expected an OBJ statement such as `v`, `vn` or `f`, found `\\u{0}\\u{1}\\u{2}\\u{3}\\u{4}\\u{5}\\u{6}\\u{7}\\u{8}`";
    refuses(bytes, "a.obj", expected);
    refuses(
        b"\xff\xfe\x00v",
        "a.obj",
        "1:1: expected an OBJ statement such as `v`, `vn` or `f`, found `\u{fffd}\u{fffd}\\u{0}v`",
    );
}

#[test]
fn the_line_is_shown() {
    let error = super::parse(format!("{TRIANGLE}f 1 2 x\n").as_bytes(), "a.obj").unwrap_err();
    let report = error.report(false);
    assert!(report.ends_with("\n  |\n4 | f 1 2 x\n  |       ^"), "{report}");
}

#[test]
fn a_byte_order_mark_is_skipped() {
    assert_eq!(reads(format!("\u{feff}{SQUARE}"), "a.obj").mesh.faces.len(), 2);
    refuses("\u{feff}v 1 2 x\n", "a.obj", "1:8: expected a finite number, found `x`");
}
