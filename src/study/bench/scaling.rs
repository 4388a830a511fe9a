//! How time and memory grow with the number of primitives and with the size of a picture.

use super::Spread;
use super::clock::timed;
use super::throughput::{Hits, Mode, Passes, measure};
use crate::geometry::Shape;
use crate::random::{hash, unit};
use crate::render::{RenderError, Settings, render};
use crate::scene::Scene;
use crate::scene::file::raw::{Question, RawRay, RayFile};
use crate::scene::generate::random_spheres;
use glam::DVec3;
use rayon::prelude::*;
use serde::Serialize;
use std::sync::atomic::AtomicBool;

/// How many rays of each kind are shot at the spheres: the square of this.
pub const RAYS_A_SIDE: u32 = 256;

/// How long one number of spheres takes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OfSpheres {
    /// How many spheres.
    pub spheres: u32,
    /// Seconds until they can be traced.
    pub build_s: f64,
    /// Nanoseconds of processor time for a ray from an eye outside, beside rays like it.
    pub ns_per_camera_ray: Spread,
    /// Nanoseconds of processor time for a ray from anywhere to anywhere.
    pub ns_per_random_ray: Spread,
    /// The part of the camera rays that hit something.
    pub hit: f64,
}

/// How long one size of a picture takes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OfSize {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Nanoseconds by the clock for a pixel, all threads together.
    pub ns_per_pixel: Spread,
}

/// Builds and traces random spheres.
pub fn of_spheres(spheres: u32, passes: usize) -> OfSpheres {
    let shapes = random_spheres(spheres).map(Shape::Sphere);
    let (scene, built) = timed(|| Scene::of_shapes("spheres", shapes));
    let mut hits = Hits::default();
    let mut traced = |rays: Vec<RawRay>| {
        let file = RayFile { question: Question::Closest, resolution: [0, 0], rays };
        let count = file.rays.len() as f64;
        let measured = measure(&scene, &file, Mode::Single, 1, Passes::Number(passes), &mut hits);
        (measured.per_cpu_second.under(1e9), measured.hits as f64 / count)
    };
    let (ns_per_camera_ray, hit) = traced(camera_rays());
    let (ns_per_random_ray, _) = traced(random_rays());
    OfSpheres { spheres, build_s: built.seconds, ns_per_camera_ray, ns_per_random_ray, hit }
}

/// Renders a scene in this size again and again.
///
/// # Errors
/// Where it can't be rendered.
pub fn of_size(scene: &Scene, threads: usize, passes: usize) -> Result<OfSize, RenderError> {
    let [width, height] = scene.camera.resolution;
    let pixels = f64::from(width) * f64::from(height);
    let settings = Settings { threads, ..Settings::whole(scene) };
    let once = || {
        let (rendered, lap) = timed(|| render(scene, &settings, |_| (), &AtomicBool::new(false)));
        rendered.map(|_| lap.seconds * 1e9 / pixels)
    };
    // One before it counts, which warms the caches up.
    once()?;
    let times = (0..passes).map(|_| once()).collect::<Result<_, _>>()?;
    Ok(OfSize { width, height, ns_per_pixel: Spread::of(times) })
}

/// The rays of a square picture of the unit cube from outside, row by row.
fn camera_rays() -> Vec<RawRay> {
    let eye = DVec3::new(1.1, 0.9, 1.5);
    let ahead = DVec3::splat(0.5) - eye;
    let right = ahead.cross(DVec3::Y);
    let up = right.cross(ahead) / ahead.length();
    let side = |k: u32| (f64::from(k) + 0.5) / f64::from(RAYS_A_SIDE) - 0.5;
    let ray = |x: u32, y: u32| raw(eye, ahead + right * side(x) - up * side(y));
    (0..RAYS_A_SIDE).flat_map(|y| (0..RAYS_A_SIDE).map(move |x| ray(x, y))).collect()
}

/// As many rays from points of the cube toward others.
fn random_rays() -> Vec<RawRay> {
    let point = |number: u32| {
        DVec3::from_array([0, 1, 2].map(|axis| unit(hash(u64::from(RAYS_A_SIDE), u64::from(number) * 3 + axis))))
    };
    let ray = |number: u32| raw(point(2 * number), point(2 * number + 1) - point(2 * number));
    (0..RAYS_A_SIDE * RAYS_A_SIDE).map(ray).collect()
}

fn raw(origin: DVec3, direction: DVec3) -> RawRay {
    let single = |vector: DVec3| vector.to_array().map(|x| x as f32);
    let unit = direction / direction.length();
    RawRay { origin: single(origin), t_min: 0.0, direction: single(unit), t_max: f32::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn most_rays_meet_many_spheres() {
        let measured = of_spheres(1000, 1);
        assert!(measured.hit > 0.3 && measured.hit < 1.0, "{}", measured.hit);
        assert_eq!(measured.spheres, 1000);
        assert!(random_rays().iter().all(|ray| ray.direction.iter().all(|x| x.is_finite())));
    }
}
