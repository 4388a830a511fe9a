//! The table of the numeric example as text, JSON and Markdown.

use super::{DIGITS, Row, Table, Verdict};
use crate::report::{Style, number};
use serde_json::{Value, json};

const HEADS: [&str; 6] = ["step", "quantity", "printed", "following the book", "by hand", "exact"];

impl Table {
    /// The table for people, with the departures explained below.
    pub fn text(&self) -> String {
        let rows: Vec<_> = self.steps.iter().map(cells).collect();
        let width = |column: usize| {
            let cells = rows.iter().map(|row| row[column].chars().count());
            cells.chain([HEADS[column].chars().count()]).max().unwrap_or(0)
        };
        let widths: [usize; 6] = std::array::from_fn(width);
        let line = |cells: &[String], verdict: &str| {
            let padded = cells.iter().zip(widths).map(|(cell, width)| pad(cell, width));
            format!("{}  {verdict}", padded.collect::<Vec<_>>().join("  ")).trim_end().to_owned()
        };
        let mut lines = vec![line(&HEADS.map(str::to_owned), "verdict")];
        lines.extend(rows.iter().zip(&self.steps).map(|(cells, row)| line(cells, row.verdict.word())));
        lines.push(String::new());
        lines.extend(self.departures().map(|(row, why)| format!("{} departs: {why}.", row.called)));
        lines.join("\n") + "\n"
    }

    /// The table for documents.
    pub fn markdown(&self) -> String {
        let mut lines = vec![format!("| {} | verdict |", HEADS.join(" | ")), "|---".repeat(HEADS.len() + 1) + "|"];
        for row in &self.steps {
            // A length's bars would end the cell.
            let cells = cells(row).map(|cell| cell.replace('|', "\\|"));
            lines.push(format!("| {} | {} |", cells.join(" | "), row.verdict.word()));
        }
        lines.push(String::new());
        lines.extend(self.departures().map(|(row, why)| format!("- {} departs: {why}.", row.called)));
        lines.join("\n") + "\n"
    }

    /// The table for programs.
    pub fn json(&self) -> String {
        let steps: Vec<Value> = self.steps.iter().map(object).collect();
        let result = self.steps.last().map(|row| {
            json!({
                "printed": components(&row.printed.components),
                "recomputed": components(&row.recomputed),
                "strict": components(&row.strict),
                "exact": components(&row.exact),
            })
        });
        format!("{}\n", json!({ "steps": steps, "result": result }))
    }

    fn departures(&self) -> impl Iterator<Item = (&Row, &'static str)> {
        self.steps.iter().filter_map(|row| match row.verdict {
            Verdict::Departs { why } => Some((row, why)),
            _ => None,
        })
    }
}

fn cells(row: &Row) -> [String; 6] {
    let shown = |values: &[f64]| {
        let numbers: Vec<_> = values.iter().map(|x| number::number(*x, Style { digits: DIGITS })).collect();
        if numbers.len() == 1 { numbers.concat() } else { format!("({})", numbers.join(", ")) }
    };
    [
        row.step.to_owned(),
        row.called.to_owned(),
        row.printed.text.to_owned(),
        shown(&row.recomputed),
        shown(&row.strict),
        shown(&row.exact),
    ]
}

fn object(row: &Row) -> Value {
    let mut object = json!({
        "step": row.step,
        "quantity": row.quantity,
        "called": row.called,
        "printed": components(&row.printed.components),
        "recomputed": components(&row.recomputed),
        "strict": components(&row.strict),
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

fn pad(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(text.chars().count())))
}
