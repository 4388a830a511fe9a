//! The events of a log as numbered steps: what a ray does one after the other, each with its formulas.

use super::data::Data;
use super::{Item, Kind, Section, Task, capitalized};
use crate::log::tree::Item as Held;
use crate::log::{Decision, Event, Name, Step, Term, What};
use crate::report::{provenance, words};

/// All steps of a log.
pub(super) fn steps(task: &Task, data: &Data) -> Section {
    let mut maker = Maker { task, data, number: 0 };
    maker.container(0)
}

/// What the events of a ray itself do.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    Aim,
    Point,
    Reflection,
    Transmission,
    Blur,
    Sampling,
}

/// The title of a node, with a capital; one that begins with the name of an object stays as it is.
fn titled(task: &Task, node: usize) -> String {
    let title = words::title(task.language, task.log, task.tree, node);
    let begins_with_a_name = matches!(task.tree.nodes()[node].step, Some(Step::Motion { .. }));
    if begins_with_a_name { title } else { capitalized(&title) }
}

struct Maker<'a> {
    task: &'a Task<'a>,
    data: &'a Data,
    number: usize,
}

impl Maker<'_> {
    /// A pixel, a sample, a zone or a ray: its own events make steps, and so do the nodes inside.
    fn container(&mut self, node: usize) -> Section {
        let tree = self.task.tree;
        let title = titled(self.task, node);
        let mut section = Section { kind: Kind::Ray, title, items: Vec::new() };
        let is_ray = matches!(tree.nodes()[node].step, Some(Step::Ray { .. }));
        let mut phase = if is_ray { Phase::Aim } else { Phase::Sampling };
        let mut open: Option<(Phase, Section)> = None;
        for held in tree.items(node) {
            let event = match held {
                Held::Event(event) => event,
                Held::Node(inside) => {
                    section.items.extend(open.take().map(|(_, step)| Item::Section(step)));
                    section.items.push(Item::Section(self.child(inside)));
                    continue;
                }
            };
            let items = self.items(event);
            phase = next_phase(phase, &self.task.log.events[event]);
            if !items.is_empty() {
                if open.as_ref().is_some_and(|(of, _)| *of != phase) {
                    section.items.extend(open.take().map(|(_, step)| Item::Section(step)));
                }
                let (_, step) = open.get_or_insert_with(|| (phase, self.numbered(phase)));
                items.into_iter().for_each(|item| step.push(item));
            }
        }
        section.items.extend(open.map(|(_, step)| Item::Section(step)));
        section
    }

    fn numbered(&mut self, phase: Phase) -> Section {
        let texts = &self.task.language.texts().solution;
        let title = match phase {
            Phase::Aim => texts.aim,
            Phase::Point => texts.point,
            Phase::Reflection => texts.reflection,
            Phase::Transmission => texts.transmission,
            Phase::Blur => texts.blur,
            Phase::Sampling => texts.sampling,
        };
        self.number += 1;
        Section { kind: Kind::Step(self.number), title: title.to_owned(), items: Vec::new() }
    }

    /// A node inside a container.
    fn child(&mut self, node: usize) -> Section {
        let (task, texts) = (self.task, &self.task.language.texts().solution);
        let object = |object: u32| words::plain(task.log.header.object(object));
        let title = match task.tree.nodes()[node].step {
            Some(Step::Test { object: tested, triangle: None }) => (texts.intersection)(&object(tested)),
            Some(Step::Test { object: tested, triangle: Some(triangle) }) => {
                (texts.intersection_triangle)(&object(tested), triangle)
            }
            Some(Step::Motion { object: moving }) => (texts.intersection_moving)(&object(moving)),
            Some(Step::Shade { object: shaded }) => (texts.local)(&object(shaded)),
            Some(Step::Combine) => (texts.combine)(&task.tree.shown_path(node)),
            _ => return self.container(node),
        };
        self.number += 1;
        let number = self.number;
        self.part(node, Kind::Step(number), title)
    }

    /// A step, or a part of one, with all that is inside.
    fn part(&mut self, node: usize, kind: Kind, title: String) -> Section {
        let mut section = Section { kind, title, items: Vec::new() };
        for held in self.task.tree.items(node) {
            match held {
                Held::Event(event) => self.items(event).into_iter().for_each(|item| section.push(item)),
                Held::Node(inside) => {
                    let title = titled(self.task, inside);
                    section.items.push(Item::Section(self.part(inside, Kind::Part, title)));
                }
            }
        }
        section
    }

    /// What an event says, with its inputs before it.
    fn items(&self, event: usize) -> Vec<Item> {
        let (log, tree) = (self.task.log, self.task.tree);
        let happening = &log.events[event];
        let mut items = Vec::new();
        let needed = log.events.given(happening).iter().filter(|(name, _)| !self.data.has(tree, event, *name));
        let needed: Vec<_> = needed.filter(|(name, _)| *name != Name::CutoffLoss).copied().collect();
        if !needed.is_empty() {
            let source = |name: Name, value| (name, value, provenance::handed_on_from(log, tree, event, name, &value));
            items.push(Item::Given(needed.into_iter().map(|(name, value)| source(name, value)).collect()));
        }
        match happening.what {
            What::Note { .. } => items.push(Item::Equations(vec![event])),
            What::Mark(_) => items.push(Item::Decision(event)),
            _ => {}
        }
        items
    }
}

fn next_phase(phase: Phase, event: &Event) -> Phase {
    let of_bounce = |what: Term| match what {
        Term::Reflected => Phase::Reflection,
        Term::Transmitted => Phase::Transmission,
        _ => phase,
    };
    match event.what {
        What::Mark(Decision::Nearest { .. } | Decision::Background) => Phase::Point,
        What::Mark(Decision::TotalInternalReflection) => Phase::Transmission,
        What::Mark(
            Decision::DepthLimit { what }
            | Decision::LeakGuard { what }
            | Decision::Bent { what }
            | Decision::Skipped { what, .. }
            | Decision::Rejected { what },
        ) => of_bounce(what),
        What::Note { name, .. } if name.key().starts_with("reflect.") => Phase::Reflection,
        What::Note { name, .. } if name.key().starts_with("refract.") => Phase::Transmission,
        What::Note { name, .. } if name.key().starts_with("lobe.") => Phase::Blur,
        _ => phase,
    }
}
