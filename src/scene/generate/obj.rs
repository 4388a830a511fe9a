//! Writes a mesh as OBJ.

use std::io::{self, Write};

use glam::DVec3;

use crate::geometry::Mesh;

/// Decimals of the coordinates.
const DECIMALS: f64 = 1e9;

/// Writes a mesh as OBJ, with its normals if it has some. Coordinates have nine decimals at most.
pub fn write_obj(mesh: &Mesh, out: &mut impl Write) -> io::Result<()> {
    for position in &mesh.positions {
        triple(out, "v", *position)?;
    }
    let Some(normals) = &mesh.normals else {
        for [a, b, c] in mesh.faces.iter().map(|face| face.map(|corner| corner + 1)) {
            writeln!(out, "f {a} {b} {c}")?;
        }
        return Ok(());
    };
    for normal in &normals.vectors {
        triple(out, "vn", *normal)?;
    }
    for (face, normals) in mesh.faces.iter().zip(&normals.faces) {
        let ([a, b, c], [na, nb, nc]) = (face.map(|corner| corner + 1), normals.map(|normal| normal + 1));
        writeln!(out, "f {a}//{na} {b}//{nb} {c}//{nc}")?;
    }
    Ok(())
}

fn triple(out: &mut impl Write, keyword: &str, value: DVec3) -> io::Result<()> {
    // Adding 0 turns -0 into 0.
    let rounded = (value * DECIMALS).round() / DECIMALS + 0.0;
    writeln!(out, "{keyword} {} {} {}", rounded.x, rounded.y, rounded.z)
}
