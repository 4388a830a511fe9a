//! What both readers build: a mesh that grows as far as the limits and the memory allow.

use std::ops::Range;

use glam::DVec3;

use super::fault::Fault;
use super::limits::{MAX_TRIANGLES, MAX_VERTICES};
use crate::geometry::mesh::{CornerNormals, Mesh};

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
        let normals = has_all_normals.then_some(CornerNormals { vectors: self.normals, faces: self.normal_faces });
        let mesh = Mesh { positions: self.positions, normals, faces: self.faces };
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

/// Adds to a list, if the limit and the memory allow it.
fn push<T>(list: &mut Vec<T>, item: T, limit: usize, what: &str, span: Range<usize>) -> Result<(), Fault> {
    if list.len() == limit {
        return Err(Fault::wrong(span, format!("too many {what}, expected at most {limit}")));
    }
    list.try_reserve(1)?;
    list.push(item);
    Ok(())
}
