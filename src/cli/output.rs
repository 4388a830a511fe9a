//! Where results go: standard output, or a file that is there whole or not at all.

use super::failure::{Failure, shown};
use super::inputs::{Claim, Inputs, place_of, refuse_printing};
use super::unfinished::{self, Beside};
use super::zstd;
use crossterm::terminal::{Clear, ClearType};
use flate2::Compression;
use flate2::write::GzEncoder;
use raywalk::files::Packing;
use raywalk_guard::{Patient, stdout_was_closed};
use std::fs;
use std::io::{self, BufWriter, StdoutLock, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// A place for a result, made sure of before the work begins.
pub enum Output {
    /// Standard output.
    Stdout,
    /// A file that is written beside its place and then renamed.
    File {
        /// The file beside it.
        file: Beside,
        /// The place, where links have led.
        place: PathBuf,
        /// The place as it was named.
        named: PathBuf,
        /// The place is its own.
        claim: Claim,
    },
    /// A device or pipe, which can't be replaced.
    Special(fs::File, PathBuf),
}

impl Output {
    /// Standard output for none and `-`; else the file, which must not be one of the `inputs`.
    pub fn create(path: Option<&Path>, inputs: &Inputs) -> Result<Output, Failure> {
        let Some(path) = path.filter(|path| *path != Path::new("-")) else {
            return standard().map(|_| Output::Stdout);
        };
        let cannot_write = |error: &io::Error| Failure::io(path, "write", error);
        let metadata = match fs::metadata(path) {
            Ok(metadata) => Some(metadata),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(cannot_write(&error)),
        };
        if metadata.as_ref().is_some_and(fs::Metadata::is_dir) {
            let path = shown(path);
            return Err(Failure::caller(format!("{path}: is a directory, expected the name of a file")));
        }
        if let Some(metadata) = &metadata {
            inputs.refuse(path, metadata)?;
        }
        if metadata.as_ref().is_some_and(|metadata| !metadata.is_file()) {
            let file = fs::OpenOptions::new().write(true).open(path).map_err(|error| cannot_write(&error))?;
            return Ok(Output::Special(file, path.to_owned()));
        }
        let place = place_of(path);
        let claim = Claim::of(path, &place)?;
        let folder = folder_of(&place);
        // The system's error names the temporary file, which says nothing to anybody.
        let plain = |error: io::Error| match error.to_string().split_once(" at path ") {
            Some((said, _)) => io::Error::new(error.kind(), said.to_owned()),
            None => error,
        };
        let begun = Beside::begin(folder, metadata.map(|metadata| metadata.permissions()));
        let file = begun.map_err(|error| cannot_write(&plain(error)))?;
        Ok(Output::File { file, place, named: path.to_owned(), claim })
    }

    /// Whether it is a file, and neither standard output nor a device.
    pub fn is_file(&self) -> bool {
        matches!(self, Output::File { .. })
    }

    /// Writes the whole result.
    pub fn commit(self, bytes: &[u8]) -> Result<(), Failure> {
        self.stream(|out| out.write_all(bytes))
    }

    /// Writes the whole result, which a later one of this run may replace.
    pub fn commit_for_now(self, bytes: &[u8]) -> Result<(), Failure> {
        self.stream_and(false, |out| out.write_all(bytes))
    }

    /// Writes a result that comes bit by bit; `write` may fail only because `out` does.
    pub fn stream(self, write: impl FnOnce(&mut Sink) -> io::Result<()>) -> Result<(), Failure> {
        self.stream_and(true, write)
    }

    fn stream_and(self, is_kept: bool, write: impl FnOnce(&mut Sink) -> io::Result<()>) -> Result<(), Failure> {
        match self {
            Output::Stdout => through(Box::new(standard()?), None, write).map_err(|error| Failure::stdout(&error)),
            Output::Special(file, path) => through(Box::new(file), None, write).map_err(|error| match error.kind() {
                io::ErrorKind::BrokenPipe => Failure::silent(0),
                _ => Failure::io(&path, "write", &error),
            }),
            Output::File { file, place, named, claim } => {
                let cannot_write = |error: &io::Error| Failure::io(&named, "write", error);
                through(Box::new(file.as_file()), packing(&named), write).map_err(|error| cannot_write(&error))?;
                file.take(&place).map_err(|error| cannot_write(&error))?;
                if is_kept {
                    claim.keep();
                }
                Ok(())
            }
        }
    }
}

/// Where a result is written to, in large pieces.
pub type Sink<'w> = BufWriter<Box<dyn Write + 'w>>;

/// What a file of this name is packed by.
fn packing(path: &Path) -> Option<Packing> {
    path.extension().and_then(|ending| Packing::of_ending(&ending.to_string_lossy()))
}

fn through<'w>(
    place: Box<dyn Write + 'w>,
    packing: Option<Packing>,
    write: impl FnOnce(&mut Sink) -> io::Result<()>,
) -> io::Result<()> {
    let into = |place: Box<dyn Write + '_>| {
        let mut out = BufWriter::with_capacity(1 << 16, place);
        write(&mut out)?;
        out.flush()
    };
    let mut place = Patient(place);
    match packing {
        None => into(Box::new(place)),
        Some(Packing::Gzip) => {
            // The packed data name no file and no time: the same result has the same bytes.
            let mut packed = GzEncoder::new(BufWriter::new(&mut place), Compression::fast());
            into(Box::new(&mut packed))?;
            packed.finish()?.flush()
        }
        Some(Packing::Zstd) => {
            let mut packed = zstd::Frames::new(&mut place);
            into(Box::new(&mut packed))?;
            packed.finish()
        }
    }
}

/// Standard output, unless it was closed when the program began: nobody would have what is written.
pub fn standard() -> Result<StdoutLock<'static>, Failure> {
    if stdout_was_closed() {
        return Err(Failure::stdout(&io::Error::other("it is closed")));
    }
    refuse_printing()?;
    Ok(io::stdout().lock())
}

/// Writes to standard output.
pub fn print(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = standard()?;
    out.write_all(bytes).and_then(|()| out.flush()).map_err(|error| Failure::stdout(&error))
}

/// Removes what killed runs left beside a result that is there already, so that none is begun.
pub fn sweep_around(path: &Path) {
    unfinished::sweep(folder_of(&place_of(path)));
}

fn folder_of(place: &Path) -> &Path {
    place.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Prints a message on standard error; nothing where that is closed or full.
pub fn tell(message: &str) {
    tell_for_now("");
    let _ = writeln!(anstream::stderr(), "{message}");
}

/// Shows on a line of standard error what is being done, until the next message; an empty text takes the line away.
pub fn tell_for_now(doing: &str) {
    static HAS_LINE: AtomicBool = AtomicBool::new(false);
    if HAS_LINE.swap(!doing.is_empty(), Ordering::Relaxed) || !doing.is_empty() {
        let _ = write!(io::stderr(), "\r{}{doing}", Clear(ClearType::UntilNewLine));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raywalk::files::{Opened, Wanted};
    use std::sync::{Arc, Mutex};

    /// Is interrupted at every other call.
    struct Restless(Arc<Mutex<(usize, Vec<u8>)>>);

    impl Write for Restless {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let mut state = self.0.lock().expect("nobody panics");
            state.0 += 1;
            if state.0 % 2 == 1 {
                return Err(io::ErrorKind::Interrupted.into());
            }
            state.1.extend_from_slice(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn whatever_packs_a_result_goes_on_where_it_is_interrupted() {
        let text: Vec<u8> = (0..300_000_u32).flat_map(|x| x.wrapping_mul(2_654_435_761).to_be_bytes()).collect();
        for packing in [None, Some(Packing::Gzip), Some(Packing::Zstd)] {
            let taken = Arc::new(Mutex::new((0, Vec::new())));
            let written = through(Box::new(Restless(Arc::clone(&taken))), packing, |out| out.write_all(&text));
            written.expect("it is tried again");
            let (calls, packed) = taken.lock().expect("nobody panics").clone();
            assert!(calls > 1);
            let unpacked = match packing {
                None => packed,
                Some(_) => {
                    let wanted = Wanted { what: "a result", max_bytes: 1 << 30 };
                    let opened = wanted.begin(io::Cursor::new(packed), 0, "result".to_owned());
                    opened.and_then(Opened::bytes).expect("it is whole")
                }
            };
            assert!(unpacked == text);
        }
    }
}
