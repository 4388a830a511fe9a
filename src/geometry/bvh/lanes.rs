//! Eight numbers of single precision side by side.
//!
//! Where the processor has AVX2 an operation on eight lanes is one instruction; that is found out when a tree is built. Elsewhere it is
//! eight operations. Both give the same bits, but for the fused operations, which round once where the processor can and twice where it
//! can't: margins are for two roundings. The lesser of two numbers is found by one comparison.

/// Eight numbers, as they lie in memory.
pub(super) type Eight = [f32; 8];

/// Instructions for eight lanes.
pub(super) trait Lanes: Copy {
    /// Eight numbers, as the instructions take them.
    type Eight: Copy;

    /// Eight times the same.
    fn splat(self, x: f32) -> Self::Eight;
    /// Eight numbers from memory.
    fn load(self, eight: &Eight) -> Self::Eight;
    /// Eight numbers to memory.
    fn store(self, eight: Self::Eight) -> Eight;
    /// a + b
    fn add(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// a − b
    fn sub(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// a · b
    fn mul(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// a·b + c, rounded once or twice.
    fn times_plus(self, a: Self::Eight, b: Self::Eight, c: Self::Eight) -> Self::Eight;
    /// a·b − c, rounded once or twice.
    fn times_minus(self, a: Self::Eight, b: Self::Eight, c: Self::Eight) -> Self::Eight;
    /// c − a·b, rounded once or twice.
    fn less_times(self, c: Self::Eight, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// The lesser one; b where one is no number.
    fn min(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// The greater one; b where one is no number.
    fn max(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// √a
    fn sqrt(self, a: Self::Eight) -> Self::Eight;
    /// a, negated where b is.
    fn negated_as(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// A bit for each lane: whether a ≥ b. False where one is no number.
    fn at_least(self, a: Self::Eight, b: Self::Eight) -> u32;
    /// Calls `body`, in which all that is inlined may use the instructions.
    fn run<R>(self, body: impl FnOnce() -> R) -> R;

    /// a · b of vectors.
    #[inline(always)]
    fn dot(self, [a_x, a_y, a_z]: [Self::Eight; 3], [b_x, b_y, b_z]: [Self::Eight; 3]) -> Self::Eight {
        self.times_plus(a_z, b_z, self.times_plus(a_y, b_y, self.mul(a_x, b_x)))
    }

    /// a × b
    #[inline(always)]
    fn cross(self, [a_x, a_y, a_z]: [Self::Eight; 3], [b_x, b_y, b_z]: [Self::Eight; 3]) -> [Self::Eight; 3] {
        let minor = |a, b, c, d| self.times_minus(a, d, self.mul(c, b));
        [minor(a_y, b_y, a_z, b_z), minor(a_z, b_z, a_x, b_x), minor(a_x, b_x, a_y, b_y)]
    }
}

/// What every processor can do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Plain;

impl Lanes for Plain {
    type Eight = Eight;

    #[inline(always)]
    fn splat(self, x: f32) -> Eight {
        [x; 8]
    }

    #[inline(always)]
    fn load(self, eight: &Eight) -> Eight {
        *eight
    }

    #[inline(always)]
    fn store(self, eight: Eight) -> Eight {
        eight
    }

    #[inline(always)]
    fn add(self, a: Eight, b: Eight) -> Eight {
        each(a, b, |a, b| a + b)
    }

    #[inline(always)]
    fn sub(self, a: Eight, b: Eight) -> Eight {
        each(a, b, |a, b| a - b)
    }

    #[inline(always)]
    fn mul(self, a: Eight, b: Eight) -> Eight {
        each(a, b, |a, b| a * b)
    }

    #[inline(always)]
    fn times_plus(self, a: Eight, b: Eight, c: Eight) -> Eight {
        self.add(self.mul(a, b), c)
    }

    #[inline(always)]
    fn times_minus(self, a: Eight, b: Eight, c: Eight) -> Eight {
        self.sub(self.mul(a, b), c)
    }

    #[inline(always)]
    fn less_times(self, c: Eight, a: Eight, b: Eight) -> Eight {
        self.sub(c, self.mul(a, b))
    }

    #[inline(always)]
    fn min(self, a: Eight, b: Eight) -> Eight {
        each(a, b, |a, b| if a < b { a } else { b })
    }

    #[inline(always)]
    fn max(self, a: Eight, b: Eight) -> Eight {
        each(a, b, |a, b| if a > b { a } else { b })
    }

    #[inline(always)]
    fn sqrt(self, a: Eight) -> Eight {
        a.map(f32::sqrt)
    }

    #[inline(always)]
    fn negated_as(self, a: Eight, b: Eight) -> Eight {
        each(a, b, |a, b| f32::from_bits(a.to_bits() ^ (b.to_bits() & SIGN)))
    }

    #[inline(always)]
    fn at_least(self, a: Eight, b: Eight) -> u32 {
        (0..8).fold(0, |bits, lane| bits | u32::from(a[lane] >= b[lane]) << lane)
    }

    #[inline(always)]
    fn run<R>(self, body: impl FnOnce() -> R) -> R {
        body()
    }
}

/// The bit of an f32 that is its sign.
const SIGN: u32 = 1 << 31;

#[inline(always)]
fn each(a: Eight, b: Eight, f: impl Fn(f32, f32) -> f32) -> Eight {
    std::array::from_fn(|lane| f(a[lane], b[lane]))
}

/// What this processor can do best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Instructions {
    /// Eight lanes at once.
    #[cfg(target_arch = "x86_64")]
    Avx2(avx2::Avx2<true>),
    /// One lane after the other.
    Plain(Plain),
}

impl Instructions {
    /// Asks the processor.
    pub fn detected() -> Instructions {
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = avx2::Avx2::detected() {
            return Instructions::Avx2(avx2);
        }
        Instructions::Plain(Plain)
    }
}

impl Default for Instructions {
    fn default() -> Instructions {
        Instructions::Plain(Plain)
    }
}

#[cfg(target_arch = "x86_64")]
pub(super) mod avx2 {
    //! The instructions of processors with AVX2. The crate `pulp` vouches that they are there.

    use super::{Eight, Lanes, SIGN};
    use crate::geometry::processor::{self, instructions};
    use pulp::x86::V3;
    use std::arch::x86_64::{__m256, _CMP_GE_OQ};

    /// The proof that the processor has them. Operations that may be fused are so if `FUSED`: without, results are the same on every machine.
    #[derive(Clone, Copy, Debug)]
    pub(in crate::geometry::bvh) struct Avx2<const FUSED: bool>(V3);

    impl<const FUSED: bool> PartialEq for Avx2<FUSED> {
        fn eq(&self, _: &Avx2<FUSED>) -> bool {
            true
        }
    }

    impl Avx2<true> {
        /// The proof, if there is one.
        pub fn detected() -> Option<Avx2<true>> {
            processor::avx2().map(Avx2)
        }

        /// The same without fused operations.
        pub fn unfused(self) -> Avx2<false> {
            Avx2(self.0)
        }
    }

    impl<const FUSED: bool> Lanes for Avx2<FUSED> {
        type Eight = __m256;

        #[inline(always)]
        fn splat(self, x: f32) -> __m256 {
            self.0.avx._mm256_set1_ps(x)
        }

        #[inline(always)]
        fn load(self, eight: &Eight) -> __m256 {
            pulp::cast(*eight)
        }

        #[inline(always)]
        fn store(self, eight: __m256) -> Eight {
            pulp::cast(eight)
        }

        instructions! { __m256:
            add(a, b) = avx._mm256_add_ps;
            sub(a, b) = avx._mm256_sub_ps;
            mul(a, b) = avx._mm256_mul_ps;
            min(a, b) = avx._mm256_min_ps;
            max(a, b) = avx._mm256_max_ps;
            sqrt(a) = avx._mm256_sqrt_ps;
        }

        #[inline(always)]
        fn times_plus(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            if FUSED { self.0.fma._mm256_fmadd_ps(a, b, c) } else { self.add(self.mul(a, b), c) }
        }

        #[inline(always)]
        fn times_minus(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            if FUSED { self.0.fma._mm256_fmsub_ps(a, b, c) } else { self.sub(self.mul(a, b), c) }
        }

        #[inline(always)]
        fn less_times(self, c: __m256, a: __m256, b: __m256) -> __m256 {
            if FUSED { self.0.fma._mm256_fnmadd_ps(a, b, c) } else { self.sub(c, self.mul(a, b)) }
        }

        #[inline(always)]
        fn negated_as(self, a: __m256, b: __m256) -> __m256 {
            let avx = self.0.avx;
            avx._mm256_xor_ps(a, avx._mm256_and_ps(b, avx._mm256_set1_ps(f32::from_bits(SIGN))))
        }

        #[inline(always)]
        fn at_least(self, a: __m256, b: __m256) -> u32 {
            let avx = self.0.avx;
            avx._mm256_movemask_ps(avx._mm256_cmp_ps::<_CMP_GE_OQ>(a, b)) as u32
        }

        #[inline(always)]
        fn run<R>(self, body: impl FnOnce() -> R) -> R {
            self.0.vectorize(body)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a few operations make of awkward numbers.
    fn results<L: Lanes>(lanes: L) -> Vec<u32> {
        let a = lanes.load(&[0.0, -0.0, 1.0, f32::INFINITY, f32::NAN, 1e-40, 3.0, -1.5]);
        let b = lanes.load(&[-0.0, 0.0, 0.3, -1.0, 2.0, 1e-20, f32::NAN, 1e38]);
        let [one, other] = [lanes.splat(0.7), lanes.splat(-3.1)];
        let mut results = vec![lanes.at_least(a, b), lanes.at_least(b, a)];
        for eight in [
            lanes.add(a, b),
            lanes.sub(a, b),
            lanes.min(a, b),
            lanes.max(a, b),
            lanes.sqrt(b),
            lanes.negated_as(a, b),
            lanes.mul(a, b),
            lanes.add(one, lanes.sub(other, b)),
        ] {
            let number = |x: f32| if x.is_nan() { u32::MAX } else { x.to_bits() };
            results.extend(lanes.store(eight).map(number));
        }
        results
    }

    #[test]
    fn every_processor_gives_the_same_bits() {
        let plain = results(Plain);
        match Instructions::detected() {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2(avx2) => assert_eq!(avx2.run(|| results(avx2)), plain),
            Instructions::Plain(_) => assert_eq!(plain[0], 0b0000_1111),
        }
    }

    /// A product that a fused operation wouldn't round.
    #[test]
    fn unfused_lanes_round_a_product_everywhere() {
        let bits = |lanes: Eight| lanes.map(f32::to_bits);
        fn rounded<L: Lanes>(lanes: L) -> [Eight; 3] {
            let (x, one) = (lanes.splat(1.0 + f32::EPSILON), lanes.splat(1.0));
            let all = [lanes.times_plus(x, x, one), lanes.times_minus(x, x, one), lanes.less_times(one, x, x)];
            all.map(|eight| lanes.store(eight))
        }
        let plain = rounded(Plain).map(bits);
        assert_eq!(plain[1], [(2.0 * f32::EPSILON).to_bits(); 8]);
        #[cfg(target_arch = "x86_64")]
        if let Instructions::Avx2(avx2) = Instructions::detected() {
            assert_eq!(avx2.run(|| rounded(avx2.unfused())).map(bits), plain);
        }
    }
}
