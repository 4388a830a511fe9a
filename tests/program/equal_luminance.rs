//! Edges between colours of equal luminance (Ramos, section 1.4.1: the eye sees stairs less where only the colour differs).

use crate::support::{changed_scene, scene};
use glam::DVec3;
use raywalk::log::{Decision, Split, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::file::schema::Sampling;

/// The usual weights of red, green and blue (Rec. ITU-R BT.709).
const WEIGHTS: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// The luminance of a colour of eight bits, as a level.
pub fn level(pixel: [u8; 3]) -> u8 {
    let luminance: f64 = pixel.iter().zip(WEIGHTS).map(|(level, weight)| f64::from(*level) * weight).sum();
    luminance.round() as u8
}

fn luminance(color: DVec3) -> f64 {
    color.dot(DVec3::from(WEIGHTS))
}

/// Left and right of each edge.
fn colours() -> [DVec3; 3] {
    let scene = scene("equal-luminance");
    let at = |x| record::pixel_color(&scene, [x, 16], Arithmetic::F64);
    [at(32), at(10), at(54)]
}

#[test]
fn luminances_are_equal_and_colours_differ() {
    let [background, other_colour, other_luminance] = colours();
    assert!((luminance(background) - luminance(other_colour)).abs() < 1e-15);
    assert!((background - other_colour).abs().max_element() > 0.7);
    // On the right the same colour is brighter.
    assert!((luminance(other_luminance) / luminance(background) - 1.8).abs() < 1e-12);
    assert!((other_luminance / 1.8 - background).abs().max_element() < 1e-15);
}

/// `adaptive` compares channels, not luminances: it cuts the cells of the left edge because of their colours, and finds as much of it
/// as of the right one, which is the same circle.
#[test]
fn adaptive_sampling_finds_the_edge_by_its_colour() {
    let adaptive = Sampling::Adaptive { threshold: 0.05, depth: 4 };
    let scene = changed_scene("equal-luminance", |file| file.sampling = adaptive);
    let mut cuts = [0, 0];
    let mut shades = [0, 0];
    for y in 0..32 {
        for x in 0..64 {
            let log = record::pixel(&scene, [x, y], Arithmetic::F64);
            let side = usize::from(x >= 32);
            let is_cut = |what: &What| matches!(what, What::Mark(Decision::Subdivided { why: Split::Color, .. }));
            cuts[side] += log.events.iter().filter(|event| is_cut(&event.what)).count();
            let by_objects = |what: &What| matches!(what, What::Mark(Decision::Subdivided { why: Split::Objects, .. }));
            assert!(!log.events.iter().any(|event| by_objects(&event.what)), "{x}, {y}");
            let [background, left, right] = colours_of(&scene);
            let color = record::pixel_color(&scene, [x, y], Arithmetic::F64);
            let pure = if side == 0 { left } else { right };
            shades[side] += usize::from((color - background).length() > 1e-9 && (color - pure).length() > 1e-9);
            if side == 0 {
                assert!((luminance(color) - luminance(background)).abs() < 1e-12, "{x}, {y}: {color}");
            }
        }
    }
    assert!(cuts[0] > 500 && shades[0] > 50, "{cuts:?} {shades:?}");
    assert_eq!((cuts[0], shades[0]), (cuts[1], shades[1]));
}

fn colours_of(scene: &raywalk::scene::Scene) -> [DVec3; 3] {
    let object = |name: &str| {
        let material = scene.objects.iter().find(|object| object.name == name).map(|object| object.material);
        scene.materials[material.expect("an object")].ambient
    };
    [scene.background, object("other colour"), object("other luminance")]
}
