//! Writing logs. A log is written while it grows, and its last line counts and digests what precedes it.

use super::mark::{write_enter, write_mark};
use super::spelling::{string, text, triple, value};
use crate::log::event::{Digits, Event, Step, What};
use crate::log::events::{Events, Input};
use crate::log::header::Header;
use crate::log::name::Name;
use crate::log::value::Value;
use crate::log::{Log, tree::add_step};
use std::io::{self, BufWriter, Write};

/// Events as lines of NDJSON: what several threads make of the pixels of a region, for one [`Writer`] to put together.
pub struct Lines<'h> {
    header: &'h Header,
    /// The paths of the open nodes.
    pub(super) paths: Paths,
    bytes: Vec<u8>,
    events: u64,
}

impl<'h> Lines<'h> {
    /// None yet, of a log with this header.
    pub fn new(header: &'h Header) -> Lines<'h> {
        Lines { header, paths: Paths::default(), bytes: Vec::new(), events: 0 }
    }

    /// Adds further events.
    pub fn push(&mut self, events: &Events) {
        self.push_some(events, events);
    }

    /// Adds some of the events.
    fn push_some(&mut self, all: &Events, events: &[Event]) {
        for event in events {
            event_fields(&mut self.bytes, self.header, (event, all.given(event)), &mut self.paths);
            self.bytes.extend_from_slice(b"}\n");
        }
        self.events += events.len() as u64;
    }

    /// Makes further events, and passes their text on in pieces, so that it takes little memory.
    pub(super) fn hand_on(&mut self, events: &Events, mut take: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
        const PIECE: usize = 4096;
        for piece in events.chunks(PIECE) {
            self.push_some(events, piece);
            take(&self.bytes)?;
            self.bytes.clear();
        }
        Ok(())
    }

    /// The text so far.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

/// The paths of the open nodes: each is a beginning of that of the innermost one.
#[derive(Debug, Default)]
pub(super) struct Paths {
    innermost: String,
    /// How long the path of the node around each is.
    around: Vec<usize>,
}

impl Paths {
    fn enter(&mut self, step: Step) {
        self.around.push(self.innermost.len());
        add_step(&mut self.innermost, step);
    }

    fn leave(&mut self) {
        if let Some(length) = self.around.pop() {
            self.innermost.truncate(length);
        }
    }

    fn depth(&self) -> usize {
        self.around.len()
    }

    fn clear(&mut self) {
        *self = Paths::default();
    }
}

/// Nodes of a document are indented by this many levels at most.
const MOST_INDENT: usize = 64;

/// Writes a log as NDJSON while it grows.
pub struct Writer<'h, W: Write> {
    out: W,
    hasher: blake3::Hasher,
    events: u64,
    lines: Lines<'h>,
}

impl<'h, W: Write> Writer<'h, W> {
    /// Starts a log with its header.
    pub fn new(out: W, header: &'h Header) -> io::Result<Self> {
        let mut writer = Writer { out, hasher: blake3::Hasher::new(), events: 0, lines: Lines::new(header) };
        write_header(header, &mut Digested(&mut writer))?;
        Ok(writer)
    }

    /// Writes further events.
    pub fn write(&mut self, events: &Events) -> io::Result<()> {
        let (out, hasher) = (&mut self.out, &mut self.hasher);
        self.lines.hand_on(events, |text| {
            hasher.update(text);
            out.write_all(text)
        })?;
        self.events += events.len() as u64;
        Ok(())
    }

    /// Writes lines that were made elsewhere.
    pub fn append(&mut self, lines: &Lines) -> io::Result<()> {
        self.append_text(&lines.bytes, lines.events)
    }

    /// Writes the text of this many events.
    pub(super) fn append_text(&mut self, text: &[u8], events: u64) -> io::Result<()> {
        self.put(text)?;
        self.events += events;
        Ok(())
    }

    /// Ends the log with its count and digest, and gives the output back.
    pub fn finish(mut self) -> io::Result<W> {
        let end = end_object(self.events, &self.hasher);
        self.out.write_all(format!("{end}\n").as_bytes())?;
        self.out.flush()?;
        Ok(self.out)
    }

    fn put(&mut self, text: &[u8]) -> io::Result<()> {
        self.hasher.update(text);
        self.out.write_all(text)
    }
}

/// Writes the header as the first line of a log.
pub(super) fn write_header(header: &Header, out: &mut impl Write) -> io::Result<()> {
    // It is written in many small pieces.
    let mut out = BufWriter::new(out);
    serde_json::to_writer(&mut out, header)?;
    out.write_all(b"\n")?;
    out.flush()
}

/// What is written to a log goes into its digest.
struct Digested<'w, 'h, W: Write>(&'w mut Writer<'h, W>);

impl<W: Write> Write for Digested<'_, '_, W> {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        self.0.put(text).map(|()| text.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The whole log as NDJSON.
pub fn to_ndjson(log: &Log) -> io::Result<Vec<u8>> {
    let mut writer = Writer::new(Vec::new(), &log.header)?;
    writer.write(&log.events)?;
    writer.finish()
}

/// The whole log as one document: the header, and each node's events as its `children`. The `end` is the NDJSON's.
pub fn to_json(log: &Log) -> io::Result<Vec<u8>> {
    let ndjson = to_ndjson(log)?;
    let last_line = ndjson.trim_ascii_end().rsplit(|byte| *byte == b'\n').next().unwrap_or_default();

    let mut out = b"{\"header\":".to_vec();
    serde_json::to_writer(&mut out, &log.header)?;
    out.extend_from_slice(b",\n\"children\":[");
    let mut paths = Paths::default();
    let mut first_child = true;
    for event in &log.events {
        // Pixels of a region log are opened but never left: the next one ends it.
        if matches!(event.what, What::Enter { step: Step::Pixel(_), .. }) && paths.depth() > 0 {
            // In a log that was cut off nodes inside it may be open, too.
            out.extend(b"]}".repeat(paths.depth()));
            paths.clear();
            first_child = false;
        }
        let is_inside = paths.depth() > 0;
        out.extend_from_slice(if first_child { b"\n" } else { b",\n" });
        out.resize(out.len() + paths.depth().min(MOST_INDENT) + 1, b' ');
        event_fields(&mut out, &log.header, (event, log.events.given(event)), &mut paths);
        first_child = matches!(event.what, What::Enter { .. });
        match event.what {
            What::Enter { .. } => out.extend_from_slice(b",\"children\":["),
            // A log from elsewhere may leave what it didn't enter.
            What::Leave if is_inside => out.extend_from_slice(b"}]}"),
            _ => out.push(b'}'),
        }
    }
    // The last one.
    out.extend(b"]}".repeat(paths.depth()));
    out.extend_from_slice(b"\n],\n");
    out.extend_from_slice(last_line.strip_prefix(b"{").unwrap_or(last_line));
    out.push(b'\n');
    Ok(out)
}

fn end_object(events: u64, hasher: &blake3::Hasher) -> String {
    format!("{{\"end\":{{\"events\":{events},\"digest\":\"{}\"}}}}", digest_of(hasher))
}

fn digest_of(hasher: &blake3::Hasher) -> String {
    format!("blake3:{}", hasher.finalize().to_hex())
}

/// The digest that a log has in its end line where raywalk writes it.
///
/// # Errors
/// None: nothing is written.
pub fn digest(log: &Log) -> io::Result<String> {
    let mut writer = Writer::new(io::sink(), &log.header)?;
    writer.write(&log.events)?;
    Ok(digest_of(&writer.hasher))
}

/// The event as a JSON object without its closing brace.
fn event_fields(out: &mut Vec<u8>, header: &Header, (event, given): (&Event, &[Input]), paths: &mut Paths) {
    text(out, &format!("{{\"at\":{},\"node\":{}", event.at, event.node));
    match &event.what {
        What::Enter { parent, step } => {
            text(out, ",\"enter\":");
            write_enter(out, header, step);
            if !matches!(step, Step::Pixel(_)) {
                text(out, &format!(",\"parent\":{parent}"));
            }
            if matches!(step, Step::Pixel(_)) {
                paths.clear();
            }
            paths.enter(*step);
            if matches!(step, Step::Ray { .. }) {
                text(out, ",\"path\":");
                string(out, &paths.innermost);
            }
        }
        What::Note { name, value } => note(out, *name, *value),
        What::Mark(decision) => {
            text(out, ",\"mark\":");
            write_mark(out, header, decision);
        }
        What::Leave => {
            text(out, ",\"leave\":{}");
            paths.leave();
        }
        What::Result { color } => {
            text(out, ",\"result\":{\"color\":");
            triple(out, color);
            text(out, "}");
        }
    }
    if let Some(agreed) = &event.digits {
        digits(out, &event.what, agreed);
    }
    if !given.is_empty() {
        text(out, ",\"given\":{");
        for (index, (name, given)) in given.iter().enumerate() {
            text(out, if index == 0 { "\"" } else { ",\"" });
            text(out, name.key());
            text(out, "\":");
            value(out, *given);
        }
        text(out, "}");
    }
}

/// The number of significant digits of each component, and whether a decision differs between the runs.
fn digits(out: &mut Vec<u8>, what: &What, digits: &Digits) {
    let count = match (digits, what) {
        (Digits::Significant(count), _) => Some(*count),
        (_, What::Note { value: Value::Number(_), .. }) => Some(Value::Number(0.0)),
        (_, What::Note { .. } | What::Result { .. }) => Some(Value::Triple([0.0; 3])),
        _ => None,
    };
    if let Some(count) = count {
        text(out, ",\"digits\":");
        value(out, count);
    }
    if *digits == Digits::DecisionDiffers {
        text(out, ",\"decision_differs\":true");
    }
}

fn note(out: &mut Vec<u8>, name: Name, noted: Value) {
    text(out, ",\"note\":\"");
    text(out, name.key());
    text(out, "\"");
    if !name.form().is_empty() {
        text(out, ",\"form\":\"");
        text(out, name.form());
        text(out, "\"");
    }
    text(out, ",\"value\":");
    value(out, noted);
}
