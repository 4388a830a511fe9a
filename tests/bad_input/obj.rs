//! The rows o01 to o12: meshes that are read with what is odd about them said, or refused with their line.

use crate::meshes::folder_with_mesh;
use crate::run::{answer, raywalk};
use std::fs;

const VERTICES: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The mesh is refused, and the problem reads so, its place included.
#[track_caller]
fn refuses(mesh: impl AsRef<[u8]>, expected: &str) {
    let first = refuses_with(mesh, expected);
    assert_eq!(first, format!("error: m.obj:{expected}"));
}

/// The mesh is refused, and the problem begins so. Gives the first line of the message.
#[track_caller]
fn refuses_with(mesh: impl AsRef<[u8]>, expected: &str) -> String {
    let folder = folder_with_mesh("m.obj");
    fs::write(folder.path().join("m.obj"), mesh).expect("written");
    let refused = answer(&mut raywalk(folder.path(), &["scene", "check", "t.json"])).fails(2, "");
    let first = refused.message.lines().next().unwrap_or_default();
    assert!(first.starts_with(&format!("error: m.obj:{expected}")), "{}", refused.message);
    assert!(refused.message.len() < 1000, "{}", refused.message);
    first.to_owned()
}

/// The mesh is read, with this warning.
#[track_caller]
fn reads(mesh: impl AsRef<[u8]>, warning: &str) {
    let folder = folder_with_mesh("m.obj");
    fs::write(folder.path().join("m.obj"), mesh).expect("written");
    let read = answer(&mut raywalk(folder.path(), &["scene", "check", "t.json"])).ends_with(0);
    assert_eq!(read.message, warning);
    answer(&mut raywalk(folder.path(), &["render", "t.json", "--size", "9x9", "-o", "a.png", "-q"])).ends_with(0);
}

#[test]
fn o01_index_zero() {
    refuses(format!("{VERTICES}f 0 1 2\n"), "5:3: there is no vertex 0, they count from 1");
}

#[test]
fn o02_index_high() {
    refuses(format!("{VERTICES}f 1 2 3\nf 1 2 9\n"), "6:7: there is no vertex 9, the file has 4 vertices");
}

#[test]
fn o03_index_negative() {
    refuses(format!("{VERTICES}f 1 2 -9\n"), "5:7: there is no vertex -9, only 4 precede it");
}

#[test]
fn o04_index_overflow() {
    let expected = "5:7: expected a corner such as `1`, `1/2`, `1//3` or `1/2/3`, found `99999999999999999999`";
    refuses(format!("{VERTICES}f 1 2 99999999999999999999\n"), expected);
    // Which would be 1 in 32 bits.
    refuses(format!("{VERTICES}f 1 2 4294967297\n"), "5:7: there is no vertex 4294967297");
}

#[test]
fn o05_two_vertices() {
    refuses(format!("{VERTICES}f 1 2\n"), "5:1: expected a face of 3 corners or more, found 2");
}

#[test]
fn o06_nan_vertex() {
    refuses("v 0 nan 0\nf 1 1 1\n", "1:5: expected a finite number, found `nan`");
    refuses("v 0 0 1e999\nf 1 1 1\n", "1:7: expected a finite number, found `1e999`");
}

#[test]
fn o07_short_vertex() {
    refuses("v 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "1:1: a vertex has three coordinates, found 2");
}

#[test]
fn o08_no_faces() {
    refuses(VERTICES, "1:1: the file has no faces, expected at least one such as `f 1 2 3`");
}

#[test]
fn o09_degenerate() {
    reads(format!("{VERTICES}f 1 1 2\nf 1 2 3\n"), "warning: m.obj: 1 of 2 triangles has no area and is skipped\n");
}

#[test]
fn o10_long_line() {
    let shown = "1".repeat(40);
    let expected = format!("1:3: expected a finite number, found `{shown}…`");
    refuses(format!("v {} 0 0\n", "1".repeat(10_000_000)), &expected);
    // A polygon of a million corners on one line.
    let corners = " 1 2 3 4".repeat(250_000);
    let folder = folder_with_mesh("m.obj");
    fs::write(folder.path().join("m.obj"), format!("{VERTICES}f{corners}\n")).expect("written");
    answer(&mut raywalk(folder.path(), &["scene", "check", "t.json"])).ends_with(0);
}

#[test]
fn o11_crlf_and_slashes() {
    reads(
        "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nvt 0 0\r\nvn 0 0 1\r\nf 1/1/1 2/1/1 \\\r\n3/1/1\r\nf 1//1 2//1 3//1\r\n",
        "",
    );
}

#[test]
fn o12_binary() {
    let bytes: Vec<u8> = (0..4096_u32).map(|k| (k * 7 % 251) as u8).collect();
    let expected = "1:1: expected an OBJ statement such as `v`, `vn` or `f`, found `\\u{0}\\u{7}\\u{e}\\u{15}\\u{1c}#*18?FMT[bipw~";
    refuses_with(bytes, expected);
}
