//! Which formulas intersect a sphere.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The two ways to intersect a sphere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), clap(rename_all = "snake_case"))]
pub enum SphereMethod {
    /// Without cancellation.
    #[default]
    Robust,
    /// As the source text does it.
    Geometric,
}
