//! What the system says of a place: whether something is there, whose fault it is if that can't be had, and whether a standard stream is one.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

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

/// Whether something has this name, be it a link that leads nowhere.
///
/// # Errors
/// Where the system doesn't tell (a folder that may not be looked into, a disk that fails): then nobody may take it for absent.
pub fn is_there(path: &Path) -> io::Result<bool> {
    match fs::symlink_metadata(path) {
        Ok(_) => Ok(true),
        Err(error) if is_callers_fault(&error) => Ok(false),
        Err(error) => Err(error),
    }
}

/// Whether standard input was closed when the program began; see [`stdout_was_closed`].
#[cfg(unix)]
pub fn stdin_was_closed() -> bool {
    was_closed(0)
}

/// Whether standard output was closed when the program began.
///
/// Before anything else the standard library opens `/dev/null` in the place of closed streams, for reading and writing. A shell opens it for
/// one of the two (`> /dev/null`). Whoever starts programs that nobody listens to opens it for both, once for several streams; so a
/// stream is taken for closed only where it alone is such a `/dev/null`. Where two streams were closed it can't be known.
#[cfg(unix)]
pub fn stdout_was_closed() -> bool {
    was_closed(1)
}

#[cfg(unix)]
fn was_closed(which: usize) -> bool {
    use rustix::fs::{FileType, OFlags, fcntl_getfl, fcntl_setfl, fstat, stat};
    let streams = [rustix::stdio::stdin(), rustix::stdio::stdout(), rustix::stdio::stderr()];
    let (Ok(found), Ok(null), Ok(flags)) = (fstat(streams[which]), stat("/dev/null"), fcntl_getfl(streams[which]))
    else {
        return false;
    };
    let is_null = FileType::from_raw_mode(found.st_mode) == FileType::CharacterDevice && found.st_rdev == null.st_rdev;
    if !is_null || flags & (OFlags::RWMODE | OFlags::APPEND) != OFlags::RDWR {
        return false;
    }
    // Flags belong to what was opened, however many descriptors it has, and this one means nothing to this device.
    let has_flag = |stream: &usize| fcntl_getfl(streams[*stream]).is_ok_and(|flags| flags.contains(OFlags::APPEND));
    let neighbours: Vec<usize> = (0..3).filter(|stream| *stream != which && !has_flag(stream)).collect();
    let is_shared = fcntl_setfl(streams[which], flags | OFlags::APPEND).is_ok() && neighbours.iter().any(has_flag);
    // As it was, for whoever shares it.
    let _ = fcntl_setfl(streams[which], flags);
    !is_shared
}

/// Nobody tells.
#[cfg(not(unix))]
pub fn stdin_was_closed() -> bool {
    false
}

/// Nobody tells.
#[cfg(not(unix))]
pub fn stdout_was_closed() -> bool {
    false
}
