//! The two bounces: the mirrored and the refracted ray (Ramos, section 1.2.2).

use super::follow::Bounce;
use super::layer_stack::LayerStack;
use super::unseen::dead_channels;
use super::zones::{self, Lobe};
use super::{Meeting, Path, in_range};
use crate::geometry::Ray;
use crate::geometry::doubled::{Doubled, Doubled3};
use crate::log::{Decision, Name, RayKind, SkipReason, Term};
use crate::probe::{Probe, Saving};
use crate::scene::ceiling::rounded_up;
use crate::scene::{Color, Formulas, Scene};
use glam::DVec3;

/// The colour of the reflected ray; nothing where there is none.
// A surface without such a ray doesn't pay for a call.
#[inline(always)]
pub(super) fn reflected<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Color {
    if meeting.material.reflects() { mirrored(scene, meeting, probe) } else { Color::ZERO }
}

#[inline(never)]
fn mirrored<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Color {
    let material = meeting.material;
    let weight = scene.tracing.scale_of_reflected(meeting.weights.reflected, material);
    if is_left_out(scene, meeting, Term::Reflected, weight, probe) {
        return Color::ZERO;
    }
    let Some(direction) = mirror(scene, meeting, probe) else { return Color::ZERO };
    let direction = above(meeting, direction, Term::Reflected, probe);
    // Made where it is used, so that a sharp bounce stays in registers.
    let place = meeting.place.and_then(LayerStack::turned_back);
    let leaving = meeting.leaving_here();
    let bounce =
        || Bounce { kind: RayKind::Reflected, leaving, weight, media: meeting.path.media, place: place.as_deref() };
    if let Some(exponent) = material.gloss_exponent {
        let lobe = Lobe { what: Term::Reflected, middle: direction, exponent };
        return zones::mean(scene, meeting, &lobe, &bounce(), probe);
    }
    bounce().follow(scene, meeting, direction, 0, probe)
}

/// The colour of the transmitted ray; nothing where there is none, as at a total internal reflection.
#[inline(always)]
pub(super) fn transmitted<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Color {
    if meeting.material.transmits() { refracted(scene, meeting, probe) } else { Color::ZERO }
}

#[inline(never)]
fn refracted<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Color {
    let material = meeting.material;
    let weight = meeting.weights.transmitted;
    if is_left_out(scene, meeting, Term::Transmitted, weight, probe) {
        return Color::ZERO;
    }
    let inside = meeting.path.media;
    let interface = meeting.interface(scene);
    let eta = [inside.ior(), inside.ior_beyond(interface, scene)];
    let formulas = scene.tracing.formulas;
    let Some(direction) = refract(meeting.ray, meeting.surface.normal, eta, formulas, probe) else {
        return Color::ZERO;
    };
    let direction = above(meeting, direction, Term::Transmitted, probe);
    let beyond = inside.beyond(interface, scene);
    let place = meeting.place.and_then(|place| place.beyond_interface(scene));
    let leaving = meeting.leaving_beyond();
    let bounce = || Bounce { kind: RayKind::Transmitted, leaving, weight, media: &beyond, place: place.as_deref() };
    if let Some(exponent) = material.translucency_exponent {
        let lobe = Lobe { what: Term::Transmitted, middle: direction, exponent };
        return zones::mean(scene, meeting, &lobe, &bounce(), probe);
    }
    bounce().follow(scene, meeting, direction, 0, probe)
}

/// The direction of a bounce, on its own side of the surface. One by an interpolated normal may run on the other side; the nearest
/// direction that doesn't is its projection onto the surface's own plane (Keller et al., "The Iray light transport simulation and rendering
/// system", 2017, section A.3, bend reflections up in the same way).
#[inline(always)]
fn above<P: Probe>(meeting: &Meeting, direction: DVec3, what: Term, probe: &mut P) -> DVec3 {
    let is_meant_here = what == Term::Reflected;
    if meeting.leaks(direction, is_meant_here) { bent(meeting, direction, what, probe) } else { direction }
}

#[cold]
#[inline(never)]
fn bent<P: Probe>(meeting: &Meeting, direction: DVec3, what: Term, probe: &mut P) -> DVec3 {
    let normal = meeting.surface.geometric_normal();
    let along = direction - normal * probe.dot(direction, normal);
    let length = along.dot(along).sqrt();
    // Straight down there is no nearest direction.
    let along = if length > 0.0 { along / length } else { normal.any_orthonormal_vector() };
    probe.mark(Decision::Bent { what });
    let name = if what == Term::Reflected { Name::ReflectDirectionBent } else { Name::RefractDirectionBent };
    probe.note(name, along)
}

/// R = d − 2N(d·N), normalised again with the formulas of the notes only: reflecting keeps the length.
fn mirror<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Option<DVec3> {
    let (direction, normal) = (meeting.ray.direction, meeting.surface.normal);
    let mirrored = direction - normal * 2.0 * probe.dot(direction, normal);
    let (name, mirrored) = match scene.tracing.formulas {
        Formulas::Robust => (Name::ReflectDirection, mirrored),
        Formulas::Notes => (Name::ReflectDirectionNormalized, normalized(mirrored)),
    };
    let mirrored = probe.note(name, mirrored);
    unless_lost(mirrored, name, probe)
}

/// v/|v|, as on paper; zero stays zero.
fn normalized(vector: DVec3) -> DVec3 {
    let length = vector.dot(vector).sqrt();
    if length > 0.0 { vector / length } else { DVec3::ZERO }
}

/// The direction of a bounce; `None`, marked, where nothing is left of it: in arithmetics with few digits, and at a quotient of
/// refractive indices beyond those of f64.
fn unless_lost<P: Probe>(direction: DVec3, name: Name, probe: &mut P) -> Option<DVec3> {
    if direction != DVec3::ZERO {
        return Some(direction);
    }
    probe.mark(Decision::Undefined { quantity: name });
    None
}

/// T = d/η − (cosφ₂ − cosφ₁/η)N with η = η₂/η₁ (Snell), normalised again with the formulas of the notes only; `None`, marked, at a total
/// internal reflection and where nothing is left of it.
pub(crate) fn refract<P: Probe>(
    ray: &Ray,
    normal: DVec3,
    [eta_1, eta_2]: [f64; 2],
    formulas: Formulas,
    probe: &mut P,
) -> Option<DVec3> {
    probe.given(Name::RefractEta1, eta_1);
    probe.given(Name::RefractEta2, eta_2);
    let eta = probe.note(Name::RefractEta, eta_2 / eta_1);
    if eta == 0.0 {
        probe.mark(Decision::Undefined { quantity: Name::RefractDirection });
        return None;
    }
    let cos_1 = probe.note(Name::RefractCos1, -probe.dot(normal, ray.direction));
    let TransmittedCosine { cos_2, .. } = match formulas {
        Formulas::Robust => transmitted_cosine(ray, normal, eta, cos_1, probe),
        Formulas::Notes => printed_cosine(eta, cos_1, probe),
    };
    let Some(cos_2) = cos_2 else {
        probe.mark(Decision::TotalInternalReflection);
        return None;
    };
    let refracted = ray.direction / eta - normal * (cos_2 - cos_1 / eta);
    let (name, refracted) = match formulas {
        Formulas::Robust => (Name::RefractDirection, refracted),
        Formulas::Notes => (Name::RefractDirectionNormalized, normalized(refracted)),
    };
    let refracted = probe.note(name, refracted);
    unless_lost(refracted, name, probe)
}

/// The transmitted ray's angle by Snell's law.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TransmittedCosine {
    /// cos φ₂; `None` where there is no transmitted ray.
    pub cos_2: Option<f64>,
    /// Its square, which is negative then.
    pub squared: f64,
}

/// cos²φ₂ = (η² − sin²φ₁)/η².
///
/// The usual k = 1 − (1 − cos²φ₁)/η² cancels; here sin²φ₁ is the squared length of the direction's tangential part.
pub(crate) fn transmitted_cosine<P: Probe>(
    ray: &Ray,
    normal: DVec3,
    eta: f64,
    cos_1: f64,
    probe: &mut P,
) -> TransmittedCosine {
    let tangential = ray.direction + normal * cos_1;
    let k_eta_squared = eta * eta - tangential.dot(tangential);
    let left = k_eta_squared / (eta * eta);
    let is_certainly_total = left < -TOTAL;
    let is_certain = is_certainly_total || left > CANCELLED;
    if probe.certifies() && !(is_certain && eta >= LEAST_ETA) {
        return doubled_cosine(ray, normal, eta, probe);
    }
    let is_total = k_eta_squared < 0.0;
    let cos_2 = (!is_total).then(|| probe.note(Name::RefractCos2, k_eta_squared.sqrt() / eta));
    TransmittedCosine { cos_2, squared: left }
}

/// cos²φ₂ = 1 − (1 − cos²φ₁)/η², as the notes print it. Near a total reflection the difference cancels, so that it shows the
/// rounding of cosφ₁ enlarged.
pub(crate) fn printed_cosine<P: Probe>(eta: f64, cos_1: f64, probe: &mut P) -> TransmittedCosine {
    let squared = 1.0 - (1.0 - cos_1 * cos_1) / (eta * eta);
    let cos_2 = (squared >= 0.0).then(|| probe.note(Name::RefractCos2Printed, squared.sqrt()));
    TransmittedCosine { cos_2, squared }
}

/// The least part of η² that may be left of η² − sin²φ₁. The tangential part errs by at most six roundings in each component
/// (cos φ₁ by four, those of the direction and the normal among them, and two of its own), so that near sin φ₁ = η the difference errs
/// by 2·6·√3·η + 5·η² of them: its sign is right far below this. But T shows the error of cos φ₂, which grows as less is left.
const CANCELLED: f64 = 1.0 / 16.0;

/// Where more than this part of η² is missing, the reflection is total: it is far more than the errors of the difference, and nothing
/// else is asked.
const TOTAL: f64 = 1.0 / (1 << 20) as f64;

/// Where η is less, the roundings of the tangential part come near to it.
const LEAST_ETA: f64 = 1.0 / (1 << 20) as f64;

/// The same with twice the digits: sin²φ₁ = |v × N|²/(v·v · N·N), whatever the lengths of both.
#[cold]
#[inline(never)]
fn doubled_cosine<P: Probe>(ray: &Ray, normal: DVec3, eta: f64, probe: &mut P) -> TransmittedCosine {
    probe.fallback();
    let lengths_squared = Doubled3::from(ray.vector).squared() * Doubled3::from(normal).squared();
    let whole = Doubled::product(eta, eta) * lengths_squared;
    let squared = (whole - Doubled3::across(ray.vector, normal).squared()).quotient(whole);
    let is_total = squared < 0.0;
    let cos_2 = (!is_total).then(|| probe.note(Name::RefractCos2Doubled, squared.sqrt()));
    TransmittedCosine { cos_2, squared }
}

/// Whether a bounce isn't traced: because of the depth limit, or because it can't be seen.
fn is_left_out<P: Probe>(scene: &Scene, meeting: &Meeting, what: Term, weight: Color, probe: &mut P) -> bool {
    let material = meeting.material;
    let tracing = &scene.tracing;
    let lobe = if what == Term::Reflected { material.gloss_exponent } else { material.translucency_exponent };
    let rays = if lobe.is_some() { u64::from(material.zones) } else { 1 };
    if !tracing.goes_deeper(meeting.path.level) {
        probe.rays_saved(Saving::DepthLimit, rays);
        probe.mark(Decision::DepthLimit { what });
        return true;
    }
    // A cutoff of 0 is none.
    let product = meeting.path.weight * weight;
    let is_below_cutoff = tracing.cutoff > 0.0 && product.cmplt(Color::splat(tracing.cutoff)).all();
    let why = if weight == Color::ZERO && tracing.skip.has(SkipReason::ZeroWeight) {
        SkipReason::ZeroWeight
    } else if product == Color::ZERO && is_zero_path(scene, meeting.path, weight) {
        SkipReason::ZeroPath
    } else if is_below_cutoff && tracing.skip.has(SkipReason::Cutoff) {
        SkipReason::Cutoff
    } else {
        return false;
    };
    if why == SkipReason::Cutoff {
        give_loss(scene, meeting.path, weight, probe);
    }
    probe.rays_saved(Saving::Skipped(why), rays);
    probe.mark(Decision::Skipped { what, why });
    true
}

/// Whether the rule of that name leaves out a bounce with this weight.
#[cold]
fn is_zero_path(scene: &Scene, path: &Path, weight: Color) -> bool {
    weight != Color::ZERO && scene.tracing.skip.has(SkipReason::ZeroPath) && dead_channels(path, weight).all()
}

/// What a bounce with this weight could at most add to the colour of its sample, for the log and the statistics; nothing where
/// there is no bound.
#[cold]
fn give_loss<P: Probe>(scene: &Scene, path: &Path, weight: Color, probe: &mut P) {
    let Some(ceiling) = scene.ceilings.of_level(path.level + 1) else { return };
    // A product that became too small for a number is at least seen not to be zero.
    let product = (path.weight * weight).max(Color::splat(f64::MIN_POSITIVE));
    let product = Color::select(dead_channels(path, weight), Color::ZERO, product);
    probe.given(Name::CutoffLoss, rounded_up(in_range(product * ceiling)));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_length_is_not_normalized() {
        assert_eq!(normalized(DVec3::ZERO), DVec3::ZERO);
        assert_eq!(normalized(DVec3::new(3.0, 0.0, -4.0)), DVec3::new(0.6, 0.0, -0.8));
    }
}
