//! The configuration of the viewer: what a user wants of it in every call. Options of the command line win over it.
//!
//! Only a viewer in a terminal reads it unasked: what a call writes to a file or a pipe depends on the call alone.

mod print;
mod read;

use super::failure::Failure;
use super::look::Look;
use super::views::Lang;
use clap::Args;
use etcetera::{BaseStrategy, choose_base_strategy};
use raywalk::files::{Wanted, is_there};
use raywalk::report::Style;
use raywalk::tui::{Bindings, Controls};
use std::env;
use std::path::{Path, PathBuf};

/// The largest configuration file.
pub const MAX_CONFIG_BYTES: u64 = 1 << 18;

/// The environment variable with its path.
const VARIABLE: &str = "RAYWALK_CONFIG";

/// The word for no file.
const NONE: &str = "none";

/// Which configuration the viewer has.
#[derive(Args, Clone, Debug, Default, PartialEq)]
pub struct ConfigChoice {
    /// The viewer's configuration file, or `none`; without it RAYWALK_CONFIG, or else raywalk/config.toml in the folder for
    /// configurations ($XDG_CONFIG_HOME or ~/.config)
    #[arg(long, value_name = "FILE or none")]
    config: Option<PathBuf>,
}

/// What a user wants of the viewer.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// How it looks.
    pub look: Look,
    /// Whether the mouse selects and scrolls at first.
    pub has_mouse: bool,
    /// Its language.
    pub language: Lang,
    /// Decimals.
    pub digits: u32,
    /// The keys.
    pub bindings: Bindings,
}

impl Default for Config {
    fn default() -> Config {
        Config {
            look: Look::default(),
            has_mouse: false,
            language: Lang::default(),
            digits: Style::default().digits,
            bindings: Bindings::default(),
        }
    }
}

impl Config {
    /// What the viewer reacts to.
    pub fn controls(&self) -> Controls {
        Controls { bindings: self.bindings.clone(), has_mouse: self.has_mouse }
    }
}

impl ConfigChoice {
    /// Whether the call itself says which.
    pub fn is_named(&self) -> bool {
        self.config.is_some()
    }

    /// Reads the configuration. Where no file is named there may be none.
    ///
    /// # Errors
    /// It is named and isn't there, can't be read, or says what it can't.
    pub fn read(&self) -> Result<Config, Failure> {
        let variable = env::var_os(VARIABLE).filter(|path| !path.is_empty()).map(PathBuf::from);
        let (path, is_named) = match self.config.clone().or(variable) {
            Some(path) if path == Path::new(NONE) => return Ok(Config::default()),
            Some(path) if path == Path::new("-") => {
                return Err(Failure::caller("--config -: expected a file, or `none` for no configuration"));
            }
            Some(path) => (path, true),
            None => match usual_place() {
                Some(path) => (path, false),
                None => return Ok(Config::default()),
            },
        };
        if !is_named && is_there(&path).is_ok_and(|is_there| !is_there) {
            return Ok(Config::default());
        }
        let wanted = Wanted { what: "a configuration file", max_bytes: MAX_CONFIG_BYTES };
        let read = wanted.read(&path).and_then(|text| read::config(&text, &path.to_string_lossy()));
        read.map_err(|error| Failure::scene(&error).with_note("--config none ignores the file"))
    }
}

/// Where the configuration is unless something else is said; nowhere where there is no home.
fn usual_place() -> Option<PathBuf> {
    Some(choose_base_strategy().ok()?.config_dir().join("raywalk").join("config.toml"))
}
