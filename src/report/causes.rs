//! Which rounding caused the error of a result: what a study of roundings found, as text, as JSON and as the cells of a table.

use super::language::Language;
use super::{Style, words};
use crate::log::table::aligned;
use crate::log::{Log, Name, Step, Tree};
use serde_json::{Value, json};

/// The error of a result, and what caused it.
#[derive(Clone, Debug)]
pub struct Study {
    /// What was traced, in which arithmetic; its events are those of the computation with nothing rounded.
    pub log: Log,
    /// The result in that arithmetic.
    pub rounded: [f64; 3],
    /// The result in f64.
    pub exact: [f64; 3],
    /// How far such a result may be off: half the root of the mean square by which results are off when every quantity is
    /// rounded up or down at random. Half, because such an error is twice as large as that of rounding to the nearest: in
    /// the mean its square is 1/3 of a step's instead of 1/12.
    pub spread: [f64; 3],
    /// From how many such runs that is known.
    pub runs: u32,
    /// Whether rounding changed the ray tree: then quantities may be missing here, and changes be jumps.
    pub decides_otherwise: bool,
    /// The quantities of the computation in f64, those first that change the result most when only they are rounded.
    pub causes: Vec<Cause>,
}

/// What the rounding of one quantity does.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// The path of the ray around it, such as `C R`.
    pub path: String,
    /// The node that it belongs to.
    pub node: usize,
    /// The event that notes it.
    pub event: usize,
    /// The quantity.
    pub name: Name,
    /// Which one of that name in its node, from 1.
    pub number: usize,
    /// The result with only this quantity rounded.
    pub only: Change,
    /// The result with all quantities but this one rounded.
    pub all_but: Change,
}

/// A result as it differs from that in f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// Red, green, blue, less what they are in f64.
    pub color: [f64; 3],
    /// Whether the ray tree is another.
    pub decides_otherwise: bool,
}

impl Change {
    /// The largest change of a channel.
    pub fn size(&self) -> f64 {
        self.color.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
    }
}

impl Study {
    /// The study for people, in a language.
    pub fn text(&self, language: Language, style: Style) -> String {
        let header = &self.log.header;
        let texts = &language.texts().causes;
        let subject = words::subject(language, header);
        let mut lines = vec![format!("{} · {subject} · {}", words::plain(&header.scene.name), header.arithmetic)];
        lines.extend(self.results(language, style).map(|(called, result)| format!("{called:<12} {result}")));
        if self.decides_otherwise {
            lines.push(texts.other_tree.to_owned());
        }
        lines.push(String::new());
        let (effective, idle) = self.by_effect();
        lines.extend(self.table(&effective, language, style));
        if !idle.is_empty() {
            lines.push((texts.idle)(idle.len()));
        }
        if effective.iter().any(|cause| cause.only.decides_otherwise || cause.all_but.decides_otherwise) {
            lines.push(texts.star.to_owned());
        }
        lines.join("\n") + "\n"
    }

    /// The results, and how far they are apart, with what each is called.
    pub fn results(&self, language: Language, style: Style) -> [(&'static str, String); 4] {
        let texts = &language.texts().causes;
        let off: [f64; 3] = std::array::from_fn(|channel| self.rounded[channel] - self.exact[channel]);
        let triple = |xyz, sign| triple(xyz, sign, language, style);
        let expected = format!("{}, {}", triple(self.spread, "±"), (texts.of_runs)(self.runs));
        [
            (texts.rounded, triple(self.rounded, "")),
            (texts.exact, triple(self.exact, "")),
            (texts.off, triple(off, "+")),
            (texts.expected, expected),
        ]
    }

    /// The causes that change something when only they are rounded, and the others.
    pub fn by_effect(&self) -> (Vec<&Cause>, Vec<&Cause>) {
        self.causes.iter().partition(|cause| has_effect(cause))
    }

    /// Columns as wide as their cells.
    fn table(&self, causes: &[&Cause], language: Language, style: Style) -> Vec<String> {
        let heads = language.texts().causes.columns.map(str::to_owned);
        let tree = Tree::of(&self.log.events);
        let cells = |cause: &&Cause| self.cells(&tree, cause, language, style);
        aligned(std::iter::once(heads).chain(causes.iter().map(cells)), |_| false)
    }

    /// A cause as the cells of a row, under [`columns`](super::language::Causes::columns); `tree` is that of the log.
    pub fn cells(&self, tree: &Tree, cause: &Cause, language: Language, style: Style) -> [String; 4] {
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
            "runs": self.runs,
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
