//! The eye inside transmitting solids: which hold it, and in what order the ray leaves them.

use super::stacks::{meetings, triple};
use super::world::{Frame, World};
use crate::random::Random;
use glam::DVec3;
use raywalk::log::{Decision, Log, Name, What};
use raywalk::record::{self, Arithmetic};
use serde_json::{Value, json};

/// The objects that a log's first ray begins in, the innermost last.
pub fn immersed(log: &Log) -> Vec<u32> {
    let held = |what: &What| match what {
        What::Mark(Decision::Immersed { object }) => Some(*object),
        _ => None,
    };
    log.events.iter().filter_map(|event| held(&event.what)).collect()
}

/// A convex solid: how deep a point of the frame lies in it, positive inside.
struct Solid {
    depth: Box<dyn Fn(DVec3) -> f64>,
    ior: f64,
}

impl Solid {
    fn holds(&self, point: DVec3) -> bool {
        (self.depth)(point) > 0.0
    }

    /// How far along a direction a point inside is from the surface: found by halving, as the solid is convex.
    fn exit(&self, origin: DVec3, direction: DVec3) -> f64 {
        let (mut inside, mut outside) = (0.0, 100.0);
        if self.holds(origin + direction * outside) {
            return f64::INFINITY;
        }
        for _ in 0..60 {
            let middle = (inside + outside) / 2.0;
            *(if self.holds(origin + direction * middle) { &mut inside } else { &mut outside }) = middle;
        }
        inside
    }
}

/// Adds a random solid near the origin of the frame.
fn add(frame: &Frame, is_upright: bool, world: World, random: &mut Random) -> (Solid, World) {
    let mut between = |from: f64, to: f64| from + (to - from) * random.part();
    let center = DVec3::new(between(-0.8, 0.8), between(-0.8, 0.8), between(-0.8, 0.8));
    let [a, b, c] = [(); 3].map(|()| between(0.5, 1.8));
    let (ior, kind, inward) = (between(1.0, 2.5), between(0.0, 8.0) as usize, between(0.0, 1.0) < 0.3);
    let own = Frame::turned(random, 0.0, 1.0);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| own.vector(axis));
    let within = move |point: DVec3| DVec3::from(axes.map(|axis| axis.dot(point - center)));
    let at = |place: [f64; 3]| frame.at((center + own.vector(place)).to_array());
    let length = |own: f64| frame.length(own);
    let name = format!("glass {}", world.text["objects"].as_array().expect("objects").len());
    let world = world.material(&name, json!({"ior": ior, "weights": {"local": 0, "transmitted": 1}}));
    let size = DVec3::new(a, b, c);
    type Depth = Box<dyn Fn(DVec3) -> f64>;
    let (depth, shape): (Depth, Value) = match kind {
        0 if is_upright => {
            let corners = [center - size, center + size].map(|corner| frame.at(corner.to_array()));
            (
                Box::new(move |point| (size - (point - center).abs()).min_element()),
                json!({"box": {"min": corners[0], "max": corners[1]}}),
            )
        }
        1 => (
            Box::new(move |point| a - (point - center).length()),
            json!({"sphere": {"center": at([0.0; 3]), "radius": length(a), "inward": inward}}),
        ),
        2 => {
            let rows = [0, 1, 2].map(|row| axes.map(|axis| frame.vector(axis.to_array())[row]));
            (
                Box::new(move |point| 1.0 - (within(point) / size).length()),
                json!({"ellipsoid": {"center": at([0.0; 3]), "radii": size.to_array().map(length), "rotation": rows}}),
            )
        }
        3 | 4 => {
            // A cylinder is a cone of one radius.
            let top = if kind == 3 { a } else { a * 0.3 };
            let depth = move |point: DVec3| {
                let point = within(point);
                let radius = (a + top) / 2.0 + (top - a) / 2.0 * (point.z / c);
                (radius - point.truncate().length()).min(c - point.z.abs())
            };
            let mut shape =
                json!({"base": at([0.0, 0.0, -c]), "apex": at([0.0, 0.0, c]), "caps": true, "inward": inward});
            if kind == 3 {
                shape["radius"] = json!(length(a));
                (Box::new(depth), json!({"cylinder": shape}))
            } else {
                shape["base_radius"] = json!(length(a));
                shape["apex_radius"] = json!(length(top));
                (Box::new(depth), json!({"cone": shape}))
            }
        }
        5 => {
            let normal = frame.vector(axes[2].to_array());
            let offset = -normal.dot(frame.point(center.to_array()));
            (
                Box::new(move |point| -within(point).z),
                json!({"plane": {"coefficients": [normal.x, normal.y, normal.z, offset]}}),
            )
        }
        _ => {
            let corner = |k: usize| {
                let signs = [k & 1, k >> 1 & 1, k >> 2].map(|bit| 2.0 * bit as f64 - 1.0);
                (center + own.vector((size * DVec3::from(signs)).to_array())).to_array()
            };
            let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
            let mut faces = super::doubled::halves(&quads);
            if inward {
                faces.iter_mut().for_each(|face| face.reverse());
            }
            let corners: Vec<_> = (0..8).map(corner).collect();
            let solid = Solid { depth: Box::new(move |point| (size - within(point).abs()).min_element()), ior };
            return (solid, world.mesh(&name, frame.mesh(&corners, &faces)));
        }
    };
    (Solid { depth, ior }, world.object(&name, shape))
}

/// What holds a point, by the order in which a direction leaves it; `None` where roundings may tell otherwise.
fn around(solids: &[Solid], point: DVec3, direction: DVec3) -> Option<Vec<u32>> {
    if solids.iter().any(|solid| (solid.depth)(point).abs() < 1e-5) {
        return None;
    }
    let holding = (0..).zip(solids).filter(|(_, solid)| solid.holds(point));
    let mut held: Vec<(f64, u32)> = holding.map(|(number, solid)| (solid.exit(point, direction), number)).collect();
    // Of several that are never left the later in the scene is the inner one.
    held.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    let is_clear = held.windows(2).all(|pair| pair[0].0 == pair[1].0 || pair[0].0 - pair[1].0 > 1e-5);
    is_clear.then(|| held.into_iter().map(|(_, number)| number).collect())
}

fn frames(random: &mut Random, case: usize) -> (Frame, bool) {
    let (far, scale) = [(0.0, 1.0), (3.0, 1e-4), (1e2, 1.0), (1e3, 1e3)][case / 2 % 4];
    match case % 2 {
        0 => (Frame::upright(random.point() * (far * scale), scale), true),
        _ => (Frame::turned(random, far, scale), false),
    }
}

fn looking(frame: &Frame, direction: DVec3) -> World {
    World::seen(frame, [0.0; 3], direction.to_array(), 70.0, [3, 3]).set("/background", json!([1, 1, 1]))
}

fn scattered(frame: &Frame, is_upright: bool, direction: DVec3, random: &mut Random) -> (Vec<Solid>, World) {
    let (mut solids, mut world) = (Vec::new(), looking(frame, direction));
    for _ in 0..1 + random.below(4) {
        let (solid, with) = add(frame, is_upright, world, random);
        solids.push(solid);
        world = with;
    }
    (solids, world)
}

/// The first surface refracts from what holds the eye into what is behind.
fn check_first_surface(log: &Log, solids: &[Solid], held: &[u32], frame: &Frame, scale: f64) -> bool {
    let met = meetings(log);
    let Some((meeting, [eta_1, eta_2])) = met.first().and_then(|meeting| Some((meeting, meeting.iors?))) else {
        return false;
    };
    let ior = |held: &[u32]| held.last().map_or(1.0, |number| solids[*number as usize].ior);
    let normal = frame.own(frame.point([0.0; 3]) + meeting.normal * scale);
    let behind = frame.own(meeting.point) - normal * 1e-7;
    let mut after = held.to_vec();
    after.retain(|number| solids[*number as usize].holds(behind));
    after.extend((0..).zip(solids).filter(|(k, solid)| !held.contains(k) && solid.holds(behind)).map(|(k, _)| k));
    // Near an edge more than one may have changed.
    if after.len().abs_diff(held.len()) != 1 {
        return false;
    }
    assert_eq!([eta_1, eta_2], [ior(held), ior(&after)]);
    let sine = |direction: DVec3| direction.cross(meeting.normal).length();
    match meeting.refracted {
        Some(refracted) => assert!((eta_1 * sine(meeting.direction) - eta_2 * sine(refracted)).abs() < 1e-12),
        None => assert!(meeting.is_total && eta_1 * sine(meeting.direction) > eta_2 * (1.0 - 1e-12)),
    }
    true
}

#[test]
fn what_holds_the_eye_is_left_the_innermost_first() {
    let mut random = Random::new(701);
    let (mut counts, mut surfaces) = ([0; 5], 0);
    for case in 0..800 {
        let (frame, is_upright) = frames(&mut random, case);
        let scale = frame.length(1.0);
        let direction = random.unit();
        let (solids, world) = scattered(&frame, is_upright, direction, &mut random);
        let scene = world.scene();
        if let Some(held) = around(&solids, DVec3::ZERO, direction) {
            // All of the picture's rays begin as the camera's direction says.
            for pixel in [[1, 1], [0, 2]] {
                let log = record::pixel(&scene, pixel, Arithmetic::F64);
                assert_eq!(immersed(&log), held, "case {case}, pixel {pixel:?}");
                surfaces += usize::from(check_first_surface(&log, &solids, &held, &frame, scale));
            }
            counts[held.len()] += 1;
        }
        // A ray of its own begins elsewhere, and asks along itself.
        let (origin, direction) = (random.point(), random.unit());
        let Some(held) = around(&solids, origin, direction) else { continue };
        let [from, way] = [frame.point(origin.to_array()), frame.vector(direction.to_array())];
        let log = record::ray(&scene, from, way, Arithmetic::F64);
        assert_eq!(immersed(&log), held, "case {case}, a ray from {origin} along {direction}");
        surfaces += usize::from(check_first_surface(&log, &solids, &held, &frame, scale));
    }
    assert!(counts[0] > 50 && counts[1] > 100 && counts[2..].iter().sum::<i32>() > 200, "{counts:?}");
    assert!(surfaces > 1000, "{surfaces}");
}

/// Through a lens, and where a solid moves, every ray asks for itself.
#[test]
fn every_ray_of_a_lens_or_among_moving_solids_asks_for_itself() {
    let mut random = Random::new(702);
    let (mut counts, mut differing) = ([0; 5], 0);
    for case in 0..200 {
        let (frame, is_upright) = frames(&mut random, case);
        let direction = random.unit();
        let (mut solids, mut world) = scattered(&frame, is_upright, direction, &mut random);
        if case % 3 == 0 {
            world =
                world.set("/camera/lens", json!({"radius": frame.length(0.3), "focus_distance": frame.length(2.0)}));
        } else {
            // Half of the way is gone when the shutter opens and closes.
            let shift = random.point() * 2.0;
            world = world.set("/camera/shutter", json!([0.5, 0.5]));
            world = world.moving(&json!({"translation": frame.span(shift.to_array())}));
            let still = solids.pop().expect("a solid");
            let depth = move |point: DVec3| (still.depth)(point - shift * 0.5);
            solids.push(Solid { depth: Box::new(depth), ior: still.ior });
        }
        let scene = world.scene();
        for pixel in [[0, 0], [1, 1], [2, 1]] {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let given = |name: Name| {
                let mut values = log.events.iter().flat_map(|event| {
                    let noted = match event.what {
                        What::Note { name, value } => Some((name, value)),
                        _ => None,
                    };
                    event.given.iter().copied().chain(noted)
                });
                values.find(|(known, _)| *known == name).map(|(_, value)| triple(value))
            };
            let origin = frame.own(given(Name::RayOrigin).expect("an origin"));
            let way = given(Name::RayDirection).expect("a direction");
            let way = frame.own(frame.point([0.0; 3]) + way * frame.length(1.0));
            let Some(held) = around(&solids, origin, way) else { continue };
            assert_eq!(immersed(&log), held, "case {case}, pixel {pixel:?}");
            counts[held.len()] += 1;
            differing += usize::from(around(&solids, DVec3::ZERO, direction).is_some_and(|eye| eye != held));
        }
    }
    assert!(counts[0] > 20 && counts[1] > 50 && counts[2..].iter().sum::<i32>() > 100, "{counts:?}");
    assert!(differing > 30, "{differing}");
}
