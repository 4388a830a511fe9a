//! `raywalk bench`: what the program measures about itself, one file a measurement.

mod arithmetic;
mod error;
mod limits;
mod machine;
mod overhead;
mod rays;
mod samplers;
mod scaling;
mod scenes;
mod table;

use super::failure::Failure;
use clap::{Subcommand, ValueEnum};
pub use machine::peak_bytes;

/// Measure error and time.
#[derive(Subcommand)]
pub enum Bench {
    /// How far pictures are off, and how long they take
    Error(error::ErrorBench),
    /// What recording, counting and other arithmetic cost
    Overhead(overhead::OverheadBench),
    /// How many rays per second are answered, on files of rays
    Rays(rays::RaysBench),
    /// How time and memory grow with the number of spheres and the size of a picture
    Scaling(scaling::ScalingBench),
}

/// How a table is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// For spreadsheets.
    Csv,
}

impl Bench {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        match self {
            Bench::Error(bench) => bench.run(),
            Bench::Overhead(bench) => bench.run(),
            Bench::Rays(bench) => bench.run(),
            Bench::Scaling(bench) => bench.run(),
        }
    }
}
