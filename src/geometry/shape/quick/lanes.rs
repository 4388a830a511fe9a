//! The same with the instructions of processors with AVX2 and fused operations. The crate `pulp` vouches that they are there.
//!
//! No operation is fused, so that the bits are those of the kernel.

use super::{Corners, OfFour, Quick, RayLanes};
use crate::geometry::bvh::{PerRay, RayMask};
use crate::geometry::processor::{self, instructions};
use crate::geometry::ray::{Ray, Side};
use crate::geometry::shape::edge::{LEAST_SIZE, OF_EDGE};
use crate::geometry::shape::flat::{LEAST_KEPT, PlaneHit, margin_of};
use glam::DVec3;
use pulp::x86::V3;
use std::arch::x86_64::{__m128d, __m256d, _CMP_GE_OQ, _CMP_LE_OQ, _CMP_LT_OQ};

/// Ends of edges as large as this, seen from the origin, have finite products.
const GREATEST_SIZE: f64 = 1e75;

/// Distances beyond this are left to the kernel, which asks whether there is a point.
const FARTHEST: f64 = 1e100;

/// Four numbers side by side.
#[derive(Clone, Copy)]
pub struct Lanes(V3);

impl Lanes {
    /// The instructions, if the processor has them.
    #[inline(always)]
    pub fn detected() -> Option<Lanes> {
        processor::avx2().map(Lanes)
    }

    #[inline(always)]
    fn vector(self, vector: &DVec3) -> __m256d {
        // Two loads, as whole as they lie in memory.
        let [low, high]: [__m128d; 2] = [pulp::cast([vector.x, vector.y]), pulp::cast([vector.z, 0.0])];
        self.0.avx._mm256_insertf128_pd::<1>(self.0.avx._mm256_castpd128_pd256(low), high)
    }

    #[inline(always)]
    fn splat(self, x: f64) -> __m256d {
        self.0.avx._mm256_set1_pd(x)
    }

    instructions! { __m256d:
        add(a, b) = avx._mm256_add_pd;
        sub(a, b) = avx._mm256_sub_pd;
        mul(a, b) = avx._mm256_mul_pd;
        min(a, b) = avx._mm256_min_pd;
        max(a, b) = avx._mm256_max_pd;
        and(a, b) = avx._mm256_and_pd;
        less(a, b) = avx._mm256_cmp_pd::<_CMP_LT_OQ>;
        at_most(a, b) = avx._mm256_cmp_pd::<_CMP_LE_OQ>;
    }

    #[inline(always)]
    fn abs(self, a: __m256d) -> __m256d {
        self.0.avx._mm256_andnot_pd(self.splat(-0.0), a)
    }

    /// (y, z, x)
    #[inline(always)]
    fn turned(self, a: __m256d) -> __m256d {
        self.0.avx2._mm256_permute4x64_pd::<0b11_00_10_01>(a)
    }

    /// a × b, its components in the order z, x, y.
    #[inline(always)]
    fn cross(self, [a, a_turned]: [__m256d; 2], [b, b_turned]: [__m256d; 2]) -> __m256d {
        self.sub(self.mul(a, b_turned), self.mul(a_turned, b))
    }

    #[inline(always)]
    fn halves(self, a: __m256d) -> [__m128d; 2] {
        [self.0.avx._mm256_castpd256_pd128(a), self.0.avx._mm256_extractf128_pd::<1>(a)]
    }

    #[inline(always)]
    fn numbers(self, a: __m128d) -> [f64; 2] {
        pulp::cast(a)
    }

    #[inline(always)]
    fn greatest(self, a: __m256d) -> f64 {
        let [low, high] = self.halves(a);
        let [x, y] = self.numbers(self.0.sse2._mm_max_pd(low, high));
        if x > y { x } else { y }
    }

    #[inline(always)]
    fn least(self, a: __m256d) -> f64 {
        let [low, high] = self.halves(a);
        let [x, y] = self.numbers(self.0.sse2._mm_min_pd(low, high));
        if x < y { x } else { y }
    }

    /// Of three vectors whose components are in the order z, x, y the sums x + y + z, the last one twice.
    #[inline(always)]
    fn sums(self, [a, b, c]: [__m256d; 3]) -> __m256d {
        let avx = self.0.avx;
        let (z_x, c_z_x) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpacklo_pd(c, c));
        let (x_w, c_x_w) = (avx._mm256_unpackhi_pd(a, b), avx._mm256_unpackhi_pd(c, c));
        let z = avx._mm256_permute2f128_pd::<0x20>(z_x, c_z_x);
        let y = avx._mm256_permute2f128_pd::<0x31>(z_x, c_z_x);
        let x = avx._mm256_permute2f128_pd::<0x20>(x_w, c_x_w);
        self.add(self.add(x, y), z)
    }
}

/// [`super::quick`].
#[inline(always)]
pub fn quick(lanes: Lanes, Corners { corners: [a, b, c], normal }: Corners, ray: &Ray) -> Quick {
    let (origin, direction) = (lanes.vector(&ray.origin), lanes.vector(&ray.direction));
    let (a, b, c) = (lanes.vector(a), lanes.vector(b), lanes.vector(c));
    let (to_a, to_b, to_c) = (lanes.sub(a, origin), lanes.sub(b, origin), lanes.sub(c, origin));
    let (at_a, at_b, at_c) = ([to_a, lanes.turned(to_a)], [to_b, lanes.turned(to_b)], [to_c, lanes.turned(to_c)]);
    let direction_zxy = lanes.turned(lanes.turned(direction));
    let (of_a, of_b, of_c) = (lanes.cross(at_c, at_b), lanes.cross(at_a, at_c), lanes.cross(at_b, at_a));
    let edges = [lanes.mul(direction_zxy, of_a), lanes.mul(direction_zxy, of_b), lanes.mul(direction_zxy, of_c)];
    let edges = lanes.sums(edges);
    let size = lanes.greatest(lanes.max(lanes.max(lanes.abs(to_a), lanes.abs(to_b)), lanes.abs(to_c)));
    let bound = OF_EDGE * size * size;
    let (least, greatest) = (lanes.least(edges), lanes.greatest(edges));
    let has_plain_products = (LEAST_SIZE..=GREATEST_SIZE).contains(&size);
    if least < -bound && greatest > bound {
        return if has_plain_products { Quick::Beside } else { Quick::InDoubt };
    }
    if !((least > bound || greatest < -bound) && has_plain_products) {
        return Quick::InDoubt;
    }
    let normal = lanes.vector(normal);
    met(lanes, [origin, direction], [a, b, c], [lanes.mul(normal, direction), lanes.mul(normal, to_a)], ray)
}

/// Where the ray hits the plane; the products are the terms of V_d and V_o.
#[inline(always)]
fn met(
    lanes: Lanes,
    [origin, direction]: [__m256d; 2],
    [a, b, c]: [__m256d; 3],
    [of_v_d, of_v_o]: [__m256d; 2],
    ray: &Ray,
) -> Quick {
    let (avx, sse2) = (lanes.0.avx, lanes.0.sse2);
    let [x, z] = lanes.halves(avx._mm256_unpacklo_pd(of_v_d, of_v_o));
    let [y, _] = lanes.halves(avx._mm256_unpackhi_pd(of_v_d, of_v_o));
    let values = sse2._mm_add_pd(sse2._mm_add_pd(x, y), z);
    let sign = sse2._mm_set1_pd(-0.0);
    let (x, y, z) = (sse2._mm_andnot_pd(sign, x), sse2._mm_andnot_pd(sign, y), sse2._mm_andnot_pd(sign, z));
    let terms = sse2._mm_add_pd(sse2._mm_add_pd(x, y), z);
    let kept = sse2._mm_mul_pd(sse2._mm_set1_pd(LEAST_KEPT), terms);
    let have_all = sse2._mm_movemask_pd(sse2._mm_cmpge_pd(sse2._mm_andnot_pd(sign, values), kept)) == 0b11;
    let [v_d, v_o] = lanes.numbers(values);
    let t = v_o / v_d;
    if !(have_all && t.abs() < FARTHEST) {
        return Quick::Inside;
    }
    let (min, max) = (lanes.min(lanes.min(a, b), c), lanes.max(lanes.max(a, b), c));
    let point = lanes.add(origin, lanes.mul(direction, lanes.splat(t)));
    let largest = lanes.greatest(lanes.max(lanes.abs(min), lanes.abs(max)));
    let of_point = ray.origin.abs().max_element() + 2.0 * lanes.greatest(lanes.abs(point));
    let margin = lanes.splat(margin_of(largest, of_point));
    let above = avx._mm256_cmp_pd::<_CMP_GE_OQ>(point, lanes.sub(min, margin));
    let below = avx._mm256_cmp_pd::<_CMP_LE_OQ>(point, lanes.add(max, margin));
    let is_within = avx._mm256_movemask_pd(avx._mm256_and_pd(above, below)) & 0b111 == 0b111;
    let side = if v_d < 0.0 { Side::Front } else { Side::Back };
    if is_within { Quick::Met(PlaneHit { t, side }) } else { Quick::Inside }
}

/// A vector in each lane.
type Vectors = [__m256d; 3];

/// Operations on a vector in each lane.
impl Lanes {
    #[inline(always)]
    fn four(self, numbers: &PerRay<f64>, first: usize) -> __m256d {
        let [low, high]: [[f64; 4]; 2] = pulp::cast(*numbers);
        pulp::cast(if first == 0 { low } else { high })
    }

    #[inline(always)]
    fn fours(self, numbers: &[PerRay<f64>; 3], first: usize) -> Vectors {
        [self.four(&numbers[0], first), self.four(&numbers[1], first), self.four(&numbers[2], first)]
    }

    #[inline(always)]
    fn splats(self, vector: &DVec3) -> Vectors {
        [self.splat(vector.x), self.splat(vector.y), self.splat(vector.z)]
    }

    #[inline(always)]
    fn difference(self, p: &Vectors, q: &Vectors) -> Vectors {
        [self.sub(p[0], q[0]), self.sub(p[1], q[1]), self.sub(p[2], q[2])]
    }

    #[inline(always)]
    fn minor(self, a: __m256d, b: __m256d, c: __m256d, d: __m256d) -> __m256d {
        self.sub(self.mul(a, b), self.mul(c, d))
    }

    /// p × q
    #[inline(always)]
    fn product(self, p: &Vectors, q: &Vectors) -> Vectors {
        [self.minor(p[1], q[2], q[1], p[2]), self.minor(p[2], q[0], q[2], p[0]), self.minor(p[0], q[1], q[0], p[1])]
    }

    /// The terms of p · q.
    #[inline(always)]
    fn terms(self, p: &Vectors, q: &Vectors) -> Vectors {
        [self.mul(p[0], q[0]), self.mul(p[1], q[1]), self.mul(p[2], q[2])]
    }

    #[inline(always)]
    fn sum(self, terms: &Vectors) -> __m256d {
        self.add(self.add(terms[0], terms[1]), terms[2])
    }

    #[inline(always)]
    fn magnitudes(self, p: &Vectors) -> Vectors {
        [self.abs(p[0]), self.abs(p[1]), self.abs(p[2])]
    }

    /// The greatest coordinate of each vector.
    #[inline(always)]
    fn size(self, p: &Vectors) -> __m256d {
        let [x, y, z] = self.magnitudes(p);
        self.max(self.max(x, y), z)
    }

    /// d · (p × q)
    #[inline(always)]
    fn edge(self, direction: &Vectors, p: &Vectors, q: &Vectors) -> __m256d {
        self.sum(&self.terms(direction, &self.product(p, q)))
    }

    #[inline(always)]
    fn bits(self, mask: __m256d) -> RayMask {
        self.0.avx._mm256_movemask_pd(mask) as RayMask
    }

    /// Whether a sum keeps all of its digits.
    #[inline(always)]
    fn keeps(self, value: __m256d, terms: &Vectors) -> __m256d {
        self.at_most(self.mul(self.splat(LEAST_KEPT), self.sum(&self.magnitudes(terms))), self.abs(value))
    }

    /// Whether the coordinates lie between two, with a margin.
    #[inline(always)]
    fn is_within(self, x: __m256d, [min, max]: [f64; 2], margin: __m256d) -> __m256d {
        let (min, max) = (self.sub(self.splat(min), margin), self.add(self.splat(max), margin));
        self.and(self.at_most(min, x), self.at_most(x, max))
    }
}

/// [`super::quick_of_four`].
#[inline(always)]
pub fn quick_of_four(
    lanes: Lanes,
    Corners { corners: [a, b, c], normal }: Corners,
    rays: &RayLanes,
    first: usize,
) -> OfFour {
    let Lanes(v3) = lanes;
    let (origin, direction) = (lanes.fours(&rays.origin, first), lanes.fours(&rays.direction, first));
    let to_a = lanes.difference(&lanes.splats(a), &origin);
    let to_b = lanes.difference(&lanes.splats(b), &origin);
    let to_c = lanes.difference(&lanes.splats(c), &origin);
    let edge_a = lanes.edge(&direction, &to_c, &to_b);
    let edge_b = lanes.edge(&direction, &to_a, &to_c);
    let edge_c = lanes.edge(&direction, &to_b, &to_a);
    let size = lanes.max(lanes.max(lanes.size(&to_a), lanes.size(&to_b)), lanes.size(&to_c));
    let bound = lanes.mul(lanes.mul(lanes.splat(OF_EDGE), size), size);
    let minus_bound = lanes.sub(lanes.splat(0.0), bound);
    let least = lanes.min(lanes.min(edge_a, edge_b), edge_c);
    let largest = lanes.max(lanes.max(edge_a, edge_b), edge_c);
    let is_plain =
        lanes.and(lanes.at_most(lanes.splat(LEAST_SIZE), size), lanes.at_most(size, lanes.splat(GREATEST_SIZE)));
    let beside = lanes.and(lanes.less(least, minus_bound), lanes.less(bound, largest));
    let beside = lanes.bits(lanes.and(beside, is_plain));
    let inside = v3.avx._mm256_or_pd(lanes.less(bound, least), lanes.less(largest, minus_bound));
    let inside = lanes.and(inside, is_plain);
    if lanes.bits(inside) == 0 {
        return OfFour { beside, ..OfFour::default() };
    }
    let normal = lanes.splats(normal);
    let (of_v_d, of_v_o) = (lanes.terms(&normal, &direction), lanes.terms(&normal, &to_a));
    let (v_d, v_o) = (lanes.sum(&of_v_d), lanes.sum(&of_v_o));
    let have_all = lanes.and(lanes.keeps(v_d, &of_v_d), lanes.keeps(v_o, &of_v_o));
    let t = v3.avx._mm256_div_pd(v_o, v_d);
    let is_near = lanes.less(lanes.abs(t), lanes.splat(FARTHEST));
    let (min, max) = (a.min(*b).min(*c), a.max(*b).max(*c));
    let largest = min.abs().max(max.abs()).max_element();
    let [x, y, z] = lanes.terms(&direction, &[t, t, t]);
    let point = [lanes.add(origin[0], x), lanes.add(origin[1], y), lanes.add(origin[2], z)];
    let twice = lanes.splat(2.0);
    let of_point = lanes.add(lanes.four(&rays.size, first), lanes.mul(twice, lanes.size(&point)));
    // As `margin_of` has it.
    let margin = lanes.sub(lanes.splat(12.0 * largest), lanes.mul(twice, of_point));
    let margin = lanes.mul(margin, lanes.splat(0.5 * f64::EPSILON));
    let x_within = lanes.is_within(point[0], [min.x, max.x], margin);
    let y_within = lanes.is_within(point[1], [min.y, max.y], margin);
    let z_within = lanes.is_within(point[2], [min.z, max.z], margin);
    let within = lanes.and(lanes.and(x_within, y_within), z_within);
    let met = lanes.bits(lanes.and(lanes.and(inside, have_all), lanes.and(is_near, within)));
    OfFour { beside, met, t: pulp::cast(t), front: lanes.bits(lanes.less(v_d, lanes.splat(0.0))) }
}
