//! A flake of spheres: each carries ten of a third of its radius, which carry ten each, and so on.
//!
//! The idea is that of "balls" in Eric Haines' Standard Procedural Databases (1987), which has six children about the equator
//! and three above it; here one more sits at the pole, so that the levels have 1, 11, 111 spheres and the sixth more than a
//! million. The scene is written as it is computed, so that a million spheres need no memory.

use std::io::{self, Write};

use glam::DVec3;

/// The greatest level, 1,111,111 spheres: the file of the next one would be larger than a scene may be.
pub const MAX_FLAKE_LEVEL: u32 = 6;

/// Writes the flake as a scene, `raywalk-scene/1`. A sphere is named after its way from the first, `ball`: its third
/// child's first is `ball-20`.
pub fn sphere_flake(level: u32, out: &mut impl Write) -> io::Result<()> {
    out.write_all(HEAD.as_bytes())?;
    let mut name = "ball".to_owned();
    let first = Ball { center: DVec3::ZERO, radius: 0.5, axis: DVec3::Z };
    first.write(level, &mut name, out)?;
    out.write_all(TAIL.as_bytes())
}

const HEAD: &str = r#"{
  "format": "raywalk-scene/1",
  "name": "sphere-flake",
  "camera": {"position": [2.1, 1.3, 1.7], "look_at": [0, 0, 0], "up": [0, 0, 1], "vertical_fov": 45,
             "resolution": [512, 512]},
  "sampling": {"guided": {"tolerance": 0.002, "min": 4, "max": 4096}},
  "ambient": [0.1, 0.1, 0.1],
  "background": [0.078, 0.361, 0.753],
  "lights": [{"name": "key", "point": {"position": [4, 3, 2]}, "color": [0.5, 0.5, 0.5]},
             {"name": "fill", "point": {"position": [1, -4, 4]}, "color": [0.3, 0.3, 0.3]},
             {"name": "back", "point": {"position": [-3, 1, 5]}, "color": [0.2, 0.2, 0.2]}],
  "materials": {
    "ground": {"ambient": [1, 0.75, 0.33], "diffuse": [1, 0.75, 0.33]},
    "ball": {"ambient": [0.5, 0.45, 0.35], "diffuse": [0.5, 0.45, 0.35], "specular": [0.5, 0.5, 0.5], "shininess": 60,
             "weights": {"local": 1, "reflected": 0.5}}
  },
  "objects": [
    {"name": "ground", "shape": {"plane": {"coefficients": [0, 0, 1, 0.5]}}, "material": "ground"}"#;

const TAIL: &str = "\n  ]\n}\n";

/// Decimals of the coordinates, some of what a sphere of the last level is wide.
const DECIMALS: f64 = 1e9;

/// A sphere; its axis points away from the one that carries it.
struct Ball {
    center: DVec3,
    radius: f64,
    axis: DVec3,
}

impl Ball {
    fn write(&self, level: u32, name: &mut String, out: &mut impl Write) -> io::Result<()> {
        let rounded = |x: f64| (x * DECIMALS).round() / DECIMALS + 0.0;
        let [x, y, z] = self.center.to_array().map(rounded);
        write!(
            out,
            ",\n    {{\"name\": \"{name}\", \"shape\": {{\"sphere\": {{\"center\": [{x}, {y}, {z}], \"radius\": {}}}}}, \
             \"material\": \"ball\"}}",
            rounded(self.radius)
        )?;
        if level == 0 {
            return Ok(());
        }
        let length = name.len();
        if length == "ball".len() {
            name.push('-');
        }
        for (digit, axis) in ('0'..='9').zip(self.axes_of_children()) {
            let radius = self.radius / 3.0;
            name.push(digit);
            let child = Ball { center: self.center + axis * (self.radius + radius), radius, axis };
            child.write(level - 1, name, out)?;
            name.pop();
        }
        name.truncate(length);
        Ok(())
    }

    /// Where the children sit: six around the equator, 60° apart, three in between at a height of √(2/3), one at the pole.
    fn axes_of_children(&self) -> impl Iterator<Item = DVec3> + use<> {
        let half_root_3 = 0.75_f64.sqrt();
        let equator = [
            (1.0, 0.0),
            (0.5, half_root_3),
            (-0.5, half_root_3),
            (-1.0, 0.0),
            (-0.5, -half_root_3),
            (0.5, -half_root_3),
        ];
        let (height, away) = ((2.0_f64 / 3.0).sqrt(), (1.0_f64 / 3.0).sqrt());
        let above = [(half_root_3, 0.5), (-half_root_3, 0.5), (0.0, -1.0)];
        let axis = self.axis;
        let (right, up) = across(axis);
        let around = equator.into_iter().map(move |(x, y)| right * x + up * y);
        let above = above.into_iter().map(move |(x, y)| (right * x + up * y) * away + axis * height);
        around.chain(above).chain([axis])
    }
}

/// Two unit vectors across a unit vector and each other (Duff et al., Building an orthonormal basis, revisited, 2017).
fn across(axis: DVec3) -> (DVec3, DVec3) {
    let sign = 1.0_f64.copysign(axis.z);
    let a = -1.0 / (sign + axis.z);
    let b = axis.x * axis.y * a;
    let right = DVec3::new(1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
    (right, DVec3::new(b, sign + axis.y * axis.y * a, -axis.y))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::scene::file;
    use crate::scene::file::schema::Shape;

    fn spheres(level: u32) -> Vec<(DVec3, f64)> {
        let mut text = Vec::new();
        sphere_flake(level, &mut text).unwrap();
        let scene = file::check(&text, "flake.json").unwrap_or_else(|error| panic!("{}", error.report(false))).scene;
        let sphere = |object: &file::schema::Object| match object.shape {
            Shape::Sphere(sphere) => Some((sphere.center.into(), sphere.radius)),
            _ => None,
        };
        scene.objects.iter().filter_map(sphere).collect()
    }

    #[test]
    fn it_is_a_good_scene_of_as_many_spheres_as_it_says() {
        for (level, expected) in [(0, 1), (1, 11), (2, 111), (3, 1111)] {
            assert_eq!(spheres(level).len(), expected);
        }
    }

    #[test]
    fn children_touch_their_parent_and_nobody_else() {
        let spheres = spheres(1);
        for (index, (center, radius)) in spheres.iter().enumerate() {
            for (other, (other_center, other_radius)) in spheres.iter().enumerate().take(index) {
                let gap = center.distance(*other_center) - radius - other_radius;
                assert!(if other == 0 { gap.abs() < 1e-8 } else { gap > 0.0 }, "{index} {other}: {gap}");
            }
        }
    }
}
