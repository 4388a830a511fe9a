//! Reading a header whose keys may be in any order. What it lists is counted while it is read: a line of some kilobytes, packed, may
//! unpack to more names than there is memory for.

use super::{Header, MAX_NAMES, MAX_PARAMETERS, Parameter, Subject};
use crate::log::shard::Shard;
use crate::log::whole::Whole;
use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

impl<'de> Deserialize<'de> for Header {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Header, D::Error> {
        deserializer.deserialize_map(Fields)
    }
}

struct Fields;

impl<'de> Visitor<'de> for Fields {
    type Value = Header;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("the header of a log")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Header, A::Error> {
        let (mut log, mut version, mut scene, mut subject) = (None, None, None, None);
        let (mut arithmetic, mut tracing, mut sampling) = (None, None, None);
        let (mut seed, mut frame, mut shard) = (None, None, None);
        let (mut objects, mut lights): (Option<Vec<String>>, Option<Vec<String>>) = (None, None);
        while let Some(Key(key)) = map.next_key()? {
            match &*key {
                "log" => once(&mut log, "log", map.next_value()?)?,
                "version" => once(&mut version, "version", map.next_value()?)?,
                "scene" => once(&mut scene, "scene", map.next_value()?)?,
                "pixel" | "ray" | "region" if subject.is_some() => drop(map.next_value::<IgnoredAny>()?),
                "pixel" => subject = Some(Subject::Pixel(numbers(map.next_value()?))),
                "ray" => subject = Some(Subject::Ray(map.next_value()?)),
                "region" => subject = Some(Subject::Region(numbers(map.next_value()?))),
                "arithmetic" => once(&mut arithmetic, "arithmetic", map.next_value()?)?,
                "tracing" => once(&mut tracing, "tracing", map.next_value()?)?,
                "sampling" => {
                    let Few(methods) = map.next_value::<Few<Few<Parameter>>>()?;
                    let methods = methods.into_iter().map(|(method, Few(parameters))| (method, parameters));
                    once(&mut sampling, "sampling", methods.collect())?;
                }
                "seed" => once(&mut seed, "seed", map.next_value::<Whole<u64>>()?.0)?,
                "frame" => once(&mut frame, "frame", map.next_value()?)?,
                "shard" => {
                    let pair: Option<[Whole<u32>; 2]> = map.next_value()?;
                    let read = pair.map(|pair| Shard::try_from(numbers(pair))).transpose().map_err(A::Error::custom)?;
                    once(&mut shard, "shard", read)?;
                }
                "objects" => {
                    let others = lights.as_ref().map_or(0, Vec::len);
                    once(&mut objects, "objects", map.next_value_seed(Names { others })?)?;
                }
                "lights" => {
                    let others = objects.as_ref().map_or(0, Vec::len);
                    once(&mut lights, "lights", map.next_value_seed(Names { others })?)?;
                }
                _ => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        Ok(Header {
            log: there(log, "log")?,
            version: there(version, "version")?,
            scene: there(scene, "scene")?,
            subject: subject.ok_or_else(|| A::Error::custom("missing field `pixel`, `ray` or `region`"))?,
            arithmetic: there(arithmetic, "arithmetic")?,
            tracing: there(tracing, "tracing")?,
            sampling: there(sampling, "sampling")?,
            seed: seed.unwrap_or_default(),
            frame: frame.unwrap_or_default(),
            shard: shard.unwrap_or_default(),
            objects: there(objects, "objects")?,
            lights: there(lights, "lights")?,
            only_elsewhere: Vec::new(),
        })
    }
}

fn once<T, E: Error>(place: &mut Option<T>, field: &'static str, value: T) -> Result<(), E> {
    if place.replace(value).is_some() { Err(E::duplicate_field(field)) } else { Ok(()) }
}

fn there<T, E: Error>(value: Option<T>, field: &'static str) -> Result<T, E> {
    value.ok_or_else(|| E::missing_field(field))
}

fn numbers<const N: usize>(whole: [Whole<u32>; N]) -> [u32; N] {
    whole.map(|Whole(number)| number)
}

/// A key, borrowed from the text unless it is escaped there.
struct Key<'t>(Cow<'t, str>);

impl<'de: 't, 't> Deserialize<'de> for Key<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text;
        impl<'de> Visitor<'de> for Text {
            type Value = Key<'de>;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a string")
            }
            fn visit_borrowed_str<E: Error>(self, text: &'de str) -> Result<Key<'de>, E> {
                Ok(Key(Cow::Borrowed(text)))
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Key<'de>, E> {
                Ok(Key(Cow::Owned(text.to_owned())))
            }
        }
        deserializer.deserialize_str(Text)
    }
}

/// Reads a list of names, of which there are some already.
struct Names {
    others: usize,
}

impl<'de> DeserializeSeed<'de> for Names {
    type Value = Vec<String>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<String>, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Names {
    type Value = Vec<String>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a list of names")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Vec<String>, A::Error> {
        let mut names = Vec::new();
        while let Some(name) = seq.next_element()? {
            if self.others + names.len() == MAX_NAMES {
                return Err(too_many("names of objects and lights in a header", MAX_NAMES));
            }
            names.push(name);
        }
        Ok(names)
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
                        return Err(too_many("methods of sampling, or parameters of one, in a header", MAX_PARAMETERS));
                    }
                    self.0.insert(key, value);
                }
                Ok(Few(self.0))
            }
        }
        deserializer.deserialize_map(Pairs(BTreeMap::new()))
    }
}

fn too_many<E: Error>(what: &str, most: usize) -> E {
    E::custom(format!("too many {what}, expected at most {most}, found more"))
}
