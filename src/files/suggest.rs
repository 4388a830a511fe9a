//! "Did you mean …?"

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
