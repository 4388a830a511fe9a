//! The events of a log, and the one piece of memory that holds the inputs of all of them.

use super::event::{Event, Given};
use super::name::Name;
use super::value::Value;
use std::collections::TryReserveError;
use std::iter;
use std::ops::{Deref, DerefMut};

/// A named input.
pub type Input = (Name, Value);

/// Events in order, with their inputs.
///
/// An event knows where its inputs are here, so that a log takes one piece of memory for them and not one an event: that was half of the
/// time of recording. The inputs of events that are taken out stay until all are cleared.
#[derive(Clone, Debug, Default)]
pub struct Events {
    list: Vec<Event>,
    inputs: Vec<Input>,
    /// How many inputs belong to events; those behind them are the next event's.
    owned: usize,
    /// Whether those aren't in the order of the table.
    is_disordered: bool,
}

impl Events {
    /// None yet.
    pub fn new() -> Events {
        Events::default()
    }

    /// The inputs of an event of these, in the order of the table of names.
    pub fn given(&self, event: &Event) -> &[Input] {
        self.inputs.get(event.given.range()).unwrap_or_default()
    }

    /// Every event with its inputs.
    pub fn with_given(&self) -> impl Iterator<Item = (&Event, &[Input])> {
        self.list.iter().map(|event| (event, self.given(event)))
    }

    /// Whether an event of these says the same as one of others, with the same inputs.
    pub fn says_as(&self, event: &Event, others: &Events, other: &Event) -> bool {
        (event.at, event.node) == (other.at, other.node)
            && event.what == other.what
            && event.digits == other.digits
            && self.given(event) == others.given(other)
    }

    /// Adds an input of the next event that [`Events::add`] makes. Equal names stay in the order in which they come.
    #[inline(always)]
    pub fn give(&mut self, name: Name, value: impl FnOnce() -> Value) {
        let before = self.inputs.len();
        self.inputs.extend(iter::once_with(|| (name, value())));
        self.is_disordered |= before > self.owned && self.inputs[before - 1].0 > name;
    }

    #[cold]
    #[inline(never)]
    fn sort_given(&mut self) {
        self.inputs[self.owned..].sort_by_key(|(name, _)| *name);
        self.is_disordered = false;
    }

    /// Adds an event and sets where its inputs are.
    #[inline(always)]
    pub fn add(&mut self, event: impl FnOnce(Given) -> Event) {
        if self.is_disordered {
            self.sort_given();
        }
        let given = Given::of(self.owned, self.inputs.len());
        self.owned = self.inputs.len();
        // `Vec::push` makes the event beside its place and copies it there with loads that are wider than the stores just before, for
        // which the processor waits.
        self.list.extend(iter::once_with(|| event(given)));
    }

    /// Adds an event of others with its inputs.
    pub fn add_from(&mut self, others: &Events, event: &Event) {
        others.given(event).iter().for_each(|(name, value)| self.give(*name, || *value));
        self.add(|given| Event { given, ..event.clone() });
    }

    /// Adds all events of others.
    pub fn add_all(&mut self, others: &Events) {
        others.iter().for_each(|event| self.add_from(others, event));
    }

    /// The same events with every input put through `f`.
    pub(super) fn map_given(&mut self, f: impl Fn(Value) -> Value) {
        self.inputs.iter_mut().for_each(|(_, value)| *value = f(*value));
    }

    /// The same events with only those inputs for which `keep` says so.
    #[must_use]
    pub fn with_inputs_where(&self, keep: impl Fn(&Input) -> bool) -> Events {
        let mut kept = Events::new();
        for (event, inputs) in self.with_given() {
            inputs.iter().filter(|input| keep(input)).for_each(|(name, value)| kept.give(*name, || *value));
            kept.add(|given| Event { given, ..event.clone() });
        }
        kept
    }

    /// Asks for room for so many more events, and for as many inputs as they have as a rule: six of ten have one.
    ///
    /// # Errors
    /// Where there is no memory for them.
    pub fn try_reserve_exact(&mut self, more: usize) -> Result<(), TryReserveError> {
        self.list.try_reserve_exact(more)?;
        let inputs = (self.list.capacity() * 5 / 8).saturating_sub(self.inputs.len());
        self.inputs.try_reserve_exact(inputs)
    }

    /// Gives memory back that isn't used.
    pub fn shrink_to_fit(&mut self) {
        self.list.shrink_to_fit();
        self.inputs.shrink_to_fit();
    }

    /// Removes all events, but no inputs of the next one.
    pub fn clear(&mut self) {
        self.list.clear();
        self.inputs.drain(..self.owned);
        self.owned = 0;
    }
}

impl From<Event> for Events {
    /// An event without inputs.
    fn from(event: Event) -> Events {
        let mut events = Events::new();
        events.add(|given| Event { given, ..event });
        events
    }
}

/// Events of other logs have their inputs there: they come in by [`Events::add_from`].
impl Deref for Events {
    type Target = Vec<Event>;

    fn deref(&self) -> &Vec<Event> {
        &self.list
    }
}

impl DerefMut for Events {
    fn deref_mut(&mut self) -> &mut Vec<Event> {
        &mut self.list
    }
}

impl<'e> IntoIterator for &'e Events {
    type Item = &'e Event;
    type IntoIter = std::slice::Iter<'e, Event>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.iter()
    }
}

impl<'e> IntoIterator for &'e mut Events {
    type Item = &'e mut Event;
    type IntoIter = std::slice::IterMut<'e, Event>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.iter_mut()
    }
}

/// Equal if the events say the same with the same inputs, wherever these are.
impl PartialEq for Events {
    fn eq(&self, other: &Events) -> bool {
        self.len() == other.len() && self.iter().zip(other).all(|(ours, theirs)| self.says_as(ours, other, theirs))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::{Decision, What};

    /// Adds a hit with these inputs.
    fn add(events: &mut Events, inputs: &[(Name, f64)]) {
        inputs.iter().for_each(|(name, x)| events.give(*name, || Value::Number(*x)));
        let (at, what) = (events.len() as u32 + 1, What::Mark(Decision::Hit));
        events.add(|given| Event { at, node: 0, what, given, digits: None });
    }

    fn given(events: &Events, at: usize) -> Vec<(Name, f64)> {
        let number = |(name, value): &Input| (*name, value.components()[0]);
        events.given(&events[at]).iter().map(number).collect()
    }

    const X: Name = Name::PixelX;
    const Y: Name = Name::PixelY;

    #[test]
    fn each_event_has_its_own_inputs_in_the_order_of_the_table() {
        let mut events = Events::new();
        add(&mut events, &[(Y, 1.0), (X, 2.0), (Y, 3.0)]);
        add(&mut events, &[]);
        add(&mut events, &[(X, 4.0)]);
        assert_eq!(
            [0, 1, 2].map(|at| given(&events, at)),
            [vec![(X, 2.0), (Y, 1.0), (Y, 3.0)], vec![], vec![(X, 4.0)]]
        );
    }

    #[test]
    fn inputs_of_the_next_event_outlive_those_before() {
        let mut events = Events::new();
        add(&mut events, &[(X, 1.0)]);
        events.give(Y, || Value::Number(2.0));
        events.clear();
        add(&mut events, &[(X, 3.0)]);
        assert_eq!(given(&events, 0), [(X, 3.0), (Y, 2.0)]);
    }

    #[test]
    fn events_are_equal_wherever_their_inputs_stand() {
        let (mut all, mut cut, mut alone) = (Events::new(), Events::new(), Events::new());
        add(&mut all, &[(X, 1.0)]);
        add(&mut all, &[(Y, 2.0)]);
        cut.add_all(&all);
        assert_eq!(cut, all);
        cut.remove(0);
        alone.add_from(&all, &all[1]);
        assert_eq!(alone, cut);
        assert_eq!(given(&alone, 0), [(Y, 2.0)]);
        alone.map_given(|value| value.map(|x| x + 1.0));
        assert_ne!(alone, cut);
    }

    #[test]
    fn inputs_are_left_out() {
        let mut events = Events::new();
        add(&mut events, &[(X, 1.0), (Y, 2.0)]);
        add(&mut events, &[(X, 3.0)]);
        let kept = events.with_inputs_where(|(name, _)| *name == Y);
        assert_eq!([0, 1].map(|at| given(&kept, at)), [vec![(Y, 2.0)], vec![]]);
    }
}
