//! Lists that explain: where a value comes from and goes, why a pixel has its colour, what a value is in other arithmetics.
//!
//! What they say is made in `report`, once, when a list is opened; here it becomes lines.

use super::effect::Effect;
use super::model::Model;
use super::model::list::{Entry, Kind, Listing, MOST, cells};
use super::theme::Role;
use super::{account, glossary, listing, paper};
use crate::log::{Digits, Log, Name, Tree, Value, What};
use crate::report::contributions;
use crate::report::provenance;
use crate::report::side_by_side::{self, Row, Run};

/// Opens a list of this kind, made from where the model is now.
pub(super) fn open(model: &mut Model, kind: Kind) -> Effect {
    if !may_open(model, kind) {
        return Effect::None;
    }
    if kind == Kind::Arithmetics && model.others.is_empty() {
        return Effect::Compare;
    }
    if kind == Kind::Causes && model.understanding.study.is_none() {
        return Effect::Study(None);
    }
    if kind == Kind::Book && model.understanding.book.is_none() {
        return Effect::Book;
    }
    model.understanding.listing = Some((kind, make(model, kind)));
    listing::open(model, kind);
    Effect::None
}

/// Whether a list of this kind tells nothing that is to be found out first; says why if it does.
fn may_open(model: &mut Model, kind: Kind) -> bool {
    let tells_results = !matches!(kind, Kind::Operands | Kind::Uses | Kind::Glossary);
    let why = if tells_results && model.understanding.quiz.is_some() {
        Some(model.texts().quiz.tells_results)
    } else if let Some(why) = is_to_come(model, kind) {
        Some(why)
    } else {
        (kind == Kind::Worst && model.picture.is_none()).then_some(model.texts().messages.no_scene)
    };
    if let Some(why) = why {
        model.say(why);
    }
    why.is_none()
}

/// Opens the list of causes, in the viewer's arithmetic if no other is named.
pub(super) fn study(model: &mut Model, arithmetic: &str) -> Effect {
    if arithmetic.is_empty() {
        open(model, Kind::Causes)
    } else if may_open(model, Kind::Causes) {
        Effect::Study(Some(arithmetic.to_owned()))
    } else {
        Effect::None
    }
}

/// What to say where a list would tell what is to come while the tree grows. Operands never are: they come before their values.
fn is_to_come(model: &Model, kind: Kind) -> Option<&'static str> {
    model.guide.grown?;
    let texts = &model.texts().lists.to_come;
    let own = |node: usize| model.tree.own_events(node).next_back();
    match kind {
        // The colour is the last that a pixel comes to, and says of what was computed before what it brings.
        Kind::Contributions | Kind::Causes | Kind::Book => own(contributions::pixel_around(&model.tree, model.cursor))
            .filter(|last| !model.guide.is_known(*last))
            .map(|_| texts.color),
        Kind::Arithmetics => own(model.cursor).filter(|last| !model.guide.is_known(*last)).map(|_| texts.node),
        Kind::Uses => Some(texts.uses),
        _ => None,
    }
}

fn make(model: &Model, kind: Kind) -> Listing {
    match kind {
        Kind::Operands => operands(model),
        Kind::Uses => uses(model),
        Kind::Contributions => account::listing(model),
        Kind::Causes => paper::causes(model),
        Kind::Book => paper::book(model),
        Kind::Glossary => glossary::listing(model),
        Kind::Worst => worst(model),
        _ => arithmetics(model),
    }
}

/// The quantity at the current step, such as `T2_A`; else what the step is.
fn subject(model: &Model) -> String {
    match model.log.events.get(model.event).map(|event| &event.what) {
        Some(What::Note { name, .. }) => name.symbol().to_owned(),
        _ => (model.texts().lists.step)(model.step()),
    }
}

/// Where an event is: `step 12, C R, sphere.t2_a`.
fn whereabouts(model: &Model, event: usize) -> String {
    let path = model.tree.path(model.tree.owner(event));
    let path = if path.is_empty() { path } else { format!(", {path}") };
    let what = match &model.log.events[event].what {
        What::Note { name, .. } => name.key().to_owned(),
        _ => model.title(model.tree.owner(event)),
    };
    format!("{}{path}, {what}", (model.texts().lists.step)(event + 1))
}

fn operands(model: &Model) -> Listing {
    let texts = &model.texts().lists;
    let found = provenance::operands(&model.log, &model.tree, model.event);
    let entry = |operand: &provenance::Operand| {
        let value = model.value(&operand.value);
        let light = operand.light.map_or(String::new(), |light| format!(" ({})", model.title(light)));
        let from = match operand.computed {
            Some(event) => whereabouts(model, event),
            None => (texts.given_in)(&whereabouts(model, operand.event)),
        };
        Entry::to(operand.computed.unwrap_or(operand.event), format!("{}{light}\t{value}\t{from}", operand.symbol))
    };
    let entries = found.iter().take(MOST).map(entry).collect();
    Listing::of(&texts.operands, (texts.operands_title)(&subject(model)), &[], entries)
}

fn uses(model: &Model) -> Listing {
    let entry = |event: usize| {
        let shown = match &model.log.events[event].what {
            What::Note { name, value } if !model.hides(event) => {
                format!("{} = {}", name.symbol(), model.value(value))
            }
            What::Note { name, .. } => {
                name.formula().map_or(name.symbol().to_owned(), |formula| format!("{} = {formula}", name.symbol()))
            }
            _ => model.title(model.tree.owner(event)),
        };
        Entry::to(event, format!("{shown}\t{}", whereabouts(model, event)))
    };
    let found = provenance::uses(&model.log, &model.tree, model.event, MOST);
    let texts = &model.texts().lists;
    Listing::of(&texts.uses, (texts.uses_title)(&subject(model)), &[], found.into_iter().map(entry).collect())
}

fn arithmetics(model: &Model) -> Listing {
    let trees: Vec<Tree> = model.others.iter().map(|log| Tree::of(&log.events)).collect();
    let own = Run { log: &model.log, tree: &model.tree };
    let others = model.others.iter().zip(&trees).map(|(log, tree)| Run { log, tree });
    let runs: Vec<_> = std::iter::once(own).chain(others).collect();
    let table = side_by_side::table(&runs, model.cursor);
    // The log that is shown is in its own column, too; the others are taken where it isn't that.
    let is_of = |log: &Log, start: &str| log.header.arithmetic.starts_with(start);
    let column = |start: &str| runs.iter().position(|run| is_of(run.log, start));
    let [hand, single, double] = ["decimal", "f32", "f64"].map(column);
    let texts = &model.texts().lists.arithmetics;
    let mut entries = Vec::new();
    for row in table.rows.iter().take(MOST) {
        entries.extend(row_entries(model, row, [hand, single, double]));
    }
    for (number, name) in [hand, single, double].into_iter().zip(texts.names) {
        let Some(number) = number else { continue };
        if !table.reaches[number] {
            entries.push(Entry::plain((texts.never_reached)(name), Role::Blocked));
        } else if !table.agrees[number] {
            entries.push(Entry::plain((texts.other_decisions)(name), Role::Blocked));
        }
    }
    let title = (texts.title)(&model.title(model.cursor));
    // The digits that can be trusted are those of f64; it is the widest, and so the last.
    Listing::of(&texts.list, title, &[1, 2, 3, 4], entries)
}

/// The pixels that single precision misses most, as far as that is known yet.
fn worst(model: &Model) -> Listing {
    let texts = &model.texts().lists;
    let Some(view) = &model.picture else { return Listing::default() };
    let mut wrong: Vec<_> = view.image.values(|dot| dot.error.filter(|error| *error > 0.0)).collect();
    // Stable: equal ones stay in the order of the picture.
    wrong.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    let entry = |(pixel, error): ([u32; 2], f64)| {
        let color = view.image.at(pixel).map_or(String::new(), |dot| model.color(dot.color));
        let text = cells([model.value(&Value::Number(error)), format!("{},{}", pixel[0], pixel[1]), color]);
        Entry { pixel: Some(pixel), ..Entry::plain(text, Role::Text) }
    };
    let entries = wrong.into_iter().take(MOST).map(entry).collect();
    Listing::of(&texts.worst, texts.worst_title, &[], entries)
}

/// A line a component.
fn row_entries(model: &Model, row: &Row, columns: [Option<usize>; 3]) -> Vec<Entry> {
    let texts = &model.texts().lists.arithmetics;
    let values = columns.map(|column| column.and_then(|column| row.values[column]));
    let count = values.iter().flatten().map(|value| value.components().len()).max().unwrap_or(1);
    let component = |index: usize| {
        let number = |value: Option<Value>| value.and_then(|value| value.components().get(index).copied());
        let [hand, single, double] = values.map(number);
        let absent = || texts.not_reached.to_owned();
        let marked = |text: String| model.language.marked(text);
        let axis = if count == 1 { "" } else { [" 1", " 2", " 3"][index.min(2)] };
        let text = cells([
            format!("{}{axis}", row.name.map_or(texts.color, Name::symbol)),
            hand.map_or_else(absent, |x| marked(shortest(x, |x| x.to_string()))),
            single.map_or_else(absent, |x| marked(shortest(x, |x| (x as f32).to_string()))),
            digits(row.digits, index, texts.decided_otherwise),
            double.map_or_else(absent, |x| marked(shortest(x, |x| x.to_string()))),
        ]);
        match row.event {
            Some(event) => Entry::to(event, text),
            None => Entry::plain(text, Role::Blocked),
        }
    };
    (0..count).map(component).collect()
}

/// A number with the fewest digits that tell it from its neighbours; very long ones with a power of ten.
fn shortest(x: f64, plain: impl Fn(f64) -> String) -> String {
    const ROOM: usize = 20;
    let text = plain(x);
    if text.len() <= ROOM { text } else { format!("{x:e}") }
}

fn digits(digits: Option<Digits>, component: usize, decided_otherwise: &str) -> String {
    match digits {
        Some(Digits::Significant(count)) => {
            count.components().get(component).map_or(String::new(), |count| format!("{:.0}", count.floor()))
        }
        Some(Digits::DecisionDiffers) => decided_otherwise.to_owned(),
        None => String::new(),
    }
}
