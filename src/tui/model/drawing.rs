//! The scene as lines, for the schematic, and from where it is looked at.

use crate::report::language::Language;
pub use crate::report::schematic::Wireframe;
use std::fmt;
use std::sync::Arc;

/// The scene as lines in space.
#[derive(Clone)]
pub struct Drawing {
    /// The objects.
    pub objects: Vec<Wireframe>,
    /// The lights; one at a place is a line of one point.
    pub lights: Vec<Wireframe>,
    /// The eye.
    pub eye: [f64; 3],
    /// The place of a point in the picture, in pixels from the top left corner; `None` behind the eye.
    pub place_of: PlaceOf,
    /// Columns and rows of the picture.
    pub size: [u32; 2],
}

/// From a point to its place in the picture.
pub type PlaceOf = Arc<dyn Fn([f64; 3]) -> Option<[f64; 2]> + Send + Sync>;

/// From where the schematic is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// From above: x to the right, z toward the one who looks.
    Top,
    /// From the front, where z comes from: x to the right, y up.
    Front,
    /// From the eye, as the picture.
    Camera,
}

impl fmt::Debug for Drawing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Drawing of {} objects and {} lights", self.objects.len(), self.lights.len())
    }
}

impl Projection {
    /// What the schematic is called that is seen so.
    pub fn title(self, language: Language) -> &'static str {
        language.texts().viewer.panes.schematic.views[self as usize]
    }

    /// The next one.
    pub fn next(self) -> Projection {
        match self {
            Projection::Top => Projection::Front,
            Projection::Front => Projection::Camera,
            Projection::Camera => Projection::Top,
        }
    }

    /// Where a point is drawn, x to the right and y up; `None` where it can't be seen. Without a scene nobody knows the eye.
    pub fn of(self, drawing: Option<&Drawing>, [x, y, z]: [f64; 3]) -> Option<[f64; 2]> {
        let place = match self {
            Projection::Top => [x, -z],
            Projection::Front => [x, y],
            Projection::Camera => (drawing?.place_of)([x, y, z]).map(|[column, row]| [column, -row])?,
        };
        place.iter().all(|number| number.is_finite()).then_some(place)
    }
}
