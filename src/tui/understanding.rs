//! Lists that explain: where a value comes from and goes, why a pixel has its colour, what a value is in other arithmetics.
//!
//! What they say is made in `report`, once, when a list is opened; here it becomes lines.

use super::list::{self, CELL_END, Column, Entry, Kind, Listing};
use super::model::Model;
use super::theme::Role;
use super::update::Effect;
use crate::log::{Digits, Log, Tree, Value, What};
use crate::report::contributions::{self, Account, Ended, Group};
use crate::report::language::Language;
use crate::report::side_by_side::{self, Row, Run};
use crate::report::{number, path_class, provenance, words};
use std::collections::{HashMap, HashSet};

/// The most entries of a list: nobody reads more, and a frame must not wait for them.
const MOST: usize = 500;

/// What the viewer keeps for understanding.
#[derive(Clone, Debug, Default)]
pub struct Understanding {
    /// The list that was opened last, made once.
    pub listing: Option<(Kind, Listing)>,
    /// The quiz, while it is on.
    pub quiz: Option<super::quiz::Quiz>,
    /// The steps whose results somebody answered, of each pixel: the score counts none of them twice.
    pub answered: HashMap<Option<[u32; 2]>, HashSet<usize>>,
}

/// Opens a list of this kind, made from where the model is now.
pub(super) fn open(model: &mut Model, kind: Kind) -> Effect {
    let tells_results = matches!(kind, Kind::Contributions | Kind::Arithmetics);
    if tells_results && model.understanding.quiz.is_some() {
        model.say("that would tell the results; Q ends the quiz");
        return Effect::None;
    }
    if let Some(why) = is_to_come(model, kind) {
        model.say(why);
        return Effect::None;
    }
    if kind == Kind::Arithmetics && model.others.is_empty() {
        return Effect::Compare;
    }
    model.understanding.listing = Some((kind, make(model, kind)));
    list::open(model, kind);
    Effect::None
}

/// What to say where a list would tell what is to come while the tree grows. Operands never are: they come before their values.
fn is_to_come(model: &Model, kind: Kind) -> Option<&'static str> {
    model.guide.grown?;
    let own = |node: usize| model.tree.own_events(node).next_back();
    match kind {
        // The colour is the last that a pixel comes to, and says of what was computed before what it brings.
        Kind::Contributions => own(contributions::pixel_around(&model.tree, model.cursor))
            .filter(|last| !model.guide.is_known(*last))
            .map(|_| "the colour isn't computed yet; t shows the whole tree"),
        Kind::Arithmetics => own(model.cursor)
            .filter(|last| !model.guide.is_known(*last))
            .map(|_| "this node isn't computed yet to its end; t shows the whole tree"),
        Kind::Uses => Some("what takes a value comes after it; t shows the whole tree"),
        _ => None,
    }
}

/// The list of this kind that was opened.
pub(super) fn listing(model: &Model, kind: Kind) -> Listing {
    match &model.understanding.listing {
        Some((of, listing)) if *of == kind => listing.clone(),
        _ => Listing::default(),
    }
}

fn make(model: &Model, kind: Kind) -> Listing {
    match kind {
        Kind::Operands => operands(model),
        Kind::Uses => uses(model),
        Kind::Contributions => account(model),
        _ => arithmetics(model),
    }
}

/// The quantity at the current step, such as `T2_A`; else what the step is.
fn subject(model: &Model) -> String {
    match model.log.events.get(model.event).map(|event| &event.what) {
        Some(What::Note { name, .. }) => name.symbol().to_owned(),
        _ => format!("step {}", model.step()),
    }
}

/// Where an event stands: `step 12, C R, sphere.t2_a`.
fn whereabouts(model: &Model, event: usize) -> String {
    let path = model.tree.path(model.tree.owner(event));
    let path = if path.is_empty() { path } else { format!(", {path}") };
    let what = match &model.log.events[event].what {
        What::Note { name, .. } => name.key().to_owned(),
        _ => words::title(&model.log, &model.tree, model.tree.owner(event)),
    };
    format!("step {}{path}, {what}", event + 1)
}

const OPERANDS: &[Column] = &[Column::text("operand"), Column::text("value"), Column::text("from")];
const USES: &[Column] = &[Column::text("value"), Column::text("computed in")];

fn operands(model: &Model) -> Listing {
    let found = provenance::operands(&model.log, &model.tree, model.event);
    let entry = |operand: &provenance::Operand| {
        let value = number::value(&operand.value, model.numbers);
        let light =
            operand.light.map_or(String::new(), |light| format!(" ({})", words::title(&model.log, &model.tree, light)));
        let from = match operand.computed {
            Some(event) => whereabouts(model, event),
            None => format!("given in {}", whereabouts(model, operand.event)),
        };
        Entry::to(operand.computed.unwrap_or(operand.event), format!("{}{light}\t{value}\t{from}", operand.symbol))
    };
    Listing {
        title: format!("What {} is made of", subject(model)),
        columns: OPERANDS,
        entries: found.iter().take(MOST).map(entry).collect(),
        nothing: "this step takes nothing that the log names",
    }
}

fn uses(model: &Model) -> Listing {
    let entry = |event: usize| {
        let shown = match &model.log.events[event].what {
            What::Note { name, value } if !model.hides(event) => {
                format!("{} = {}", name.symbol(), number::value(value, model.numbers))
            }
            What::Note { name, .. } => {
                name.formula().map_or(name.symbol().to_owned(), |formula| format!("{} = {formula}", name.symbol()))
            }
            _ => words::title(&model.log, &model.tree, model.tree.owner(event)),
        };
        Entry::to(event, format!("{shown}\t{}", whereabouts(model, event)))
    };
    let found = provenance::uses(&model.log, &model.tree, model.event, MOST);
    Listing {
        title: format!("What takes {}", subject(model)),
        columns: USES,
        entries: found.into_iter().map(entry).collect(),
        nothing: "no later step takes it",
    }
}

fn account(model: &Model) -> Listing {
    let account = contributions::account(&model.log, &model.tree, model.cursor);
    let color = number::value(&Value::Triple(account.color), model.numbers);
    let groups = contributions::groups(&account.contributions);
    let mut entries: Vec<_> = groups.iter().take(MOST).map(|group| contribution(model, &account, group)).collect();
    if let Some(rest) = groups.get(MOST..).filter(|rest| !rest.is_empty()) {
        let share: f64 = rest.iter().map(|group| group.sum.share).sum();
        let rest = format!("{}\t\t\t{} smaller ones together", percent(share), rest.len());
        entries.push(Entry::plain(rest, Role::Faint));
    }
    if !account.ended.is_empty() {
        entries.push(Entry::heading(format!("What brings nothing ({}):", account.ended.len())));
    }
    entries.extend(account.ended.iter().take(MOST).map(|ended| self::ended(model, ended)));
    let class = path_class::of_ray(&model.log, &model.tree, model.cursor);
    let class = class.map_or(String::new(), |class| format!(" - here {class}"));
    let title = match account.is_whole {
        true => format!("Why the colour is {color}{class}"),
        false => format!("The log ends before the colour; so far {color}{class}"),
    };
    Listing { title, columns: SHARES, entries, nothing: "no light is accounted for yet" }
}

/// The columns of why a pixel has its colour: first what matters most.
const SHARES: &[Column] = &[
    Column::number("share"),
    Column::text("path"),
    Column::text("times"),
    Column::text("from"),
    Column::text("class"),
    Column::text("figure 14"),
    Column::text("% of r g b"),
    Column::text("brings"),
    Column::text("= own colour * weight"),
];

/// So much of the colour, and of each of its channels, and where it comes from.
fn contribution(model: &Model, account: &Account, Group { sum: part, count }: &Group) -> Entry {
    let header = &model.log.header;
    let origin = words::origin_in(Language::English, header, part.origin);
    let color = number::value(&Value::Triple(part.color), model.numbers);
    let times = if *count == 1 { String::new() } else { format!("×{count}") };
    let weight = (part.weight != [1.0; 3] && *count == 1).then(|| {
        format!("= {} * {}", number::value(&Value::Triple(part.own), model.numbers), triple(model, &part.weight))
    });
    let channel = |channel| {
        part.share_of(channel, &account.color).map_or("-".to_owned(), |x| format!("{:.0}", (100.0 * x).round() + 0.0))
    };
    let channels = format!("[{}]", [0, 1, 2].map(channel).join(" "));
    let (share, cases) = (percent(part.share), part.cases.to_owned());
    let weight = weight.unwrap_or_default();
    let text = cells([share, part.path.clone(), times, origin, part.class.clone(), cases, channels, color, weight]);
    Entry { target: part.event, ..Entry::plain(text, Role::Text) }
}

/// The text of an entry with these cells.
fn cells<const N: usize>(cells: [String; N]) -> String {
    cells.join(CELL_END.encode_utf8(&mut [0; 4]))
}

/// A weight, as one number where the channels have the same.
fn triple(model: &Model, weight: &[f64; 3]) -> String {
    let is_grey = weight[0] == weight[1] && weight[1] == weight[2];
    let value = if is_grey { Value::Number(weight[0]) } else { Value::Triple(*weight) };
    number::value(&value, model.numbers)
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

fn ended(model: &Model, ended: &Ended) -> Entry {
    let why = words::ended_in(Language::English, &model.log, ended, model.numbers);
    Entry { role: Role::Blocked, ..Entry::to(ended.event, format!("  {}  {why}", ended.path)) }
}

/// The columns of the comparison. The digits that can be trusted are those of f64; it is the widest, and so the last.
const COMPARISON: &[Column] = &[
    Column::text(""),
    Column::number("by hand"),
    Column::number("f32"),
    Column::number("digits"),
    Column::number("f64"),
];

fn arithmetics(model: &Model) -> Listing {
    let trees: Vec<Tree> = model.others.iter().map(|log| Tree::of(&log.events)).collect();
    let own = Run { log: &model.log, tree: &model.tree };
    let others = model.others.iter().zip(&trees).map(|(log, tree)| Run { log, tree });
    let runs: Vec<_> = std::iter::once(own).chain(others).collect();
    let table = side_by_side::table(&runs, model.cursor);
    // The log that is shown stands in its own column, too; the others are taken where it isn't that.
    let is_of = |log: &Log, start: &str| log.header.arithmetic.starts_with(start);
    let column = |start: &str| runs.iter().position(|run| is_of(run.log, start));
    let [hand, single, double] = ["decimal", "f32", "f64"].map(column);
    let mut entries = Vec::new();
    for row in table.rows.iter().take(MOST) {
        entries.extend(row_entries(row, [hand, single, double]));
    }
    for (number, name) in [(hand, "by hand"), (single, "in f32"), (double, "in f64")] {
        let Some(number) = number else { continue };
        if !table.reaches[number] {
            entries.push(Entry::plain(format!("not reached {name}: it decides otherwise before"), Role::Blocked));
        } else if !table.agrees[number] {
            entries.push(Entry::plain(format!("other decisions {name} in this node"), Role::Blocked));
        }
    }
    let title = format!("{} in three arithmetics", words::title(&model.log, &model.tree, model.cursor));
    Listing { title, columns: COMPARISON, entries, nothing: "this node computes nothing itself" }
}

/// A line a component.
fn row_entries(row: &Row, columns: [Option<usize>; 3]) -> Vec<Entry> {
    let values = columns.map(|column| column.and_then(|column| row.values[column]));
    let count = values.iter().flatten().map(|value| value.components().len()).max().unwrap_or(1);
    let component = |index: usize| {
        let number = |value: Option<Value>| value.and_then(|value| value.components().get(index).copied());
        let [hand, single, double] = values.map(number);
        let absent = || "not reached".to_owned();
        let axis = if count == 1 { "" } else { [" 1", " 2", " 3"][index.min(2)] };
        let text = cells([
            format!("{}{axis}", row.name.symbol()),
            hand.map_or_else(absent, |x| shortest(x, |x| x.to_string())),
            single.map_or_else(absent, |x| shortest(x, |x| (x as f32).to_string())),
            digits(row.digits, index),
            double.map_or_else(absent, |x| shortest(x, |x| x.to_string())),
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

fn digits(digits: Option<Digits>, component: usize) -> String {
    match digits {
        Some(Digits::Significant(count)) => {
            count.components().get(component).map_or(String::new(), |count| format!("{:.0}", count.floor()))
        }
        Some(Digits::DecisionDiffers) => "0: decided otherwise".to_owned(),
        None => String::new(),
    }
}
