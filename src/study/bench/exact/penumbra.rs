//! Pictures of diffuse surfaces in the light of a disk, with the penumbras of its occluders: exact at each point, and integrated over
//! each pixel with an estimate of the error.

use super::NotExact;
use super::area::edges;
use super::kinks::Kinks;
use super::quadrature::{Estimate, Rule, in_pieces};
use super::shadow::{Circle, Cone, mean_cosine};
use crate::geometry::shape::Round;
use crate::geometry::{Intersect, Shape};
use crate::probe::Silent;
use crate::scene::light_surface::{By, least_axis};
use crate::scene::{AreaLight, Color, Light, LightKind, LightSurface, Material, Object, Scene};
use crate::trace::{closest_hit, in_range};
use glam::DVec3;
use rayon::prelude::*;

/// The most that the two rules of quadrature may differ by on a part of a row of a pixel, in units of the picture's largest value.
const ALONG_ROW: Rule = Rule { tolerance: 1e-10, halvings: 36 };

/// The same of the rows of a pixel.
const OVER_ROWS: Rule = Rule { tolerance: 1e-9, halvings: 20 };

/// A scene with one disk for a light, and diffuse surfaces.
#[derive(Clone, Debug)]
pub struct Penumbra<'a> {
    scene: &'a Scene,
    color: Color,
    center: DVec3,
    /// Its axes and its normal, of length 1.
    axes: [DVec3; 3],
    radius: f64,
    kinks: Kinks,
    /// What values are compared with.
    scale: f64,
}

impl<'a> Penumbra<'a> {
    /// A scene's, if it is one of this kind.
    ///
    /// # Errors
    /// [`NotExact`] where it isn't, with the reason.
    pub fn of(scene: &'a Scene) -> Result<Penumbra<'a>, NotExact> {
        if scene.camera.lens.is_some() || scene.camera.shutter.is_some() {
            return Err(NotExact::Camera);
        }
        let (light, center, edges) = disk(scene)?;
        let radius = edges[0].length();
        let [u, v] = edges.map(|edge| edge / radius);
        let axes = [u, v, u.cross(v)];
        for object in &scene.objects {
            if !is_diffuse(scene, scene.materials.get(object.material), object) {
                return Err(NotExact::Diffuse(object.name.to_string()));
            }
            if !is_computed(&object.shape) {
                return Err(NotExact::Occluder(object.name.to_string()));
            }
            if crosses(&object.shape, center, axes[2]) {
                return Err(NotExact::BesideLight(object.name.to_string()));
            }
        }
        let brightest = |object: &Object| {
            let Material { ambient, diffuse, weights, .. } = &scene.materials[object.material];
            (weights.local * (scene.ambient * *ambient + light.color * *diffuse)).abs().max_element()
        };
        let background = scene.background.abs().max_element();
        let scale = scene.objects.iter().map(brightest).fold(background, f64::max).max(f64::MIN_POSITIVE);
        let kinks = Kinks::of(scene, center, edges);
        Ok(Penumbra { scene, color: light.color, center, axes, radius, kinks, scale })
    }

    /// The picture, row by row, computed on the threads of the pool that it is called in, and the root of the mean square of the estimated errors, in the unit of its colours.
    pub fn picture(&self) -> Estimate<Vec<Color>> {
        let [width, height] = self.scene.camera.resolution;
        let places: Vec<_> = (0..height).flat_map(|row| (0..width).map(move |column| [column, row])).collect();
        let pixels: Vec<_> = places.into_par_iter().map(|pixel| self.pixel(pixel)).collect();
        let squares: f64 = pixels.iter().map(|pixel| pixel.error * pixel.error).sum();
        let error = (squares / pixels.len() as f64).sqrt();
        Estimate { value: pixels.into_iter().map(|pixel| pixel.value).collect(), error }
    }

    /// The mean over a pixel.
    pub fn pixel(&self, pixel: [u32; 2]) -> Estimate<Color> {
        let [left, top] = pixel.map(f64::from);
        let mut row = |y: f64| {
            let splits = self.kinks.along([[left, y], [left + 1.0, y]]).into_iter().map(|part| left + part).collect();
            in_pieces(&mut |x| self.at([x, y]), [left, left + 1.0], splits, self.rule(ALONG_ROW))
        };
        let splits = self.kinks.of_rows([left, top]);
        in_pieces(&mut row, [top, top + 1.0], splits, self.rule(OVER_ROWS))
    }

    fn rule(&self, rule: Rule) -> Rule {
        Rule { tolerance: rule.tolerance * self.scale, ..rule }
    }

    /// What is seen at a place of the picture.
    pub fn at(&self, place: [f64; 2]) -> Estimate<Color> {
        let scene = self.scene;
        let nothing = Estimate { value: scene.background, error: 0.0 };
        let Some(ray) = scene.camera.ray(place, &mut Silent) else { return nothing };
        let Some(hit) = closest_hit(scene, &ray, &mut Silent) else { return nothing };
        let surface = scene.objects[hit.object as usize].shape.surface(&ray, hit.crossing, &mut Silent);
        let Material { ambient, diffuse, weights, .. } = scene.material_of(hit.object);
        let lit = *diffuse * self.color;
        let cosine = match scene.tracing.shades_ambient_only(0) || lit == Color::ZERO {
            true => Estimate { value: 0.0, error: 0.0 },
            false => self.mean_cosine(surface.point, surface.normal, hit.object),
        };
        let local = in_range(scene.ambient * *ambient + lit * cosine.value);
        let error = (weights.local * lit).abs().max_element() * cosine.error;
        Estimate { value: in_range(weights.local * local), error }
    }

    /// The mean of N·L over the visible part of the light.
    fn mean_cosine(&self, point: DVec3, normal: DVec3, own: u32) -> Estimate<f64> {
        let frame = Frame::new(self, point);
        let (normal, center) = (frame.of(normal), frame.of(self.center - point));
        let height = normal.dot(center);
        let reach = self.radius * libm::hypot(normal.x, normal.y);
        if height <= -reach {
            return Estimate { value: 0.0, error: 0.0 };
        }
        let below = self.beyond(center, height, [normal.x, normal.y]).map(Some);
        let mut hidden = Vec::new();
        for cone in below.into_iter().chain(
            (0..)
                .zip(&self.scene.objects)
                .filter(|(number, _)| *number != own)
                .filter_map(|(_, object)| self.cone(&frame, center, &object.shape)),
        ) {
            match cone {
                None => return Estimate { value: 0.0, error: 0.0 },
                Some(cone) if cone.misses(center, self.radius) => (),
                Some(cone) => hidden.push(cone),
            }
        }
        mean_cosine(normal, center, self.radius, &hidden)
    }

    /// What an object hides of the light: `None` nothing, `Some(None)` all.
    fn cone(&self, frame: &Frame, center: DVec3, shape: &Shape) -> Option<Option<Cone>> {
        match shape {
            Shape::Plane(plane) => {
                let height = plane.height(self.center);
                let slope = |axis: DVec3| plane.height(self.center + axis) - height;
                let [x, y] = [slope(frame.axes[0]), slope(frame.axes[1])];
                let own = plane.height(frame.point);
                // A point in the plane itself has nothing of it before the light.
                if own.abs() <= 1e-12 * (1.0 + frame.point.length()) {
                    return None;
                }
                let side = own.signum();
                let reach = self.radius * libm::hypot(x, y);
                if side * height <= -reach {
                    return Some(None);
                }
                self.beyond(center, side * height, [side * x, side * y]).map(Some)
            }
            Shape::Triangle(triangle) => self.flat(frame, center, &triangle.corners()).map(Some),
            Shape::Polygon(polygon) => self.flat(frame, center, polygon.corners()).map(Some),
            Shape::Cuboid(_) => self.solid(frame, center, shape),
            Shape::Disk(_) | Shape::Sphere(_) => self.round(frame, center, shape),
            _ => None,
        }
    }

    /// The part of the disk where height + slope·q, q counted from its centre, is negative.
    fn beyond(&self, center: DVec3, height: f64, [x, y]: [f64; 2]) -> Option<Cone> {
        let steep = libm::hypot(x, y);
        if height >= self.radius * steep {
            return None;
        }
        let out = DVec3::new(-x / steep, -y / steep, 0.0);
        let along = DVec3::new(-out.y, out.x, 0.0) * (3.0 * self.radius);
        let (near, far) = (center + out * (height / steep), center + out * (height / steep + 4.0 * self.radius));
        let corners = [near + along, near - along, far - along, far + along];
        Cone::flat(edges(&corners), (near + far) / 2.0)
    }

    fn flat(&self, frame: &Frame, center: DVec3, corners: &[DVec3]) -> Option<Cone> {
        let corners: Vec<_> = corners.iter().map(|corner| frame.of(*corner - frame.point)).collect();
        let mut kept = Vec::new();
        for [from, to] in edges(&corners) {
            let (a, b) = (center.z - from.z, center.z - to.z);
            if a >= 0.0 {
                kept.push(from);
            }
            if a * b < 0.0 {
                kept.push(from + (to - from) * (a / (a - b)));
            }
        }
        let is_before = kept.iter().any(|corner| corner.z < center.z);
        let middle = kept.iter().sum::<DVec3>() / kept.len() as f64;
        if is_before && kept.len() > 2 { Cone::flat(edges(&kept), middle) } else { None }
    }

    /// A box: the edges between the faces that are seen and those that aren't.
    fn solid(&self, frame: &Frame, center: DVec3, shape: &Shape) -> Option<Option<Cone>> {
        let bounds = shape.bounds()?;
        let middle = frame.of(bounds.center() - frame.point);
        if middle.z >= center.z {
            return None;
        }
        let corners: Vec<_> = bounds.corners().collect();
        // Whether the face on this side of an axis is seen.
        let is_seen = |axis: usize, is_high: bool| match is_high {
            true => frame.point[axis] > bounds.max[axis],
            false => frame.point[axis] < bounds.min[axis],
        };
        let outline = super::kinks::box_edges().filter(|[one, other]| {
            let along = (one ^ other).trailing_zeros() as usize;
            let [first, second] = [(along + 1) % 3, (along + 2) % 3];
            let face = |axis: usize| is_seen(axis, one >> axis & 1 == 1);
            face(first) != face(second)
        });
        let sides: Vec<_> = outline.map(|pair| pair.map(|k| frame.of(corners[k] - frame.point))).collect();
        if sides.is_empty() {
            return Some(None);
        }
        Cone::flat(sides, middle).map(Some)
    }

    fn round(&self, frame: &Frame, center: DVec3, shape: &Shape) -> Option<Option<Cone>> {
        let round = shape.round()?;
        let away = frame.of(round.center() - frame.point);
        if away.z >= center.z {
            return None;
        }
        let (middle, axes) = match round {
            Round::Ball { half_axes, .. } => {
                let (distance, radius) = (away.length(), half_axes[0].length());
                let tangent = (distance - radius) * (distance + radius);
                if tangent <= 0.0 {
                    return Some(None);
                }
                // The circle along which the tangents from the point touch.
                let along = away / distance;
                let radius = radius * tangent.sqrt() / distance;
                (along * (tangent / distance), across(along).map(|axis| axis * radius))
            }
            Round::Disk { normal, radius, .. } => (away, across(frame.of(normal)).map(|axis| axis * radius)),
        };
        Circle::new(middle, axes).map(|circle| Some(Cone::Round(circle)))
    }
}

/// The frame of the disk, with the point on its negative side.
struct Frame {
    point: DVec3,
    axes: [DVec3; 3],
}

impl Frame {
    fn new(light: &Penumbra, point: DVec3) -> Frame {
        let [u, v, n] = light.axes;
        let axes = if n.dot(light.center - point) < 0.0 { [u, v, -n] } else { [u, v, n] };
        Frame { point, axes }
    }

    fn of(&self, vector: DVec3) -> DVec3 {
        DVec3::from(self.axes.map(|axis| axis.dot(vector)))
    }
}

/// Two unit vectors perpendicular to a unit vector and to each other.
fn across(normal: DVec3) -> [DVec3; 2] {
    let first = normal.cross(least_axis(normal));
    let first = first / first.length();
    [first, normal.cross(first)]
}

/// The only light, with the centre and the radii of its disk.
fn disk(scene: &Scene) -> Result<(&Light, DVec3, [DVec3; 2]), NotExact> {
    let mut shining = scene.lights.iter().filter(|light| light.color != Color::ZERO);
    let (Some(light), None) = (shining.next(), shining.next()) else { return Err(NotExact::Lights) };
    match &light.kind {
        LightKind::Area(area) if light.attenuation.is_none() => match **area {
            AreaLight { surface: LightSurface::Disk { center, edges }, profile: None, by: By::Area, .. } => {
                Ok((light, center, edges))
            }
            _ => Err(NotExact::Lights),
        },
        _ => Err(NotExact::Lights),
    }
}

fn is_diffuse(scene: &Scene, material: Option<&Material>, object: &Object) -> bool {
    material.is_some_and(|material| {
        let bounces = material.reflects() && scene.tracing.goes_deeper(0);
        let is_dull = material.specular == Color::ZERO && !material.lets_light_through();
        is_dull && !bounces && material.pattern.is_none() && !object.one_sided
    })
}

fn is_computed(shape: &Shape) -> bool {
    match shape {
        Shape::Plane(_) | Shape::Cuboid(_) | Shape::Disk(_) | Shape::Sphere(_) => true,
        Shape::Triangle(triangle) => !triangle.is_smooth(),
        Shape::Polygon(polygon) => polygon.is_plane() && polygon.is_convex() && !polygon.is_smooth(),
        _ => false,
    }
}

/// Whether a box, a ball or a disk lies on both sides of the light's plane.
fn crosses(shape: &Shape, center: DVec3, normal: DVec3) -> bool {
    if !matches!(shape, Shape::Cuboid(_) | Shape::Disk(_) | Shape::Sphere(_)) {
        return false;
    }
    let Some(bounds) = shape.bounds() else { return false };
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in bounds.corners() {
        let height = normal.dot(corner - center);
        (low, high) = (low.min(height), high.max(height));
    }
    low < 0.0 && high > 0.0
}
