//! Signals that end the work early: unfinished files go, the exit code says why, and it happens at once.

use super::failure::{HUNG_UP, INTERRUPTED, TERMINATED};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
use signal_hook::flag;
use signal_hook::iterator::{Handle, Signals};
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex};
use std::{fs, io, process, thread};
use tempfile::NamedTempFile;

/// Files that are not finished yet.
static UNFINISHED: LazyLock<Mutex<Vec<PathBuf>>> = LazyLock::new(Mutex::default);

/// Ends the process on SIGINT, SIGTERM and SIGHUP, until the handle is closed.
///
/// A thread does it, so that neither a deep ray tree nor the encoding of a picture makes the user wait.
pub fn leave_on_signals() -> io::Result<Handle> {
    // A file that grows beyond what the system allows is an error of writing, and no reason to die with a core dump.
    flag::register(SIGXFSZ, Arc::default())?;
    let leaving = [SIGINT, SIGTERM].into_iter().chain((!ignores_hang_up()).then_some(SIGHUP));
    let mut signals = Signals::new(leaving)?;
    let handle = signals.handle();
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            // The lock is kept to the end, so that no file is begun any more.
            let mut unfinished = UNFINISHED.lock();
            for path in unfinished.iter_mut().flat_map(|paths| paths.drain(..)) {
                // It may be gone already.
                let _ = fs::remove_file(path);
            }
            process::exit(i32::from(exit_code(signal)));
        }
    };
    thread::Builder::new().spawn(wait)?;
    Ok(handle)
}

fn exit_code(signal: i32) -> u8 {
    match signal {
        SIGTERM => TERMINATED,
        SIGHUP => HUNG_UP,
        _ => INTERRUPTED,
    }
}

/// Whether the program was started so as to outlive its terminal, by `nohup`. Unknown where the system doesn't tell.
fn ignores_hang_up() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    ignored & (1 << (SIGHUP - 1)) != 0
}

/// Begins a file that is to be removed if a signal comes; none comes between the beginning and the note of its path.
pub fn unfinished(begin: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<NamedTempFile> {
    let mut paths = UNFINISHED.lock();
    let file = begin()?;
    if let Ok(paths) = &mut paths {
        paths.push(file.path().to_owned());
    }
    Ok(file)
}

/// The file with this path is finished.
pub fn finished(path: &Path) {
    if let Ok(mut paths) = UNFINISHED.lock() {
        paths.retain(|unfinished| unfinished != path);
    }
}
