//! Random numbers of different decisions of a sample are unrelated, also where a pixel has few samples.

use crate::edges;
use crate::support;
use raywalk::random::{Arrangement, Dimension, Draws, Partner, Route};
use raywalk::scene::{Sampling, Scene};

/// What the samples of a pixel draw for a decision.
fn drawn(dimension: Dimension, pixel: u32, arrangement: Arrangement, count: u32) -> Vec<f64> {
    let draws = |number| Draws::of_pixel(4, [pixel, 2], number, arrangement);
    let value = |number| match dimension {
        Dimension::Time => draws(number).number(dimension),
        _ => draws(number).pick(dimension).point()[0],
    };
    (0..count).map(value).collect()
}

/// The correlation of two rows of numbers.
fn correlation(one: &[f64], other: &[f64]) -> f64 {
    let centred = |row: &[f64]| {
        let mean = row.iter().sum::<f64>() / row.len() as f64;
        row.iter().map(|value| value - mean).collect::<Vec<_>>()
    };
    let (one, other) = (centred(one), centred(other));
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    product(&one, &other) / (product(&one, &one) * product(&other, &other)).sqrt()
}

/// If all orders of one row are as likely, the correlation with another row of N numbers has the mean 0 and the mean square 1/(N − 1),
/// whatever the numbers are. Four standard errors of 10⁴ pixels, the variance of the square being less than 2/(N − 1)².
#[test]
fn correlations_of_two_decisions_are_those_of_random_orders() {
    let light = Dimension::Light { route: Route::CAMERA.reflected(0), light: 1 };
    let pairs = [
        (Dimension::Pixel, Dimension::Lens),
        (Dimension::Pixel, Dimension::Time),
        (Dimension::Lens, Dimension::Time),
        (Dimension::Time, light),
    ];
    for count in [4, 9, 16] {
        for arrangement in [Arrangement::Independent, Arrangement::Stratified { count }] {
            for (one, other) in pairs {
                let (mut sum, mut squares) = (0.0, 0.0);
                for pixel in 0..10_000 {
                    let of = |dimension| drawn(dimension, pixel, arrangement, count);
                    let correlation = correlation(&of(one), &of(other));
                    sum += correlation;
                    squares += correlation * correlation;
                }
                let (mean, square) = (sum / 1e4, squares / 1e4);
                let expected = 1.0 / f64::from(count - 1);
                let name = format!("{arrangement:?}, N = {count}, {one:?} and {other:?}");
                println!("{name}: {mean:.4}, {square:.4} of {expected:.4}");
                assert!(mean.abs() < 4.0 * (expected / 1e4).sqrt(), "{name}: mean {mean}");
                let deviation = 2.0_f64.sqrt() * expected;
                assert!((square - expected).abs() < 4.0 * deviation / 100.0, "{name}: mean square {square}");
            }
        }
    }
}

/// A camera sees edges that its lens, its shutter or a light blurs: functions that jump where a sum of coordinates of two decisions passes a
/// bound, so that neither decision knows of the edge by itself. The root of the mean square error of the part of such samples that lie
/// before the edge, over 400 pixels; the part is t²/2 for two coordinates and a bound t up to 1.
fn error_of_edges(dimension: Dimension, partner: Partner, count: u32) -> f64 {
    let mut squares = 0.0;
    for pixel in 0..400 {
        let bound = (f64::from(pixel) + 0.5) / 400.0;
        let is_before = |number| {
            let draws = Draws::of_pixel(6, [pixel, 1], number, Arrangement::Sobol { partner });
            let blurred = match dimension {
                Dimension::Time => draws.number(dimension),
                _ => draws.pick(dimension).point()[1],
            };
            draws.pick(Dimension::Pixel).point()[0] + blurred < bound
        };
        let part = (0..count).filter(|number| is_before(*number)).count() as f64 / f64::from(count);
        let error = part - bound * bound / 2.0;
        squares += error * error;
    }
    libm::sqrt(squares / 400.0)
}

/// Joint points err as those of a net, N^(−5/8) for a jump in four dimensions or better (Owen, "Monte Carlo variance of scrambled net quadrature",
/// 1997, has the smooth ones); pairs that know nothing of each other as random ones do where both take part, N^(−1/2).
#[test]
fn partners_integrate_edges_across_both_better() {
    let light = Dimension::Light { route: Route::CAMERA, light: 3 };
    let reflection = Dimension::Reflection { route: Route::CAMERA };
    let transmission = Dimension::Transmission { route: Route::CAMERA };
    let cases = [
        (Dimension::Lens, Partner::Lens),
        (Dimension::Time, Partner::Time),
        (light, Partner::Surface),
        (reflection, Partner::Surface),
        (transmission, Partner::Surface),
    ];
    for (dimension, partner) in cases {
        let [alone, jointly] = [Partner::Nothing, partner].map(|partner| error_of_edges(dimension, partner, 256));
        println!("{dimension:?}: {alone:.5} alone, {jointly:.5} jointly");
        assert!(jointly < 0.6 * alone, "{dimension:?}: {jointly} of {alone}");
    }
    // Only what is the partner changes.
    let deeper = Dimension::Light { route: Route::CAMERA.reflected(0), light: 3 };
    for (dimension, partner) in [(Dimension::Time, Partner::Lens), (light, Partner::Lens), (deeper, Partner::Surface)] {
        assert_eq!(
            error_of_edges(dimension, partner, 16),
            error_of_edges(dimension, Partner::Nothing, 16),
            "{dimension:?}"
        );
    }
}

/// The corners of a pixel have one time in each of n² parts of the exposure, whichever pixel.
#[test]
fn the_corners_of_a_pixel_are_stratified_together() {
    for (n, pixel) in [(1, [0, 0]), (2, [3, 1]), (4, [0, 7]), (5, [1000, 2])] {
        let corners = (0..n * n).map(|k| [pixel[0] * n + k % n, pixel[1] * n + k / n]);
        let part = |corner| (Draws::of_corner(3, corner, n).number(Dimension::Time) * f64::from(n * n)) as u32;
        let mut parts: Vec<_> = corners.map(part).collect();
        parts.sort_unstable();
        assert_eq!(parts, (0..n * n).collect::<Vec<_>>(), "{n}");
    }
}

/// Where cells are cut, so have those of each coarser grid: 4^k corners, one in each of 4^k parts.
#[test]
fn coarse_corners_are_spread_before_fine_ones() {
    const DEPTH: u32 = 3;
    for pixel in [[0, 0], [5, 9]] {
        for level in 0..=DEPTH {
            let (n, step) = (1 << level, 1 << (DEPTH - level));
            let corners = (0..n * n).map(|k| [pixel[0] * 8 + k % n * step, pixel[1] * 8 + k / n * step]);
            let number = |corner| Draws::of_nested_corner(3, corner, DEPTH).number(Dimension::Time);
            let mut parts: Vec<_> = corners.map(|corner| (number(corner) * f64::from(n * n)) as u32).collect();
            parts.sort_unstable();
            assert_eq!(parts, (0..n * n).collect::<Vec<_>>(), "level {level}");
        }
    }
}

/// An edge that moves by ten pixels while the shutter is open: pixel k of the ramp is covered for 1 − (k + 1/2)/10 of the time.
fn ramp(sampling: Sampling) -> Scene {
    let text = r#"{"format": "raywalk-scene/1",
        "camera": {"position": [0, 0, 1], "direction": [0, 0, -1], "vertical_fov": 90, "resolution": [32, 16], "shutter": [0, 1]},
        "ambient": [1, 1, 1], "materials": {"white": {"ambient": [1, 1, 1]}},
        "objects": [{"shape": {"polygon": {"vertices": [[-9, -9, 0], [0, -9, 0], [0, 9, 0], [-9, 9, 0]]}},
                     "material": "white", "motion": {"translation": [1.25, 0, 0]}}]}"#;
    Scene { sampling, ..support::scene_of(text.as_bytes(), "ramp") }
}

/// The root of the mean square error over the ramp and 8 seeds, and the mean error of its pixels.
fn ramp_error(sampling: Sampling) -> [f64; 2] {
    let mut scene = ramp(sampling);
    let (mut squares, mut sum) = (0.0, 0.0);
    for seed in 0..8 {
        scene.seed = seed;
        let picture = edges::red(&edges::picture(&scene));
        for (row, column) in (0..16).flat_map(|row| (0..10).map(move |column| (row, column))) {
            let error = picture[row * 32 + 16 + column] - (0.95 - 0.1 * column as f64);
            squares += error * error;
            sum += error;
        }
    }
    let count = 8.0 * 160.0;
    [libm::sqrt(squares / count), sum / count]
}

/// The corners that pixels share see as many times as those of a grid that is each pixel's own: a pixel has corners of four blocks, of
/// which one is nearly whole.
#[test]
fn shared_corners_blur_motion_about_as_well_as_a_grid_of_one_s_own() {
    let [regular, _] = ramp_error(Sampling::Regular { n: 4 });
    let [shared, bias] = ramp_error(Sampling::Shared { n: 4 });
    let [random, _] = ramp_error(Sampling::Random { n: 16 });
    println!("regular {regular:.4}, shared {shared:.4}, random {random:.4}, bias {bias:.4}");
    for depth in [2, 4] {
        let [error, bias] = ramp_error(Sampling::Adaptive { threshold: 0.02, depth });
        println!("adaptive, depth {depth}: {error:.4}, bias {bias:.4}");
    }
    assert!(shared < 2.0 * regular && shared < 0.75 * random, "{shared}, {regular}, {random}");
    assert!(bias.abs() < 4.0 * shared / libm::sqrt(1280.0), "{bias}");
}
