//! Signals that end the work early.

use super::failure::{Failure, INTERRUPTED, TERMINATED};
use signal_hook::consts::{SIGINT, SIGTERM};
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Flags that signals set.
pub struct Signals {
    /// Set by either signal.
    pub stop: Arc<AtomicBool>,
    terminated: Arc<AtomicBool>,
}

impl Signals {
    /// Catches SIGINT and SIGTERM. A second one ends the process at once.
    pub fn catch() -> io::Result<Signals> {
        let signals = Signals { stop: Arc::default(), terminated: Arc::default() };
        for (signal, code) in [(SIGINT, INTERRUPTED), (SIGTERM, TERMINATED)] {
            signal_hook::flag::register_conditional_shutdown(signal, i32::from(code), signals.stop.clone())?;
            signal_hook::flag::register(signal, signals.stop.clone())?;
        }
        signal_hook::flag::register(SIGTERM, signals.terminated.clone())?;
        Ok(signals)
    }

    /// The end that the signal asked for.
    pub fn failure(&self) -> Failure {
        let is_terminated = self.terminated.load(Ordering::Relaxed);
        Failure::silent(if is_terminated { TERMINATED } else { INTERRUPTED })
    }
}
