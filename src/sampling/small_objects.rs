//! Objects so small, or so narrow, in the picture that samples may pass beside them (Ramos, section 1.4.1, figure 19).

use crate::geometry::Bounds;
use crate::scene::{Camera, Scene};

/// A rectangle of the picture in pixels: left, top, right, bottom.
pub type Rectangle = [f64; 4];

/// An object with the rectangle that its box fills in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmallObject {
    /// The object.
    pub object: u32,
    bounds: Rectangle,
    /// The shorter side of the rectangle.
    breadth: f64,
}

/// Two cells of a side fit an object in any place, so a grid of them can't miss it.
const CELLS_IN_A_FOUND_OBJECT: f64 = 2.0;

/// The objects of a scene that a cell as large as a pixel may miss. Those without end and those that the eye stands beside are none.
pub fn of(scene: &Scene) -> Vec<SmallObject> {
    let objects = (0..).zip(&scene.objects);
    let rectangle = |(object, thing): (u32, &crate::scene::Object)| {
        let bounds @ [left, top, right, bottom] = projected(&scene.camera, &thing.shape.bounds()?)?;
        Some(SmallObject { object, bounds, breadth: (right - left).min(bottom - top) })
    };
    objects.filter_map(rectangle).filter(|small| small.may_be_missed(1.0)).collect()
}

/// Those that reach into a rectangle of the picture.
pub fn within(objects: &[SmallObject], rectangle: Rectangle) -> Vec<SmallObject> {
    objects.iter().copied().filter(|small| small.reaches_into(rectangle)).collect()
}

impl SmallObject {
    /// Whether corners of cells with this side, in pixels, may all lie beside the object.
    pub fn may_be_missed(&self, side: f64) -> bool {
        self.breadth < CELLS_IN_A_FOUND_OBJECT * side
    }

    /// Whether the object's rectangle and this one have something in common.
    pub fn reaches_into(&self, [left, top, right, bottom]: Rectangle) -> bool {
        let [own_left, own_top, own_right, own_bottom] = self.bounds;
        own_left < right && left < own_right && own_top < bottom && top < own_bottom
    }
}

/// The rectangle around a box in the picture; `None` where a part of it doesn't lie in front of the eye.
fn projected(camera: &Camera, bounds: &Bounds) -> Option<Rectangle> {
    bounds.corners().map(|corner| camera.place_of(corner)).try_fold(
        [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY],
        |around, place| {
            let [left, top, right, bottom] = around;
            let [x, y] = place?;
            Some([left.min(x), top.min(y), right.max(x), bottom.max(y)])
        },
    )
}
