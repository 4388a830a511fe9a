//! `raywalk scene`: check, show and list scenes.

use super::failure::Failure;
use super::options::ColorChoice;
use super::{output, scene_argument};
use clap::Subcommand;
use raywalk::scene::{build, builtin, file::visible};
use std::path::PathBuf;

/// Check, show or list scenes.
#[derive(Subcommand)]
pub enum SceneCommand {
    /// Say everything that is wrong with a scene
    Check {
        /// A scene file, `-` for standard input, or a built-in scene
        scene: PathBuf,
    },
    /// Print a scene with all its defaults
    Show {
        /// A scene file, `-` for standard input, or a built-in scene
        scene: PathBuf,
    },
    /// List the built-in scenes
    List,
}

impl SceneCommand {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        match self {
            SceneCommand::Check { scene } => {
                let file = scene_argument::load(&scene, colors)?.scene;
                build(&file).map_err(|unsupported| Failure::caller(unsupported.to_string()))?;
                let (objects, lights, materials) = (file.objects.len(), file.lights.len(), file.materials.len());
                let name = visible(&file.name).into_owned();
                let counts = format!("{objects} objects, {lights} lights, {materials} materials");
                output::print(format!("{name}: ok, {counts}\n").as_bytes())
            }
            SceneCommand::Show { scene } => {
                let file = scene_argument::load(&scene, colors)?.scene;
                output::print(format!("{}\n", file.to_json().trim_end()).as_bytes())
            }
            SceneCommand::List => {
                let names: String = builtin::names().map(|name| format!("{name}\n")).collect();
                output::print(names.as_bytes())
            }
        }
    }
}
