//! The unit of each quantity. It belongs to the key: whatever formula gives a quantity, it has the same unit.

use super::Name;
use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

/// What a quantity is measured in. The components of a triple have the same.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Unit {
    /// A number without a unit: a ratio, a cosine, a component of a unit vector, a coefficient of a material, a random number.
    One,
    /// So many of something, or which of several.
    Count,
    /// A length in the units of the scene.
    Length,
    /// A length times a length.
    Area,
    /// An area times a length.
    Volume,
    /// One over a length.
    PerLength,
    /// One over an area.
    PerArea,
    /// The intensity of light, in the unit in which the scene states its lights; linear, not clipped.
    Intensity,
    /// Columns and rows of the picture.
    Pixels,
    /// One over pixels.
    PerPixel,
    /// Time, in the unit of the objects' motions.
    Time,
    /// A length per time.
    LengthPerTime,
    /// An angle in degrees.
    Degrees,
    /// Degrees per time.
    DegreesPerTime,
}

impl Unit {
    /// How the unit is written in tables.
    pub fn text(self) -> &'static str {
        match self {
            Unit::One => "1",
            Unit::Count => "count",
            Unit::Length => "length",
            Unit::Area => "length²",
            Unit::Volume => "length³",
            Unit::PerLength => "1/length",
            Unit::PerArea => "1/length²",
            Unit::Intensity => "intensity",
            Unit::Pixels => "pixels",
            Unit::PerPixel => "1/pixels",
            Unit::Time => "time",
            Unit::LengthPerTime => "length/time",
            Unit::Degrees => "degrees",
            Unit::DegreesPerTime => "degrees/time",
        }
    }

    /// The exponents of length, intensity, time and angle. Counts and places in the picture are numbers.
    pub fn dimension(self) -> [i32; 4] {
        match self {
            Unit::One | Unit::Count | Unit::Pixels | Unit::PerPixel => [0; 4],
            Unit::Length => [1, 0, 0, 0],
            Unit::Area => [2, 0, 0, 0],
            Unit::Volume => [3, 0, 0, 0],
            Unit::PerLength => [-1, 0, 0, 0],
            Unit::PerArea => [-2, 0, 0, 0],
            Unit::Intensity => [0, 1, 0, 0],
            Unit::Time => [0, 0, 1, 0],
            Unit::LengthPerTime => [1, 0, -1, 0],
            Unit::Degrees => [0, 0, 0, 1],
            Unit::DegreesPerTime => [0, 0, -1, 1],
        }
    }
}

impl Name {
    /// What the quantity is measured in.
    pub fn unit(self) -> Unit {
        static UNITS: LazyLock<HashMap<&str, Unit>> = LazyLock::new(|| pairs().collect());
        UNITS.get(self.key()).copied().unwrap_or(Unit::One)
    }

    /// Whether its values are triples (points, vectors, colours) and not numbers.
    pub fn is_triple(self) -> bool {
        static TRIPLE: LazyLock<HashSet<&str>> = LazyLock::new(|| triples().collect());
        TRIPLE.contains(self.key())
    }
}

/// Every key with its unit.
pub(super) fn pairs() -> impl Iterator<Item = (&'static str, Unit)> {
    KEYS.iter().flat_map(|(unit, keys)| keys.split_whitespace().map(|key| (key, *unit)))
}

/// Every key whose values are triples.
pub(super) fn triples() -> impl Iterator<Item = &'static str> {
    TRIPLES.split_whitespace()
}

/// Points, vectors, colours and what else has three components.
const TRIPLES: &str = "
    ray.origin camera.direction camera.up_as_given camera.right camera.up ray.vector ray.direction plane.normal
    sphere.center sphere.oc sphere.from_center ellipsoid.center ellipsoid.row_1 ellipsoid.row_2 ellipsoid.row_3
    ellipsoid.origin ellipsoid.point ellipsoid.gradient triangle.a triangle.b triangle.c triangle.normal
    triangle.unit_normal triangle.edges_exact triangle.normal_a triangle.normal_b triangle.normal_c triangle.mean_normal
    polygon.corner polygon.normal polygon.unit_normal box.min box.max box.face_normal box.to_min box.to_max axis.base
    axis.apex axis.direction axis.origin axis.origin_across axis.ray_across axis.point axis.point_across cone.gradient
    disk.center disk.normal disk.unit_normal hit.point hit.normal hit.geometric_normal reflect.direction refract.direction
    light.position light.travel light.center light.edge_u light.edge_v light.color light.vector light.direction
    shadow.transmittance view.direction half.sum half.direction mirror.direction transmit.sum transmit.direction
    light.ambient material.ambient material.diffuse material.specular material.transmission weight.local shade.local
    material.ambient_plain material.diffuse_plain pattern.a pattern.b pattern.axes pattern.cell pattern.color cutoff.loss
    weight.reflected weight.transmitted incoming.reflected incoming.transmitted combine.local combine.reflected
    combine.transmitted combine.color cell.color_1 cell.color_2 cell.color_3 cell.color_4 statistical.mean
    statistical.standard_error statistical.degrees_of_freedom statistical.t_quantile statistical.half_width
    camera.position lens.focus motion.translation motion.shift motion.axis motion.point motion.arm motion.hit_point
    motion.hit_normal motion.geometric_normal pattern.point light.outward lobe.middle lobe.helper lobe.axis_1 lobe.axis_2
    lobe.direction lobe.color lobe.sum lobe.mean background.color pixel.mean";

/// The keys of each unit.
const KEYS: &[(Unit, &str)] = &[
    (
        Unit::One,
        "camera.right camera.up_as_given camera.up pixel.x pixel.y ray.direction
        plane.normal plane.v_d
        ellipsoid.row_1 ellipsoid.row_2 ellipsoid.row_3
        ellipsoid.direction_1 ellipsoid.direction_2 ellipsoid.direction_3 ellipsoid.a
        triangle.unit_normal triangle.normal_a triangle.normal_b triangle.normal_c
        triangle.weight_a triangle.weight_b triangle.weight_c triangle.mean_normal
        polygon.unit_normal box.face_normal
        axis.direction axis.ray_along axis.ray_across cylinder.a cone.slope cone.ray_radius cone.a cone.gradient
        disk.normal disk.unit_normal disk.v_d
        hit.normal hit.geometric_normal reflect.direction
        refract.eta_1 refract.eta_2 refract.eta refract.cos_1 refract.cos_2 refract.direction
        light.travel light.constant light.direction light.attenuation light.spread light.x light.y light.outward
        light.solid_angle light.profile_cosine light.profile_power light.profile_mean light.weight light.share
        shadow.transmittance view.direction half.sum half.length half.direction mirror.direction
        transmit.eta transmit.sum transmit.length transmit.direction
        shade.n_dot_l shade.n_dot_h shade.r_dot_v shade.n_dot_transmitted shade.specular_power shade.transmitted_power
        material.ambient material.diffuse material.specular material.shininess
        material.transmission material.transmission_exponent material.ambient_plain material.diffuse_plain
        pattern.a pattern.b pattern.color
        weight.local weight.reflected weight.transmitted
        sample.jitter_x sample.jitter_y sample.x sample.y sample.time sample.weight cell.area disc.x disc.y
        cell.threshold statistical.confidence statistical.t_quantile statistical.tolerance
        guided.variance guided.contrast guided.error guided.tolerance
        motion.axis motion.cos motion.sin motion.hit_normal motion.geometric_normal
        lobe.middle lobe.exponent lobe.helper lobe.axis_1 lobe.axis_2 lobe.x lobe.y lobe.z lobe.direction lobe.height",
    ),
    (
        Unit::Count,
        "polygon.crossings pattern.axes pattern.cell pattern.sum pattern.parity
        sample.column sample.across sample.above sample.count pixel.samples camera.rows
        statistical.degrees_of_freedom statistical.alike_needed guided.asked lobe.kept",
    ),
    (
        Unit::Length,
        "ray.origin camera.direction camera.length camera.position ray.vector ray.length
        plane.offset plane.v_o plane.t touch.t
        sphere.center sphere.radius sphere.oc sphere.t_a sphere.t sphere.from_center
        ellipsoid.center ellipsoid.origin ellipsoid.origin_1 ellipsoid.origin_2 ellipsoid.origin_3 ellipsoid.b
        ellipsoid.t ellipsoid.point ellipsoid.point_1 ellipsoid.point_2 ellipsoid.point_3 ellipsoid.gradient
        quadratic.q quadratic.t_1 quadratic.t_2
        triangle.a triangle.b triangle.c triangle.t triangle.t_near triangle.t_far
        polygon.corner polygon.t polygon.t_near polygon.t_far
        box.min box.max box.to_min box.to_max box.entry box.exit box.t
        axis.base axis.apex axis.length axis.origin axis.origin_along axis.origin_across axis.t_base axis.t_apex
        axis.point axis.point_along axis.point_across
        cylinder.radius cylinder.b cylinder.t
        cone.base_radius cone.t_0 cone.origin_radius cone.b cone.t cone.offset
        disk.center disk.radius disk.v_o disk.t
        hit.point light.position light.center light.edge_u light.edge_v light.radius light.vector light.distance
        pattern.size pattern.point lens.focus_distance lens.focus lens.radius
        motion.shift motion.point motion.arm motion.hit_point",
    ),
    (
        Unit::Area,
        "sphere.radius_squared sphere.l2_oc sphere.t2_a
        ellipsoid.radius_squared ellipsoid.c ellipsoid.discriminant ellipsoid.offset
        triangle.normal triangle.edge_a triangle.edge_b triangle.edge_c triangle.edges_exact triangle.v_d
        polygon.normal polygon.v_d cylinder.radius_squared cylinder.c cylinder.discriminant
        cone.c cone.discriminant disk.distance_squared",
    ),
    (Unit::Volume, "triangle.v_o polygon.v_o"),
    (Unit::PerLength, "light.linear"),
    (Unit::PerArea, "light.quadratic"),
    (
        Unit::Intensity,
        "light.color light.ambient shade.local cutoff.loss incoming.reflected incoming.transmitted
        combine.local combine.reflected combine.transmitted combine.color
        cell.color_1 cell.color_2 cell.color_3 cell.color_4 cell.limit cell.difference
        statistical.mean statistical.standard_error statistical.half_width statistical.widest statistical.limit
        output.white lobe.color lobe.sum lobe.mean background.color pixel.mean",
    ),
    (Unit::Pixels, "pixel.column pixel.middle_column pixel.row pixel.middle_row pixel.left pixel.top"),
    (Unit::PerPixel, "pixel.side"),
    (Unit::Time, "shutter.open shutter.close ray.time"),
    (Unit::LengthPerTime, "motion.translation"),
    (Unit::Degrees, "motion.angle camera.vertical_fov"),
    (Unit::DegreesPerTime, "motion.degrees"),
];
