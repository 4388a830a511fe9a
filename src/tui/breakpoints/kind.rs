//! The kinds of events that one can stop at, as words: those of the log, with `-` between their parts.

use crate::log::{Decision, Miss, Step, What};

/// Every kind: of nodes, then of decisions from `hit` on, then the result.
pub const WORDS: &[&str] = &[
    "pixel",
    "sample",
    "ray",
    "camera",
    "shadow",
    "reflected",
    "transmitted",
    "motion",
    "test",
    "shade",
    "light",
    "zone",
    "combine",
    "hit",
    "miss",
    "parallel",
    "behind",
    "beside",
    "beyond",
    "faces-away",
    "begins-there",
    "outside",
    "inside",
    "nearest",
    "coincident",
    "immersed",
    "bent",
    "background",
    "free",
    "occluded",
    "attenuated",
    "undefined",
    "total-internal-reflection",
    "depth-limit",
    "leak-guard",
    "rejected",
    "skipped",
    "subdivided",
    "accepted",
    "asked",
    "more-samples",
    "result",
];

/// The kind with this word, however its parts are joined.
pub fn find(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase().replace(['_', ' '], "-");
    WORDS.iter().copied().find(|known| *known == word)
}

/// Whether a kind is seen without knowing what was decided: that of a node, and the result.
pub fn is_open(word: &str) -> bool {
    let first_decision = WORDS.iter().position(|known| *known == "hit").unwrap_or(WORDS.len());
    word == "result" || WORDS[..first_decision].contains(&word)
}

/// The kinds of an event, the narrower one last; none for a computed value and for the end of a node.
pub fn of(what: &What) -> &'static [&'static str] {
    match what {
        What::Enter { step, .. } => of_step(*step),
        What::Mark(decision) => of_decision(decision),
        What::Result { .. } => &["result"],
        What::Note { .. } | What::Leave => &[],
    }
}

fn of_step(step: Step) -> &'static [&'static str] {
    match step {
        Step::Pixel(_) => &["pixel"],
        Step::Sample { .. } => &["sample"],
        Step::Ray { kind, .. } => match kind.letter() {
            'C' => &["ray", "camera"],
            'S' => &["ray", "shadow"],
            'R' => &["ray", "reflected"],
            _ => &["ray", "transmitted"],
        },
        Step::Motion { .. } => &["motion"],
        Step::Test { .. } => &["test"],
        Step::Shade { .. } => &["shade"],
        Step::Light { .. } => &["light"],
        Step::Zone { .. } => &["zone"],
        Step::Combine => &["combine"],
    }
}

fn of_decision(decision: &Decision) -> &'static [&'static str] {
    match decision {
        Decision::Hit => &["hit"],
        Decision::Miss { why } => match why {
            Miss::Parallel => &["miss", "parallel"],
            Miss::Behind => &["miss", "behind"],
            Miss::Beside => &["miss", "beside"],
            Miss::Beyond => &["miss", "beyond"],
            Miss::FacesAway => &["miss", "faces-away"],
            Miss::BeginsThere => &["miss", "begins-there"],
        },
        Decision::Outside => &["outside"],
        Decision::Inside => &["inside"],
        Decision::Nearest { .. } => &["nearest"],
        Decision::Coincident { .. } => &["coincident"],
        Decision::Immersed { .. } => &["immersed"],
        Decision::Bent { .. } => &["bent"],
        Decision::Background => &["background"],
        Decision::Free => &["free"],
        Decision::Occluded { .. } => &["occluded"],
        Decision::Attenuated { .. } => &["attenuated"],
        Decision::Undefined { .. } => &["undefined"],
        Decision::TotalInternalReflection => &["total-internal-reflection"],
        Decision::DepthLimit { .. } => &["depth-limit"],
        Decision::LeakGuard { .. } => &["leak-guard"],
        Decision::Rejected { .. } => &["rejected"],
        Decision::Skipped { .. } => &["skipped"],
        Decision::Subdivided { .. } => &["subdivided"],
        Decision::Accepted { .. } => &["accepted"],
        Decision::Asked { .. } => &["asked"],
        Decision::MoreSamples { .. } => &["more-samples"],
    }
}
