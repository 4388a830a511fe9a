//! How many digits can be trusted, in words.

use super::language::Language;
use crate::log::{Digits, Event, What};

/// What follows a value with twice the digits, and a value or a decision of several perturbed runs, such as ` (14 digits)`;
/// nothing otherwise.
pub fn marker(language: Language, event: &Event) -> String {
    let texts = language.texts();
    let doubled = match event.what {
        What::Note { name, .. } if name.form().starts_with("doubled") => format!(" ({})", texts.twice_the_digits),
        _ => String::new(),
    };
    doubled + &of_runs(language, event)
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
