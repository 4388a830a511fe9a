//! What the processor can do, found out once and in one place.

#[cfg(target_arch = "x86_64")]
use pulp::x86::V3;
use std::ffi::OsString;
#[cfg(target_arch = "x86_64")]
use std::sync::LazyLock;

/// The environment variable that keeps the program from the processor's best instructions. Results don't depend on them, and tests ask
/// both ways for the same.
pub const LANES: &str = "RAYWALK_LANES";

/// What [`LANES`] may say, if anything.
pub const PLAIN: &str = "plain";

/// What [`LANES`] says, if it isn't known.
pub fn unknown_lanes() -> Option<OsString> {
    std::env::var_os(LANES).filter(|lanes| !lanes.is_empty() && lanes != PLAIN)
}

/// The instructions of AVX2 with fused operations, where the processor has them and they are wanted.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(crate) fn avx2() -> Option<V3> {
    static AVX2: LazyLock<Option<V3>> =
        LazyLock::new(
            || if std::env::var_os(LANES).is_some_and(|lanes| lanes == PLAIN) { None } else { V3::try_new() },
        );
    *AVX2
}
