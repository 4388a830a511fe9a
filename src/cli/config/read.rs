//! Reading a configuration: every mistake with its place, and what was perhaps meant.

use super::Config;
use clap::ValueEnum;
use clap::builder::PossibleValue;
use raywalk::files::escape::quoted;
use raywalk::files::{FileError, KeyPath, Problem, Source, one_of, suggest, unknown, without_mark};
use raywalk::report::Style;
use raywalk::tui;
use raywalk::tui::Chord;
use raywalk::tui::keys::{self, Refused};
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The keys of the file, in the order in which it is printed.
pub(super) const KEYS: [&str; 7] = ["theme", "ascii", "mouse", "language", "digits", "keys", "keys-in-lists"];

/// The most mistakes that are shown.
const MOST_PROBLEMS: usize = 20;

/// The configuration in a text.
pub(super) fn config(text: &[u8], name: &str) -> Result<Config, FileError> {
    let text = without_mark(text);
    let source = Source { name, text };
    let text = str::from_utf8(text).map_err(|error| {
        let at = error.valid_up_to();
        FileError::from(source.problem(at..at + 1, KeyPath::default(), "expected text in UTF-8".to_owned()))
    })?;
    let (table, errors) = DeTable::parse_recoverable(text);
    let mut reader = Reader { source, problems: Vec::new(), config: Config::default() };
    for error in &errors {
        reader.complain(error.span().unwrap_or(0..0), KeyPath::default(), error.message().to_owned());
    }
    // Of what is no TOML no more can be said.
    if errors.is_empty() {
        reader.table(table.get_ref());
    }
    reader.problems.sort_by_key(|problem| (problem.line, problem.column));
    let omitted = reader.problems.len().saturating_sub(MOST_PROBLEMS);
    reader.problems.truncate(MOST_PROBLEMS);
    match reader.problems {
        problems if problems.is_empty() => Ok(reader.config),
        problems => Err(FileError::Invalid { problems, omitted }),
    }
}

struct Reader<'t> {
    source: Source<'t>,
    problems: Vec<Problem>,
    config: Config,
}

/// A value and where it stands.
type Value<'t> = Spanned<DeValue<'t>>;

impl Reader<'_> {
    fn complain(&mut self, span: Range<usize>, path: KeyPath, message: String) {
        self.problems.push(self.source.problem(span, path, message));
    }

    fn table(&mut self, table: &DeTable) {
        for (key, value) in table {
            let (name, path) = (key.get_ref().as_ref(), KeyPath::default().join(key.get_ref().to_string()));
            match name {
                "theme" => self.config.look.theme = self.word(value, path),
                "ascii" => self.config.look.ascii = self.truth(value, path),
                "mouse" => self.config.has_mouse = self.truth(value, path).unwrap_or_default(),
                "language" => self.config.language = self.word(value, path).unwrap_or_default(),
                "digits" => self.config.digits = self.digits(value, path).unwrap_or_default(),
                "keys" => self.keys(value, path, false),
                "keys-in-lists" => self.keys(value, path, true),
                _ => self.complain(key.span(), KeyPath::default(), unknown("key", name, &KEYS)),
            }
        }
    }

    /// A value is of another kind than expected.
    fn expected(&mut self, what: &str, value: &Value, path: KeyPath) {
        let found = match value.get_ref() {
            DeValue::String(text) => format!("the text {}", quoted(text)),
            DeValue::Integer(number) => format!("the number {}", quoted(number.as_str())),
            DeValue::Float(number) => format!("the number {}", quoted(number.as_str())),
            DeValue::Boolean(truth) => format!("`{truth}`"),
            DeValue::Datetime(_) => "a date".to_owned(),
            DeValue::Array(_) => "an array".to_owned(),
            DeValue::Table(_) => "a table".to_owned(),
        };
        self.complain(value.span(), path, format!("expected {what}, found {found}"));
    }

    /// One of some words.
    fn word<T: ValueEnum>(&mut self, value: &Value, path: KeyPath) -> Option<T> {
        let known: Vec<_> = T::value_variants().iter().filter_map(ValueEnum::to_possible_value).collect();
        let known: Vec<_> = known.iter().map(PossibleValue::get_name).collect();
        let found = value.get_ref().as_str();
        let word = found.and_then(|word| T::from_str(word, false).ok());
        match found {
            Some(found) if word.is_none() => self.complain(value.span(), path, unknown("word", found, &known)),
            None => self.expected(&one_of(known.iter().map(|word| format!("\"{word}\""))), value, path),
            Some(_) => {}
        }
        word
    }

    fn truth(&mut self, value: &Value, path: KeyPath) -> Option<bool> {
        let truth = value.get_ref().as_bool();
        if truth.is_none() {
            self.expected("true or false", value, path);
        }
        truth
    }

    fn digits(&mut self, value: &Value, path: KeyPath) -> Option<u32> {
        let number = value.get_ref().as_integer();
        let number = number.and_then(|number| u32::from_str_radix(number.as_str(), number.radix()).ok());
        let number = number.filter(|number| *number <= Style::MOST_DIGITS);
        if number.is_none() {
            self.expected(&format!("a whole number from 0 to {}", Style::MOST_DIGITS), value, path);
        }
        number
    }

    /// The keys in the panes, or in lists whose entries can be deleted.
    fn keys(&mut self, value: &Value, path: KeyPath, in_lists: bool) {
        let DeValue::Table(table) = value.get_ref() else {
            return self.expected("a table of keys, such as \"^n\" = \"next-value\"", value, path);
        };
        let mut places: BTreeMap<Chord, Range<usize>> = BTreeMap::new();
        for (key, value) in table {
            let path = path.join(key.get_ref().to_string());
            let Some(to) = value.get_ref().as_str() else {
                self.expected("the name of an action, \"none\", or a command that begins with `:`", value, path);
                continue;
            };
            let bindings = &mut self.config.bindings;
            let bound = match in_lists {
                true => keys::bind_in_lists(bindings, key.get_ref(), to),
                false => keys::bind(bindings, key.get_ref(), to, tui::check_command),
            };
            match bound {
                Ok(chord) => {
                    if places.insert(chord.clone(), key.span()).is_some() {
                        let message = format!("{} is bound twice, spelt differently", quoted(&chord.text()));
                        self.complain(key.span(), path, message);
                    }
                }
                Err(why @ (Refused::NoKey(_) | Refused::Fixed)) => {
                    self.complain(key.span(), path, words(&why, key.get_ref(), to, in_lists));
                }
                Err(why) => self.complain(value.span(), path, words(&why, key.get_ref(), to, in_lists)),
            }
        }
        if in_lists {
            return;
        }
        for [alone, pair] in keys::clashes(&self.config.bindings) {
            let span = places.get(&alone).or(places.get(&pair)).cloned().unwrap_or_else(|| value.span());
            let (one, both) = (quoted(&alone.text()), quoted(&pair.text()));
            let message =
                format!("{one} does something alone, and {both} begins with it: bind one of them to \"none\"");
            self.complain(span, path.clone(), message);
        }
        if !keys::has_way_out(&self.config.bindings) {
            let message = "no key is left that leaves the viewer: `quit`, `interrupt` or `command` needs one";
            self.complain(value.span(), path, message.to_owned());
        }
    }
}

/// Why a key can't be bound so.
fn words(why: &Refused, key: &str, to: &str, in_lists: bool) -> String {
    const LISTED: &str = "`raywalk walk --config none --print-config` lists all";
    match why {
        Refused::NoKey(near) => {
            let near = near.map_or(String::new(), |near| format!(", did you mean `{near}`?"));
            format!(
                "no key is called {}{near}; expected a key such as n, ^n, F3 or PgDn, or two characters",
                quoted(key)
            )
        }
        Refused::Fixed => "Esc and Enter stay as they are, and digits begin counts".to_owned(),
        Refused::NeedsCharacter => format!("a letter follows {}, whose key must be a character", quoted(to)),
        Refused::OfLists => format!("{} is for the table `keys-in-lists`", quoted(to)),
        Refused::Line(why) => why.clone(),
        Refused::NoAction => {
            let known = keys::names(in_lists);
            let near = suggest(to, known.iter().map(String::as_str));
            let near = near.map_or(String::new(), |near| format!(", did you mean `{near}`?"));
            let own = if in_lists { one_of(known.iter().map(|name| format!("`{name}`"))) } else { LISTED.to_owned() };
            format!("no action is called {}{near}; {own}", quoted(to))
        }
    }
}

#[cfg(test)]
mod tests;
