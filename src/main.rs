//! The `raywalk` command: parses, dispatches, and maps what goes wrong to exit codes.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
