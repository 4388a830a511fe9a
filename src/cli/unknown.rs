//! Words that options don't know.

use raywalk::files::suggest;

/// The message about a word that isn't among the known ones.
pub fn unknown(what: &str, found: &str, known: &[&str]) -> String {
    let near = suggest(found, known.iter().copied()).map(|near| format!("; did you mean `{near}`?"));
    format!("unknown {what} `{found}`, expected {}{}", known.join(", "), near.unwrap_or_default())
}
