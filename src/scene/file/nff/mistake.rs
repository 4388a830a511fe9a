//! What is wrong with an NFF text, in sentences.

use std::ops::Range;

use super::tokens::Token;
use crate::files::escape;
use crate::files::{KeyPath, Problem, Source, suggest};

/// Something about a place of the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mistake {
    /// The place in bytes.
    pub span: Range<usize>,
    /// What is wrong, what was expected.
    pub message: String,
}

impl Mistake {
    /// The mistake of a token.
    pub fn at(token: &Token, message: impl Into<String>) -> Self {
        Self { span: token.span(), message: message.into() }
    }

    /// The mistake with its line.
    pub fn problem(&self, source: &Source) -> Problem {
        source.problem(self.span.clone(), KeyPath::default(), self.message.clone())
    }
}

/// The entities, and the words that people might take for them.
const WORDS: &[(&str, &str)] = &[
    ("background", "b"),
    ("view", "v"),
    ("viewpoint", "v"),
    ("camera", "v"),
    ("light", "l"),
    ("fill", "f"),
    ("color", "f"),
    ("material", "f"),
    ("cone", "c"),
    ("cylinder", "c"),
    ("sphere", "s"),
    ("polygon", "p"),
    ("triangle", "p"),
    ("patch", "pp"),
    ("pp", "pp"),
    ("tpp", "tpp"),
    ("tess", "tess"),
    ("shader", "shader"),
];

const ENTITIES: &str = "`b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp`";

/// A token where an entity should be; `latest` is the entity that has ended here, with what it takes.
pub fn no_entity(token: &Token, latest: Option<(&str, &str)>) -> Mistake {
    let shown = quoted(token);
    if token.number().is_some() {
        let takes = latest.map_or(String::new(), |(entity, takes)| format!(" (`{entity}` takes {takes})"));
        return Mistake::at(token, format!("expected an entity, {ENTITIES}, found the number {shown}{takes}"));
    }
    let word = String::from_utf8_lossy(token.text);
    if ["from", "at", "up", "angle", "hither", "resolution"].contains(&&*word) {
        return Mistake::at(token, format!("{shown} belongs to a view, expected `v` before it"));
    }
    if word.starts_with('{') {
        return Mistake::at(token, format!("found {shown} as in JSON, expected an entity of NFF, {ENTITIES}"));
    }
    let message = match meant(&word) {
        Some(meant) => format!("unknown entity {shown}, did you mean `{meant}`? expected {ENTITIES}"),
        None => format!("unknown entity {shown}, expected {ENTITIES}"),
    };
    Mistake::at(token, message)
}

fn meant(word: &str) -> Option<&'static str> {
    let lower = word.to_ascii_lowercase();
    if let Some(entity) = ["b", "v", "l", "f", "c", "s", "p"].into_iter().find(|entity| *entity == lower) {
        return Some(entity);
    }
    // Next to one letter every other letter is near.
    let word = suggest(&lower, WORDS.iter().map(|(word, _)| *word)).filter(|_| lower.len() > 1)?;
    WORDS.iter().find(|(known, _)| *known == word).map(|(_, entity)| *entity)
}

/// Something else where a number should be.
pub fn no_number(found: Option<&Token>, end: usize, entity: &str, what: &str) -> Mistake {
    let wanted = format!("expected a number for {what} of `{entity}`");
    match found {
        Some(token) => Mistake::at(token, format!("{wanted}, found {}", quoted(token))),
        None => Mistake { span: end..end, message: format!("{wanted}, found the end of the file") },
    }
}

/// A token as a message repeats it.
pub fn quoted(token: &Token) -> String {
    escape::quoted(&String::from_utf8_lossy(token.text))
}
