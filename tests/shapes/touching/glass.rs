//! Random transmitting solids, each with an independent look at what is inside.

use super::doubled::halves;
use super::world::{Frame, World};
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
