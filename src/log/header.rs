//! What a log says about itself: enough to replay it without the scene.

mod read;

use super::shard::Shard;
use super::whole::whole;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use std::collections::BTreeMap;
use std::fmt;

/// The name and version of the format.
pub const FORMAT: &str = "raywalk-log/1";

/// The most names in a header, of objects and lights together.
pub const MAX_NAMES: usize = 1 << 20;

/// The most methods of sampling in a header, and parameters of each.
pub const MAX_PARAMETERS: usize = 64;

/// The first line of a log.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Header {
    /// The format and its version, `raywalk-log/1`.
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
    pub sampling: BTreeMap<String, BTreeMap<String, Parameter>>,
    /// Which random numbers samples drew; 0 isn't written.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub seed: u64,
    /// Which frame of an animation was traced; not written where there is one only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "FrameId")]
    pub frame: Option<FrameId>,
    /// Which part of a region's pixels the log has; not written where it has all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "[u32; 2]")]
    pub shard: Option<Shard>,
    /// The names of the objects, by number.
    pub objects: Vec<String>,
    /// The names of the lights, by number.
    pub lights: Vec<String>,
    /// Of these names, those that are there only so that the numbers agree with those of another log. Never written.
    #[serde(skip)]
    pub only_elsewhere: Vec<String>,
}

// serde hands over a reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_zero(seed: &u64) -> bool {
    *seed == 0
}

// serde hands over a reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_false(flag: &bool) -> bool {
    !*flag
}

/// A parameter of a method of sampling. Whole ones are written without a point, so that there is one spelling of each.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct Parameter(pub f64);

impl Serialize for Parameter {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let whole = self.0 as u32;
        if f64::from(whole) == self.0 { serializer.serialize_u32(whole) } else { serializer.serialize_f64(self.0) }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// A frame of an animation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrameId {
    /// Its number, from 1.
    #[serde(deserialize_with = "whole")]
    pub number: u32,
    /// What it adds to the times of the shutter, in the unit of the objects' motions.
    pub time: f64,
}

/// The scene of a log.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SceneId {
    /// The scene's name.
    pub name: String,
    /// The digest of the resolved scene, `blake3:…`; empty, and not written, where another program made the log.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub digest: String,
}

/// What part of a scene was traced.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TracingId {
    /// The algorithm: `recursive`, `whitted` or `foley`.
    pub algorithm: String,
    /// Its depth limit.
    #[serde(deserialize_with = "whole")]
    pub max_depth: u32,
    /// The specular term: `half_vector`, `reflection_vector` or `half_vector_compensated`.
    pub specular: String,
    /// `notes` for the formulas of the source text; not written for the robust ones.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formulas: Option<String>,
    /// The sphere's formulas: `robust` or `geometric`.
    pub sphere_method: String,
    /// `specular` where W_r·K_e scales the colour of a reflected ray; not written for W_r.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reflected_scale: Option<String>,
    /// Whether the products of dot products are rounded before they are added; only written where they are.
    #[serde(default, skip_serializing_if = "is_false")]
    pub round_products: bool,
    /// The weight below which bounces are left out.
    pub cutoff: f64,
    /// Whether faces are seen from behind.
    pub two_sided: bool,
    /// The rules by which work is left out, with commas between them; not written where all are in force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub skip: Option<String>,
    /// `all` where a log shows every intersection test; not written where it shows those that the tracer ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub tests: Option<String>,
}

impl Header {
    /// To how many decimals the products of dot products are rounded before they are added; `None` if they aren't.
    pub fn decimals_of_products(&self) -> Option<u32> {
        let digits = self.arithmetic.strip_prefix("decimal:").filter(|_| self.tracing.round_products)?;
        digits.parse().ok()
    }

    /// The name of an object; `?` if the header has none for it.
    pub fn object(&self, object: u32) -> &str {
        self.objects.get(object as usize).map_or("?", String::as_str)
    }

    /// The name of a light; `?` if the header has none for it.
    pub fn light(&self, light: u32) -> &str {
        self.lights.get(light as usize).map_or("?", String::as_str)
    }
}
