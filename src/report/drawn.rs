//! How rays are drawn: by kind, each with a name and a colour that all figures and files of lines have in common.

use crate::log::RayKind;

/// What a drawn ray is distinguished by: where it comes from, and whether it reaches what it is sent to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Drawn {
    Camera,
    Reflected,
    Transmitted,
    Shadow,
    Blocked,
}

impl Drawn {
    /// In the order of legends and files.
    pub const ALL: [Drawn; 5] = [Drawn::Camera, Drawn::Reflected, Drawn::Transmitted, Drawn::Shadow, Drawn::Blocked];

    pub fn of(kind: RayKind, is_blocked: bool) -> Drawn {
        match kind {
            _ if is_blocked => Drawn::Blocked,
            RayKind::Camera => Drawn::Camera,
            RayKind::Reflected => Drawn::Reflected,
            RayKind::Transmitted => Drawn::Transmitted,
            RayKind::Shadow { .. } => Drawn::Shadow,
        }
    }

    /// What its colour is called in documents.
    pub fn name(self) -> &'static str {
        match self {
            Drawn::Camera => "camera",
            Drawn::Reflected => "reflected",
            Drawn::Transmitted => "transmitted",
            Drawn::Shadow => "shadow",
            Drawn::Blocked => "blocked",
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
