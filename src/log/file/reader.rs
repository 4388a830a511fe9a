//! From the lines of a log to its events.

use super::digest::Digest;
use super::error::{Ending, LogError};
use super::line::{End, Line};
use super::mark::Mark;
use super::numbers::Lookup;
use super::{MAX_NESTING, MAX_SAVED_EVENTS};
use crate::files::escape::{QUOTED, escape_hidden, hidden, shortened};
use crate::log::Log;
use crate::log::event::{Digits, Event, Step, What};
use crate::log::events::Events;
use crate::log::header::{FORMAT, Header};
use crate::log::name::Name;
use crate::log::value::Value;
use crate::log::whole::Whole;
use raywalk_guard::{attempt, has_room_for};
use std::io::ErrorKind;
use std::mem;

/// A log as it was found.
#[derive(Debug)]
pub struct ReadLog {
    /// What could be read.
    pub log: Log,
    /// How it ends.
    pub ending: Ending,
}

/// Turns lines into events: names into numbers, words into decisions.
pub(super) struct Reader {
    /// What the log says about itself.
    pub(super) lookup: Lookup,
    /// Those that weren't passed on.
    pub(super) events: Events,
    /// How many were.
    handed_on: usize,
    /// The digest of those, rewritten, while it may be asked for.
    pub(super) digest: Option<Digest>,
    /// How many nodes are open.
    depth: usize,
    /// What isn't in the table of names, and was skipped.
    unknown: Unknown,
    /// Inputs on events of unknown quantities: they count from the next event on.
    carried: Vec<(Name, Value)>,
}

/// Quantities that this program doesn't know.
#[derive(Default)]
struct Unknown {
    /// The events that were skipped.
    events: usize,
    /// Those, and the inputs.
    count: usize,
    /// What they are called, and their line; of the first.
    first: Option<(String, usize)>,
}

impl Unknown {
    fn add(&mut self, key: &str, line: usize) {
        self.count += 1;
        self.first.get_or_insert_with(|| (key.to_owned(), line));
    }

    /// How a log ends that is whole but for them.
    fn ending(&self) -> Ending {
        const LONGEST: usize = 60;
        match &self.first {
            None => Ending::Complete,
            Some((key, line)) => Ending::Unknown { count: self.count, key: shortened(key, LONGEST), line: *line },
        }
    }
}

impl Reader {
    pub(super) fn new(header: Header) -> Reader {
        Reader {
            digest: Some(Digest::new(&header)),
            lookup: Lookup::of(header),
            events: Events::new(),
            handed_on: 0,
            depth: 0,
            unknown: Unknown::default(),
            carried: Vec::new(),
        }
    }

    /// The log as far as it was read.
    pub(super) fn finish(self, ending: Ending) -> ReadLog {
        let mut events = self.events;
        events.shrink_to_fit();
        ReadLog { log: Log { header: self.lookup.header, events }, ending }
    }

    /// Passes the events on.
    pub(super) fn hand_on(&mut self) -> Events {
        if let Some(digest) = &mut self.digest {
            digest.add(&self.lookup.header, &self.events);
        }
        self.handed_on += self.events.len();
        mem::take(&mut self.events)
    }

    /// How the log ends, by its end line and the digest of the bytes before it, if they may count. A log that another program has rewritten,
    /// with other order of keys or spelling of numbers, is whole: its digest is that of the lines as they are written here.
    pub(super) fn check_end(&mut self, end: &End, of_bytes: Option<blake3::Hash>) -> Ending {
        let events = self.handed_on + self.events.len() + self.unknown.events;
        if end.events != events as u64 {
            return Ending::Mismatch { what: format!("its end line counts {} events, there are {events}", end.events) };
        }
        // It isn't needed after the end.
        // Of what was skipped the lines can't be rewritten.
        let written_anew = self.digest.take().filter(|_| self.unknown.count == 0);
        let fits_events = || {
            written_anew.is_some_and(|mut digest| {
                digest.add(&self.lookup.header, &self.events);
                end.has(digest.finish())
            })
        };
        if end.digest.is_none() || of_bytes.is_some_and(|digest| end.has(digest)) || fits_events() {
            return self.unknown.ending();
        }
        Ending::Mismatch { what: "its digest fits neither its bytes nor its events".into() }
    }

    /// Takes the event of the line with this number.
    pub(super) fn take(&mut self, line: Line, number: usize) -> Result<(), LogError> {
        let damaged = |message: String| LogError::damaged(number, 1, &message);
        let missing = |field: &str| damaged(format!("expected an event, found no `{field}`"));
        let Whole(at) = line.at.ok_or_else(|| missing("at"))?;
        let Whole(node) = line.node.ok_or_else(|| missing("node"))?;
        if line.children.is_some() {
            return Err(damaged("expected one event, found `children` in it".into()));
        }
        line.given.unknown.iter().for_each(|key| self.unknown.add(key, number));
        let what = if let Some(enter) = line.enter {
            let step = enter.resolve(&self.lookup).map_err(damaged)?;
            // Nothing is around a pixel, whatever its line says.
            let parent = if matches!(step, Step::Pixel(_)) { 0 } else { line.parent.0 };
            What::Enter { parent, step }
        } else if let Some(key) = line.note {
            let value = line.value.ok_or_else(|| missing("value"))?;
            let Some(name) = Name::find(&key, &line.form) else {
                let form = if line.form.is_empty() { String::new() } else { format!(" ({})", &*line.form) };
                self.carried.extend(line.given.inputs);
                return self.pass_over(&format!("{}{form}", &*key), number);
            };
            What::Note { name, value }
        } else if let Some(Mark::Undefined { quantity }) = &line.mark
            && Name::with_key(quantity).is_none()
        {
            self.carried.extend(line.given.inputs);
            return self.pass_over(quantity, number);
        } else if let Some(mark) = line.mark {
            What::Mark(mark.resolve(&self.lookup).map_err(damaged)?)
        } else if line.leave.is_some() {
            What::Leave
        } else if let Some(result) = line.result {
            What::Result { color: result.color }
        } else {
            return Err(damaged("expected `enter`, `note`, `mark`, `leave` or `result`".into()));
        };
        self.depth = match what {
            // Pixels of a region follow one another without being left.
            What::Enter { step: Step::Pixel(_), .. } => 1,
            What::Enter { .. } => self.depth + 1,
            What::Leave => self.depth.saturating_sub(1),
            _ => self.depth,
        };
        if self.depth > MAX_NESTING {
            return Err(damaged(format!("nested more than {MAX_NESTING} deep")));
        }
        let digits = match line.digits {
            _ if line.decision_differs => Some(Digits::DecisionDiffers),
            digits => digits.map(Digits::Significant),
        };
        if self.events.len() == self.events.capacity() {
            self.ask_for_memory()?;
        }
        if self.events.len() == MAX_SAVED_EVENTS {
            return Err(LogError::TooLong { line: number });
        }
        for (name, value) in self.carried.drain(..).chain(line.given.inputs) {
            self.events.give(name, || value);
        }
        self.events.add(|given| Event { at, node, what, given, digits: digits.map(Box::new) });
        Ok(())
    }

    /// Goes on without the event of a quantity that isn't in the table: a later version may have it, or another program.
    fn pass_over(&mut self, key: &str, line: usize) -> Result<(), LogError> {
        self.unknown.events += 1;
        self.unknown.add(key, line);
        Ok(())
    }

    /// Gets room for more events and for what they hold: in the middle of the work it could only abort.
    #[cold]
    fn ask_for_memory(&mut self) -> Result<(), LogError> {
        /// The inputs of an event and what its place in the tree takes, with some to spare.
        const BYTES_BESIDE: usize = 150;
        const MOST: usize = 1 << 20;
        let more = self.events.len().clamp(64, MOST);
        let beside = (self.events.len() + more) * BYTES_BESIDE;
        let is_room = has_room_for(beside) && attempt(|| self.events.try_reserve_exact(more)).is_ok();
        if is_room { Ok(()) } else { Err(LogError::Io(ErrorKind::OutOfMemory.into())) }
    }
}

pub(super) fn check_version(found: &str) -> Result<(), LogError> {
    if found == FORMAT { Ok(()) } else { Err(LogError::OtherVersion { found: shortened(found, QUOTED) }) }
}

/// Views of a log show its names, so that none may hold control characters for a terminal. No scene has such names.
pub(super) fn check_names(header: &Header) -> Result<(), LogError> {
    let tracing = &header.tracing;
    let words = [&header.version, &header.arithmetic, &tracing.algorithm, &tracing.specular, &tracing.sphere_method];
    let parameters = header.sampling.iter().flat_map(|(word, parameters)| [word].into_iter().chain(parameters.keys()));
    let names = header.objects.iter().chain(&header.lights).chain([&header.scene.name, &header.scene.digest]);
    let optional = [&tracing.formulas, &tracing.reflected_scale].into_iter().flatten();
    match words.into_iter().chain(optional).chain(parameters).chain(names).find(|name| hidden(name).next().is_some()) {
        None => Ok(()),
        Some(name) => Err(LogError::damaged(
            1,
            1,
            &format!("a name must not hold invisible characters, found `{}`", escape_hidden(name)),
        )),
    }
}
