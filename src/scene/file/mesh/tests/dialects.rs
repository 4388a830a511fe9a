//! Meshes drawn at random, each written in a dialect drawn at random: all of them are the same mesh.

use std::fmt::Write as _;
use std::io::Write as _;

use flate2::Compression;
use flate2::write::GzEncoder;
use glam::DVec3;
use proptest::prelude::*;
use ruzstd::encoding::{CompressionLevel, compress_to_vec};

use super::from_scenes::{folder_and_scene, load_in};
use crate::geometry::mesh::{CornerNormals, Mesh};

/// Decisions drawn at random, one after the other.
struct Draws<'d> {
    drawn: &'d [u8],
    at: usize,
}

impl Draws<'_> {
    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        self.at += 1;
        choices[usize::from(self.drawn[self.at % self.drawn.len()]) % choices.len()]
    }

    fn chance(&mut self) -> bool {
        self.one_of(&[false, true])
    }
}

/// A mesh with what its file has beside triangles: strips, and faces that are none.
#[derive(Clone, Debug)]
struct Drawn {
    vertices: Vec<[i8; 3]>,
    faces: Vec<[usize; 3]>,
    strips: Vec<Vec<usize>>,
    short: Vec<Vec<usize>>,
    has_normals: bool,
}

fn meshes() -> impl Strategy<Value = Drawn> {
    let index = || 0..20_usize;
    let strip = prop::collection::vec(index(), 3..7);
    (
        prop::collection::vec(any::<[i8; 3]>(), 1..20),
        prop::collection::vec([index(), index(), index()], 1..9),
        prop::collection::vec(strip, 0..4),
        prop::collection::vec(prop::collection::vec(index(), 0..3), 0..3),
        any::<bool>(),
    )
        .prop_map(|(vertices, faces, strips, short, has_normals)| {
            let count = vertices.len();
            let within = |list: Vec<usize>| list.into_iter().map(|index| index % count).collect::<Vec<_>>();
            let faces = faces.into_iter().map(|face| face.map(|index| index % count)).collect();
            let lists = |lists: Vec<Vec<usize>>| lists.into_iter().map(within).collect();
            Drawn { vertices, faces, strips: lists(strips), short: lists(short), has_normals }
        })
}

impl Drawn {
    fn position(vertex: &[i8; 3]) -> [f64; 3] {
        vertex.map(|number| f64::from(number) / 4.0)
    }

    fn normal(vertex: &[i8; 3]) -> [f64; 3] {
        let [x, y, z] = Self::position(vertex);
        [y, z, x + 0.5]
    }

    /// What is to be read, of these triangles.
    fn mesh(&self, faces: &[[usize; 3]]) -> Mesh {
        let faces: Vec<_> = faces.iter().map(|face| face.map(|index| index as u32)).collect();
        let vectors = || self.vertices.iter().map(|vertex| Self::normal(vertex).into()).collect();
        Mesh {
            positions: self.vertices.iter().map(|vertex| DVec3::from(Self::position(vertex))).collect(),
            normals: self.has_normals.then(|| CornerNormals { vectors: vectors(), faces: faces.clone() }),
            faces,
        }
    }

    /// The triangles of the strips: of each three corners in a row, every second time the other way round.
    fn of_strips(&self) -> Vec<[usize; 3]> {
        let of_strip = |strip: &Vec<usize>| {
            let turned = |(at, corners): (usize, &[usize])| match at % 2 {
                0 => [corners[0], corners[1], corners[2]],
                _ => [corners[1], corners[0], corners[2]],
            };
            strip.windows(3).enumerate().map(turned).collect::<Vec<_>>()
        };
        let has_three = |[a, b, c]: &[usize; 3]| a != b && b != c && c != a;
        self.strips.iter().flat_map(of_strip).filter(has_three).collect()
    }

    /// The faces and those that are none, in turn.
    fn lists(&self) -> Vec<Vec<usize>> {
        let mut lists: Vec<Vec<usize>> = self.short.clone();
        lists.extend(self.faces.iter().map(|face| face.to_vec()));
        lists
    }
}

/// A value of a PLY body with its type: a float, a count or an index.
#[derive(Clone, Copy)]
enum Value {
    Float(f64),
    Count(usize),
    Index(i32),
    /// Of a property that nobody uses.
    Unused(f64),
}

impl Value {
    fn text(self, draws: &mut Draws) -> String {
        match self {
            Value::Float(number) => match draws.chance() {
                false => number.to_string(),
                true => format!("{number:.6e}"),
            },
            Value::Count(count) => count.to_string(),
            Value::Index(index) => index.to_string(),
            Value::Unused(_) => {
                draws.one_of(&["1", "0.5", "-nan(ind)", "nan", "-1.#IND00", "inf", "1.#QNAN"]).to_owned()
            }
        }
    }

    fn bytes(self, is_big: bool) -> Vec<u8> {
        let mut bytes = match self {
            Value::Float(number) | Value::Unused(number) => (number as f32).to_le_bytes().to_vec(),
            Value::Count(count) => (count as u16).to_le_bytes().to_vec(),
            Value::Index(index) => index.to_le_bytes().to_vec(),
        };
        if is_big {
            bytes.reverse();
        }
        bytes
    }
}

fn ply(drawn: &Drawn, draws: &mut Draws) -> (Vec<u8>, Mesh) {
    let format = draws.one_of(&["ascii", "ascii", "binary_little_endian", "binary_big_endian"]);
    let line_end = draws.one_of(&["\n", "\r\n"]);
    let (float, short, int) = draws.one_of(&[("float", "ushort", "int"), ("float32", "uint16", "int32")]);
    let has_unused = draws.chance();
    let mut vertices = Vec::new();
    for vertex in &drawn.vertices {
        let mut record: Vec<Value> = Drawn::position(vertex).map(Value::Float).to_vec();
        record.extend(has_unused.then_some(Value::Unused(f64::NAN)));
        if drawn.has_normals {
            record.extend(Drawn::normal(vertex).map(Value::Float));
        }
        vertices.push(record);
    }
    let list = |corners: &[i32]| {
        let corners = corners.iter().map(|index| Value::Index(*index));
        std::iter::once(Value::Count(corners.len())).chain(corners).collect::<Vec<_>>()
    };
    let numbers = |corners: &[usize]| corners.iter().map(|index| *index as i32).collect::<Vec<_>>();
    let faces: Vec<_> = drawn.lists().iter().map(|face| list(&numbers(face))).collect();
    // All strips in one list, or each in its own.
    let strips: Vec<_> = match draws.chance() {
        true => drawn.strips.iter().map(|strip| list(&numbers(strip))).collect(),
        false => {
            vec![list(&drawn.strips.iter().flat_map(|strip| [numbers(strip), vec![-1]].concat()).collect::<Vec<_>>())]
        }
    };
    let mut properties = format!("property {float} x\nproperty {float} y\nproperty {float} z\n");
    if has_unused {
        let _ = writeln!(properties, "property {float} quality");
    }
    if drawn.has_normals {
        let _ = writeln!(properties, "property {float} nx\nproperty {float} ny\nproperty {float} nz");
    }
    let corners = format!("property list {short} {int} vertex_indices\n");
    let mut elements = [
        (format!("element vertex {}\n{properties}", vertices.len()), vertices),
        (format!("element face {}\n{corners}", faces.len()), faces),
        (format!("element tristrips {}\n{corners}", strips.len()), strips),
    ];
    let order = draws.one_of(&[[0, 1, 2], [1, 0, 2], [0, 2, 1], [2, 1, 0]]);
    let is_strip_first = order.iter().position(|at| *at == 2) < order.iter().position(|at| *at == 1);
    let mut bytes = format!("ply\nformat {format} 1.0\ncomment f 1 # 2\n").into_bytes();
    for at in order {
        bytes.extend(elements[at].0.bytes());
    }
    bytes.extend(b"end_header\n");
    let mut bytes = String::from_utf8(bytes).unwrap().replace('\n', line_end).into_bytes();
    let records: Vec<Vec<Value>> = order.iter().flat_map(|at| std::mem::take(&mut elements[*at].1)).collect();
    match format {
        "ascii" => bytes.extend(text(&records, line_end, draws).bytes()),
        _ => bytes.extend(records.iter().flatten().flat_map(|value| value.bytes(format == "binary_big_endian"))),
    }
    let (faces, strips) = (drawn.faces.clone(), drawn.of_strips());
    let triangles = if is_strip_first { [strips, faces] } else { [faces, strips] };
    (bytes, drawn.mesh(&triangles.concat()))
}

/// The lines of a PLY body.
fn text(records: &[Vec<Value>], line_end: &str, draws: &mut Draws) -> String {
    let mut text = String::new();
    // A line a record, more values on each line, lines of this many values, or two lines a record.
    let (width, has_more, halves) = draws.one_of(&[
        (None, false, false),
        (None, true, false),
        (Some(1), false, false),
        (Some(5), false, false),
        (Some(9999), false, false),
        (None, false, true),
    ]);
    let mut values = 0;
    for record in records {
        for (at, value) in record.iter().enumerate() {
            text.push_str(&value.text(draws));
            text.push_str(draws.one_of(&[" ", "  ", "\t", "\x0b"]));
            values += 1;
            let ends = width.is_some_and(|width| values % width == 0) || (halves && at + 1 == record.len() / 2);
            text.push_str(if ends { line_end } else { "" });
        }
        if width.is_none() {
            text.push_str(if has_more { "255 0 77777 junk" } else { "" });
            text.push_str(line_end);
            text.push_str(draws.one_of(&["", "", line_end]));
        }
    }
    text.push_str(draws.one_of(&["", line_end, "\x1a", "\r\n\x1a\n"]));
    text
}

fn obj(drawn: &Drawn, draws: &mut Draws) -> (Vec<u8>, Mesh) {
    let mut lines: Vec<Vec<String>> = Vec::new();
    let three = |keyword: &str, numbers: [f64; 3]| {
        std::iter::once(keyword.to_owned()).chain(numbers.map(|number| number.to_string())).collect::<Vec<_>>()
    };
    for vertex in &drawn.vertices {
        lines.push(three("v", Drawn::position(vertex)));
        if drawn.has_normals {
            lines.push(three("vn", Drawn::normal(vertex)));
        }
        if draws.chance() {
            lines.push(vec!["p".to_owned(), "1".to_owned()]);
        }
    }
    let count = drawn.vertices.len();
    for face in drawn.lists() {
        let number = |index: usize, draws: &mut Draws| match draws.chance() {
            true => (index + 1).to_string(),
            false => format!("-{}", count - index),
        };
        let corner = |index: &usize| {
            let vertex = number(*index, draws);
            let texture = draws.one_of(&["", "7", "0", "-3"]);
            match (drawn.has_normals, texture) {
                (true, texture) => format!("{vertex}/{texture}/{}", number(*index, draws)),
                (false, "") => vertex,
                (false, texture) => format!("{vertex}/{texture}"),
            }
        };
        lines.push(std::iter::once("f".to_owned()).chain(face.iter().map(corner)).collect());
    }
    let line_end = draws.one_of(&["\n", "\r\n", "\r"]);
    let mut text = String::new();
    for line in lines {
        for word in line {
            text.push_str(&word);
            text.push_str(draws.one_of(&[" ", "\t ", "\x0b", "\x0c", " \\\n", "\\ \t\r\n"]));
        }
        // Behind the last word is a blank or a line that goes on; the end of the line may have been there.
        text.push_str(draws.one_of(&["", "# v 0 0 0", "#\\"]));
        text.push_str(line_end);
        text.push_str(draws.one_of(&["", "# f 1 1 1\n", "l 1 2\n", "\n"]));
    }
    text.push_str(draws.one_of(&["", "\x1a", "\x1a\r\n"]));
    (text.into_bytes(), drawn.mesh(&drawn.faces))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_mesh_is_the_same_in_every_dialect(drawn in meshes(), drawn_bytes in prop::collection::vec(any::<u8>(), 64..300)) {
        let mut draws = Draws { drawn: &drawn_bytes, at: 0 };
        let is_obj = draws.chance();
        let (bytes, expected) = if is_obj { obj(&drawn, &mut draws) } else { ply(&drawn, &mut draws) };
        let ending = draws.one_of(&["", ".gz", ".zst"]);
        let packed = match ending {
            ".gz" => {
                let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
                encoder.write_all(&bytes).unwrap();
                encoder.finish().unwrap()
            }
            ".zst" => compress_to_vec(&bytes[..], CompressionLevel::Fastest),
            _ => bytes.clone(),
        };
        let name = format!("drawn.{}{ending}", if is_obj { "obj" } else { "ply" });
        let (folder, scene) = folder_and_scene(&[&name]);
        std::fs::write(folder.path().join(&name), packed).unwrap();
        let shown = String::from_utf8_lossy(&bytes);
        let (meshes, warnings) = load_in(folder.path(), &scene).unwrap_or_else(|error| panic!("{error}\n{shown}"));
        prop_assert_eq!(&**meshes.get(&name).unwrap(), &expected, "\n{}", shown);
        let left_out = warnings.iter().filter(|warning| warning.message.contains("fewer than 3 corners")).count();
        prop_assert_eq!(left_out, usize::from(!drawn.short.is_empty()));
    }
}
