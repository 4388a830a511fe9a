//! Reading logs, also such as were cut off or damaged: what is complete is read, and what isn't is said.

use super::LogError;
use super::document::{self, is_document};
use super::line::{Enter, Line, Mark};
use crate::log::escape::{is_hidden, shortened, visible};
use crate::log::event::{Acceptance, Decision, Digits, Event, Miss, RayKind, SkipReason, Skippable, Split, Step, What};
use crate::log::header::{FORMAT, Header};
use crate::log::name::Name;
use crate::log::{Log, file::line::End};
use serde::Deserialize;
use std::collections::HashMap;

/// A log as it was found.
#[derive(Debug)]
pub struct ReadLog {
    /// What could be read.
    pub log: Log,
    /// How it ends.
    pub ending: Ending,
}

/// How a log ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ending {
    /// With an end line that fits.
    Complete,
    /// Without an end line: the log was cut off, or is still being written.
    Missing {
        /// Whether the last line is incomplete (it was passed over).
        incomplete_record: bool,
    },
    /// With an end line that doesn't fit what stands before it.
    Mismatch {
        /// What doesn't fit.
        what: String,
    },
}

impl Ending {
    /// A sentence for people; `None` if all is well.
    pub fn warning(&self) -> Option<String> {
        match self {
            Ending::Complete => None,
            Ending::Missing { incomplete_record: false } => Some("the log has no end line: it was cut off".into()),
            Ending::Missing { incomplete_record: true } => {
                Some("the log was cut off: 1 incomplete record was passed over".into())
            }
            Ending::Mismatch { what } => Some(format!("the log was changed after it was written: {what}")),
        }
    }
}

/// How much larger than its bytes a log is in memory, with the text that may be made of it.
const GROWTH: usize = 3;

/// Reads a log, NDJSON or one JSON document.
///
/// # Errors
/// [`LogError`]; [`LogError::Io`] when there is no memory for it.
pub fn read(bytes: &[u8]) -> Result<ReadLog, LogError> {
    // In the middle of the work it could only abort.
    let asked = Vec::<u8>::new().try_reserve_exact(bytes.len().saturating_mul(GROWTH));
    asked.map_err(|_| std::io::Error::from(std::io::ErrorKind::OutOfMemory))?;
    if is_document(bytes) {
        return document::read(bytes);
    }
    let mut lines = Lines { rest: bytes, number: 0 };
    let header = header(lines.next().map(|line| line.text).unwrap_or_default())?;
    let mut reader = Reader::new(&header);
    let mut hashed = bytes.len() - lines.rest.len();
    let mut ending = Ending::Missing { incomplete_record: false };
    while let Some(line) = lines.next() {
        if line.text.trim_ascii().is_empty() {
            continue;
        }
        let parsed = serde_json::from_slice::<Line>(line.text).map_err(|error| error_at(line.number, &error));
        let parsed = match parsed {
            Ok(parsed) => parsed,
            Err(_) if !line.is_terminated => {
                ending = Ending::Missing { incomplete_record: true };
                break;
            }
            Err(error) => return Err(error),
        };
        if let Some(end) = parsed.end {
            ending = check_end(&end, reader.events.len(), &bytes[..hashed]);
            let after = lines.rest.trim_ascii().len();
            if after > 0 {
                ending = Ending::Mismatch { what: format!("{after} bytes stand after its end line") };
            }
            break;
        }
        reader.take(parsed, line.number)?;
        hashed = bytes.len() - lines.rest.len();
    }
    let events = reader.events;
    Ok(ReadLog { log: Log { header, events }, ending })
}

fn header(line: &[u8]) -> Result<Header, LogError> {
    #[derive(Deserialize)]
    struct Version {
        log: String,
    }
    let Ok(version) = serde_json::from_slice::<Version>(line) else {
        let found: String = String::from_utf8_lossy(line).chars().take(40).flat_map(char::escape_default).collect();
        return Err(LogError::NotALog {
            found: if found.is_empty() { "nothing".into() } else { format!("`{found}`") },
        });
    };
    check_version(&version.log)?;
    let header = serde_json::from_slice(line).map_err(|error| error_at(1, &error))?;
    check_names(&header)?;
    Ok(header)
}

/// Whoever shows a log shows its names, so that none may hold what drives a terminal. No scene has such names.
pub(super) fn check_names(header: &Header) -> Result<(), LogError> {
    let tracing = &header.tracing;
    let words = [&header.version, &header.arithmetic, &tracing.algorithm, &tracing.specular, &tracing.sphere_method];
    let parameters = header.sampling.iter().flat_map(|(word, parameters)| [word].into_iter().chain(parameters.keys()));
    let names = header.objects.iter().chain(&header.lights).chain([&header.scene.name, &header.scene.digest]);
    match words.into_iter().chain(parameters).chain(names).find(|name| name.chars().any(is_hidden)) {
        None => Ok(()),
        Some(name) => {
            Err(LogError::damaged(1, 1, &format!("a name must not hold control characters, found `{}`", visible(name))))
        }
    }
}

pub(super) fn check_version(found: &str) -> Result<(), LogError> {
    if found == FORMAT { Ok(()) } else { Err(LogError::OtherVersion { found: shortened(found, 40) }) }
}

pub(super) fn check_end(end: &End, events: usize, hashed: &[u8]) -> Ending {
    let digest = format!("blake3:{}", blake3::hash(hashed).to_hex());
    if end.events != events as u64 {
        Ending::Mismatch { what: format!("its end line counts {} events, there are {events}", end.events) }
    } else if end.digest != digest {
        Ending::Mismatch { what: "its digest doesn't fit its bytes".into() }
    } else {
        Ending::Complete
    }
}

pub(super) fn error_at(line: usize, error: &serde_json::Error) -> LogError {
    let text = error.to_string();
    let message = text.split(" at line ").next().unwrap_or(&text);
    LogError::damaged(line, error.column().max(1), message)
}

struct Lines<'b> {
    rest: &'b [u8],
    number: usize,
}

struct TextLine<'b> {
    text: &'b [u8],
    number: usize,
    is_terminated: bool,
}

impl<'b> Iterator for Lines<'b> {
    type Item = TextLine<'b>;

    fn next(&mut self) -> Option<TextLine<'b>> {
        if self.rest.is_empty() {
            return None;
        }
        self.number += 1;
        let end = self.rest.iter().position(|byte| *byte == b'\n');
        let (text, rest) = match end {
            Some(end) => (&self.rest[..end], &self.rest[end + 1..]),
            None => (self.rest, &self.rest[..0]),
        };
        self.rest = rest;
        Some(TextLine { text, number: self.number, is_terminated: end.is_some() })
    }
}

/// Turns lines into events: names into numbers, words into decisions.
pub(super) struct Reader {
    objects: HashMap<String, u32>,
    lights: HashMap<String, u32>,
    pub(super) events: Vec<Event>,
}

impl Reader {
    pub(super) fn new(header: &Header) -> Reader {
        let numbered = |names: &[String]| {
            // The first of equal names wins, as it does in a scene.
            names.iter().enumerate().rev().map(|(number, name)| (name.clone(), number as u32)).collect()
        };
        Reader { objects: numbered(&header.objects), lights: numbered(&header.lights), events: Vec::new() }
    }

    pub(super) fn take(&mut self, line: Line, number: usize) -> Result<(), LogError> {
        let damaged = |message: String| LogError::damaged(number, 1, &message);
        let missing = |field: &str| damaged(format!("expected an event, found no `{field}`"));
        let at = line.at.ok_or_else(|| missing("at"))?;
        let node = line.node.ok_or_else(|| missing("node"))?;
        let what = if let Some(enter) = line.enter {
            What::Enter { parent: line.parent, step: self.step(enter).map_err(damaged)? }
        } else if let Some(key) = line.note {
            let name = Name::find(&key, &line.form).ok_or_else(|| damaged(format!("unknown quantity `{key}`")))?;
            What::Note { name, value: line.value.ok_or_else(|| missing("value"))? }
        } else if let Some(mark) = line.mark {
            What::Mark(self.decision(mark).map_err(damaged)?)
        } else if line.leave.is_some() {
            What::Leave
        } else if let Some(result) = line.result {
            What::Result { color: result.color }
        } else {
            return Err(damaged("expected `enter`, `note`, `mark`, `leave` or `result`".into()));
        };
        let given = line.given.0.into_iter().map(|(key, value)| match Name::find(&key, "") {
            Some(name) => Ok((name, value)),
            None => Err(damaged(format!("unknown quantity `{key}`"))),
        });
        let given = given.collect::<Result<_, _>>()?;
        let digits = match line.digits {
            _ if line.decision_differs => Some(Digits::DecisionDiffers),
            digits => digits.map(Digits::Significant),
        };
        self.events.push(Event { at, node, what, given, digits: digits.map(Box::new) });
        for child in line.children {
            self.take(child, number)?;
        }
        Ok(())
    }

    fn step(&self, enter: Enter) -> Result<Step, String> {
        Ok(match enter {
            Enter::Pixel(pixel) => Step::Pixel(pixel),
            Enter::Sample { number } => Step::Sample { number },
            Enter::Ray { kind, depth, light, split } => {
                let kind = match (kind.as_str(), light) {
                    ("camera", _) => RayKind::Camera,
                    ("reflected", _) => RayKind::Reflected,
                    ("transmitted", _) => RayKind::Transmitted,
                    ("shadow", Some(light)) => RayKind::Shadow { light: self.light(&light)? },
                    (other, _) => return Err(format!("unknown kind of ray `{other}`")),
                };
                Step::Ray { kind, depth, split }
            }
            Enter::Test { object, triangle } => Step::Test { object: self.object(&object)?, triangle },
            Enter::Shade { object } => Step::Shade { object: self.object(&object)? },
            Enter::Light { light, split } => Step::Light { light: self.light(&light)?, split },
            Enter::Motion { object } => Step::Motion { object: self.object(&object)? },
            Enter::Zone { what, number } => Step::Zone { what: skippable(&what)?, number },
            Enter::Combine {} => Step::Combine,
        })
    }

    fn decision(&self, mark: Mark) -> Result<Decision, String> {
        Ok(match mark {
            Mark::Hit {} => Decision::Hit,
            Mark::Miss { why } => {
                Decision::Miss { why: Miss::find(&why).ok_or_else(|| format!("unknown reason `{why}`"))? }
            }
            Mark::Outside {} => Decision::Outside,
            Mark::Inside {} => Decision::Inside,
            Mark::Nearest { object } => Decision::Nearest { object: self.object(&object)? },
            Mark::Background {} => Decision::Background,
            Mark::Occluded { object } => Decision::Occluded { object: self.object(&object)? },
            Mark::Attenuated { object, factor } => Decision::Attenuated { object: self.object(&object)?, factor },
            Mark::Undefined { quantity } => {
                let name = Name::all().find(|name| name.key() == quantity);
                Decision::Undefined { quantity: name.ok_or_else(|| format!("unknown quantity `{quantity}`"))? }
            }
            Mark::TotalInternalReflection {} => Decision::TotalInternalReflection,
            Mark::DepthLimit { what } => Decision::DepthLimit { what: skippable(&what)? },
            Mark::LeakGuard { what } => Decision::LeakGuard { what: skippable(&what)? },
            Mark::Rejected { what } => Decision::Rejected { what: skippable(&what)? },
            Mark::Skipped { what, why } => Decision::Skipped {
                what: skippable(&what)?,
                why: SkipReason::find(&why).ok_or_else(|| format!("unknown rule `{why}`"))?,
            },
            Mark::Subdivided { cell, why, object } => Decision::Subdivided {
                cell,
                why: Split::find(&why).ok_or_else(|| format!("unknown reason `{why}`"))?,
                object: object.map(|object| self.object(&object)).transpose()?,
            },
            Mark::Accepted { cell, why } => Decision::Accepted {
                cell,
                why: Acceptance::find(&why).ok_or_else(|| format!("unknown reason `{why}`"))?,
            },
            Mark::MoreSamples { from, to } => Decision::MoreSamples { from, to },
        })
    }

    fn object(&self, name: &str) -> Result<u32, String> {
        self.objects.get(name).copied().ok_or_else(|| format!("object `{name}` isn't in the header"))
    }

    fn light(&self, name: &str) -> Result<u32, String> {
        self.lights.get(name).copied().ok_or_else(|| format!("light `{name}` isn't in the header"))
    }
}

fn skippable(word: &str) -> Result<Skippable, String> {
    Skippable::find(word).ok_or_else(|| format!("unknown work `{word}`"))
}
