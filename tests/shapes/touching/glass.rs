//! Random transmitting solids, each with an independent look at what is inside.

use super::doubled::halves;
use super::world::{Frame, World, wrong};
use crate::random::Random;
use glam::DVec3;
use serde_json::{Value, json};

/// A convex solid: how deep a point of the frame lies in it, positive inside.
pub struct Solid {
    pub depth: Box<dyn Fn(DVec3) -> f64>,
    pub ior: f64,
}

impl Solid {
    pub fn holds(&self, point: DVec3) -> bool {
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
pub fn add(frame: &Frame, is_upright: bool, world: World, random: &mut Random) -> (Solid, World) {
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
            let mut faces = halves(&quads);
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
pub fn around(solids: &[Solid], point: DVec3, direction: DVec3) -> Option<Vec<u32>> {
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

/// A sheet of two triangles in the plane of another sheet: where a ray goes through their common edge it crosses them once.
#[test]
fn the_diagonal_of_a_sheet_in_contact_is_crossed_once() {
    let mut random = Random::new(611);
    for frame in [Frame::upright(DVec3::ZERO, 1.0), Frame::turned(&mut random, 1e3, 1.0)] {
        let square = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
        // The middle of every pixel on a diagonal of the picture lies on that of the square.
        let world = World::seen(&frame, [0.0, 0.0, 2.0], [0.0; 3], 20.0, [21, 21])
            .material("sheet", json!({"weights": {"local": 0, "transmitted": 0.5}}));
        let right: Vec<_> = world.picture().into_iter().map(|color| color * 0.25).collect();
        let mesh = || frame.mesh(&square, &[[0, 1, 2], [0, 2, 3]]);
        let polygon = || frame.polygon(&square);
        let first = world.clone().object("sheet", polygon()).mesh("sheet", mesh());
        let second = world.clone().mesh("sheet", mesh()).object("sheet", polygon());
        let both = world.mesh("sheet", mesh()).mesh("sheet", mesh());
        for found in [first, second, both] {
            let (count, worst) = wrong(&found.picture(), &right, 1e-9);
            assert_eq!(count, 0, "off by {worst:e}");
        }
    }
}

/// A solid of glass that has each face twice, the second time the other way round, refracts as that with each face once.
#[test]
fn faces_twice_refract_as_faces_once() {
    let mut random = Random::new(612);
    for frame in [Frame::upright(DVec3::ZERO, 1.0), Frame::turned(&mut random, 1e3, 1.0)] {
        let corners = [[-1.0, -0.8, -0.6], [1.1, -0.7, -0.5], [0.1, 1.0, -0.7], [0.0, 0.1, 0.9]];
        let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        let doubled: Vec<_> = faces.iter().copied().chain(faces.map(|[a, b, c]| [c, b, a])).collect();
        let world = World::seen(&frame, [0.3, 0.4, 5.0], [0.0; 3], 30.0, [48, 36])
            .material("glass", json!({"ior": 1.4, "weights": {"local": 0, "transmitted": 1}}))
            .material(
                "wall",
                json!({"ambient": [1, 1, 1], "pattern": {"checker": {"a": [0.9, 0.2, 0.1],
                "b": [0.1, 0.3, 0.8], "size": 0.7}}}),
            )
            .set("/ambient", json!([1, 1, 1]))
            .object("wall", frame.plane([0.0, 0.0, -3.0], [0.0, 0.0, 1.0]));
        let once = world.clone().mesh("glass", frame.mesh(&corners, &faces)).picture();
        let twice = world.clone().mesh("glass", frame.mesh(&corners, &doubled)).picture();
        let (bent, _) = wrong(&once, &world.picture(), 1e-9);
        assert!(bent > 30, "{bent} pixels are seen through the glass");
        let (count, worst) = wrong(&twice, &once, 1e-9);
        assert_eq!(count, 0, "off by {worst:e}");
    }
}
