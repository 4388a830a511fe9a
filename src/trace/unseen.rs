//! Light that can't be seen: whether zeros among the factors of a local model leave nothing of it in any channel.
//!
//! What a light adds to a pixel is a product in each channel: the weights on the path, W_l, I_i, and K_d and K_e, or K_t for a light on the
//! other side. The *factors* are asked, not their product, which may be too small for a number although a bright light would leave
//! something of it. A product above zero is proof enough that no factor is zero, and in most scenes that of the first channel is enough.

use super::{Meeting, Path};
use crate::log::SkipReason;
use crate::scene::{Color, LightKind, Material, Scene};
use glam::BVec3;

/// The rule by which the local model is left out, if one does.
#[inline(always)]
pub(super) fn local_model(scene: &Scene, meeting: &Meeting) -> Option<SkipReason> {
    let (path, local) = (&meeting.path.weight, &meeting.weights.local);
    let is_alive = path.x * local.x > 0.0 || path.y * local.y > 0.0 || path.z * local.z > 0.0;
    if is_alive { None } else { why_no_local_model(scene, meeting) }
}

#[cold]
#[inline(never)]
fn why_no_local_model(scene: &Scene, meeting: &Meeting) -> Option<SkipReason> {
    let local = meeting.weights.local;
    let why = if local == Color::ZERO {
        SkipReason::ZeroLocal
    } else if dead_channels(meeting.path, local).all() {
        SkipReason::ZeroPathLocal
    } else {
        return None;
    };
    scene.tracing.skip.has(why).then_some(why)
}

/// The rule by which the shadow ray to a light of this colour on this side of the surface is left out, if one does.
#[inline(always)]
pub(super) fn light(scene: &Scene, meeting: &Meeting, color: &Color, is_in_front: bool) -> Option<SkipReason> {
    let material = meeting.material;
    let Material { diffuse, specular, transmission, .. } = material;
    let (path, local) = (&meeting.path.weight, &meeting.weights.local);
    let is_alive = match is_in_front {
        true => {
            path.x * local.x * (color.x * (diffuse.x + specular.x)) > 0.0
                || path.y * local.y * (color.y * (diffuse.y + specular.y)) > 0.0
                || path.z * local.z * (color.z * (diffuse.z + specular.z)) > 0.0
        }
        false => (*path * *local * *color * *transmission).cmpgt(Color::ZERO).any(),
    };
    if is_alive { None } else { why_no_light(scene, meeting, *color, is_in_front) }
}

#[cold]
#[inline(never)]
fn why_no_light(scene: &Scene, meeting: &Meeting, color: Color, is_in_front: bool) -> Option<SkipReason> {
    let material = meeting.material;
    // Neither is negative, so that their sum is zero where both are.
    let used = if is_in_front { material.diffuse + material.specular } else { material.transmission };
    let dead = color.cmpeq(Color::ZERO) | used.cmpeq(Color::ZERO);
    let why = if used == Color::ZERO {
        SkipReason::NoLocalTerm
    } else if dead.all() {
        SkipReason::ZeroLight
    } else if (dead | dead_channels(meeting.path, meeting.weights.local)).all() {
        SkipReason::ZeroPathLight
    } else {
        return None;
    };
    scene.tracing.skip.has(why).then_some(why)
}

/// How many shadow rays the local model has at most: lights behind the surface get none.
pub(super) fn shadow_rays(scene: &Scene, meeting: &Meeting) -> u64 {
    if scene.tracing.shades_ambient_only(meeting.path.level) {
        return 0;
    }
    let points = |kind: &LightKind| if let LightKind::Area(area) = kind { area.samples.into() } else { 1 };
    scene.lights.iter().map(|light| points(&light.kind)).sum()
}

/// The channels in which some weight on a path, or the next one, is zero. The product of the weights isn't enough: it may have become
/// too small for a number, while a light is so bright that something would be left of it.
pub(super) fn dead_channels(path: &Path, weight: Color) -> BVec3 {
    let bounces = std::iter::successors(path.via.as_ref(), |via| via.path.via.as_ref());
    bounces.fold(weight.cmpeq(Color::ZERO), |dead, via| dead | via.weight.cmpeq(Color::ZERO))
}
