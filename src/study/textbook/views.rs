//! The tables of worked examples as text, JSON and Markdown.

use super::{Checked, CheckedRow, DIGITS, Example, Row, Table, Verdict};
use crate::log::table;
use crate::report::{Style, number};
use serde_json::{Value, json};

const HEADS: [&str; 7] = ["step", "quantity", "printed", "following the book", "by hand", "exact", "verdict"];
/// Of an example that no book prints.
const SHEET_HEADS: [&str; 7] = ["step", "quantity", "sheet", "following the sheet", "by hand", "exact", "verdict"];
const CHECKED_HEADS: [&str; 7] = ["quantity", "ray", "printed", "following the file", "by hand", "exact", "verdict"];

/// A table for people: what departs is explained below it, and what there is to say of all rows.
struct Sheet {
    heads: [&'static str; 7],
    rows: Vec<[String; 7]>,
    remarks: Vec<String>,
    summary: Option<String>,
}

impl Sheet {
    fn text(self) -> String {
        let mut lines = table::aligned(std::iter::once(self.heads.map(str::to_owned)).chain(self.rows), |_| false);
        lines.extend(std::iter::once(String::new()).chain(self.remarks).chain(self.summary));
        lines.join("\n") + "\n"
    }

    fn markdown(self) -> String {
        let heads = [format!("| {} |", self.heads.join(" | ")), "|---".repeat(self.heads.len()) + "|"];
        // A length's bars would end the cell.
        let row = |cells: [String; 7]| format!("| {} |", cells.map(|cell| cell.replace('|', "\\|")).join(" | "));
        let mut lines: Vec<_> =
            heads.into_iter().chain(self.rows.into_iter().map(row)).chain([String::new()]).collect();
        lines.extend(self.remarks.iter().map(|remark| format!("- {remark}")));
        lines.extend(self.summary.into_iter().flat_map(|summary| [String::new(), summary]));
        lines.join("\n") + "\n"
    }
}

impl Table {
    /// The table for people, with the departures explained below.
    pub fn text(&self) -> String {
        self.sheet().text()
    }

    /// The table for documents.
    pub fn markdown(&self) -> String {
        self.sheet().markdown()
    }

    fn sheet(&self) -> Sheet {
        let heads = if self.example == Example::Textbook { HEADS } else { SHEET_HEADS };
        let departures = self.steps.iter().filter_map(|row| match row.verdict {
            Verdict::Departs { why } => Some(format!("{} departs: {why}.", row.called)),
            _ => None,
        });
        let remarks = departures.chain(self.with_rounded_products()).collect();
        Sheet { heads, rows: self.steps.iter().map(cells).collect(), remarks, summary: None }
    }

    /// The table for programs.
    pub fn json(&self) -> String {
        let steps: Vec<Value> = self.steps.iter().map(object).collect();
        let result = self.steps.last().map(|row| {
            json!({
                "printed": components(&row.printed.components),
                "recomputed": components(&row.recomputed),
                "strict": components(&row.strict),
                "strict_round_products": components(&row.strict_products),
                "exact": components(&row.exact),
            })
        });
        format!("{}\n", json!({ "steps": steps, "result": result }))
    }

    /// What else by hand can mean. The book itself does both: it rounds the products of step 7 and not those of the other steps.
    fn with_rounded_products(&self) -> Option<String> {
        // Of the second example nearly all of them differ: its result says enough.
        let first = if self.example == Example::Textbook { 0 } else { self.steps.len().saturating_sub(1) };
        let differing = self.steps[first..].iter().filter(|row| row.strict_products != row.strict);
        let values: Vec<_> = differing.map(|row| format!("{} {}", row.called, shown(&row.strict_products))).collect();
        let book = if self.example == Example::Textbook { ", as the book does in step 7" } else { "" };
        let call = self.example.call_with_rounded_products();
        let products = format!("By hand with the products of dot products rounded too (`{call}`){book}");
        (!values.is_empty()).then(|| format!("{products}: {}.", values.join(", ")))
    }
}

impl Checked {
    /// The table for people, with the departures explained below.
    pub fn text(&self) -> String {
        self.sheet().text()
    }

    /// The table for documents.
    pub fn markdown(&self) -> String {
        self.sheet().markdown()
    }

    fn sheet(&self) -> Sheet {
        let remarks = self.departures().map(|row| format!("{}.", departure(row))).collect();
        let rows = self.rows.iter().map(checked_cells).collect();
        Sheet { heads: CHECKED_HEADS, rows, remarks, summary: Some(self.summary()) }
    }

    /// The table for programs.
    pub fn json(&self) -> String {
        let steps: Vec<Value> = self.rows.iter().map(checked_object).collect();
        format!("{}\n", json!({ "order": self.order.word(), "steps": steps, "departures": self.departures().count() }))
    }

    fn summary(&self) -> String {
        let departures = self.departures().count();
        let values = if self.rows.len() == 1 { "value" } else { "values" };
        let depart = if departures == 1 { "departs" } else { "depart" };
        format!(
            "{} {values} checked, {departures} {depart}; rows of one name in the order of the {}.",
            self.rows.len(),
            self.order.word()
        )
    }
}

fn departure(row: &CheckedRow) -> String {
    let CheckedRow { line, quantity, path, text, recomputed, verdict, .. } = row;
    let rules = match verdict {
        Verdict::Departs { why } if recomputed.is_empty() => (*why).to_owned(),
        _ => format!("the rules give {}", shown(recomputed)),
    };
    format!("line {line}: {quantity} of the ray {path} departs: printed {text}, {rules}")
}

fn cells(row: &Row) -> [String; 7] {
    [
        row.step.to_owned(),
        row.called.to_owned(),
        row.printed.text.to_owned(),
        shown(&row.recomputed),
        shown(&row.strict),
        shown(&row.exact),
        row.verdict.word().to_owned(),
    ]
}

fn checked_cells(row: &CheckedRow) -> [String; 7] {
    [
        row.quantity.to_owned(),
        row.path.clone(),
        row.text.clone(),
        shown(&row.recomputed),
        shown(&row.strict),
        shown(&row.exact),
        row.verdict.word().to_owned(),
    ]
}

/// A number or a triple as people read it.
fn shown(values: &[f64]) -> String {
    if values.is_empty() {
        return "–".to_owned();
    }
    let numbers: Vec<_> =
        values.iter().map(|x| number::number(*x, Style { digits: DIGITS, keeps_small: false })).collect();
    if numbers.len() == 1 { numbers.concat() } else { format!("({})", numbers.join(", ")) }
}

fn checked_object(row: &CheckedRow) -> Value {
    let mut object = json!({
        "line": row.line,
        "quantity": row.quantity,
        "path": row.path,
        "printed": components(&row.printed),
        "strict": components(&row.strict),
        "exact": components(&row.exact),
        "verdict": row.verdict.word(),
    });
    // Absent where the walk doesn't come to it.
    if !row.recomputed.is_empty() {
        object["recomputed"] = components(&row.recomputed);
    }
    object
}

fn object(row: &Row) -> Value {
    let mut object = json!({
        "step": row.step,
        "quantity": row.quantity,
        "called": row.called,
        "printed": components(&row.printed.components),
        "recomputed": components(&row.recomputed),
        "strict": components(&row.strict),
        "strict_round_products": components(&row.strict_products),
        "exact": components(&row.exact),
        "verdict": row.verdict.word(),
    });
    if let Verdict::Departs { why } = row.verdict {
        object["why"] = why.into();
    }
    object
}

/// A number, or a list of three.
fn components(values: &[f64]) -> Value {
    match values {
        [number] => (*number).into(),
        several => several.into(),
    }
}
