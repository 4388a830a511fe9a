//! The study of roundings as text and JSON.

use super::{Cause, Change, RUNS, Study};
use crate::report::{Style, number, words};
use serde_json::{Value, json};

impl Study {
    /// The study for people.
    pub fn text(&self, style: Style) -> String {
        let header = &self.header;
        let off: [f64; 3] = std::array::from_fn(|channel| self.rounded[channel] - self.exact[channel]);
        let mut lines = vec![
            format!("{} · {} · {}", words::plain(&header.scene.name), words::subject(header), header.arithmetic),
            format!("rounded      {}", triple(self.rounded, "", style)),
            format!("in f64       {}", triple(self.exact, "", style)),
            format!("off by       {}", triple(off, "+", style)),
            format!(
                "to expect    {}, from {RUNS} runs that round up or down at random",
                triple(self.spread, "±", style)
            ),
        ];
        if self.decides_otherwise {
            lines.push("Rounding changes the ray tree: what is computed only there isn't listed here.".to_owned());
        }
        lines.push(String::new());
        let (effective, idle): (Vec<_>, Vec<_>) = self.causes.iter().partition(|cause| has_effect(cause));
        lines.extend(table(&effective, style));
        if !idle.is_empty() {
            lines.push(format!("{} further quantities change nothing when only they are rounded.", idle.len()));
        }
        if effective.iter().any(|cause| cause.only.decides_otherwise || cause.all_but.decides_otherwise) {
            lines.push("*  The ray tree is another than in f64.".to_owned());
        }
        lines.join("\n") + "\n"
    }

    /// The study for programs.
    pub fn json(&self) -> String {
        let causes: Vec<Value> = self.causes.iter().map(object).collect();
        let study = json!({
            "subject": self.header.subject,
            "scene": self.header.scene,
            "arithmetic": self.header.arithmetic,
            "rounded": self.rounded,
            "f64": self.exact,
            "spread": self.spread,
            "runs": RUNS,
            "decides_otherwise": self.decides_otherwise,
            "causes": causes,
        });
        format!("{study}\n")
    }
}

fn has_effect(cause: &Cause) -> bool {
    cause.only.size() > 0.0 || cause.only.decides_otherwise
}

/// Columns as wide as their cells.
fn table(causes: &[&Cause], style: Style) -> Vec<String> {
    let heads = ["only it rounded", "all but it", "quantity", "where"].map(str::to_owned);
    let rows: Vec<[String; 4]> = std::iter::once(heads).chain(causes.iter().map(|cause| cells(cause, style))).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; 4] = std::array::from_fn(width);
    let line = |row: &[String; 4]| {
        let padded = row.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}"));
        padded.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

fn cells(cause: &Cause, style: Style) -> [String; 4] {
    let changed = |change: &Change| {
        format!("{}{}", triple(change.color, "+", style), if change.decides_otherwise { " *" } else { "" })
    };
    let number = if cause.number > 1 { format!(" ({})", cause.number) } else { String::new() };
    // The title of a ray has its path.
    let place = match cause.node.strip_prefix("ray ") {
        Some(ray) => ray.to_owned(),
        None => format!("{}, {}", cause.path, cause.node),
    };
    [changed(&cause.only), changed(&cause.all_but), format!("{}{number}", cause.name.key()), place]
}

/// Three numbers, each with this sign before it unless it is negative.
fn triple(components: [f64; 3], sign: &str, style: Style) -> String {
    let signed = |x: f64| format!("{}{}", if x > 0.0 { sign } else { "" }, number::number(x, style));
    format!("({})", components.map(signed).join(", "))
}

fn object(cause: &Cause) -> Value {
    let changed = |change: &Change| json!({ "change": change.color, "decides_otherwise": change.decides_otherwise });
    json!({
        "path": cause.path,
        "node": cause.node,
        "quantity": cause.name.key(),
        "form": cause.name.form(),
        "number": cause.number,
        "only": changed(&cause.only),
        "all_but": changed(&cause.all_but),
    })
}
