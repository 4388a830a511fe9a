//! The probe that keeps the log.

use super::{Probe, Quantity};
use crate::log::{Decision, Event, Events, Name, Step, What};
use raywalk_guard::{attempt, has_room_for};
use std::any::Any;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// Where events go that aren't kept.
pub type Outlet<'o> = dyn FnMut(&Events) -> io::Result<()> + 'o;

/// How many events are passed on at a time.
const PIECE: usize = 4096;

/// The memory that an event needs besides itself: its inputs, and its lines in a document or a text.
const BYTES_BESIDE: usize = 250;

/// The initial capacity for events, so that the log of a simple pixel is never moved.
const AT_FIRST: usize = 1024;

/// How many nodes are open at once in most pixels.
const DEEP: usize = 16;

/// From this many events on, memory is reserved before it is used.
const MANY: usize = 1 << 14;

/// Keeps every event of the computation, or passes them on as they come.
pub struct Recorder<'o> {
    events: Events,
    nodes: u32,
    open: Vec<u32>,
    /// How many events are kept before the recorder grows, passes them on or stops.
    room: usize,
    /// How many events there are when [`Recorder::go_on`] is asked: there is no more room, or no more memory.
    full: usize,
    /// How many events were passed on.
    gone: u32,
    outlet: Option<&'o mut Outlet<'o>>,
}

/// Why a computation was stopped: there was no place for its log.
#[derive(Debug, thiserror::Error)]
pub enum CutOff {
    /// The log would be too long.
    #[error("the log would have more than {most} events")]
    TooLong {
        /// The most events it may have.
        most: usize,
    },
    /// There is no memory for it.
    #[error("not enough memory for the log")]
    Memory,
    /// The log can't be written.
    #[error("{0}")]
    Io(#[from] io::Error),
}

impl Default for Recorder<'_> {
    fn default() -> Self {
        Recorder::of_at_most(usize::MAX)
    }
}

impl<'o> Recorder<'o> {
    /// Keeps this many events; one more ends the computation, see [`until_cut_off`].
    pub fn of_at_most(room: usize) -> Recorder<'o> {
        let (events, open) = (Events::new(), Vec::with_capacity(DEEP));
        Recorder { events, nodes: 0, open, room, full: 0, gone: 0, outlet: None }
    }

    /// Passes events on as they come; an error ends the computation, see [`until_cut_off`].
    pub fn to_outlet(outlet: &'o mut Outlet<'o>) -> Recorder<'o> {
        Recorder { outlet: Some(outlet), ..Recorder::of_at_most(PIECE) }
    }

    /// The events so far, less those that were passed on.
    pub fn events(&self) -> &Events {
        &self.events
    }

    /// Ends the computation of a pixel with its colour and gives its events, or hands the last of them on.
    pub fn finish(mut self, color: [f64; 3]) -> Events {
        self.push(0, What::Result { color });
        if self.outlet.is_some() {
            self.make_room();
        }
        self.events
    }

    fn here(&self) -> u32 {
        self.open.last().copied().unwrap_or(0)
    }

    #[inline(always)]
    fn push(&mut self, node: u32, what: What) {
        if self.events.len() == self.full {
            self.go_on();
        }
        let at = self.gone + self.events.len() as u32 + 1;
        self.events.add(|given| Event { at, node, what, given, digits: None });
    }

    /// Makes room for one more event.
    #[cold]
    #[inline(never)]
    fn go_on(&mut self) {
        if self.events.len() >= self.room {
            self.make_room();
        }
        if self.events.len() == self.events.capacity() {
            self.ask_for_memory();
        }
        self.full = self.events.capacity().min(self.room);
    }

    /// Doubles the capacity, or ends the computation.
    #[cold]
    fn ask_for_memory(&mut self) {
        let more = self.events.len().clamp(AT_FIRST, PIECE << 4);
        let is_asked = self.outlet.is_none() && self.events.len() >= MANY;
        let beside = if is_asked { (self.events.len() + more) * BYTES_BESIDE } else { 0 };
        let is_room = has_room_for(beside) && attempt(|| self.events.try_reserve_exact(more)).is_ok();
        if !is_room {
            resume_unwind(Box::new(CutOff::Memory));
        }
    }

    /// Passes the events on, or ends the computation.
    #[cold]
    fn make_room(&mut self) {
        let made = match &mut self.outlet {
            None => Err(CutOff::TooLong { most: self.room }),
            Some(outlet) => outlet(&self.events).map_err(CutOff::Io),
        };
        // The numbers of events have 32 bits; the next piece must fit too.
        let gone = self.gone.saturating_add(self.events.len() as u32);
        let has_numbers = gone <= u32::MAX - PIECE as u32;
        match made.and(if has_numbers { Ok(gone) } else { Err(CutOff::TooLong { most: gone as usize }) }) {
            Ok(gone) => {
                self.gone = gone;
                self.events.clear();
            }
            // What a probe returns can't end a computation, so it unwinds; this doesn't print the message of a panic.
            Err(cut_off) => resume_unwind(Box::new(cut_off)),
        }
    }
}

/// Runs what records, and says whether a recorder cut it off.
pub fn until_cut_off<T>(run: impl FnOnce() -> T) -> Result<T, CutOff> {
    // After a cut-off nothing that the computation had changed is used.
    catch_unwind(AssertUnwindSafe(run)).map_err(|payload: Box<dyn Any + Send>| match payload.downcast() {
        Ok(cut_off) => *cut_off,
        Err(panic) => resume_unwind(panic),
    })
}

impl Probe for Recorder<'_> {
    #[inline(always)]
    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        self.events.give(name, || value.value());
    }

    #[inline(always)]
    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        self.push(self.here(), What::Note { name, value: value.value() });
        value
    }

    #[inline(always)]
    fn mark(&mut self, decision: Decision) {
        self.push(self.here(), What::Mark(decision));
    }

    #[inline(always)]
    fn enter(&mut self, step: Step) {
        let parent = self.here();
        self.nodes += 1;
        self.open.push(self.nodes);
        self.push(self.nodes, What::Enter { parent, step });
    }

    #[inline(always)]
    fn leave(&mut self) {
        self.push(self.here(), What::Leave);
        self.open.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Value;

    /// Records `count` marks and the result.
    fn record(mut recorder: Recorder, count: usize) -> Events {
        (0..count).for_each(|_| recorder.mark(Decision::Hit));
        recorder.finish([0.0; 3])
    }

    #[test]
    fn what_is_handed_on_is_what_would_have_been_kept() {
        for count in [0, 1, PIECE - 1, PIECE, 3 * PIECE + 5] {
            let mut handed_on = Events::new();
            let mut outlet = |events: &Events| {
                assert!(events.len() <= PIECE);
                handed_on.add_all(events);
                Ok(())
            };
            assert_eq!(record(Recorder::to_outlet(&mut outlet), count), Events::new());
            assert_eq!(handed_on, record(Recorder::default(), count));
        }
    }

    #[test]
    fn inputs_given_at_the_end_of_a_piece_belong_to_the_event_behind_it() {
        let run = |mut recorder: Recorder| {
            for number in 0..PIECE + 3 {
                recorder.given(Name::RayLength, number as f64);
                recorder.mark(Decision::Hit);
            }
            recorder.finish([0.0; 3])
        };
        let mut handed_on = Events::new();
        let mut outlet = |events: &Events| {
            handed_on.add_all(events);
            Ok(())
        };
        run(Recorder::to_outlet(&mut outlet));
        assert_eq!(handed_on, run(Recorder::default()));
        let first_of_next = handed_on.given(&handed_on[PIECE]);
        assert_eq!(first_of_next, [(Name::RayLength, Value::Number(PIECE as f64))]);
    }

    #[test]
    fn a_log_that_is_too_long_ends_the_computation() {
        let cut_off = until_cut_off(|| record(Recorder::of_at_most(10), 10));
        assert!(matches!(cut_off, Err(CutOff::TooLong { most: 10 })));
        assert_eq!(until_cut_off(|| record(Recorder::of_at_most(10), 9).len()).ok(), Some(10));
    }

    #[test]
    fn a_log_that_nobody_takes_ends_the_computation() {
        let mut outlet = |_: &Events| Err(io::ErrorKind::BrokenPipe.into());
        let cut_off = until_cut_off(|| record(Recorder::to_outlet(&mut outlet), usize::MAX));
        assert!(matches!(cut_off, Err(CutOff::Io(error)) if error.kind() == io::ErrorKind::BrokenPipe));
    }
}
