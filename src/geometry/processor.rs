//! What the processor can do, found out once and in one place.

#[cfg(target_arch = "x86_64")]
use pulp::x86::V3;
#[cfg(target_arch = "x86_64")]
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering};

static IS_PLAIN: AtomicBool = AtomicBool::new(false);

/// Keeps to what every processor has. Results don't depend on it, and tests ask both ways for the same. To be called before anything else:
/// what is made up already stays.
pub fn keep_to_plain_instructions() {
    IS_PLAIN.store(true, Ordering::Relaxed);
}

/// The instructions of AVX2 with fused operations, where the processor has them and they are wanted.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(crate) fn avx2() -> Option<V3> {
    static AVX2: LazyLock<Option<V3>> =
        LazyLock::new(|| if IS_PLAIN.load(Ordering::Relaxed) { None } else { V3::try_new() });
    *AVX2
}

/// Methods that are one instruction each, such as `add(a, b) = avx._mm256_add_ps`: the proof that the processor has it is `self.0`.
#[cfg(target_arch = "x86_64")]
macro_rules! instructions {
    ($lanes:ty: $($method:ident($($x:ident),*) = $set:ident.$instruction:ident$(::<$kind:ident>)?;)*) => {
        $(
            #[inline(always)]
            fn $method(self, $($x: $lanes),*) -> $lanes {
                self.0.$set.$instruction$(::<$kind>)?($($x),*)
            }
        )*
    };
}

#[cfg(target_arch = "x86_64")]
pub(crate) use instructions;
