//! The keys of `camera`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Vec3;
use crate::scene::file::validate::limits::MAX_SIDE;

/// The camera as the file gives it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "CameraKeys")]
pub struct Camera {
    /// Where the eye is.
    pub position: Vec3,
    /// Where it looks.
    #[serde(flatten)]
    pub aim: Aim,
    /// The vector that points upwards in the picture, of any length; not along the view.
    pub up: Vec3,
    /// The angle from the top edge of the picture to its bottom edge, in degrees.
    pub vertical_fov: f64,
    /// Width and height of the picture in pixels.
    pub resolution: [u32; 2],
    /// A thin lens; without it everything is sharp.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lens: Option<Lens>,
    /// The times at which the shutter opens and closes; objects with `motion` move in between.
    pub shutter: [f64; 2],
}

/// The two ways of saying where a camera looks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Aim {
    /// Along this vector, of any length.
    Direction(Vec3),
    /// At this point.
    LookAt(Vec3),
}

impl Camera {
    /// The direction vector as given, not normalised: `direction`, or `look_at` − `position`.
    pub fn direction(&self) -> Vec3 {
        match self.aim {
            Aim::Direction(direction) => direction,
            Aim::LookAt(point) => std::array::from_fn(|axis| point[axis] - self.position[axis]),
        }
    }
}

/// A thin lens, for depth of field.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Lens {
    /// Radius of the aperture; 0 is a pinhole.
    #[schemars(range(min = 0))]
    pub radius: f64,
    /// Distance from the eye to the plane in focus, along the view.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub focus_distance: f64,
}

/// The camera as the file gives it.
// The keys one by one, before it is known which of `direction` and `look_at` was given.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Camera")]
#[schemars(extend("oneOf" = [{"required": ["direction"]}, {"required": ["look_at"]}]))]
pub struct CameraKeys {
    /// Where the eye is.
    position: Vec3,
    /// The vector along which it looks, of any length. This or `look_at`.
    direction: Option<Vec3>,
    /// The point at which it looks, in the middle of the picture.
    look_at: Option<Vec3>,
    /// The vector that points upwards in the picture, of any length; not along the view.
    #[serde(default = "default_up")]
    up: Vec3,
    /// The angle from the top edge of the picture to its bottom edge, in degrees.
    #[serde(default = "default_vertical_fov")]
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180))]
    vertical_fov: f64,
    /// Width and height of the picture in pixels.
    #[serde(default = "default_resolution")]
    #[schemars(inner(range(min = 1, max = MAX_SIDE)))]
    resolution: [u32; 2],
    /// A thin lens; without it everything is sharp.
    lens: Option<Lens>,
    /// The times at which the shutter opens and closes; objects with `motion` move in between.
    #[serde(default)]
    shutter: [f64; 2],
}

fn default_up() -> Vec3 {
    [0.0, 1.0, 0.0]
}

fn default_vertical_fov() -> f64 {
    45.0
}

fn default_resolution() -> [u32; 2] {
    [320, 240]
}

impl TryFrom<CameraKeys> for Camera {
    type Error = &'static str;

    fn try_from(keys: CameraKeys) -> Result<Self, Self::Error> {
        let aim = match (keys.direction, keys.look_at) {
            (Some(direction), None) => Aim::Direction(direction),
            (None, Some(point)) => Aim::LookAt(point),
            _ => return Err("expected exactly one of `direction`, `look_at`"),
        };
        Ok(Self {
            position: keys.position,
            aim,
            up: keys.up,
            vertical_fov: keys.vertical_fov,
            resolution: keys.resolution,
            lens: keys.lens,
            shutter: keys.shutter,
        })
    }
}
