//! A picture that is coarse at first and grows finer, with what else is known of its pixels.

use super::layers::{Planes, Watched};
use crate::log::{Name, RayKind, Step};
use crate::probe::{Erased, Probe, Quantity};
use crate::record::{Arithmetic, Computation, Pixel};
use crate::sampling;
use crate::scene::{Color, Scene};
use crate::threads::{Threads, wanted};
use glam::DVec3;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// What is known of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Its colour, bit for bit as [`render`](super::render) has it.
    pub color: Color,
    /// The distance from the eye to the first point that a camera ray of the pixel hits.
    pub depth: Option<f64>,
    /// How many rays it took.
    pub rays: u32,
    /// How many samples; 1 where the pixel has its one ray only.
    pub samples: u32,
}

/// The dot of a pixel.
pub fn dot(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic) -> Dot {
    let (color, gauge) = arithmetic.run(PreviewProbe::default(), Pixel { scene, pixel });
    let depth = gauge.first_hit.map(|point| (point - scene.camera.position()).length());
    Dot { color, depth, rays: gauge.rays, samples: gauge.samples.max(1) }
}

/// What one ray through the middle of a pixel says of it, where the pixel has more: its colour until the others are traced.
pub fn rough_dot(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic) -> Dot {
    let (color, gauge) = arithmetic.run(PreviewProbe::default(), Center(Pixel { scene, pixel }));
    let depth = gauge.first_hit.map(|point| (point - scene.camera.position()).length());
    Dot { color, depth, rays: gauge.rays, samples: 1 }
}

/// The dot of a pixel with the numbers of planes; what one ray through its middle says of it, if it is rough.
pub fn named_dot(
    scene: &Scene,
    pixel: [u32; 2],
    arithmetic: Arithmetic,
    planes: &Planes,
    is_rough: bool,
) -> (Dot, Vec<f64>) {
    let mut watched = Watched::new(PreviewProbe::default(), planes);
    let (erased, pixel) = (Erased::of(&mut watched), Pixel { scene, pixel });
    let color = match is_rough {
        true => arithmetic.run(erased, Center(pixel)).0,
        false => arithmetic.run(erased, pixel).0,
    };
    let (gauge, numbers) = watched.finish();
    let depth = gauge.first_hit.map(|point| (point - scene.camera.position()).length());
    (Dot { color, depth, rays: gauge.rays, samples: gauge.samples.max(1) }, numbers)
}

/// The computation of one ray of a pixel.
#[derive(Clone, Copy)]
struct Center<'s>(Pixel<'s>);

impl Computation for Center<'_> {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        sampling::through_center(self.0.scene, self.0.pixel, probe)
    }

    fn pixel(&self) -> [u32; 2] {
        self.0.pixel
    }
}

/// The dots of these pixels, in their order.
pub fn dots(scene: &Scene, pixels: Vec<[u32; 2]>, arithmetic: Arithmetic) -> Vec<Dot> {
    all_dots(pixels, |pixel| dot(scene, pixel, arithmetic))
}

/// Something of these pixels, in their order.
pub fn all_dots<T: Send>(pixels: Vec<[u32; 2]>, of_pixel: impl Fn([u32; 2]) -> T + Sync + Send) -> Vec<T> {
    Threads::of(wanted(), pixels.len()).run(|| pixels.into_par_iter().map(of_pixel).collect())
}

/// By how much single precision misses the colour of a pixel, in the worst channel.
pub fn error_of_single(scene: &Scene, pixel: [u32; 2], color: Color) -> f64 {
    (Arithmetic::F32.color(Pixel { scene, pixel }) - color).abs().max_element()
}

/// Computes something for the dots of a grid of pixels, every `step`-th of each row and column, in passes that halve their
/// distance, the first with every 2^`coarsest`-th dot. `publish` is handed the dots of a few rows at a time, by column and row of
/// the grid. Returns early when it is to stop.
pub fn in_passes<T: Send>(
    [columns, rows]: [u32; 2],
    coarsest: u32,
    of_dot: impl Fn([u32; 2]) -> T + Sync,
    mut publish: impl FnMut(Vec<([u32; 2], T)>),
    stop: &AtomicBool,
) {
    let threads = Threads::of(wanted(), columns as usize * rows as usize);
    for coarse in (0..=coarsest).rev() {
        let distance = 1 << coarse;
        let is_new =
            |[column, row]: &[u32; 2]| coarse == coarsest || column % (2 * distance) != 0 || row % (2 * distance) != 0;
        let mut row = 0;
        while row < rows {
            // So many dots at a time that threads have work, and few enough to show soon.
            let end = rows.min(row + distance * (DOTS_AT_ONCE / columns.div_ceil(distance)).max(1));
            let grid = (row..end)
                .step_by(distance as usize)
                .flat_map(|row| (0..columns).step_by(distance as usize).map(move |column| [column, row]));
            let places: Vec<[u32; 2]> = grid.filter(is_new).collect();
            let of_place = |place: [u32; 2]| (!stop.load(Ordering::Relaxed)).then(|| (place, of_dot(place)));
            let Some(dots) = threads.run(|| places.into_par_iter().map(of_place).collect::<Option<Vec<_>>>()) else {
                return;
            };
            publish(dots);
            row = end;
        }
    }
}

const DOTS_AT_ONCE: u32 = 2048;

/// Counts rays and samples, and keeps the first hit point of a camera ray.
#[derive(Clone, Debug, Default)]
struct PreviewProbe {
    rays: u32,
    samples: u32,
    level: u32,
    first_hit: Option<DVec3>,
}

impl Probe for PreviewProbe {
    fn enter(&mut self, step: Step) {
        match step {
            Step::Ray { kind, .. } => {
                self.rays = self.rays.saturating_add(1);
                self.level = if kind == RayKind::Camera { 0 } else { self.level + 1 };
            }
            Step::Sample { .. } => self.samples = self.samples.saturating_add(1),
            _ => {}
        }
    }

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        if self.first_hit.is_none()
            && self.level == 0
            && name.is(Name::HitPoint)
            && let crate::log::Value::Triple(point) = value.value()
        {
            self.first_hit = Some(DVec3::from(point));
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::pixel_color;
    use crate::scene::{build, builtin, file};
    use std::collections::BTreeSet;

    fn scene(name: &str) -> Scene {
        let text = builtin::text(name).unwrap_or_default();
        let loaded = file::check(text.as_bytes(), name).unwrap_or_else(|error| panic!("{}", error.report(false)));
        build(&loaded.scene, &Default::default()).unwrap_or_else(|unsupported| panic!("{unsupported}"))
    }

    /// The first look at a pixel of many samples is what one ray through its middle says.
    #[test]
    fn a_rough_dot_is_one_ray_through_the_middle() {
        let one = scene("textbook");
        let many = Scene { sampling: crate::scene::Sampling::Regular { n: 4 }, ..scene("textbook") };
        let pixel = [80, 60];
        let rough = rough_dot(&many, pixel, Arithmetic::F64);
        assert_eq!(rough, dot(&one, pixel, Arithmetic::F64));
        let whole = dot(&many, pixel, Arithmetic::F64);
        assert_eq!((rough.samples, whole.samples), (1, 16));
        assert_eq!(dots(&many, vec![pixel, [0, 0]], Arithmetic::F64)[0], whole);
    }

    #[test]
    fn a_dot_has_the_colour_of_its_pixel() {
        let scene = scene("textbook");
        for pixel in [[160, 120], [0, 0], [200, 140]] {
            assert_eq!(dot(&scene, pixel, Arithmetic::F64).color, pixel_color(&scene, pixel, Arithmetic::F64));
        }
        // The numeric example: a camera ray, a reflected one, and a shadow ray from each of two points.
        let middle = dot(&scene, [160, 120], Arithmetic::F64);
        assert_eq!((middle.rays, middle.samples), (4, 1));
        // From (16, 2, 7) to (4, 6, 8).
        assert_eq!(middle.depth, Some(161.0_f64.sqrt()));
        assert!(error_of_single(&scene, [160, 120], middle.color) < 1e-3);
    }

    #[test]
    fn passes_have_every_dot_once() {
        for size in [[1, 1], [5, 3], [33, 70], [64, 64]] {
            let mut seen = BTreeSet::new();
            let publish = |dots: Vec<([u32; 2], u32)>| {
                for ([column, row], value) in dots {
                    assert_eq!(value, column * 1000 + row);
                    assert!(seen.insert([column, row]), "{column},{row} twice");
                }
            };
            in_passes(size, 5, |[column, row]| column * 1000 + row, publish, &AtomicBool::new(false));
            assert_eq!(seen.len() as u32, size[0] * size[1]);
        }
    }

    #[test]
    fn what_is_stopped_publishes_nothing() {
        in_passes([9, 9], 2, |_| (), |_| panic!("published"), &AtomicBool::new(true));
    }
}
