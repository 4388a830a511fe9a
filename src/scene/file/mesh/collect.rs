//! What both readers build: a mesh that grows as far as the limits and the memory allow.

use std::ops::Range;

use glam::DVec3;

use super::fault::Fault;
use super::limits::{MAX_CORNERS_CUT, MAX_TRIANGLES, MAX_VERTICES};
use crate::geometry::mesh::{CornerNormals, Mesh, triangulate};
use crate::scene::file::validate::limits::MAX_COORDINATE;

/// A corner of a face: the numbers of its vertex and of its normal, from 0.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// The vertex.
    pub vertex: u32,
    /// The normal, if it has one.
    pub normal: Option<u32>,
}

/// What corners one after the other are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// A face. From the third on, each corner makes a triangle with the first and the one before.
    Face,
    /// A strip. From the third on, each corner makes a triangle with the two before, every second of which runs the other
    /// way round; those with a corner twice only lead from one part of the strip to the next.
    Strip,
}

/// A mesh that is being read.
#[derive(Default)]
pub struct Collector {
    /// The vertices so far.
    pub positions: Vec<DVec3>,
    /// The normals so far; those that aren't finite count as none.
    pub normals: Vec<DVec3>,
    /// How many corners name a normal that isn't there.
    pub lost_normals: usize,
    faces: Vec<[u32; 3]>,
    /// The normals of the faces; shorter than `faces` once a corner came without.
    normal_faces: Vec<[u32; 3]>,
    has_some_normals: bool,
    /// The faces of more than three corners, by the numbers of their triangles, which are a fan until all vertices are known.
    fans: Vec<Range<u32>>,
    /// How many faces have fewer than three corners, and the first of them with its number of corners.
    short: usize,
    first_short: Option<(Range<usize>, usize)>,
    ends: Ends,
}

/// The corners of the face or strip that is being read to which the next one makes a triangle.
#[derive(Default)]
struct Ends {
    first: Option<Corner>,
    latest: Option<Corner>,
    count: usize,
}

impl Collector {
    /// A vertex.
    pub fn vertex(&mut self, position: DVec3, span: Range<usize>) -> Result<(), Fault> {
        if position.abs().max_element() > MAX_COORDINATE {
            let message = format!("expected coordinates from -{MAX_COORDINATE:e} to {MAX_COORDINATE:e}");
            return Err(Fault::wrong(span, message));
        }
        push(&mut self.positions, position, MAX_VERTICES, "vertices", span)
    }

    /// A normal.
    pub fn normal(&mut self, normal: DVec3, span: Range<usize>) -> Result<(), Fault> {
        push(&mut self.normals, normal, MAX_VERTICES, "normals", span)
    }

    /// The next corner of a face or a strip.
    pub fn corner(&mut self, run: Run, corner: Corner, span: Range<usize>) -> Result<(), Fault> {
        self.ends.count += 1;
        let is_turned = run == Run::Strip && self.ends.count.is_multiple_of(2);
        match (self.ends.first, self.ends.latest) {
            (None, _) => self.ends.first = Some(corner),
            (Some(_), None) => self.ends.latest = Some(corner),
            (Some(first), Some(latest)) => {
                let triangle = if is_turned { [latest, first, corner] } else { [first, latest, corner] };
                let [a, b, c] = triangle.map(|corner| corner.vertex);
                if run == Run::Face || (a != b && b != c && c != a) {
                    self.triangle(triangle, span)?;
                }
                self.ends.first = Some(if run == Run::Strip { latest } else { first });
                self.ends.latest = Some(corner);
            }
        }
        Ok(())
    }

    /// The end of a face or strip.
    pub fn end(&mut self, run: Run, span: Range<usize>) -> Result<(), Fault> {
        let corners = std::mem::take(&mut self.ends).count;
        // Between two marks of an end there is no strip.
        if corners < 3 && (run, corners) != (Run::Strip, 0) {
            self.short += 1;
            self.first_short.get_or_insert((span, corners));
        } else if corners > 3 && run == Run::Face {
            let end = self.faces.len() as u32;
            push(&mut self.fans, end - (corners as u32 - 2)..end, MAX_TRIANGLES, "faces", span)?;
        }
        Ok(())
    }

    /// Refuses a mesh without triangles: at its first face, if that has too few corners, or else with these words.
    pub fn check_faces(&mut self, nothing: Fault) -> Result<(), Fault> {
        match self.first_short.take() {
            _ if !self.faces.is_empty() => Ok(()),
            Some((span, corners)) => {
                Err(Fault::wrong(span, format!("expected a face of 3 corners or more, found {corners}")))
            }
            None => Err(nothing),
        }
    }

    /// The mesh, and what is odd about it.
    pub fn finish(self) -> (Mesh, Vec<String>) {
        let mut warnings = Vec::new();
        if self.short > 0 {
            let short = counted(self.short, "face has", "faces have");
            warnings.push(format!("{short} fewer than 3 corners, such are left out"));
        }
        let is_there = |normal: &u32| self.normals.get(*normal as usize).is_some_and(|normal| normal.is_finite());
        let has_all_normals = self.normal_faces.len() == self.faces.len()
            && self.normal_faces.iter().all(|normals| normals.iter().all(is_there));
        warnings.extend(self.about_normals(has_all_normals));
        let (mut faces, mut normal_faces, mut normals) = (self.faces, self.normal_faces, self.normals);
        // No corner has these, and nobody should find them.
        normals.iter_mut().filter(|normal| !normal.is_finite()).for_each(|normal| *normal = DVec3::ZERO);
        let mut crooked = 0;
        for fan in &self.fans {
            let of_corners = if has_all_normals { &mut normal_faces[..] } else { &mut [] };
            let is_cut = cut_concave(fan, &self.positions, &mut faces, of_corners);
            crooked += usize::from(!is_cut);
        }
        if crooked > 0 {
            let faces = counted(crooked, "face has", "faces have");
            warnings.push(format!("{faces} more than {MAX_CORNERS_CUT} corners and a notch, and may be cut wrongly"));
        }
        let normals = has_all_normals.then_some(CornerNormals { vectors: normals, faces: normal_faces });
        let mesh = Mesh { positions: self.positions, normals, faces };
        match (mesh.degenerate_count(), mesh.faces.len()) {
            (0, _) => {}
            (1, all) => warnings.push(format!("1 of {all} triangles has no area and is skipped")),
            (count, all) => warnings.push(format!("{count} of {all} triangles have no area and are skipped")),
        }
        (mesh, warnings)
    }

    /// What is said about normals, in one sentence.
    fn about_normals(&self, has_all: bool) -> Option<String> {
        let not_finite = self.normals.iter().filter(|normal| !normal.is_finite()).count();
        let mut why = Vec::new();
        if not_finite > 0 {
            why.push(format!("{} no number", counted(not_finite, "normal is", "normals are")));
        }
        if self.lost_normals > 0 {
            why.push(counted(
                self.lost_normals,
                "corner names a normal that isn't there",
                "corners name normals that aren't there",
            ));
        }
        let why = why.join(", and ");
        match (self.has_some_normals && !has_all, why.is_empty()) {
            (true, true) => Some("the normals are left out, because some corners have none".to_owned()),
            (true, false) => Some(format!("the normals are left out, because some corners have none: {why}")),
            (false, true) => None,
            (false, false) => Some(format!("{why}, which counts as none")),
        }
    }

    fn triangle(&mut self, corners: [Corner; 3], span: Range<usize>) -> Result<(), Fault> {
        self.has_some_normals |= corners.iter().any(|corner| corner.normal.is_some());
        if let [Some(a), Some(b), Some(c)] = corners.map(|corner| corner.normal)
            && self.normal_faces.len() == self.faces.len()
        {
            push(&mut self.normal_faces, [a, b, c], MAX_TRIANGLES, "triangles", span.clone())?;
        }
        push(&mut self.faces, corners.map(|corner| corner.vertex), MAX_TRIANGLES, "triangles", span)
    }
}

/// A number with what there are so many of.
pub fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// Cuts a face with a notch, of which a fan would leave the outline, into triangles inside it. `false` if it has too many
/// corners for that.
fn cut_concave(fan: &Range<u32>, positions: &[DVec3], faces: &mut [[u32; 3]], normal_faces: &mut [[u32; 3]]) -> bool {
    let range = fan.start as usize..fan.end as usize;
    let of_fan = |triangles: &[[u32; 3]]| -> Vec<u32> {
        triangles.iter().take(1).flatten().copied().chain(triangles.iter().skip(1).map(|[_, _, c]| *c)).collect()
    };
    // A face may have millions of corners, of which no list is made.
    if is_fan(&faces[range.clone()], positions) {
        return true;
    }
    if range.len() + 2 > MAX_CORNERS_CUT {
        return false;
    }
    let corners = of_fan(&faces[range.clone()]);
    let places: Vec<DVec3> = corners.iter().map(|corner| positions[*corner as usize]).collect();
    let cut = triangulate(&places);
    let renumber = |triangles: &mut [[u32; 3]], numbers: &[u32]| {
        for (triangle, corners) in triangles.iter_mut().zip(&cut) {
            *triangle = corners.map(|corner| numbers[corner]);
        }
    };
    if let Some(triangles) = normal_faces.get_mut(range.clone()) {
        let normals = of_fan(triangles);
        renumber(triangles, &normals);
    }
    renumber(&mut faces[range], &corners);
    true
}

/// Whether all triangles of the fan from the first corner turn the same way.
fn is_fan(triangles: &[[u32; 3]], positions: &[DVec3]) -> bool {
    let mut areas = triangles.iter().map(|triangle| {
        let [first, one, other] = triangle.map(|corner| positions[corner as usize]);
        (one - first).cross(other - first)
    });
    let sum: DVec3 = areas.clone().sum();
    areas.all(|area| area.dot(sum) >= 0.0)
}

/// Adds to a list, if the limit and the memory allow it.
fn push<T>(list: &mut Vec<T>, item: T, limit: usize, what: &str, span: Range<usize>) -> Result<(), Fault> {
    if list.len() == limit {
        return Err(Fault::wrong(span, format!("too many {what}, expected at most {limit}")));
    }
    if list.len() == list.capacity() {
        raywalk_guard::attempt(|| list.try_reserve(1))?;
    }
    list.push(item);
    Ok(())
}
