//! The kinds of rays that figures tell apart, with their names and colours in every format.

use crate::log::RayKind;
use crate::log::words::words;

words! {
    /// What a ray is for, and of a shadow ray whether it reaches its light, in the order of legends and files. A word is also the name of the
    /// colour in documents of LaTeX.
    pub RayGroup {
        /// From the eye.
        Camera = "camera",
        /// Reflected.
        Reflected = "reflected",
        /// Transmitted.
        Transmitted = "transmitted",
        /// To a light.
        Shadow = "shadow",
        /// To a light, and blocked.
        Blocked = "blocked",
    }
}

impl RayGroup {
    /// The group of a ray.
    pub fn of(kind: RayKind, is_blocked: bool) -> RayGroup {
        match kind {
            _ if is_blocked => RayGroup::Blocked,
            RayKind::Camera => RayGroup::Camera,
            RayKind::Reflected => RayGroup::Reflected,
            RayKind::Transmitted => RayGroup::Transmitted,
            RayKind::Shadow { .. } => RayGroup::Shadow,
        }
    }

    /// Its colour as six hexadecimal digits.
    pub fn hex(self) -> &'static str {
        match self {
            RayGroup::Camera => "3b4252",
            RayGroup::Reflected => "1d6fb8",
            RayGroup::Transmitted => "2c8a4b",
            RayGroup::Shadow => "c98a00",
            RayGroup::Blocked => "c0392b",
        }
    }
}
