//! The eye inside transmitting solids: which hold it, and in what order the ray leaves them.

use super::glass::{Solid, add, around};
use super::stacks::{meetings, triple};
use super::world::{Frame, World};
use crate::random::Random;
use glam::DVec3;
use raywalk::log::{Decision, Log, Name, What};
use raywalk::record::{self, Arithmetic};
use serde_json::json;

/// The objects that a log's first ray begins in, the innermost last.
pub fn immersed(log: &Log) -> Vec<u32> {
    let held = |what: &What| match what {
        What::Mark(Decision::Immersed { object }) => Some(*object),
        _ => None,
    };
    log.events.iter().filter_map(|event| held(&event.what)).collect()
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

/// Through a lens, and where a solid moves, every ray asks from its own place and at its own time; still along the camera's direction.
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
                    log.events.given(event).iter().copied().chain(noted)
                });
                values.find(|(known, _)| *known == name).map(|(_, value)| triple(value))
            };
            let origin = given(Name::RayOriginLens).map_or(DVec3::ZERO, |origin| frame.own(origin));
            let Some(held) = around(&solids, origin, direction) else { continue };
            assert_eq!(immersed(&log), held, "case {case}, pixel {pixel:?}");
            counts[held.len()] += 1;
            differing += usize::from(around(&solids, DVec3::ZERO, direction).is_some_and(|eye| eye != held));
        }
    }
    assert!(counts[0] > 20 && counts[1] > 50 && counts[2..].iter().sum::<i32>() > 100, "{counts:?}");
    assert!(differing > 30, "{differing}");
}
