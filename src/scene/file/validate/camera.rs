//! The checks of `camera`.

use crate::scene::file::schema::{Aim, Camera};

use super::checker::{Checker, triple};
use super::limits::{MAX_PIXELS, MAX_SIDE};
use super::vector::are_parallel;

/// Checks the camera.
pub fn camera(mut check: Checker<'_>, camera: &Camera) {
    check.point("position", camera.position);
    let has_direction = aim(&mut check, camera);
    let has_up = check.direction("up", camera.up);
    let direction = camera.direction();
    if has_direction && has_up && are_parallel(direction, camera.up) {
        let message =
            format!("must not be parallel to the direction of view {}, found {}", triple(direction), triple(camera.up));
        check.at("up").error(message);
    }
    check.between("vertical_fov", camera.vertical_fov, 0.0, 180.0);
    resolution(check.at("resolution"), camera.resolution);
    if let Some(lens) = &camera.lens {
        let mut check = check.at("lens");
        check.not_negative("radius", lens.radius);
        check.positive("focus_distance", lens.focus_distance);
    }
    shutter(check.at("shutter"), camera.shutter);
}

/// Whether the camera looks somewhere.
fn aim(check: &mut Checker<'_>, camera: &Camera) -> bool {
    match camera.aim {
        Aim::Direction(direction) => check.direction("direction", direction),
        Aim::LookAt(point) => check.point_away("look_at", point, camera.position, "the camera's position"),
    }
}

fn resolution(mut check: Checker<'_>, [width, height]: [u32; 2]) {
    for (index, (side, pixels)) in [("width", width), ("height", height)].into_iter().enumerate() {
        if !(1..=MAX_SIDE).contains(&pixels) {
            let message = format!("the {side} must be from 1 to {MAX_SIDE} pixels, found {pixels}");
            check.at(index).error(message);
        }
    }
    let pixels = u64::from(width) * u64::from(height);
    if pixels > MAX_PIXELS && width.max(height) <= MAX_SIDE {
        check.error(format!("a picture must have at most {MAX_PIXELS} pixels, found {width} × {height} = {pixels}"));
    }
}

fn shutter(mut check: Checker<'_>, [open, close]: [f64; 2]) {
    check.finite(0, open);
    check.finite(1, close);
    if open > close {
        check.error(format!("must open before it closes, found [{open}, {close}]"));
    }
}
