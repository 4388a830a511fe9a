//! How many points of an area light are asked.

use std::fmt;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::scene::file::validate::limits::MAX_SAMPLES;

/// How many points of an area light are asked: always this many, or as many as it takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum LightSamples {
    /// This many, each with a shadow ray.
    Count(#[schemars(range(min = 1, max = MAX_SAMPLES))] u32),
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
    pub min: u32,
    /// How many are asked where the light may be hidden in part, or where it is in full view and no rule is good enough; `min` or more.
    #[schemars(range(min = 1, max = MAX_SAMPLES))]
    pub max: u32,
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

    fn visit_u64<E: Error>(self, count: u64) -> Result<LightSamples, E> {
        let whole = u32::try_from(count).map(LightSamples::Count);
        whole.map_err(|_| E::invalid_value(Unexpected::Unsigned(count), &self))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<LightSamples, A::Error> {
        SampleRange::deserialize(MapAccessDeserializer::new(map)).map(LightSamples::Range)
    }
}
