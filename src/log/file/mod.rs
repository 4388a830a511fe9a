//! Logs as files: `raywalk-log/1`, one event a line (NDJSON) or one nested document (JSON).

mod digest;
mod document;
mod error;
mod line;
mod lines;
mod mark;
mod numbers;
mod pixels;
mod read;
mod reader;
mod spelling;
mod write;

pub use error::{Ending, LogError};
pub use pixels::{PixelEvents, PixelReader};
pub use read::{read, read_from};
pub use reader::ReadLog;
pub use write::{Lines, Writer, digest, to_json, to_ndjson};

/// The most events of a saved log, or of one of its pixels where it is read by pixels, that are held in memory.
pub const MAX_SAVED_EVENTS: usize = 1 << 24;

/// How deep the nodes of a log may nest.
pub const MAX_NESTING: usize = 2048;
