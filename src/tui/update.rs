//! What each action does to the model. Nothing is drawn here, and nothing read: `update(model, action)` is all.

use super::effect::{Effect, Exit};
use super::keys::{Action, Walk};
use super::model::fold::previous_sibling;
use super::model::list::Kind;
use super::model::prompt::{Prompt, Purpose};
use super::model::{Model, Overlay, Pane};
use super::steps::{self, Stop};
use super::view::{self, help};
use super::{command, drawn, jumps, list, mouse, panes, play, prompt, quiz, understanding, walk};
use crate::log::tree::Item;
use ratatui::layout::Position;

/// Does an action.
pub fn update(model: &mut Model, action: Action) -> Effect {
    let mut effect = Effect::None;
    match action {
        Action::Digit(digit) => {
            let count = model.pending.count.unwrap_or(0).saturating_mul(10).saturating_add(u32::from(digit));
            model.pending.count = Some(count.min(MOST));
        }
        Action::Prefix(first) => model.pending.prefix = Some(first),
        Action::Resize(width, height) => model.size = (width, height),
        Action::Walk(Walk::Tick) => play::tick(model),
        Action::Typed(key) => effect = prompt::typed(model, key),
        _ => effect = by_key(model, action),
    }
    quiz::visit(model);
    keep_in_view(model);
    effect
}

/// The largest count.
const MOST: u32 = 1_000_000_000;

/// Does the action of a whole key, with the count typed before it.
fn by_key(model: &mut Model, action: Action) -> Effect {
    let count = std::mem::take(&mut model.pending).count;
    if action != Action::Close {
        model.message = None;
    }
    match model.overlay {
        Some(Overlay::Help { top }) => in_help(model, action, top, count),
        Some(Overlay::List { kind, selected, shift }) => list::update(model, action, kind, (selected, shift), count),
        None => in_panes(model, action, count),
    }
}

fn in_panes(model: &mut Model, action: Action, count: Option<u32>) -> Effect {
    let special = panes::in_picture(model, action, count)
        .or_else(|| panes::in_schematic(model, action))
        .or_else(|| drawn::update(model, action));
    if let Some(effect) = special {
        return effect;
    }
    let times = count.unwrap_or(1) as usize;
    match action {
        Action::Down => move_by(model, times as isize),
        Action::Up => move_by(model, -(times as isize)),
        Action::HalfPageDown => move_by(model, pages(model, times) / 2),
        Action::HalfPageUp => move_by(model, -(pages(model, times) / 2)),
        Action::PageDown => move_by(model, pages(model, times)),
        Action::PageUp => move_by(model, -pages(model, times)),
        Action::First => move_by(model, isize::MIN),
        Action::Last => match count {
            None => move_by(model, isize::MAX),
            Some(step) => jumps::to_event(model, (step as usize).saturating_sub(1)),
        },
        Action::Out => (0..times.min(model.tree.nodes().len())).for_each(|_| go_out(model)),
        Action::In | Action::Enter => (0..times.min(model.tree.nodes().len())).for_each(|_| go_in(model)),
        Action::NextSibling => go_along(model, times, |model, node| model.fold.next_sibling(&model.tree, node)),
        Action::PreviousSibling => go_along(model, times, |model, node| previous_sibling(&model.tree, node)),
        Action::Center => model.top = model.fold.up(&model.tree, model.cursor, model.page() / 2).0,
        Action::Toggle => toggle(model),
        Action::OpenSiblings => set_siblings(model, true),
        Action::CloseSiblings => set_siblings(model, false),
        Action::OpenAll => model.fold.set_all(inside(model), true),
        Action::CloseAll => model.fold.set_all(inside(model), false),
        Action::NextValue => step(model, Stop::Value, times, steps::after),
        Action::PreviousValue => step(model, Stop::Value, times, steps::before),
        Action::NextEvent => step(model, Stop::Event, times, steps::after),
        Action::PreviousEvent => step(model, Stop::Event, times, steps::before),
        Action::NextRay => step(model, Stop::Ray, times, steps::after),
        Action::PreviousRay => step(model, Stop::Ray, times, steps::before),
        Action::SwitchPane => panes::switch(model, 1),
        Action::PreviousPane => panes::switch(model, -1),
        Action::OnlyPane => model.is_alone = !model.is_alone,
        Action::Wider => model.shift = panes::shifted(model, times as i64),
        Action::Narrower => model.shift = panes::shifted(model, -(times as i64)),
        Action::Operands => return understanding::open(model, Kind::Operands),
        Action::Uses => return understanding::open(model, Kind::Uses),
        Action::Contributions => return understanding::open(model, Kind::Contributions),
        Action::Arithmetics => return understanding::open(model, Kind::Arithmetics),
        Action::Causes => return understanding::open(model, Kind::Causes),
        Action::Glossary => return understanding::open(model, Kind::Glossary),
        Action::Back => return jumps::back(model),
        Action::Quiz => quiz::toggle(model),
        Action::Answer => quiz::ask(model),
        Action::Search => model.prompt = Some(Prompt::new(Purpose::Search)),
        Action::Help => return walk::open_help(model),
        Action::Close => walk::close(model),
        Action::Walk(Walk::Wheel(rows, x, y)) => {
            let action = mouse::wheel(model, rows, x, y);
            return in_panes(model, action, Some(u32::from(rows.unsigned_abs())));
        }
        Action::Walk(Walk::Click(x, y)) => {
            let at = Position { x, y };
            let computed = view::item_at(model, model.layout(model.size).area(Pane::Computation), at);
            return mouse::click(model, at, computed);
        }
        Action::Walk(walk) => return walk::update(model, walk, count),
        Action::Quit => return Effect::Leave(Exit::Quit),
        Action::Interrupt => return Effect::Leave(Exit::Interrupted),
        Action::Suspend => return Effect::Suspend,
        Action::Worst => return understanding::open(model, Kind::Worst),
        Action::ZoomIn | Action::ZoomOut | Action::Brighter | Action::Darker | Action::NextView | Action::CellLeft => {
            model.say(model.texts().messages.other_pane);
        }
        Action::Line(number) => {
            let line = model.guide.bindings.lines().nth(number.into()).map(|(_, line)| line.to_owned());
            let line = line.unwrap_or_default();
            return command::run(model, &line).unwrap_or_else(|why| {
                model.say(&why);
                Effect::None
            });
        }
        Action::Schematic | Action::ShadowRays | Action::RaysOver => model.say(model.texts().messages.other_pane),
        Action::Unknown => model.say(model.texts().messages.no_key),
        Action::Digit(_) | Action::Prefix(_) | Action::Resize(..) | Action::Typed(_) => {}
    }
    Effect::None
}

fn in_help(model: &mut Model, action: Action, top: usize, count: Option<u32>) -> Effect {
    match action {
        Action::Search => model.prompt = Some(Prompt::new(Purpose::Help)),
        Action::Close | Action::Help | Action::Quit | Action::Interrupt => {
            model.overlay = None;
            return Effect::None;
        }
        Action::Suspend => return Effect::Suspend,
        _ => {}
    }
    let top = if action == Action::Search { 0 } else { top };
    let (page, last) = (usize::from(model.size.1 / 2), help::last_top(model));
    let moved = list::moved(action, top, count.unwrap_or(1) as usize, [page; 2], last);
    model.overlay = Some(Overlay::Help { top: moved.unwrap_or(top).min(last) });
    Effect::None
}

/// As many rows as these pages have.
fn pages(model: &Model, count: usize) -> isize {
    (count.saturating_mul(model.page().max(2))).min(isize::MAX as usize / 2) as isize
}

/// Moves by rows: of the tree, or of the computation when that has the focus.
fn move_by(model: &mut Model, rows: isize) {
    let count = rows.unsigned_abs();
    match model.focus {
        Pane::Picture | Pane::Tree | Pane::Code | Pane::Schematic => {
            let node = match rows {
                isize::MAX => model.fold.last(&model.tree),
                isize::MIN => 0,
                _ if rows > 0 => model.fold.down(&model.tree, model.cursor, count).0,
                _ => model.fold.up(&model.tree, model.cursor, count).0,
            };
            if node != model.cursor {
                model.go_to_node(node);
            }
        }
        Pane::Computation => {
            let own = model.items().into_iter().filter_map(|item| match item {
                Item::Event(event) => Some(event),
                Item::Node(_) => None,
            });
            let current = model.event;
            let target = if rows > 0 {
                own.filter(|event| *event > current).take(count).last()
            } else {
                let earlier: Vec<_> = own.filter(|event| *event < current).collect();
                earlier[earlier.len().saturating_sub(count)..].first().copied()
            };
            model.event = target.unwrap_or(current);
        }
    }
}

fn go_out(model: &mut Model) {
    match model.focus {
        Pane::Computation => model.focus = Pane::Tree,
        _ if model.fold.is_open(&model.tree, model.cursor) => model.fold.set(model.cursor, false),
        _ if model.cursor != 0 => model.go_to_node(model.tree.nodes()[model.cursor].parent),
        _ => {}
    }
}

fn go_in(model: &mut Model) {
    match model.focus {
        Pane::Computation if model.hides(model.event) => quiz::ask(model),
        Pane::Computation => {}
        _ => match model.fold.first_inside(&model.tree, model.cursor) {
            None => model.focus_on(Pane::Computation),
            Some(first) if model.fold.is_open(&model.tree, model.cursor) => model.go_to_node(first),
            Some(_) => model.fold.set(model.cursor, true),
        },
    }
}

fn go_along(model: &mut Model, times: usize, next: impl Fn(&Model, usize) -> Option<usize>) {
    let siblings = std::iter::successors(Some(model.cursor), |node| next(model, *node));
    match siblings.skip(1).filter(|node| model.fold.visible.is(*node)).take(times).last() {
        Some(node) => model.go_to_node(node),
        None => model.say(model.texts().messages.no_siblings),
    }
}

fn toggle(model: &mut Model) {
    let is_open = model.fold.is_open(&model.tree, model.cursor);
    model.fold.set(model.cursor, !is_open);
}

fn set_siblings(model: &mut Model, open: bool) {
    let parent = model.tree.nodes()[model.cursor].parent;
    if model.cursor == parent {
        return model.fold.set(parent, open);
    }
    for node in model.tree.children(parent) {
        model.fold.set(node, open);
    }
}

fn inside(model: &Model) -> std::ops::Range<usize> {
    model.cursor..model.tree.nodes()[model.cursor].subtree_end
}

type Find = fn(&[crate::log::Event], usize, Stop, usize) -> Option<usize>;

fn step(model: &mut Model, stop: Stop, times: usize, find: Find) {
    let here = model.event;
    if let Some(event) = find(&model.log.events, here, stop, times) {
        model.go_to_event(event);
        // As far as there are steps, though there are fewer.
        if times == 1 || find(&model.log.events, here, stop, times - 1) != Some(event) {
            return;
        }
    }
    model.say(stop.end(&model.texts().messages));
}

/// After every action the selected node is a row, and on the screen.
fn keep_in_view(model: &mut Model) {
    let row = model.fold.row_of(&model.tree, model.cursor);
    if row != model.cursor {
        model.go_to_node(row);
    }
    model.top = model.fold.scrolled(&model.tree, model.top, model.cursor, model.page());
}
