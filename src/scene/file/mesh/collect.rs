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

/// A mesh that is being read.
#[derive(Default)]
pub struct Collector {
    /// The vertices so far.
    pub positions: Vec<DVec3>,
    /// The normals so far.
    pub normals: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
    /// The normals of the faces; shorter than `faces` once a corner came without.
    normal_faces: Vec<[u32; 3]>,
    has_some_normals: bool,
    /// The faces of more than three corners, by the numbers of their triangles, which are a fan until all vertices are known.
    fans: Vec<Range<u32>>,
    fan: Fan,
}

/// The corners of the face that is being read, as far as a fan needs them.
#[derive(Default)]
struct Fan {
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

    /// The next corner of a face. From the third on, each makes a triangle with the first and the one before.
    pub fn corner(&mut self, corner: Corner, span: Range<usize>) -> Result<(), Fault> {
        self.fan.count += 1;
        self.has_some_normals |= corner.normal.is_some();
        if let (Some(first), Some(latest)) = (self.fan.first, self.fan.latest) {
            self.triangle([first, latest, corner], span)?;
        }
        let slot = if self.fan.first.is_none() { &mut self.fan.first } else { &mut self.fan.latest };
        *slot = Some(corner);
        Ok(())
    }

    /// The end of a face.
    pub fn end_face(&mut self, span: Range<usize>) -> Result<(), Fault> {
        let corners = std::mem::take(&mut self.fan).count;
        if corners < 3 {
            return Err(Fault::wrong(span, format!("expected a face of 3 corners or more, found {corners}")));
        }
        if corners > 3 {
            let end = self.faces.len() as u32;
            push(&mut self.fans, end - (corners as u32 - 2)..end, MAX_TRIANGLES, "faces", span)?;
        }
        Ok(())
    }

    /// Whether there are triangles.
    pub fn has_faces(&self) -> bool {
        !self.faces.is_empty()
    }

    /// The mesh, and what is odd about it.
    pub fn finish(self) -> (Mesh, Vec<String>) {
        let mut warnings = Vec::new();
        let has_all_normals = self.normal_faces.len() == self.faces.len();
        if self.has_some_normals && !has_all_normals {
            warnings.push("the normals are left out, because some corners have none".to_owned());
        }
        let (mut faces, mut normal_faces) = (self.faces, self.normal_faces);
        let mut crooked = 0;
        for fan in &self.fans {
            let normals = if has_all_normals { &mut normal_faces[..] } else { &mut [] };
            let is_cut = cut_concave(fan, &self.positions, &mut faces, normals);
            crooked += usize::from(!is_cut);
        }
        if crooked > 0 {
            let faces = if crooked == 1 { "1 face has".to_owned() } else { format!("{crooked} faces have") };
            warnings.push(format!("{faces} more than {MAX_CORNERS_CUT} corners and a notch, and may be cut wrongly"));
        }
        let normals = has_all_normals.then_some(CornerNormals { vectors: self.normals, faces: normal_faces });
        let mesh = Mesh { positions: self.positions, normals, faces };
        match (mesh.degenerate_count(), mesh.faces.len()) {
            (0, _) => {}
            (1, all) => warnings.push(format!("1 of {all} triangles has no area and is skipped")),
            (count, all) => warnings.push(format!("{count} of {all} triangles have no area and are skipped")),
        }
        (mesh, warnings)
    }

    fn triangle(&mut self, corners: [Corner; 3], span: Range<usize>) -> Result<(), Fault> {
        if let [Some(a), Some(b), Some(c)] = corners.map(|corner| corner.normal)
            && self.normal_faces.len() == self.faces.len()
        {
            push(&mut self.normal_faces, [a, b, c], MAX_TRIANGLES, "triangles", span.clone())?;
        }
        push(&mut self.faces, corners.map(|corner| corner.vertex), MAX_TRIANGLES, "triangles", span)
    }
}

/// Cuts a face with a notch, of which a fan would leave the outline, into triangles inside it. `false` if it has too many
/// corners for that.
fn cut_concave(fan: &Range<u32>, positions: &[DVec3], faces: &mut [[u32; 3]], normal_faces: &mut [[u32; 3]]) -> bool {
    let range = fan.start as usize..fan.end as usize;
    let of_fan = |triangles: &[[u32; 3]]| -> Vec<u32> {
        triangles.iter().take(1).flatten().copied().chain(triangles.iter().skip(1).map(|[_, _, c]| *c)).collect()
    };
    let corners = of_fan(&faces[range.clone()]);
    let places: Vec<DVec3> = corners.iter().map(|corner| positions[*corner as usize]).collect();
    if is_fan(&places) {
        return true;
    }
    if corners.len() > MAX_CORNERS_CUT {
        return false;
    }
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
fn is_fan(corners: &[DVec3]) -> bool {
    let Some((first, rest)) = corners.split_first() else { return true };
    let mut areas = rest.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first));
    let sum: DVec3 = areas.clone().sum();
    areas.all(|area| area.dot(sum) >= 0.0)
}

/// Adds to a list, if the limit and the memory allow it.
fn push<T>(list: &mut Vec<T>, item: T, limit: usize, what: &str, span: Range<usize>) -> Result<(), Fault> {
    if list.len() == limit {
        return Err(Fault::wrong(span, format!("too many {what}, expected at most {limit}")));
    }
    list.try_reserve(1)?;
    list.push(item);
    Ok(())
}
