//! The rays of a packet have the hits that each of them has alone, to the last bit.

use crate::random::Random;
use crate::worlds::{World, magnitude, world};
use glam::DVec3;
use rayon::prelude::*;
use raywalk::geometry::PACKET;
use raywalk::scene::Scene;
use raywalk::trace::query::Query;
use std::sync::atomic::{AtomicU64, Ordering};

/// One to eight rays: neighbours from an eye, neighbours from anywhere, or rays that have nothing to do with each other.
fn packet(world: &World, random: &mut Random) -> Vec<Query> {
    let World { middle, size, targets, .. } = world;
    let kind = random.below(6);
    let far = magnitude(random, 0, 14);
    let eye = *middle + random.point() * *size * if random.below(2) == 0 { 1.0 } else { 3.0 };
    let target = targets[random.below(targets.len())];
    let spread = *size * magnitude(random, -9, -1);
    let one = |random: &mut Random| {
        let (origin, target) = match kind {
            0 | 1 => (eye, target + random.point() * spread),
            2 => (eye + random.point() * spread, target + random.point() * spread),
            // The same ray again and again, and neighbours from very far away, each as far as it likes.
            3 => (eye, target),
            4 => (target + (eye - target) * far * (0.5 + random.part()), target + random.point() * spread),
            _ => (*middle + random.point() * *size * 2.0, targets[random.below(targets.len())]),
        };
        let mut direction = target - origin;
        match random.below(10) {
            // Of single precision, as files have them.
            0 => direction = direction.normalize_or(DVec3::X).as_vec3().as_dvec3(),
            1 => direction *= magnitude(random, -3, 3),
            2 => direction[random.below(3)] = if random.below(2) == 0 { 0.0 } else { -0.0 },
            _ => {}
        }
        if direction == DVec3::ZERO {
            direction = DVec3::X;
        }
        let way = (target - origin).length() / direction.length();
        let t_min = if random.below(8) == 0 { way * random.part() } else { 0.0 };
        let t_max = if random.below(3) == 0 { way * (0.5 + random.part()) } else { f64::INFINITY };
        Query { origin, direction, t_min, t_max, from: None }
    };
    let mut queries: Vec<_> = (0..1 + random.below(PACKET)).map(|_| one(random)).collect();
    if random.below(8) == 0 {
        // Ends in the wrong order, and rays of no length.
        let query = random.below(queries.len());
        (queries[query].t_min, queries[query].t_max) = (*size * random.part(), *size * random.part() * 1e-3);
    }
    queries
}

/// The same number of rays that leave the surface where the first ray hits it.
fn leaving(scene: &Scene, queries: &[Query], random: &mut Random) -> Option<Vec<Query>> {
    let answer = queries.first()?.nearest(scene)?;
    let way = random.unit();
    let spread = magnitude(random, -6, 0);
    let one = |random: &mut Random| Query {
        origin: answer.point,
        direction: way + random.point() * spread * 0.5,
        t_min: 0.0,
        t_max: f64::INFINITY,
        from: (random.below(4) != 0).then_some((answer.object, answer.primitive)),
    };
    Some(queries.iter().map(|_| one(random)).filter(|query| query.direction != DVec3::ZERO).collect())
}

#[derive(Default)]
struct Tally {
    hits: AtomicU64,
    misses: AtomicU64,
}

fn compare(scene: &Scene, queries: &[Query], number: u64, tally: &Tally) {
    let mut alone = queries.iter().map(|query| query.hit(scene));
    Query::hits(queries, scene, |hit| {
        let expected = alone.next().expect("no more answers than rays");
        let bits = |hit: raywalk::trace::query::RayHit| (hit.object, hit.primitive, hit.t.to_bits());
        assert_eq!(hit.map(bits), expected.map(bits), "world {number}: {queries:?}");
        let outcome = if hit.is_some() { &tally.hits } else { &tally.misses };
        outcome.fetch_add(1, Ordering::Relaxed);
    });
    assert!(alone.next().is_none(), "as many answers as rays");
    let expected: u32 = (0..).zip(queries).map(|(at, query): (u32, _)| u32::from(query.is_occluded(scene)) << at).sum();
    assert_eq!(Query::are_occluded(queries, scene), expected, "world {number}: {queries:?}");
}

#[test]
fn rays_that_walk_together_meet_what_they_meet_alone() {
    let tally = Tally::default();
    (0..360_u64).into_par_iter().for_each(|number| {
        let world = world(number);
        let mut random = Random::new(!number);
        let scenes = [Some(world.shapes.clone()), world.mesh.clone().map(|mesh| vec![mesh])];
        for mut scene in scenes.into_iter().flatten().map(|shapes| Scene::of_shapes("world", shapes)) {
            if random.below(2) == 0 {
                scene.objects.iter_mut().for_each(|object| object.one_sided = random.below(2) == 0);
            }
            for _ in 0..60 {
                let queries = packet(&world, &mut random);
                compare(&scene, &queries, number, &tally);
                if let Some(queries) = leaving(&scene, &queries, &mut random) {
                    compare(&scene, &queries, number, &tally);
                }
            }
        }
    });
    let (hits, misses) = (tally.hits.into_inner(), tally.misses.into_inner());
    assert!(hits > 50_000 && misses > 20_000, "{hits} hits, {misses} misses");
}
