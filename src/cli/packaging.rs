//! `raywalk completions` and `raywalk man`: what a package installs beside the program.

use super::Cli;
use super::failure::{Failure, shown};
use super::inputs::Inputs;
use super::output::{self, Output};
use clap::{Args, Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;
use std::io;
use std::path::PathBuf;

const COMPLETIONS: &str = "\
Examples:
  raywalk completions bash > ~/.local/share/bash-completion/completions/raywalk
  raywalk completions zsh > /usr/local/share/zsh/site-functions/_raywalk
  raywalk completions fish > ~/.config/fish/completions/raywalk.fish";

const MANUAL: &str = "\
Examples:
  raywalk man | man -l -
  raywalk man -o /usr/local/share/man/man1";

/// Print a shell's completion script.
#[derive(Args)]
#[command(after_long_help = COMPLETIONS)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

/// Print the manual page, or write those of all commands into a folder.
#[derive(Args)]
#[command(after_long_help = MANUAL)]
pub struct Manual {
    /// The folder for the pages of all commands, such as /usr/local/share/man/man1; created if missing
    #[arg(long, short, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

impl Completions {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let (mut command, mut script) = (Cli::command(), Vec::new());
        let name = command.get_name().to_owned();
        clap_complete::generate(self.shell, &mut command, name, &mut script);
        output::print(&script)
    }
}

impl Manual {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let mut command = Cli::command();
        command.build();
        let Some(folder) = &self.output else { return output::print(&page(command)?) };
        std::fs::create_dir_all(folder).map_err(|error| match folder.is_dir() || !folder.exists() {
            true => Failure::io(folder, "create", &error),
            false => Failure::caller(format!("{}: is a file, expected a folder", shown(folder))),
        })?;
        for command in with_all_below(command) {
            let path = folder.join(format!("{}.1", command.get_display_name().unwrap_or(command.get_name())));
            Output::create(Some(&path), &Inputs::none())?.commit(&page(command)?)?;
        }
        Ok(())
    }
}

fn page(command: Command) -> Result<Vec<u8>, Failure> {
    let mut page = Vec::new();
    let written = Man::new(command).render(&mut page);
    written.map_err(|error: io::Error| Failure::machine(format!("man: cannot write: {error}")))?;
    Ok(page)
}

/// A command, and all commands in it but `help`.
fn with_all_below(command: Command) -> Vec<Command> {
    let below: Vec<Command> = command.get_subcommands().filter(|below| below.get_name() != "help").cloned().collect();
    std::iter::once(command).chain(below.into_iter().flat_map(with_all_below)).collect()
}
