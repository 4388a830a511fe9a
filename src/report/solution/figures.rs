//! What the figures of a worked solution show.

use super::Task;
use crate::log::Step;
use crate::report::contributions::pixel_around;
use crate::report::ray_tree::{self, Branch, Figure};
use crate::report::schematic::{self, Plan};

/// The most rays of a tree that is drawn on a page.
const MOST_RAYS: usize = 120;

/// The rays of a ray tree, and what is to be said of those that aren't there.
pub(super) struct Figures {
    /// The rays; empty if they are too many.
    pub branches: Vec<Branch>,
    /// What isn't shown.
    pub notes: Vec<String>,
    /// The schematic, if there are rays to be drawn.
    pub plan: Option<Plan>,
}

impl Figures {
    pub(super) fn of(task: &Task) -> Figures {
        let texts = &task.language.texts().figure;
        let pixel = pixel_around(task.tree, 0);
        let mut branches = ray_tree::branches(task.log, task.tree, pixel);
        let mut notes = Vec::new();
        if branches.len() > 1 {
            notes.push((texts.first_sample)(branches.len()));
            branches.truncate(1);
        }
        let rays = ray_tree::count(&branches);
        if rays > MOST_RAYS {
            notes.push((texts.too_many)(rays));
            branches.clear();
        }
        let is_sample = |child: &usize| matches!(task.tree.nodes()[*child].step, Some(Step::Sample { .. }));
        let first = task.tree.children(pixel).find(is_sample).unwrap_or(pixel);
        let plan = schematic::plan(task.log, task.tree, first, task.stage, task.language);
        Figures { branches, notes, plan }
    }

    /// The ray tree, if it is drawn.
    pub(super) fn tree<'a>(&'a self, task: &Task<'a>) -> Option<Figure<'a>> {
        let figure = Figure { log: task.log, branches: &self.branches, language: task.language, style: task.style };
        (!self.branches.is_empty()).then_some(figure)
    }
}

/// The caption of the schematic.
pub(super) fn caption(task: &Task, plan: &Plan) -> String {
    let texts = &task.language.texts().figure;
    let [right, up] = plan.axes;
    format!("{} ({})", texts.schematic, (texts.plane)(right, up))
}
