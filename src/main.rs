//! The `raywalk` command: parses, dispatches, and maps what goes wrong to exit codes.

mod cli;

use raywalk_guard::{Allocator, give_back_large_pieces};
use std::panic::catch_unwind;
use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: Allocator = Allocator::new(cli::MACHINE);

fn main() -> ExitCode {
    give_back_large_pieces();
    // A panic is a bug of ours; its message is out, and scripts needn't know another exit code.
    catch_unwind(cli::run).unwrap_or(ExitCode::from(cli::MACHINE))
}
