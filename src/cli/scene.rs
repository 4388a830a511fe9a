//! `raywalk scene`: check, show and list scenes.

use super::failure::Failure;
use super::options::ColorChoice;
use super::output::{self, Output};
use super::scene_argument::{self, Loaded};
use clap::{Subcommand, ValueEnum};
use raywalk::scene::{build, builtin, file::visible, generate};
use std::path::{Path, PathBuf};

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
    /// Write a scene or mesh that is computed
    Generate {
        /// What to write
        #[arg(value_enum)]
        what: Generated,
        /// How fine or deep it is
        #[arg(long, value_name = "N", default_value_t = 3)]
        #[arg(value_parser = clap::value_parser!(u32).range(0..=i64::from(generate::MAX_LEVEL)))]
        level: u32,
        /// Where to write; standard output without it
        #[arg(long, short, value_name = "FILE")]
        output: Option<PathBuf>,
    },
}

/// What can be computed.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Generated {
    /// A knotted tube as an OBJ mesh of 256 * 4^N triangles
    Knot,
    /// A ball as an OBJ mesh of 20 * 4^N triangles
    Icosphere,
    /// A scene of 1 + 9 + ... + 9^N spheres that carry spheres
    SphereFlake,
}

impl SceneCommand {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        match self {
            SceneCommand::Check { scene } => {
                let Loaded { scene: file, meshes } = scene_argument::load(&scene, colors)?;
                build(&file, &meshes).map_err(|unsupported| Failure::caller(unsupported.to_string()))?;
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
            SceneCommand::Generate { what, level, output } => {
                let output = Output::create(output.as_deref(), Path::new(""))?;
                output.stream(|out| match what {
                    Generated::Knot => generate::write_obj(&generate::knot(level), out),
                    Generated::Icosphere => generate::write_obj(&generate::icosphere(level), out),
                    Generated::SphereFlake => generate::sphere_flake(level, out),
                })
            }
        }
    }
}
