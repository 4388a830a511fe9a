//! A shaft through a tree finds whatever a ray from its point to some point of the light crosses, in worlds and for shafts made to find where
//! it wouldn't.

use crate::random::Random;
use crate::worlds::{World, magnitude, world};
use glam::DVec3;
use rayon::prelude::*;
use raywalk::geometry::{Bounds, Crossing, Intersect, Leaving, Ray, Shaft, Side, Target};
use raywalk::probe::Silent;
use std::sync::atomic::{AtomicU64, Ordering};

/// How many rays go to the light from the point of a shaft.
const RAYS: usize = 24;

/// What the shafts found, so that a test that sees one kind of them only is seen through.
#[derive(Default)]
struct Tally {
    shafts: AtomicU64,
    complete: AtomicU64,
    primitives: AtomicU64,
    found: AtomicU64,
    crossed: AtomicU64,
    meshes: AtomicU64,
    free_meshes: AtomicU64,
    crossed_meshes: AtomicU64,
}

fn count(of: &AtomicU64, number: usize) {
    of.fetch_add(number as u64, Ordering::Relaxed);
}

/// A point on a surface that a ray has met.
struct Met {
    ray: Ray,
    object: u32,
    crossing: Crossing,
}

/// A ray into the world, and what it hits first of all shapes.
fn met(world: &World, random: &mut Random) -> Option<Met> {
    let World { middle, size, targets, .. } = world;
    let origin = *middle + random.unit() * *size * 3.0;
    let target = targets[random.below(targets.len())] + random.point() * *size * magnitude(random, -9, -1);
    let ray = Ray::along(origin, target - origin);
    let meet = |object: u32| {
        let crossing = world.shapes[object as usize].first_crossing(Target::two_sided(object), &ray, &mut Silent)?;
        Some(Met { ray, object, crossing })
    };
    (0..world.shapes.len() as u32).filter_map(meet).min_by(|a, b| a.crossing.t.total_cmp(&b.crossing.t))
}

/// A box for a light, seldom far from the world, of which some sides may be 0; and a point of it.
fn light(world: &World, point: DVec3, random: &mut Random) -> Bounds {
    let World { middle, size, targets, .. } = world;
    let center = match random.below(6) {
        0 => *middle + random.unit() * *size * magnitude(random, 0, 4),
        1 => targets[random.below(targets.len())],
        2 => point + random.unit() * *size * magnitude(random, -6, 0),
        3 => *middle + random.point() * *size,
        _ => *middle + random.unit() * *size * (2.0 + random.part()),
    };
    let mut half = random.point().abs() * (center - point).length() * magnitude(random, -3, 0);
    for axis in 0..3 {
        if random.part() < 0.4 {
            half[axis] = 0.0;
        }
    }
    Bounds { min: center - half, max: center + half }
}

fn point_of(light: &Bounds, random: &mut Random) -> DVec3 {
    let part = |random: &mut Random| match random.below(4) {
        0 => 0.0,
        1 => 1.0,
        _ => random.part(),
    };
    light.min + (light.max - light.min) * DVec3::new(part(random), part(random), part(random))
}

/// The shaft from a point to the light, with the vector if it rises along that, or along the opposite one; and the side of the vector on
/// which the light then lies.
fn shaft_to(point: DVec3, light: Bounds, along: DVec3) -> (Shaft, Option<Side>) {
    let radius = (light.max - light.min).length() * 0.5 * (1.0 + 1e-12);
    let shaft = Shaft::new(point, light, (light.center(), radius));
    match shaft.rise_along(along) {
        [least, _] if least > 0.0 => (shaft.rising(along, least), Some(Side::Front)),
        [_, most] if most < 0.0 => (shaft.rising(-along, -most), Some(Side::Back)),
        _ => (shaft, None),
    }
}

/// The shadow ray to a point of the light, as the tracer makes it.
fn shadow_ray(point: DVec3, to: DVec3, leaving: Option<Leaving>, slack: f64) -> Option<Ray> {
    let distance = (to - point).length();
    let is_plain = distance > 0.0 && distance.is_finite();
    is_plain.then(|| Ray {
        t_max: distance,
        wants_distance: false,
        leaving,
        slack,
        ..Ray::new(point, (to - point) / distance)
    })
}

/// Whatever of a world's shapes a ray to the light crosses, the shaft has found.
fn compare(world: &World, number: u64, random: &mut Random, tally: &Tally) {
    let met = met(world, random);
    let (point, along, leaving, slack) = match &met {
        Some(met) if random.part() < 0.7 => {
            let surface = world.shapes[met.object as usize].surface(&met.ray, met.crossing, &mut Silent);
            let leaving = Leaving { object: met.object, primitive: met.crossing.primitive, side: met.crossing.side };
            let slack = met.ray.slack_at(surface.point, &Silent) + world.shapes[met.object as usize].slack();
            (surface.point, surface.normal, Some(leaving), slack)
        }
        _ => (world.middle + random.point() * world.size * 1.5, random.unit(), None, 0.0),
    };
    let light = light(world, point, random);
    let (shaft, side) = shaft_to(point, light, along);
    let mut found = Vec::new();
    let is_complete = world.tree.between(&shaft, |primitive| {
        found.push(primitive);
        true
    });
    count(&tally.shafts, 1);
    if !is_complete {
        return;
    }
    count(&tally.complete, 1);
    count(&tally.primitives, world.shapes.len());
    count(&tally.found, found.len());
    // The normal is on the side from which the ray has come.
    let leaving = leaving.map(|leaving| match side {
        Some(Side::Back) => Leaving { side: leaving.side.opposite(), ..leaving },
        _ => leaving,
    });
    let is_free_mesh = world.mesh.as_ref().and_then(|mesh| {
        let leaving = leaving.filter(|_| side.is_some()).map(|leaving| Leaving {
            primitive: leaving.object,
            object: 0,
            ..leaving
        });
        Some((mesh, leaving, !mesh.can_be_crossed_in(&shaft, leaving))).filter(|_| leaving.is_some() || met.is_none())
    });
    if let Some((_, _, is_free)) = is_free_mesh {
        count(&tally.meshes, 1);
        count(&tally.free_meshes, usize::from(is_free));
    }
    for _ in 0..RAYS {
        let to = point_of(&light, random);
        let Some(ray) = shadow_ray(point, to, leaving, slack) else { continue };
        for (primitive, shape) in (0..).zip(&world.shapes) {
            let crossing = shape.first_crossing(Target::two_sided(primitive), &ray, &mut Silent);
            if let Some(crossing) = crossing {
                count(&tally.crossed, 1);
                let is_found = found.contains(&primitive);
                assert!(is_found, "world {number}: {ray:?} crosses {primitive} at {crossing:?}, beside {shaft:?}");
                let own = leaving.filter(|leaving| leaving.object == primitive && side.is_some());
                assert!(shape.can_be_crossed_in(&shaft, own), "world {number}: {ray:?} crosses {primitive} again");
            }
        }
        if let Some((mesh, leaving, is_free)) = is_free_mesh {
            let is_crossed = mesh.is_crossed(Target::two_sided(0), &Ray { leaving, ..ray }, &mut Silent);
            assert!(
                !is_free || !is_crossed,
                "world {number}: {ray:?} crosses the mesh, leaving {leaving:?}, in {shaft:?}"
            );
            count(&tally.crossed_meshes, usize::from(is_crossed));
        }
    }
}

fn compare_worlds(worlds: u64, shafts: u64) {
    let tally = Tally::default();
    (0..worlds).into_par_iter().for_each(|number| {
        let world = world(number);
        let mut random = Random::new(!number ^ 0x5a);
        for _ in 0..shafts {
            compare(&world, number, &mut random, &tally);
        }
    });
    let [shafts, complete, primitives, found, crossed] =
        [tally.shafts, tally.complete, tally.primitives, tally.found, tally.crossed].map(AtomicU64::into_inner);
    let [meshes, free_meshes, crossed_meshes] =
        [tally.meshes, tally.free_meshes, tally.crossed_meshes].map(AtomicU64::into_inner);
    println!("{complete} of {shafts} shafts complete, {found} of {primitives} primitives found, {crossed} crossed");
    println!("{free_meshes} of {meshes} meshes free, {crossed_meshes} rays crossed one");
    assert!(complete * 4 > shafts * 3, "{complete} of {shafts} shafts were complete");
    assert!(
        found * 4 < primitives && crossed > shafts,
        "{found} of {primitives} primitives were found, {crossed} crossed"
    );
    assert!(free_meshes * 4 > meshes && crossed_meshes > meshes, "{free_meshes} of {meshes} meshes were free");
}

#[test]
fn a_shaft_finds_whatever_a_shadow_ray_crosses() {
    compare_worlds(450, 60);
}

#[test]
#[ignore = "ten million shadow rays take minutes"]
fn a_shaft_finds_whatever_a_shadow_ray_crosses_in_ten_million() {
    compare_worlds(10_500, 40);
}
