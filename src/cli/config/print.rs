//! A configuration as a file that says the same, with what everything is for.

use super::Config;
use clap::ValueEnum;
use raywalk::files::escape_hidden;
use raywalk::report::Style;
use raywalk::report::language::Language;
use raywalk::tui::keys::{self, NOTHING, Row};
use std::fmt::Write;

impl Config {
    /// The file.
    pub fn file(&self) -> String {
        let help = &Language::English.texts().viewer.help;
        let mut file = format!(
            "# The configuration of raywalk's viewer: `raywalk walk` and `raywalk diff --walk` read it.\n\
             # Its place is raywalk/config.toml in $XDG_CONFIG_HOME, or in ~/.config where that isn't set; RAYWALK_CONFIG and\n\
             # --config name another file, or `none`. Options of the command line win over it. Every line may be left out.\n\
             \n# The colours: auto (as the terminal's background is), dark, light, 16 or mono.\ntheme = {}\n\
             \n# Only ASCII characters. Without this line as the terminal and the locale allow.\n{}ascii = {}\n\
             \n# Whether the mouse selects and scrolls at first.\nmouse = {}\n\
             \n# The language: en or es.\nlanguage = {}\n\
             \n# Decimals, 0 to {}.\ndigits = {}\n\
             \n# Keys, each with the name of what it does. A key is written as in --keys: a character, `^` or `ctrl-` and a letter, a\n\
             # name such as PgDn, Space or F3, or two characters. \"{NOTHING}\" takes what it does from a key; a command that begins with\n\
             # `:`, such as \":pixel 10,20\", is typed by it. Esc and Enter stay as they are, and digits begin counts.\n[keys]\n",
            word(&self.look.theme.unwrap_or_default()),
            if self.look.ascii.is_none() { "# " } else { "" },
            self.look.ascii.unwrap_or_default(),
            self.has_mouse,
            word(&self.language),
            Style::MOST_DIGITS,
            self.digits,
        );
        let mut group = None;
        for row in keys::rows().filter(|row| !row.is_of_lists()) {
            let title = (row.group)(&help.groups);
            if group.replace(title) != Some(title) {
                let _ = writeln!(file, "\n# {title}");
            }
            self.add_row(&mut file, row, (row.help)(&help.keys));
        }
        let lines: Vec<_> = self.bindings.lines().collect();
        if !lines.is_empty() {
            let _ = writeln!(file, "\n# {}", help.groups.own);
        }
        for (chord, line) in lines {
            let _ = writeln!(file, "{} = {}", text(&chord.text()), text(&format!(":{line}")));
        }
        let _ = writeln!(file, "\n# In the lists of breakpoints and bookmarks\n[keys-in-lists]");
        for row in keys::rows().filter(|row| row.is_of_lists()) {
            self.add_row(&mut file, row, (row.help)(&help.keys));
        }
        file
    }

    /// The keys of a row: those that it has now, and those that it has no longer.
    fn add_row(&self, file: &mut String, row: &Row, said: &str) {
        let bare = |key: &str| key.strip_suffix(keys::ANY_LETTER).unwrap_or(key).to_owned();
        let now = keys::in_force(&self.bindings, row);
        let after = if row.takes_letter() { ", with the letter that follows" } else { "" };
        for (number, key) in now.iter().enumerate() {
            let comment = if number == 0 { format!("  # {said}{after}") } else { String::new() };
            let _ = writeln!(file, "{} = {}{comment}", text(&bare(key)), text(&row.name()));
        }
        if now.is_empty() {
            let _ = writeln!(file, "# no key = {}  # {said}{after}", text(&row.name()));
        }
        let is_free = |key: &&&str| keys::chord(&bare(key)).is_some_and(|chord| self.bindings.is_unbound(&chord));
        for key in row.keys.iter().filter(is_free) {
            let _ = writeln!(file, "{} = {}", text(&bare(key)), text(NOTHING));
        }
    }
}

/// The word for a value.
fn word(value: &impl ValueEnum) -> String {
    text(value.to_possible_value().as_ref().map_or("", |value| value.get_name()))
}

/// A text in quotation marks, with nothing in it that could drive a terminal.
fn text(text: &str) -> String {
    let mut quoted = String::from('"');
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            _ if escape_hidden(character.encode_utf8(&mut [0; 4])).chars().eq([character]) => quoted.push(character),
            _ => _ = write!(quoted, "\\U{:08X}", u32::from(character)),
        }
    }
    quoted + "\""
}
