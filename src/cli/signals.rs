//! What ends the work early: unfinished files go, the exit code says why, and it happens at once.

use super::failure::{HUNG_UP, INTERRUPTED, MACHINE, TERMINATED};
use raywalk_guard::{Endings, end_on_abort};
use signal_hook::consts::{SIGABRT, SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
use signal_hook::flag;
use std::sync::Arc;
use std::{fs, io};

/// Ends the process on SIGINT, SIGTERM and SIGHUP, until that is given up, and where it aborts itself.
///
/// The handler itself does it, so that neither a deep ray tree nor the encoding of a picture makes the user wait.
pub fn leave_on_signals() -> io::Result<Endings> {
    // A file that grows beyond what the system allows is an error of writing, and no reason to die with a core dump.
    flag::register(SIGXFSZ, Arc::default())?;
    end_on_abort(SIGABRT, MACHINE)?;
    let leaving = [(SIGINT, INTERRUPTED), (SIGTERM, TERMINATED)].into_iter();
    Endings::on(leaving.chain((!ignores_hang_up()).then_some((SIGHUP, HUNG_UP))))
}

/// Whether the program was started so as to outlive its terminal, by `nohup`. Unknown where the system doesn't say.
fn ignores_hang_up() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    ignored & (1 << (SIGHUP - 1)) != 0
}
