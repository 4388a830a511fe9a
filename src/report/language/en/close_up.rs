//! Close-ups in English.

use crate::report::language::close_up::CloseUp;

pub(super) const CLOSE_UP: CloseUp = CloseUp {
    vectors: |path| format!("Vectors at the hit of the ray {path}"),
    vectors_note: "Each figure lies in the plane of its vectors: its angles are those of the log.",
    vector_columns: ["vectors", "product", "angle", "light"],
    plane_of_incidence: "plane of incidence",
    total_reflection: "total internal reflection",
    plane_of_light: |light| format!("plane of N and L: light {light}"),
    plane_of_view: |light| format!("plane of L and V: light {light}"),
    zones: |path| format!("Zones of the blurred bounce at the hit of the ray {path}"),
    zones_note: "Seen along the axis of the lobe; equal areas are equally likely, the angles are those from the axis.",
    zone_columns: ["zone", "x_z", "y_z", "z_z", "angle", "direction"],
    lobe: |middle, exponent| format!("lobe cosⁿ about {middle}, n = {exponent}"),
    kept: "kept",
    rejected: "rejected: wrong side of the surface",
    light: |light, path| format!("Light {light} at the hit of the ray {path}"),
    light_note: "The area of a point is the weight of its shadow ray; hollow: blocked, or on the far side of a sphere.",
    another_light: |path, light| format!("--path '{path}' shows light {light}."),
    light_columns: ["ray", "F", "weight", "τ", "adds"],
    weights: |sum| format!("sum of the weights: {sum}"),
};
