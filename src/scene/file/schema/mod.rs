//! The serde mirror of `raywalk-scene/1`: one Rust field a key, one default a key that may be left out.
//!
//! These types know how a scene is written and nothing else; whether the numbers make sense is asked in
//! [`validate`](mod@super::validate). Reading is only strict (objects for structs, exact lengths, no `null`) behind the adapter
//! that [`parse`](super::parse) uses.

mod camera;
mod json_schema;
mod light;
mod material;
mod objects;
mod samples;
mod sampling;
mod settings;
mod shape;

pub use camera::{Aim, Camera, Lens};
pub(super) use json_schema::inlined_schema;
pub use json_schema::json_schema;
pub use light::{By, DirectionalLight, DiskLight, Light, LightKind, PointLight, Profile, RectangleLight, SphereLight};
pub use material::{Checker, Material, Materials, Pattern, Weight, Weights};
pub(super) use objects::digest;
pub use objects::{MAX_DUPLICATES, MAX_LIGHTS};
pub use samples::LightSamples;
pub use sampling::{FORMS, Guided, Sampling, Statistical};
pub use settings::{Algorithm, Formulas, Frames, Output, ReflectedScale, Specular, Tracing, Transfer, word};
pub use shape::{
    AxisBox, Cone, Cylinder, Disk, Ellipsoid, Mesh, Motion, Object, Plane, Polygon, Rotation, Shape, Sphere, Triangle,
};

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The value of the key `format`: the only form of scene file that this program reads.
pub const FORMAT: &str = "raywalk-scene/1";

/// Three coordinates, right-handed.
pub type Vec3 = [f64; 3];

/// Red, green and blue, in the scene's own scale.
pub type Rgb = [f64; 3];

/// A whole scene file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// [`FORMAT`].
    #[schemars(description = "The format of the file and its version.", extend("const" = FORMAT))]
    pub format: String,
    /// The scene's name; if omitted, the stem of the file's name.
    #[serde(default)]
    pub name: String,
    /// Where the picture is taken from, and what part of the scene it shows.
    #[schemars(with = "camera::CameraKeys")]
    pub camera: Camera,
    /// I_a, the ambient light.
    #[serde(default)]
    #[schemars(inner(range(min = 0)))]
    pub ambient: Rgb,
    /// The colour of a ray that hits nothing.
    #[serde(default)]
    #[schemars(inner(range(min = 0)))]
    pub background: Rgb,
    /// The lights, in the order of the file.
    #[serde(default, deserialize_with = "objects::lights")]
    #[schemars(with = "Vec<light::LightKeys>")]
    pub lights: Vec<Light>,
    /// The materials by name, in the order of the file.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Material>")]
    pub materials: Materials,
    /// The objects; of coincident surfaces the first is the nearer one.
    #[serde(deserialize_with = "objects::objects")]
    pub objects: Vec<Object>,
    /// How rays are traced.
    #[serde(default)]
    pub tracing: Tracing,
    /// Which rays make a pixel.
    #[serde(default)]
    pub sampling: Sampling,
    /// Which random numbers the samples draw: another seed gives another picture of the same scene.
    #[serde(default)]
    pub seed: u64,
    /// The frames of an animation; if omitted, the scene is a single picture.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frames: Option<Frames>,
    /// How values become the numbers of a picture.
    #[serde(default)]
    pub output: Output,
}
