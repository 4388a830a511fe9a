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
    let name = display_name(path);
    let bytes = read_as_it_is(path, &name)?;
    gzip::unpacked(bytes, MAX_BYTES).map_err(|reason| refused(&name, reason))
}

fn read_as_it_is(path: &Path, name: &str) -> Result<Vec<u8>, SceneError> {
    if path == Path::new("-") {
        return read_bounded(io::stdin().lock(), 0, name);
    }
    // Asked before opening, because opening a FIFO would wait for a writer.
    let metadata = fs::metadata(path).map_err(|error| failure(name, error))?;
    refuse_what_is_no_file(&metadata, name)?;
    let file = File::open(path).map_err(|error| failure(name, error))?;
    read_bounded(file, metadata.len(), name)
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

fn refuse_what_is_no_file(metadata: &Metadata, name: &str) -> Result<(), SceneError> {
    if let Some(thing) = irregular(metadata) {
        return Err(refused(name, format!("expected a regular file, found {thing}")));
    }
    if metadata.len() > MAX_BYTES {
        return Err(too_large(name, &format!("found {} bytes", metadata.len())));
    }
    Ok(())
}

fn read_bounded(input: impl Read, expected: u64, name: &str) -> Result<Vec<u8>, SceneError> {
    let mut bytes = Vec::new();
    bytes
        .try_reserve(usize::try_from(expected).unwrap_or(usize::MAX))
        .map_err(|_| failure(name, ErrorKind::OutOfMemory.into()))?;
    input.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(|error| failure(name, error))?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(too_large(name, "found more"));
    }
    Ok(bytes)
}

fn failure(name: &str, source: io::Error) -> SceneError {
    if source.kind() == ErrorKind::NotFound {
        refused(name, "no such file, expected a scene file".to_string())
    } else if is_callers_fault(&source) {
        refused(name, format!("expected a scene file: {source}"))
    } else {
        SceneError::Unreadable { file: name.to_string(), source }
    }
}

fn too_large(name: &str, found: &str) -> SceneError {
    refused(name, format!("too large, expected at most {MAX_BYTES} bytes, {found}"))
}

fn refused(name: &str, reason: String) -> SceneError {
    SceneError::Refused { file: name.to_string(), reason }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

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
        let error = read_bounded(io::repeat(b' '), 0, "-").unwrap_err();
        assert_eq!(error.exit_code(), 2);
    }

    #[test]
    fn a_failing_disk_may_be_tried_again() {
        let error = failure("a", ErrorKind::PermissionDenied.into());
        assert_eq!(error.exit_code(), 3);
    }
}
