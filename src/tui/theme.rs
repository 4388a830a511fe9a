//! How the viewer looks: colours and glyphs. The caller decides; nothing here reads the terminal or the environment.
//!
//! Colours are those of Okabe and Ito, which colour-blind people tell apart, on the terminal's own background. No state
//! is shown by a colour alone: each also has a glyph or a word.

use crate::log::{RayKind, Step};
use ratatui::style::{Color, Modifier, Style};

/// The look of the viewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Theme {
    /// Which colours the terminal has.
    pub palette: Palette,
    /// Which characters it has.
    pub glyphs: &'static Glyphs,
}

/// Which colours to use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Palette {
    /// None (`NO_COLOR`): bold, dim and reversed text only.
    None,
    /// The 256 colours that nearly every terminal has.
    Indexed,
    /// 24-bit colours.
    True,
}

/// What a piece of the screen stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Ordinary text.
    Text,
    /// The name of a pane.
    Title,
    /// Frames, hints, and what stands back.
    Faint,
    /// A camera ray.
    Camera,
    /// A reflected ray.
    Reflected,
    /// A transmitted ray.
    Transmitted,
    /// A shadow ray.
    Shadow,
    /// A light.
    Light,
    /// A hit.
    Hit,
    /// What isn't reached: occlusion, depth limits.
    Blocked,
    /// A computed value.
    Value,
    /// The current step.
    Current,
    /// A warning.
    Warning,
}

/// Declares the characters that stand for something: the usual one of each, and one for terminals and fonts that have ASCII only.
macro_rules! glyphs {
    ($($name:ident: $usual:literal, $ascii:literal;)*) => {
        /// Characters that stand for something.
        #[derive(Debug, PartialEq, Eq)]
        #[allow(missing_docs)]
        pub struct Glyphs {
            $(pub $name: &'static str,)*
        }

        /// The usual characters.
        pub const UNICODE: Glyphs = Glyphs { $($name: $usual,)* };
        /// Characters for terminals and fonts that have ASCII only.
        pub const ASCII: Glyphs = Glyphs { $($name: $ascii,)* };
    };
}

glyphs! {
    open: "▾", "-";
    closed: "▸", "+";
    leaf: "╴", " ";
    branch: "├", "|";
    last_branch: "└", "`";
    trunk: "│", "|";
    horizontal: "─", "-";
    vertical: "│", "|";
    tee: "┬", "+";
    pixel: "▣", "#";
    sample: "▫", ".";
    camera: "◉", "@";
    reflected: "↗", "/";
    transmitted: "↘", "\\";
    shadow: "⇡", "^";
    test: "?", "?";
    shade: "◐", "%";
    light: "☼", "*";
    combine: "Σ", "=";
    hit: "●", "o";
    miss: "○", "-";
    blocked: "✕", "x";
    current: "▶", ">";
    more: "…", "~";
    cut_left: "…", "<";
    cut_right: "…", ">";
    differs: "≠", "!";
}

impl Theme {
    /// The look with these colours, in ASCII or not.
    pub fn new(palette: Palette, ascii: bool) -> Theme {
        Theme { palette, glyphs: if ascii { &ASCII } else { &UNICODE } }
    }

    /// Whether only ASCII may be shown.
    pub fn is_ascii(&self) -> bool {
        *self.glyphs == ASCII
    }

    /// How something with this role is written.
    pub fn style(&self, role: Role) -> Style {
        let color = match role {
            Role::Text | Role::Title | Role::Faint | Role::Value => None,
            Role::Camera => Some((74, 0x56B4E9)),
            Role::Reflected | Role::Hit => Some((36, 0x009E73)),
            Role::Transmitted => Some((175, 0xCC79A7)),
            Role::Shadow => Some((172, 0xC78300)),
            Role::Light | Role::Current => Some((214, 0xE69F00)),
            Role::Blocked | Role::Warning => Some((166, 0xD55E00)),
        };
        let color = color.and_then(|(index, rgb)| match self.palette {
            Palette::None => None,
            Palette::Indexed => Some(Color::Indexed(index)),
            Palette::True => Some(Color::from_u32(rgb)),
        });
        let modifier = match role {
            Role::Title | Role::Current | Role::Warning | Role::Value => Modifier::BOLD,
            Role::Faint => Modifier::DIM,
            _ => Modifier::empty(),
        };
        let style = Style::new().add_modifier(modifier);
        color.map_or(style, |color| style.fg(color))
    }

    /// The glyph and the role of a kind of rays.
    pub fn of_ray(&self, kind: RayKind) -> (&'static str, Role) {
        match kind {
            RayKind::Camera => (self.glyphs.camera, Role::Camera),
            RayKind::Reflected => (self.glyphs.reflected, Role::Reflected),
            RayKind::Transmitted => (self.glyphs.transmitted, Role::Transmitted),
            RayKind::Shadow { .. } => (self.glyphs.shadow, Role::Shadow),
        }
    }

    /// The glyph and the role of a node; the root is a pixel.
    pub fn of_step(&self, step: Option<Step>) -> (&'static str, Role) {
        let glyphs = self.glyphs;
        match step {
            None | Some(Step::Pixel(_)) => (glyphs.pixel, Role::Title),
            Some(Step::Sample { .. }) => (glyphs.sample, Role::Text),
            Some(Step::Ray { kind, .. }) => self.of_ray(kind),
            Some(Step::Test { .. } | Step::Motion { .. }) => (glyphs.test, Role::Faint),
            Some(Step::Zone { .. }) => (glyphs.sample, Role::Text),
            Some(Step::Shade { .. }) => (glyphs.shade, Role::Text),
            Some(Step::Light { .. }) => (glyphs.light, Role::Light),
            Some(Step::Combine) => (glyphs.combine, Role::Text),
        }
    }
}

/// The colours of a terminal with 256 of them: 16 with names, a cube of 6 × 6 × 6, and greys.
pub fn of_index(index: u8) -> [u8; 3] {
    match index {
        0..=15 => {
            let strong = if index < 8 { 0xaa } else { 0xff };
            let weak = if index < 8 { 0x00 } else { 0x55 };
            let channel = |bit: u8| if index >> bit & 1 == 1 { strong } else { weak };
            [0, 1, 2].map(channel)
        }
        16..=231 => {
            let level = |digit: u8| if digit == 0 { 0 } else { 55 + 40 * digit };
            let cube = index - 16;
            [cube / 36, cube / 6 % 6, cube % 6].map(level)
        }
        232..=255 => [8 + 10 * (index - 232); 3],
    }
}
