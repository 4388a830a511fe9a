//! What a log says about itself: enough to replay it without the scene.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The name and version of the format.
pub const FORMAT: &str = "raywalk-log/1";

/// The first line of a log.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Always [`FORMAT`].
    pub log: String,
    /// The version of the program that wrote the log.
    pub version: String,
    /// The scene that was traced.
    pub scene: SceneId,
    /// What was traced of it.
    #[serde(flatten)]
    pub subject: Subject,
    /// The arithmetic, such as `f64` or `decimal:3`.
    pub arithmetic: String,
    /// How rays were traced.
    pub tracing: TracingId,
    /// How pixels were sampled: the method and its parameters.
    pub sampling: BTreeMap<String, BTreeMap<String, f64>>,
    /// Which random numbers samples drew; 0 isn't written.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub seed: u64,
    /// The names of the objects, by number.
    pub objects: Vec<String>,
    /// The names of the lights, by number.
    pub lights: Vec<String>,
}

// serde hands over a reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_zero(seed: &u64) -> bool {
    *seed == 0
}

/// Which scene a log tells of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SceneId {
    /// The scene's name.
    pub name: String,
    /// The digest of the resolved scene, `blake3:…`.
    pub digest: String,
}

/// What part of a scene was traced.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Subject {
    /// One pixel: column and row from the top left.
    Pixel([u32; 2]),
    /// One ray: origin and direction.
    Ray([f64; 6]),
    /// The pixels of a rectangle: left, top, right and bottom, the last two exclusive.
    Region([u32; 4]),
}

/// The options of the tracing, as words.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TracingId {
    /// The algorithm: `recursive`, `whitted` or `foley`.
    pub algorithm: String,
    /// Its depth limit.
    pub max_depth: u32,
    /// The specular term: `half_vector` or `reflection_vector`.
    pub specular: String,
    /// The sphere's formulas: `robust` or `geometric`.
    pub sphere_method: String,
    /// The weight below which bounces are left out.
    pub cutoff: f64,
    /// Whether faces are seen from behind.
    pub two_sided: bool,
}

impl Header {
    /// The name of an object; `?` if the header has none for it.
    pub fn object(&self, object: u32) -> &str {
        self.objects.get(object as usize).map_or("?", String::as_str)
    }

    /// The name of a light; `?` if the header has none for it.
    pub fn light(&self, light: u32) -> &str {
        self.lights.get(light as usize).map_or("?", String::as_str)
    }
}
