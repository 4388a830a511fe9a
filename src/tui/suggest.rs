//! "Did you mean …?"

/// The candidate that is near enough to have been meant.
pub(super) fn nearest<'c>(text: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    // The distance takes quadratic time, and long texts are no slip of the fingers.
    const LONG: usize = 64;
    let lower = text.to_lowercase();
    if lower.len() > LONG {
        return None;
    }
    let distance = |candidate: &str| strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
    let near = candidates.into_iter().filter(|candidate| candidate.len() <= LONG).map(|known| (distance(known), known));
    near.filter(|(distance, known)| *distance <= 1.max(known.chars().count() / 3) && *distance < lower.chars().count())
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, known)| known)
}
