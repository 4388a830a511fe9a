//! Area lights that get only as many shadow rays as they need: where nothing can lie between, a rule of quadrature without shadow rays;
//! where one object hides all of the light, a single point; else all.

use super::one_light::{Source, from_light, segment_to_light};
use super::{Meeting, unseen};
use crate::geometry::{Intersect, Leaving, Ray, Search, Shaft, Target};
use crate::log::{Asking, Decision, Name, SkipReason, Step, Term};
use crate::probe::{Probe, Saving, Silent};
use crate::random::{Dimension, Splits};
use crate::scene::By;
use crate::scene::adaptive_light::RulePoint;
use crate::scene::square::place_in_square;
use crate::scene::{Adaptive, AreaLight, Arrival, Color, Light, LightSurface, Scene, Shadows, Sight, Specular};
use glam::DVec3;

/// What can lie between a surface point and a point of a light.
#[derive(Clone, Copy)]
enum Between<'a> {
    /// Nothing.
    Nothing,
    /// Of all objects these, where they are known.
    Of(Option<&'a [u32]>),
}

/// From a surface point to a light.
struct Way<'a> {
    scene: &'a Scene,
    meeting: &'a Meeting<'a>,
    view: DVec3,
    light: &'a Light,
    area: &'a AreaLight,
    /// The light's number.
    number: u32,
}

/// The sum with what the light adds.
#[inline(never)]
pub(super) fn add<P: Probe>(
    scene: &Scene,
    meeting: &Meeting,
    view: DVec3,
    (number, light, area, adaptive): (u32, &Light, &AreaLight, &Adaptive),
    sum: Color,
    probe: &mut P,
) -> Color {
    let way = Way { scene, meeting, view, light, area, number };
    let side = on_one_side(meeting, area);
    if let Some(why) = side.as_ref().and_then(|side| way.why_left_out(side.is_in_front)) {
        light.give(probe);
        probe.within(Step::Light { light: number, split: 0 }, |probe| {
            probe.rays_saved(Saving::Skipped(why), area.samples.into());
            probe.mark(Decision::Skipped { what: Term::Shadow, why });
        });
        return sum;
    }
    // That decides what is asked, so it is the same whoever looks on.
    let index = scene.index.usual();
    let among = index.between(meeting.surface.point, area.ball(), meeting.layer.object);
    let in_shaft = side
        .as_ref()
        .and_then(|OneSide { shaft, leaving, .. }| index.in_shaft(&scene.objects, shaft, *leaving, among.as_deref()));
    let among = in_shaft.or(among);
    match (&side, among.as_deref()) {
        (Some(side), Some([])) if meeting.place.is_none() => way.in_full_view(adaptive, side.is_in_front, sum, probe),
        (_, among) => way.in_part(among, sum, probe),
    }
}

impl Way<'_> {
    /// The rule by which the light is left out as a whole, if it is all on this side of the surface.
    fn why_left_out(&self, is_in_front: bool) -> Option<SkipReason> {
        if !is_in_front && !self.meeting.material.uses_light_behind() {
            return Some(SkipReason::Behind);
        }
        unseen::light(self.scene, self.meeting, &self.light.color, is_in_front)
    }

    /// The sum with what a light adds that nothing can block.
    #[inline(always)]
    fn in_full_view<P: Probe>(&self, adaptive: &Adaptive, is_in_front: bool, mut sum: Color, probe: &mut P) -> Color {
        let Way { area, number: light, .. } = *self;
        // How far the points of a sphere are that are spread by solid angle has no derivative at its limb.
        let has_limb = area.by == By::SolidAngle && matches!(area.surface, LightSurface::Sphere { .. });
        let is_smooth = is_in_front
            && area.profile.is_none()
            && !(has_limb && self.light.attenuation.is_some())
            && !self.light.bends_between(self.distances());
        if let Some(rule) = is_smooth.then(|| adaptive.rule(&area.surface, self.sight())).flatten() {
            let points = rule.points.len() as u32;
            probe.rays_saved(Saving::Search, points.into());
            probe.mark(Decision::Asked { light, why: Asking::Rule, points, object: None });
            for (split, point) in (1..).zip(&rule.points) {
                sum += self.by_rule(split, point, probe);
            }
            return sum;
        }
        let points = area.samples;
        probe.rays_saved(Saving::Search, points.into());
        probe.mark(Decision::Asked { light, why: Asking::InView, points, object: None });
        let splits = self.splits();
        for part in 0..points {
            sum += self.at_random(&splits, part, Between::Nothing, probe);
        }
        sum
    }

    /// The sum with what a light adds of which a part may be hidden: that of all points, unless one object hides them all.
    #[inline(always)]
    fn in_part<P: Probe>(&self, among: Option<&[u32]>, mut sum: Color, probe: &mut P) -> Color {
        let Way { number: light, .. } = *self;
        let points = self.area.samples;
        let splits = self.splits();
        for part in 0..points {
            let seen = self.at_random(&splits, part, Between::Of(among), probe);
            sum += seen;
            if part == 0 {
                let hider = if seen == Color::ZERO { self.hider(&splits) } else { None };
                if let Some(object) = hider {
                    probe.mark(Decision::Asked { light, why: Asking::Hidden, points: 1, object: Some(object) });
                    return sum;
                }
                probe.mark(Decision::Asked { light, why: Asking::All, points, object: None });
            }
        }
        sum
    }

    fn splits(&self) -> Splits<'_> {
        let Way { meeting, area, number: light, .. } = *self;
        Splits::new(meeting.path.draws, Dimension::Light { route: meeting.path.route(), light }, area.samples)
    }

    /// How far the light's points are at least and at most.
    fn distances(&self) -> [f64; 2] {
        let (center, radius) = self.area.ball();
        let distance = (center - self.meeting.surface.point).length();
        [distance - radius, distance + radius]
    }

    /// What the light looks like from the surface point.
    fn sight(&self) -> Sight {
        let Meeting { surface, material, .. } = self.meeting;
        let (center, radius) = self.area.ball();
        let way = center - surface.point;
        let square = way.dot(way);
        let spread = radius * radius / square;
        let fades = self.light.attenuation.is_some();
        if material.specular == Color::ZERO {
            return Sight { spread, fades, sharpness: 0.0 };
        }
        let exponent = self.scene.tracing.specular.exponent(material.shininess);
        let sharpness = match self.scene.tracing.specular {
            // The half vector turns by less than the light does, but where both directions run along the surface: by 1/|L + V| of it.
            Specular::HalfVector | Specular::HalfVectorCompensated => {
                let sum = way / square.sqrt() + self.view;
                exponent * spread / sum.dot(sum)
            }
            // Where it ends, a wide lobe has a bend.
            Specular::ReflectionVector if exponent < 4.0 => f64::INFINITY,
            Specular::ReflectionVector => exponent * spread,
        };
        Sight { spread, fades, sharpness: sharpness.max(f64::MIN_POSITIVE) }
    }

    /// What a point of a rule adds.
    #[inline(always)]
    fn by_rule<P: Probe>(&self, split: u32, point: &RulePoint, probe: &mut P) -> Color {
        self.light.give_with(self.light.color, probe);
        probe.within(
            Step::Light { light: self.number, split },
            #[inline(always)]
            |probe| {
                let position = self.area.ruled_point(point.at, self.meeting.surface.point, probe);
                probe.given(Name::LightShare, point.weight);
                let color = probe.note(Name::LightColorShared, self.light.color * point.weight);
                self.from(position, split, &color, Between::Nothing, probe)
            },
        )
    }

    /// What the random point in this stratum adds.
    #[inline(always)]
    fn at_random<P: Probe>(&self, splits: &Splits, part: u32, between: Between, probe: &mut P) -> Color {
        self.light.give(probe);
        let split = if self.area.samples == 1 { 0 } else { part + 1 };
        probe.within(
            Step::Light { light: self.number, split },
            #[inline(always)]
            |probe| {
                let square = place_in_square(splits.pick(part), probe);
                let (position, of_profile) = self.area.point(square, self.meeting.surface.point, probe);
                let color = self.light.share();
                let color = of_profile.map_or(color, |weight| probe.note(Name::LightColorWeighted, color * weight));
                self.from(position, split, &color, between, probe)
            },
        )
    }

    /// What a point of the light adds that has this intensity.
    #[inline(always)]
    fn from<P: Probe>(&self, position: DVec3, split: u32, color: &Color, between: Between, probe: &mut P) -> Color {
        let (among, is_free) = match between {
            Between::Nothing => (None, true),
            Between::Of(among) => (among, false),
        };
        if is_free {
            probe.mark(Decision::Free);
        }
        let source = Source { light: self.light, number: self.number, split, color, among, is_free };
        let arrival = Arrival::of(position, self.meeting.surface.point, probe);
        from_light(self.scene, self.meeting, self.view, &source, arrival, probe)
    }

    /// The object that hides all of the light, if one object does that hides its first point.
    ///
    /// It is convex and hides the corners of a convex hull of the light: on the ways to the corners c_i lie points x_i = P + s_i·(c_i − P) of it. The way to
    /// Σλ_i·c_i then meets Σ(λ_i/s_i)·x_i/S with S = Σλ_i/s_i ≥ 1, which is a point of it, too.
    #[inline(never)]
    fn hider(&self, splits: &Splits) -> Option<u32> {
        let Way { scene, meeting, area, .. } = *self;
        let point = meeting.surface.point;
        let way_to = |position: DVec3| {
            let arrival = Arrival::of(position, point, &mut Silent)?;
            let leaving = Some(meeting.leaving_here());
            Some(Ray { leaving, slack: meeting.slack, time: meeting.ray.time, ..segment_to_light(point, &arrival) })
        };
        let (position, _) = area.point(splits.pick(0).point(), point, &mut Silent);
        let ray = way_to(position)?;
        let corners = area.corners();
        let mut found = None;
        let lets_light_pass = scene.tracing.shadows == Shadows::PerSurface;
        let search = Search::in_any_order(&Silent);
        scene.index.usual().visit(&ray, search, &mut Silent, |object, _, probe| {
            let candidate = &scene.objects[object as usize];
            let is_opaque = !(lets_light_pass && scene.materials[candidate.material].transmits());
            if is_opaque
                && object != meeting.layer.object
                && !candidate.one_sided
                && candidate.shape.is_convex_from(point)
                && candidate.shape.is_crossed(Target::two_sided(object), &ray, probe)
                && corners.iter().all(|corner| {
                    way_to(*corner)
                        .is_some_and(|ray| candidate.shape.is_crossed(Target::two_sided(object), &ray, probe))
                })
            {
                found = Some(found.map_or(object, |other: u32| other.min(object)));
            }
            ray.t_max
        });
        found
    }
}

/// A light that is all on one side of the surface.
pub(super) struct OneSide {
    /// The ways to it.
    pub shaft: Shaft,
    /// How they leave the surface.
    pub leaving: Leaving,
    /// Whether it is the viewer's side.
    pub is_in_front: bool,
}

/// On which side of the surface all of the light is; `None` where it may be on both.
#[inline(always)]
pub(super) fn on_one_side(meeting: &Meeting, area: &AreaLight) -> Option<OneSide> {
    let surface = &meeting.surface;
    let shaft = Shaft::new(surface.point, area.bounds(), area.ball());
    let normal = surface.geometric_normal();
    let [least, most] = shaft.rise_along(normal);
    let [shown_least, shown_most] = surface.beneath.map_or([least, most], |_| shaft.rise_along(surface.normal));
    if least > 0.0 && shown_least > 0.0 {
        Some(OneSide { shaft: shaft.rising(normal, least), leaving: meeting.leaving_here(), is_in_front: true })
    } else if most < 0.0 && shown_most < 0.0 {
        let shaft = shaft.rising(-normal, -most);
        Some(OneSide { shaft, leaving: meeting.leaving_beyond(), is_in_front: false })
    } else {
        None
    }
}
