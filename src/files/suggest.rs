//! Unknown words: "did you mean …?"

use super::escape::quoted;

/// The message about a word that isn't among the known ones: "unknown key `x`, did you mean `b`? expected `a`, `b` or `c`".
pub fn unknown(what: &str, found: &str, known: &[&str]) -> String {
    let shown = quoted(found);
    let expected = match known {
        [] => format!("expected no {what} here"),
        _ => format!("expected {}", one_of(known.iter().map(|word| format!("`{word}`")))),
    };
    match suggest(found, known.iter().copied()) {
        Some(meant) => format!("unknown {what} {shown}, did you mean `{meant}`? {expected}"),
        None => format!("unknown {what} {shown}, {expected}"),
    }
}

/// Alternatives as a sentence lists them: "a, b or c".
pub fn one_of(alternatives: impl IntoIterator<Item = String>) -> String {
    let mut listed: Vec<String> = alternatives.into_iter().collect();
    let last = listed.pop().unwrap_or_default();
    if listed.is_empty() { last } else { format!("{} or {last}", listed.join(", ")) }
}

/// The candidate that is near enough to have been meant.
pub fn suggest<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    // A name much longer than any key is no slip of the fingers, and the distance takes quadratic time.
    const LONG: usize = 64;
    let lower = name.to_lowercase();
    if lower.len() > LONG {
        return None;
    }
    let distance = |candidate: &str| strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
    let known = candidates.into_iter().filter(|candidate| candidate.len() <= LONG);
    let near = known.map(|candidate| (distance(candidate), candidate)).filter(|(distance, candidate)| {
        // Of which nothing is left was nothing of it meant.
        *distance <= 1.max(candidate.chars().count() / 3) && *distance < lower.chars().count()
    });
    near.min_by_key(|(distance, _)| *distance).map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn suggests(name: &str, expected: Option<&str>) {
        assert_eq!(suggest(name, ["sphere", "plane", "triangle"]), expected);
    }

    #[test]
    fn swapped_letters() {
        suggests("shpere", Some("sphere"));
    }

    #[test]
    fn other_case() {
        suggests("Plane", Some("plane"));
    }

    #[test]
    fn nothing_near() {
        suggests("torus", None);
    }
}
