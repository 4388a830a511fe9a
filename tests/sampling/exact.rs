//! Pictures computed without sampling: against very many samples, and against areas that are known.

use crate::edges::{self, SIDE};
use crate::support;
use raywalk::record::{self, Arithmetic};
use raywalk::sampling::ellipse::Ellipse;
use raywalk::scene::{Color, Sampling, Scene, builtin};
use raywalk::study::bench::exact::{Exact, NotExact};
use std::f64::consts::PI;

const FIGURES: [&str; 4] = ["figure-17", "figure-18", "figure-19", "figure-20"];

fn exact(scene: &Scene) -> Exact {
    Exact::of(scene).unwrap_or_else(|why| panic!("{}: {why}", scene.name))
}

/// The mean of 64 × 64 cells errs by at most half a cell in each column and edge: 1/128 of the contrast, of which a pixel has four at most.
#[test]
fn the_figures_are_what_very_many_samples_show() {
    for name in FIGURES {
        let mut scene = support::scene(name);
        let [width, height] = scene.camera.resolution;
        let exact = exact(&scene).picture();
        let (mut mixed, mut signed) = (0, 0.0);
        for (k, expected) in exact.iter().enumerate() {
            let pixel = [k as u32 % width, k as u32 / width];
            let is_pure = |color: &Color| (*color - *expected).abs().max_element() < 1e-12;
            let colors: Vec<_> = scene.materials.iter().map(|material| scene.ambient * material.ambient).collect();
            let is_mixed = !colors.iter().chain([&scene.background]).any(is_pure);
            scene.sampling = Sampling::Regular { n: if is_mixed { 64 } else { 3 } };
            let found = record::pixel_color(&scene, pixel, Arithmetic::F64);
            let error = (found - *expected).x;
            let limit = if is_mixed { 4.0 / 128.0 } else { 1e-12 };
            assert!((found - *expected).abs().max_element() <= limit, "{name} {pixel:?}: {found} {expected}");
            mixed += usize::from(is_mixed);
            signed += error;
        }
        assert!(mixed > 10 && (signed / mixed as f64).abs() < 2e-3, "{name}: {mixed} mixed, {signed}");
        assert_eq!(exact.len(), (width * height) as usize);
    }
}

/// The areas of the pixels are those of the whole.
#[test]
fn the_areas_of_figure_19_add_up() {
    let scene = support::scene("figure-19");
    let picture = exact(&scene).picture();
    let sum: Color = picture.iter().map(|color| *color - scene.background).sum();
    // Two discs of radius 0.3 and two bars; a pixel is as large as 1 in the plane of the figure.
    let (discs, bars) = (2.0 * PI * 0.09, 2.0 * 0.3 * 12.3);
    let (red, blue) = (Color::new(0.9, 0.3, 0.25), Color::new(0.4, 0.6, 0.95));
    let expected = (red - scene.background) * discs + (blue - scene.background) * bars;
    assert!((sum - expected).abs().max_element() < 1e-11, "{sum} {expected}");
}

/// Discs and half-planes by another computation of the same areas, which loses digits on the largest disc.
#[test]
fn discs_and_edges_are_those_of_an_independent_computation() {
    let shapes = [
        edges::Shape::Disc { x: 0.37, y: -0.21, radius: 11.3 },
        edges::Shape::Disc { x: 3.2, y: 1.9, radius: 0.3 },
        edges::Shape::Disc { x: -160.0, y: 1.0, radius: 155.2 },
        edges::Shape::HalfPlane { nx: 0.6, ny: 0.8, d: 2.35 },
    ];
    for shape in shapes {
        let found = exact(&edges::scene(shape, Sampling::Center {})).picture();
        for (k, (found, expected)) in found.iter().zip(edges::coverage(shape)).enumerate() {
            assert!((found.x - expected).abs() < 1e-9, "{shape:?} {} {}: {found}", k as u32 % SIDE, k as u32 / SIDE);
        }
    }
}

/// An ellipsoid seen from the side, whose silhouette isn't a section through its centre.
#[test]
fn the_areas_of_a_near_ellipsoid_add_up() {
    let text = r#"{"format": "raywalk-scene/1",
        "camera": {"position": [0.5, 0.2, 4], "direction": [-0.1, 0, -1], "vertical_fov": 60, "resolution": [40, 30]},
        "ambient": [1, 1, 1], "materials": {"white": {"ambient": [1, 1, 1]}},
        "objects": [{"name": "egg", "material": "white", "shape": {"ellipsoid": {"center": [0.1, 0, 0], "radii": [1.4, 0.3, 0.9],
            "rotation": [[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]]}}}]}"#;
    let scene = support::scene_of(text.as_bytes(), "egg");
    let round = scene.objects[0].shape.round().expect("an ellipsoid");
    let area = Ellipse::seen(&scene.camera, &round).expect("an ellipse").area();
    let picture = exact(&scene).picture();
    let sum: f64 = picture.iter().map(|color| color.x).sum();
    assert!((sum - area).abs() < 1e-10 && area > 20.0, "{sum} {area}");
    let sampled = Scene { sampling: Sampling::Regular { n: 16 }, ..scene };
    let found: f64 = edges::red(&edges::picture(&sampled)).iter().sum();
    assert!((found - area).abs() < 0.05, "{found} {area}");
}

#[test]
fn scenes_without_an_exact_picture_say_why() {
    let why = |scene: &Scene| Exact::of(scene).expect_err("no exact picture").to_string();
    assert!(why(&support::scene("depth-of-field")).contains("lens"));
    assert!(why(&support::scene("textbook")).contains("`plane`"));
    assert!(why(&support::scene("figure-6")).contains("object `"));
    let mut scene = support::scene("figure-17");
    scene.objects[0].shape = scene.objects[1].shape.clone();
    assert_eq!(Exact::of(&scene), Err(NotExact::Overlap("curve".into(), "profile".into())));
    let with_exact: Vec<_> = builtin::names().filter(|name| Exact::of(&support::scene(name)).is_ok()).collect();
    assert_eq!(with_exact, [&["equal-luminance"][..], &FIGURES].concat());
}
