//! Procedural scenes and meshes, of any size, the same on every machine.

mod icosphere;
mod knot;
mod obj;
mod random_spheres;
mod sphere_flake;

pub use icosphere::icosphere;
pub use knot::knot;
pub use obj::write_obj;
pub use random_spheres::random_spheres;
pub use sphere_flake::{MAX_FLAKE_LEVEL, sphere_flake};

/// The greatest level of detail. The triangles of a mesh still count in millions there.
pub const MAX_LEVEL: u32 = 7;

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod testing {
    use crate::geometry::Mesh;
    use std::collections::HashMap;

    /// Every edge has a triangle on each side, which run along it in opposite directions.
    #[track_caller]
    pub fn is_closed(mesh: &Mesh) {
        let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
        for [a, b, c] in &mesh.faces {
            for edge in [(*a, *b), (*b, *c), (*c, *a)] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        assert!(edges.values().all(|count| *count == 1), "an edge twice in one direction");
        assert!(edges.keys().all(|(from, to)| edges.contains_key(&(*to, *from))), "an edge with one triangle");
    }
}
