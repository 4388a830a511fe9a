//! Where results go: standard output, or a file that is there whole or not at all.

use super::failure::{Failure, shown};
use super::inputs::{Claim, Inputs, place_of};
use super::{signals, zstd};
use flate2::Compression;
use flate2::write::GzEncoder;
use raywalk::scene::file::{Packing, stdout_was_closed};
use std::fs::{self, Permissions};
use std::io::{self, BufWriter, StdoutLock, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// A place for a result, made sure of before the work begins.
pub enum Output {
    /// Standard output.
    Stdout,
    /// A file that is written beside its place and then renamed.
    File {
        /// The file beside it.
        file: NamedTempFile,
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
            return standard().and_then(|_| inputs.refuse_standard_output()).map(|()| Output::Stdout);
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
        let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut builder = tempfile::Builder::new();
        builder.prefix(".raywalk-").suffix(".part");
        let permissions = metadata.map(|metadata| metadata.permissions()).or_else(default_permissions);
        if let Some(permissions) = permissions {
            builder.permissions(permissions);
        }
        // The system's error names the temporary file, which says nothing to anybody.
        let plain = |error: io::Error| match error.to_string().split_once(" at path ") {
            Some((said, _)) => io::Error::new(error.kind(), said.to_owned()),
            None => error,
        };
        let begun = signals::unfinished(|| builder.tempfile_in(folder));
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

    /// Writes a result that comes bit by bit; `write` may fail only because `out` does.
    pub fn stream(self, write: impl FnOnce(&mut Sink) -> io::Result<()>) -> Result<(), Failure> {
        match self {
            Output::Stdout => through(Box::new(standard()?), None, write).map_err(|error| Failure::stdout(&error)),
            Output::Special(file, path) => through(Box::new(file), None, write).map_err(|error| match error.kind() {
                io::ErrorKind::BrokenPipe => Failure::silent(0),
                _ => Failure::io(&path, "write", &error),
            }),
            Output::File { mut file, place, named, claim } => {
                let cannot_write = |error: &io::Error| Failure::io(&named, "write", error);
                // To the file itself: the errors of a temporary file name it, which says nothing to anybody.
                through(Box::new(file.as_file_mut()), packing(&named), write).map_err(|error| cannot_write(&error))?;
                file.as_file().sync_all().map_err(|error| cannot_write(&error))?;
                let unfinished = file.path().to_owned();
                file.persist(&place).map_err(|error| cannot_write(&error.error))?;
                signals::finished(&unfinished);
                claim.keep();
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
    mut place: Box<dyn Write + 'w>,
    packing: Option<Packing>,
    write: impl FnOnce(&mut Sink) -> io::Result<()>,
) -> io::Result<()> {
    let into = |place: Box<dyn Write + '_>| {
        let mut out = BufWriter::with_capacity(1 << 16, place);
        write(&mut out)?;
        out.flush()
    };
    match packing {
        None => into(place),
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
    Ok(io::stdout().lock())
}

/// Writes to standard output.
pub fn print(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = standard()?;
    out.write_all(bytes).and_then(|()| out.flush()).map_err(|error| Failure::stdout(&error))
}

/// What a new file gets, less the umask; a temporary file alone would be private.
#[cfg(unix)]
fn default_permissions() -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn default_permissions() -> Option<Permissions> {
    None
}

/// Tells people something on standard error; where that is closed or full there is nobody to tell.
pub fn tell(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}
