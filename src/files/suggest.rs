//! "Did you mean …?"

/// The candidate that is near enough to have been meant.
pub fn suggest<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    let lower = name.to_lowercase();
    // A name much longer than any key is no slip of the fingers, and the distance takes quadratic time.
    if lower.len() > 64 {
        return None;
    }
    candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= 64)
        .map(|candidate| (distance(&lower, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= 1.max(candidate.chars().count() / 3))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

fn distance(lower: &str, candidate: &str) -> usize {
    strsim::damerau_levenshtein(lower, &candidate.to_lowercase())
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
