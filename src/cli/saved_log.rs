//! Logs that were saved.

use super::failure::Failure;
use raywalk::log::file::LogError;
use std::io::ErrorKind;

/// The longest log: some forty million events.
pub const MAX_LOG_BYTES: u64 = 4 << 30;

/// Why a log can't be read, as messages call it by its name.
pub fn failure(name: &str, error: &LogError) -> Failure {
    match error {
        // A document is whole or nothing.
        LogError::Io(error)
            if matches!(error.kind(), ErrorKind::FileTooLarge | ErrorKind::InvalidData | ErrorKind::UnexpectedEof) =>
        {
            Failure::caller(format!("{name}: {error}"))
        }
        LogError::Io(error) => Failure::machine(format!("{name}: cannot read: {error}")),
        _ => Failure::caller(format!("{name}:{error}")),
    }
}
