//! What the silent probe costs: the program against the same written by hand without any probe.
//!
//! Two contests. The *kernels* meet the objects of a scene with the camera's rays: this is what the probe may cost at
//! most 2 % of. The whole *picture* is traced by a tracer of planes and spheres that knows nothing of the program's other
//! shapes, tree and interpolated normals: what it saves by that is shown too, but isn't the probe's.
//!
//! Both sides must first give the same bits, so the program's asks for no more digits than f64 has: what those cost is measured by
//! the bench `certified`. The same bits take the same operations in the same order: where the program gets a better formula, the
//! yardstick fails until it has it, too. That is how it is meant, since a contest of different formulas says nothing of the probe.
//!
//! Then they are timed in pairs, and their instructions are counted, which don't depend on the machine's mood (`support/lib.rs`).
//!
//! ```text
//! cargo bench --bench silent
//! ```

mod yardstick;

use glam::DVec3;
use raywalk::geometry::Ray;
use raywalk::geometry::shape::{Approach, Kernel, Shape};
use raywalk::probe::Silent;
use raywalk::sampling;
use raywalk::scene::{Scene, build, builtin, file};
use std::hint::black_box;
use support::{Extent, Pairs, Uncertified, instructions};
use yardstick::Yardstick;
use yardstick::shapes::{Meet, Ray as RayByHand, Shape as ByHand};

/// The size of the pictures, small enough that their rays stay in the cache: memory isn't what is compared.
const SIZE: [u32; 2] = [80, 60];

/// How often the work is done to be timed once.
const ROUNDS: usize = 16;

/// The most that the silent probe may cost.
const ALLOWED: f64 = 1.02;

fn main() {
    let arguments: Vec<_> = std::env::args().collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        // How the bench calls itself to have its instructions counted.
        [_, "--run", work, side, scene] => run(work, side, &Contest::new(scene, SIZE)),
        _ => scenes().for_each(|scene| report(scene, Extent::asked())),
    }
}

/// The scenes of the contest: the numeric example, and glass in a room with every kind of light.
fn scenes() -> impl Iterator<Item = &'static str> {
    ["textbook", "glass"].into_iter()
}

fn report(scene: &str, extent: Extent) {
    let contest = Contest::new(scene, SIZE);
    contest.assert_same_bits();
    println!("{scene}, {} × {} camera rays, {ROUNDS} rounds; the same bits everywhere", SIZE[0], SIZE[1]);
    for work in [Work::Kernels, Work::Picture] {
        let pairs = contest.times(work, extent);
        let [ratio, lower, upper] = pairs.ratio();
        let verdict = match work {
            Work::Kernels if ratio <= ALLOWED => format!(", within {ALLOWED}"),
            Work::Kernels => format!(", ABOVE {ALLOWED}"),
            Work::Picture => String::new(),
        };
        println!("  {work:?}: median time silent {:.2?}, by hand {:.2?}", pairs.one, pairs.other);
        println!(
            "    ratio of times {ratio:.4} (quartiles {lower:.4} and {upper:.4} of {} pairs){verdict}",
            extent.pairs()
        );
        if extent == Extent::Short {
            continue;
        }
        match instructions(&format!("{work:?}"), ["silent", "by_hand"], scene) {
            Some([silent, by_hand]) => {
                let ratio = silent as f64 / by_hand as f64;
                println!("    ratio of instructions {ratio:.4} (silent {silent}, by hand {by_hand})");
            }
            None => println!("    instructions not counted: valgrind can't be run"),
        }
    }
}

/// What is done.
#[derive(Clone, Copy, Debug)]
enum Work {
    /// Each object is met by each camera ray, and its surface is found where it is.
    Kernels,
    /// A picture is traced.
    Picture,
}

/// The two sides on one scene.
struct Contest {
    scene: Scene,
    yardstick: Yardstick,
    rays: Vec<Ray>,
    rays_by_hand: Vec<RayByHand>,
}

impl Contest {
    fn new(scene: &str, resolution: [u32; 2]) -> Contest {
        let text = if scene == "glass" { Some(include_str!("glass.json")) } else { builtin::text(scene) };
        let text = text.unwrap_or_else(|| panic!("no scene `{scene}`"));
        let loaded = file::check(text.as_bytes(), scene).map_err(|error| error.report(false));
        let mut file = loaded.unwrap_or_else(|report| panic!("{report}")).scene;
        file.camera.resolution = resolution;
        let scene = build(&file, &Default::default()).unwrap_or_else(|unsupported| panic!("{unsupported}"));
        let center = |[column, row]: [u32; 2]| [f64::from(column) + 0.5, f64::from(row) + 0.5];
        let rays: Vec<_> =
            pixels(resolution).filter_map(|pixel| scene.camera.ray(center(pixel), &mut Silent)).collect();
        let by_hand = |ray: &Ray| RayByHand {
            origin: ray.origin,
            direction: ray.direction,
            from: None,
            start: ray.t_min,
            end: ray.t_max,
            slack: ray.slack,
        };
        Contest { rays_by_hand: rays.iter().map(by_hand).collect(), rays, yardstick: Yardstick::new(&file), scene }
    }

    /// Does the work with the program's code and shows `see` what comes out.
    fn silent(&self, work: Work, mut see: impl FnMut(DVec3)) {
        match work {
            Work::Kernels => {
                for object in &self.scene.objects {
                    match &object.shape {
                        Shape::Plane(plane) => self.meet(plane, object.one_sided, &mut see),
                        Shape::Sphere(sphere) => self.meet(sphere, object.one_sided, &mut see),
                        _ => {}
                    }
                }
            }
            Work::Picture => {
                for pixel in pixels(self.scene.camera.resolution) {
                    see(sampling::pixel(&self.scene, black_box(pixel), &mut Uncertified));
                }
            }
        }
    }

    fn meet(&self, kernel: &impl Kernel, one_sided: bool, see: &mut impl FnMut(DVec3)) {
        let approach = black_box(Approach { leaving: None, one_sided });
        for ray in black_box(&self.rays) {
            if let Some((point, normal)) = hit(kernel, ray, approach) {
                see(point);
                see(normal);
            }
        }
    }

    /// Does the work with the yardstick's code and shows `see` what comes out.
    fn by_hand(&self, work: Work, mut see: impl FnMut(DVec3)) {
        match work {
            Work::Kernels => {
                for object in &self.yardstick.objects {
                    match &object.shape {
                        ByHand::Plane(plane) => self.meet_by_hand(plane, object.is_one_sided, &mut see),
                        ByHand::Sphere(sphere) => self.meet_by_hand(sphere, object.is_one_sided, &mut see),
                    }
                }
            }
            Work::Picture => {
                for pixel in pixels(self.scene.camera.resolution) {
                    see(self.yardstick.pixel(black_box(pixel)));
                }
            }
        }
    }

    fn meet_by_hand(&self, shape: &impl Meet, is_one_sided: bool, see: &mut impl FnMut(DVec3)) {
        let (leaves, is_one_sided) = black_box((false, is_one_sided));
        for ray in black_box(&self.rays_by_hand) {
            if let Some((point, normal)) = hit_by_hand(shape, ray, leaves, is_one_sided) {
                see(point);
                see(normal);
            }
        }
    }

    fn assert_same_bits(&self) {
        for work in [Work::Kernels, Work::Picture] {
            let (mut silent, mut by_hand) = (Vec::new(), Vec::new());
            self.silent(work, |value| silent.push(value));
            self.by_hand(work, |value| by_hand.push(value));
            assert!(!silent.is_empty() && silent.len() == by_hand.len(), "{work:?}: not the same hits");
            for (number, (silent, by_hand)) in silent.iter().zip(&by_hand).enumerate() {
                let bits = |value: &DVec3| value.to_array().map(f64::to_bits);
                let is_same = bits(silent) == bits(by_hand);
                assert!(is_same, "{work:?}: not the same bits in result {number}: {silent:?}, by hand {by_hand:?}");
            }
        }
    }

    /// The times of the one and of the other.
    fn times(&self, work: Work, extent: Extent) -> Pairs {
        let rounds = |round: &dyn Fn()| (0..ROUNDS).for_each(|_| round());
        Pairs::timed(
            extent,
            || rounds(&|| self.silent(work, |value| _ = black_box(value))),
            || rounds(&|| self.by_hand(work, |value| _ = black_box(value))),
        )
    }
}

/// A kernel, as one function.
#[inline(never)]
fn hit(kernel: &impl Kernel, ray: &Ray, approach: Approach) -> Option<(DVec3, DVec3)> {
    let crossing = kernel.first_crossing(ray, approach, &mut Uncertified)?;
    let surface = kernel.surface(ray, crossing, &mut Uncertified);
    Some((surface.point, surface.normal))
}

/// A kernel of the yardstick, as one function.
#[inline(never)]
fn hit_by_hand(shape: &impl Meet, ray: &RayByHand, leaves: bool, is_one_sided: bool) -> Option<(DVec3, DVec3)> {
    let crossing = shape.first_crossing(leaves, is_one_sided, ray)?;
    Some(shape.surface(ray, crossing))
}

fn pixels([width, height]: [u32; 2]) -> impl Iterator<Item = [u32; 2]> {
    (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
}

/// Does the work of one side, or everything but.
fn run(work: &str, side: &str, contest: &Contest) {
    let work = if work == "Kernels" { Work::Kernels } else { Work::Picture };
    match side {
        "silent" => contest.silent(work, |value| _ = black_box(value)),
        "by_hand" => contest.by_hand(work, |value| _ = black_box(value)),
        _ => {}
    }
}
