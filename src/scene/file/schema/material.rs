//! The keys of `materials`.

use std::collections::HashMap;
use std::fmt;
use std::sync::Arc;

use compact_str::CompactString;
use schemars::JsonSchema;
use serde::de::{self, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Rgb;
use crate::scene::file::validate::limits::{MAX_RATIO, MAX_SAMPLES};

/// One material; every key has a default.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// K_a: what part of the scene's `ambient` light it sends back.
    #[schemars(inner(range(min = 0)))]
    pub ambient: Rgb,
    /// K_d: what part of a light it scatters in all directions.
    #[schemars(inner(range(min = 0)))]
    pub diffuse: Rgb,
    /// K_e: the colour of the highlight.
    #[schemars(inner(range(min = 0)))]
    pub specular: Rgb,
    /// K_t: what part of a light behind the surface it scatters through, without refraction.
    #[schemars(inner(range(min = 0)))]
    pub transmission: Rgb,
    /// n_e, the exponent of the highlight: the larger, the smaller the highlight.
    #[schemars(range(min = 0))]
    pub shininess: f64,
    /// n_t, the exponent of the local transmission, likewise.
    #[schemars(range(min = 0))]
    pub transmission_exponent: f64,
    /// Refractive index of the medium inside; that of air is 1.
    #[schemars(range(min = 1.0 / MAX_RATIO, max = MAX_RATIO))]
    pub ior: f64,
    /// How much the local light, the reflected ray and the transmitted ray count.
    pub weights: Weights,
    /// n of a blurred reflection, whose rays are spread by cos^n around the mirror's; without it the surface is a mirror.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0))]
    pub gloss_exponent: Option<f64>,
    /// n of a blurred transmission, likewise; without it the medium is clear.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0))]
    pub translucency_exponent: Option<f64>,
    /// Rays for each blurred bounce.
    #[schemars(range(min = 1, max = MAX_SAMPLES))]
    pub samples: u32,
    /// A pattern that multiplies `ambient` and `diffuse`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pattern: Option<Box<Pattern>>,
}

const _: () = assert!(size_of::<Material>() <= 264);

impl Default for Material {
    fn default() -> Self {
        Self {
            ambient: [0.0; 3],
            diffuse: [0.0; 3],
            specular: [0.0; 3],
            transmission: [0.0; 3],
            shininess: 1.0,
            transmission_exponent: 1.0,
            ior: 1.0,
            weights: Weights::default(),
            gloss_exponent: None,
            translucency_exponent: None,
            samples: 1,
            pattern: None,
        }
    }
}

/// W_l, W_r and W_t.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Weights {
    /// Weight of the local intensity.
    pub local: Weight,
    /// Weight of the reflected ray.
    pub reflected: Weight,
    /// Weight of the transmitted ray.
    pub transmitted: Weight,
}

impl Default for Weights {
    fn default() -> Self {
        Self { local: Weight::Scalar(1.0), reflected: Weight::Scalar(0.0), transmitted: Weight::Scalar(0.0) }
    }
}

/// A weight, written as one number or as a colour.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Weight {
    /// The same in every channel.
    Scalar(#[schemars(range(min = 0))] f64),
    /// One number a channel.
    Rgb(#[schemars(inner(range(min = 0)))] Rgb),
}

impl Weight {
    /// The weight of each channel.
    pub fn rgb(self) -> Rgb {
        match self {
            Self::Scalar(weight) => [weight; 3],
            Self::Rgb(weights) => weights,
        }
    }
}

/// A colour that varies over a surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Pattern {
    /// Cubes of two colours.
    Checker(Checker),
}

/// A checkerboard in space.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Checker {
    /// Colour where the sum of floor(coordinate/size) is even.
    #[schemars(inner(range(min = 0)))]
    pub a: Rgb,
    /// Colour where it is odd.
    #[schemars(inner(range(min = 0)))]
    pub b: Rgb,
    /// Edge of a cube.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub size: f64,
}

/// The most materials of a scene in JSON: each takes many times the bytes of its text.
pub const MAX_MATERIALS: usize = 1 << 17;

/// The materials by name, in the order of the file, which is also the order in which they are printed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Materials {
    /// Those that are the same, one after the other, are one piece of memory: programs write what they have before each object.
    materials: Vec<Arc<Material>>,
    names: Vec<CompactString>,
    by_name: HashMap<CompactString, u32>,
}

impl Materials {
    /// Adds a material; `false`, and nothing happens, when the name is taken.
    pub fn insert(&mut self, name: &str, material: Material) -> bool {
        if self.by_name.contains_key(name) {
            return false;
        }
        self.by_name.insert(name.into(), self.names.len() as u32);
        self.names.push(name.into());
        let same = self.materials.last().filter(|latest| ***latest == material).cloned();
        self.materials.push(same.unwrap_or_else(|| Arc::new(material)));
        true
    }

    /// The places of names in the order of the file, and the materials there.
    pub fn into_parts(self) -> (HashMap<CompactString, u32>, Vec<Arc<Material>>) {
        (self.by_name, self.materials)
    }

    /// The place of a name in the order of the file.
    pub fn index_of(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).map(|place| *place as usize)
    }

    /// The material of a name.
    pub fn get(&self, name: &str) -> Option<&Material> {
        self.index_of(name).map(|index| &*self.materials[index])
    }

    /// All names and materials, in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&str, &Material)> {
        self.names.iter().map(CompactString::as_str).zip(self.materials.iter().map(Arc::as_ref))
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }
}

impl Serialize for Materials {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.len()))?;
        for (name, material) in self.iter() {
            map.serialize_entry(name, material)?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for Materials {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(MaterialsVisitor)
    }
}

struct MaterialsVisitor;

impl<'de> Visitor<'de> for MaterialsVisitor {
    type Value = Materials;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str("an object of materials by name")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Materials, A::Error> {
        let mut materials = Materials::default();
        while let Some(name) = map.next_key::<String>()? {
            if materials.len() == MAX_MATERIALS {
                return Err(de::Error::custom(format!(
                    "too many materials, expected at most {MAX_MATERIALS}, found more"
                )));
            }
            if !materials.insert(&name, map.next_value()?) {
                return Err(de::Error::custom("a name occurs twice"));
            }
        }
        Ok(materials)
    }
}
