//! Closed bodies of polygons are closed: a ray from within that is aimed at an edge or a corner hits exactly one face.

use crate::random::Random;
use glam::DVec3;
use raywalk::geometry::shape::{Polygon, Triangle};
use raywalk::geometry::{Ray, Shape, Target};
use raywalk::probe::Silent;

/// A prism over a star around 0, turned, stretched and moved: mostly concave caps, and quads as sides.
struct Body {
    middle: DVec3,
    faces: Vec<Vec<DVec3>>,
}

impl Body {
    fn any(random: &mut Random, size: f64, offset: f64) -> Body {
        let count = 3 + random.below(8);
        let axes = [random.unit(), random.unit(), random.unit()];
        let middle = random.point() * offset;
        let outline: Vec<[f64; 2]> = (0..count)
            .map(|k| {
                let (sine, cosine) = libm::sincos(std::f64::consts::TAU * k as f64 / count as f64);
                let radius = 0.4 + random.part();
                [cosine * radius, sine * radius]
            })
            .collect();
        let place = |[x, y]: [f64; 2], z: f64| middle + (axes[0] * x + axes[1] * y + axes[2] * z) * size;
        let cap = |z: f64| outline.iter().map(|corner| place(*corner, z)).collect::<Vec<_>>();
        let side = |k: usize| {
            let next = (k + 1) % count;
            vec![place(outline[k], -1.0), place(outline[next], -1.0), place(outline[next], 1.0), place(outline[k], 1.0)]
        };
        let mut faces: Vec<_> = (0..count).map(side).collect();
        faces.extend([cap(-1.0), cap(1.0)]);
        // Nothing depends on which way round a face is run or where it begins.
        for face in &mut faces {
            let first = random.below(face.len());
            face.rotate_left(first);
            if random.below(2) == 0 {
                face.reverse();
            }
        }
        Body { middle, faces }
    }

    fn shapes(&self) -> Vec<Shape> {
        let corners = |face: &[DVec3]| face.iter().map(|corner| corner.to_array()).collect::<Vec<_>>();
        self.faces.iter().map(|face| Shape::Polygon(Box::new(Polygon::new(&corners(face), None)))).collect()
    }

    /// A point of an edge, or a corner.
    fn target(&self, random: &mut Random) -> DVec3 {
        let face = &self.faces[random.below(self.faces.len())];
        let at = random.below(face.len());
        let (from, to) = (face[at], face[(at + 1) % face.len()]);
        let part = if random.below(8) == 0 { 0.0 } else { random.part() };
        from + (to - from) * part
    }
}

fn hits(shapes: &[Shape], ray: &Ray) -> usize {
    shapes.iter().filter(|shape| shape.first_crossing(Target::two_sided(0), ray, &mut Silent).is_some()).count()
}

#[test]
fn a_ray_from_within_meets_one_face() {
    let mut random = Random::new(11);
    for number in 0..600 {
        let size = [1e-6, 1.0, 1e9][number % 3];
        let body = Body::any(&mut random, size, size * [0.0, 1.0, 1e3][number / 3 % 3]);
        let shapes = body.shapes();
        for _ in 0..200 {
            let ray = Ray::along(body.middle, body.target(&mut random) - body.middle);
            assert_eq!(hits(&shapes, &ray), 1, "{ray:?} in {:?}", body.faces);
        }
    }
}

#[test]
fn a_ray_from_without_meets_an_even_number_of_faces() {
    let mut random = Random::new(12);
    let mut met = 0;
    for _ in 0..400 {
        let body = Body::any(&mut random, 1.0, 0.0);
        let shapes = body.shapes();
        for _ in 0..200 {
            let origin = body.middle + random.unit() * 9.0;
            let ray = Ray::along(origin, body.target(&mut random) - origin);
            let count = hits(&shapes, &ray);
            assert_eq!(count % 2, 0, "{ray:?} in {:?}", body.faces);
            met += usize::from(count > 0);
        }
    }
    // Edges of the outline are met or passed, the others lie before the body.
    assert!((30_000..80_000).contains(&met), "{met}");
}

#[test]
fn a_polygon_has_the_points_of_its_triangles() {
    let mut random = Random::new(13);
    for _ in 0..2000 {
        let plane = [random.point(), random.unit(), random.unit()];
        let corners = [[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [-1.0, 2.0]]
            .map(|[x, y]| plane[0] + plane[1] * x + plane[2] * y)
            .map(|corner| corner.to_array());
        let [a, b, c, d] = corners;
        let polygon = Shape::Polygon(Box::new(Polygon::new(&corners, None)));
        let halves = [[a, b, c], [a, c, d]].map(|half| Shape::Triangle(Box::new(Triangle::new(half, None))));
        for _ in 0..20 {
            let origin = random.unit() * 20.0;
            let (a, c) = (DVec3::from(a), DVec3::from(c));
            // On the diagonal, which is no edge of the polygon.
            let target = a + (c - a) * (0.01 + 0.98 * random.part());
            let ray = Ray::along(origin, target - origin);
            assert_eq!(hits(std::slice::from_ref(&polygon), &ray), 1, "{ray:?} {corners:?}");
            assert!(hits(&halves, &ray) >= 1, "{ray:?} {corners:?}");
        }
    }
}
