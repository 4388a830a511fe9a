//! How the viewer looks: its colours, which hang on the terminal's background, and its characters.

use super::options::ColorChoice;
use clap::{Args, ValueEnum};
use raywalk::tui::{Background, Palette, Theme};
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use std::env;
use std::io::{self, IsTerminal};
use std::time::Duration;
use terminal_colorsaurus::{QueryOptions, ThemeMode, theme_mode};

/// How the viewer looks.
#[derive(Args, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Look {
    /// Draw the viewer with ASCII characters only
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true", value_name = "BOOL", hide_possible_values = true)]
    pub ascii: Option<bool>,
    /// The colours of the viewer; without it those of the configuration, or else auto
    #[arg(long, value_enum, value_name = "THEME")]
    pub theme: Option<ThemeChoice>,
}

/// The colours of the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ThemeChoice {
    /// As the terminal's background is, for which it is asked
    #[default]
    Auto,
    /// For a dark background
    Dark,
    /// For a light background
    Light,
    /// Only the first eight colours of the terminal's own scheme
    #[value(name = "16")]
    Sixteen,
    /// None: bold, dim and reversed text
    Mono,
}

impl Look {
    /// What is said here, and for the rest what is said there.
    pub fn over(self, other: Look) -> Look {
        Look { ascii: self.ascii.or(other.ascii), theme: self.theme.or(other.theme) }
    }

    fn choice(self) -> ThemeChoice {
        self.theme.unwrap_or_default()
    }

    /// The theme in this terminal.
    pub fn in_terminal(self, colors: ColorChoice) -> Theme {
        let palette = self.palette(has_colors(colors));
        let asks = self.choice() == ThemeChoice::Auto && palette != Palette::None;
        let is_ascii = self.ascii.unwrap_or_else(|| !has_unicode(|name| env::var(name).ok()));
        let background = if asks { background() } else { self.background() };
        Theme::new(palette, is_ascii).on(background)
    }

    /// The theme of a picture.
    pub fn in_picture(self) -> Theme {
        Theme::new(self.palette(Palette::True), self.ascii.unwrap_or_default()).on(self.background())
    }

    fn palette(self, of_terminal: Palette) -> Palette {
        match (self.choice(), of_terminal) {
            (ThemeChoice::Mono, _) | (_, Palette::None) => Palette::None,
            (ThemeChoice::Sixteen, _) => Palette::Sixteen,
            (_, palette) => palette,
        }
    }

    fn background(self) -> Background {
        if self.choice() == ThemeChoice::Light { Background::Light } else { Background::Dark }
    }
}

/// The colours that the terminal has, if any are wanted.
fn has_colors(colors: ColorChoice) -> Palette {
    let has_true_color = env::var("COLORTERM").is_ok_and(|said| said == "truecolor" || said == "24bit");
    let has_sixteen = env::var("TERM").is_ok_and(|term| term == "linux" || term.ends_with("-16color"));
    match (colors.applies_to(&io::stdout()), has_true_color) {
        (false, _) => Palette::None,
        (true, true) => Palette::True,
        (true, false) if has_sixteen => Palette::Sixteen,
        (true, false) => Palette::Indexed,
    }
}

/// Whether the terminal shows more than ASCII, as the environment says: the console of Linux has few glyphs, and a locale may have another
/// encoding. Where nothing is said it does.
fn has_unicode(variable: impl Fn(&str) -> Option<String>) -> bool {
    if variable("TERM").as_deref() == Some("linux") {
        return false;
    }
    let locale =
        ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(|name| variable(name).filter(|word| !word.is_empty()));
    locale.is_none_or(|locale| {
        let encoding = locale.to_ascii_lowercase();
        encoding.contains("utf-8") || encoding.contains("utf8")
    })
}

/// What is known of the terminal's background: by `COLORFGBG`, or else by its own answer.
fn background() -> Background {
    /// A terminal that doesn't know the question says so with the next one's answer, but some answer nothing.
    const PATIENCE: Duration = Duration::from_millis(80);
    if let Some(said) = env::var("COLORFGBG").ok().and_then(|said| of_colorfgbg(&said)) {
        return said;
    }
    // What was typed before would be taken for the answer.
    if !io::stdin().is_terminal() || is_typed() {
        return Background::Dark;
    }
    let mut options = QueryOptions::default();
    options.timeout = PATIENCE;
    match theme_mode(options) {
        Ok(ThemeMode::Light) => Background::Light,
        Ok(ThemeMode::Dark) | Err(_) => Background::Dark,
    }
}

/// Whether keys wait to be read.
fn is_typed() -> bool {
    let stdin = io::stdin();
    poll(&mut [PollFd::new(&stdin, PollFlags::IN)], Some(&Timespec { tv_sec: 0, tv_nsec: 0 }))
        .is_ok_and(|ready| ready > 0)
}

/// The background in `COLORFGBG`, such as `15;0`: the last number is that of a colour, of which 7 and those above 8 are light.
fn of_colorfgbg(said: &str) -> Option<Background> {
    let number: u8 = said.rsplit(';').next()?.parse().ok()?;
    Some(if number == 7 || (9..16).contains(&number) { Background::Light } else { Background::Dark })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colorfgbg_names_the_background_last() {
        for (said, expected) in [
            ("15;0", Some(Background::Dark)),
            ("0;15", Some(Background::Light)),
            ("0;default;15", Some(Background::Light)),
            ("12;8", Some(Background::Dark)),
            ("0;7", Some(Background::Light)),
            ("0;default", None),
            ("", None),
        ] {
            assert_eq!(of_colorfgbg(said), expected, "{said}");
        }
    }

    #[test]
    fn ascii_where_the_environment_says_so() {
        let has_unicode = |term: &str, lc_all: &str, lang: &str| {
            has_unicode(|name| match name {
                "TERM" => Some(term.to_owned()),
                "LC_ALL" => Some(lc_all.to_owned()),
                "LANG" => Some(lang.to_owned()),
                _ => None,
            })
        };
        assert!(has_unicode("xterm", "", ""));
        assert!(has_unicode("xterm", "", "es_ES.UTF-8"));
        assert!(has_unicode("xterm", "C.utf8", "POSIX"));
        assert!(!has_unicode("xterm", "C", "es_ES.UTF-8"));
        assert!(!has_unicode("xterm", "", "de_DE.ISO-8859-1"));
        assert!(!has_unicode("linux", "", "es_ES.UTF-8"));
    }

    #[test]
    fn a_theme_has_its_palette() {
        let look = |theme| Look { ascii: None, theme: Some(theme) }.in_picture();
        assert_eq!(look(ThemeChoice::Light).background, Background::Light);
        assert_eq!(look(ThemeChoice::Auto), Theme::new(Palette::True, false));
        assert_eq!(look(ThemeChoice::Sixteen).palette, Palette::Sixteen);
        assert_eq!(look(ThemeChoice::Mono).palette, Palette::None);
    }
}
