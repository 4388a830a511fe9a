//! Reads Wavefront OBJ: vertices, normals and faces. What else the format has is skipped.
//!
//! Own code rather than the crate `tobj`, whose errors don't say the line, which is what a person with a broken file needs.

use std::ops::Range;

use glam::DVec3;

use super::collect::{Collector, Corner};
use super::fault::{Fault, without_place};
use super::words::{Syntax, Words};
use crate::geometry::mesh::Mesh;
use crate::scene::file::{Problem, SceneError, Source};

/// Statements that say nothing about where triangles are.
const SKIPPED: &[&[u8]] = &[
    b"vt",
    b"vp",
    b"p",
    b"l",
    b"g",
    b"s",
    b"o",
    b"mg",
    b"mtllib",
    b"usemtl",
    b"usemap",
    b"maplib",
    b"bevel",
    b"lod",
    b"c_interp",
    b"d_interp",
    b"shadow_obj",
    b"trace_obj",
    b"cstype",
    b"deg",
    b"bmat",
    b"step",
    b"curv",
    b"curv2",
    b"surf",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
    b"ctech",
    b"stech",
    b"call",
    b"csh",
];

/// What some editors put before a text.
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// The mesh in the text of an OBJ file, and warnings.
pub fn read(source: &Source) -> Result<(Mesh, Vec<Problem>), SceneError> {
    let start = if source.text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 };
    let mut reader = Reader {
        words: Words::new(source.text, start, Syntax::Obj),
        mesh: Collector::default(),
        highest_vertex: None,
        highest_normal: None,
        unknown: None,
    };
    reader.read().map_err(|fault| fault.in_text(source))?;
    let (mesh, warnings) = reader.mesh.finish();
    let unknown = reader.unknown.map(|(span, message)| source.problem(span, Default::default(), message));
    let warnings = warnings.into_iter().map(|message| without_place(source.name, message));
    Ok((mesh, unknown.into_iter().chain(warnings).collect()))
}

struct Reader<'t> {
    words: Words<'t>,
    mesh: Collector,
    /// The highest numbers that faces name, with their places: a face may name what comes later.
    highest_vertex: Option<(u32, Range<usize>)>,
    highest_normal: Option<(u32, Range<usize>)>,
    /// The first statement that isn't known.
    unknown: Option<(Range<usize>, String)>,
}

impl Reader<'_> {
    fn read(&mut self) -> Result<(), Fault> {
        loop {
            if let Some(keyword) = self.words.next() {
                self.statement(keyword)?;
            }
            if !self.words.next_line() {
                break;
            }
        }
        check_highest(self.highest_vertex.take(), self.mesh.positions.len(), "vertex", "vertices")?;
        check_highest(self.highest_normal.take(), self.mesh.normals.len(), "normal", "normals")?;
        if self.mesh.has_faces() {
            return Ok(());
        }
        Err(Fault::wrong(0..0, "the file has no faces, expected at least one such as `f 1 2 3`"))
    }

    fn statement(&mut self, keyword: Range<usize>) -> Result<(), Fault> {
        match self.words.bytes(&keyword) {
            b"v" => {
                let position = self.triple(&keyword, "a vertex has")?;
                self.mesh.vertex(position, keyword)
            }
            b"vn" => {
                let normal = self.triple(&keyword, "a normal has")?;
                self.mesh.normal(normal, keyword)
            }
            b"f" | b"fo" => self.face(keyword),
            known if SKIPPED.contains(&known) => Ok(()),
            other => self.unknown(keyword, other),
        }
    }

    /// Three finite numbers; a weight or a colour may follow.
    fn triple(&mut self, keyword: &Range<usize>, who: &str) -> Result<DVec3, Fault> {
        let mut triple = [0.0; 3];
        for (index, component) in triple.iter_mut().enumerate() {
            let Some(word) = self.words.next() else {
                let span = keyword.start..self.words.at;
                return Err(Fault::wrong(span, format!("{who} three coordinates, found {index}")));
            };
            *component = self.number(word)?;
        }
        Ok(triple.into())
    }

    fn number(&self, word: Range<usize>) -> Result<f64, Fault> {
        let text = std::str::from_utf8(self.words.bytes(&word)).unwrap_or_default();
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => {
                let message = format!("expected a finite number, found `{}`", self.words.shown(&word));
                Err(Fault::wrong(word, message))
            }
        }
    }

    fn face(&mut self, keyword: Range<usize>) -> Result<(), Fault> {
        let start = keyword.start;
        while let Some(word) = self.words.next() {
            let corner = self.corner(&word)?;
            self.mesh.corner(corner, word)?;
        }
        self.mesh.end_face(start..self.words.at)
    }

    /// A corner `vertex`, `vertex/texture`, `vertex//normal` or `vertex/texture/normal`.
    fn corner(&mut self, word: &Range<usize>) -> Result<Corner, Fault> {
        let mut parts = self.words.bytes(word).split(|byte| *byte == b'/');
        let vertex = parts.next().unwrap_or_default();
        let texture = parts.next().filter(|part| !part.is_empty());
        let normal = parts.next().filter(|part| !part.is_empty());
        let numbers = (integer(vertex), texture.map(integer), normal.map(integer), parts.next());
        let (Some(vertex), None | Some(Some(_)), None | Some(Some(_)), None) = numbers else {
            let shown = self.words.shown(word);
            let message = format!("expected a corner such as `1`, `1/2`, `1//3` or `1/2/3`, found `{shown}`");
            return Err(Fault::wrong(word.clone(), message));
        };
        let vertex = resolve(vertex, self.mesh.positions.len(), word, "vertex", &mut self.highest_vertex)?;
        let normal = match numbers.2.flatten() {
            Some(normal) => Some(resolve(normal, self.mesh.normals.len(), word, "normal", &mut self.highest_normal)?),
            None => None,
        };
        Ok(Corner { vertex, normal })
    }

    /// Plain words may be somebody's extension; anything else is no OBJ file.
    fn unknown(&mut self, keyword: Range<usize>, word: &[u8]) -> Result<(), Fault> {
        let is_word = word.len() <= 32 && word.iter().all(|byte| byte.is_ascii_alphanumeric() || *byte == b'_');
        let starts_with_letter = word.first().is_some_and(u8::is_ascii_alphabetic);
        let shown = self.words.shown(&keyword);
        if is_word && starts_with_letter {
            if self.unknown.is_none() {
                self.unknown = Some((keyword, format!("unknown statement `{shown}`, such are skipped")));
            }
            return Ok(());
        }
        Err(Fault::wrong(keyword, format!("expected an OBJ statement such as `v`, `vn` or `f`, found `{shown}`")))
    }
}

fn integer(word: &[u8]) -> Option<i64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// The number from 0 of what a face names: from 1, or from the latest backward.
fn resolve(
    number: i64,
    so_far: usize,
    word: &Range<usize>,
    what: &str,
    highest: &mut Option<(u32, Range<usize>)>,
) -> Result<u32, Fault> {
    let wrong = |message: String| Err(Fault::wrong(word.clone(), message));
    if number == 0 {
        return wrong(format!("there is no {what} 0, they count from 1"));
    }
    if number > 0 {
        let Ok(number) = u32::try_from(number) else {
            return wrong(format!("there is no {what} {number}"));
        };
        if number as usize > so_far && highest.as_ref().is_none_or(|(highest, _)| *highest < number) {
            *highest = Some((number, word.clone()));
        }
        return Ok(number - 1);
    }
    match (so_far as i64).checked_add(number) {
        // The limits keep the numbers far below 2³².
        Some(index) if index >= 0 => Ok(index as u32),
        _ => wrong(format!("there is no {what} {number}, only {so_far} stand before it")),
    }
}

fn check_highest(highest: Option<(u32, Range<usize>)>, count: usize, what: &str, plural: &str) -> Result<(), Fault> {
    match highest {
        Some((number, span)) if number as usize > count => {
            let have = match count {
                0 => format!("the file has no {plural}"),
                1 => format!("the file has one {what}"),
                _ => format!("the file has {count} {plural}"),
            };
            Err(Fault::wrong(span, format!("there is no {what} {number}, {have}")))
        }
        _ => Ok(()),
    }
}
