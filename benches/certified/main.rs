//! What certainty costs: pictures as they are made, against the same in f64 alone, whatever it leaves in doubt.
//!
//! Two sides are told from the program: `plain` never asks for more digits than f64 has; `naive` meets its spheres by the formulas of
//! the source text besides.
//!
//! ```text
//! cargo bench --bench certified
//! ```

use raywalk::geometry::shape::SphereMethod;
use raywalk::probe::{Probe, Silent};
use raywalk::sampling;

use raywalk::files::Source;
use raywalk::scene::file::{self, mesh};
use raywalk::scene::{Sampling, Scene, build, builtin, generate};
use std::hint::black_box;
use support::{Extent, Pairs, Uncertified, instructions};

/// The size of the pictures.
const SIZE: [u32; 2] = [80, 60];

/// The most that it may cost.
const ALLOWED: f64 = 1.15;

/// Ordinary scenes: the numeric example, many mirrors and shadows, every shape, glass, triangles, thousands of spheres.
const SCENES: [&str; 6] = ["textbook", "figure-6", "table-top", "glass-and-mirror", "mesh", "flake"];

fn main() {
    let arguments: Vec<_> = std::env::args().collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        // How the bench calls itself to have its instructions counted.
        [_, "--run", _, side, scene] => run(side, &Contest::new(scene)),
        _ => SCENES.into_iter().for_each(|name| report(name, Extent::asked())),
    }
}

fn report(name: &str, extent: Extent) {
    let contest = Contest::new(name);
    println!("{name}, {} x {} pixels", SIZE[0], SIZE[1]);
    let is_counted = extent == Extent::Whole;
    let counts = is_counted.then(|| instructions("picture", ["certified", "plain", "naive"], name)).flatten();
    let certified = || picture(&contest.scene, &mut Silent);
    for (number, side) in ["plain", "naive"].into_iter().enumerate() {
        let pairs = Pairs::timed(extent, certified, || run(side, &contest));
        let [ratio, lower, upper] = pairs.ratio();
        let verdict = if ratio <= ALLOWED { "within" } else { "ABOVE" };
        println!("  against {side}: median times {:.2?} and {:.2?}", pairs.one, pairs.other);
        println!("    ratio of times {ratio:.4} (quartiles {lower:.4} and {upper:.4}), {verdict} {ALLOWED}");
        match counts {
            Some(counts) => println!("    ratio of instructions {:.4}", counts[0] as f64 / counts[number + 1] as f64),
            None if is_counted => println!("    instructions not counted: valgrind can't be run"),
            None => {}
        }
    }
}

/// A scene, and the same with the formulas of the source text.
struct Contest {
    scene: Scene,
    geometric: Scene,
}

impl Contest {
    fn new(name: &str) -> Contest {
        let text = match name {
            "flake" => {
                let mut text = Vec::new();
                generate::sphere_flake(4, &mut text).unwrap_or_else(|error| panic!("{error}"));
                text
            }
            _ => builtin::text(name).unwrap_or_else(|| panic!("no scene `{name}`")).as_bytes().to_vec(),
        };
        let scene = |method: SphereMethod| {
            let loaded = file::check(&text, name).map_err(|error| error.report(false));
            let mut file = loaded.unwrap_or_else(|report| panic!("{report}")).scene;
            file.camera.resolution = SIZE;
            file.tracing.sphere_method = Some(method);
            let source = Source { name, text: &text };
            let meshes = mesh::load(&file, &source, mesh::Folder::BuiltIn(builtin::mesh));
            let (meshes, _) = meshes.unwrap_or_else(|error| panic!("{}", error.report(false)));
            let scene = build(&file, &meshes).unwrap_or_else(|unsupported| panic!("{unsupported}"));
            Scene { sampling: Sampling::Center {}, ..scene }
        };
        Contest { scene: scene(SphereMethod::Robust), geometric: scene(SphereMethod::Geometric) }
    }
}

fn run(side: &str, contest: &Contest) {
    match side {
        "certified" => picture(&contest.scene, &mut Silent),
        "plain" => picture(&contest.scene, &mut Uncertified),
        "naive" => picture(&contest.geometric, &mut Uncertified),
        _ => {}
    }
}

fn picture(scene: &Scene, probe: &mut impl Probe) {
    let [width, height] = scene.camera.resolution;
    for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
        black_box(sampling::pixel(scene, black_box(pixel), probe));
    }
}
