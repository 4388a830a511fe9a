//! Logs that were saved.

use super::failure::Failure;
use super::progress::ProgressOptions;
use raywalk::files::{Opened, Wanted, escape_hidden};
use raywalk::log::file::{self, Ending, LogError, PixelReader};
use raywalk::log::{Header, Log};
use raywalk::report::forms;
use std::io::{self, ErrorKind};
use std::path::Path;

/// The longest log: some forty million events.
pub const MAX_LOG_BYTES: u64 = 4 << 30;

/// A log that was read.
pub struct Saved {
    /// Its name in messages.
    pub name: String,
    /// The log.
    pub log: Log,
    /// Whether it is damaged or was cut off, which is always reported.
    pub ending: Ending,
}

/// Reads a log.
pub fn read(opened: Opened, progress: &ProgressOptions) -> Result<Saved, Failure> {
    let name = escape_hidden(opened.name()).into_owned();
    let size = opened.size();
    let input = progress.reading(opened.stream(MAX_LOG_BYTES), size);
    let mut read = file::read_from(input).map_err(|error| failure(&name, &error))?;
    forms::find(&mut read.log);
    Ok(Saved { name, log: read.log, ending: read.ending })
}

/// Whether the whole log with this header is in a file.
pub fn is_whole(path: &Path, header: &Header) -> bool {
    if path == Path::new("-") || !path.is_file() {
        return false;
    }
    let log = || {
        let opened = Wanted { what: "a log", max_bytes: MAX_LOG_BYTES }.open(path).ok()?;
        PixelReader::open(opened.stream(MAX_LOG_BYTES)).ok().filter(|log| log.header() == header)
    };
    let Ok(mut nowhere) = file::Writer::new(io::sink(), header) else { return false };
    log().is_some_and(|log| log.copy_to(&mut nowhere).is_ok_and(|is_whole| is_whole))
        || log().is_some_and(|log| log.add_to(&mut nowhere).is_ok())
}

/// A log was named with options that only a scene has a use for.
pub fn is_traced_already(opened: &Opened) -> Failure {
    let name = escape_hidden(opened.name());
    Failure::caller(format!("{name}: is a log, which is traced already; expected no options of tracing"))
}

/// Why a log can't be read, as messages call it by its name.
pub fn failure(name: &str, error: &LogError) -> Failure {
    match error {
        // A document is whole or nothing.
        LogError::Io(error)
            if matches!(error.kind(), ErrorKind::FileTooLarge | ErrorKind::InvalidData | ErrorKind::UnexpectedEof) =>
        {
            Failure::caller(format!("{name}: {error}"))
        }
        LogError::Io(error) => Failure::machine(format!("{name}: cannot read: {error}")),
        _ => Failure::caller(format!("{name}:{error}")),
    }
}
