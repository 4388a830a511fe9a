//! A triangle's kernel with its numbers side by side, for a probe that sees nothing: one ray with all edges at once, or one triangle with four
//! rays at once.
//!
//! Both take the operations of [`Facet::crossing`](super::triangle::Facet::crossing) in the same order, and so give the same bits. Whatever f64
//! leaves in doubt, and whatever a processor without these instructions is asked, they leave to that.

#[cfg(target_arch = "x86_64")]
mod lanes;

use super::flat::PlaneHit;
use crate::geometry::bvh::{PACKET, PerRay, RayMask, each};
use crate::geometry::ray::Ray;
use crate::probe::Probe;
use glam::DVec3;

/// How far the fast way came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Quick {
    /// The ray's line certainly passes beside the triangle.
    Beside,
    /// It passes inside, and meets the triangle's plane at a distance whose digits are right and whose point is surely within the box around
    /// the triangle.
    Met(PlaneHit),
    /// It passes inside; the rest is in doubt.
    Inside,
    /// All is in doubt.
    InDoubt,
}

/// A triangle's corners and its normal, where they lie in memory.
// Copied together first, they would be read in other pieces than they were written in, and the processor would wait for the copies.
#[derive(Clone, Copy)]
pub(super) struct Corners<'a> {
    pub corners: [&'a DVec3; 3],
    pub normal: &'a DVec3,
}

/// The rays of a packet, in lanes.
pub(super) struct RayLanes {
    origin: [PerRay<f64>; 3],
    direction: [PerRay<f64>; 3],
    /// The greatest coordinate of the origin.
    size: PerRay<f64>,
}

impl RayLanes {
    /// These of the rays.
    #[inline(always)]
    pub fn of(rays: &[Ray], which: RayMask) -> RayLanes {
        let mut lanes = RayLanes { origin: [[0.0; PACKET]; 3], direction: [[0.0; PACKET]; 3], size: [0.0; PACKET] };
        for at in each(which) {
            let Ray { origin, direction, .. } = &rays[at];
            for axis in 0..3 {
                lanes.origin[axis][at] = origin[axis];
                lanes.direction[axis][at] = direction[axis];
            }
            lanes.size[at] = origin.abs().max_element();
        }
        lanes
    }
}

/// What is certain of four rays, a bit for each.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct OfFour {
    /// Those that certainly pass beside the triangle.
    pub beside: RayMask,
    /// Those of [`Quick::Met`].
    pub met: RayMask,
    /// Where these meet the triangle's plane.
    pub t: [f64; 4],
    /// Those that arrive at its front.
    pub front: RayMask,
}

/// Tests the triangle as far as f64 leaves nothing in doubt.
#[inline(always)]
pub(super) fn quick<P: Probe>(triangle: Corners, ray: &Ray) -> Quick {
    #[cfg(target_arch = "x86_64")]
    if P::IS_SILENT
        && let Some(lanes) = lanes::Lanes::detected()
    {
        return lanes::quick(lanes, triangle, ray);
    }
    let _ = (triangle, ray);
    Quick::InDoubt
}

/// Tests the triangle with four rays, from number `first` on, which is 0 or 4.
#[inline(always)]
pub(super) fn quick_of_four<P: Probe>(triangle: Corners, rays: &RayLanes, first: usize) -> OfFour {
    #[cfg(target_arch = "x86_64")]
    if P::IS_SILENT
        && let Some(lanes) = lanes::Lanes::detected()
    {
        return lanes::quick_of_four(lanes, triangle, rays, first);
    }
    let _ = (triangle, rays, first);
    OfFour::default()
}

#[cfg(test)]
mod tests {
    use super::super::triangle::Facet;
    use super::super::{Approach, Kernel, Triangle};
    use super::*;
    use crate::geometry::ray::Side;
    use crate::probe::Silent;
    use crate::random::{hash, unit};

    /// Triangles and rays, some of them with round numbers, far away or along the triangle.
    fn drawn(k: u64) -> (Facet, Vec<Ray>) {
        let number = |axis: u64| {
            let x = 2.0 * unit(hash(k, axis)) - 1.0;
            match k % 5 {
                0 => (x * 4.0).round(),
                1 => f64::from(x as f32),
                _ => x,
            }
        };
        let far = if k.is_multiple_of(7) { 1e6 } else { 1.0 };
        let place = |axis: u64| DVec3::new(number(axis), number(axis + 1), number(axis + 2));
        let facet = Facet::new(place(0), place(3), place(6));
        let eye = place(9) * 4.0 * far;
        let ray = |at: u64| {
            let weights = [number(12 + 3 * at), number(13 + 3 * at)].map(f64::abs);
            let target = facet.a + (facet.b - facet.a) * weights[0] + (facet.c - facet.a) * weights[1];
            // A ray needs a direction.
            let way = if target == eye { DVec3::X } else { target - eye };
            Ray::along(eye + place(40 + at) * 1e-3, way)
        };
        (facet, (0..8).map(ray).collect())
    }

    #[test]
    fn the_fast_ways_say_what_the_kernel_says() {
        let approach = Approach { leaving: None, one_sided: false };
        let (mut told, mut of_four_told) = (0, 0);
        for k in 0..40_000 {
            let (facet, rays) = drawn(k);
            let corners = Corners { corners: [&facet.a, &facet.b, &facet.c], normal: &facet.normal };
            let kernel = Triangle::new([facet.a, facet.b, facet.c].map(|corner| corner.to_array()), None);
            let lanes = RayLanes::of(&rays, 0xff);
            for (at, ray) in rays.iter().enumerate() {
                let expected = kernel.first_crossing(ray, approach, &mut Silent).map(|hit| (hit.t.to_bits(), hit.side));
                let is_reached = |t: f64| ray.reaches(t);
                let told_of = |t: f64, side: Side| is_reached(t).then_some((t.to_bits(), side));
                match quick::<Silent>(corners, ray) {
                    Quick::Beside => assert_eq!(expected, None, "{k} {at}"),
                    Quick::Met(PlaneHit { t, side }) => assert_eq!(told_of(t, side), expected, "{k} {at}"),
                    Quick::Inside | Quick::InDoubt => told -= 1,
                }
                told += 1;
                let OfFour { beside, met, t, front } = quick_of_four::<Silent>(corners, &lanes, at & 4);
                let bit = at & 3;
                assert_eq!(beside & met, 0);
                if beside >> bit & 1 == 1 {
                    assert_eq!(expected, None, "{k} {at}");
                }
                if met >> bit & 1 == 1 {
                    let side = if front >> bit & 1 == 1 { Side::Front } else { Side::Back };
                    assert_eq!(told_of(t[bit], side), expected, "{k} {at}");
                }
                of_four_told += (beside | met) >> bit & 1;
            }
        }
        // Elsewhere there is no fast way.
        #[cfg(target_arch = "x86_64")]
        if lanes::Lanes::detected().is_some() {
            assert!(told > 150_000 && of_four_told > 150_000, "{told} {of_four_told}");
        }
    }
}
