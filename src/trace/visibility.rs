//! What a ray hits first, and how much light a shadow ray lets through.

use super::{Layer, LayerStack, in_range};
use crate::geometry::{
    Crossing, Hit, Intersect, Nearest, PACKET, PerRay, Ray, RayMask, RaySource, Search, Shape, each,
};
use crate::log::{Decision, SkipReason, Term};
use crate::probe::{Probe, Saving};
use crate::scene::{Color, Scene, Shadows};
use std::cmp::Ordering;

/// Two distances nearer to each other than this many parts of them are compared with more digits.
const NEAR_TIE: f64 = 8.0 * f64::EPSILON;

/// Two distances with twice the digits that differ by no more than this part of them are the same: that much is their own error where
/// half of their digits were lost.
const SAME: f64 = f64::EPSILON * f64::EPSILON * (1 << 24) as f64;

/// The order of two crossings along the ray; at the same distance the object that comes first in the
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
    scene.index.visit(ray, Search::in_any_order(probe), probe, |object, _, probe| {
        let found = &scene.objects[object as usize];
        found.shape.all_crossings(found.target(object), ray, &mut crossings, probe);
        hits.extend(crossings.drain(..).map(|crossing| Hit { object, crossing }));
        ray.t_max
    });
    hits.sort_by(|one, other| one.crossing.t.total_cmp(&other.crossing.t).then(one.object.cmp(&other.object)));
    // What nearly coincides is put in order by the shapes. That isn't transitive, which a library's sort may refuse.
    for next in 1..hits.len() {
        let mut place = next;
        while place > 0 && order(scene, ray, hits[place - 1], hits[place], probe).is_gt() {
            hits.swap(place - 1, place);
            place -= 1;
        }
    }
    hits
}

/// The nearest hit. Of coincident surfaces the first in the scene is the nearest, then the lowest primitive.
#[inline(always)]
pub fn closest_hit<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Option<Hit> {
    let nearest = search(scene, ray, probe);
    let hit = nearest.hit()?;
    if !nearest.is_alone() {
        return Some(settled(scene, ray, nearest, probe)[0]);
    }
    probe.mark(Decision::Nearest { object: hit.object });
    Some(hit)
}

/// The nearest hit by its distance, and those that may coincide.
// Inlined into the recursion, which otherwise would read the hit from memory.
#[inline(always)]
pub(super) fn search<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Nearest {
    let mut nearest = Nearest::of(ray);
    scene.index.visit(
        ray,
        Search::nearest_first(probe),
        probe,
        #[inline(always)]
        |object, _, probe| {
            let found = &scene.objects[object as usize];
            found.shape.nearest(found.target(object), ray, &mut nearest, probe);
            nearest.limit()
        },
    );
    nearest
}

/// The same for several rays, at most [`PACKET`], which traverse the tree as a packet where they are coherent.
pub(super) fn search_together<P: Probe>(scene: &Scene, rays: &[Ray], nearest: &mut PerRay<Nearest>, probe: &mut P) {
    let mut limits = [-1.0; PACKET];
    for (at, ray) in rays.iter().enumerate().take(PACKET) {
        nearest[at] = Nearest::of(ray);
        limits[at] = ray.t_max;
    }
    scene.index.visit_together::<P, Ray>(
        rays,
        (1 << rays.len()) - 1,
        Search::nearest_first(probe),
        &mut limits,
        #[inline(always)]
        |which, object, _, limits| {
            let found = &scene.objects[object as usize];
            if let Shape::Mesh(mesh) = &found.shape {
                mesh.nearest_together(found.target(object), rays, which, nearest, limits, probe);
                return;
            }
            for at in each(which) {
                found.shape.nearest(found.target(object), &rays[at], &mut nearest[at], probe);
                limits[at] = nearest[at].limit();
            }
        },
    );
}

/// The surfaces coincident with the nearest one, in the order of the scene; marks what was decided.
#[cold]
#[inline(never)]
pub(super) fn settled<P: Probe>(scene: &Scene, ray: &Ray, nearest: Nearest, probe: &mut P) -> Vec<Hit> {
    let place = nearest.place(ray, |object| &scene.objects[object as usize].shape, probe);
    probe.mark(Decision::Nearest { object: place[0].object });
    for other in &place[1..] {
        let is_mesh = scene.objects[other.object as usize].shape.is_mesh();
        let triangle = is_mesh.then_some(other.crossing.primitive);
        probe.mark(Decision::Coincident { object: other.object, triangle });
    }
    place
}

/// The hit of a ray that begins just in front of a surface, which is therefore the nearest. There is one in a place that a ray begins in.
#[cold]
pub(super) fn touched<P: Probe>(scene: &Scene, ray: &Ray, place: &LayerStack, probe: &mut P) -> Hit {
    let layer = place.ahead[0];
    let object = &scene.objects[layer.object as usize];
    object.shape.touch(object.target(layer.object), layer.primitive, ray, probe);
    probe.mark(Decision::Nearest { object: layer.object });
    layer.touched()
}

/// Whether a ray hits anything at all. Kernels compute fewer digits for rays that need no distance.
#[inline(always)]
pub fn is_any_hit<P: Probe>(scene: &Scene, source: &impl RaySource, probe: &mut P) -> bool {
    let mut is_hit = false;
    scene.index.visit(source, Search::of_any(probe), probe, |object, is_sure, probe| {
        is_hit = is_blocked_by(scene, source, object, is_sure, probe);
        if is_hit { -1.0 } else { source.reach() }
    });
    is_hit
}

/// Which of several rays, at most [`PACKET`], of those in `rays` hit anything at all.
pub fn are_any_hit<P: Probe, S: RaySource>(scene: &Scene, sources: &[S], rays: RayMask, probe: &mut P) -> RayMask {
    let mut limits = [-1.0; PACKET];
    for at in each(rays) {
        limits[at] = sources[at].reach();
    }
    scene.index.visit_together::<P, S>(
        sources,
        rays,
        Search::of_any(probe),
        &mut limits,
        #[inline(always)]
        |which, object, is_sure, limits| {
            let found = &scene.objects[object as usize];
            if let Shape::Mesh(mesh) = &found.shape {
                mesh.cross_together(found.target(object), sources, which, limits, probe);
                return;
            }
            for at in each(which) {
                if is_blocked_by(scene, &sources[at], object, is_sure, probe) {
                    limits[at] = -1.0;
                }
            }
        },
    );
    each(rays).filter(|at| limits[*at] < 0.0).fold(0, |hit, at| hit | 1 << at)
}

/// Whether the ray crosses an object; `is_sure` where that is known but for the ray's own surface and the object's side.
#[inline(always)]
fn is_blocked_by<P: Probe>(scene: &Scene, source: &impl RaySource, object: u32, is_sure: bool, probe: &mut P) -> bool {
    let found = &scene.objects[object as usize];
    let is_left = || source.leaving().is_some_and(|leaving| leaving.object == object);
    (is_sure && !found.one_sided && !is_left()) || found.shape.is_crossed(found.target(object), source, probe)
}

/// The part of the light that gets along a shadow ray: the product of what every crossed surface transmits, in a
/// straight line; zero as soon as an opaque one is crossed (Ramos, section 1.2.5).
pub fn transmittance<P: Probe>(scene: &Scene, ray: &Ray, probe: &mut P) -> Color {
    transmittance_among(scene, ray, &Obstacles::default(), probe)
}

/// What is known of the surfaces that a shadow ray crosses before they are searched for.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Obstacles<'a> {
    /// All objects that the ray can intersect, where they are known.
    pub among: Option<&'a [u32]>,
    /// The surfaces that the ray crosses where it begins.
    pub touched: &'a [Layer],
}

/// The same where something is known before the search.
#[inline(always)]
pub(super) fn transmittance_among<P: Probe>(scene: &Scene, ray: &Ray, obstacles: &Obstacles, probe: &mut P) -> Color {
    let has_none = obstacles.among.is_some_and(<[u32]>::is_empty) && obstacles.touched.is_empty();
    if has_none {
        probe.rays_saved(Saving::Search, 1);
        if P::IS_SILENT {
            return Color::ONE;
        }
    }
    // A probe that counts or logs tests sees all of them.
    let obstacles = if P::IS_SILENT { *obstacles } else { Obstacles { among: None, ..*obstacles } };
    searched(scene, ray, &obstacles, probe)
}

// Outlined: the shading around it would spill this loop's registers.
#[inline(never)]
fn searched<P: Probe>(scene: &Scene, ray: &Ray, obstacles: &Obstacles, probe: &mut P) -> Color {
    let stops_when_blocked = scene.tracing.skip.has(SkipReason::Blocked);
    let lets_light_pass = scene.tracing.shadows == Shadows::PerSurface;
    let mut crossed: Vec<(f64, u32)> = Vec::new();
    let mut crossings: Vec<Crossing> = Vec::new();
    let mut is_blocked = false;
    for layer in obstacles.touched {
        if lets_light_pass && scene.material_of(layer.object).transmits() {
            crossed.push((0.0, layer.object));
        } else {
            probe.mark(Decision::Occluded { object: layer.object });
            return Color::ZERO;
        }
    }
    let mut meet = |object: u32, is_sure: bool, probe: &mut P| {
        let found = &scene.objects[object as usize];
        if lets_light_pass && scene.materials[found.material].transmits() {
            found.shape.all_crossings(found.target(object), ray, &mut crossings, probe);
            crossed.extend(crossings.drain(..).map(|crossing| (crossing.t, object)));
        } else if is_blocked_by(scene, ray, object, is_sure, probe) {
            if !is_blocked {
                probe.mark(Decision::Occluded { object });
            }
            is_blocked = true;
        }
        if is_blocked && stops_when_blocked {
            probe.mark(Decision::Skipped { what: Term::Shadow, why: SkipReason::Blocked });
            return -1.0;
        }
        ray.t_max
    };
    match obstacles.among {
        None => scene.index.visit(ray, Search::of_any(probe), probe, meet),
        Some(objects) => {
            // One that blocks the ray ends the search.
            let _ = objects.iter().any(|object| meet(*object, false, probe) < 0.0);
        }
    }
    if is_blocked { Color::ZERO } else { attenuation(scene, crossed, probe) }
}

/// The product over the crossed surfaces, in the order of the ray, so that it has the same bits however they were found.
fn attenuation<P: Probe>(scene: &Scene, mut crossed: Vec<(f64, u32)>, probe: &mut P) -> Color {
    if crossed.is_empty() {
        probe.mark(Decision::Free);
        return Color::ONE;
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Side;
    use crate::geometry::shape::{Plane, Sphere, SphereMethod};
    use crate::probe::{Altered, Silent, Single};
    use glam::DVec3;

    /// The order of two hits at these distances as f64 has them, with planes across a ray along z at these true distances.
    #[track_caller]
    fn is_ordered<P: Probe>(planes: [f64; 2], found: [f64; 2], mut probe: P, expected: Ordering) {
        let plane = |distance: f64| Shape::Plane(Plane::new([0.0, 0.0, 1.0, -distance]));
        let scene = Scene::of_shapes("planes", planes.map(plane));
        let hit = |object: u32| {
            let crossing = Crossing { t: found[object as usize], side: Side::Back, primitive: 0 };
            Hit { object, crossing }
        };
        let ray = Ray::new(DVec3::ZERO, DVec3::Z);
        assert_eq!(order(&scene, &ray, hit(0), hit(1), &mut probe), expected, "{planes:?} {found:?}");
        assert_eq!(order(&scene, &ray, hit(1), hit(0), &mut probe), expected.reverse(), "{planes:?} {found:?}");
    }

    /// Far from 1, so that a part of the distance isn't taken for a distance.
    const FAR: f64 = 1024.0;
    const ULP: f64 = FAR * f64::EPSILON;

    #[test]
    fn near_ties_are_decided_by_what_the_shapes_know() {
        is_ordered([FAR, FAR + ULP], [FAR + ULP, FAR], Silent, Ordering::Less);
        is_ordered([FAR + ULP, FAR], [FAR, FAR + ULP], Silent, Ordering::Greater);
        is_ordered([FAR + ULP, FAR], [FAR, FAR], Silent, Ordering::Greater);
        // Eight parts of the distance still are a tie.
        is_ordered([FAR + ULP, FAR], [FAR, FAR + 7.0 * ULP], Silent, Ordering::Greater);
        // In the same place the first object is the nearer one.
        is_ordered([FAR, FAR], [FAR + ULP, FAR], Silent, Ordering::Less);
    }

    #[test]
    fn distances_that_are_no_near_tie_decide_themselves() {
        is_ordered([FAR + ULP, FAR], [FAR, FAR + 16.0 * ULP], Silent, Ordering::Less);
        is_ordered([FAR + 1.0, FAR], [FAR, FAR + 1.0], Silent, Ordering::Less);
    }

    #[test]
    fn other_arithmetics_go_on_with_their_distances() {
        let single = Altered { alteration: Single, probe: Silent };
        is_ordered([FAR + ULP, FAR], [FAR, FAR + ULP], single, Ordering::Less);
    }

    /// Both ends of the chord of a ball are hits of one object, however near they are to each other.
    #[test]
    fn hits_of_one_object_are_in_the_order_of_their_distances() {
        let ball = Shape::Sphere(Sphere::new(DVec3::Z * FAR, 1.0, false, SphereMethod::Robust));
        let scene = Scene::of_shapes("ball", [ball]);
        let hit = |t: f64| Hit { object: 0, crossing: Crossing { t, side: Side::Front, primitive: 0 } };
        let ray = Ray::new(DVec3::ZERO, DVec3::Z);
        assert_eq!(order(&scene, &ray, hit(FAR), hit(FAR + ULP), &mut Silent), Ordering::Less);
    }
}
