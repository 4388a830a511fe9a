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

/// Measure speed, error, overhead and growth.
#[derive(Subcommand)]
pub enum Bench {
    Error(error::ErrorBench),
    Overhead(overhead::OverheadBench),
    Rays(rays::RaysBench),
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
