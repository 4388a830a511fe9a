//! The comparison that a decision was taken by, with its numbers: `L2oc > r²: 178.024 > 9`.
//!
//! A log says what was decided, and has the numbers. Which of them were compared is in one table here; what is shown holds for the
//! logged numbers, and where the tracer took twice the digits, for those.

mod table;

use super::evaluate::{doubled_value, evaluate_with};
use super::expression::{self, Expression, Leaf};
use super::{Style, number};
use crate::log::formula::Formula;
use crate::log::{Decision, Log, Name, Step, Tree, Value, What, scope};
use table::{PRINTED_REFLECTION, Parsed, Reasons, SETS_OFF_INWARD, groups, hits, misses, parsed};

/// How two sides are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `<`
    Less,
    /// `≤`
    AtMost,
    /// `=`
    Equal,
    /// `≥`
    AtLeast,
    /// `>`
    Greater,
}

/// A comparison that holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The relation.
    pub relation: Relation,
    /// Both sides with their symbols.
    pub symbolic: [Expression; 2],
    /// Both sides with the numbers put in.
    pub substituted: [Expression; 2],
    /// What both sides come to.
    pub values: [f64; 2],
    /// Whether that was computed with twice the digits.
    pub is_doubled: bool,
    /// How the numbers are shown: with so many decimals that different ones look different.
    pub style: Style,
}

impl Comparison {
    /// Both sides with the numbers put in, and behind what is computed what it comes to: `1 − 0.704/0.391 = -0.802`. What equals a
    /// number has that on the other side.
    pub fn numbers(&self, text: &dyn Fn(&Expression) -> String) -> [String; 2] {
        [0, 1].map(|side| {
            let put_in = &self.substituted[side];
            match (put_in.ungrouped(), self.relation) {
                (Formula::Number(_) | Formula::Leaf(Leaf::Value(..)), _) | (_, Relation::Equal) => text(put_in),
                _ => format!("{} = {}", text(put_in), text(&Expression::value(Value::Number(self.values[side]), None))),
            }
        })
    }
}

impl Relation {
    /// Every relation with its sign.
    pub const SIGNS: [(Relation, &'static str); 5] = [
        (Relation::Less, "<"),
        (Relation::AtMost, "≤"),
        (Relation::Equal, "="),
        (Relation::AtLeast, "≥"),
        (Relation::Greater, ">"),
    ];

    /// The sign.
    pub fn sign(self) -> &'static str {
        Relation::SIGNS.iter().find(|(relation, _)| *relation == self).map_or("", |(_, sign)| sign)
    }

    /// Whether two numbers are in this relation.
    pub fn holds(self, [left, right]: [f64; 2]) -> bool {
        match self {
            Relation::Less => left < right,
            Relation::AtMost => left <= right,
            Relation::Equal => left == right,
            Relation::AtLeast => left >= right,
            Relation::Greater => left > right,
        }
    }
}

/// What is known from outside the node that decides; all else must be its own.
const FROM_OUTSIDE: &[&str] = &["O", "d", "N", "N_g", "L", "|ℓ|", "K_d", "K_e", "n_g"];

/// How much of the largest number of a test f64 may lose of a difference: what differs by more wasn't computed from these numbers.
const LOST: f64 = 1e-6;

/// The comparisons by which the decision of an event was taken; none for what isn't decided by numbers, or by some that the log hasn't.
pub fn comparisons(log: &Log, tree: &Tree, event: usize, style: Style) -> Vec<Comparison> {
    let Some(What::Mark(decision)) = log.events.get(event).map(|event| &event.what) else { return Vec::new() };
    if let Decision::Occluded { object } = decision {
        let Some(hit) = blocking(log, tree, event, *object) else { return Vec::new() };
        return Decider { log, tree, event: hit, style }.first(&["t < |ℓ|", "t > 0"]).into_iter().collect();
    }
    let decider = Decider { log, tree, event, style };
    if *decision == Decision::TotalInternalReflection && log.header.tracing.formulas.as_deref() == Some("notes") {
        return decider.first(&[PRINTED_REFLECTION]).into_iter().collect();
    }
    if let Decision::Miss { why } = decision {
        return decider.reason(misses(*why, decider.operand("t_0").is_some()));
    }
    if *decision == Decision::Inside && decider.leaves_sphere() {
        return decider.first(&[SETS_OFF_INWARD]).into_iter().collect();
    }
    let groups = groups(decision).iter().enumerate();
    let is_of_origin = |number: usize| *decision == Decision::Hit && number == 0;
    let groups = groups.filter(|(number, _)| !is_of_origin(*number) || decider.is_outside());
    let mut found: Vec<Comparison> = groups.filter_map(|(_, group)| decider.first(group)).collect();
    if *decision == Decision::Hit && decider.operand("t").is_none() {
        found.extend(decider.reason(hits(decider.operand("t_0").is_some())));
    }
    found
}

/// The hit of the test that found what blocks a shadow ray.
fn blocking(log: &Log, tree: &Tree, mark: usize, object: u32) -> Option<usize> {
    let start = tree.nodes()[tree.owner(mark)].events.start;
    scope::latest_hit(&log.events, tree, mark, object).filter(|hit| *hit >= start)
}

#[derive(Clone, Copy)]
struct Decider<'a> {
    log: &'a Log,
    tree: &'a Tree,
    event: usize,
    style: Style,
}

impl Decider<'_> {
    /// The first comparison whose quantities the log holds and that holds for them.
    fn first(&self, group: &[&'static str]) -> Option<Comparison> {
        group.iter().find_map(|text| self.comparison(parsed(text)?))
    }

    /// The comparisons of the first reason all of which hold: for the logged numbers, or else with twice the digits.
    fn reason(&self, reasons: Reasons) -> Vec<Comparison> {
        let all = |texts: &[&'static str], holds: &dyn Fn(&Parsed) -> Option<Comparison>| {
            texts.iter().map(|text| holds(parsed(text)?)).collect::<Option<Vec<_>>>()
        };
        let plain = reasons.iter().find_map(|texts| all(texts, &|parsed| self.plain_comparison(parsed)));
        plain
            .or_else(|| reasons.iter().find_map(|texts| all(texts, &|parsed| self.comparison(parsed))))
            .unwrap_or_default()
    }

    fn comparison(&self, parsed: &Parsed) -> Option<Comparison> {
        self.plain_comparison(parsed).or_else(|| self.doubled_comparison(parsed))
    }

    /// A comparison that holds for the logged numbers.
    fn plain_comparison(&self, parsed: &Parsed) -> Option<Comparison> {
        self.told(parsed, self.plain([&parsed.0, &parsed.2])?, false)
    }

    /// A comparison that holds with twice the digits.
    fn doubled_comparison(&self, parsed: &Parsed) -> Option<Comparison> {
        let sides = [&parsed.0, &parsed.2];
        let (plain, values) = (self.plain(sides)?, self.doubled(sides)?);
        // What another program logged may contradict its own operands: then nothing is known of what it compared.
        if (0..2).any(|side| (values[side] - plain[side]).abs() > LOST * self.size()) {
            return None;
        }
        self.told(parsed, values, true)
    }

    /// A comparison of these values, if it holds.
    fn told(&self, (left, relation, right): &Parsed, values: [f64; 2], is_doubled: bool) -> Option<Comparison> {
        if !relation.holds(values) {
            return None;
        }
        let substituted = [left, right].map(|side| {
            let put_in = if is_doubled {
                expression::substituted_doubled(self.log, self.tree, self.event, side, self.style)
            } else {
                expression::substituted(self.log, self.tree, self.event, side, self.style, &[])
            };
            put_in.unwrap_or(Formula::Number(0.0))
        });
        let (relation, symbolic) = (*relation, [left, right].map(Expression::symbolic));
        let style = telling(relation, values, self.style);
        Some(Comparison { relation, symbolic, substituted, values, is_doubled, style })
    }

    fn plain(&self, sides: [&Formula; 2]) -> Option<[f64; 2]> {
        let operand = |symbol: &'static str, _| self.operand(symbol);
        numbers(sides.map(|side| evaluate_with(self.log, self.tree, self.event, side, &operand)))
    }

    /// What more digits say, where the tracer took more: in f64, and where it noted so or no more numbers.
    fn doubled(&self, sides: [&Formula; 2]) -> Option<[f64; 2]> {
        let is_f64 = self.log.header.arithmetic == "f64";
        let values = || sides.map(|side| doubled_value(&self.log.events, self.tree, self.event, side));
        is_f64.then(values).and_then(numbers)
    }

    fn operand(&self, symbol: &str) -> Option<Value> {
        let events = &self.log.events;
        let operand = if FROM_OUTSIDE.contains(&symbol) {
            scope::operand(events, self.tree, self.event, symbol)
        } else {
            scope::operand_in_node(events, self.tree, self.event, symbol).filter(|own| own.event >= self.begin())
        };
        operand.map(|operand| operand.value)
    }

    /// Where what was noted for this decision begins: behind the last time that more samples were asked for.
    fn begin(&self) -> usize {
        let own = self.tree.owner(self.event);
        if own == 0 || matches!(self.tree.nodes()[own].step, Some(Step::Pixel(_))) {
            self.latest(&Decision::MoreSamples { from: 0, to: 0 }).unwrap_or(0)
        } else {
            0
        }
    }

    /// The latest decision of a kind that the node took before this one.
    fn latest(&self, like: &Decision) -> Option<usize> {
        scope::latest_mark(&self.log.events, self.tree, self.tree.owner(self.event), self.event, like)
    }

    /// The largest number that the node noted or was given so far.
    fn size(&self) -> f64 {
        scope::size_before(&self.log.events, self.tree, self.tree.owner(self.event), self.event)
    }

    /// Whether the ray leaves the sphere that is tested: its other end is then at 2·T_A, and only the side says where it begins on
    /// which it was sent off.
    fn leaves_sphere(&self) -> bool {
        let own = self.tree.owner(self.event);
        scope::latest_note(&self.log.events, self.tree, own, usize::MAX, Name::SphereTLeaving).is_some()
    }

    fn is_outside(&self) -> bool {
        self.latest(&Decision::Outside).is_some()
    }
}

/// Two values, if both are numbers.
fn numbers([left, right]: [Result<Value, String>; 2]) -> Option<[f64; 2]> {
    Some([left.ok()?.number()?, right.ok()?.number()?])
}

/// A style in which a side that is less than the other looks different.
fn telling(relation: Relation, values: [f64; 2], style: Style) -> Style {
    let [left, right] = values.map(Value::Number);
    let is_strict = matches!(relation, Relation::Less | Relation::Greater);
    if is_strict { number::telling(&left, &right, style) } else { style }
}
