//! How good the methods are for the rays that they take: no bias, the promised interval, less error for fewer rays, and
//! nothing lost.

use crate::edges::{Shape, camera_rays, coverage, picture, red, scene};
use crate::support;
use raywalk::scene::{Guided, Sampling, Scene, Statistical};

const SEEDS: u64 = 100;

/// Edges of every kind: nearly level, steep, aligned, round.
const SHAPES: [Shape; 4] = [
    Shape::HalfPlane { nx: 0.1, ny: 0.994_987_437_106_62, d: 0.33 },
    Shape::HalfPlane { nx: 0.8, ny: -0.6, d: -2.41 },
    Shape::HalfPlane { nx: 1.0, ny: 0.0, d: 3.27 },
    Shape::Disc { x: 0.37, y: -0.21, radius: 11.3 },
];

/// The means and the squared standard errors of each pixel over the seeds.
fn over_seeds(shape: Shape, sampling: Sampling) -> Vec<[f64; 2]> {
    let mut scene = scene(shape, sampling);
    let mut sums = vec![[0.0; 2]; coverage(shape).len()];
    for seed in 0..SEEDS {
        scene.seed = seed;
        for (sum, value) in sums.iter_mut().zip(red(&picture(&scene))) {
            *sum = [sum[0] + value, sum[1] + value * value];
        }
    }
    let n = SEEDS as f64;
    let moments = |[sum, squares]: [f64; 2]| [sum / n, (squares - sum * sum / n).max(0.0) / (n - 1.0) / n];
    sums.into_iter().map(moments).collect()
}

/// The sum of z² over the pixels that an edge crosses well is that of unbiased means, at four standard deviations. With
/// 100 seeds z is Student's t of 99 degrees of freedom: z² has the mean 99/97 and less than 2.3 for its variance.
#[track_caller]
fn assert_unbiased(shape: Shape, sampling: Sampling, crossed: impl Fn(f64) -> bool) {
    let (mut sum, mut count) = (0.0, 0.0);
    for ([mean, variance], exact) in over_seeds(shape, sampling).into_iter().zip(coverage(shape)) {
        if crossed(exact) {
            assert!(variance > 0.0, "{sampling:?}, {shape:?}: a pixel with {exact} never changes");
            sum += (mean - exact) * (mean - exact) / variance;
            count += 1.0;
        } else if exact == 0.0 || exact == 1.0 {
            assert_eq!(mean, exact);
        }
    }
    assert!(count >= 15.0, "{count} pixels");
    let deviation = (sum - count * 99.0 / 97.0) / libm::sqrt(2.3 * count);
    assert!(deviation.abs() < 4.0, "{sampling:?}, {shape:?}: {deviation} standard deviations, {count} pixels");
}

#[test]
fn stochastic_methods_have_no_bias() {
    for sampling in [
        Sampling::Stochastic { n: 1 },
        Sampling::Stochastic { n: 4 },
        Sampling::Stochastic { n: 7 },
        Sampling::Random { n: 4 },
        Sampling::Sobol { n: 4 },
        Sampling::Sobol { n: 7 },
        Sampling::Guided(Guided { tolerance: 0.01, min: 2, max: 64 }),
        Sampling::Guided(Guided { tolerance: 0.01, min: 4, max: 64 }),
    ] {
        for shape in SHAPES {
            // Where nearly every seed gives the same, 100 of them are too few for a normal distribution.
            assert_unbiased(shape, sampling, |exact| (0.15..=0.85).contains(&exact));
        }
    }
}

/// Statistical sampling stops when it likes what it sees, so that a pixel keeps a small bias: within the tolerance, and
/// over the pixels of an edge, where what is lost and what is gained meet, a tenth of it.
#[test]
fn the_bias_of_statistical_sampling_is_within_its_tolerance() {
    let sampling = Sampling::Statistical(Statistical { confidence: 0.95, tolerance: 0.05, min: 8, max: 4096 });
    for shape in SHAPES {
        let bias = |([mean, _], exact): ([f64; 2], &f64)| mean - exact;
        let exact = coverage(shape);
        let biases: Vec<_> = over_seeds(shape, sampling).into_iter().zip(&exact).map(bias).collect();
        let crossed = exact.iter().filter(|part| **part > 0.0 && **part < 1.0).count() as f64;
        let worst = biases.iter().fold(0.0_f64, |worst, bias| worst.max(bias.abs()));
        let mean = biases.iter().sum::<f64>() / crossed;
        println!("{shape:?}: bias of a crossed pixel {mean:.4} in the mean, {worst:.4} at the worst");
        assert!(worst <= 0.05, "{shape:?}: {worst}");
        assert!(mean.abs() <= 0.005, "{shape:?}: {mean}");
    }
}

/// A pixel that took more samples where its own first ones meet a small bright object would lose most of its light: with a say of its own in how
/// many follow a pilot of two kept 0.13 of the light of a dot that covers a tenth of a pixel. Four standard errors of the picture's sum.
#[test]
fn guided_sampling_keeps_the_light_of_small_objects() {
    for (number, radius) in (0..).zip([0.1, 0.18, 0.3, 0.45]) {
        for min in [2, 4, 8] {
            let place = f64::from(number) * 0.37;
            let shape = Shape::Disc { x: 2.41 + place, y: 1.13 - place, radius };
            let sampling = Sampling::Guided(Guided { tolerance: 0.002, min, max: 256 });
            let pixels = over_seeds(shape, sampling);
            let [sum, variance] =
                pixels.iter().fold([0.0; 2], |sums, [mean, variance]| [sums[0] + mean, sums[1] + variance]);
            let exact: f64 = coverage(shape).iter().sum();
            println!("{radius} of a pixel, from {min}: {:.2} of the light", sum / exact);
            assert!((sum - exact).abs() < 4.0 * variance.sqrt(), "{radius}, from {min}: {sum} of {exact}, {variance}");
        }
    }
}

#[test]
fn the_interval_holds_what_it_promises() {
    let sampling = Sampling::Statistical(Statistical { confidence: 0.95, tolerance: 0.05, min: 8, max: 4096 });
    let (mut crossed, mut held, mut all, mut all_held, mut rays) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for shape in SHAPES {
        let mut scene = scene(shape, sampling);
        let exact = coverage(shape);
        let (mut own, mut own_held) = (0.0, 0.0);
        for seed in 0..20 {
            scene.seed = seed;
            let rendered = picture(&scene);
            rays += camera_rays(&rendered) as f64;
            for (found, exact) in red(&rendered).into_iter().zip(&exact) {
                let is_held = f64::from((found - exact).abs() <= 0.05);
                all += 1.0;
                all_held += is_held;
                if *exact > 0.0 && *exact < 1.0 {
                    own += 1.0;
                    own_held += is_held;
                }
            }
        }
        println!("{shape:?}: {:.4} of {own} crossed", own_held / own);
        crossed += own;
        held += own_held;
    }
    println!("crossed {:.4}, all {:.4}, rays a pixel {:.1}", held / crossed, all_held / all, rays / all);
    assert!(held / crossed >= 0.88, "{} of the crossed pixels", held / crossed);
    assert!(all_held / all >= 0.99, "{} of all pixels", all_held / all);
}

const FIGURES: [&str; 5] = ["figure-16", "figure-17", "figure-18", "figure-19", "figure-20"];

fn figure(name: &str, sampling: Sampling) -> Scene {
    Scene { sampling, ..support::scene(name) }
}

/// The root of the mean square error against a picture of a great many samples, over some seeds, and the rays per pixel.
fn measure(name: &str, sampling: Sampling, exact: &[f64], seeds: u64) -> [f64; 2] {
    let mut scene = figure(name, sampling);
    let (mut squares, mut rays) = (0.0, 0.0);
    for seed in 1..=seeds {
        scene.seed = seed;
        let rendered = picture(&scene);
        rays += camera_rays(&rendered) as f64;
        let error = |(found, exact): (f64, &f64)| (found - exact) * (found - exact);
        squares += red(&rendered).into_iter().zip(exact).map(error).sum::<f64>();
    }
    let pixels = (seeds * exact.len() as u64) as f64;
    [libm::sqrt(squares / pixels), rays / pixels]
}

#[test]
fn adaptive_and_statistical_sampling_save_rays() {
    for name in FIGURES {
        let exact = red(&picture(&figure(name, Sampling::Sobol { n: 4096 })));
        let adaptive = Sampling::Adaptive { threshold: 0.02, depth: 4 };
        let statistical = Statistical { confidence: 0.9, tolerance: 0.1, min: 8, max: 256 };
        for (sampling, reference, seeds) in [
            (adaptive, Sampling::Regular { n: 8 }, 1),
            (Sampling::Statistical(statistical), Sampling::Random { n: 64 }, 4),
        ] {
            let [error, rays] = measure(name, sampling, &exact, seeds);
            let [allowed, all_rays] = measure(name, reference, &exact, seeds);
            println!(
                "{name}: {} {error:.5}, {rays:.2} rays; {} {allowed:.5}, {all_rays}",
                sampling.key(),
                reference.key()
            );
            assert!(error <= allowed, "{name}, {sampling:?}: {error} > {allowed}");
            assert!(rays <= 0.35 * all_rays, "{name}, {sampling:?}: {rays} rays of {all_rays}");
        }
    }
}

/// The parts of figure 19's picture in which its objects lie, by columns.
const OBJECTS_OF_FIGURE_19: [(&str, std::ops::Range<usize>); 4] =
    [("A", 7..10), ("C", 13..16), ("B", 19..23), ("D", 28..32)];

fn found(sampling: Sampling) -> Vec<&'static str> {
    let scene = figure("figure-19", sampling);
    let pixels = red(&picture(&scene));
    let is_bright = |columns: &std::ops::Range<usize>| {
        (0..32).any(|row: usize| columns.clone().any(|column| pixels[row * 48 + column] > 0.1 + 1e-9))
    };
    OBJECTS_OF_FIGURE_19.iter().filter(|(_, columns)| is_bright(columns)).map(|(name, _)| *name).collect()
}

#[test]
fn nothing_small_is_lost_by_adaptive_sampling() {
    assert_eq!(found(Sampling::Center {}), ["A", "C"], "B and D are lost between the centres");
    for depth in 3..6 {
        assert_eq!(found(Sampling::Adaptive { threshold: 0.05, depth }), ["A", "C", "B", "D"], "depth {depth}");
    }
    // Without the rule for small objects the corners alone would lose some.
    assert_ne!(found(Sampling::Shared { n: 1 }).len(), 4);
}

/// Without edges the points that are spread best win by a power of their number.
#[test]
fn sobol_beats_strata_and_strata_beat_chance_where_pixels_are_smooth() {
    let floor = include_bytes!("../support/smooth-floor.json").as_slice();
    let ball = include_bytes!("../support/smooth-ball.json").as_slice();
    for (name, text) in [("smooth-floor", floor), ("smooth-ball", ball)] {
        let scene = support::scene_of(text, name);
        let of = |sampling, seed| red(&picture(&Scene { sampling, seed, ..scene.clone() }));
        let exact = of(Sampling::Sobol { n: 1 << 12 }, 99);
        let error = |sampling| {
            let square = |(found, exact): (f64, &f64)| (found - exact) * (found - exact);
            let squares =
                (0..4).flat_map(|seed| of(sampling, seed).into_iter().zip(&exact).map(square).collect::<Vec<_>>());
            libm::sqrt(squares.sum::<f64>() / 4.0 / exact.len() as f64)
        };
        let [sobol, stochastic, random] =
            [Sampling::Sobol { n: 64 }, Sampling::Stochastic { n: 64 }, Sampling::Random { n: 64 }].map(error);
        println!("{name}: sobol {sobol:.2e}, stochastic {stochastic:.2e}, random {random:.2e}");
        assert!(sobol < 0.8 * stochastic && stochastic < 0.8 * random, "{name}: {sobol}, {stochastic}, {random}");
    }
}
