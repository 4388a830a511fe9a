//! Worlds of shapes that are hard on filters, and trees over them.

use crate::random::Random;
use glam::DVec3;
use raywalk::geometry::shape::{Cone, Cuboid, Cylinder, Disk, Ellipsoid, Sphere, SphereMethod, Triangle, TriangleMesh};
use raywalk::geometry::{Bvh, Intersect, Mesh, Shape};
use std::sync::Arc;

/// Primitives, and a tree over them.
pub struct World {
    pub shapes: Vec<Shape>,
    pub tree: Bvh,
    /// The same triangles as a mesh, if there is nothing else.
    pub mesh: Option<Shape>,
    /// Points where the tests are hardest: corners, and points of edges and surfaces.
    pub targets: Vec<DVec3>,
    pub middle: DVec3,
    pub size: f64,
}

/// What a world is made of, in a cube around the origin with sides of 2.
const MAKERS: [fn(&mut Random) -> Vec<Shape>; 9] =
    [soup, balls, shells, everything, grid, twice, ball_of_triangles, needles, on_a_huge_floor];

pub fn corners_of(shape: &Shape) -> Option<[DVec3; 3]> {
    match shape {
        Shape::Triangle(triangle) => Some(triangle.corners()),
        _ => None,
    }
}

fn triangle(corners: [DVec3; 3]) -> Shape {
    Shape::Triangle(Box::new(Triangle::new(corners.map(|corner| corner.to_array()), None)))
}

fn sphere(center: DVec3, radius: f64) -> Shape {
    Shape::Sphere(Sphere::new(center, radius, false, SphereMethod::Robust))
}

/// A power of ten from 10^low to 10^high.
pub fn magnitude(random: &mut Random, low: i32, high: i32) -> f64 {
    let power = low + random.below((high - low + 1) as usize) as i32;
    libm::pow(10.0, f64::from(power))
}

fn soup(random: &mut Random) -> Vec<Shape> {
    let size = magnitude(random, -6, 0);
    let one = |random: &mut Random| {
        let a = random.point();
        triangle([a, a + random.point() * size, a + random.point() * size])
    };
    (0..90).map(|_| one(random)).collect()
}

fn balls(random: &mut Random) -> Vec<Shape> {
    let largest = magnitude(random, -4, 0);
    (0..90).map(|_| sphere(random.point(), largest * (0.01 + random.part()))).collect()
}

/// Spheres around one centre, some of which differ by next to nothing.
fn shells(random: &mut Random) -> Vec<Shape> {
    let center = random.point() * 0.1;
    let step = magnitude(random, -16, -1);
    (0..40).map(|k| sphere(center, 0.5 + step * f64::from(k))).collect()
}

fn everything(random: &mut Random) -> Vec<Shape> {
    let one = |random: &mut Random| {
        let (at, size) = (random.point(), 0.02 + 0.2 * random.part());
        let end = at + random.unit() * size;
        match random.below(8) {
            0 => Shape::Cuboid(Cuboid::new(at, at + DVec3::splat(size))),
            1 => Shape::Disk(Box::new(Disk::new(at, random.unit(), size))),
            2 => Shape::Ellipsoid(Box::new(Ellipsoid::new(at, DVec3::new(size, size * 0.5, size * 2.0), None))),
            3 => Shape::Cylinder(Box::new(Cylinder::new(at, end, size * 0.3, true, false))),
            4 => Shape::Cone(Box::new(Cone::new((at, size * 0.5), (end, 0.0), true, false))),
            5 => Shape::Sphere(Sphere::new(at, size, false, SphereMethod::Geometric)),
            6 => sphere(at, size),
            _ => triangle([at, end, at + random.point() * size]),
        }
    };
    (0..60).map(|_| one(random)).collect()
}

/// Squares along the axes, cut into triangles, that share edges and lie in the faces of boxes.
fn grid(random: &mut Random) -> Vec<Shape> {
    let mut shapes = Vec::new();
    let height = if random.part() < 0.5 { 0.0 } else { 0.3 };
    for k in 0..36 {
        let a = DVec3::new(f64::from(k % 6) / 3.0 - 1.0, f64::from(k / 6) / 3.0 - 1.0, height);
        let [b, c] = [a + DVec3::X / 3.0, a + DVec3::Y / 3.0];
        let turned = |corner: DVec3| if k % 2 == 0 { corner } else { DVec3::new(corner.z, corner.x, corner.y) };
        shapes.push(triangle([a, b, c].map(turned)));
        shapes.push(triangle([b, b + DVec3::Y / 3.0, c].map(turned)));
    }
    shapes
}

/// Everything again, so that all distances are the same twice.
fn twice(random: &mut Random) -> Vec<Shape> {
    let mut shapes = if random.part() < 0.5 { soup(random) } else { balls(random) };
    shapes.truncate(40);
    shapes.extend(shapes.clone());
    shapes
}

fn ball_of_triangles(_: &mut Random) -> Vec<Shape> {
    let ball = octahedron(2);
    (0..ball.faces.len() as u32).map(|face| triangle(ball.corners(face))).collect()
}

/// An octahedron, its faces cut into four and pushed out this many times.
fn octahedron(times: u32) -> Mesh {
    let mut faces = Vec::new();
    for signs in 0..8 {
        let axis = |k: u32| DVec3::AXES[k as usize] * if signs >> k & 1 == 0 { 1.0 } else { -1.0 };
        faces.push([axis(0), axis(1), axis(2)]);
    }
    for _ in 0..times {
        let cut = |[a, b, c]: [DVec3; 3]| {
            let middle = |p: DVec3, q: DVec3| (p + q) / (p + q).length();
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(cut).collect();
    }
    let positions = faces.iter().flatten().copied().collect();
    let numbers = (0..faces.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    Mesh { positions, normals: None, faces: numbers }
}

/// Triangles next to no width.
fn needles(random: &mut Random) -> Vec<Shape> {
    let one = |random: &mut Random| {
        let (a, along) = (random.point(), random.unit());
        let width = magnitude(random, -12, -1);
        triangle([a, a + along * random.part(), a + along * random.part() + random.point() * width])
    };
    (0..70).map(|_| one(random)).collect()
}

/// A few small primitives on one that is larger than all of them by far.
fn on_a_huge_floor(random: &mut Random) -> Vec<Shape> {
    let size = magnitude(random, 2, 9);
    let mut shapes = soup(random);
    shapes.truncate(40);
    shapes.extend((0..20).map(|_| sphere(random.point(), 0.1)));
    shapes.push(match random.below(3) {
        0 => sphere(DVec3::new(0.0, 0.0, -size - 1.0), size),
        1 => triangle([DVec3::new(-size, -size, -1.0), DVec3::new(size, -size, -1.0), DVec3::new(0.0, size, -1.0)]),
        _ => Shape::Cuboid(Cuboid::new(DVec3::splat(-size), DVec3::new(size, size, -1.0))),
    });
    shapes
}

/// The shape in a world `scale` times as large whose origin has been moved.
fn placed(shape: Shape, scale: f64, offset: DVec3) -> Option<Shape> {
    let at = |point: DVec3| point * scale + offset;
    match shape {
        Shape::Triangle(ref shape) => Some(triangle(shape.corners().map(at))),
        Shape::Sphere(_) => {
            let bounds = shape.bounds()?;
            Some(sphere(at(bounds.center()), (bounds.max.x - bounds.min.x) * 0.5 * scale))
        }
        other if scale == 1.0 && offset == DVec3::ZERO => Some(other),
        _ => None,
    }
}

pub fn world(number: u64) -> World {
    let mut random = Random::new(number);
    let make = MAKERS[number as usize % MAKERS.len()];
    let scale = if random.part() < 0.5 { 1.0 } else { magnitude(&mut random, -90, 90) };
    let offset = match random.below(3) {
        0 => DVec3::ZERO,
        _ => random.point() * scale * magnitude(&mut random, 0, 9),
    };
    let offset = if random.part() < 0.5 { DVec3::ZERO } else { offset };
    let shapes: Vec<Shape> = make(&mut random).into_iter().filter_map(|shape| placed(shape, scale, offset)).collect();
    let primitives: Vec<u32> = (0..shapes.len() as u32).collect();
    let tree =
        Bvh::new(Vec::new(), primitives.clone(), |primitive| shapes[primitive as usize].form().expect("bounded"));
    let mut targets = Vec::new();
    for shape in &shapes {
        match corners_of(shape) {
            Some([a, b, c]) => targets.extend([a, b, c, a * 0.5 + b * 0.5, a * 0.3 + c * 0.7, (a + b + c) / 3.0]),
            None => targets.extend(shape.bounds().into_iter().flat_map(|bounds| {
                let side = (bounds.max - bounds.min) * 0.5;
                [bounds.center(), bounds.center() + random.unit() * side, bounds.min, bounds.max]
            })),
        }
    }
    let mesh = mesh_of(&shapes);
    World { shapes, tree, mesh, targets, middle: offset, size: scale }
}

fn mesh_of(shapes: &[Shape]) -> Option<Shape> {
    let corners: Option<Vec<[DVec3; 3]>> = shapes.iter().map(corners_of).collect();
    let corners = corners?;
    let faces = (0..corners.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    Some(Shape::Mesh(Arc::new(TriangleMesh::new(Arc::new(Mesh { positions: corners.concat(), normals: None, faces })))))
}
