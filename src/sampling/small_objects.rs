//! Objects so small, or so narrow, in the picture that samples may pass beside them (Ramos, section 1.4.1, figure 19).

use super::outline::Outline;
use crate::scene::{Camera, Object, Scene};

/// A rectangle of the picture in pixels: left, top, right, bottom.
pub type Rectangle = [f64; 4];

/// An object with its outline in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SmallObject {
    /// The object.
    pub object: u32,
    outline: Outline,
}

/// A convex figure of this width, in cells, holds a corner of the cells however it lies: 1 + 2/√3 (Hurkens, "Blowing up convex sets in
/// the plane", 1990).
const CELLS_IN_A_FOUND_OBJECT: f64 = 2.154_700_538_379_252;

/// The objects of a scene that a cell as large as a pixel may miss. Those without end and those that the eye stands beside are none.
pub fn of(scene: &Scene) -> Vec<SmallObject> {
    let small = |(object, thing): (u32, &Object)| Some(SmallObject { object, outline: seen(&scene.camera, thing)? });
    (0..).zip(&scene.objects).filter_map(small).filter(|small| small.may_be_missed(1.0)).collect()
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
    let places: Option<Vec<_>> = object.shape.corners()?.into_iter().map(|corner| camera.place_of(corner)).collect();
    Some(Outline::around(places?))
}
