//! How the viewer looks: colours and glyphs. The caller decides; nothing here reads the terminal or the environment.
//!
//! Colours are those of Okabe and Ito, which colour-blind people tell apart, on the terminal's own background; on a light one darker
//! shades of them. No state is shown by a colour alone: each also has a glyph or a word.

use crate::log::{RayKind, Step};
use ratatui::style::{Color, Modifier, Style};

/// The look of the viewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Theme {
    /// Which colours the terminal has.
    pub palette: Palette,
    /// What they are seen on.
    pub background: Background,
    /// Which characters it has.
    pub glyphs: &'static Glyphs,
}

/// Which colours to use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Palette {
    /// None (`NO_COLOR`): bold, dim and reversed text only.
    None,
    /// The first eight, which a terminal's own colour scheme chooses so that they are seen on its background.
    Sixteen,
    /// The 256 colours that nearly every terminal has.
    Indexed,
    /// 24-bit colours.
    True,
}

/// The background of the terminal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Background {
    /// Dark, as that of most terminals.
    #[default]
    Dark,
    /// Light.
    Light,
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
    breakpoint: "◆", "&";
}

impl Theme {
    /// The look with these colours, in ASCII or not.
    pub fn new(palette: Palette, ascii: bool) -> Theme {
        Theme { palette, background: Background::Dark, glyphs: if ascii { &ASCII } else { &UNICODE } }
    }

    /// The same on this background.
    pub fn on(self, background: Background) -> Theme {
        Theme { background, ..self }
    }

    /// Whether only ASCII may be shown.
    pub fn is_ascii(&self) -> bool {
        *self.glyphs == ASCII
    }

    /// Whether it can't show the colours of a picture.
    pub fn has_few_colors(&self) -> bool {
        matches!(self.palette, Palette::None | Palette::Sixteen)
    }

    /// How something with this role is written.
    pub fn style(&self, role: Role) -> Style {
        let modifier = match role {
            Role::Title | Role::Current | Role::Warning | Role::Value => Modifier::BOLD,
            // Dimmed, black text on white is too pale in some terminals: there it is grey.
            Role::Faint if self.color(role).is_none() => Modifier::DIM,
            _ => Modifier::empty(),
        };
        let style = Style::new().add_modifier(modifier);
        self.color(role).map_or(style, |color| style.fg(color))
    }

    /// The colour of a role; `None` for the terminal's own.
    fn color(&self, role: Role) -> Option<Color> {
        // Of the 16, of the 256 and in full; the last two on a dark background and on a light one.
        let (named, dark, light) = match role {
            Role::Text | Role::Title | Role::Value => return None,
            Role::Faint if self.background == Background::Light => (None, (0, 0), (241, 0x626262)),
            Role::Faint => return None,
            Role::Camera => (Some(Color::Blue), (74, 0x56B4E9), (25, 0x00619A)),
            Role::Reflected | Role::Hit => (Some(Color::Green), (36, 0x009E73), (23, 0x006B4E)),
            Role::Transmitted => (Some(Color::Magenta), (175, 0xCC79A7), (126, 0x9C3F75)),
            Role::Shadow => (Some(Color::Yellow), (172, 0xC78300), (94, 0x7D5200)),
            Role::Light | Role::Current => (Some(Color::Yellow), (214, 0xE69F00), (94, 0x875D00)),
            Role::Blocked | Role::Warning => (Some(Color::Red), (166, 0xD55E00), (124, 0xA84A00)),
        };
        let (index, rgb) = if self.background == Background::Light { light } else { dark };
        match self.palette {
            Palette::None => None,
            Palette::Sixteen => named,
            Palette::Indexed => Some(Color::Indexed(index)),
            Palette::True => Some(Color::from_u32(rgb)),
        }
    }

    /// The colour of lines that stand back.
    pub fn line(&self) -> Color {
        match (self.palette, self.background) {
            (Palette::None | Palette::Sixteen, _) => Color::Reset,
            (_, Background::Dark) => Color::Indexed(244),
            (_, Background::Light) => Color::Indexed(242),
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    const ROLES: [Role; 13] = [
        Role::Text,
        Role::Title,
        Role::Faint,
        Role::Camera,
        Role::Reflected,
        Role::Transmitted,
        Role::Shadow,
        Role::Light,
        Role::Hit,
        Role::Blocked,
        Role::Value,
        Role::Current,
        Role::Warning,
    ];

    /// The relative luminance of WCAG 2.1.
    fn luminance(color: [u8; 3]) -> f64 {
        let [r, g, b] = color.map(|level| match f64::from(level) / 255.0 {
            low if low <= 0.04045 => low / 12.92,
            high => libm::pow((high + 0.055) / 1.055, 2.4),
        });
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    fn contrast(one: [u8; 3], other: [u8; 3]) -> f64 {
        let [one, other] = [one, other].map(luminance);
        (one.max(other) + 0.05) / (one.min(other) + 0.05)
    }

    fn rgb(color: Color) -> [u8; 3] {
        match color {
            Color::Rgb(r, g, b) => [r, g, b],
            Color::Indexed(index) => of_index(index),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn contrast_is_that_of_the_standard() {
        assert_eq!(contrast([255; 3], [0; 3]), 21.0);
        // The standard's own example of a grey that is just enough.
        assert!((contrast([255; 3], [0x76; 3]) - 4.54).abs() < 0.005);
    }

    #[test]
    fn every_role_is_seen_on_its_background() {
        const SOLARIZED: [[u8; 3]; 2] = [[0x00, 0x2b, 0x36], [0xfd, 0xf6, 0xe3]];
        for (background, own, solarized) in
            [(Background::Dark, [0; 3], SOLARIZED[0]), (Background::Light, [255; 3], SOLARIZED[1])]
        {
            for palette in [Palette::Indexed, Palette::True] {
                let theme = Theme::new(palette, false).on(background);
                for (role, color) in ROLES.into_iter().filter_map(|role| Some((role, theme.style(role).fg?))) {
                    let seen = contrast(rgb(color), own);
                    assert!(seen >= 4.5, "{role:?} on {background:?}, {palette:?}: {seen}");
                    let seen = contrast(rgb(color), solarized);
                    assert!(seen >= 3.0, "{role:?} on Solarized {background:?}, {palette:?}: {seen}");
                }
            }
        }
    }

    #[test]
    fn of_the_sixteen_only_those_that_no_scheme_uses_for_backgrounds() {
        let theme = Theme::new(Palette::Sixteen, false);
        let colors = ROLES.into_iter().filter_map(|role| theme.style(role).fg);
        let known = [Color::Red, Color::Green, Color::Yellow, Color::Blue, Color::Magenta];
        assert!(colors.into_iter().all(|color| known.contains(&color)));
    }
}
