//! What a ray meets first, and how much light gets through.

use crate::geometry::{Crossing, Ray};
use crate::log::{Decision, SkipReason, Skippable};
use crate::probe::Probe;
use crate::scene::{Color, Scene};

/// The nearest thing on a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The object.
    pub object: u32,
    /// The triangle, for a mesh; else 0.
    pub primitive: u32,
    /// Where the ray crosses its surface.
    pub crossing: Crossing,
}

/// The nearest hit. Of several at the same distance the object that comes first in the scene wins.
pub fn closest_hit<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (object, thing) in (0..).zip(&scene.objects) {
        if let Some(crossing) = thing.shape.first_crossing(object, ray, probe)
            && nearest.is_none_or(|hit| crossing.t < hit.crossing.t)
        {
            nearest = Some(Hit { object, primitive: 0, crossing });
        }
    }
    if let Some(hit) = nearest {
        probe.mark(Decision::Nearest { object: hit.object });
    }
    nearest
}

/// The part of the light that gets along a shadow ray: the product of what every crossed surface transmits, in a
/// straight line; zero as soon as an opaque one is crossed (Ramos, section 1.2.5).
// Kept out of the shading around it, whose values would crowd this loop's out of the registers.
#[inline(never)]
pub fn transmittance<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Color {
    let stops_when_blocked = scene.tracing.skip.has(SkipReason::Blocked);
    let mut crossed: Vec<(f64, u32)> = Vec::new();
    let mut is_blocked = false;
    for (object, thing) in (0..).zip(&scene.objects) {
        if scene.materials[thing.material].transmits() {
            let crossings = thing.shape.all_crossings(object, ray, probe);
            crossed.extend(crossings.into_iter().flatten().map(|crossing| (crossing.t, object)));
        } else if thing.shape.first_crossing(object, ray, probe).is_some() {
            if !is_blocked {
                probe.mark(Decision::Occluded { object });
            }
            is_blocked = true;
            if stops_when_blocked {
                probe.mark(Decision::Skipped { what: Skippable::Shadow, why: SkipReason::Blocked });
                break;
            }
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
        part *= factor;
        if part == Color::ZERO {
            // Filters of different colours let nothing through together.
            probe.mark(Decision::Occluded { object });
            break;
        }
    }
    part
}
