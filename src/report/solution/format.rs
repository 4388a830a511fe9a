//! One walk over a worked solution, and what each format writes of its parts.

use super::figures::Figures;
use super::shares::Shares;
use super::{Item, Kind, Section, Solution, Task, data, decision, lowered};
use crate::log::{Name, Step, Value, What};
use crate::report::digits;
use crate::report::notation::{self, Notation};
use crate::report::ray_tree::Figure;
use crate::report::schematic::Plan;

/// What comes before and behind a part of the page.
pub(super) type Around = [&'static str; 2];

/// How a format writes the parts of a worked solution. What a hook is given as a text has been escaped, and it returns what it adds to the
/// page.
pub(super) trait Format {
    /// Whether a step stands visibly inside its ray, so that nobody has to be told that the steps after another ray's are this one's again.
    const IS_NESTED: bool = false;
    /// How it writes formulas.
    type Formulas: Notation;
    /// Around the heading of a part of the page.
    const HEADING: Around;
    /// Around a paragraph.
    const PARAGRAPH: Around;
    /// Around the sentence with the result.
    const RESULT: Around = Self::PARAGRAPH;
    /// Around what the problem states.
    const DATA: Around = ["", ""];
    /// Before, between and behind the heading and the values of a group of that.
    const GROUP: [&str; 3];
    /// Around the inputs of a step.
    const GIVEN: Around;
    /// Around `symbol = value`.
    const ASSIGNMENT: Around;
    /// Between values.
    const COMMA: &str = ", ";
    /// Around a decision.
    const DECISION: Around;
    /// Around a ray that goes on behind another.
    const BACK: Around;
    /// Behind a section.
    const CLOSE: &str = "";
    /// Before, between and behind the heading and the items of a list.
    const LIST: [&str; 3];
    /// Around an item of a list.
    const ITEM: Around;
    /// The end of the page.
    const END: &str;

    /// A text that says what it says in this format.
    fn escaped(text: &str) -> String;

    /// A note on the figures, with code in backticks.
    fn note(note: &str) -> String {
        Self::escaped(&note.replace('`', ""))
    }

    /// The beginning of the page up to its title, which is the page's, too.
    fn begin(task: &Task, title: &str) -> String;

    /// The ray tree.
    fn ray_tree(task: &Task, figure: &Figure) -> String;

    /// The schematic under its heading.
    fn schematic(task: &Task, plan: &Plan) -> String;

    /// What comes before and behind all steps.
    fn around_steps(_task: &Task) -> [String; 2] {
        [String::new(), String::new()]
    }

    /// The beginning of a section, with its title.
    fn open(task: &Task, section: &Section, title: &str) -> String;

    /// The equations of some events.
    fn equations(task: &Task, events: &[usize]) -> String;

    /// The table of what adds to the colour.
    fn table(columns: &[String; 7], rows: &[[String; 7]]) -> String;
}

/// Writes a worked solution.
pub(super) fn page<F: Format>(task: &Task) -> String {
    let solution = Solution::of(task);
    let texts = &task.language.texts().solution;
    let heading = |text: &str| around(F::HEADING, &F::escaped(text));
    let mut out = F::begin(task, &F::escaped(&solution.title));
    out += &around(F::PARAGRAPH, &F::escaped(&solution.conditions.join(" ")));
    if !solution.data.groups.is_empty() {
        let groups = solution.data.groups.iter().map(|(owner, values)| {
            let values = values.iter().map(|(name, value)| assignment::<F>(task, *name, value, None));
            let heading = F::escaped(&data::heading(task, *owner));
            between(F::GROUP, &heading, &values.collect::<Vec<_>>().join(F::COMMA))
        });
        out += &(heading(texts.data) + &around(F::DATA, &groups.collect::<String>()));
    }
    out += &heading(task.language.texts().figure.ray_tree);
    out += &figures::<F>(task);
    let [before, behind] = F::around_steps(task);
    out += &(heading(texts.steps) + &before);
    section::<F>(&mut out, task, &solution.steps);
    out += &behind;
    out += &heading(texts.result);
    out += &match solution.result {
        Some((color, event)) => {
            let marker = F::escaped(&digits::marker(task.language, task.log, task.tree, event));
            // The sentence is the language's own and has nothing that a format reads.
            let color = value::<F>(task, &Value::Triple(color), last_color(task));
            let sentence = (texts.conclusion)(&F::Formulas::within_text(color));
            around(F::RESULT, &(sentence + &marker))
        }
        None => around(F::PARAGRAPH, &F::escaped(texts.no_result)),
    };
    out += &(heading(texts.contributions) + &shares::<F>(task));
    out.truncate(out.trim_end().len());
    out + F::END
}

fn around([before, behind]: Around, text: &str) -> String {
    format!("{before}{text}{behind}")
}

fn between([before, between, behind]: [&str; 3], first: &str, second: &str) -> String {
    format!("{before}{first}{between}{second}{behind}")
}

/// A value, linked with the event that computed it.
fn value<F: Format>(task: &Task, value: &Value, source: Option<usize>) -> String {
    F::Formulas::linked(F::Formulas::value(task.numbers(), value), source)
}

/// `symbol = value`
fn assignment<F: Format>(task: &Task, name: Name, value: &Value, source: Option<usize>) -> String {
    let value = self::value::<F>(task, value, source);
    around(F::ASSIGNMENT, &format!("{} = {value}", F::Formulas::symbol(name.symbol())))
}

/// The event that computed the pixel's colour, where one sample is the pixel.
fn last_color(task: &Task) -> Option<usize> {
    let is_color = |event: &usize| match task.log.events[*event].what {
        What::Note { name, .. } => name.is(Name::CombineColor),
        _ => false,
    };
    let has_samples = task.tree.nodes().iter().any(|node| matches!(node.step, Some(Step::Sample { .. })));
    (0..task.log.events.len()).rev().find(is_color).filter(|_| !has_samples)
}

fn figures<F: Format>(task: &Task) -> String {
    let figures = Figures::of(task);
    let notes = figures.notes.iter().map(|note| around(F::PARAGRAPH, &F::note(note)));
    let tree = figures.tree(task).map(|tree| F::ray_tree(task, &tree));
    let plan = figures.plan.as_ref().map(|plan| F::schematic(task, plan));
    notes.chain(tree).chain(plan).collect()
}

fn section<F: Format>(out: &mut String, task: &Task, section: &Section) {
    // A pixel of one sample is said in the title.
    let is_shown = !section.is_wrapper();
    if is_shown {
        *out += &F::open(task, section, &F::escaped(&section.title));
    }
    // Steps after another ray's are told to be this one's again.
    let mut is_away = false;
    for item in &section.items {
        match item {
            Item::Section(inside) => {
                if is_away && inside.kind != Kind::Ray && !F::IS_NESTED {
                    let title = (task.language.texts().solution.back)(&lowered(&section.title));
                    *out += &around(F::BACK, &F::escaped(&title));
                }
                is_away = inside.kind == Kind::Ray && section.kind == Kind::Ray;
                self::section::<F>(out, task, inside);
            }
            Item::Given(values) => {
                let values = values.iter().map(|(name, value, source)| assignment::<F>(task, *name, value, *source));
                let values = values.collect::<Vec<_>>().join(F::COMMA);
                *out += &around(F::GIVEN, &format!("{} {values}", task.language.texts().solution.with));
            }
            Item::Equations(events) => *out += &F::equations(task, events),
            Item::Decision(event) => {
                let words = F::escaped(&decision(task, *event).unwrap_or_default());
                let numbers = notation::comparisons::<F::Formulas>(task.numbers(), task.log, task.tree, *event);
                let numbers = numbers.map_or(String::new(), |numbers| format!(" ({numbers})"));
                *out += &around(F::DECISION, &(words + &numbers));
            }
        }
    }
    if is_shown {
        *out += F::CLOSE;
    }
}

fn shares<F: Format>(task: &Task) -> String {
    let texts = &task.language.texts().solution;
    let shares = Shares::of(task);
    let rows: Vec<_> = shares.rows.iter().map(|row| row.each_ref().map(|cell| F::escaped(cell))).collect();
    let table = F::table(&texts.columns.map(F::escaped), &rows);
    if shares.ended.is_empty() {
        return table;
    }
    let ended = shares.ended.iter().map(|(path, why)| format!("{path}: {why}"));
    let more = (shares.more > 0).then(|| (texts.more)(shares.more));
    let items = ended.chain(more).map(|item| around(F::ITEM, &F::escaped(&item)));
    table + &between(F::LIST, &F::escaped(texts.brings_nothing), &items.collect::<String>())
}
