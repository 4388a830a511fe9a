//! The kinds of rays that figures tell apart, with their names and colours in every format.

use crate::log::RayKind;

/// What a ray is for, and of a shadow ray whether it reaches its light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayGroup {
    /// From the eye.
    Camera,
    /// Reflected.
    Reflected,
    /// Transmitted.
    Transmitted,
    /// To a light.
    Shadow,
    /// To a light, and blocked.
    Blocked,
}

impl RayGroup {
    /// Every one, in the order of legends and files.
    pub const ALL: [RayGroup; 5] =
        [RayGroup::Camera, RayGroup::Reflected, RayGroup::Transmitted, RayGroup::Shadow, RayGroup::Blocked];

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

    /// Its name, also that of its colour in documents of LaTeX.
    pub fn name(self) -> &'static str {
        match self {
            RayGroup::Camera => "camera",
            RayGroup::Reflected => "reflected",
            RayGroup::Transmitted => "transmitted",
            RayGroup::Shadow => "shadow",
            RayGroup::Blocked => "blocked",
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
