//! The keys of one of the `objects`: its shape, material and motion.

use compact_str::CompactString;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Vec3;

/// One object.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// Its name; if omitted, `object-1` and so on.
    #[serde(default)]
    #[schemars(with = "String")]
    pub name: CompactString,
    /// Its geometry.
    pub shape: Shape,
    /// The name of its material; if omitted, a material with every key at its default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub material: Option<CompactString>,
    /// How it moves between time 0 and time 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<Box<Motion>>,
}

// A file of nothing but spheres says one in 51 bytes, and in NFF in 10: docs/robustness.md has what memory that takes.
const _: () = assert!(size_of::<Object>() <= 96);

/// The geometry of an object: one of these keys.
// Those larger than a sphere are boxed, so that a million spheres don't take the room of a million triangles.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Shape {
    /// An infinite plane.
    Plane(Plane),
    /// A sphere.
    Sphere(Sphere),
    /// An ellipsoid.
    Ellipsoid(Box<Ellipsoid>),
    /// A triangle.
    Triangle(Box<Triangle>),
    /// A flat polygon.
    Polygon(Box<Polygon>),
    /// A box along the axes.
    Box(Box<AxisBox>),
    /// A cylinder.
    Cylinder(Box<Cylinder>),
    /// A cone or a frustum.
    Cone(Box<Cone>),
    /// A flat disk.
    Disk(Box<Disk>),
    /// Triangles of another file.
    Mesh(Mesh),
}

impl Shape {
    /// The path of a mesh, as it is written.
    pub fn mesh_path(&self) -> Option<&str> {
        match self {
            Shape::Mesh(mesh) => Some(&mesh.path),
            _ => None,
        }
    }

    /// The key of this shape.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Plane(_) => "plane",
            Self::Sphere(_) => "sphere",
            Self::Ellipsoid(_) => "ellipsoid",
            Self::Triangle(_) => "triangle",
            Self::Polygon(_) => "polygon",
            Self::Box(_) => "box",
            Self::Cylinder(_) => "cylinder",
            Self::Cone(_) => "cone",
            Self::Disk(_) => "disk",
            Self::Mesh(_) => "mesh",
        }
    }
}

/// The plane Ax + By + Cz + D = 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// A, B, C (the normal, of any length) and D.
    pub coefficients: [f64; 4],
}

/// A sphere.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Whether the front is the inside.
    #[serde(default)]
    pub inward: bool,
}

/// world = center + rotation·(radii ∘ unit point).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ellipsoid {
    /// Its centre.
    pub center: Vec3,
    /// Its three radii.
    #[schemars(extend("items" = {"type": "number", "exclusiveMinimum": 0}))]
    pub radii: Vec3,
    /// The rows of a rotation matrix; if omitted, the axes of the ellipsoid are those of the world.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotation: Option<Box<[Vec3; 3]>>,
}

/// A triangle, counter-clockwise seen from the front.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Triangle {
    /// Its corners.
    pub vertices: [Vec3; 3],
    /// Normals at the corners, for smooth shading.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normals: Option<Box<[Vec3; 3]>>,
}

/// A flat polygon, counter-clockwise seen from the front.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Polygon {
    /// Its corners, three or more.
    #[schemars(length(min = 3))]
    pub vertices: Vec<Vec3>,
    /// Normals at the corners, for smooth shading.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 3))]
    pub normals: Option<Vec<Vec3>>,
}

/// A box along the axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisBox {
    /// The corner of the smallest coordinates.
    pub min: Vec3,
    /// The corner of the largest coordinates.
    pub max: Vec3,
}

/// A cylinder.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Centre of one end.
    pub base: Vec3,
    /// Centre of the other end.
    pub apex: Vec3,
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Whether the ends are closed.
    #[serde(default)]
    pub caps: bool,
    /// Whether the front is the inside.
    #[serde(default)]
    pub inward: bool,
}

/// A cone or a frustum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// Centre of one end.
    pub base: Vec3,
    /// Radius of that end.
    #[schemars(range(min = 0))]
    pub base_radius: f64,
    /// Centre of the other end.
    pub apex: Vec3,
    /// Radius of that end.
    #[schemars(range(min = 0))]
    pub apex_radius: f64,
    /// Whether the ends are closed.
    #[serde(default)]
    pub caps: bool,
    /// Whether the front is the inside.
    #[serde(default)]
    pub inward: bool,
}

/// A flat disk.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Disk {
    /// Its centre.
    pub center: Vec3,
    /// The normal of its front, of any length.
    pub normal: Vec3,
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// Triangles of another file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// An OBJ or PLY file, relative to the scene file.
    pub path: String,
}

/// Where an object has got to at time 1: at time t it is turned by t·degrees, then moved by t·translation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// How far it moves.
    #[serde(default)]
    pub translation: Vec3,
    /// How far it turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotation: Option<Rotation>,
}

/// A turn about an axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rotation {
    /// The axis, of any length.
    pub axis: Vec3,
    /// A point on the axis.
    pub point: Vec3,
    /// The angle.
    pub degrees: f64,
}
