//! Reading a header whose keys may be in any order. What it lists is counted while it is read: a line of some kilobytes, packed, may
//! unpack to more names than there is memory for.

use super::{FrameId, Header, MAX_NAMES, MAX_PARAMETERS, Parameter, SceneId, Subject, TracingId};
use crate::log::shard::Shard;
use crate::log::whole::Whole;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;

impl<'de> Deserialize<'de> for Header {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Header, D::Error> {
        Fields::deserialize(deserializer)?.header().map_err(D::Error::custom)
    }
}

#[derive(serde::Deserialize)]
#[serde(expecting = "the header of a log")]
struct Fields {
    log: String,
    version: String,
    scene: SceneId,
    #[serde(default, deserialize_with = "present")]
    pixel: Option<[Whole<u32>; 2]>,
    #[serde(default, deserialize_with = "present")]
    ray: Option<[f64; 6]>,
    #[serde(default, deserialize_with = "present")]
    region: Option<[Whole<u32>; 4]>,
    arithmetic: String,
    tracing: TracingId,
    sampling: Few<Few<Parameter>>,
    #[serde(default)]
    seed: Whole<u64>,
    frame: Option<FrameId>,
    shard: Option<[Whole<u32>; 2]>,
    objects: Names,
    lights: Names,
}

impl Fields {
    fn header(self) -> Result<Header, String> {
        let subject = (self.pixel.map(|pixel| Subject::Pixel(numbers(pixel))))
            .or(self.ray.map(Subject::Ray))
            .or(self.region.map(|region| Subject::Region(numbers(region))));
        if self.objects.0.len() + self.lights.0.len() > MAX_NAMES {
            return Err(too_many_names());
        }
        Ok(Header {
            log: self.log,
            version: self.version,
            scene: self.scene,
            subject: subject.ok_or("missing field `pixel`, `ray` or `region`")?,
            arithmetic: self.arithmetic,
            tracing: self.tracing,
            sampling: self.sampling.0.into_iter().map(|(method, Few(parameters))| (method, parameters)).collect(),
            seed: self.seed.0,
            frame: self.frame,
            shard: self.shard.map(|shard| Shard::try_from(numbers(shard))).transpose()?,
            objects: self.objects.0,
            lights: self.lights.0,
            only_elsewhere: Vec::new(),
        })
    }
}

/// Reads a subject that has its key: `null` is none.
fn present<'de, T: Deserialize<'de>, D: Deserializer<'de>>(deserializer: D) -> Result<Option<T>, D::Error> {
    T::deserialize(deserializer).map(Some)
}

fn numbers<const N: usize>(whole: [Whole<u32>; N]) -> [u32; N] {
    whole.map(|Whole(number)| number)
}

/// Names of objects or of lights.
struct Names(Vec<String>);

impl<'de> Deserialize<'de> for Names {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Names, D::Error> {
        struct List;
        impl<'de> Visitor<'de> for List {
            type Value = Names;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a list of names")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Names, A::Error> {
                let mut names = Vec::new();
                while let Some(name) = seq.next_element()? {
                    if names.len() == MAX_NAMES {
                        return Err(A::Error::custom(too_many_names()));
                    }
                    names.push(name);
                }
                Ok(Names(names))
            }
        }
        deserializer.deserialize_seq(List)
    }
}

/// What has few keys.
struct Few<T>(BTreeMap<String, T>);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Few<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs<T>(BTreeMap<String, T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Pairs<T> {
            type Value = Few<T>;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a map")
            }
            fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<Few<T>, A::Error> {
                while let Some((key, value)) = map.next_entry()? {
                    if self.0.len() == MAX_PARAMETERS {
                        let message =
                            too_many("methods of sampling, or parameters of one, in a header", MAX_PARAMETERS);
                        return Err(A::Error::custom(message));
                    }
                    self.0.insert(key, value);
                }
                Ok(Few(self.0))
            }
        }
        deserializer.deserialize_map(Pairs(BTreeMap::new()))
    }
}

fn too_many(what: &str, most: usize) -> String {
    format!("too many {what}, expected at most {most}, found more")
}

fn too_many_names() -> String {
    too_many("names of objects and lights in a header", MAX_NAMES)
}
