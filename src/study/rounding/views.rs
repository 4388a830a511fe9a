//! The study of roundings as text and JSON.

use super::{Cause, Change, RUNS, Study};
use crate::log::table::aligned;
use crate::log::{Step, Tree};
use crate::report::language::Language;
use crate::report::{Style, words};
use serde_json::{Value, json};

impl Study {
    /// The study for people, in a language.
    pub fn text(&self, language: Language, style: Style) -> String {
        let header = &self.log.header;
        let texts = &language.texts().causes;
        let off: [f64; 3] = std::array::from_fn(|channel| self.rounded[channel] - self.exact[channel]);
        let triple = |xyz, sign| triple(xyz, sign, language, style);
        let expected = format!("{}, {}", triple(self.spread, "±"), (texts.of_runs)(RUNS));
        let results = [
            (texts.rounded, triple(self.rounded, "")),
            (texts.exact, triple(self.exact, "")),
            (texts.off, triple(off, "+")),
            (texts.expected, expected),
        ];
        let subject = words::subject(language, header);
        let mut lines = vec![format!("{} · {subject} · {}", words::plain(&header.scene.name), header.arithmetic)];
        lines.extend(results.map(|(called, result)| format!("{called:<12} {result}")));
        if self.decides_otherwise {
            lines.push(texts.other_tree.to_owned());
        }
        lines.push(String::new());
        let (effective, idle): (Vec<_>, Vec<_>) = self.causes.iter().partition(|cause| has_effect(cause));
        lines.extend(self.table(&effective, language, style));
        if !idle.is_empty() {
            lines.push((texts.idle)(idle.len()));
        }
        if effective.iter().any(|cause| cause.only.decides_otherwise || cause.all_but.decides_otherwise) {
            lines.push(texts.star.to_owned());
        }
        lines.join("\n") + "\n"
    }

    /// Columns as wide as their cells.
    fn table(&self, causes: &[&Cause], language: Language, style: Style) -> Vec<String> {
        let heads = language.texts().causes.columns.map(str::to_owned);
        let tree = Tree::of(&self.log.events);
        let cells = |cause: &&Cause| self.cells(&tree, cause, language, style);
        aligned(std::iter::once(heads).chain(causes.iter().map(cells)), |_| false)
    }

    fn cells(&self, tree: &Tree, cause: &Cause, language: Language, style: Style) -> [String; 4] {
        let changed = |change: &Change| {
            let star = if change.decides_otherwise { " *" } else { "" };
            format!("{}{star}", triple(change.color, "+", language, style))
        };
        let number = if cause.number > 1 { format!(" ({})", cause.number) } else { String::new() };
        let place = match tree.nodes()[cause.node].step {
            Some(Step::Ray { kind, .. }) => {
                format!("{}, {}", cause.path, words::ray_kind(language, &self.log.header, kind))
            }
            _ => format!("{}, {}", cause.path, words::title(language, &self.log, tree, cause.node)),
        };
        [changed(&cause.only), changed(&cause.all_but), format!("{}{number}", cause.name.key()), place]
    }

    /// The study for programs.
    pub fn json(&self) -> String {
        let tree = Tree::of(&self.log.events);
        let causes: Vec<Value> = self.causes.iter().map(|cause| self.object(&tree, cause)).collect();
        let study = json!({
            "subject": self.log.header.subject,
            "scene": self.log.header.scene,
            "arithmetic": self.log.header.arithmetic,
            "rounded": self.rounded,
            "f64": self.exact,
            "spread": self.spread,
            "runs": RUNS,
            "decides_otherwise": self.decides_otherwise,
            "causes": causes,
        });
        format!("{study}\n")
    }

    fn object(&self, tree: &Tree, cause: &Cause) -> Value {
        let changed =
            |change: &Change| json!({ "change": change.color, "decides_otherwise": change.decides_otherwise });
        json!({
            "path": cause.path,
            "node": words::title(Language::English, &self.log, tree, cause.node),
            "quantity": cause.name.key(),
            "form": cause.name.form(),
            "number": cause.number,
            "only": changed(&cause.only),
            "all_but": changed(&cause.all_but),
        })
    }
}

fn has_effect(cause: &Cause) -> bool {
    cause.only.size() > 0.0 || cause.only.decides_otherwise
}

/// Three numbers, each with this sign before it unless it is negative.
fn triple(components: [f64; 3], sign: &str, language: Language, style: Style) -> String {
    let signed = |x: f64| format!("{}{}", if x > 0.0 { sign } else { "" }, language.number(x, style));
    format!("({})", components.map(signed).join(language.texts().separator))
}
