//! Logs of a region's shards.

use super::{Merge, open, some_of};
use crate::cli::failure::{Failure, shown};
use crate::cli::inputs::Inputs;
use crate::cli::output::{Output, Sink};
use crate::cli::saved_log::{self, MAX_LOG_BYTES};
use raywalk::log::file::{LogError, PixelReader, Writer};
use raywalk::log::{Header, Shard};
use raywalk::report::diff::header_differences;
use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::Path;

impl Merge {
    /// Joins logs.
    pub(super) fn logs(&self) -> Result<(), Failure> {
        if self.png16 {
            return Err(Failure::caller("--png16: is for pictures, found logs"));
        }
        if let Some(option) = self.shown.given().first() {
            return Err(Failure::caller(format!("{option}: is for pictures, found logs")));
        }
        let mut found: Vec<(&Path, Header, Shard)> = Vec::new();
        for path in &self.parts {
            let header = log_in(path)?.header().clone();
            let shard = header.shard.ok_or_else(|| {
                Failure::caller(format!("{}: is no shard; expected a log that `trace --shard` wrote", shown(path)))
            })?;
            found.push((path, header, shard));
        }
        let in_order = in_order(&found)?;
        let header = Header { shard: None, ..found[0].1.clone() };
        let inputs = Inputs::of(&self.parts);
        let output = || Output::create(Some(&self.output), &inputs);
        let mut place = output()?;
        // A file can be reread if another program turns out to have rewritten a log; for anything else the logs are asked first.
        let is_file = place.is_file();
        let mut nowhere =
            Writer::new(io::sink(), &header).map_err(|error| Failure::io(&self.output, "write", &error))?;
        let mut is_copied = |path| log_in(path).is_ok_and(|log| log.copy_to(&mut nowhere).unwrap_or(false));
        if is_file || in_order.iter().all(|path| is_copied(path)) {
            match join(&in_order, &header, place, |log, writer| log.copy_to(writer))? {
                true => return Ok(()),
                false if is_file => place = output()?,
                false => return Err(Failure::caller("merge: a log was changed while it was read")),
            }
        }
        join(&in_order, &header, place, |log, writer| log.add_to(writer).map(|()| true)).map(|_| ())
    }
}

type PartReader = PixelReader<Box<dyn Read>>;

/// Writes the logs one after another; `false` where `add` gives that for one of them.
fn join(
    logs: &[&Path],
    header: &Header,
    output: Output,
    add: impl Fn(PartReader, &mut Writer<&mut Sink>) -> Result<bool, LogError>,
) -> Result<bool, Failure> {
    let mut added = Ok(true);
    let written = output.stream(|out| {
        let mut writer = Writer::new(out, header)?;
        for path in logs {
            let add = |log| add(log, &mut writer).map_err(|error| saved_log::failure(&shown(path), &error));
            added = log_in(path).and_then(add);
            if !matches!(added, Ok(true)) {
                return Err(io::ErrorKind::Other.into());
            }
        }
        writer.finish().map(|_| ())
    });
    if let Ok(true) = added { written.map(|()| true) } else { added }
}

fn log_in(path: &Path) -> Result<PartReader, Failure> {
    let input: Box<dyn Read> = Box::new(open(path)?.stream(MAX_LOG_BYTES));
    PixelReader::open(input).map_err(|error: LogError| saved_log::failure(&shown(path), &error))
}

/// The logs in the order of their shards, if together they are the whole of one region.
fn in_order<'p>(found: &[(&'p Path, Header, Shard)]) -> Result<Vec<&'p Path>, Failure> {
    let (first, header, shard) = &found[0];
    let mut shards: BTreeMap<u32, &Path> = BTreeMap::new();
    for (path, other, at) in found {
        let unsharded = |header: &Header| Header { shard: None, ..header.clone() };
        if let Some(difference) = header_differences(&unsharded(header), &unsharded(other)).into_iter().next() {
            let (field, [a, b]) = (difference.field, [difference.a, difference.b]);
            return Err(Failure::caller(format!(
                "{} and {}: are of different regions, {field}: {a} against {b}",
                shown(first),
                shown(path)
            )));
        }
        if shard.of() != at.of() {
            return Err(Failure::caller(format!(
                "{} and {}: are of different divisions, shard {shard} and shard {at}",
                shown(first),
                shown(path)
            )));
        }
        if let Some(before) = shards.insert(at.number(), path) {
            return Err(Failure::caller(format!("{} and {}: are both shard {at}", shown(before), shown(path))));
        }
    }
    if shards.len() < shard.of() as usize {
        let missing = (1..=shard.of()).filter(|number| !shards.contains_key(number));
        let missing: Vec<_> = missing.map(|number| format!("{number}/{}", shard.of())).collect();
        return Err(Failure::caller(format!("merge: shards are missing: {}", some_of(&missing))));
    }
    Ok(shards.into_values().collect())
}
