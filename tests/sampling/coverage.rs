//! How much of each pixel an edge covers, by every method, against the exact area.

use crate::edges::{SIDE, Shape, camera_rays, coverage, picture, red, scene};
use raywalk::scene::{Guided, Sampling, Statistical};

/// A half-plane whose edge rises by this part over 1.
fn slanted(slope: f64, d: f64) -> Shape {
    let length = libm::sqrt(1.0 + slope * slope);
    Shape::HalfPlane { nx: slope / length, ny: 1.0 / length, d }
}

const DISC: Shape = Shape::Disc { x: 0.37, y: -0.21, radius: 11.3 };

/// The errors of all pixels.
fn errors(shape: Shape, sampling: Sampling) -> Vec<f64> {
    red(&picture(&scene(shape, sampling))).iter().zip(coverage(shape)).map(|(found, exact)| found - exact).collect()
}

fn mean_square(errors: &[f64]) -> f64 {
    errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64
}

fn greatest(errors: &[f64]) -> f64 {
    errors.iter().fold(0.0, |greatest, error| greatest.max(error.abs()))
}

#[test]
fn the_exact_areas_add_up() {
    let disc: f64 = coverage(DISC).iter().sum();
    assert!((disc - std::f64::consts::PI * 11.3 * 11.3).abs() < 1e-9, "{disc}");
    let half: f64 = coverage(slanted(0.3, 0.0)).iter().sum();
    assert!((half - f64::from(SIDE * SIDE) / 2.0).abs() < 1e-9, "{half}");
    let small: f64 = coverage(Shape::Disc { x: 3.2, y: 1.9, radius: 0.3 }).iter().sum();
    assert!((small - std::f64::consts::PI * 0.09).abs() < 1e-12, "{small}");
}

#[test]
fn an_edge_on_the_grid_of_cells_is_exact() {
    for n in [1, 2, 4, 8] {
        for steps in [1, 3, 2 * n, 2 * n + 1] {
            let d = f64::from(steps) / f64::from(n);
            for (nx, ny) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)] {
                let errors = errors(Shape::HalfPlane { nx, ny, d }, Sampling::Regular { n });
                assert_eq!(greatest(&errors), 0.0, "n = {n}, edge at {d}");
            }
        }
    }
}

/// A column of cells is in or out: beside the grid the error is at most 1/(2n), and 1/(12n²) in the mean square over all
/// places of the edge. No slope does worse.
#[test]
fn the_square_error_of_a_regular_grid_falls_as_the_square_of_its_side() {
    for n in [1_u32, 2, 4, 8, 16] {
        let mut sum = 0.0;
        let places = 41;
        for k in 0..places {
            let d = 0.5 + f64::from(k) / (f64::from(places) * f64::from(n)) + 1e-6;
            let errors = errors(Shape::HalfPlane { nx: 1.0, ny: 0.0, d }, Sampling::Regular { n });
            assert!(greatest(&errors) <= 0.5 / f64::from(n) + 1e-9, "n = {n}, edge at {d}");
            // One column of pixels is crossed.
            sum += mean_square(&errors) * f64::from(SIDE);
        }
        let law = 1.0 / (12.0 * f64::from(n * n));
        let ratio = sum / f64::from(places) / law;
        assert!((0.9..1.1).contains(&ratio), "n = {n}: {ratio} of the law");
    }
    for shape in [slanted(0.3, 0.2), slanted(0.07, -1.3), DISC] {
        let crossed = coverage(shape).iter().filter(|part| **part > 0.0 && **part < 1.0).count() as f64;
        for n in [2_u32, 4, 8, 16] {
            let errors = errors(shape, Sampling::Regular { n });
            let of_crossed = mean_square(&errors) * errors.len() as f64 / crossed;
            assert!(of_crossed <= 1.1 / (12.0 * f64::from(n * n)), "{shape:?}, n = {n}: {of_crossed}");
        }
    }
}

#[test]
fn every_method_comes_near_the_exact_area() {
    let statistical = Statistical { confidence: 0.95, tolerance: 0.02, min: 16, max: 4096 };
    for (sampling, allowed) in [
        (Sampling::Regular { n: 16 }, 0.03),
        (Sampling::Shared { n: 16 }, 0.03),
        (Sampling::Adaptive { threshold: 0.0, depth: 5 }, 0.03),
        (Sampling::Stochastic { n: 256 }, 0.04),
        (Sampling::Random { n: 1024 }, 0.07),
        (Sampling::Sobol { n: 256 }, 0.03),
        // Where an edge cuts off a small part, the first 16 samples may agree by chance.
        (Sampling::Statistical(statistical), 0.1),
        (Sampling::Guided(Guided { tolerance: 1e-4, min: 4, max: 4096 }), 0.03),
    ] {
        for shape in [slanted(0.3, 0.2), DISC] {
            let errors = errors(shape, sampling);
            assert!(greatest(&errors) < allowed, "{sampling:?}, {shape:?}: {}", greatest(&errors));
        }
    }
}

/// Uniform pixels take the fewest samples, and shared corners are counted once.
#[test]
fn samples_are_counted() {
    let empty = Shape::Disc { x: 100.0, y: 0.0, radius: 1.0 };
    let statistical = Statistical { confidence: 0.95, tolerance: 0.02, min: 8, max: 64 };
    let pixels = u64::from(SIDE * SIDE);
    let corners = u64::from((SIDE + 1) * (SIDE + 1));
    for (sampling, rays) in [
        (Sampling::Center {}, pixels),
        (Sampling::Regular { n: 3 }, 9 * pixels),
        (Sampling::Shared { n: 1 }, corners),
        (Sampling::Adaptive { threshold: 0.1, depth: 4 }, corners),
        (Sampling::Stochastic { n: 7 }, 7 * pixels),
        (Sampling::Random { n: 5 }, 5 * pixels),
        (Sampling::Sobol { n: 6 }, 6 * pixels),
        (Sampling::Statistical(statistical), 8 * pixels),
        (Sampling::Guided(Guided { tolerance: 0.001, min: 3, max: 64 }), 4 * pixels),
    ] {
        assert_eq!(camera_rays(&picture(&scene(empty, sampling))), rays, "{sampling:?}");
    }
}
