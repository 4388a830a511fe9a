//! Meshes and spheres.

use super::MAX_RAW_BYTES;
use super::fields::{Claim, Fields};
use crate::files::{FileError, Wanted, display_name, is_there};
use crate::geometry::mesh::Mesh;
use crate::scene::file::mesh::limits::{MAX_TRIANGLES, MAX_VERTICES};
use crate::scene::file::nff::MAX_PRIMITIVES;
use std::path::{Path, PathBuf};

/// What rays are shot at.
#[derive(Clone, Debug, PartialEq)]
pub enum Primitives {
    /// One mesh.
    Mesh(Mesh),
    /// Spheres by number.
    Spheres(Vec<RawSphere>),
}

/// A sphere as it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RawSphere {
    /// The centre.
    pub center: [f32; 3],
    /// The radius, positive.
    pub radius: f32,
}

impl Primitives {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Primitives::Mesh(mesh) => mesh.faces.len(),
            Primitives::Spheres(spheres) => spheres.len(),
        }
    }
}

/// `STEM.mesh` and `STEM.spheres`, one of which holds a scene's primitives.
pub fn primitive_files(stem: &Path) -> [PathBuf; 2] {
    [".mesh", ".spheres"].map(|ending| {
        let mut path = stem.as_os_str().to_owned();
        path.push(ending);
        PathBuf::from(path)
    })
}

/// Reads `STEM.mesh`, or `STEM.spheres` where there is no such file.
///
/// # Errors
/// [`FileError::Refused`] where there is neither or the file is damaged; [`FileError::Unreadable`] where the machine
/// doesn't give the bytes or has no room for them.
pub fn read_primitives(stem: &Path) -> Result<Primitives, FileError> {
    let [mesh, spheres] = primitive_files(stem);
    let wanted = |what| Wanted { what, max_bytes: MAX_RAW_BYTES };
    let is_there =
        |path: &Path| is_there(path).map_err(|source| FileError::Unreadable { file: display_name(path), source });
    match (is_there(&mesh)?, is_there(&spheres)?) {
        (true, _) => {
            let bytes = wanted("a raw mesh").read(&mesh)?;
            parse_mesh(&bytes, &display_name(&mesh)).map(Primitives::Mesh)
        }
        (false, true) => {
            let bytes = wanted("raw spheres").read(&spheres)?;
            parse_spheres(&bytes, &display_name(&spheres)).map(Primitives::Spheres)
        }
        (false, false) => {
            let reason = "no such scene, expected a file of that name with .mesh or .spheres behind it".to_owned();
            Err(FileError::Refused { file: display_name(stem), reason })
        }
    }
}

/// Reads a mesh.
///
/// # Errors
/// [`FileError::Refused`] where it is damaged; [`FileError::Unreadable`] where there is no room for it.
pub fn parse_mesh(bytes: &[u8], name: &str) -> Result<Mesh, FileError> {
    let mut fields = Fields::of(bytes, name, "RWMESH01", 24)?;
    let (vertices, triangles) = (fields.u64(), fields.u64());
    fields.must_hold(&[
        Claim { what: "vertices", count: vertices, size: 12, most: MAX_VERTICES },
        Claim { what: "triangles", count: triangles, size: 12, most: MAX_TRIANGLES },
    ])?;
    let vertex = |fields: &mut Fields, number| fields.finite::<3>("vertex", number).map(|x| x.map(f64::from).into());
    let positions = fields.list(vertices, vertex)?;
    let faces = fields.list(triangles, |fields, number| {
        let corners = [(); 3].map(|()| fields.u32());
        match corners.iter().find(|corner| u64::from(**corner) >= vertices) {
            None => Ok(corners),
            Some(corner) => Err(fields.refused(format!(
                "triangle {number}: expected vertices by their numbers below {vertices}, found {corner}"
            ))),
        }
    })?;
    Ok(Mesh { positions, normals: None, faces })
}

/// Reads spheres.
///
/// # Errors
/// Those of [`parse_mesh`].
pub fn parse_spheres(bytes: &[u8], name: &str) -> Result<Vec<RawSphere>, FileError> {
    let mut fields = Fields::of(bytes, name, "RWSPHR01", 16)?;
    let count = fields.u64();
    fields.must_hold(&[Claim { what: "spheres", count, size: 16, most: MAX_PRIMITIVES }])?;
    fields.list(count, |fields, number| {
        let [x, y, z, radius] = fields.finite("sphere", number)?;
        if radius > 0.0 {
            return Ok(RawSphere { center: [x, y, z], radius });
        }
        Err(fields.refused(format!("sphere {number}: the radius must be positive, found {radius}")))
    })
}
