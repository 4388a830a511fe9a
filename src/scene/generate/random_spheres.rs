//! Spheres at random, as many as are asked for.

use crate::geometry::shape::{Sphere, SphereMethod};
use crate::random::{hash, unit};
use glam::DVec3;
use rayon::prelude::*;

/// Spheres in the unit cube whose volumes are an eighth of it together, whatever their number: places and radii (from half to one and a
/// half times the mean) are hashes of their numbers, so that every machine has the same. They may overlap.
pub fn random_spheres(count: u32) -> impl IndexedParallelIterator<Item = Sphere> {
    let mean = libm::cbrt(0.1 * 0.75 / std::f64::consts::PI / f64::from(count));
    (0..count).into_par_iter().map(move |number| {
        let [x, y, z, r] = [0, 1, 2, 3].map(|word| unit(hash(u64::from(count), u64::from(number) * 4 + word)));
        Sphere::new(DVec3::new(x, y, z), mean * (0.5 + r), false, SphereMethod::Robust)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::shape::Kernel;

    #[test]
    fn they_fill_about_an_eighth_of_the_cube() {
        for count in [1000, 3000] {
            let volumes = random_spheres(count).filter_map(|sphere| {
                let bounds = sphere.bounds()?;
                let radius = (bounds.max - bounds.min).x / 2.0;
                assert!((DVec3::splat(-0.1).cmple(bounds.center()) & bounds.center().cmple(DVec3::splat(1.1))).all());
                Some(radius * radius * radius * 4.0 / 3.0 * std::f64::consts::PI)
            });
            // The mean of r³ is 1.25 times the cube of the mean.
            let filled: f64 = volumes.sum();
            assert!((filled - 0.125).abs() < 0.01, "{filled}");
        }
    }
}
