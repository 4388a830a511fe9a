//! Signals that end the work early: unfinished files go, the exit code says why, and it happens at once.

use super::failure::{INTERRUPTED, TERMINATED};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::{Handle, Signals};
use std::path::PathBuf;
use std::sync::{LazyLock, Mutex};
use std::{fs, io, process, thread};

/// Files that are not finished yet.
static UNFINISHED: LazyLock<Mutex<Vec<PathBuf>>> = LazyLock::new(Mutex::default);

/// Ends the process on SIGINT and SIGTERM, until the handle is closed.
///
/// A thread does it, so that neither a deep ray tree nor the encoding of a picture makes the user wait.
pub fn leave_on_signals() -> io::Result<Handle> {
    let mut signals = Signals::new([SIGINT, SIGTERM])?;
    let handle = signals.handle();
    thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            for path in UNFINISHED.lock().iter_mut().flat_map(|paths| paths.drain(..)) {
                // It may be gone already.
                let _ = fs::remove_file(path);
            }
            process::exit(i32::from(if signal == SIGTERM { TERMINATED } else { INTERRUPTED }));
        }
    });
    Ok(handle)
}

/// A file to remove if a signal comes.
pub fn unfinished(path: PathBuf) {
    if let Ok(mut paths) = UNFINISHED.lock() {
        paths.push(path);
    }
}

/// All files are finished.
pub fn finished() {
    if let Ok(mut paths) = UNFINISHED.lock() {
        paths.clear();
    }
}
