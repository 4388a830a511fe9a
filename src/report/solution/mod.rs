//! The computation of a pixel as the source text writes its example (Ramos, section 1.3): what the problem states, numbered steps
//! with formulas, the numbers put in and the results, the figures, and what adds to the colour.
//!
//! Here the log becomes an outline that knows no format; `markdown`, `latex` and `html` write it.

mod data;
mod equation;
mod figures;
mod format;
mod html;
mod latex;
mod markdown;
mod math;
mod shares;
mod steps;

pub use html::html;
pub use latex::latex;
pub use markdown::markdown;

use super::Style;
use super::contributions::{self, pixel_around};
use super::language::Language;
use super::notation::Numbers;
use super::schematic::Stage;
use super::{digits, words};
use crate::log::{Log, Name, Tree, Value, What};
use data::Data;

/// What a worked solution is made of, and how.
pub struct Task<'a> {
    /// The log.
    pub log: &'a Log,
    /// Its nodes.
    pub tree: &'a Tree,
    /// What is known of the scene.
    pub stage: Stage<'a>,
    /// The language.
    pub language: Language,
    /// How numbers are shown.
    pub style: Style,
}

impl Task<'_> {
    fn numbers(&self) -> Numbers {
        Numbers { language: self.language, style: self.style }
    }
}

/// The outline of a worked solution.
struct Solution {
    title: String,
    /// How it was computed, in sentences.
    conditions: Vec<String>,
    data: Data,
    steps: Section,
    /// The colour of the pixel, and the event that says so.
    result: Option<([f64; 3], usize)>,
}

/// A part of the steps with a heading.
struct Section {
    kind: Kind,
    title: String,
    items: Vec<Item>,
}

/// What a section is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// A pixel, a sample or a ray; it contains steps.
    Ray,
    /// A step, by its number.
    Step(usize),
    /// A part of a step: a light, a shadow ray, a test.
    Part,
}

/// What is in a section.
enum Item {
    /// Inputs that the problem states, or that another step passes on.
    Given(Vec<(Name, Value, Option<usize>)>),
    /// Values computed one after the other, by their events.
    Equations(Vec<usize>),
    /// A decision, by its event.
    Decision(usize),
    /// A section inside.
    Section(Section),
}

impl Solution {
    fn of(task: &Task) -> Solution {
        let (log, tree, texts) = (task.log, task.tree, task.language.texts());
        let header = &log.header;
        let subject = words::subject_in_frame(task.language, header);
        let tracing = &header.tracing;
        let (arithmetic, algorithm) = (words::arithmetic(header), words::plain(&tracing.algorithm));
        let mut conditions = vec![(texts.solution.conditions)(&arithmetic, &algorithm, tracing.max_depth)];
        conditions.extend(words::sampling(task.language, header).map(|method| (texts.solution.sampled)(&method)));
        let data = Data::of(log, tree);
        Solution {
            title: (texts.solution.title)(&subject, &words::plain(&header.scene.name)),
            conditions,
            steps: steps::steps(task, &data),
            data,
            result: contributions::result(log, tree, pixel_around(tree, 0)),
        }
    }
}

impl Section {
    /// Adds an item; consecutive equations form one group.
    fn push(&mut self, item: Item) {
        match (self.items.last_mut(), item) {
            (Some(Item::Equations(before)), Item::Equations(mut more)) => before.append(&mut more),
            (_, item) => self.items.push(item),
        }
    }

    /// Whether it holds nothing but sections of its own kind, such as a pixel of one sample.
    fn is_wrapper(&self) -> bool {
        self.kind == Kind::Ray && matches!(self.items.first(), Some(Item::Section(first)) if first.kind == Kind::Ray)
    }
}

/// A title within a sentence.
fn lowered(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or(String::new(), |first| first.to_lowercase().chain(characters).collect())
}

/// A decision with what it cost and whether it can be trusted.
fn decision(task: &Task, event: usize) -> Option<String> {
    let happening = &task.log.events[event];
    let What::Mark(decision) = &happening.what else { return None };
    let lost = words::lost(task.language, task.log.given(event), task.style);
    let words = words::decision(task.language, &task.log.header, decision, task.style);
    Some(format!("{words}{lost}{}", digits::marker(task.language, task.log, task.tree, event)))
}

/// A title as the beginning of a sentence.
fn capitalized(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or(String::new(), |first| first.to_uppercase().chain(characters).collect())
}
