//! What touches and what doesn't: coincident solids, a slab on a floor, and gaps that stay gaps.

use super::stacks::meetings;
use super::world::{Frame, World, wrong};
use crate::random::Random;
use glam::DVec3;
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Color, Scene};
use serde_json::{Value, json};

const SQUARE: [[f64; 3]; 4] = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];

fn glass(ior: f64) -> Value {
    json!({"ior": ior, "weights": {"local": 0, "transmitted": 1}})
}

fn ball(frame: &Frame, radius: f64) -> Value {
    json!({"sphere": {"center": frame.at([0.0; 3]), "radius": frame.length(radius)}})
}

/// Seen from above, under a light straight above.
fn world(frame: &Frame) -> World {
    World::seen(frame, [0.3, 0.2, 2.5], [0.0; 3], 20.0, [20, 15])
        .light(json!({"directional": {"direction": frame.way([0.0, 0.0, -1.0])}}))
        .material("white", json!({"diffuse": [1, 1, 1]}))
        .material("dark", json!({"diffuse": [0.1, 0.2, 0.3]}))
        .material("sheet", json!({"weights": {"local": 0, "transmitted": 0.5}}))
        .material("glass", glass(1.5))
        .material("water", glass(1.25))
}

/// The indices before and behind wherever a ray through the frame's middle hits glass.
fn iors(scene: &Scene, frame: &Frame, origin: [f64; 3]) -> Vec<[f64; 2]> {
    let origin = frame.point(origin);
    let log = record::ray(scene, origin, frame.point([0.05, 0.03, 0.0]) - origin, Arithmetic::F64);
    meetings(&log).iter().filter_map(|meeting| meeting.iors).collect()
}

fn times(picture: Vec<Color>, factor: f64) -> Vec<Color> {
    picture.into_iter().map(|color| color * factor).collect()
}

/// They are entered together and left together; the later one fills them.
#[test]
fn equal_solids_of_two_indices() {
    let mut random = Random::new(801);
    for (far, scale) in [(0.0, 1.0), (1e3, 1.0), (3.0, 1e-4), (1e4, 1e5)] {
        let frame = Frame::turned(&mut random, far, scale);
        let radii = [1.1, 0.7, 0.9].map(|radius| frame.length(radius));
        let egg = json!({"ellipsoid": {"center": frame.at([0.0; 3]), "radii": radii, "rotation": frame.rows()}});
        for solid in [ball(&frame, 0.9), egg] {
            for ([first, second], ior) in [(["glass", "water"], 1.25), (["water", "glass"], 1.5)] {
                let scene = world(&frame).object(first, solid.clone()).object(second, solid.clone()).scene();
                for _ in 0..20 {
                    let found = iors(&scene, &frame, (random.unit() * 3.0).to_array());
                    assert_eq!(found, [[1.0, ior], [ior, 1.0]], "{far} sizes of {scale} away");
                }
                // From inside only the ways out are left.
                assert_eq!(iors(&scene, &frame, [-0.1, 0.2, 0.05]), [[ior, 1.0]], "{far} sizes of {scale} away");
            }
        }
    }
}

/// The order of the scene says on which side of the floor the slab's lower face is, and says so everywhere.
#[test]
fn a_slab_on_a_floor() {
    let mut random = Random::new(802);
    for (far, scale) in [(0.0, 1.0), (1e3, 1.0), (3.0, 1e-4), (1e4, 1e5)] {
        let frame = Frame::upright(random.point() * (far * scale), scale);
        let slab = json!({"box": {"min": frame.at([-3.0, -3.0, 0.0]), "max": frame.at([3.0, 3.0, 0.2])}});
        let wide = frame.polygon(&SQUARE.map(|own| own.map(|x| 4.0 * x)));
        for floor in [frame.plane([0.0; 3], [0.0, 0.0, 1.0]), wide] {
            let open = world(&frame).object("white", floor.clone()).picture();
            // Both faces of the slab weigh what is seen and its light, or only the upper one does.
            let slab_first = world(&frame).object("sheet", slab.clone()).object("white", floor.clone()).picture();
            let (count, worst) = wrong(&slab_first, &times(open.clone(), 1.0 / 16.0), 1e-9);
            assert_eq!(count, 0, "slab first, {far} sizes of {scale} away: off by {worst:e}");
            let floor_first = world(&frame).object("white", floor).object("sheet", slab.clone()).picture();
            let (count, worst) = wrong(&floor_first, &times(open, 1.0 / 4.0), 1e-9);
            assert_eq!(count, 0, "floor first, {far} sizes of {scale} away: off by {worst:e}");
        }
    }
}

/// A frame far away, and a gap of 10⁻⁹ of its coordinates in its own measure.
fn gapped(random: &mut Random, is_upright: bool) -> (Frame, f64, f64) {
    let (far, scale) = [(0.0, 1.0), (1e3, 1.0), (3.0, 1e-4), (1e4, 1e5)][random.below(4)];
    let frame = match is_upright {
        true => Frame::upright(random.point() * (far * scale), scale),
        false => Frame::turned(random, far, scale),
    };
    (frame, 1e-9 * (far + 3.0), far)
}

#[test]
fn flat_shapes_a_little_apart() {
    let mut random = Random::new(803);
    for _ in 0..20 {
        let (frame, gap, far) = gapped(&mut random, false);
        let lower = frame.polygon(&SQUARE.map(|own| own.map(|x| 2.0 * x)));
        let upper = frame.polygon(&SQUARE.map(|[x, y, _]| [x, y, gap]));
        let alone = world(&frame).object("dark", upper.clone()).picture();
        let floor = world(&frame).object("white", lower.clone()).picture();
        for is_first in [false, true] {
            let both = |material: &str| {
                let order = [(material, upper.clone()), ("white", lower.clone())];
                let add = |world: World, (material, shape): (&str, Value)| world.object(material, shape);
                let [one, other] = order;
                let pair = if is_first { [one, other] } else { [other, one] };
                pair.into_iter().fold(world(&frame), add).picture()
            };
            let (count, worst) = wrong(&both("dark"), &alone, 1e-9);
            assert_eq!(count, 0, "the nearer one, {far} sizes away: off by {worst:e}");
            let (count, worst) = wrong(&both("sheet"), &times(floor.clone(), 0.25), 1e-9);
            assert_eq!(count, 0, "seen and lit through a sheet, {far} sizes away: off by {worst:e}");
        }
    }
}

#[test]
fn spheres_a_little_apart() {
    let mut random = Random::new(804);
    for _ in 0..20 {
        let (frame, gap, far) = gapped(&mut random, false);
        let [inner, outer] = [0.9, 0.9 + gap].map(|radius| ball(&frame, radius));
        let alone = world(&frame).object("dark", outer.clone()).picture();
        for order in [[("dark", &outer), ("white", &inner)], [("white", &inner), ("dark", &outer)]] {
            let add = |world: World, (material, shape): (&str, &Value)| world.object(material, shape.clone());
            let (count, worst) = wrong(&order.into_iter().fold(world(&frame), add).picture(), &alone, 1e-9);
            assert_eq!(count, 0, "{far} sizes away: off by {worst:e}");
        }
        for order in [[("glass", &outer), ("water", &inner)], [("water", &inner), ("glass", &outer)]] {
            let add = |world: World, (material, shape): (&str, &Value)| world.object(material, shape.clone());
            let scene = order.into_iter().fold(world(&frame), add).scene();
            let found = iors(&scene, &frame, (random.unit() * 3.0).to_array());
            assert_eq!(found, [[1.0, 1.5], [1.5, 1.25], [1.25, 1.5], [1.5, 1.0]], "{far} sizes away");
        }
    }
}

#[test]
fn slabs_with_air_between() {
    let mut random = Random::new(805);
    for case in 0..40 {
        let (frame, gap, far) = gapped(&mut random, true);
        let slab = |bottom: f64, top: f64| json!({"box": {"min": frame.at([-3.0, -3.0, bottom]), "max": frame.at([3.0, 3.0, top])}});
        let (upper, lower) = (("glass", slab(gap, 1.0)), ("water", slab(-1.0, 0.0)));
        let pair = if case % 2 == 0 { [upper, lower] } else { [lower, upper] };
        let add = |world: World, (material, shape): (&str, Value)| world.object(material, shape);
        let scene = pair.into_iter().fold(world(&frame), add).scene();
        let from = DVec3::new(random.part() - 0.5, random.part() - 0.5, 1.7);
        let found = iors(&scene, &frame, from.to_array());
        assert_eq!(found, [[1.0, 1.5], [1.5, 1.0], [1.0, 1.25], [1.25, 1.0]], "{far} sizes away");
    }
}
