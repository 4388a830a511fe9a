//! How many points of an area light are asked.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scene::file::validate::limits::MAX_SAMPLES;

/// How many points of an area light get a shadow ray: a fixed number, or as many as needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum LightSamples {
    /// This many, each with a shadow ray.
    Count(#[schemars(range(min = 1, max = MAX_SAMPLES))] u32),
    /// The fewest points of a rule that takes the place of shadow rays where nothing can block the light, and the points that are asked, each
    /// with a shadow ray, where something may. Where one object hides all of the light a single one is asked.
    Range {
        /// The fewest points of a rule; it may have more than `max`.
        #[schemars(range(min = 1, max = MAX_SAMPLES))]
        min: u32,
        /// How many are asked where the light may be hidden in part, or where it is in full view and no rule is good enough; `min` or more.
        #[schemars(range(min = 1, max = MAX_SAMPLES))]
        max: u32,
    },
}
