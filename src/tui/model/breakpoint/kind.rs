//! The kinds of events that one can stop at, as words: those of the log, with `-` between their parts.

use crate::log::{Decision, Miss, RayKind, Step, What};
use arrayvec::ArrayVec;
use std::sync::LazyLock;

const RESULT: &str = "result";

/// Every kind: of nodes, of decisions and of misses, then the result.
pub static WORDS: LazyLock<Vec<&'static str>> =
    LazyLock::new(|| nodes().chain(DECIDED.iter().map(|(_, dashed)| *dashed)).chain([RESULT]).collect());

/// The words of decisions and of misses as a log has them, and with dashes.
static DECIDED: LazyLock<Vec<(&'static str, &'static str)>> = LazyLock::new(|| {
    let decided = Decision::WORDS.iter().copied().chain(Miss::ALL.iter().map(|why| why.word()));
    decided.map(|word| (word, &*word.replace('_', "-").leak())).collect()
});

/// The kinds of nodes, and of rays.
fn nodes() -> impl Iterator<Item = &'static str> {
    Step::WORDS.iter().chain(RayKind::WORDS).copied()
}

/// The kind with this word, however its parts are joined.
pub fn find(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase().replace(['_', ' '], "-");
    WORDS.iter().copied().find(|known| *known == word)
}

/// Whether a kind is that of a node.
pub fn is_node(word: &str) -> bool {
    nodes().any(|node| node == word)
}

/// Whether a kind is seen without knowing what was decided: that of a node, and the result.
pub fn is_open(word: &str) -> bool {
    word == RESULT || is_node(word)
}

/// The kinds of a node, the narrower one last.
pub fn of_step(step: &Step) -> ArrayVec<&'static str, 2> {
    let of_ray = match step {
        Step::Ray { kind, .. } => Some(kind.word()),
        _ => None,
    };
    [Some(step.word()), of_ray].into_iter().flatten().collect()
}

/// The kinds of an event, the narrower one last; none for a computed value and for the end of a node.
pub fn of(what: &What) -> ArrayVec<&'static str, 2> {
    let of_log = match what {
        What::Enter { step, .. } => return of_step(step),
        What::Mark(decision @ Decision::Miss { why }) => [Some(decision.word()), Some(why.word())],
        What::Mark(decision) => [Some(decision.word()), None],
        What::Result { .. } => [Some(RESULT), None],
        What::Note { .. } | What::Leave => [None, None],
    };
    // Asked of every event of a log.
    let dashed = |word: &'static str| match word.contains('_') {
        true => DECIDED.iter().find(|(of_log, _)| *of_log == word).map_or(word, |(_, dashed)| dashed),
        false => word,
    };
    of_log.into_iter().flatten().map(dashed).collect()
}
