//! Reads Wavefront OBJ: vertices, normals and faces. What else the format has is skipped.
//!
//! Own code rather than the crate `tobj`, whose errors don't say the line, which is what a person with a broken file needs.

use crate::files::{FileError, Problem, Source, without_mark};
use std::num::{IntErrorKind, ParseIntError};
use std::ops::Range;

use glam::DVec3;

use super::collect::{Collector, Corner, Run, counted};
use super::fault::{Fault, without_place};
use super::words::{Syntax, Words};
use crate::geometry::mesh::Mesh;
use crate::scene::file::foreign::{number, without_end_mark};

/// Statements that say nothing about where triangles are.
const SKIPPED: &[&[u8]] = &[
    b"vp",
    b"p",
    b"points",
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

/// The mesh in the text of an OBJ file, and warnings.
pub fn read(source: &Source) -> Result<(Mesh, Vec<Problem>), FileError> {
    let start = source.text.len() - without_mark(source.text).len();
    let mut reader = Reader {
        words: Words::new(without_end_mark(source.text), start, Syntax::Obj),
        mesh: Collector::default(),
        highest_vertex: None,
        normals: Named::default(),
        textures: Named::default(),
        unknown: None,
    };
    reader.read().map_err(|fault| fault.in_text(source))?;
    let lost_textures = reader.textures.lost();
    let (mesh, mut warnings) = reader.mesh.finish();
    if lost_textures > 0 {
        let (one, several) = ("corner names a texture coordinate", "corners name texture coordinates");
        let corners = counted(lost_textures, one, several);
        warnings.push(format!("{corners} that the file doesn't have, which counts as none"));
    }
    let unknown = reader.unknown.map(|(span, message)| source.problem(span, Default::default(), message));
    let warnings = warnings.into_iter().map(|message| without_place(source.name, message));
    Ok((mesh, unknown.into_iter().chain(warnings).collect()))
}

struct Reader<'t> {
    words: Words<'t>,
    mesh: Collector,
    /// The highest number of a vertex that faces name, with its place: a face may name what comes later.
    highest_vertex: Option<(u32, Range<usize>)>,
    normals: Named,
    textures: Named,
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
        check_highest(self.highest_vertex.take(), self.mesh.positions.len())?;
        self.mesh.lost_normals = self.normals.lost();
        self.mesh.check_faces(Fault::wrong(0..0, "the file has no faces, expected at least one such as `f 1 2 3`"))
    }

    fn statement(&mut self, keyword: Range<usize>) -> Result<(), Fault> {
        match self.words.bytes(&keyword) {
            b"v" => {
                let position = self.triple(&keyword, "a vertex has", f64::is_finite)?;
                self.mesh.vertex(position, keyword)
            }
            b"vn" => {
                let normal = self.triple(&keyword, "a normal has", |_| true)?;
                self.normals.so_far += 1;
                self.mesh.normal(normal, keyword)
            }
            b"vt" => {
                self.textures.so_far += 1;
                Ok(())
            }
            b"f" | b"fo" => self.face(keyword),
            known if SKIPPED.contains(&known) => Ok(()),
            other => self.unknown(keyword, other),
        }
    }

    /// Three numbers that may be there; a weight or a colour may follow.
    fn triple(&mut self, keyword: &Range<usize>, who: &str, may_be: fn(f64) -> bool) -> Result<DVec3, Fault> {
        let mut triple = [0.0; 3];
        for (index, component) in triple.iter_mut().enumerate() {
            let Some(word) = self.words.next() else {
                let span = keyword.start..self.words.at;
                return Err(Fault::wrong(span, format!("{who} three coordinates, found {index}")));
            };
            let Some(number) = number(self.words.bytes(&word)).filter(|number| may_be(*number)) else {
                let message = format!("expected a finite number, found `{}`", self.words.shown(&word));
                return Err(Fault::wrong(word, message));
            };
            *component = number;
        }
        Ok(triple.into())
    }

    fn face(&mut self, keyword: Range<usize>) -> Result<(), Fault> {
        let start = keyword.start;
        while let Some(word) = self.words.next() {
            let corner = self.corner(&word)?;
            self.mesh.corner(Run::Face, corner, word)?;
        }
        self.mesh.end(Run::Face, start..self.words.at)
    }

    /// A corner `vertex`, `vertex/texture`, `vertex//normal` or `vertex/texture/normal`.
    fn corner(&mut self, word: &Range<usize>) -> Result<Corner, Fault> {
        let mut parts = self.words.bytes(word).split(|byte| *byte == b'/');
        let vertex = parts.next().unwrap_or_default();
        let texture = parts.next().filter(|part| !part.is_empty());
        let normal = parts.next().filter(|part| !part.is_empty());
        let numbers = (integer(vertex), texture.map(index), normal.map(index), parts.next());
        let (Ok(vertex), None | Some(Some(_)), None | Some(Some(_)), None) = numbers else {
            let shown = self.words.shown(word);
            let message = format!("expected a corner such as `1`, `1/2`, `1//3` or `1/2/3`, found `{shown}`");
            return Err(Fault::wrong(word.clone(), message));
        };
        let vertex = resolve(vertex, self.mesh.positions.len(), word, &mut self.highest_vertex)?;
        let (texture, normal) = (numbers.1.flatten(), numbers.2.flatten());
        texture.map(|texture| self.textures.find(texture)).transpose()?;
        let normal = normal.map(|normal| self.normals.find(normal)).transpose()?.flatten();
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

/// What corners may name beside vertices, and may name though it isn't there.
#[derive(Default)]
struct Named {
    /// How many there are so far.
    so_far: usize,
    /// How often one was named that is never there.
    lost: usize,
    /// The numbers, from 0, of those that were named before they came.
    ahead: Vec<u32>,
}

impl Named {
    /// The number from 0 of what a corner names; it may still not come.
    fn find(&mut self, number: i64) -> Result<Option<u32>, Fault> {
        let found = match number {
            1.. => u32::try_from(number - 1).ok(),
            _ => {
                (self.so_far as i64).checked_add(number).filter(|_| number < 0).and_then(|index| index.try_into().ok())
            }
        };
        match found {
            None => self.lost += 1,
            Some(index) if index as usize >= self.so_far => {
                if self.ahead.len() == self.ahead.capacity() {
                    raywalk_guard::attempt(|| self.ahead.try_reserve(1))?;
                }
                self.ahead.push(index);
            }
            Some(_) => {}
        }
        Ok(found)
    }

    /// How often one was named that isn't there, now that all are known.
    fn lost(&self) -> usize {
        self.lost + self.ahead.iter().filter(|index| **index as usize >= self.so_far).count()
    }
}

fn integer(word: &[u8]) -> Result<i64, Option<IntErrorKind>> {
    let text = std::str::from_utf8(word).map_err(|_| None)?;
    text.parse().map_err(|error: ParseIntError| Some(*error.kind()))
}

/// A number of what may be missing, so that it may be too large for anything.
fn index(word: &[u8]) -> Option<i64> {
    match integer(word) {
        Err(Some(IntErrorKind::PosOverflow | IntErrorKind::NegOverflow)) => Some(0),
        number => number.ok(),
    }
}

/// The number from 0 of the vertex that a face names: from 1, or from the latest backward.
fn resolve(
    number: i64,
    so_far: usize,
    word: &Range<usize>,
    highest: &mut Option<(u32, Range<usize>)>,
) -> Result<u32, Fault> {
    let wrong = |message: String| Err(Fault::wrong(word.clone(), message));
    if number == 0 {
        return wrong("there is no vertex 0, they count from 1".to_owned());
    }
    if number > 0 {
        let Ok(number) = u32::try_from(number) else {
            return wrong(format!("there is no vertex {number}"));
        };
        if number as usize > so_far && highest.as_ref().is_none_or(|(highest, _)| *highest < number) {
            *highest = Some((number, word.clone()));
        }
        return Ok(number - 1);
    }
    match (so_far as i64).checked_add(number) {
        // The limits keep the numbers far below 2³².
        Some(index) if index >= 0 => Ok(index as u32),
        _ => wrong(format!("there is no vertex {number}, only {so_far} precede it")),
    }
}

fn check_highest(highest: Option<(u32, Range<usize>)>, count: usize) -> Result<(), Fault> {
    match highest {
        Some((number, span)) if number as usize > count => {
            let have = match count {
                0 => "the file has no vertices".to_owned(),
                1 => "the file has one vertex".to_owned(),
                _ => format!("the file has {count} vertices"),
            };
            Err(Fault::wrong(span, format!("there is no vertex {number}, {have}")))
        }
        _ => Ok(()),
    }
}
