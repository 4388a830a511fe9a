//! What the system says of a place: whether something is there, and whose fault it is if that can't be had.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// Whether the caller named the wrong file, rather than the machine failing.
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

/// Whether something has this name, be it a link that leads nowhere.
///
/// # Errors
/// Unknown (a folder without permission, a failing disk): it must not be taken for absent.
pub fn is_there(path: &Path) -> io::Result<bool> {
    match fs::symlink_metadata(path) {
        Ok(_) => Ok(true),
        Err(error) if is_callers_fault(&error) => Ok(false),
        Err(error) => Err(error),
    }
}
