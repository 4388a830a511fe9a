//! How many digits can be trusted, in words.

use crate::log::{Digits, Event, What};

/// What stands behind a value or a decision of several perturbed runs, such as ` (14 digits)`; nothing otherwise.
pub fn marker(event: &Event) -> String {
    match (event.digits.as_deref(), &event.what) {
        (None, _) => String::new(),
        (Some(Digits::DecisionDiffers), What::Mark(_)) => " (the decision differs between runs)".to_owned(),
        (Some(Digits::DecisionDiffers), _) => " (0 digits: a decision differs between runs)".to_owned(),
        (Some(Digits::Significant(count)), _) => {
            // Whole digits; a part of one can't be read off a number.
            let counts: Vec<_> = count.components().iter().map(|count| format!("{:.0}", count.floor())).collect();
            let is_plain = counts.iter().all(|count| *count == counts[0]);
            let counts = if is_plain { counts[0].clone() } else { counts.join(", ") };
            format!(" ({counts} {})", if counts == "1" { "digit" } else { "digits" })
        }
    }
}
