//! `raywalk rays`: ray queries, a line each.

use super::failure::Failure;
use super::inputs;
use super::options::TracingOptions;
use super::{output, scene_argument};
use clap::Args;
use glam::DVec3;
use raywalk::files::{escape_hidden, escape_hidden_json, suggest, unknown};
use raywalk::geometry::{Leaving, Side};
use raywalk::record::Arithmetic;
use raywalk::scene::Scene;
use raywalk::trace::query::{Answer, Query};
use raywalk_guard::stdin_was_closed;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::collections::HashMap;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::PathBuf;

const MORE: &str = "\
A query is a JSON object in a line of its own: `o` the origin, `d` the direction (of any length), and where wanted `id` (comes back \
with the answer), `tmin` and `tmax` (between which t counts; the point is o + t·d), `from` and `from_primitive` (the object that the \
ray leaves, which it doesn't hit again there). The answer is a line, too. A line that can't be read is answered with an `error`, and the \
next line goes on. Moving objects are where they are when the shutter opens.

Examples:
  $ echo '{\"id\": 1, \"o\": [16, 2, 7], \"d\": [-12, 4, 1]}' | raywalk rays textbook
  {\"id\":1,\"hit\":{\"object\":\"plane\",\"primitive\":0,\"t\":1.0,\"point\":[4.0,6.0,8.0],\"normal\":[1.0,0.0,0.0],\"side\":\"front\"}}
  $ echo '{\"o\": [16, 2, 7], \"d\": [-12, 4, 1]}' | raywalk rays textbook --all
  {\"hits\":[{\"object\":\"plane\",\"primitive\":0,\"t\":1.0,\"point\":[4.0,6.0,8.0],\"normal\":[1.0,0.0,0.0],\"side\":\"front\"}]}
  $ raywalk rays textbook --occlusion < queries.ndjson > answers.ndjson";

/// Answer ray queries from standard input.
#[derive(Args)]
#[command(after_long_help = MORE)]
pub struct Rays {
    /// A scene file or a built-in scene
    scene: PathBuf,
    /// Report only whether anything is in the way
    #[arg(long)]
    occlusion: bool,
    /// Report every crossing in the order of the ray; an edge or corner of a mesh counts once
    #[arg(long, conflicts_with = "occlusion")]
    all: bool,
    #[command(flatten)]
    tracing: TracingOptions,
}

/// The longest line that is read, in bytes. A longer one is answered with an error and skipped.
const MAX_LINE_BYTES: u64 = 64 * 1024;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Question<'a> {
    #[serde(borrow)]
    id: Option<&'a RawValue>,
    o: [f64; 3],
    d: [f64; 3],
    #[serde(default)]
    tmin: f64,
    tmax: Option<f64>,
    from: Option<String>,
    from_primitive: Option<u32>,
}

/// Only the id, of a line that is otherwise unusable.
#[derive(Deserialize)]
struct Identity<'a> {
    #[serde(borrow)]
    id: Option<&'a RawValue>,
}

#[derive(Serialize)]
struct Reply<'a, T> {
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a RawValue>,
    #[serde(flatten)]
    reply: T,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Outcome<'s> {
    Hit(Option<HitReply<'s>>),
    Hits(Vec<HitReply<'s>>),
    Occluded(bool),
    Error(String),
}

#[derive(Serialize)]
struct HitReply<'s> {
    object: &'s str,
    primitive: u32,
    t: f64,
    point: [f64; 3],
    normal: [f64; 3],
    side: &'static str,
}

impl Rays {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        if self.scene.as_os_str() == "-" {
            return Err(Failure::caller("rays: the scene can't be standard input, which holds the rays"));
        }
        if self.tracing.arithmetic() != Arithmetic::F64 {
            return Err(Failure::caller("rays: --arithmetic: queries are answered in f64 only"));
        }
        self.tracing.use_threads();
        let scene = self.tracing.apply(scene_argument::load(&self.scene, &self.tracing.import())?)?;
        let names: HashMap<&str, u32> = scene.objects.iter().map(|object| object.name.as_str()).zip(0..).collect();
        if stdin_was_closed() {
            return Err(unreadable(&io::Error::other("it is closed")));
        }
        inputs::reads(["-"]);
        let mut input = BufReader::with_capacity(1 << 16, io::stdin().lock());
        let mut out = BufWriter::with_capacity(1 << 16, output::standard()?);
        let mut line = Vec::new();
        while let Some(kept) = next_line(&mut input, &mut line).map_err(|error| unreadable(&error))? {
            if line.trim_ascii().is_empty() {
                continue;
            }
            let written = if kept { self.answer(&scene, &names, &line, &mut out) } else { too_long(&mut out) };
            written.map_err(|error| Failure::stdout(&error))?;
            // A reader may wait for each answer: output is flushed while no more input has arrived.
            if input.buffer().is_empty() {
                out.flush().map_err(|error| Failure::stdout(&error))?;
            }
        }
        out.flush().map_err(|error| Failure::stdout(&error))
    }

    fn answer(&self, scene: &Scene, names: &HashMap<&str, u32>, line: &[u8], out: &mut impl Write) -> io::Result<()> {
        let (id, reply) = match read(line) {
            Ok(question) => {
                let outcome = match question.query(scene, names) {
                    Err(message) => Outcome::Error(message),
                    Ok(query) if self.occlusion => Outcome::Occluded(query.is_occluded(scene)),
                    Ok(query) if self.all => {
                        Outcome::Hits(query.all(scene).iter().map(|answer| HitReply::of(scene, answer)).collect())
                    }
                    Ok(query) => Outcome::Hit(query.nearest(scene).map(|answer| HitReply::of(scene, &answer))),
                };
                (question.id, outcome)
            }
            Err(error) => {
                let id = serde_json::from_slice::<Identity>(line).ok().and_then(|identity| identity.id);
                (id, Outcome::Error(unusable(line, &error)))
            }
        };
        // The id is written as it came, and whatever was quoted of a line as well.
        out.write_all(escape_hidden_json(&serde_json::to_string(&Reply { id, reply })?).as_bytes())?;
        out.write_all(b"\n")
    }
}

impl Question<'_> {
    fn query(&self, scene: &Scene, names: &HashMap<&str, u32>) -> Result<Query, String> {
        let (origin, direction) = (DVec3::from(self.o), DVec3::from(self.d));
        let from = self.from(scene, names)?;
        let query = Query { origin, direction, t_min: self.tmin, t_max: self.tmax.unwrap_or(f64::INFINITY), from };
        query.check()?;
        Ok(query)
    }
}

impl Question<'_> {
    /// The object and the primitive that the ray leaves.
    fn from(&self, scene: &Scene, names: &HashMap<&str, u32>) -> Result<Option<(u32, u32)>, String> {
        let Some(name) = &self.from else {
            return match self.from_primitive {
                None => Ok(None),
                Some(_) => Err("from_primitive: expected `from` too, the object that has it".to_owned()),
            };
        };
        let shown = escape_hidden(name);
        let Some(object) = names.get(name.as_str()) else {
            let meant = suggest(name, names.keys().copied());
            let hint = meant.map_or_else(String::new, |meant| format!(", did you mean `{}`?", escape_hidden(meant)));
            return Err(format!("from: no object is called `{shown}`{hint}"));
        };
        let primitive = match (scene.objects[*object as usize].shape.triangle_count(), self.from_primitive) {
            (None, None | Some(0)) => Leaving::ANY_PRIMITIVE,
            (None, Some(other)) => {
                return Err(format!("from_primitive: `{shown}` has primitive 0 only, found {other}"));
            }
            (Some(_), None) => return Err(format!("from: `{shown}` is a mesh, expected `from_primitive` too")),
            (Some(count), Some(triangle)) if triangle as usize >= count => {
                return Err(format!("from_primitive: `{shown}` has {count} triangles, from 0 on, found {triangle}"));
            }
            (Some(_), Some(triangle)) => triangle,
        };
        Ok(Some((*object, primitive)))
    }
}

impl<'s> HitReply<'s> {
    fn of(scene: &'s Scene, answer: &Answer) -> HitReply<'s> {
        let object = &scene.objects[answer.object as usize];
        HitReply {
            object: &object.name,
            primitive: if object.shape.is_mesh() { answer.primitive } else { 0 },
            t: answer.t,
            point: answer.point.to_array(),
            normal: answer.normal.to_array(),
            side: match answer.side {
                Side::Front => "front",
                Side::Back => "back",
            },
        }
    }
}

/// The question of a line. serde would take an array for one too.
fn read(line: &[u8]) -> serde_json::Result<Question<'_>> {
    if line.trim_ascii_start().starts_with(b"[") {
        return Err(serde::de::Error::custom(
            "expected an object, {\"o\": [x, y, z], \"d\": [x, y, z]}, found an array",
        ));
    }
    serde_json::from_slice(line)
}

/// What is wrong with a line, with the key that was perhaps meant.
fn unusable(line: &[u8], error: &serde_json::Error) -> String {
    const KEYS: [&str; 7] = ["id", "o", "d", "tmin", "tmax", "from", "from_primitive"];
    let said = error.to_string();
    let of_serde = said.strip_prefix("unknown field `").and_then(|rest| rest.split_once("`, expected"));
    match of_serde {
        Some((name, _)) => format!("column {}: {}", error.column(), unknown("key", name, &KEYS)),
        None if said.contains("struct Question") => {
            let found = String::from_utf8_lossy(line.trim_ascii());
            let start: String = found.chars().take(20).collect();
            format!("expected an object, {{\"o\": [x, y, z], \"d\": [x, y, z]}}, found `{}`", escape_hidden(&start))
        }
        None => said,
    }
}

/// Reads a line without its end; `None` at the end of the input, `false` for a line that was too long to keep.
fn next_line(input: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<Option<bool>> {
    line.clear();
    if input.by_ref().take(MAX_LINE_BYTES).read_until(b'\n', line)? == 0 {
        return Ok(None);
    }
    if line.last() == Some(&b'\n') || (line.len() as u64) < MAX_LINE_BYTES {
        return Ok(Some(true));
    }
    // The rest of the line, piece by piece.
    let mut rest = Vec::new();
    while input.by_ref().take(MAX_LINE_BYTES).read_until(b'\n', &mut rest)? > 0 && rest.last() != Some(&b'\n') {
        rest.clear();
    }
    Ok(Some(false))
}

fn too_long(out: &mut impl Write) -> io::Result<()> {
    let reply = Outcome::Error(format!("the line is longer than {MAX_LINE_BYTES} bytes"));
    serde_json::to_writer(&mut *out, &reply)?;
    out.write_all(b"\n")
}

fn unreadable(error: &io::Error) -> Failure {
    Failure::machine(format!("standard input: cannot read: {error}"))
}
