//! The tree of boxes and its tests in single precision never change an answer: what they show of a world holds every primitive that decides,
//! in worlds and for rays made to find where they wouldn't.
//!
//! ```text
//! cargo test --release --test shapes filters_are_conservative -- --ignored      # ten million rays
//! ```

use crate::random::Random;
use crate::worlds::{World, corners_of, magnitude, world};
use glam::DVec3;
use rayon::prelude::*;
use raywalk::geometry::{Crossing, Intersect, Leaving, Ray, Search, Shape, Target};
use raywalk::probe::Silent;
use std::sync::atomic::{AtomicU64, Ordering};

/// Hits this close to the nearest, in parts of its distance, are compared with more digits, so they must be shown too.
const NEAR_TIE: f64 = 8.0 * f64::EPSILON;

/// Farther away, in sizes of the world, a point of a small sphere has no digits left and may lie beside the sphere: what leaves it then
/// doesn't begin where it says.
const NEARBY: f64 = 1e6;

/// How many rays hit and missed, so that a test that sees one of both only is seen through.
#[derive(Default)]
struct Tally {
    hits: AtomicU64,
    misses: AtomicU64,
    culled: AtomicU64,
    /// Hits of which the tree was sure.
    sure: AtomicU64,
    /// Boxes that a look says to be missed, and others.
    missed_boxes: AtomicU64,
    boxes: AtomicU64,
}

/// A ray that is hard on the tests.
fn ray(world: &World, random: &mut Random) -> Ray {
    let World { middle, size, targets, .. } = world;
    let mut target = targets[random.below(targets.len())];
    let mut origin = match random.below(8) {
        0 | 1 => *middle + random.point() * *size,
        2 | 3 => *middle + random.point() * *size * 3.0,
        4 => *middle + random.unit() * *size * magnitude(random, 1, 12),
        5 => targets[random.below(targets.len())],
        6 => target + random.unit() * *size * magnitude(random, -12, 0),
        _ => *middle + random.point() * *size * 1.5,
    };
    if random.part() < 0.25 {
        target = *middle + random.point() * *size;
    }
    let mut vector = target - origin;
    // Along an axis or a plane of two, through the target.
    match random.below(8) {
        0 => {
            let axis = random.below(3);
            vector = DVec3::AXES[axis] * if vector[axis] < 0.0 { -*size } else { *size };
            origin = target - vector * (0.5 + 4.0 * random.part());
        }
        1 => vector[random.below(3)] = 0.0,
        2 => vector[random.below(3)] *= 1e-17,
        _ => {}
    }
    if vector == DVec3::ZERO {
        vector = random.unit();
    }
    let mut ray = Ray::along(origin, vector * magnitude(random, -3, 3));
    match random.below(6) {
        0 => ray.t_max = (target - origin).length() * (0.5 + random.part()),
        1 => ray.t_max = (target - origin).length(),
        2 => ray.t_min = (target - origin).length() * (0.5 + random.part()),
        _ => {}
    }
    if random.part() < 0.1 {
        // A reflected ray has no other vector than its direction, whose length is 1 to a few roundings.
        ray.direction *= 1.0 + 2.0 * f64::EPSILON * (random.part() - 0.5);
        ray.vector = ray.direction;
    }
    ray
}

/// A ray that leaves a sphere inward or outward from where another ray has met it.
fn spawned(world: &World, from: &Ray, object: u32, crossing: Crossing, random: &mut Random) -> Ray {
    let surface = world.shapes[object as usize].surface(from, crossing, &mut Silent);
    let way = random.unit();
    let is_back = way.dot(surface.normal) < 0.0;
    let side = if is_back { crossing.side.opposite() } else { crossing.side };
    let leaving = Some(Leaving { object, primitive: crossing.primitive, side });
    Ray { leaving, slack: from.slack_at(surface.point, &Silent), ..Ray::along(surface.point, way) }
}

/// The first of the crossings with triangles that coincide with the nearest one: within 64 roundings of all coordinates. Of triangles
/// that share one or two corners only the one that is hit first counts: the ray goes through the edge or the corner between them.
fn first_in_place(shapes: &[Shape], all: &[(u32, Crossing)], ray: &Ray) -> Option<(u32, Crossing)> {
    let mut all = all.to_vec();
    all.sort_by(|(a, one), (b, other)| one.t.total_cmp(&other.t).then(a.cmp(b)));
    let nearest = *all.first()?;
    let corners = |primitive: u32| corners_of(&shapes[primitive as usize]).expect("a triangle");
    let slope = |(primitive, crossing): &(u32, Crossing)| {
        let surface = shapes[*primitive as usize].surface(ray, *crossing, &mut Silent);
        surface.geometric_normal().dot(ray.direction).abs()
    };
    let size =
        |primitive: u32| corners(primitive).map(|corner| corner.abs().max_element()).into_iter().fold(0.0, f64::max);
    let is_here = |other: &&(u32, Crossing)| {
        let points = 2.0 * (ray.origin.abs().element_sum() + other.1.t);
        let gap = (other.1.t - nearest.1.t) * slope(&nearest).max(slope(other));
        // However flat the ray runs, what it hits so much later isn't in the same place.
        let is_close = other.1.t - nearest.1.t <= (nearest.1.t + ray.origin.abs().element_sum()) / f64::from(1 << 20);
        is_close && gap <= 32.0 * f64::EPSILON * (points + size(nearest.0) + size(other.0))
    };
    let are_neighbors = |one: u32, other: u32| {
        let in_common = corners(one).iter().filter(|corner| corners(other).contains(corner)).count();
        matches!(in_common, 1 | 2)
    };
    let mut here = vec![nearest];
    for hit in all.iter().skip(1).filter(is_here) {
        if !here.iter().any(|kept| are_neighbors(kept.0, hit.0)) {
            here.push(*hit);
        }
    }
    here.into_iter().min_by_key(|(primitive, _)| *primitive)
}

/// Compares what the tree shows with everything; returns the nearest hit.
fn compare(world: &World, number: u64, ray: &Ray, tally: &Tally) -> Option<(u32, Crossing)> {
    let meet = |primitive: u32, ray: &Ray| {
        world.shapes[primitive as usize].first_crossing(Target::two_sided(primitive), ray, &mut Silent)
    };
    let all: Vec<(u32, Crossing)> =
        (0..world.shapes.len() as u32).filter_map(|primitive| Some((primitive, meet(primitive, ray)?))).collect();
    let nearest = all.iter().copied().min_by(|(a, one), (b, other)| one.t.total_cmp(&other.t).then(a.cmp(b)));
    let mut shown = Vec::new();
    let mut t_max = ray.t_max;
    world.tree.visit::<Silent>(ray, Search::nearest_first(&Silent), |primitive, _| {
        shown.push(primitive);
        if let Some(crossing) = meet(primitive, ray) {
            t_max = t_max.min(crossing.t);
        }
        t_max
    });
    if let Some((_, Crossing { t, .. })) = nearest {
        for (primitive, crossing) in &all {
            let decides = crossing.t - t <= NEAR_TIE * crossing.t.abs();
            assert!(
                !decides || shown.contains(primitive),
                "world {number}: {primitive} at {crossing:?} isn't shown to {ray:?}"
            );
        }
    }
    are_missed_boxes_empty(world, number, ray, &all, tally);
    let quick = Ray { wants_distance: false, ..*ray };
    let mut is_occluded = false;
    world.tree.visit::<Silent>(&quick, Search::of_any(&Silent), |primitive, is_sure| {
        let is_met = meet(primitive, &quick).is_some();
        // The caller excludes the object that a ray leaves.
        let is_left = ray.leaving.is_some_and(|leaving| leaving.object == primitive);
        assert!(
            is_met || is_left || !is_sure,
            "world {number}: {ray:?} doesn't cross {primitive}, of which the tree is sure"
        );
        tally.sure.fetch_add(u64::from(is_sure), Ordering::Relaxed);
        is_occluded |= is_met;
        if is_occluded { -1.0 } else { ray.t_max }
    });
    assert_eq!(is_occluded, nearest.is_some(), "world {number}: occlusion of {ray:?} by {nearest:?}");
    if let (Some(mesh), None) = (&world.mesh, ray.leaving) {
        let found = mesh.first_crossing(Target::two_sided(0), ray, &mut Silent);
        let found = found.map(|crossing| (crossing.primitive, crossing.t.to_bits(), crossing.side));
        let expected = first_in_place(&world.shapes, &all, ray);
        let expected = expected.map(|(primitive, crossing)| (primitive, crossing.t.to_bits(), crossing.side));
        assert_eq!(found, expected, "world {number}: the mesh and {ray:?}");
        assert_eq!(
            mesh.is_crossed(Target::two_sided(0), &quick, &mut Silent),
            nearest.is_some(),
            "world {number}: {ray:?}"
        );
    }
    tally.culled.fetch_add((world.shapes.len() - shown.len()) as u64, Ordering::Relaxed);
    let outcome = if nearest.is_some() { &tally.hits } else { &tally.misses };
    outcome.fetch_add(1, Ordering::Relaxed);
    nearest
}

/// No shape is met whose box a look says to be missed, whatever the length of the direction.
fn are_missed_boxes_empty(world: &World, number: u64, ray: &Ray, all: &[(u32, Crossing)], tally: &Tally) {
    // Of middling length, and so short that squares vanish.
    for scale in [1.0, 0.75e-3, 1e-200] {
        for (primitive, shape) in (0..).zip(&world.shapes) {
            let Some(bounds) = shape.bounds() else { continue };
            if bounds.is_surely_missed(ray.origin, ray.direction * scale) {
                tally.missed_boxes.fetch_add(1, Ordering::Relaxed);
                let met = all.iter().find(|(met, _)| *met == primitive);
                assert!(met.is_none(), "world {number}: {ray:?} meets {primitive} outside its box: {met:?}");
            } else if scale == 1.0 {
                tally.boxes.fetch_add(1, Ordering::Relaxed);
            }
        }
    }
}

/// Compares this many worlds, each with this many rays and as many as leave what those have met.
fn compare_worlds(worlds: u64, rays: u64) {
    let tally = Tally::default();
    (0..worlds).into_par_iter().for_each(|number| {
        let world = world(number);
        let mut random = Random::new(!number);
        for _ in 0..rays {
            let ray = ray(&world, &mut random);
            if let Some((object, crossing)) = compare(&world, number, &ray, &tally)
                && matches!(world.shapes[object as usize], Shape::Sphere(_) | Shape::Triangle(_))
                && crossing.t < NEARBY * world.size
            {
                compare(&world, number, &spawned(&world, &ray, object, crossing, &mut random), &tally);
            }
        }
    });
    let [hits, misses, culled] = [&tally.hits, &tally.misses, &tally.culled].map(|count| count.load(Ordering::Relaxed));
    let [missed_boxes, boxes] = [&tally.missed_boxes, &tally.boxes].map(|count| count.load(Ordering::Relaxed));
    assert!(tally.sure.into_inner() > hits / 4, "the tree is hardly ever sure");
    assert!(missed_boxes > 10 * boxes, "{missed_boxes} boxes were missed, {boxes} weren't");
    println!("{hits} hits, {misses} misses, {culled} primitives not shown");
    assert!(hits > worlds * rays / 4 && misses > worlds * rays / 8, "{hits} hits, {misses} misses");
    assert!(culled / (hits + misses) > 30, "{culled} primitives weren't shown: the tree sorts out next to nothing");
}

#[test]
fn the_tree_shows_whatever_decides() {
    compare_worlds(450, 250);
}

#[test]
#[ignore = "ten million rays take minutes"]
fn the_tree_shows_whatever_decides_to_ten_million_rays() {
    compare_worlds(10_500, 700);
}
