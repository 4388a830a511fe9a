//! Single ray queries: what a ray hits, without any shading, at the time when the shutter opens.

use super::visibility::{all_crossings, are_any_hit, closest_hit, is_any_hit, search_together};
use crate::geometry::Hit;
use crate::geometry::unit::{unit, with_unit};
use crate::geometry::{Intersect, Leaving, Line, Nearest, PACKET, PerRay, Ray, RayMask, RaySource, Side};
use crate::probe::Silent;
use crate::scene::Scene;
use arrayvec::ArrayVec;
use glam::DVec3;
use std::cell::OnceCell;

/// A query about one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    /// Where the ray begins.
    pub origin: DVec3,
    /// Where it goes; of any length but zero, and `t` is in units of it.
    pub direction: DVec3,
    /// Hits lie beyond this distance.
    pub t_min: f64,
    /// Hits lie before this distance.
    pub t_max: f64,
    /// The object and the primitive that the ray leaves.
    pub from: Option<(u32, u32)>,
}

/// What a ray hits first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The object.
    pub object: u32,
    /// The triangle, for a mesh; else the part of the surface.
    pub primitive: u32,
    /// The distance, in units of the direction as given.
    pub t: f64,
    /// The point.
    pub point: DVec3,
    /// The geometric unit normal of the front.
    pub normal: DVec3,
    /// The side from which the ray arrives.
    pub side: Side,
}

/// Where a ray hits something first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// The object.
    pub object: u32,
    /// The triangle, for a mesh; else the part of the surface.
    pub primitive: u32,
    /// The distance, in units of the direction as given.
    pub t: f64,
}

/// How many steps of an ulp the end of a ray may be from its first estimate.
const STEPS: u32 = 8;

impl Query {
    /// A query for hits at any distance from a point on no surface; `direction` may have any length but zero.
    pub fn new(origin: DVec3, direction: DVec3) -> Query {
        Query { origin, direction, t_min: 0.0, t_max: f64::INFINITY, from: None }
    }

    /// What is wrong with the numbers of this query, if anything is.
    pub fn check(&self) -> Result<(), &'static str> {
        if !self.origin.is_finite() {
            Err("o: expected finite numbers")
        } else if !self.direction.is_finite() {
            Err("d: expected finite numbers")
        } else if self.direction == DVec3::ZERO {
            Err("d: expected a direction that is not zero")
        } else {
            Ok(())
        }
    }

    /// The nearest hit, with the surface there.
    pub fn nearest(&self, scene: &Scene) -> Option<Answer> {
        if self.surely_misses(scene) {
            return None;
        }
        let (ray, length) = self.ray(scene);
        let (ray, hit, t) = self.first_hit(ray, length, scene)?;
        Some(Answer::at(&hit, t, &ray, scene))
    }

    /// Every hit in the order of the ray, each with the surface there; coincident surfaces in the order of the scene. A point on an edge or a
    /// vertex that several triangles of a mesh share is one hit where the surface goes on beyond it.
    pub fn all(&self, scene: &Scene) -> Vec<Answer> {
        if self.surely_misses(scene) {
            return Vec::new();
        }
        let (ray, length) = self.ray(scene);
        let answer = |hit: &Hit| {
            let t = hit.crossing.t / length;
            (t > self.t_min && t < self.t_max).then(|| Answer::at(hit, t, &ray, scene))
        };
        all_crossings(scene, &ray, &mut Silent).iter().filter_map(answer).collect()
    }

    /// The nearest hit, without the surface there.
    #[inline]
    pub fn hit(&self, scene: &Scene) -> Option<RayHit> {
        if self.surely_misses(scene) {
            return None;
        }
        with_unit(
            self.direction,
            #[inline(always)]
            |(direction, vector, length)| {
                let ray = self.ray_along(direction, vector, length, scene);
                let (_, hit, t) = self.first_hit(ray, length, scene)?;
                Some(RayHit { object: hit.object, primitive: hit.crossing.primitive, t })
            },
        )
    }

    /// Whether there is any hit.
    #[inline]
    pub fn is_occluded(&self, scene: &Scene) -> bool {
        if self.surely_misses(scene) {
            return false;
        }
        match self.line() {
            Some(line) => is_any_hit(scene, &Asked { query: self, scene, line, ray: OnceCell::new() }, &mut Silent),
            None => {
                let (ray, length) = self.ray(scene);
                self.first_hit(ray, length, scene).is_some()
            }
        }
    }

    /// Where the nearest hits of several rays are, at most [`PACKET`]: calls `answer` with the hit of each, in their order. Coherent rays are
    /// faster like this; the answers are the same.
    pub fn hits(queries: &[Query], scene: &Scene, mut answer: impl FnMut(Option<RayHit>)) {
        let mut rays: ArrayVec<Ray, PACKET> = ArrayVec::new();
        let mut lengths = [0.0; PACKET];
        let mut missing: RayMask = 0;
        for (at, query) in queries.iter().enumerate() {
            if query.surely_misses(scene) {
                missing |= 1 << at;
                continue;
            }
            let (direction, vector, length) = unit(query.direction);
            lengths[rays.len()] = length;
            rays.push(query.ray_along(direction, vector, length, scene));
        }
        let mut nearest: PerRay<Nearest> = [const { Nearest::NONE }; PACKET];
        search_together(scene, &rays, &mut nearest, &mut Silent);
        let mut made = 0;
        for (at, query) in queries.iter().enumerate() {
            if missing >> at & 1 == 1 {
                answer(None);
                continue;
            }
            let (ray, length, nearest) = (&rays[made], lengths[made], &nearest[made]);
            made += 1;
            let t = nearest.hit().map_or(f64::NAN, |hit| hit.crossing.t / length);
            // Where the order of surfaces or an end of the ray is in doubt, the ray is traced alone.
            let hit = match nearest.hit() {
                None => None,
                Some(hit) if nearest.is_alone() && t > query.t_min && t < query.t_max => Some((hit, t)),
                Some(_) => query.first_hit(*ray, length, scene).map(|(_, hit, t)| (hit, t)),
            };
            answer(hit.map(|(hit, t)| RayHit { object: hit.object, primitive: hit.crossing.primitive, t }));
        }
    }

    /// Which of several rays, at most [`PACKET`], have any hit, a bit for each.
    pub fn are_occluded(queries: &[Query], scene: &Scene) -> RayMask {
        let mut asked: ArrayVec<Asked, PACKET> = ArrayVec::new();
        let mut rays = 0;
        for query in queries {
            let Some(line) = query.line() else { break };
            rays |= RayMask::from(!query.surely_misses(scene)) << asked.len();
            asked.push(Asked { query, scene, line, ray: OnceCell::new() });
        }
        if asked.len() < queries.len() {
            let occluded = |at: &usize| queries[*at].is_occluded(scene);
            return (0..queries.len()).filter(occluded).fold(0, |rays, at| rays | 1 << at);
        }
        if rays == 0 { 0 } else { are_any_hit(scene, &asked, rays, &mut Silent) }
    }

    /// The line on which a hit is looked for; `None` where it is too ill-defined to tell.
    #[inline(always)]
    fn line(&self) -> Option<Line> {
        /// Bounds whose products with the length of a line have all their digits.
        const PLAIN: std::ops::Range<f64> = 1e-200..1e200;
        // Where an end has fewer digits than others, its distance in units of the direction decides.
        let has_plain_ends = (self.t_min == 0.0 || PLAIN.contains(&self.t_min))
            && (self.t_max == f64::INFINITY || PLAIN.contains(&self.t_max));
        if has_plain_ends { Line::along(self.origin, self.direction, [self.t_min, self.t_max]) } else { None }
    }

    /// Whether the ray misses the box around everything: that test is far cheaper than normalising its direction.
    #[inline(always)]
    fn surely_misses(&self, scene: &Scene) -> bool {
        scene.index.is_surely_missed(self.origin, self.direction)
    }

    /// The ray, what it hits first, and the distance in units of the direction as given.
    #[inline(always)]
    fn first_hit(&self, mut ray: Ray, length: f64, scene: &Scene) -> Option<(Ray, Hit, f64)> {
        loop {
            let hit = closest_hit(scene, &ray, &mut Silent)?;
            match hit.crossing.t / length {
                t if t <= self.t_min => ray.t_min = hit.crossing.t,
                t if t >= self.t_max => return None,
                t => return Some((ray, hit, t)),
            }
        }
    }

    /// The ray with a unit direction, and the length of the direction as given. Its ends are such that a distance lies between them if and
    /// only if it does so in units of the direction as given, rounding included.
    #[inline]
    pub fn ray(&self, scene: &Scene) -> (Ray, f64) {
        let (direction, vector, length) = unit(self.direction);
        (self.ray_along(direction, vector, length, scene), length)
    }

    /// The ray along the direction, of which the unit vector, the vector of moderate size and the length are known.
    #[inline(always)]
    fn ray_along(&self, direction: DVec3, vector: DVec3, length: f64, scene: &Scene) -> Ray {
        let t_min = if self.t_min == 0.0 { 0.0 } else { -first_beyond(-self.t_min, length) };
        let t_max = if self.t_max == f64::INFINITY { self.t_max } else { first_beyond(self.t_max, length) };
        let time = scene.camera.opening();
        Ray { vector, leaving: self.leaving(scene), t_min, t_max, time, ..Ray::new(self.origin, direction) }
    }

    #[inline(always)]
    fn leaving(&self, scene: &Scene) -> Option<Leaving> {
        self.from.map(|(object, primitive)| {
            let side = scene.objects[object as usize].shape.returning_side();
            Leaving { object, primitive, side }
        })
    }
}

impl Answer {
    /// The surface where the ray hits it, at this distance in units of the direction as given.
    fn at(hit: &Hit, t: f64, ray: &Ray, scene: &Scene) -> Answer {
        let surface = scene.objects[hit.object as usize].shape.surface(ray, hit.crossing, &mut Silent);
        let normal = match surface.side {
            Side::Front => surface.geometric_normal(),
            Side::Back => -surface.geometric_normal(),
        };
        Answer {
            object: hit.object,
            primitive: hit.crossing.primitive,
            t,
            point: surface.point,
            // −0 turned over and back is +0.
            normal: normal + DVec3::ZERO,
            side: surface.side,
        }
    }
}

/// A query whose ray is made when the first kernel asks for it: most rays that hit nothing never need it, and many that do, neither.
struct Asked<'a> {
    query: &'a Query,
    scene: &'a Scene,
    /// The line, its ends in units of the direction as given.
    line: Line,
    ray: OnceCell<Ray>,
}

impl RaySource for Asked<'_> {
    #[inline(always)]
    fn line(&self) -> Option<Line> {
        // Kernels give distances in units of length.
        let Line { unit, t_min, t_max, .. } = self.line;
        Some(Line { unit: 1.0, t_min: t_min * unit, t_max: t_max * unit, ..self.line })
    }

    #[inline(always)]
    fn reach(&self) -> f64 {
        self.line.t_max * self.line.unit
    }

    #[inline(always)]
    fn slack(&self) -> f64 {
        0.0
    }

    #[inline(always)]
    fn leaving(&self) -> Option<Leaving> {
        self.query.leaving(self.scene)
    }

    #[inline(always)]
    fn ray(&self) -> &Ray {
        self.ray.get_or_init(|| Ray { wants_distance: false, ..self.query.ray(self.scene).0 })
    }
}

/// The least distance that is at `bound` or beyond it in units of this length.
#[inline]
fn first_beyond(bound: f64, length: f64) -> f64 {
    let mut t = bound * length;
    for _ in 0..STEPS {
        let before = t.next_down();
        if t / length < bound {
            t = t.next_up();
        } else if before / length >= bound {
            t = before;
        } else {
            break;
        }
    }
    t
}
