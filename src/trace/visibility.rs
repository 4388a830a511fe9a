//! What a ray meets first, and how much light gets through.

use super::in_range;
use crate::geometry::{Crossing, Ray};
use crate::log::{Decision, SkipReason, Skippable};
use crate::probe::Probe;
use crate::scene::{Color, Scene, Shadows};
use std::cmp::Ordering;

/// The nearest thing on a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The object.
    pub object: u32,
    /// Where the ray crosses its surface.
    pub crossing: Crossing,
}

/// Two distances nearer to each other than so many parts of them are compared with more digits.
const NEAR_TIE: f64 = 8.0 * f64::EPSILON;

/// Two distances with twice the digits that differ by no more than this part of them are the same: that much is their own error where
/// half of their digits were lost.
const SAME: f64 = f64::EPSILON * f64::EPSILON * (1 << 24) as f64;

/// How two crossings with objects follow each other along the ray; at the same distance the object that comes first in the
/// scene is the first.
fn order<P: Probe>(scene: &Scene, ray: &Ray, one: Hit, other: Hit, probe: &mut P) -> Ordering {
    let (t, other_t) = (one.crossing.t, other.crossing.t);
    let is_near_tie = (t - other_t).abs() <= NEAR_TIE * t.abs() && one.object != other.object;
    let by_distance = if is_near_tie && probe.certifies() {
        let refined = |hit: Hit| scene.objects[hit.object as usize].shape.refined(ray, hit.crossing);
        let difference = (refined(one) - refined(other)).head;
        if difference.abs() <= SAME * t.abs() { Ordering::Equal } else { difference.total_cmp(&0.0) }
    } else {
        t.total_cmp(&other_t)
    };
    by_distance.then(one.object.cmp(&other.object))
}

/// All crossings with all objects, in the order of the ray.
pub(crate) fn all_crossings<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Vec<Hit> {
    let mut hits = Vec::new();
    let mut crossings = Vec::new();
    scene.index.in_any_order(ray, probe, |object, probe| {
        let thing = &scene.objects[object as usize];
        thing.shape.all_crossings(object, thing.one_sided, ray, &mut crossings, probe);
        hits.extend(crossings.drain(..).map(|crossing| Hit { object, crossing }));
        ray.t_max
    });
    hits.sort_by(|one, other| order(scene, ray, *one, *other, probe));
    hits
}

/// The nearest hit. Of several at the same distance the object that comes first in the scene wins.
// A part of the recursion, which would have to take the hit out of memory.
#[inline(always)]
pub fn closest_hit<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    scene.index.nearest_first(
        ray,
        probe,
        #[inline(always)]
        |object, probe| {
            let thing = &scene.objects[object as usize];
            if let Some(crossing) = thing.shape.first_crossing(object, thing.one_sided, ray, probe)
                && nearest.is_none_or(|hit| order(scene, ray, Hit { object, crossing }, hit, probe).is_lt())
            {
                nearest = Some(Hit { object, crossing });
            }
            nearest.map_or(ray.t_max, |hit| hit.crossing.t)
        },
    );
    if let Some(hit) = nearest {
        probe.mark(Decision::Nearest { object: hit.object });
    }
    nearest
}

/// Whether the ray meets anything at all.
pub fn is_any_hit<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> bool {
    let mut is_hit = false;
    let ray = &ray.without_distance();
    scene.index.in_any_order(ray, probe, |object, probe| {
        let thing = &scene.objects[object as usize];
        is_hit |= thing.shape.is_crossed(object, thing.one_sided, ray, probe);
        if is_hit { -1.0 } else { ray.t_max }
    });
    is_hit
}

/// The part of the light that gets along a shadow ray: the product of what every crossed surface transmits, in a
/// straight line; zero as soon as an opaque one is crossed (Ramos, section 1.2.5).
pub fn transmittance<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Color {
    transmittance_among(scene, ray, None, probe)
}

/// The same where all objects that the ray can meet are known.
#[inline(always)]
pub(super) fn transmittance_among<P: Probe>(scene: &Scene, ray: &Ray, among: Option<&[u32]>, probe: &mut P) -> Color {
    if among.is_some_and(<[u32]>::is_empty) { Color::ONE } else { searched(scene, ray, among, probe) }
}

// Kept out of the shading around it, whose values would crowd this loop's out of the registers.
#[inline(never)]
fn searched<P: Probe>(scene: &Scene, ray: &Ray, among: Option<&[u32]>, probe: &mut P) -> Color {
    let stops_when_blocked = scene.tracing.skip.has(SkipReason::Blocked);
    let lets_light_pass = scene.tracing.shadows == Shadows::PerSurface;
    let mut crossed: Vec<(f64, u32)> = Vec::new();
    let mut crossings: Vec<Crossing> = Vec::new();
    let mut is_blocked = false;
    let mut meet = |object: u32, probe: &mut P| {
        let thing = &scene.objects[object as usize];
        if lets_light_pass && scene.materials[thing.material].transmits() {
            thing.shape.all_crossings(object, thing.one_sided, ray, &mut crossings, probe);
            crossed.extend(crossings.drain(..).map(|crossing| (crossing.t, object)));
        } else if thing.shape.is_crossed(object, thing.one_sided, ray, probe) {
            if !is_blocked {
                probe.mark(Decision::Occluded { object });
            }
            is_blocked = true;
        }
        if is_blocked && stops_when_blocked {
            probe.mark(Decision::Skipped { what: Skippable::Shadow, why: SkipReason::Blocked });
            return -1.0;
        }
        ray.t_max
    };
    match among {
        None => scene.index.in_any_order(ray, probe, meet),
        Some(objects) => {
            // One that blocks the ray ends the search.
            let _ = objects.iter().any(|object| meet(*object, probe) < 0.0);
        }
    }
    if is_blocked { Color::ZERO } else { attenuation(scene, crossed, probe) }
}

/// The product over the crossed surfaces, in the order of the ray, so that it has the same bits however they were found.
fn attenuation<P: Probe>(scene: &Scene, mut crossed: Vec<(f64, u32)>, probe: &mut P) -> Color {
    crossed.sort_by(|(t, object), (other_t, other)| t.total_cmp(other_t).then(object.cmp(other)));
    let mut part = Color::ONE;
    for (_, object) in crossed {
        let factor = scene.material_of(object).weights.transmitted;
        probe.mark(Decision::Attenuated { object, factor: factor.to_array() });
        // Not infinite, so that a surface behind that lets nothing through still does so.
        part = (part * factor).min(Color::MAX);
        if part == Color::ZERO {
            // Filters of different colours let nothing through together.
            probe.mark(Decision::Occluded { object });
            break;
        }
    }
    in_range(part)
}
