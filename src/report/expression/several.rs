//! Sums over samples and cells and products over surfaces, with the numbers put in.

use super::{Expression, Leaf, Part, Substitution};
use crate::log::Value;
use crate::log::formula::{Formula, Operator, Several, Unary};
use crate::log::scope::{self, Element};

/// The most terms of a sum that are written out; of more, the first three and the last one are.
const MOST: usize = 8;

impl Substitution<'_> {
    /// A sum or product with a term or factor for each of its elements.
    pub(super) fn over(&self, several: Several, inner: &Formula) -> Part {
        if several.is_statistic() {
            // The text of the formula says it all: nobody follows a standard error term by term.
            return Part::One;
        }
        if several == Several::Surfaces {
            return self.over_surfaces();
        }
        let events = &self.log.events;
        let elements = scope::elements(events, self.tree, self.event, several);
        let term = |element: &Element| Substitution { element: Some(*element), ..*self }.part(inner).there();
        let is_elided = elements.len() > MOST;
        let shown: Vec<_> = match elements.as_slice() {
            [first, second, third, .., last] if is_elided => {
                let first = [first, second, third].map(term);
                first.into_iter().chain([Some(Formula::Leaf(Leaf::Elided)), term(last)]).collect()
            }
            all => all.iter().map(term).collect(),
        };
        // A term that the log doesn't hold can't be put in, and neither can the sum.
        let Some(shown) = shown.into_iter().collect::<Option<Vec<_>>>() else { return Part::Zero };
        let is_one = shown.len() == 1;
        match shown.into_iter().reduce(|sum, term| Formula::binary(Operator::Plus, sum, term)) {
            None => Part::Zero,
            Some(sum) if is_one => Part::There(sum),
            Some(sum) => Part::There(Formula::unary(Unary::Grouped, sum)),
        }
    }

    fn over_surfaces(&self) -> Part {
        let factors = scope::factors(&self.log.events, self.tree, self.event);
        let known: Option<Vec<_>> = factors.into_iter().collect();
        let factors = known.into_iter().flatten().map(|factor| Expression::value(Value::Triple(factor), None));
        factors
            .reduce(|product, factor| Formula::binary(Operator::Channelwise, product, factor))
            .map_or(Part::One, Part::There)
    }
}
