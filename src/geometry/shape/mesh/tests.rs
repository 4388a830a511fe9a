#![allow(clippy::unwrap_used)]

use super::*;
use crate::geometry::bvh::{PACKET, PerRay};
use crate::geometry::ray::{Leaving, Side};
use crate::geometry::shape::{Approach, Shape};
use crate::probe::Silent;
use crate::scene::generate::{icosphere, knot};
use glam::DVec3;

/// Random numbers, the same in every run (Steele et al., Fast splittable pseudorandom number generators, 2014).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// From −1 to 1.
    fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn point(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }
}

impl TriangleMesh {
    fn first_crossing<P: Probe>(&self, target: Target, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        Shape::Mesh(Arc::new(self.clone())).first_crossing(target, ray, probe)
    }
}

fn tree(mesh: Mesh) -> TriangleMesh {
    TriangleMesh::new(Arc::new(mesh))
}

fn toward(origin: DVec3, target: DVec3) -> Ray {
    Ray::new(origin, (target - origin) / origin.distance(target))
}

/// Every kind of ray: anywhere, along an axis, through a vertex, through the middle of an edge, in the plane of a triangle.
fn any_ray(mesh: &Mesh, random: &mut Random) -> Ray {
    let origin = random.point() * 3.0;
    let vertex = mesh.positions[random.below(mesh.positions.len())];
    let [a, b, c] = mesh.corners(random.below(mesh.faces.len()) as u32);
    let axis = [DVec3::X, DVec3::Y, DVec3::Z][random.below(3)] * if random.bits() & 1 == 0 { 1.0 } else { -1.0 };
    match random.below(7) {
        0 => toward(origin, random.point()),
        1 => Ray::new(origin, axis),
        2 => toward(origin, vertex),
        3 => toward(origin, (a + b) * 0.5),
        4 => Ray::new(vertex - axis * 3.0, axis),
        5 => toward(a + (b - c) * 3.0, a),
        _ => Ray { t_max: 2.0, ..toward(vertex, random.point()) },
    }
}

/// The crossings with every triangle, without a tree, in the order of the ray.
fn all_by_force(shape: &TriangleMesh, one_sided: bool, ray: &Ray) -> Vec<Crossing> {
    let left = ray.leaving.map(|leaving| leaving.primitive);
    let mut crossings: Vec<_> = (0..shape.mesh().faces.len() as u32)
        .filter(|triangle| left != Some(*triangle))
        .filter_map(|triangle| {
            let approach = Approach { leaving: None, one_sided };
            let triangle_left = ray.leaving.and_then(|leaving| LeftTriangle::of(&shape.facets, leaving, ray));
            if triangle_left.is_some_and(|left| left.bars(&shape.facets, triangle, ray)) {
                return None;
            }
            shape.facets.get(triangle).crossing(ray, approach, triangle, |_, _| None, &mut Silent)
        })
        .collect();
    crossings.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive)));
    shape.keep_edges_once(ray, &mut crossings, 0);
    crossings
}

fn bits(crossing: &Crossing) -> (u64, u32, Side) {
    (crossing.t.to_bits(), crossing.primitive, crossing.side)
}

#[track_caller]
fn answers_as_by_force(shape: &TriangleMesh, rays: usize, seed: u64) {
    let mut random = Random(seed);
    let (mut hits, mut misses) = (0, 0);
    for _ in 0..rays {
        let mut ray = any_ray(shape.mesh(), &mut random);
        let one_sided = random.bits() & 1 == 0;
        if random.bits() & 1 == 0 {
            let primitive = random.below(shape.mesh().faces.len()) as u32;
            ray.leaving = Some(Leaving { object: 0, primitive, side: Side::Front });
        }
        let expected = all_by_force(shape, one_sided, &ray);
        let first = shape.first_crossing(Target { object: 0, one_sided }, &ray, &mut Silent);
        assert_eq!(first.as_ref().map(bits), expected.first().map(bits), "{ray:?}");
        assert_eq!(shape.is_crossed(Target { object: 0, one_sided }, &ray, &mut Silent), first.is_some(), "{ray:?}");
        let mut all = Vec::new();
        shape.all_crossings(Target { object: 0, one_sided }, &ray, &mut all, &mut Silent);
        assert_eq!(all.iter().map(bits).collect::<Vec<_>>(), expected.iter().map(bits).collect::<Vec<_>>(), "{ray:?}");
        hits += usize::from(first.is_some());
        misses += usize::from(first.is_none());
    }
    assert!(hits > rays / 10 && misses > rays / 10, "{hits} hits, {misses} misses");
}

#[test]
fn the_tree_finds_what_testing_everything_finds() {
    answers_as_by_force(&tree(icosphere(2)), 10_000, 1);
    answers_as_by_force(&tree(knot(1)), 3_000, 2);
}

#[test]
fn the_tree_finds_it_far_from_the_origin_too() {
    let mut mesh = icosphere(1);
    mesh.positions.iter_mut().for_each(|position| *position = *position * 1e-3 + DVec3::new(1e3, -2e3, 7.0));
    let shape = tree(mesh);
    let mut random = Random(3);
    let mut hits = 0;
    for _ in 0..2000 {
        let target = shape.mesh().positions[random.below(shape.mesh().positions.len())];
        let ray = toward(target + random.point() * 1e5, target + random.point() * 1e-4);
        let expected = all_by_force(&shape, false, &ray);
        let first = shape.first_crossing(Target::two_sided(0), &ray, &mut Silent);
        assert_eq!(first.as_ref().map(bits), expected.first().map(bits), "{ray:?}");
        hits += usize::from(first.is_some());
    }
    assert!(hits > 1000, "{hits}");
}

#[test]
fn of_triangles_at_the_same_place_the_first_wins() {
    let mut mesh = icosphere(1);
    // Each triangle three times, scattered over the file.
    let faces = mesh.faces.clone();
    let count = faces.len();
    mesh.faces.extend((0..count).map(|k| faces[(k * 37 + 11) % count]));
    mesh.faces.extend((0..count).map(|k| faces[(k * 23 + 5) % count]));
    mesh.normals = None;
    let shape = tree(mesh);
    answers_as_by_force(&shape, 2000, 4);
    let mut random = Random(5);
    for _ in 0..1000 {
        let first = shape.first_crossing(Target::two_sided(0), &toward(DVec3::ZERO, random.point()), &mut Silent);
        assert!(first.unwrap().primitive < count as u32);
    }
}

#[test]
fn no_ray_leaves_a_closed_mesh() {
    let shape = tree(icosphere(3));
    let mut random = Random(6);
    for _ in 0..100_000 {
        let origin = random.point() * 0.5;
        let ray = Ray { origin, ..any_ray(shape.mesh(), &mut random) };
        let ray = Ray { t_max: f64::INFINITY, ..ray };
        let crossing = shape.first_crossing(Target::two_sided(0), &ray, &mut Silent);
        assert_eq!(crossing.map(|crossing| crossing.side), Some(Side::Back), "{ray:?}");
    }
}

#[test]
fn no_ray_leaves_through_an_edge() {
    let shape = tree(icosphere(2));
    let mut random = Random(7);
    for _ in 0..300 {
        let origin = random.point() * 0.5;
        for [a, b, _] in
            shape.mesh().faces.iter().map(|face| face.map(|corner| shape.mesh().positions[corner as usize]))
        {
            let on_edge = a + (b - a) * (random.number() * 0.5 + 0.5);
            for target in [(a + b) * 0.5, on_edge] {
                assert!(
                    shape.is_crossed(Target::two_sided(0), &toward(origin, target), &mut Silent),
                    "{origin} to {target}"
                );
            }
        }
    }
}

#[test]
fn no_ray_leaves_through_a_vertex() {
    let shape = tree(icosphere(2));
    let mut random = Random(10);
    for _ in 0..300 {
        let origin = random.point() * 0.5;
        for vertex in &shape.mesh().positions {
            assert!(
                shape.is_crossed(Target::two_sided(0), &toward(origin, *vertex), &mut Silent),
                "{origin} to {vertex}"
            );
        }
    }
}

#[test]
fn a_ray_skips_the_triangle_that_it_leaves_and_no_other() {
    let twice = Mesh { faces: vec![[0, 1, 2], [0, 1, 2]], ..triangle() };
    let shape = tree(twice);
    let leaving = |object, primitive| Some(Leaving { object, primitive, side: Side::Front });
    let ray = Ray::new(DVec3::new(0.2, 0.2, 1.0), -DVec3::Z);
    for (leaving, expected) in [(None, 0), (leaving(5, 0), 1), (leaving(5, 1), 0), (leaving(4, 0), 0)] {
        let first = shape.first_crossing(Target::two_sided(5), &Ray { leaving, ..ray }, &mut Silent);
        assert_eq!(first.map(|crossing| crossing.primitive), Some(expected));
    }
}

#[test]
fn no_ray_meets_the_surface_that_it_leaves() {
    for scale in [1e-6, 1.0, 1e9] {
        let mut mesh = icosphere(2);
        mesh.positions.iter_mut().for_each(|position| *position = (*position + DVec3::splat(3.0)) * scale);
        let shape = tree(mesh);
        let mut random = Random(9);
        let (mut away, mut through) = (0, 0);
        for _ in 0..30_000 {
            let (arriving, front) = onto_an_edge(&shape, scale, &mut random);
            let Some(crossing) = shape.first_crossing(Target { object: 0, one_sided: true }, &arriving, &mut Silent)
            else {
                continue;
            };
            let point = shape.surface(&arriving, crossing, &mut Silent).point;
            let leaving = Some(Leaving { object: 0, primitive: crossing.primitive, side: crossing.side });
            let direction = random.point();
            let ray = Ray { leaving, ..Ray::new(point, direction / direction.length()) };
            let next = shape.first_crossing(Target::two_sided(0), &ray, &mut Silent);
            // The ball is convex: away from it there is nothing, and into it there is its other side.
            if front(crossing.primitive).dot(ray.direction) > 0.0 {
                assert_eq!(next, None, "{ray:?}");
                away += 1;
            } else if let Some(next) = next {
                assert_eq!(next.side, Side::Back, "{ray:?}");
                through += 1;
            }
        }
        assert!(away > 5000 && through > 5000, "{away} {through}");
    }
}

/// A ray from outside to an edge, or to a place within rounding of it; and the normals of the triangles.
fn onto_an_edge<'s>(
    shape: &'s TriangleMesh,
    scale: f64,
    random: &mut Random,
) -> (Ray, impl Fn(u32) -> DVec3 + use<'s>) {
    let front = |triangle| {
        let [a, b, c] = shape.mesh().corners(triangle);
        (b - a).cross(c - a)
    };
    let triangle = random.below(shape.mesh().faces.len()) as u32;
    let [a, b, _] = shape.mesh().corners(triangle);
    let target = a + (b - a) * random.number().abs() + random.point() * (scale * 1e-15 * random.below(3) as f64);
    let normal = front(triangle);
    let origin = target + (normal / normal.length() + random.point() * 0.5) * (scale * 10.0);
    (toward(origin, target), front)
}

#[test]
fn triangles_without_area_keep_their_numbers() {
    let shape = tree(Mesh { faces: vec![[0, 0, 1], [0, 1, 2], [2, 2, 2]], ..triangle() });
    let ray = Ray::new(DVec3::new(0.2, 0.2, 1.0), -DVec3::Z);
    let first = shape.first_crossing(Target::two_sided(0), &ray, &mut Silent);
    assert_eq!(first, Some(Crossing { t: 1.0, side: Side::Front, primitive: 1 }));
    let nothing = tree(Mesh { faces: vec![[0, 0, 1]], ..triangle() });
    assert_eq!(nothing.bounds(), None);
    assert_eq!(nothing.first_crossing(Target::two_sided(0), &ray, &mut Silent), None);
}

#[test]
fn normals_are_blended_and_turned_toward_the_ray() {
    let shape = Shape::Mesh(Arc::new(tree(icosphere(3))));
    let mut random = Random(8);
    for origin in [DVec3::ZERO, DVec3::new(0.1, 0.2, 3.0)] {
        for _ in 0..1000 {
            let ray = toward(origin, random.point() * 0.5);
            let crossing = shape.first_crossing(Target::two_sided(0), &ray, &mut Silent).unwrap();
            let surface = shape.surface(&ray, crossing, &mut Silent);
            assert!(surface.geometric_normal().dot(ray.direction) < 0.0);
            let radial = surface.point / surface.point.length();
            let radial = if crossing.side == Side::Front { radial } else { -radial };
            assert!((surface.normal.length() - 1.0).abs() < 1e-12);
            assert!(surface.normal.distance(radial) < 1e-3, "{} is not {radial}", surface.normal);
            assert!(surface.beneath.is_some_and(|normal| normal != surface.normal));
        }
    }
}

#[test]
fn tests_are_logged_by_triangle() {
    use crate::log::What;
    use crate::probe::Recorder;
    let shape = Shape::Mesh(Arc::new(tree(triangle())));
    let mut recorder = Recorder::default();
    shape.first_crossing(Target::two_sided(3), &Ray::new(DVec3::new(0.2, 0.2, 1.0), -DVec3::Z), &mut recorder);
    let step = Step::Test { object: 3, triangle: Some(0) };
    assert_eq!(recorder.events()[0].what, What::Enter { parent: 0, step });
}

fn triangle() -> Mesh {
    Mesh { positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y], normals: None, faces: vec![[0, 1, 2]] }
}

#[test]
fn an_edge_is_crossed_once() {
    // A square of two triangles, and the same once more, the other way round.
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    let once = tree(Mesh { positions: positions.clone(), normals: None, faces: vec![[0, 1, 2], [0, 2, 3]] });
    let faces = vec![[0, 1, 2], [0, 2, 3], [2, 1, 0], [3, 2, 0]];
    let twice = tree(Mesh { positions, normals: None, faces });
    for on_diagonal in [0.25, 0.3, 0.7] {
        let ray = toward(DVec3::new(0.1, 0.4, 2.0), DVec3::new(on_diagonal, on_diagonal, 0.0));
        for (shape, count) in [(&once, 1), (&twice, 2)] {
            let mut found = Vec::new();
            shape.all_crossings(Target::two_sided(0), &ray, &mut found, &mut Silent);
            assert_eq!(found.len(), count, "{found:?}");
        }
    }
}

/// A mesh of few corners and many triangles, whose tree has each triangle once, beside the same with so many unused corners that nobody looks
/// for copies.
#[test]
fn triangles_that_are_there_again_are_hit_as_often() {
    let random = &mut Random(7);
    let corners: Vec<DVec3> = (0..6).map(|_| random.point()).collect();
    let faces: Vec<[u32; 3]> = (0..5000).map(|_| [0; 3].map(|_| random.below(6) as u32)).collect();
    let unused = vec![DVec3::ONE; 1000];
    let positions = [corners.clone(), unused].concat();
    let alone = tree(Mesh { positions, normals: None, faces: faces.clone() });
    let mesh = Mesh { positions: corners, normals: None, faces };
    let shared = tree(mesh.clone());
    assert!(shared.copies != Copies::default() && alone.copies == Copies::default());
    let mut met = 0;
    for _ in 0..40 {
        let rays: Vec<Ray> = (0..PACKET)
            .map(|_| {
                let leaving = Leaving { object: 0, primitive: random.below(5000) as u32, side: Side::Front };
                let ray = any_ray(&mesh, random);
                Ray { leaving: (random.bits() & 1 == 0).then_some(leaving), ..ray }
            })
            .collect();
        let together = [&shared, &alone].map(|shape| {
            let mut nearest: PerRay<Nearest> = std::array::from_fn(|at| Nearest::of(&rays[at]));
            let mut limits: PerRay<f64> = std::array::from_fn(|at| rays[at].t_max);
            let mut crossed = limits;
            shape.nearest_together(Target::two_sided(0), &rays, 0xff, &mut nearest, &mut limits, &mut Silent);
            shape.cross_together(Target::two_sided(0), &rays, 0xff, &mut crossed, &mut Silent);
            let shape = Shape::Mesh(Arc::new(shape.clone()));
            let first = |(nearest, ray): (Nearest, &Ray)| {
                nearest.place(ray, |_| &shape, &Silent).first().map(|hit| hit.crossing)
            };
            let firsts: Vec<_> = nearest.into_iter().zip(&rays).map(first).collect();
            (firsts, crossed.map(|limit| limit < 0.0))
        });
        assert_eq!(together[0], together[1]);
        for (at, ray) in rays.iter().enumerate() {
            let seen = [&shared, &alone].map(|shape| {
                let mut all = Vec::new();
                shape.all_crossings(Target::two_sided(0), ray, &mut all, &mut Silent);
                (
                    shape.first_crossing(Target::two_sided(0), ray, &mut Silent),
                    shape.is_crossed(Target::two_sided(0), ray, &mut Silent),
                    all,
                )
            });
            assert_eq!(seen[0], seen[1]);
            assert_eq!((together[0].0[at], together[0].1[at]), (seen[0].0, seen[0].1));
            met += usize::from(seen[0].2.len() > 1);
        }
    }
    assert!(met > 30, "{met} rays cross several triangles");
}
