//! What one light, or one point of it, adds to the local model: its shadow ray, and the diffuse, specular and transmitted light (Ramos,
//! section 1.2.1).

use super::visibility::{Obstacles, transmittance_among};
use super::{Meeting, unseen};
use crate::geometry::Ray;
use crate::log::plane::Emitter;
use crate::log::{Decision, Name, RayKind, SkipReason, Step, Term};
use crate::probe::{Probe, Saving};
use crate::scene::{Arrival, Color, Formulas, Light, Material, Scene, Specular};
use glam::DVec3;

/// A light, or a point of one.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    pub light: &'a Light,
    /// The light's number.
    pub number: u32,
    /// Of several points of an area light, the number from 1; 0 if there is one.
    pub split: u32,
    /// Its intensity, I_i.
    pub color: &'a Color,
    /// The objects that can block it, where that is known before the search for them.
    pub among: Option<&'a [u32]>,
    /// Whether it is known that nothing blocks it: no shadow ray is traced.
    pub is_free: bool,
}

/// The contribution of a light; nothing if it is at the surface point.
// Without the attribute, whether the compiler inlines it depends on the rest of the program.
#[inline(always)]
pub(super) fn from_light<P: Probe>(
    scene: &Scene,
    meeting: &Meeting,
    view: DVec3,
    source: &Source,
    arrival: Option<Arrival>,
    probe: &mut P,
) -> Color {
    let material = meeting.material;
    let normal = meeting.surface.normal;
    let Some(arrival) = arrival else { return Color::ZERO };
    let n_dot_l = probe.note(Name::ShadeNDotL, probe.dot(normal, arrival.direction));

    let is_in_front = n_dot_l > 0.0;
    let is_behind = n_dot_l < 0.0;
    let is_used = is_in_front || (is_behind && material.uses_light_behind());
    if !is_used {
        // The algorithm itself sends no shadow ray there, whatever rules are in force.
        return without_shadow_ray(SkipReason::Behind, probe);
    }
    if let Some(why) = unseen::light(scene, meeting, source.color, is_in_front) {
        return without_shadow_ray(why, probe);
    }
    let passed =
        if source.is_free { Color::ONE } else { shadow_ray(scene, meeting, source, &arrival, is_in_front, probe) };
    if passed == Color::ZERO {
        return Color::ZERO;
    }
    let directions = Directions { normal, view, light: arrival.direction };
    let arriving = source.light.faded(source.color, arrival.distance, probe) * passed;
    let reflectance = if is_in_front {
        let diffuse = material.diffuse * cosine(n_dot_l);
        let specular = specular(scene, material, &directions, n_dot_l, probe);
        show_parts(source, arriving, [diffuse, specular], probe);
        diffuse + specular
    } else {
        let transmitted = transmission(scene, meeting, &directions, probe);
        show_parts(source, arriving, [Color::ZERO, transmitted], probe);
        transmitted
    };
    arriving * reflectance
}

/// Shows a probe that wants to see it what of a light is scattered diffusely, and what is not.
#[inline(always)]
fn show_parts<P: Probe>(source: &Source, arriving: Color, reflectances: [Color; 2], probe: &mut P) {
    if !probe.sees_parts() {
        return;
    }
    for (is_diffuse, reflectance) in [true, false].into_iter().zip(reflectances) {
        probe.part(Emitter::Light { light: source.number, is_diffuse }, arriving * reflectance);
    }
}

/// The contribution of a light without a shadow ray, by this rule: nothing.
fn without_shadow_ray<P: Probe>(why: SkipReason, probe: &mut P) -> Color {
    probe.rays_saved(Saving::Skipped(why), 1);
    probe.mark(Decision::Skipped { what: Term::Shadow, why });
    Color::ZERO
}

/// The part of a light's intensity that reaches the surface point: nothing, if the light is on that side of the surface
/// only by an interpolated normal.
#[inline(always)]
fn shadow_ray<P: Probe>(
    scene: &Scene,
    meeting: &Meeting,
    source: &Source,
    arrival: &Arrival,
    is_in_front: bool,
    probe: &mut P,
) -> Color {
    let leaving = if is_in_front { meeting.leaving_here() } else { meeting.leaving_beyond() };
    let touched = match meeting.place {
        None => &[],
        Some(place) if is_in_front => &*place.crossed,
        Some(place) => place.ahead.get(1..).unwrap_or_default(),
    };
    let time = meeting.ray.time;
    let ray =
        Ray { leaving: Some(leaving), slack: meeting.slack, time, ..segment_to_light(meeting.surface.point, arrival) };
    let step =
        Step::Ray { kind: RayKind::Shadow { light: source.number }, depth: meeting.path.level, split: source.split };
    give_ray(&ray, probe);
    let obstacles = Obstacles { among: source.among, touched };
    let passed = probe.within(step, |probe| transmittance_among(scene, &ray, &obstacles, probe));
    let passed = if meeting.leaks(arrival.direction, is_in_front) {
        probe.mark(Decision::LeakGuard { what: Term::Shadow });
        Color::ZERO
    } else {
        passed
    };
    if passed == Color::ONE { passed } else { probe.note(Name::ShadowTransmittance, passed) }
}

/// The ray from a point up to a light. How far away its blockers are doesn't matter, only their order.
pub(crate) fn segment_to_light(point: DVec3, arrival: &Arrival) -> Ray {
    Ray { t_max: arrival.distance, wants_distance: false, ..Ray::new(point, arrival.direction) }
}

/// The directions of the local model, of unit length.
struct Directions {
    normal: DVec3,
    view: DVec3,
    light: DVec3,
}

/// K_e ((N·H)⁺)^n_e, or K_e ((R·V)⁺)^n_e.
fn specular<P: Probe>(
    scene: &Scene,
    material: &Material,
    &Directions { normal, view, light }: &Directions,
    n_dot_l: f64,
    probe: &mut P,
) -> Color {
    // All that is added up here is at least +0, and so adding zero changes no bit.
    if material.specular == Color::ZERO && scene.tracing.skip.has(SkipReason::ZeroTerm) {
        probe.mark(Decision::Skipped { what: Term::Specular, why: SkipReason::ZeroTerm });
        return Color::ZERO;
    }
    let lobe = match scene.tracing.specular {
        Specular::HalfVector | Specular::HalfVectorCompensated => {
            let sum = probe.note(Name::HalfSum, light + view);
            let length = probe.note(Name::HalfLength, probe.dot(sum, sum).sqrt());
            if length == 0.0 {
                // The light is exactly behind the viewer's back: along the surface there is no half vector.
                return Color::ZERO;
            }
            let half = probe.note(Name::HalfDirection, sum / length);
            let names = match scene.tracing.specular {
                Specular::HalfVectorCompensated => {
                    [Name::ShadeSpecularPowerCompensated, Name::ShadeSpecularPowerCompensatedSine]
                }
                _ => [Name::ShadeSpecularPower, Name::ShadeSpecularPowerSine],
            };
            Lobe { cosine: probe.note(Name::ShadeNDotH, probe.dot(normal, half)), between: [half, normal], names }
        }
        Specular::ReflectionVector => {
            let mirrored = probe.note(Name::MirrorDirection, normal * 2.0 * n_dot_l - light);
            let names = [Name::ShadeSpecularPowerMirror, Name::ShadeSpecularPowerMirrorSine];
            let cosine = probe.note(Name::ShadeRDotV, probe.dot(mirrored, view));
            Lobe { cosine, between: [mirrored, view], names }
        }
    };
    let exponent = scene.tracing.specular.exponent(material.shininess);
    let is_sharp = scene.tracing.specular.is_sharp(material);
    material.specular * lobe.height(is_sharp, exponent, probe)
}

/// K_t ((−N·H′)⁺)^n_t with H′ = (−L − ηV)/(η − 1), normalised; the light's side is medium 1, the viewer's medium 2.
///
/// The robust formulas write the sum as −(L + V)/(η − 1) − V, which keeps its digits where η is near 1. The source text prints a second form,
/// (V − η′·L′)/(η′ − 1). With the incident direction L′ = −L and η′ = η₁/η₂ = 1/η it is the same vector: numerator and denominator times −η.
fn transmission<P: Probe>(
    scene: &Scene,
    meeting: &Meeting,
    &Directions { normal, view, light }: &Directions,
    probe: &mut P,
) -> Color {
    let material = meeting.material;
    let media = meeting.path.media;
    let exponent = material.transmission_exponent;
    let is_sharp = scene.tracing.specular.is_sharp(material);
    let eta_light = media.ior_beyond(meeting.interface(scene), scene);
    probe.given(Name::RefractEta1, eta_light);
    probe.given(Name::RefractEta2, media.ior());
    let eta = probe.note(Name::TransmitEta, media.ior() / eta_light);
    if eta == 1.0 {
        // No interface: the lobe has narrowed to the straight line, where it keeps its height.
        if view != -light {
            return Color::ZERO;
        }
        let cosine = probe.note(Name::ShadeNDotTransmittedStraight, 1.0);
        let height = if is_sharp {
            probe.note(Name::ShadeTransmittedPower, power(cosine, exponent))
        } else {
            power(cosine, exponent)
        };
        return material.transmission * height;
    }
    let Some(half) = transmitted_half(light, view, eta, scene.tracing.formulas, probe) else { return Color::ZERO };
    let cosine = probe.note(Name::ShadeNDotTransmitted, -probe.dot(normal, half));
    let names = [Name::ShadeTransmittedPower, Name::ShadeTransmittedPowerSine];
    let lobe = Lobe { cosine, between: [-normal, half], names };
    material.transmission * lobe.height(is_sharp, exponent, probe)
}

/// A power of the cosine between two vectors.
struct Lobe {
    cosine: f64,
    between: [DVec3; 2],
    /// The quantity of a sharp lobe's height, from the cosine and from the sine.
    names: [Name; 2],
}

impl Lobe {
    /// The height, (cos⁺)^n. A sharp lobe's is a quantity of its own.
    #[inline(always)]
    fn height<P: Probe>(&self, is_sharp: bool, exponent: f64, probe: &mut P) -> f64 {
        let Lobe { cosine, between: [a, b], names: [of_cosine, of_sine] } = *self;
        match is_sharp {
            false => power(cosine, exponent),
            true if probe.certifies() && cosine > 0.0 => probe.note(of_sine, power_between(a, b, exponent)),
            true => probe.note(of_cosine, power(cosine, exponent)),
        }
    }
}

/// H′ from the two directions and η ≠ 1; `None` where it has no direction.
pub(crate) fn transmitted_half<P: Probe>(
    light: DVec3,
    view: DVec3,
    eta: f64,
    formulas: Formulas,
    probe: &mut P,
) -> Option<DVec3> {
    let (name, sum) = match formulas {
        Formulas::Robust => (Name::TransmitSum, -(light + view) / (eta - 1.0) - view),
        Formulas::Notes => (Name::TransmitSumPrinted, (-light - view * eta) / (eta - 1.0)),
    };
    let sum = probe.note(name, sum);
    let length = probe.note(Name::TransmitLength, probe.dot(sum, sum).sqrt());
    (length != 0.0).then(|| probe.note(Name::TransmitDirection, sum / length))
}

/// (x⁺)^n, the height of a lobe.
pub(crate) fn power(x: f64, exponent: f64) -> f64 {
    libm::pow(cosine(x), exponent)
}

/// ((a·b)⁺)^n for two unit vectors, (1 − sin²)^(n/2).
///
/// Near 1 the product has lost the angle: its rounding errors are n times as large in the power. The sine hasn't, because
/// b − a is exact where the two are near each other.
pub(crate) fn power_between(a: DVec3, b: DVec3, exponent: f64) -> f64 {
    if a.dot(b) <= 0.0 {
        return power(0.0, exponent);
    }
    let across = a.cross(b - a);
    let sine_squared = across.dot(across) / (a.dot(a) * b.dot(b));
    libm::exp(exponent / 2.0 * libm::log1p(-sine_squared.min(1.0)))
}

/// x⁺: a dot product of unit vectors, clamped to a cosine. Rounding can take it past 1, and a large exponent from there
/// to anywhere.
fn cosine(x: f64) -> f64 {
    x.clamp(0.0, 1.0)
}

/// Origin and direction of a ray that other quantities have already named.
pub(super) fn give_ray<P: Probe>(ray: &Ray, probe: &mut P) {
    probe.given(Name::RayOrigin, ray.origin);
    probe.given(Name::RayDirection, ray.direction);
}
