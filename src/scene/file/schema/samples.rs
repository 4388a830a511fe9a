//! How many points of an area light are asked.

use std::fmt;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::scene::file::validate::limits::MAX_SAMPLES;

/// How many points of an area light are asked: always this many, or as many as it takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum LightSamples {
    /// This many, each with a shadow ray.
    Count(#[schemars(range(min = 1, max = MAX_SAMPLES))] u64),
    /// As many as it takes.
    Range(SampleRange),
}

/// The fewest points of a rule that takes the place of shadow rays where nothing can block the light, and the points that are asked, each with
/// a shadow ray, where something may. Where one object hides all of the light a single one is asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SampleRange {
    /// The fewest points of a rule; it may have more than `max`.
    #[schemars(range(min = 1, max = MAX_SAMPLES))]
    pub min: u64,
    /// How many are asked where the light may be hidden in part, or where it is in full view and no rule is good enough; `min` or more.
    #[schemars(range(min = 1, max = MAX_SAMPLES))]
    pub max: u64,
}

impl LightSamples {
    /// The same, but for this many at most.
    #[must_use]
    pub fn at_most(self, most: u64) -> LightSamples {
        match self {
            Self::Count(count) => Self::Count(count.min(most)),
            Self::Range(SampleRange { min, max }) => {
                Self::Range(SampleRange { min: min.min(most), max: max.min(most) })
            }
        }
    }
}

impl<'de> Deserialize<'de> for LightSamples {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SamplesVisitor)
    }
}

struct SamplesVisitor;

impl<'de> Visitor<'de> for SamplesVisitor {
    type Value = LightSamples;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "a whole number from 1 to {MAX_SAMPLES}, or an object with `min` and `max`")
    }

    fn visit_u64<E>(self, count: u64) -> Result<LightSamples, E> {
        Ok(LightSamples::Count(count))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<LightSamples, A::Error> {
        SampleRange::deserialize(MapAccessDeserializer::new(map)).map(LightSamples::Range)
    }
}
