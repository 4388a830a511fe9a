//! `raywalk log`: how logs are written.

use super::failure::Failure;
use super::output;
use clap::{Args, Subcommand, ValueEnum};
use raywalk::log::schema;

const MORE: &str = "\
Examples:
  raywalk log schema | less -S
  raywalk log schema --format json > raywalk-log.schema.json";

/// Describe the format of logs.
#[derive(Subcommand)]
pub enum LogCommand {
    Schema(Schema),
}

/// Print the format of logs: lines, nodes, decisions, and every quantity with its symbol, formula and unit.
#[derive(Args)]
#[command(after_long_help = MORE)]
pub struct Schema {
    /// How to print it
    #[arg(long, value_enum, default_value = "text")]
    format: SchemaFormat,
}

#[derive(Clone, Copy, ValueEnum)]
enum SchemaFormat {
    /// A table for people.
    Text,
    /// A JSON Schema of a line, for programs.
    Json,
}

impl LogCommand {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let LogCommand::Schema(Schema { format }) = self;
        match format {
            SchemaFormat::Text => output::print(schema::text().as_bytes()),
            SchemaFormat::Json => output::print(format!("{:#}\n", schema::json_schema()).as_bytes()),
        }
    }
}
