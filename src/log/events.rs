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
/// An event knows where its inputs stand here, so that a log takes one piece of memory for them and not one an event: that was half of the
/// time of recording. The inputs of events that are taken out stay until all are cleared.
#[derive(Clone, Debug, Default)]
pub struct Events {
    list: Vec<Event>,
    inputs: Vec<Input>,
    /// How many inputs belong to events; those behind them are the next event's.
    owned: usize,
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
        if before > self.owned && self.inputs[before - 1].0 > name {
            self.sort_given();
        }
    }

    #[cold]
    #[inline(never)]
    fn sort_given(&mut self) {
        self.inputs[self.owned..].sort_by_key(|(name, _)| *name);
    }

    /// Adds an event, which is told where its inputs stand.
    #[inline(always)]
    pub fn add(&mut self, event: impl FnOnce(Given) -> Event) {
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

/// Equal if the events say the same with the same inputs, wherever these stand.
impl PartialEq for Events {
    fn eq(&self, other: &Events) -> bool {
        self.len() == other.len() && self.iter().zip(other).all(|(ours, theirs)| self.says_as(ours, other, theirs))
    }
}
