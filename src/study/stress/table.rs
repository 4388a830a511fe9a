//! The report: a row a family.

use super::case::Family;
use super::judge::Outcome;
use super::requirement::{Unit, requirement};
use serde::Serialize;
use std::fmt::Write;

/// The report.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table {
    /// The rows.
    pub rows: Vec<Row>,
}

/// What became of the cases of a family.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The family.
    pub family: String,
    /// What was done.
    pub op: String,
    /// How many cases there are.
    pub cases: usize,
    /// How many were decided wrongly.
    pub wrong: usize,
    /// The worst error of the others; `None` where nothing was measured.
    pub worst: Option<f64>,
    /// The median error.
    pub median: Option<f64>,
    /// The unit of errors, such as `ulp`.
    pub unit: &'static str,
    /// The greatest error that is allowed; `None` where only decisions count.
    pub required: Option<f64>,
    /// Whether nothing was decided wrongly and no error is greater.
    pub holds: bool,
}

impl Row {
    /// The row of these outcomes.
    pub(super) fn of(family: &Family, op: &str, outcomes: &[Outcome]) -> Row {
        let requirement = requirement(&family.family, op);
        let mut errors: Vec<f64> = outcomes.iter().filter_map(|outcome| outcome.error).collect();
        errors.sort_by(f64::total_cmp);
        let worst = errors.last().copied();
        let wrong = outcomes.iter().filter(|outcome| outcome.is_wrong).count();
        let required = (requirement.unit != Unit::None).then_some(requirement.limit);
        let is_exact = worst.is_none_or(|worst| required.is_none_or(|limit| worst <= limit));
        Row {
            family: family.family.clone(),
            op: op.to_owned(),
            cases: outcomes.len(),
            wrong,
            worst,
            median: (!errors.is_empty()).then(|| errors[errors.len() / 2]),
            unit: requirement.unit.word(),
            required,
            holds: wrong == 0 && is_exact,
        }
    }
}

impl Table {
    /// Whether every requirement holds.
    pub fn holds(&self) -> bool {
        self.rows.iter().all(|row| row.holds)
    }

    /// For programs.
    pub fn json(&self) -> String {
        // Numbers and texts in memory: there is nothing that could fail.
        let mut text = serde_json::to_string_pretty(self).unwrap_or_default();
        text.push('\n');
        text
    }

    /// For people. `shown` makes text from a file safe to print.
    pub fn text(&self, shown: impl Fn(&str) -> String) -> String {
        let names: Vec<_> = self.rows.iter().map(|row| shown(&row.family)).collect();
        let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0).max("family".len());
        let mut text = String::new();
        let heads = ["cases", "wrong", "worst", "median", "required", ""];
        let [cases, wrong, worst, median, required, verdict] = heads;
        let _ = writeln!(
            text,
            "{:<width$} {cases:>6} {wrong:>6} {worst:>10} {median:>10}  {required:<18} {verdict}",
            "family"
        );
        for (row, name) in self.rows.iter().zip(names) {
            let required =
                row.required.map_or("0 wrong".to_owned(), |limit| format!("<= {} {}", bound(limit), row.unit));
            let verdict = if row.holds { "holds" } else { "FAILS" };
            let (worst, median) = (number(row.worst), number(row.median));
            let (cases, wrong) = (row.cases, row.wrong);
            let padding = " ".repeat(width - name.chars().count());
            let line =
                format!("{name}{padding} {cases:>6} {wrong:>6} {worst:>10} {median:>10}  {required:<18} {verdict}");
            let _ = writeln!(text, "{}", line.trim_end());
        }
        text
    }
}

/// A number of three digits, or nothing.
fn number(number: Option<f64>) -> String {
    match number {
        None => String::new(),
        Some(0.0) => "0".to_owned(),
        Some(number) if (0.001..1e4).contains(&number) => format!("{number:.3}"),
        Some(number) => format!("{number:.1e}"),
    }
}

/// A limit as it is written.
fn bound(limit: f64) -> String {
    if limit < 1e-3 { format!("{limit:e}") } else { limit.to_string() }
}
