//! The keys of `tracing`, `frames` and `output`. Their words are those of a log and of the command line, too.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;

use crate::geometry::shape::SphereMethod;
use crate::scene::file::validate::limits::{MAX_DEPTH, MAX_EXPOSURE, MAX_FRAMES};

/// How rays are traced.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Tracing {
    /// Which recursion: that of one of the pseudocodes of the notes.
    pub algorithm: Algorithm,
    /// The depth at which the recursion stops.
    #[schemars(range(max = MAX_DEPTH))]
    pub max_depth: u32,
    /// Which formula of the highlight.
    pub specular: Specular,
    /// Which formulas; if omitted, those of the notes by hand and the robust ones in any other arithmetic.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub formulas: Option<Formulas>,
    /// Which intersection of ray and sphere; if omitted, the one that the formulas imply.
    #[serde(serialize_with = "sphere_method_or_default")]
    pub sphere_method: Option<SphereMethod>,
    /// What scales the light of a reflected ray.
    #[serde(skip_serializing_if = "ReflectedScale::is_default")]
    pub reflected_scale: ReflectedScale,
    /// A bounce is skipped when the product of the weights along its path is below this in every channel; 0 is off.
    #[schemars(range(min = 0))]
    pub cutoff: f64,
    /// Whether rays hit surfaces from behind; transmitting ones are always hit.
    pub two_sided: bool,
}

impl Default for Tracing {
    fn default() -> Self {
        Self {
            algorithm: Algorithm::default(),
            max_depth: 4,
            specular: Specular::default(),
            formulas: None,
            sphere_method: None,
            reflected_scale: ReflectedScale::default(),
            cutoff: 0.0,
            two_sided: true,
        }
    }
}

/// A scene that names no method has the digest of one that names the default, as it had before methods could be implied.
// serde hands over a reference.
#[allow(clippy::ref_option)]
fn sphere_method_or_default<S: Serializer>(method: &Option<SphereMethod>, serializer: S) -> Result<S::Ok, S::Error> {
    method.unwrap_or_default().serialize(serializer)
}

/// The recursion of the first pseudocode, of the second as printed, or of the second as in its source.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), clap(rename_all = "snake_case"))]
pub enum Algorithm {
    /// Starts at depth 0; a ray deeper than the limit is black.
    #[default]
    Recursive,
    /// Starts at depth 1; at the limit a hit returns the ambient term only.
    Whitted,
    /// Starts at depth 1; at the limit only the bounces stop.
    Foley,
}

/// The two forms of the specular term.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), clap(rename_all = "snake_case"))]
#[schemars(rename = "SpecularForm")]
pub enum Specular {
    /// N·H.
    #[default]
    HalfVector,
    /// R·V.
    ReflectionVector,
    /// N·H with four times the exponent, which makes its highlight as wide as that of R·V.
    HalfVectorCompensated,
}

/// Where two formulas give the same number in exact arithmetic.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), clap(rename_all = "snake_case"))]
pub enum Formulas {
    /// Those that keep their digits.
    #[default]
    Robust,
    /// Those that the notes print; every new direction is normalised.
    Notes,
}

/// What scales the light of a reflected ray.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ReflectedScale {
    /// The weight W_r.
    #[default]
    Weight,
    /// W_r·K_e, as the second pseudocode does.
    Specular,
}

impl ReflectedScale {
    // serde hands over a reference.
    #[allow(clippy::trivially_copy_pass_by_ref)]
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// An animation: frame k, from 1, adds (k − 1)·duration/count to both shutter times.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frames {
    /// How many frames.
    #[schemars(range(min = 1, max = MAX_FRAMES))]
    pub count: u32,
    /// The time that all of them last.
    #[schemars(range(min = 0))]
    pub duration: f64,
}

impl Frames {
    /// What a frame, counted from 1, adds to the times of the shutter.
    pub fn time_of(&self, frame: u32) -> f64 {
        f64::from(frame.saturating_sub(1)) * self.duration / f64::from(self.count)
    }
}

/// How values become the numbers of a picture; integer formats only.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// The value shown as full white.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub white: f64,
    /// The curve from value to number.
    pub transfer: Transfer,
    /// Exposure in stops.
    #[schemars(range(min = -MAX_EXPOSURE, max = MAX_EXPOSURE))]
    pub exposure: f64,
}

impl Default for Output {
    fn default() -> Self {
        Self { white: 1.0, transfer: Transfer::default(), exposure: 0.0 }
    }
}

/// The curve from value to number.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), clap(rename_all = "snake_case"))]
pub enum Transfer {
    /// In proportion.
    #[default]
    Linear,
    /// The sRGB curve.
    Srgb,
}

/// The word for a choice, as scene files and logs write it.
pub fn word(choice: impl Serialize) -> String {
    match serde_json::to_value(choice) {
        Ok(Value::String(word)) => word,
        _ => String::new(),
    }
}
