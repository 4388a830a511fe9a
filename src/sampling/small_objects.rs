//! Objects so small, or so narrow, in the picture that samples may pass beside them (Ramos, section 1.4.1, figure 19).

use super::ellipse::Ellipse;
use super::outline::{Outline, Rectangle};
use crate::geometry::Shape;
use crate::geometry::mesh::triangulate;
use crate::scene::{Camera, Object, Scene};
use glam::DVec3;

/// An object, or a part of one, with its outline in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SmallObject {
    /// The object.
    pub object: u32,
    outline: Outline,
}

/// A convex figure of this width, in cells, holds a corner of the cells however it lies: 1 + 2/√3 (Hurkens, "Blowing up convex sets in
/// the plane", 1990).
const CELLS_IN_A_FOUND_OBJECT: f64 = 2.154_700_538_379_252;

/// The most triangles of a mesh that are looked at one by one.
pub const MOST_TRIANGLES: usize = 100_000;

/// The objects of a scene that a cell as large as a pixel may miss, and of an object that isn't convex the parts. Those without end and
/// those that the eye is beside are none.
pub fn of(scene: &Scene) -> Vec<SmallObject> {
    near(scene, None)
}

/// Those that reach into a rectangle, found without looking at the parts of objects that don't.
pub fn of_rectangle(scene: &Scene, rectangle: Rectangle) -> Vec<SmallObject> {
    near(scene, Some(rectangle))
}

fn near(scene: &Scene, rectangle: Option<Rectangle>) -> Vec<SmallObject> {
    let reaches = |outline: &Outline| rectangle.is_none_or(|rectangle| outline.reaches_into(rectangle));
    // With room for the roundings by which the outline of a part may reach beyond that of the whole.
    let widened = rectangle.map(|[left, top, right, bottom]| [left - 0.01, top - 0.01, right + 0.01, bottom + 0.01]);
    let is_near = |outline: &Outline| widened.is_none_or(|rectangle| outline.reaches_into(rectangle));
    let mut found = Vec::new();
    for (number, object) in (0..).zip(&scene.objects) {
        let Some(whole) = seen(&scene.camera, object).filter(is_near) else { continue };
        let small = |outline| SmallObject { object: number, outline };
        let parts = parts(&object.shape);
        if whole.width() < CELLS_IN_A_FOUND_OBJECT || parts.is_empty() {
            found.extend(Some(whole).filter(reaches).map(small));
            continue;
        }
        let outline = |part: &[DVec3; 3]| around(&scene.camera, part);
        found.extend(parts.iter().filter_map(outline).filter(reaches).map(small));
    }
    found.retain(|small| small.may_be_missed(1.0));
    found
}

/// Those that reach into a rectangle of the picture.
pub fn within<'s>(objects: impl IntoIterator<Item = &'s SmallObject>, rectangle: Rectangle) -> Vec<&'s SmallObject> {
    objects.into_iter().filter(|small| small.reaches_into(rectangle)).collect()
}

impl SmallObject {
    /// Whether corners of cells with this side, in pixels, may all lie beside the object.
    pub fn may_be_missed(&self, side: f64) -> bool {
        self.outline.width() < CELLS_IN_A_FOUND_OBJECT * side
    }

    /// Whether the object's outline and a rectangle have something in common.
    pub fn reaches_into(&self, rectangle: Rectangle) -> bool {
        self.outline.reaches_into(rectangle)
    }
}

/// The outline of an object in the picture; `None` where a part of it doesn't lie in front of the eye.
fn seen(camera: &Camera, object: &Object) -> Option<Outline> {
    let places = places(camera, &object.shape.corners()?)?;
    let ellipse = object.shape.round().and_then(|round| Ellipse::seen(camera, &round));
    Some(match ellipse {
        Some(ellipse) => Outline::around(ellipse.corners()).with_width(ellipse.width()),
        None => Outline::around(places),
    })
}

/// The triangles of a shape whose outline may be wide although it is narrow everywhere; none of a convex one.
fn parts(shape: &Shape) -> Vec<[DVec3; 3]> {
    match shape {
        Shape::Mesh(mesh) if mesh.mesh().faces.len() <= MOST_TRIANGLES => {
            let mesh = mesh.mesh();
            (0..mesh.faces.len() as u32).map(|triangle| mesh.corners(triangle)).collect()
        }
        Shape::Polygon(polygon) if !polygon.is_convex() => {
            let corners = polygon.corners();
            triangulate(corners).into_iter().map(|triangle| triangle.map(|corner| corners[corner])).collect()
        }
        _ => Vec::new(),
    }
}

fn around(camera: &Camera, corners: &[DVec3]) -> Option<Outline> {
    Some(Outline::around(places(camera, corners)?))
}

/// Where corners are seen; `None` where one doesn't lie in front of the eye.
fn places(camera: &Camera, corners: &[DVec3]) -> Option<Vec<[f64; 2]>> {
    corners.iter().map(|corner| camera.place_of(*corner)).collect()
}
