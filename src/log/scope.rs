//! Where the operands of a formula come from: the provenance of each value.
//!
//! The symbols of a formula mean the latest quantity of that symbol that the computation could see: in the node itself,
//! in the intersection test that found the nearest hit, then in the enclosing nodes.

use super::event::{Decision, Step, What};
use super::events::Events;
use super::formula::Several;
use super::name::Name;
use super::tree::index::{Nearest, given_at, noted};
use super::tree::{Child, Tree, index};
use super::value::Value;
use std::mem::discriminant;

/// A value that a formula puts in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operand {
    /// The event that noted it or has it among its inputs.
    pub event: usize,
    /// The value.
    pub value: Value,
}

/// What a symbol in the formula of the quantity noted by `event` stands for.
pub fn operand(events: &Events, tree: &Tree, event: usize, symbol: &str) -> Option<Operand> {
    if let Some(value) = given_at(events, event, symbol) {
        return Some(Operand { event, value });
    }
    seen_from(events, tree, tree.owner(event), event, symbol)
}

/// The same among quantities that have one symbol, where others that have it, too, don't count.
pub fn operand_among(events: &Events, tree: &Tree, event: usize, names: &[Name]) -> Option<Operand> {
    let symbol = names.first()?.symbol();
    let has = |at: usize| {
        let noted = events[at].noted().filter(|(name, _)| names.contains(name)).map(|(_, value)| value);
        let given = || events.given(&events[at]).iter().find(|(name, _)| names.contains(name)).map(|(_, value)| *value);
        Some(Operand { event: at, value: noted.or_else(given)? })
    };
    let given = events.given(events.get(event)?).iter().find(|(name, _)| names.contains(name));
    if let Some((_, value)) = given {
        return Some(Operand { event, value: *value });
    }
    let in_place = |place: usize, before: usize| {
        let earlier = |before: usize| in_node(events, tree, place, before, symbol).map(|found| found.event);
        std::iter::successors(earlier(before), |at| earlier(*at)).find_map(has)
    };
    let mut before = event;
    tree.around(tree.owner(event)).find_map(|node| {
        let test = || nearest_test(events, tree, node, before).and_then(|test| in_place(test, before));
        let found = in_place(node, before).or_else(test);
        before = tree.nodes()[node].events.start;
        found
    })
}

/// The same if the event's own node has it, itself and not in a test inside it.
pub fn operand_in_node(events: &Events, tree: &Tree, event: usize, symbol: &str) -> Option<Operand> {
    match given_at(events, event, symbol) {
        Some(value) => Some(Operand { event, value }),
        None => in_node(events, tree, tree.owner(event), event, symbol),
    }
}

/// What a symbol under the Σ of a local intensity stands for, in the part of one light (see [`lights`]).
pub fn operand_of_light(events: &Events, tree: &Tree, light: usize, symbol: &str) -> Option<Operand> {
    seen_from(events, tree, light, tree.nodes()[light].events.end, symbol)
}

/// Whether an operand that a log doesn't hold is 1: a light that doesn't fade, a shadow ray that nothing crosses. Other
/// operands that are absent belong to a term that is zero.
pub fn is_one_when_absent(symbol: &str) -> bool {
    symbol == Name::LightAttenuation.symbol() || symbol == Name::ShadowTransmittance.symbol()
}

/// The nodes of the lights over which the Σ in the formula of `event` adds; none if the sums of its node are too many.
pub fn lights<'t>(events: &Events, tree: &'t Tree, event: usize) -> impl Iterator<Item = usize> + 't {
    let node = Some(tree.owner(event)).filter(|_| is_added_up(events, tree, event));
    let children = node.into_iter().flat_map(|node| tree.children(node));
    children.filter(|child| matches!(tree.nodes()[*child].step, Some(Step::Light { .. })))
}

/// The most sums that are added up, of a pixel and of another node: raywalk has three for each doubling of a pixel's samples, and elsewhere one. In
/// a log from elsewhere each of a hundred thousand could go over as many lights.
const MOST_SUMS: [usize; 2] = [64, 4];

/// Whether the sum that an event notes may be added up once more: it is among the first of its node.
pub fn is_added_up(events: &Events, tree: &Tree, event: usize) -> bool {
    let is_of_pixel = matches!(tree.nodes()[tree.owner(event)].step, None | Some(Step::Pixel(_)));
    sums_before(events, tree, event) < MOST_SUMS[usize::from(!is_of_pixel)]
}

/// How many sums the node of an event has noted before it, where they may be many.
pub fn sums_before(events: &Events, tree: &Tree, event: usize) -> usize {
    tree.index(events).sums(tree.owner(event), event).unwrap_or(0)
}

/// The last node of a kind directly inside a node that ends before an event.
pub fn last_child(events: &Events, tree: &Tree, node: usize, before: usize, kind: Child) -> Option<usize> {
    let ends_before = |child: usize| tree.nodes()[child].events.end <= before;
    match tree.index(events).children(node, kind) {
        Some(children) => {
            let count = children.partition_point(|child| ends_before(*child as usize));
            count.checked_sub(1).map(|at| children[at] as usize)
        }
        None => {
            let before = tree.children(node).take_while(|child| ends_before(*child));
            before.filter(|child| kind.is(events, tree, *child)).last()
        }
    }
}

/// The latest computed quantity of this symbol that can be seen from where an event is, before it; inputs don't count.
pub fn noted_before(events: &Events, tree: &Tree, event: usize, symbol: &str) -> Option<Operand> {
    let in_node = |node, before| noted_in(events, tree, node, before, symbol);
    outward(events, tree, (tree.owner(event), event), (symbol, false), in_node)
}

/// The latest of a node's own quantities of this symbol before an event.
pub fn noted_in(events: &Events, tree: &Tree, node: usize, before: usize, symbol: &str) -> Option<Operand> {
    match tree.index(events).noted(node, before, symbol) {
        Some(event) => event.and_then(|event| noted_as(events, event, symbol)),
        None => tree.own_events_before(node, before).rev().find_map(|event| noted_as(events, event, symbol)),
    }
}

/// What is found in a node before an event, or else in the nodes around it before each begins. What a node sees around it doesn't depend on
/// who asks, so that it is remembered there.
fn outward(
    events: &Events,
    tree: &Tree,
    (mut node, mut before): (usize, usize),
    (symbol, with_inputs): (&str, bool),
    in_node: impl Fn(usize, usize) -> Option<Operand>,
) -> Option<Operand> {
    let memo = &tree.index(events).memo;
    let mut passed = Vec::new();
    let found = loop {
        let found = in_node(node, before);
        if found.is_some() || node == 0 {
            break found;
        }
        before = tree.nodes()[node].events.start;
        if memo.has(node) {
            if let Some(known) = memo.known(node, symbol, with_inputs) {
                break known.and_then(|event| operand_at(events, event, symbol, with_inputs));
            }
            passed.push(node);
        }
        node = tree.nodes()[node].parent;
    };
    memo.remember(&passed, symbol, with_inputs, found.map(|found| found.event));
    found
}

/// What an event has of a symbol: noted, or, if they count, among its inputs.
fn operand_at(events: &Events, event: usize, symbol: &str, with_inputs: bool) -> Option<Operand> {
    let given = || given_at(events, event, symbol).filter(|_| with_inputs);
    Some(Operand { event, value: noted(&events[event], symbol).or_else(given)? })
}

/// The first of a node's own events from one on that notes this quantity.
pub fn first_note(events: &Events, tree: &Tree, node: usize, from: usize, name: Name) -> Option<usize> {
    let is_it = |at: &usize| matches!(events[*at].what, What::Note { name: noted, .. } if noted == name);
    let found = tree.index(events).first_name(node, from, name);
    found.unwrap_or_else(|| tree.own_events_from(node, from).find(is_it))
}

/// The latest of a node's own events before one that notes this quantity.
pub fn latest_note(events: &Events, tree: &Tree, node: usize, before: usize, name: Name) -> Option<usize> {
    let is_it = |at: &usize| matches!(events[*at].what, What::Note { name: noted, .. } if noted == name);
    let found = tree.index(events).names(node, before, name);
    found.unwrap_or_else(|| tree.own_events_before(node, before).rfind(is_it))
}

/// The latest of a node's own events before one that is a decision of this kind, whatever was decided.
pub fn latest_mark(events: &Events, tree: &Tree, node: usize, before: usize, like: &Decision) -> Option<usize> {
    let kind = discriminant(like);
    let is_it = |at: &usize| matches!(&events[*at].what, What::Mark(decision) if discriminant(decision) == kind);
    let found = tree.index(events).marked(node, before, kind);
    found.unwrap_or_else(|| tree.own_events_before(node, before).rfind(is_it))
}

/// The latest event before one, wherever it is, by which a test hits an object.
pub fn latest_hit(events: &Events, tree: &Tree, before: usize, object: u32) -> Option<usize> {
    tree.index(events).hit(before, object)
}

/// The largest number that a node noted or was given before an event.
pub fn size_before(events: &Events, tree: &Tree, node: usize, before: usize) -> f64 {
    let gone_through = || tree.own_events_before(node, before).fold(0.0, |size, at| index::size_of(events, at, size));
    tree.index(events).size(node, before).unwrap_or_else(gone_through)
}

fn seen_from(events: &Events, tree: &Tree, node: usize, before: usize, symbol: &str) -> Option<Operand> {
    outward(events, tree, (node, before), (symbol, true), |node, before| {
        in_node(events, tree, node, before, symbol).or_else(|| {
            nearest_test(events, tree, node, before).and_then(|test| in_node(events, tree, test, before, symbol))
        })
    })
}

fn in_node(events: &Events, tree: &Tree, node: usize, before: usize, symbol: &str) -> Option<Operand> {
    let has = |event: usize| operand_at(events, event, symbol, true);
    match tree.index(events).has(node, before, symbol) {
        Some(event) => event.and_then(has),
        None => tree.own_events_before(node, before).rev().find_map(has),
    }
}

fn noted_as(events: &Events, event: usize, symbol: &str) -> Option<Operand> {
    operand_at(events, event, symbol, false)
}

/// The test, directly inside `node` or in a moving object's frame there, that found the nearest object. A mesh has a test for each triangle; the one at the
/// least distance found it, of several the one of the first triangle.
pub fn nearest_test(events: &Events, tree: &Tree, node: usize, before: usize) -> Option<usize> {
    match tree.index(events).nearest(node) {
        Some(nearest) => nearest?.before(before),
        None => Nearest::of(events, tree, node, before)?.before(before),
    }
}

/// What `Σ_s` and `Σ_c` add over.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Element {
    /// A sample: its node.
    Sample(usize),
    /// A cell: the event that accepts it.
    Cell(usize),
}

/// What a sum in the formula of `event` adds over: the samples or the accepted cells of its pixel so far.
pub fn elements(events: &Events, tree: &Tree, event: usize, several: Several) -> Vec<Element> {
    let pixel = tree.owner(event);
    if !is_added_up(events, tree, event) {
        return Vec::new();
    }
    let is_sample = |child: &usize| matches!(tree.nodes()[*child].step, Some(Step::Sample { .. }));
    let is_cell = |at: &usize| matches!(events[*at].what, What::Mark(Decision::Accepted { cell: Some(_), .. }));
    match several {
        Several::Samples | Several::StandardError | Several::Freedom => {
            let before = tree.children(pixel).take_while(|child| tree.nodes()[*child].events.end <= event);
            before.filter(is_sample).map(Element::Sample).collect()
        }
        Several::Cells => tree.own_events_before(pixel, event).filter(is_cell).map(Element::Cell).collect(),
        Several::Surfaces => Vec::new(),
    }
}

/// What a symbol under `Σ_s` or `Σ_c` stands for in the part of one sample or cell.
pub fn operand_of_element(events: &Events, tree: &Tree, element: Element, symbol: &str) -> Option<Value> {
    match element {
        Element::Cell(mark) => in_node(events, tree, tree.owner(mark), mark + 1, symbol).map(|operand| operand.value),
        Element::Sample(sample) if symbol == Name::CombineColor.symbol() => camera_color(events, tree, sample),
        Element::Sample(sample) => {
            let start = tree.nodes()[sample].events.start;
            events.get(start).and_then(|_| given_at(events, start, symbol))
        }
    }
}

/// The colour of the camera ray inside a pixel or a sample.
fn camera_color(events: &Events, tree: &Tree, around: usize) -> Option<Value> {
    let ray = tree.children(around).find(|child| matches!(tree.nodes()[*child].step, Some(Step::Ray { .. })))?;
    color_of_ray(events, tree, ray)
}

/// The colour of a ray: that of the surface it hit, or the background.
pub fn color_of_ray(events: &Events, tree: &Tree, ray: usize) -> Option<Value> {
    match last_child(events, tree, ray, usize::MAX, Child::Combine) {
        Some(combine) => in_node(events, tree, combine, usize::MAX, Name::CombineColor.symbol()),
        None => in_node(events, tree, ray, usize::MAX, Name::BackgroundColor.symbol()),
    }
    .map(|operand| operand.value)
}

/// The colour of a pixel as the last of its computations has it: the mean of its samples, or the colour of its one ray.
pub fn color_of_pixel(events: &Events, tree: &Tree, pixel: usize) -> Option<Value> {
    let mean = tree.own_events(pixel).rev().find_map(|at| match events[at].what {
        What::Note { name, value } if name.is(Name::PixelMean) || name == Name::StatisticalMean => Some(value),
        _ => None,
    });
    mean.or_else(|| camera_color(events, tree, pixel))
}

/// What the surfaces let through that the shadow ray of a light crosses, whose transmittance `event` notes. It is zero where one lets
/// nothing through, and where the light would leak through the surface itself.
pub fn transmittance(events: &Events, tree: &Tree, event: usize) -> [f64; 3] {
    let light = tree.owner(event);
    let leaks = |at: usize| matches!(events[at].what, What::Mark(Decision::LeakGuard { .. }));
    if tree.own_events_before(light, event).any(leaks) {
        return [0.0; 3];
    }
    let mut part = [1.0_f64; 3];
    for factor in factors(events, tree, event) {
        match factor {
            None => return [0.0; 3],
            Some(factor) => part = [0, 1, 2].map(|k| (part[k] * factor[k]).min(f64::MAX)),
        }
    }
    part.map(|part| part.min(MOST))
}

/// The factors of that product, in the order of the ray; `None` for what lets nothing through.
pub fn factors(events: &Events, tree: &Tree, event: usize) -> Vec<Option<[f64; 3]>> {
    let shadow = last_child(events, tree, tree.owner(event), event, Child::Shadow);
    let Some(ray) = shadow.filter(|_| is_added_up(events, tree, event)) else { return Vec::new() };
    let factor = |at: usize| match events[at].what {
        What::Mark(Decision::Attenuated { factor, .. }) => Some(Some(factor)),
        What::Mark(Decision::Occluded { .. }) => Some(None),
        _ => None,
    };
    tree.own_events(ray).filter_map(factor).collect()
}

/// The largest part of a light that counts, which is that of a colour (`trace::MAX_INTENSITY`).
const MOST: f64 = 1e150;
