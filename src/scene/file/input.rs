//! Bytes from outside, of bounded size and never by waiting for a device.

use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use super::error::SceneError;
use super::gzip;

/// The largest scene file: 256 MiB.
pub const MAX_BYTES: u64 = 256 << 20;

/// The name that standard input has in messages.
pub const STANDARD_INPUT: &str = "<stdin>";

/// Reads a regular file, or standard input for `-`, up to [`MAX_BYTES`]; what is packed by gzip is unpacked.
///
/// # Errors
/// [`SceneError::Refused`] when it is missing, no regular file or too large; [`SceneError::Unreadable`] when the machine
/// did not give the bytes.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, SceneError> {
    Wanted { what: "a scene file", max_bytes: MAX_BYTES }.read(path)
}

/// What kind of file is read.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// The kind, in words.
    pub what: &'static str,
    /// The largest one.
    pub max_bytes: u64,
}

impl Wanted {
    /// Reads such a file, or standard input for `-`, and unpacks it; errors are those of [`read_bytes`].
    pub fn read(self, path: &Path) -> Result<Vec<u8>, SceneError> {
        let name = display_name(path);
        let bytes = self.read_as_it_is(path, &name)?;
        gzip::unpacked(bytes, self.max_bytes).map_err(|reason| refused(&name, reason))
    }

    fn read_as_it_is(self, path: &Path, name: &str) -> Result<Vec<u8>, SceneError> {
        if path == Path::new("-") {
            return self.read_bounded(io::stdin().lock(), 0, name);
        }
        // Asked before opening, because opening a FIFO would wait for a writer.
        let metadata = fs::metadata(path).map_err(|error| self.failure(name, error))?;
        if let Some(thing) = irregular(&metadata) {
            return Err(refused(name, format!("expected a regular file, found {thing}")));
        }
        if metadata.len() > self.max_bytes {
            return Err(self.too_large(name, &format!("found {} bytes", metadata.len())));
        }
        let file = File::open(path).map_err(|error| self.failure(name, error))?;
        self.read_bounded(file, metadata.len(), name)
    }

    fn read_bounded(self, input: impl Read, expected: u64, name: &str) -> Result<Vec<u8>, SceneError> {
        let mut bytes = Vec::new();
        bytes
            .try_reserve(usize::try_from(expected).unwrap_or(usize::MAX))
            .map_err(|_| self.failure(name, ErrorKind::OutOfMemory.into()))?;
        input.take(self.max_bytes + 1).read_to_end(&mut bytes).map_err(|error| self.failure(name, error))?;
        if bytes.len() as u64 > self.max_bytes {
            return Err(self.too_large(name, "found more"));
        }
        Ok(bytes)
    }

    fn failure(self, name: &str, source: io::Error) -> SceneError {
        let what = self.what;
        if source.kind() == ErrorKind::NotFound {
            refused(name, format!("no such file, expected {what}"))
        } else if is_callers_fault(&source) {
            refused(name, format!("expected {what}: {source}"))
        } else {
            SceneError::Unreadable { file: name.to_string(), source }
        }
    }

    fn too_large(self, name: &str, found: &str) -> SceneError {
        refused(name, format!("too large, expected at most {} bytes, {found}", self.max_bytes))
    }
}

/// The name of a file as messages show it.
pub fn display_name(path: &Path) -> String {
    if path == Path::new("-") { STANDARD_INPUT.to_string() } else { path.to_string_lossy().into_owned() }
}

/// What a thing that is no regular file is, in words.
pub fn irregular(metadata: &Metadata) -> Option<&'static str> {
    let kind = metadata.file_type();
    if kind.is_file() {
        return None;
    }
    if kind.is_dir() {
        return Some("a directory");
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_fifo() {
            return Some("a FIFO");
        }
        if kind.is_char_device() || kind.is_block_device() {
            return Some("a device");
        }
        if kind.is_socket() {
            return Some("a socket");
        }
    }
    Some("something else")
}

/// Whether the caller named the wrong thing, rather than the machine failing.
pub fn is_callers_fault(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        ErrorKind::NotFound
            | ErrorKind::IsADirectory
            | ErrorKind::NotADirectory
            | ErrorKind::InvalidFilename
            | ErrorKind::InvalidInput
    )
}

fn refused(name: &str, reason: String) -> SceneError {
    SceneError::Refused { file: name.to_string(), reason }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn scene_file() -> Wanted {
        Wanted { what: "a scene file", max_bytes: MAX_BYTES }
    }

    #[track_caller]
    fn refuses(path: &Path, exit_code: u8, part: &str) {
        let error = read_bytes(path).unwrap_err();
        assert_eq!(error.exit_code(), exit_code);
        assert!(error.to_string().contains(part), "{error}");
    }

    #[test]
    fn a_missing_file() {
        refuses(Path::new("/no/such/scene.json"), 2, "no such file");
    }

    #[test]
    fn a_directory() {
        refuses(&std::env::temp_dir(), 2, "expected a regular file, found a directory");
    }

    #[test]
    #[cfg(unix)]
    fn an_endless_device() {
        refuses(Path::new("/dev/zero"), 2, "found a device");
    }

    #[test]
    #[cfg(unix)]
    fn a_fifo_that_nobody_writes_does_not_hang() {
        let folder = tempfile::tempdir().unwrap();
        let fifo = folder.path().join("fifo");
        let made = std::process::Command::new("mkfifo").arg(&fifo).status().unwrap();
        assert!(made.success());
        refuses(&fifo, 2, "found a FIFO");
    }

    #[test]
    fn a_huge_file_is_refused_by_its_size() {
        let file = tempfile::NamedTempFile::new().unwrap();
        file.as_file().set_len(5 << 30).unwrap();
        refuses(file.path(), 2, "expected at most 268435456 bytes, found 5368709120 bytes");
    }

    #[test]
    fn endless_input_ends_at_the_limit() {
        let error = scene_file().read_bounded(io::repeat(b' '), 0, "-").unwrap_err();
        assert_eq!(error.exit_code(), 2);
    }

    #[test]
    fn a_failing_disk_may_be_tried_again() {
        let error = scene_file().failure("a", ErrorKind::PermissionDenied.into());
        assert_eq!(error.exit_code(), 3);
    }
}
