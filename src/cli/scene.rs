//! `raywalk scene`: check, show, convert and list scenes.

use super::failure::Failure;
use super::options::{ColorChoice, NffOptions};
use super::output::{self, Output};
use super::scene_argument;
use clap::{Args, Subcommand};
use raywalk::scene::file::SceneFile;
use raywalk::scene::{build, builtin, file::visible};
use std::path::PathBuf;

/// Check, show, convert or list scenes.
#[derive(Subcommand)]
pub enum SceneCommand {
    /// Say everything that is wrong with a scene
    Check(Named),
    /// Print a scene with all its defaults
    Show(Named),
    /// Write a scene of another format (NFF) as JSON: one object a primitive, one material a fill
    Convert {
        #[command(flatten)]
        scene: Named,
        /// Where to write; standard output without it
        #[arg(long, short, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// List the built-in scenes
    List,
}

/// The scene of a command.
#[derive(Args)]
pub struct Named {
    /// A scene file (JSON or NFF, also packed by gzip), `-` for standard input, or a built-in scene
    scene: PathBuf,
    #[command(flatten)]
    nff: NffOptions,
}

impl Named {
    fn load(&self, colors: ColorChoice) -> Result<SceneFile, Failure> {
        Ok(scene_argument::load(&self.scene, &self.nff.import(), colors)?.scene)
    }
}

impl SceneCommand {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        match self {
            SceneCommand::Check(scene) => {
                let file = scene.load(colors)?;
                build(&file).map_err(|unsupported| Failure::caller(unsupported.to_string()))?;
                let (objects, lights, materials) = (file.objects.len(), file.lights.len(), file.materials.len());
                let name = visible(&file.name).into_owned();
                let counts = format!("{objects} objects, {lights} lights, {materials} materials");
                output::print(format!("{name}: ok, {counts}\n").as_bytes())
            }
            SceneCommand::Show(scene) => output::print(scene.load(colors)?.to_json().as_bytes()),
            SceneCommand::Convert { scene, output } => {
                let file = scene.load(colors)?;
                Output::create(output.as_deref(), &scene.scene)?.commit(file.to_json().as_bytes())
            }
            SceneCommand::List => {
                let names: String = builtin::names().map(|name| format!("{name}\n")).collect();
                output::print(names.as_bytes())
            }
        }
    }
}
