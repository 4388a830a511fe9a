//! How rays are drawn: by kind, each with a name and a colour that all figures and files of lines have in common.

use crate::log::RayKind;
use crate::log::words::words;

words! {
    /// What a drawn ray is distinguished by: where it comes from, and whether it reaches what it is sent to.
    pub(super) Drawn {
        Camera = "camera",
        Reflected = "reflected",
        Transmitted = "transmitted",
        Shadow = "shadow",
        Blocked = "blocked",
    }
}

impl Drawn {
    pub fn of(kind: RayKind, is_blocked: bool) -> Drawn {
        match kind {
            _ if is_blocked => Drawn::Blocked,
            RayKind::Camera => Drawn::Camera,
            RayKind::Reflected => Drawn::Reflected,
            RayKind::Transmitted => Drawn::Transmitted,
            RayKind::Shadow { .. } => Drawn::Shadow,
        }
    }

    /// Its colour: red, green and blue as six hexadecimal digits.
    pub fn hex(self) -> &'static str {
        match self {
            Drawn::Camera => "3b4252",
            Drawn::Reflected => "1d6fb8",
            Drawn::Transmitted => "2c8a4b",
            Drawn::Shadow => "c98a00",
            Drawn::Blocked => "c0392b",
        }
    }
}
