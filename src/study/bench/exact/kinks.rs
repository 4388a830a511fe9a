//! Where a picture of penumbras may have jumps and kinks along a straight line: at outlines, and where a shadow begins or ends. Places too many
//! do no harm.

use super::area;
use super::quadrature::zeros;
use crate::geometry::{Intersect, Shape};
use crate::probe::Silent;
use crate::sampling::ellipse::Ellipse;
use crate::scene::Scene;
use crate::trace::closest_hit;
use glam::DVec3;

/// The edges, corners and outlines of a scene, as its eye and its light see them.
#[derive(Clone, Debug)]
pub struct Kinks {
    scene: Scene,
    /// The centre and the radii of the light.
    center: DVec3,
    radii: [DVec3; 2],
    edges: Vec<[DVec3; 2]>,
    corners: Vec<DVec3>,
    /// Normals of planes, whose horizons are seen.
    horizons: Vec<DVec3>,
    ellipses: Vec<Ellipse>,
}

impl Kinks {
    /// Those of a scene with this disk for a light.
    pub fn of(scene: &Scene, center: DVec3, radii: [DVec3; 2]) -> Kinks {
        let (mut edges, mut corners, mut horizons, mut ellipses) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for object in &scene.objects {
            match &object.shape {
                Shape::Plane(plane) => {
                    let from = plane.height(DVec3::ZERO);
                    horizons.push(DVec3::from(DVec3::AXES.map(|axis| plane.height(axis) - from)));
                }
                Shape::Cuboid(_) => {
                    let all = object.shape.corners().unwrap_or_default();
                    edges.extend(box_edges().map(|pair| pair.map(|k| all[k])));
                    corners.extend(all);
                }
                shape @ (Shape::Triangle(_) | Shape::Polygon(_)) => {
                    let all = shape.corners().unwrap_or_default();
                    edges.extend(area::edges(&all));
                    corners.extend(all);
                }
                shape => ellipses.extend(shape.round().and_then(|round| Ellipse::seen(&scene.camera, &round))),
            }
        }
        Kinks { scene: scene.clone(), center, radii, edges, corners, horizons, ellipses }
    }

    /// The parts of the way from one place of the picture to another at which there may be one.
    pub fn along(&self, way: [[f64; 2]; 2]) -> Vec<f64> {
        let camera = &self.scene.camera;
        let [start, end] = way;
        let place = |part: f64| [start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part];
        let views = [0.0, 0.5, 1.0].map(|part| camera.vector_through(place(part)));
        let eye = camera.position();
        let mut found = Vec::new();
        // The place is linear in the direction, the direction in the place.
        let edges = self.edges.iter().map(|[from, to]| (*from - eye).cross(*to - eye));
        for normal in edges.chain(self.horizons.iter().copied()) {
            let [from, _, to] = views.map(|view| normal.dot(view));
            found.push(from / (from - to));
        }
        for ellipse in &self.ellipses {
            found.extend(quadratic([0.0, 0.5, 1.0].map(|part| {
                let [x, y] = ellipse.circled(place(part));
                x * x + y * y - 1.0
            })));
        }
        let mut seen: Vec<(DVec3, DVec3)> = Vec::new();
        for part in [0.02, 0.5, 0.98] {
            let Some(ray) = camera.ray(place(part), &mut Silent) else { continue };
            let Some(hit) = closest_hit(&self.scene, &ray, &mut Silent) else { continue };
            let shape = &self.scene.objects[hit.object as usize].shape;
            let surface = shape.surface(&ray, hit.crossing, &mut Silent);
            let is_new = seen.iter().all(|(normal, point)| {
                (*normal - surface.normal).length() > 1e-9
                    || normal.dot(*point - surface.point).abs() > 1e-9 * (1.0 + surface.point.length())
            });
            if is_new && shape.is_flat(hit.crossing.primitive) {
                seen.push((surface.normal, surface.point));
                self.of_shadows(eye, views, (surface.normal, surface.point), &mut found);
            }
        }
        found.retain(|part| *part > 0.0 && *part < 1.0);
        found
    }

    /// Where the shadows of edges and corners on a plane begin and end: where the plane through an edge touches the light, and where a line
    /// through a corner meets its rim. The point of the plane is k·eye + m·view over k, with k = N·view and m = N·(point − eye), both linear
    /// along the way, so that both conditions are quadratic.
    fn of_shadows(&self, eye: DVec3, views: [DVec3; 3], (normal, point): (DVec3, DVec3), found: &mut Vec<f64>) {
        let reach = normal.dot(point - eye);
        let points = views.map(|view| (normal.dot(view), eye * normal.dot(view) + view * reach));
        let [u, v] = self.radii;
        for [from, to] in &self.edges {
            found.extend(quadratic(points.map(|(k, point)| {
                let plane = from.cross(*to) * k - point.cross(*to - *from);
                let (height, x, y) = (plane.dot(self.center - *from), plane.dot(u), plane.dot(v));
                height * height - x * x - y * y
            })));
        }
        let axis = u.cross(v);
        let square = u.dot(u);
        for corner in &self.corners {
            let away = self.center - *corner;
            found.extend(quadratic(points.map(|(k, point)| {
                let way = *corner * k - point;
                // Where the line meets the light's plane, from the light's centre, times axis·way.
                let meets = way * axis.dot(away) - away * axis.dot(way);
                let (x, y, z) = (u.dot(meets), v.dot(meets), square * axis.dot(way));
                x * x + y * y - z * z
            })));
        }
    }

    /// The heights in a pixel at which what is seen along its rows has kinks.
    pub fn of_rows(&self, [left, top]: [f64; 2]) -> Vec<f64> {
        let mut found = Vec::new();
        for x in [left, left + 1.0] {
            found.extend(self.along([[x, top], [x, top + 1.0]]).into_iter().map(|part| top + part));
        }
        found.extend(self.corners.iter().filter_map(|corner| self.scene.camera.place_of(*corner)).map(|[_, y]| y));
        for ellipse in &self.ellipses {
            let [from, to] = [0.0, 1.0].map(|y| ellipse.circled([0.0, y])[1]);
            found.extend([-1.0, 1.0].map(|end| (end - from) / (to - from)));
        }
        found
    }
}

/// The edges of a box by its corners, of which bit k tells the side along axis k.
pub fn box_edges() -> impl Iterator<Item = [usize; 2]> {
    (0..8).flat_map(|corner| (0..3).map(move |axis| [corner, corner | 1 << axis]).filter(|[from, to]| from != to))
}

/// The zeros between 0 and 1 of the quadratic polynomial with these values at 0, 1/2 and 1.
fn quadratic([start, middle, end]: [f64; 3]) -> impl Iterator<Item = f64> {
    let factors = [middle, (end - start) / 2.0, (end + start) / 2.0 - middle];
    zeros(&factors).into_iter().map(|place| (place + 1.0) / 2.0)
}
