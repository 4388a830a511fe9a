//! How fast each method of sampling comes near the picture: the root of the mean square error against the rays per pixel.
//!
//! ```text
//! cargo bench --bench convergence
//! ```

use raywalk::render::{Settings, render};
use raywalk::scene::{Guided, Sampling, Scene, Statistical, build, builtin, file};
use std::sync::atomic::AtomicBool;
use support::Extent;

/// The samples of the pictures that count as exact.
const EXACT: u32 = 1 << 14;

/// Over how many seeds errors are taken.
const SEEDS: u64 = 8;

fn main() {
    let (exact, seeds) = match Extent::asked() {
        Extent::Whole => (EXACT, SEEDS),
        Extent::Short => (16, 1),
    };
    for (name, scene) in scenes() {
        let reference = picture(&scene, Sampling::Sobol { n: exact }, 1 << 20).0;
        println!("{name}, {} pixels", reference.len());
        println!("  {:<56} {:>9} {:>10}", "method", "rays/px", "RMSE");
        for sampling in methods() {
            let runs: Vec<_> = (0..seeds).map(|seed| picture(&scene, sampling, seed)).collect();
            let rays: u64 = runs.iter().map(|(_, rays)| rays).sum();
            let squares = runs.iter().flat_map(|(pixels, _)| pixels.iter().zip(&reference));
            let square: f64 = squares.map(|(found, exact)| (found - exact) * (found - exact)).sum();
            let pixels = (runs.len() * reference.len()) as f64;
            println!(
                "  {:<56} {:>9.2} {:>10.2e}",
                sampling.to_string(),
                rays as f64 / pixels,
                (square / pixels).sqrt()
            );
        }
    }
}

/// Two scenes of edges, two of smooth pixels.
fn scenes() -> Vec<(&'static str, Scene)> {
    let figure = |name| (name, scene(builtin::text(name).unwrap_or_default(), name));
    vec![
        figure("figure-16"),
        figure("figure-17"),
        ("smooth-floor", scene(include_str!("../tests/support/smooth-floor.json"), "smooth-floor")),
        ("smooth-ball", scene(include_str!("../tests/support/smooth-ball.json"), "smooth-ball")),
    ]
}

fn scene(text: &str, name: &str) -> Scene {
    let loaded = file::check(text.as_bytes(), name).expect("a good scene of our own");
    build(&loaded.scene, &Default::default()).expect("a supported scene of our own")
}

fn methods() -> Vec<Sampling> {
    let mut methods = vec![Sampling::Center {}];
    for n in [4, 16, 64, 256] {
        let side = f64::from(n).sqrt() as u32;
        methods.extend([Sampling::Regular { n: side }, Sampling::Shared { n: side }]);
        methods.extend([Sampling::Random { n }, Sampling::Stochastic { n }, Sampling::Sobol { n }]);
    }
    methods.extend([2, 3, 4].map(|depth| Sampling::Adaptive { threshold: 0.02, depth }));
    let statistical = |tolerance| Statistical { confidence: 0.95, tolerance, min: 8, max: 4096 };
    methods.extend([0.1, 0.05, 0.02].map(|tolerance| Sampling::Statistical(statistical(tolerance))));
    let guided = |tolerance| Guided { tolerance, min: 4, max: 4096 };
    methods.extend([0.02, 0.005, 0.001].map(|tolerance| Sampling::Guided(guided(tolerance))));
    methods
}

/// The red of each pixel, and the camera rays.
fn picture(scene: &Scene, sampling: Sampling, seed: u64) -> (Vec<f64>, u64) {
    let scene = Scene { sampling, seed, ..scene.clone() };
    let settings = Settings { counts_rays: true, ..Settings::whole(&scene) };
    let rendered = render(&scene, &settings, |_| (), &AtomicBool::new(false)).expect("a picture that fits into memory");
    let statistics = rendered.counts.map(|counts| counts.statistics(0, Default::default(), 0));
    let rays = statistics.map_or(0, |statistics| statistics.samples);
    (rendered.film.pixels().iter().map(|color| color.x).collect(), rays)
}
