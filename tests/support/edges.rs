//! White shapes on black whose part of each pixel is known, and pictures of them by any method.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use raywalk::record::Arithmetic;
use raywalk::render::{Rendered, Settings, TileOrder, render};
use raywalk::scene::{Sampling, Scene, build, file};
use std::sync::atomic::AtomicBool;

/// The side of the pictures.
pub const SIDE: u32 = 32;

/// A white shape in the plane z = 0. A pixel is 1 wide; the middle of the picture is at (0, 0), y goes up.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// The points with nx·x + ny·y ≤ d.
    HalfPlane { nx: f64, ny: f64, d: f64 },
    /// A disc.
    Disc { x: f64, y: f64, radius: f64 },
}

/// The scene with one such shape.
pub fn scene(shape: Shape, sampling: Sampling) -> Scene {
    let shape = match shape {
        Shape::Disc { x, y, radius } => {
            format!(r#"{{"disk": {{"center": [{x:?}, {y:?}, 0], "normal": [0, 0, 1], "radius": {radius:?}}}}}"#)
        }
        Shape::HalfPlane { nx, ny, d } => {
            // A rectangle that reaches far beyond the picture on the inner side of the edge.
            let far = 100.0;
            let at = |along: f64, inward: f64| [nx * (d - inward) - ny * along, ny * (d - inward) + nx * along, 0.0];
            let corners = [at(-far, 0.0), at(far, 0.0), at(far, far), at(-far, far)];
            format!(r#"{{"polygon": {{"vertices": {corners:?}}}}}"#)
        }
    };
    let text = format!(
        r#"{{"format": "raywalk-scene/1",
            "camera": {{"position": [0, 0, 16], "direction": [0, 0, -1], "vertical_fov": 90, "resolution": [{SIDE}, {SIDE}]}},
            "ambient": [1, 1, 1], "materials": {{"white": {{"ambient": [1, 1, 1]}}}},
            "objects": [{{"shape": {shape}, "material": "white"}}]}}"#
    );
    let loaded = file::check(text.as_bytes(), "edge.json").unwrap_or_else(|error| panic!("{}", error.report(false)));
    let mut scene = build(&loaded.scene, &Default::default()).expect("a supported scene");
    scene.sampling = sampling;
    scene
}

/// The picture of a scene.
pub fn picture(scene: &Scene) -> Rendered {
    let [width, height] = scene.camera.resolution;
    picture_with(scene, [0, 0, width, height], 2)
}

/// A part of the picture of a scene, on this many threads.
pub fn picture_with(scene: &Scene, crop: [u32; 4], threads: usize) -> Rendered {
    picture_in_order(scene, crop, threads, TileOrder::Rows)
}

/// The same, the tiles taken up in some order.
pub fn picture_in_order(scene: &Scene, crop: [u32; 4], threads: usize, order: TileOrder) -> Rendered {
    let settings = Settings { crop, arithmetic: Arithmetic::F64, threads, counts_rays: true, order };
    render(scene, &settings, |_| (), &AtomicBool::new(false)).expect("a picture")
}

/// The red of each pixel.
pub fn red(rendered: &Rendered) -> Vec<f64> {
    rendered.film.pixels().iter().map(|color| color.x).collect()
}

/// How many camera rays a picture took.
pub fn camera_rays(rendered: &Rendered) -> u64 {
    let counts = rendered.counts.as_ref().expect("counts");
    let json = serde_json::to_value(counts.statistics(0, Default::default(), 0)).expect("JSON");
    assert_eq!(json["samples"], json["rays"]["camera"]);
    json["rays"]["camera"].as_u64().expect("a number")
}

/// The part of each pixel that the shape covers, exactly.
pub fn coverage(shape: Shape) -> Vec<f64> {
    let half = f64::from(SIDE) / 2.0;
    let pixels = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| [f64::from(column), f64::from(row)]));
    pixels.map(|[column, row]| covered(shape, column - half, half - row - 1.0)).collect()
}

/// The part of the unit square with its lower left corner at (left, low) that the shape covers.
fn covered(shape: Shape, left: f64, low: f64) -> f64 {
    match shape {
        Shape::HalfPlane { nx, ny, d } => {
            let corners = [[left, low], [left + 1.0, low], [left + 1.0, low + 1.0], [left, low + 1.0]];
            area(&clipped(&corners, |[x, y]| d - nx * x - ny * y))
        }
        Shape::Disc { x, y, radius } => disc_in_square(left - x, low - y, radius),
    }
}

/// The part of a convex polygon where `inside` isn't negative (Sutherland and Hodgman).
fn clipped(corners: &[[f64; 2]], inside: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    for (k, from) in corners.iter().enumerate() {
        let to = corners[(k + 1) % corners.len()];
        let (a, b) = (inside(*from), inside(to));
        if a >= 0.0 {
            kept.push(*from);
        }
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            let part = a / (a - b);
            kept.push([from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]);
        }
    }
    kept
}

fn area(corners: &[[f64; 2]]) -> f64 {
    let next = |k: usize| corners[(k + 1) % corners.len()];
    corners.iter().enumerate().map(|(k, [x, y])| x * next(k)[1] - next(k)[0] * y).sum::<f64>() / 2.0
}

/// The area of a disc around the origin in a unit square: between its arcs, clamped to the square, column by column.
fn disc_in_square(left: f64, low: f64, r: f64) -> f64 {
    let chord = |y: f64| (r * r - y * y).max(0.0).sqrt();
    let mut cuts = vec![left, left + 1.0, -r, r];
    for y in [low, low + 1.0] {
        cuts.extend([chord(y), -chord(y)]);
    }
    cuts.iter_mut().for_each(|x| *x = x.clamp(left, left + 1.0));
    cuts.sort_by(f64::total_cmp);
    // ∫ √(r² − x²) dx
    let arc = |x: f64| {
        let x = x.clamp(-r, r);
        0.5 * (x * chord(x) + r * r * libm::asin((x / r).clamp(-1.0, 1.0)))
    };
    cuts.windows(2)
        .map(|pair| {
            let [from, to] = [pair[0], pair[1]];
            let middle = (from + to) / 2.0;
            if middle.abs() >= r {
                return 0.0;
            }
            // Which of arc and side bounds the strip above and below doesn't change in it.
            let height = chord(middle);
            let above = if height < low + 1.0 { arc(to) - arc(from) } else { (low + 1.0) * (to - from) };
            let below = if -height > low { arc(from) - arc(to) } else { low * (to - from) };
            (above - below).max(0.0)
        })
        .sum()
}
