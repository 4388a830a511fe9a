//! The command line: one file a command.

mod bench;
mod causes;
mod color;
mod config;
mod diff;
mod failure;
mod frames;
mod inputs;
mod layers;
mod live;
mod lock;
mod log;
mod look;
mod merge;
mod options;
mod output;
mod packaging;
mod picture;
mod progress;
mod rays;
mod region;
mod render;
mod sampling_spec;
mod saved_log;
mod scene;
mod scene_argument;
mod shown;
mod signals;
mod stress;
mod textbook;
mod trace;
mod unfinished;
mod usage;
mod views;
mod walk;
mod zstd;

use clap::{Parser, Subcommand};
use failure::Failure;
pub use failure::MACHINE;
use options::ColorChoice;
use raywalk::geometry::processor;
use std::process::ExitCode;

/// A ray tracer whose every computed value can be walked through.
///
/// Without a command, walks through the numeric example of the source text in the terminal.
#[derive(Parser)]
#[command(name = "raywalk", bin_name = "raywalk", version, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    /// Whether to colour messages and the viewer; `auto` also heeds NO_COLOR
    #[arg(long, value_enum, default_value = "auto", global = true)]
    color: ColorChoice,
}

#[derive(Subcommand)]
enum Command {
    Walk(walk::Walk),
    Trace(trace::Trace),
    Render(render::Render),
    Merge(merge::Merge),
    Diff(diff::Diff),
    Rays(rays::Rays),
    Textbook(textbook::Textbook),
    Stress(stress::Stress),
    #[command(subcommand)]
    Bench(bench::Bench),
    #[command(subcommand)]
    Log(log::LogCommand),
    #[command(subcommand)]
    Scene(scene::SceneCommand),
    Completions(packaging::Completions),
    Man(packaging::Manual),
}

/// Runs the command line; gives the exit code of the process.
pub fn run() -> ExitCode {
    let cli = match usage::parse() {
        Ok(cli) => cli,
        Err(code) => return code,
    };
    // Small work is done on this thread: others are started only for work that is worth it.
    raywalk::threads::work_alone();
    // Where signals can't be caught they end the process all the same.
    let signals = signals::leave_on_signals().ok();
    if let Err(failure) = choose_instructions() {
        return failure.exit();
    }
    let colors = cli.color;
    colors.choose_for_messages();
    let done = match cli.command {
        Some(Command::Diff(diff)) => return exit_code(diff.run(colors, signals)),
        Some(Command::Textbook(textbook)) => return exit_code(textbook.run()),
        Some(Command::Stress(stress)) => return exit_code(stress.run()),
        None => walk::Walk::of_the_numeric_example().run(colors, signals),
        Some(Command::Walk(walk)) => walk.run(colors, signals),
        Some(Command::Trace(trace)) => trace.run(),
        Some(Command::Render(render)) => render.run(),
        Some(Command::Merge(merge)) => merge.run(),
        Some(Command::Rays(rays)) => rays.run(),
        Some(Command::Bench(bench)) => bench.run(),
        Some(Command::Log(command)) => command.run(),
        Some(Command::Scene(command)) => command.run(),
        Some(Command::Completions(completions)) => completions.run(),
        Some(Command::Man(manual)) => manual.run(),
    };
    exit_code(done.map(|()| true))
}

/// The exit code of a command that is done, with a positive answer or not.
fn exit_code(done: Result<bool, Failure>) -> ExitCode {
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(failure::NEGATIVE),
        Err(failure) => failure.exit(),
    }
}

/// The environment variable that keeps the program from the processor's best instructions, and what it says then.
const LANES: [&str; 2] = ["RAYWALK_LANES", "plain"];

/// For tests: the program as it is on a processor that has less.
fn choose_instructions() -> Result<(), Failure> {
    let [name, plain] = LANES;
    match std::env::var_os(name).filter(|lanes| !lanes.is_empty()) {
        None => {}
        Some(lanes) if lanes == plain => processor::keep_to_plain_instructions(),
        Some(lanes) => {
            let lanes = failure::shown(lanes.as_ref());
            return Err(Failure::caller(format!("{name} is `{lanes}`, expected `{plain}` or nothing")));
        }
    }
    Ok(())
}
