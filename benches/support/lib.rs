//! What the benches share.
//!
//! Two sides are timed against each other on a machine that has moods: in pairs, one right after the other and in turns, so that
//! a machine that slows down slows both. What counts is the median of the pairs' ratios. Where valgrind is installed, the
//! instructions are counted too.
//!
//! Every bench has a short run, `cargo bench -- --short`, for the gate: all that it checks, in seconds; its times are too few to say
//! much.

use raywalk::log::Step;
use raywalk::probe::{Probe, Silent};
use std::process::Command;
use std::time::{Duration, Instant};

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// As much as figures need.
    Whole,
    /// As little as shows that the bench works.
    Short,
}

impl Extent {
    /// As the command line asks: short with `--short`, and without the `--bench` that `cargo bench` gives.
    pub fn asked() -> Extent {
        let has = |wanted: &str| std::env::args().any(|argument| argument == wanted);
        if has("--bench") && !has("--short") { Extent::Whole } else { Extent::Short }
    }

    /// How many pairs are timed.
    pub fn pairs(self) -> usize {
        match self {
            Extent::Whole => 41,
            Extent::Short => 5,
        }
    }
}

/// What came of the pairs.
pub struct Pairs {
    /// The median time of the one side.
    pub one: Duration,
    /// The median time of the other.
    pub other: Duration,
    /// The ratio of each pair, sorted.
    ratios: Vec<f64>,
}

impl Pairs {
    /// Runs both sides, once before it counts to warm up caches and clock.
    pub fn timed(extent: Extent, one: impl Fn(), other: impl Fn()) -> Pairs {
        let (one, other) = (|| time(&one), || time(&other));
        let _ = (one(), other());
        let pair = |number: usize| {
            if number.is_multiple_of(2) {
                (one(), other())
            } else {
                let other = other();
                (one(), other)
            }
        };
        let pairs: Vec<_> = (0..extent.pairs()).map(pair).collect();
        let mut ratios: Vec<_> = pairs.iter().map(|(one, other)| one.as_secs_f64() / other.as_secs_f64()).collect();
        ratios.sort_by(f64::total_cmp);
        let (one, other): (Vec<_>, Vec<_>) = pairs.into_iter().unzip();
        Pairs { one: median(one), other: median(other), ratios }
    }

    /// The ratio of the times, the lower and the upper quartile of it.
    pub fn ratio(&self) -> [f64; 3] {
        [2, 1, 3].map(|part| self.ratios[(self.ratios.len() - 1) * part / 4])
    }
}

/// The instructions of `--run` with these arguments by this very bench, less those of getting ready, which the side `nothing` is.
pub fn instructions<const N: usize>(work: &str, sides: [&str; N], scene: &str) -> Option<[u64; N]> {
    let nothing = instructions_of(work, "nothing", scene)?;
    let mut counts = [0; N];
    for (count, side) in counts.iter_mut().zip(sides) {
        *count = instructions_of(work, side, scene)?.checked_sub(nothing)?;
    }
    Some(counts)
}

fn instructions_of(work: &str, side: &str, scene: &str) -> Option<u64> {
    let this = std::env::current_exe().ok()?;
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
    valgrind.arg(this).args(["--run", work, side, scene]);
    let output = valgrind.output().ok()?;
    let messages = String::from_utf8_lossy(&output.stderr);
    let collected = messages.lines().find_map(|line| line.split_once("Collected : "))?.1;
    collected.trim().parse().ok()
}

fn time(work: impl Fn()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times[times.len() / 2]
}

/// Silence that asks for no more digits than f64 has. In all else it is [`Silent`], and what the compiler makes of it, too.
pub struct Uncertified;

impl Probe for Uncertified {
    const IS_SILENT: bool = Silent::IS_SILENT;
    const USES_SIMD: bool = Silent::USES_SIMD;

    #[inline(always)]
    fn certifies(&self) -> bool {
        false
    }

    #[inline(always)]
    fn within<T>(&mut self, _step: Step, body: impl FnOnce(&mut Uncertified) -> T) -> T {
        body(self)
    }
}
