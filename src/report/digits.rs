//! What there is to say of a value beside it: how many digits can be trusted, and where it comes from if that isn't its formula.

use super::language::Language;
use super::{Style, evaluate, forms};
use crate::log::{Digits, Event, Log, Tree, What};

/// What follows a value with twice the digits, one that the book prints against its formula, and a value or a decision of several perturbed
/// runs, such as ` (14 digits)`; nothing otherwise.
pub fn marker(language: Language, log: &Log, tree: &Tree, event: usize) -> String {
    let texts = language.texts();
    let happening = &log.events[event];
    let own = match happening.what {
        What::Note { name, .. } if name.form().starts_with("doubled") => format!(" ({})", texts.twice_the_digits),
        What::Note { .. } if is_printed_otherwise(log, tree, event) => format!(" ({})", texts.printed),
        _ => String::new(),
    };
    own + &of_runs(language, happening)
}

/// Whether a value of the book isn't what its formula gives with the values before it, to the last printed digit.
fn is_printed_otherwise(log: &Log, tree: &Tree, event: usize) -> bool {
    let What::Note { name, value } = log.events[event].what else { return false };
    let computed = || evaluate::evaluate(log, tree, event, name).and_then(Result::ok);
    log.header.arithmetic == "printed"
        && computed().is_some_and(|computed| !forms::is_near(log, &computed, &value, Style::default().digits))
}

/// How far perturbed runs agree.
fn of_runs(language: Language, event: &Event) -> String {
    let texts = language.texts();
    match (event.digits.as_deref(), &event.what) {
        (None, _) => String::new(),
        (Some(Digits::DecisionDiffers), What::Mark(_)) => format!(" ({})", texts.decision_differs),
        (Some(Digits::DecisionDiffers), _) => format!(" ({})", texts.no_digits),
        (Some(Digits::Significant(count)), _) => {
            // Whole digits; a part of one can't be read off a number.
            let counts: Vec<_> = count.components().iter().map(|count| format!("{:.0}", count.floor())).collect();
            let is_plain = counts.iter().all(|count| *count == counts[0]);
            let counts = if is_plain { counts[0].clone() } else { counts.join(", ") };
            format!(" ({})", (texts.digits)(&counts, counts == "1"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{self, Arithmetic};
    use crate::scene::{build, builtin, file};

    /// The book departs from its formulas at P₁, H₁ and the local intensity of P₂ (docs/notes.md), and nowhere else.
    #[test]
    fn what_the_book_prints_against_its_formulas_is_marked() {
        let text = builtin::text("textbook").expect("the numeric example is built in");
        let read = file::check(text.as_bytes(), "textbook").unwrap_or_else(|error| panic!("{}", error.report(false)));
        let scene = build(&read.scene, &Default::default()).unwrap_or_else(|why| panic!("{why}"));
        let marked = |arithmetic, language| {
            let log = record::pixel(&scene, [160, 120], arithmetic);
            let tree = Tree::of(&log.events);
            let marked = (0..log.events.len()).filter_map(|event| {
                let marker = marker(language, &log, &tree, event);
                let (name, _) = log.events[event].noted().filter(|_| !marker.is_empty())?;
                Some(format!("{} {}{marker}", tree.path(tree.owner(event)), name.key()))
            });
            marked.collect::<Vec<_>>()
        };
        let expected = ["C hit.point (printed)", "C half.direction (printed)", "C R shade.local (printed)"];
        assert_eq!(marked(Arithmetic::Printed, Language::English), expected);
        let expected = expected.map(|line| line.replace("printed", "impreso"));
        assert_eq!(marked(Arithmetic::Printed, Language::Spanish), expected);
        assert!(marked(Arithmetic::Decimal(3), Language::English).is_empty());
    }
}
