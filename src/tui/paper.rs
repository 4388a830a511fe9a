//! Two lists that need more than the log: the worked example that it is of, and which rounding caused the error of its result.

use super::model::Model;
use super::model::list::{Entry, Listing, cells};
use super::text::with_counted;
use super::theme::Role;
use crate::log::tree::Place;
use crate::log::{Tree, Value};
use crate::report::causes::{Cause, Study};
use crate::report::language::viewer::List;
use crate::report::paper::{Row, Verdict};
use crate::report::words;

/// The worked example in its own order.
pub(super) fn book(model: &Model) -> Listing {
    let Some(book) = &model.understanding.book else { return Listing::default() };
    let texts = &model.texts().lists.book;
    let mut entries = Vec::new();
    for row in &book.rows {
        entries.push(Entry { target: event_of(model, row), ..Entry::plain(book_cells(model, row), Role::Text) });
        if let Verdict::Departs { why } = row.verdict {
            entries.push(Entry::heading(format!("     {}", (texts.why)(row.called, why))));
        }
    }
    Listing::of(&texts.list, (texts.title)(book.scene), &[], entries)
}

fn book_cells(model: &Model, row: &Row) -> String {
    let texts = &model.texts().lists.book;
    let shown = |values: &[f64]| match values {
        [red] => model.value(&Value::Number(*red)),
        [x, y, z] => model.value(&Value::Triple([*x, *y, *z])),
        _ => String::new(),
    };
    let verdict = match row.verdict {
        Verdict::Agrees => texts.agrees,
        Verdict::Format => texts.format,
        Verdict::Departs { .. } => texts.departs,
    };
    cells([
        row.step.to_owned(),
        row.called.to_owned(),
        model.language.paper(row.printed.text),
        verdict.to_owned(),
        shown(&row.recomputed),
        shown(&row.strict),
        shown(&row.exact),
    ])
}

/// The event that notes a quantity of the example, if the log comes to it.
fn event_of(model: &Model, row: &Row) -> Option<usize> {
    let is_it = |event: &usize| {
        let noted = model.log.events[*event].noted();
        noted.is_some_and(|(name, _)| name.key() == row.quantity)
            && model.tree.path(model.tree.owner(*event)) == row.printed.path
    };
    (0..model.log.events.len()).filter(is_it).nth(row.number)
}

/// Which rounding caused the error of the result.
pub(super) fn causes(model: &Model) -> Listing {
    let Some(study) = &model.understanding.study else { return Listing::default() };
    let (language, style) = (model.language, model.numbers);
    let texts = &language.texts().causes;
    let tree = Tree::of(&study.log.events);
    let results = study.results(language, style);
    let widest = results.iter().map(|(called, _)| called.chars().count()).max().unwrap_or(0);
    let result = |(called, value): (&str, String)| Entry::plain(format!("{called:<widest$}  {value}"), Role::Text);
    let mut entries: Vec<_> = results.into_iter().map(result).collect();
    let faint = |text: String| Entry::plain(text, Role::Faint);
    if study.decides_otherwise {
        entries.push(faint(texts.other_tree.to_owned()));
    }
    let (effective, idle) = study.by_effect();
    entries.extend(effective.iter().map(|cause| Entry {
        target: event_in(model, study, &tree, cause.event),
        ..Entry::plain(cause_cells(model, study, &tree, cause), Role::Text)
    }));
    if !idle.is_empty() {
        entries.push(faint((texts.idle)(idle.len())));
    }
    if effective.iter().any(|cause| cause.only.decides_otherwise || cause.all_but.decides_otherwise) {
        entries.push(faint(texts.star.to_owned()));
    }
    let title = (model.texts().lists.causes_title)(&words::arithmetic(&study.log.header));
    Listing::of(&List { columns: in_order(texts.columns), nothing: "" }, title, &[], entries)
}

fn cause_cells(model: &Model, study: &Study, tree: &Tree, cause: &Cause) -> String {
    let [quantity, only, place, all_but] = in_order(study.cells(tree, cause, model.language, model.numbers));
    cells([quantity, only, with_counted(&place, &cause.path), all_but])
}

/// The columns of a study as the viewer has them: the quantity first, and last what is without it.
fn in_order<T>([only, all_but, quantity, place]: [T; 4]) -> [T; 4] {
    [quantity, only, place, all_but]
}

/// The event of the viewer's log in the place of one of the study's, which has the log of an unrounded computation.
fn event_in(model: &Model, study: &Study, tree: &Tree, event: usize) -> Option<usize> {
    Place::of(&study.log, tree, event).find(&model.log, &model.tree).ok()
}
