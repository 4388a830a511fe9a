//! Logs as files: `raywalk-log/1`, one event a line (NDJSON) or one nested document (JSON).

mod document;
mod error;
mod line;
mod lines;
mod pixels;
mod read;
mod reader;
mod shards;
mod write;

pub use error::LogError;
pub use pixels::{PixelEvents, PixelReader};
pub use read::{Ending, ReadLog, is_log, read, read_from};
pub use shards::ShardLog;
pub use write::{Lines, Writer, to_json, to_ndjson};
