//! The texts of close-ups: a hit's vectors, the zones of a blurred bounce, the points of an area light.

use super::{OfName, OfNames};

/// The texts of close-ups.
pub struct CloseUp {
    /// The vectors at the hit of a ray, by its path.
    pub vectors: OfName,
    /// How their figure is to be read.
    pub vectors_note: &'static str,
    /// Two vectors, their product, their angle, the light that they are for.
    pub vector_columns: [&'static str; 4],
    /// The plane of the arriving ray and the normal.
    pub plane_of_incidence: &'static str,
    /// Nothing is transmitted.
    pub total_reflection: &'static str,
    /// The plane of the normal and the direction to a light.
    pub plane_of_light: OfName,
    /// The plane of the directions to a light and to the viewer.
    pub plane_of_view: OfName,
    /// The zones of a ray's hit.
    pub zones: OfName,
    /// How their figure is to be read.
    pub zones_note: &'static str,
    /// Number, the direction's three parts, its angle from the axis, what became of it.
    pub zone_columns: [&'static str; 6],
    /// The lobe about a direction, with its exponent.
    pub lobe: OfNames,
    /// A direction on the right side of the surface.
    pub kept: &'static str,
    /// One on the wrong side.
    pub rejected: &'static str,
    /// The points of a light that a ray's hit asks.
    pub light: OfNames,
    /// How their figure is to be read.
    pub light_note: &'static str,
    /// How another area light of the hit is shown: its path and its name.
    pub another_light: OfNames,
    /// Number, point, weight, what passes, what it adds.
    pub light_columns: [&'static str; 5],
    /// The sum of the weights.
    pub weights: OfName,
}
