//! The keys of one of the `lights`: the kind of light is itself a key, beside the others.

use compact_str::CompactString;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{LightSamples, Rgb, Vec3};

/// One light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "LightKeys")]
pub struct Light {
    /// Its name; if omitted, `light-1` and so on.
    pub name: CompactString,
    /// Its position and form.
    #[serde(flatten)]
    pub kind: LightKind,
    /// I_i, its intensity in each channel.
    pub color: Rgb,
    /// c, l and q of the attenuation min(1, 1/(c + l·d + q·d²)) at the distance d. A directional light has none.
    pub attenuation: [f64; 3],
    /// How the light is spread over its surface: of rectangles and disks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile: Option<Profile>,
    /// How many shadow rays ask for an area light.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub samples: Option<LightSamples>,
    /// By what measure the points of an area light count alike.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub by: Option<By>,
}

/// The kinds of light, one key each.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LightKind {
    /// `point`.
    Point(PointLight),
    /// `directional`.
    Directional(DirectionalLight),
    /// `rectangle`.
    Rectangle(RectangleLight),
    /// `disk`.
    Disk(DiskLight),
    /// `sphere`.
    Sphere(SphereLight),
}

impl LightKind {
    /// The key of this kind.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Point(_) => "point",
            Self::Directional(_) => "directional",
            Self::Rectangle(_) => "rectangle",
            Self::Disk(_) => "disk",
            Self::Sphere(_) => "sphere",
        }
    }

    /// Whether the light has a surface, so that `samples` means something.
    pub fn is_area(&self) -> bool {
        matches!(self, Self::Rectangle(_) | Self::Disk(_) | Self::Sphere(_))
    }

    /// Whether the light takes a `profile`.
    pub fn has_profile(&self) -> bool {
        matches!(self, Self::Rectangle(_) | Self::Disk(_))
    }

    /// Whether the points of the light can be spread by solid angle.
    pub fn has_solid_angle(&self) -> bool {
        matches!(self, Self::Rectangle(_) | Self::Sphere(_))
    }
}

/// Light from one point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointLight {
    /// The point.
    pub position: Vec3,
}

/// Parallel light, from infinitely far away.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DirectionalLight {
    /// The vector along which the light travels, of any length.
    pub direction: Vec3,
}

/// Light from a parallelogram.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RectangleLight {
    /// One corner.
    pub corner: Vec3,
    /// The edge from the corner along u.
    pub edge_u: Vec3,
    /// The edge from the corner along v.
    pub edge_v: Vec3,
}

/// Light from a flat disk.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DiskLight {
    /// Its centre.
    pub center: Vec3,
    /// The normal of its plane, of any length.
    pub normal: Vec3,
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// Light from the surface of a sphere.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereLight {
    /// Its centre.
    pub center: Vec3,
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// The weight over the surface of an area light.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Profile {
    /// The same everywhere.
    #[default]
    Uniform,
    /// Proportional to cos^p(π/2·ρ), ρ the distance from the centre as a part of the radius.
    CosinePower(#[schemars(range(min = 0))] f64),
}

/// By what measure the points of an area light count alike.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum By {
    /// By the area of its surface.
    #[default]
    Area,
    /// By the solid angle under which a surface point sees them.
    SolidAngle,
}

/// One light.
// The keys one by one, before it is known which kind was given.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Light")]
#[schemars(extend("oneOf" = [
    {"required": ["point"]}, {"required": ["directional"]}, {"required": ["rectangle"]}, {"required": ["disk"]},
    {"required": ["sphere"]},
]))]
#[schemars(extend("dependentSchemas" = {
    "profile": {"anyOf": [{"required": ["rectangle"]}, {"required": ["disk"]}]},
    "samples": {"anyOf": [{"required": ["rectangle"]}, {"required": ["disk"]}, {"required": ["sphere"]}]},
    "by": {"anyOf": [
        {"required": ["rectangle"]}, {"required": ["sphere"]}, {"required": ["disk"], "patternProperties": {"^by$": {"const": "area"}}},
    ]},
}))]
pub struct LightKeys {
    /// Its name; if omitted, `light-1` and so on.
    #[serde(default)]
    #[schemars(with = "String")]
    name: CompactString,
    /// Light from one point.
    point: Option<PointLight>,
    /// Parallel light, from infinitely far away.
    directional: Option<DirectionalLight>,
    /// Light from a parallelogram.
    rectangle: Option<RectangleLight>,
    /// Light from a flat disk.
    disk: Option<DiskLight>,
    /// Light from the surface of a sphere.
    sphere: Option<SphereLight>,
    /// I_i, its intensity in each channel.
    #[serde(default = "white")]
    #[schemars(inner(range(min = 0)))]
    color: Rgb,
    /// c, l and q of the attenuation min(1, 1/(c + l·d + q·d²)) at the distance d. A directional light has none.
    #[serde(default = "no_attenuation")]
    #[schemars(inner(range(min = 0)))]
    attenuation: [f64; 3],
    /// How the intensity varies over the surface of a rectangle or disk; `uniform` if omitted.
    profile: Option<Profile>,
    /// The number of shadow rays to an area light, fixed or from `min` to `max` as needed; 1 by default.
    samples: Option<LightSamples>,
    /// By what measure the points of an area light count alike: `area` if omitted, or `solid_angle` (rectangles and spheres).
    by: Option<By>,
}

fn white() -> Rgb {
    [1.0; 3]
}

fn no_attenuation() -> [f64; 3] {
    [1.0, 0.0, 0.0]
}

impl TryFrom<LightKeys> for Light {
    type Error = &'static str;

    fn try_from(keys: LightKeys) -> Result<Self, Self::Error> {
        let kinds = [
            keys.point.map(LightKind::Point),
            keys.directional.map(LightKind::Directional),
            keys.rectangle.map(LightKind::Rectangle),
            keys.disk.map(LightKind::Disk),
            keys.sphere.map(LightKind::Sphere),
        ];
        let given: Vec<LightKind> = kinds.into_iter().flatten().collect();
        let [kind] = given[..] else {
            return Err("expected exactly one of `point`, `directional`, `rectangle`, `disk`, `sphere`");
        };
        Ok(Self {
            name: keys.name,
            kind,
            color: keys.color,
            attenuation: keys.attenuation,
            profile: keys.profile.or(kind.has_profile().then(Profile::default)),
            samples: keys.samples.or(kind.is_area().then_some(LightSamples::Count(1))),
            by: keys.by.or(kind.is_area().then(By::default)),
        })
    }
}
