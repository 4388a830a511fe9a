//! How long work takes, by the clock and in processor time, which other programs on the machine disturb less.

use rustix::time::{ClockId, clock_gettime};
use std::time::Instant;

/// What a piece of work took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lap {
    /// Seconds by the clock.
    pub seconds: f64,
    /// Processor seconds of all threads of the program together.
    pub cpu_seconds: f64,
}

/// Does the work, and says what it took.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, Lap) {
    let (begun, cpu) = (Instant::now(), cpu_seconds());
    let done = work();
    (done, Lap { seconds: begun.elapsed().as_secs_f64(), cpu_seconds: cpu_seconds() - cpu })
}

/// The processor seconds of the program so far.
fn cpu_seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}
