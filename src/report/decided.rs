//! The comparison that a decision was taken by, with its numbers: `L2oc > r²: 178.024 > 9`.
//!
//! A log says what was decided, and has the numbers. Which of them were compared stands in one table here; what is shown holds for the
//! logged numbers, and where the tracer took twice the digits, for those.

use super::evaluate::{doubled_value, evaluate_with};
use super::expression::{self, Expression};
use super::language::Language;
use super::{Style, computation, number};
use crate::log::formula::{self, Formula};
use crate::log::{Acceptance, Decision, Log, Miss, SkipReason, Skippable, Split, Step, Tree, Value, What, scope};
use std::collections::HashMap;
use std::sync::LazyLock;

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

/// What may be compared: of each group the first comparison whose quantities the log holds, and which holds for them.
type Groups = &'static [&'static [&'static str]];

/// The point of the line is on the surface.
const MEETS: &[&str] = &[
    "T2_A ≥ 0",
    "Δ ≥ 0",
    "t_in ≤ t_out",
    "min(E) ≥ 0",
    "max(E) ≤ 0",
    "min(E_a, min(E_b, E_c)) ≥ 0",
    "max(E_a, max(E_b, E_c)) ≤ 0",
    "ρ² ≤ r_d·r_d",
    "κ − 2·⌊κ/2⌋ = 1",
];

/// It isn't.
const MISSES: &[&str] = &[
    "T2_A < 0",
    "T2_A = 0",
    "Δ < 0",
    "t_in > t_out",
    "min(E) < 0",
    "min(E_a, min(E_b, E_c)) < 0",
    "ρ² > r_d·r_d",
    "κ − 2·⌊κ/2⌋ = 0",
];

/// By which comparisons a decision is taken; several groups hold together.
fn groups(decision: &Decision) -> Groups {
    match decision {
        Decision::Outside => &[&["L2oc > r²", "c > 0", "min(min(O − b_min, b_max − O)) < 0"]],
        Decision::Inside => &[&["L2oc ≤ r²", "c ≤ 0", "min(min(O − b_min, b_max − O)) ≥ 0"]],
        Decision::Hit => &[&["T_A > 0"], MEETS, &["t > 0", "t = 0"], &["t < |ℓ|"]],
        Decision::Miss { why: Miss::Parallel } => &[&["V_d = 0", "a = 0"]],
        Decision::Miss { why: Miss::Behind } => {
            &[&["t ≤ 0", "t_out ≤ 0", "t_0 + max(t_1, t_2) ≤ 0", "max(t_1, t_2) ≤ 0", "T_A < 0"]]
        }
        Decision::Miss { why: Miss::Beside } => &[MISSES, &["max(E) > 0", "max(E_a, max(E_b, E_c)) > 0"]],
        Decision::Miss { why: Miss::Beyond } => {
            &[&["t ≥ |ℓ|", "t_in ≥ |ℓ|", "t_0 + min(t_1, t_2) ≥ |ℓ|", "min(t_1, t_2) ≥ |ℓ|"]]
        }
        Decision::Miss { why: Miss::FacesAway } => &[&["V_d > 0"]],
        Decision::TotalInternalReflection => &[&["η² − |d + cosφ_1·N|² < 0"]],
        Decision::Skipped { what: Skippable::Shadow, why: SkipReason::Behind } => &[&["N·L < 0", "N·L = 0"]],
        Decision::Skipped { what: Skippable::Shadow, why: SkipReason::NoLocalTerm } => &[&["N·L > 0"]],
        Decision::Rejected { what: Skippable::Transmitted } => &[&["h_z > 0"]],
        Decision::Rejected { .. } => &[&["h_z < 0"]],
        Decision::LeakGuard { .. } => &[&["N_g · L < 0", "N_g · L > 0"]],
        Decision::Bent { what: Skippable::Transmitted } => &[&["N_g · T > 0"]],
        Decision::Bent { .. } => &[&["N_g · R < 0"]],
        Decision::Undefined { .. } => &[&["|D| = 0"]],
        Decision::Subdivided { why: Split::Color, .. } => &[&["Δ_I > Δ_max"]],
        Decision::Accepted { cell: Some(_), why: Acceptance::Alike } => &[&["Δ_I ≤ Δ_max"]],
        Decision::Accepted { cell: None, why: Acceptance::Alike } => &[&["n_p ≥ n_m"]],
        Decision::Accepted { why: Acceptance::Interval, .. } => &[&["h_max ≤ h_lim"]],
        Decision::MoreSamples { .. } => &[&["h_max > h_lim", "n_p < n_m"]],
        _ => &[],
    }
}

/// By what total reflection is told where the formulas are those of the source text.
const PRINTED_REFLECTION: &str = "1 − (1 − cosφ_1²)/η² < 0";

/// What is known from outside the node that decides; all else must be its own.
const FROM_OUTSIDE: &[&str] = &["O", "d", "N", "N_g", "L", "|ℓ|"];

/// How much of the largest number of a test f64 may lose of a difference: what differs by more wasn't computed from these numbers.
const LOST: f64 = 1e-6;

type Parsed = (Formula, Relation, Formula);

/// The comparisons of the table, parsed.
fn parsed(text: &str) -> Option<&'static Parsed> {
    static PARSED: LazyLock<HashMap<&'static str, Parsed>> =
        LazyLock::new(|| texts().filter_map(|text| Some((text, parse(text)?))).collect());
    PARSED.get(text)
}

fn parse(text: &str) -> Option<Parsed> {
    let (relation, sign) = Relation::SIGNS.iter().find(|(_, sign)| text.contains(sign))?;
    let (left, right) = text.split_once(sign)?;
    Some((formula::parse(left).ok()?, *relation, formula::parse(right).ok()?))
}

/// Every text of the table.
fn texts() -> impl Iterator<Item = &'static str> {
    use Skippable::{Reflected, Shadow, Transmitted};
    let misses = Miss::ALL.iter().map(|why| Decision::Miss { why: *why });
    let others = [
        Decision::Outside,
        Decision::Inside,
        Decision::Hit,
        Decision::TotalInternalReflection,
        Decision::Skipped { what: Shadow, why: SkipReason::Behind },
        Decision::Skipped { what: Shadow, why: SkipReason::NoLocalTerm },
        Decision::Rejected { what: Transmitted },
        Decision::Rejected { what: Reflected },
        Decision::LeakGuard { what: Shadow },
        Decision::Bent { what: Transmitted },
        Decision::Bent { what: Reflected },
        Decision::Undefined { quantity: crate::log::Name::RayDirection },
        Decision::Subdivided { cell: [0.0; 3], why: Split::Color, object: None },
        Decision::Accepted { cell: Some([0.0; 3]), why: Acceptance::Alike },
        Decision::Accepted { cell: None, why: Acceptance::Alike },
        Decision::Accepted { cell: None, why: Acceptance::Interval },
        Decision::MoreSamples { from: 0, to: 0 },
    ];
    let of_groups =
        misses.chain(others).flat_map(|decision| groups(&decision).iter().flat_map(|group| group.iter().copied()));
    of_groups.chain([PRINTED_REFLECTION])
}

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
    let mut found = Vec::new();
    for (number, group) in groups(decision).iter().enumerate() {
        let is_of_origin = *decision == Decision::Hit && number == 0;
        if is_of_origin && !decider.is_outside() {
            continue;
        }
        match decider.first(group) {
            Some(comparison) => found.push(comparison),
            // That edges lie on both sides says nothing alone.
            None if matches!(decision, Decision::Miss { .. }) => break,
            None => {}
        }
    }
    found
}

/// The hit of the test that found what blocks a shadow ray.
fn blocking(log: &Log, tree: &Tree, mark: usize, object: u32) -> Option<usize> {
    let start = tree.nodes()[tree.owner(mark)].events.start;
    let is_test = |at: &usize| matches!(tree.nodes()[tree.owner(*at)].step, Some(Step::Test { object: tested, .. }) if tested == object);
    (start..mark).rev().filter(is_test).find(|at| log.events[*at].what == What::Mark(Decision::Hit))
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
    fn first(&self, group: &[&str]) -> Option<Comparison> {
        group.iter().find_map(|text| self.comparison(parsed(text)?))
    }

    fn comparison(&self, (left, relation, right): &Parsed) -> Option<Comparison> {
        let sides = [left, right];
        let plain = self.plain(sides)?;
        let substituted = sides.map(|side| {
            let put_in = expression::substituted(self.log, self.tree, self.event, side, self.style, &[]);
            put_in.unwrap_or(Expression::Number(0.0))
        });
        let symbolic = sides.map(Expression::symbolic);
        let (relation, style) = (*relation, self.style);
        if relation.holds(plain) {
            let style = telling(relation, plain, style);
            return Some(Comparison { relation, symbolic, substituted, values: plain, is_doubled: false, style });
        }
        let values = self.doubled(sides)?;
        // What another program logged may contradict its own operands: then nothing is known of what it compared.
        if (0..2).any(|side| (values[side] - plain[side]).abs() > LOST * self.size()) {
            return None;
        }
        let substituted = sides.map(|side| {
            let put_in = expression::substituted_doubled(self.log, self.tree, self.event, side, self.style);
            put_in.unwrap_or(Expression::Number(0.0))
        });
        let style = telling(relation, values, style);
        let is_doubled = true;
        relation.holds(values).then_some(Comparison { relation, symbolic, substituted, values, is_doubled, style })
    }

    fn plain(&self, sides: [&Formula; 2]) -> Option<[f64; 2]> {
        let operand = |symbol: &'static str, _| self.operand(symbol);
        let value = |side| match evaluate_with(&self.log.header, self.tree, self.event, side, &operand) {
            Ok(Value::Number(x)) => Some(x),
            _ => None,
        };
        Some([value(sides[0])?, value(sides[1])?])
    }

    /// What more digits say, where the tracer took more: in f64, and where it noted so or no more numbers.
    fn doubled(&self, sides: [&Formula; 2]) -> Option<[f64; 2]> {
        if self.log.header.arithmetic != "f64" {
            return None;
        }
        let value = |side| match doubled_value(&self.log.events, self.tree, self.event, side) {
            Ok(Value::Number(x)) => Some(x),
            _ => None,
        };
        Some([value(sides[0])?, value(sides[1])?])
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
        let is_more = |at: &usize| matches!(self.log.events[*at].what, What::Mark(Decision::MoreSamples { .. }));
        if own == 0 || matches!(self.tree.nodes()[own].step, Some(Step::Pixel(_))) {
            self.tree.own_events_before(own, self.event).rev().find(is_more).unwrap_or(0)
        } else {
            0
        }
    }

    /// The largest number that the node noted or was given so far.
    fn size(&self) -> f64 {
        let own = self.tree.own_events_before(self.tree.owner(self.event), self.event);
        let values = own.flat_map(|at| {
            let event = &self.log.events[at];
            let noted = if let What::Note { value, .. } = event.what { Some(value) } else { None };
            noted.into_iter().chain(event.given.iter().map(|(_, value)| *value))
        });
        values.fold(0.0, |size, value| value.components().iter().fold(size, |size: f64, x| size.max(x.abs())))
    }

    fn is_outside(&self) -> bool {
        let own = self.tree.owner(self.event);
        let is_outside = |at: usize| self.log.events[at].what == What::Mark(Decision::Outside);
        self.tree.own_events_before(own, self.event).any(is_outside)
    }
}

/// A style in which two different numbers look different, or the one there is.
fn telling(relation: Relation, [left, right]: [f64; 2], style: Style) -> Style {
    const MOST: u32 = 17;
    let is_told = |style: &Style| number::number(left, *style) != number::number(right, *style);
    let is_strict = matches!(relation, Relation::Less | Relation::Greater);
    let styles = (style.digits..=MOST).map(|digits| Style { digits });
    if is_strict { styles.into_iter().find(is_told).unwrap_or(style) } else { style }
}

/// The comparisons of a decision in one line of plain text; nothing where there are none.
pub fn line_in(language: Language, log: &Log, tree: &Tree, event: usize, style: Style) -> Option<String> {
    let line = |comparison: &Comparison| {
        let text = |expression: &Expression| computation::text(language, expression, comparison.style);
        written(language, comparison, &text, |relation| relation.sign().to_owned())
    };
    let lines: Vec<_> = comparisons(log, tree, event, style).iter().map(line).collect();
    (!lines.is_empty()).then(|| lines.join("; "))
}

/// A comparison in the notation of a format.
pub fn written(
    language: Language,
    comparison: &Comparison,
    text: &dyn Fn(&Expression) -> String,
    sign: impl Fn(Relation) -> String,
) -> String {
    let sign = sign(comparison.relation);
    let sides = |[left, right]: &[Expression; 2]| format!("{} {sign} {}", text(left), text(right));
    let doubled =
        if comparison.is_doubled { format!(" ({})", language.texts().twice_the_digits) } else { String::new() };
    let numbers = sides(&comparison.substituted);
    format!("{}: {numbers}{doubled}", sides(&comparison.symbolic))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn every_comparison_of_the_table_parses() {
        assert!(texts().count() > 40);
        for text in texts() {
            assert!(parsed(text).is_some(), "{text}");
        }
    }
}
