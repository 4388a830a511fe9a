//! The checks of one of the `lights`.

use crate::scene::file::schema::{By, Light, LightKind, LightSamples, Profile, RectangleLight};

use super::checker::Checker;
use super::limits::MAX_SAMPLES;
use super::vector::{are_parallel, are_perpendicular};

/// Checks a light, all but its name.
pub fn light(check: &mut Checker<'_>, light: &Light) {
    kind(check.at(light.kind.key()), &light.kind);
    check.color("color", light.color);
    check.color("attenuation", light.attenuation);
    if light.attenuation == [0.0; 3] {
        let message = "must not be zero throughout, found [0, 0, 0] (no attenuation is [1, 0, 0])";
        check.at("attenuation").error(message.to_string());
    }
    if let Some(Profile::CosinePower(power)) = light.profile {
        check.at("profile").not_negative("cosine_power", power);
    }
    surface(check, light);
    if let (LightKind::Rectangle(RectangleLight { edge_u, edge_v, .. }), Some(By::SolidAngle)) = (light.kind, light.by)
        && !are_perpendicular(edge_u, edge_v)
    {
        let message =
            "`solid_angle` is for rectangles with perpendicular edges, found a parallelogram (`area` takes any)";
        check.at("by").error(message.to_string());
    }
    if let Some(points) = light.samples {
        samples(check, points);
    }
}

/// Checks that a light has what its keys are about: a surface, and of the right form.
fn surface(check: &mut Checker<'_>, light: &Light) {
    let (kind, key) = (light.kind, light.kind.key());
    let mut is_for = |name: &'static str, is_given: bool, kinds: &str| {
        if is_given {
            check.at(name).error_in_key(format!("`{name}` is for {kinds} lights, found it on a `{key}` light"));
        }
    };
    is_for("profile", light.profile.is_some() && !kind.has_profile(), "`rectangle` and `disk`");
    is_for("samples", light.samples.is_some() && !kind.is_area(), "`rectangle`, `disk` and `sphere`");
    is_for("by", light.by.is_some() && !kind.is_area(), "`rectangle`, `disk` and `sphere`");
    if kind.is_area() && light.by == Some(By::SolidAngle) && !kind.has_solid_angle() {
        let message = format!(
            "`solid_angle` is for `rectangle` and `sphere` lights, found it on a `{key}` light, whose points can be spread by `area` alone"
        );
        check.at("by").error(message);
    }
}

fn samples(check: &mut Checker<'_>, samples: LightSamples) {
    match samples {
        LightSamples::Count(count) => check.count("samples", count, 1, MAX_SAMPLES),
        LightSamples::Range { min, max } => {
            let mut check = check.at("samples");
            check.count("min", min, 1, MAX_SAMPLES);
            check.count("max", max, 1, MAX_SAMPLES);
            if max < min {
                check.at("max").error(format!("must be `min`, {min}, or more, found {max}"));
            }
        }
    }
}

fn kind(mut check: Checker<'_>, kind: &LightKind) {
    match kind {
        LightKind::Point(point) => check.point("position", point.position),
        LightKind::Directional(light) => {
            check.direction("direction", light.direction);
        }
        LightKind::Rectangle(rectangle) => {
            check.point("corner", rectangle.corner);
            let has_u = check.direction("edge_u", rectangle.edge_u);
            let has_v = check.direction("edge_v", rectangle.edge_v);
            if has_u && has_v && are_parallel(rectangle.edge_u, rectangle.edge_v) {
                check.error("the edges must not be parallel".to_string());
            }
        }
        LightKind::Disk(disk) => {
            check.point("center", disk.center);
            check.direction("normal", disk.normal);
            check.positive("radius", disk.radius);
        }
        LightKind::Sphere(sphere) => {
            check.point("center", sphere.center);
            check.positive("radius", sphere.radius);
        }
    }
}
