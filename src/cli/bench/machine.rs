//! The machine that was measured on, without which times mean nothing.

use raywalk::files::escape_hidden;
use serde::Serialize;
use std::fmt;
use std::fs;
use std::thread::available_parallelism;

/// What the figures of a benchmark depend on.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    /// The version of the program.
    pub version: &'static str,
    /// The model of the processor, where the system reports it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub processor: Option<String>,
    /// How many cores the program may use.
    pub cores: usize,
    /// The operating system and the architecture.
    pub system: String,
    /// Whether the program was built without optimisation, so that times say nothing.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub unoptimized: bool,
}

impl Machine {
    /// This one.
    pub fn this() -> Machine {
        Machine {
            version: env!("CARGO_PKG_VERSION"),
            processor: processor(),
            cores: available_parallelism().map_or(1, usize::from),
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            unoptimized: cfg!(debug_assertions),
        }
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Machine { version, processor, cores, system, unoptimized } = self;
        let processor = processor.as_deref().unwrap_or("unknown processor");
        write!(f, "raywalk {version}, {}, cores: {cores}, {system}", escape_hidden(processor))?;
        if *unoptimized { write!(f, "; built without optimisation: times say nothing") } else { Ok(()) }
    }
}

/// The model of the processor, where the system has a file that says it.
fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// The most memory that this process held since it began, in bytes, where the system reports it.
pub fn peak_bytes() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().trim_end_matches(" kB").parse().ok()?;
    Some(kibibytes * 1024)
}
