//! The report: a row a family.

use super::case::Family;
use super::judge::Outcome;
use super::requirement::{Unit, requirement};
use super::way::Way;
use crate::log::table::aligned;
use crate::scene::Formulas;
use serde::Serialize;

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
    /// The same in other ways.
    pub columns: Vec<Column>,
}

/// The same cases in another way, of which nothing is required.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Column {
    /// What the way is called in the table.
    pub way: String,
    /// Its arithmetic.
    pub arithmetic: String,
    /// Its formulas.
    pub formulas: Formulas,
    /// How many cases were decided wrongly; `None`, as the other two, where the answers don't depend on the way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wrong: Option<usize>,
    /// The worst error of the others, in the unit of the row.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worst: Option<f64>,
    /// The median error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub median: Option<f64>,
}

impl Column {
    /// The column of these outcomes.
    pub(super) fn of(way: &Way, outcomes: Option<&Vec<Outcome>>) -> Column {
        let errors = outcomes.map(|outcomes| sorted_errors(outcomes)).unwrap_or_default();
        Column {
            way: way.name(),
            arithmetic: way.arithmetic().to_string(),
            formulas: way.formulas(),
            wrong: outcomes.map(|outcomes| wrong(outcomes)),
            worst: errors.last().copied(),
            median: errors.get(errors.len() / 2).copied(),
        }
    }

    /// The worst error, and how many decisions are wrong if any is.
    fn text(&self) -> String {
        match self.wrong {
            None => "-".to_owned(),
            Some(0) => match self.worst {
                None => "0 wrong".to_owned(),
                worst => number(worst),
            },
            Some(wrong) => format!("{} {wrong} wrong", number(self.worst)).trim().to_owned(),
        }
    }
}

/// The errors of those that weren't decided wrongly, from the least on.
fn sorted_errors(outcomes: &[Outcome]) -> Vec<f64> {
    let mut errors: Vec<f64> = outcomes.iter().filter_map(|outcome| outcome.error).collect();
    errors.sort_by(f64::total_cmp);
    errors
}

fn wrong(outcomes: &[Outcome]) -> usize {
    outcomes.iter().filter(|outcome| outcome.is_wrong).count()
}

impl Row {
    /// The row of these outcomes.
    pub(super) fn of(family: &Family, op: &str, outcomes: &[Outcome], columns: Vec<Column>) -> Row {
        let requirement = requirement(&family.family, op);
        let errors = sorted_errors(outcomes);
        let worst = errors.last().copied();
        let wrong = wrong(outcomes);
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
            columns,
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
        let ways = self.rows.first().into_iter().flat_map(|row| &row.columns).map(|column| column.way.clone());
        let heads = ["family", "cases", "wrong", "worst", "median", "required", ""].map(str::to_owned);
        let rows = self.rows.iter().map(|row| {
            let required =
                row.required.map_or("0 wrong".to_owned(), |limit| format!("<= {} {}", bound(limit), row.unit));
            let verdict = if row.holds { "holds" } else { "FAILS" };
            let (cases, wrong) = (row.cases.to_string(), row.wrong.to_string());
            let own =
                [shown(&row.family), cases, wrong, number(row.worst), number(row.median), required, verdict.to_owned()];
            own.into_iter().chain(row.columns.iter().map(Column::text)).collect()
        });
        let rows = std::iter::once(heads.into_iter().chain(ways).collect::<Vec<_>>()).chain(rows);
        aligned(rows, |column| !matches!(column, 0 | 5 | 6)).join("\n") + "\n" + LEGEND
    }
}

/// What the units are, and the columns.
const LEGEND: &str = "
ulp       the distance of the two f64 around the exact answer
k         the error over 2^-53 times the answer times the case's condition number: 1 is what rounding the input would do
2^-52     the error over 2^-52, of unit vectors
relative  the error as a part of the answer
wrong     decisions that are wrong: a hit or a miss, an order, which object; such cases have no error
worst, median, required are of f64 and the formulas that keep their digits. The last columns have the worst error, in the same unit, of
notes (f64 and the formulas as printed: cos φ_2, H', the geometric sphere), of f32, and of the notes by hand; - where a column doesn't apply.
";

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
