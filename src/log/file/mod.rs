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
mod write;

pub use error::LogError;
pub use pixels::{PixelEvents, PixelReader};
pub use read::{Ending, ReadLog, read, read_from};
pub use write::{Lines, Writer, to_json, to_ndjson};
