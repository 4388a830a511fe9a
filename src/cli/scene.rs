//! `raywalk scene`: check, show, convert, list and generate scenes, and say how they are written.

mod lights;

use super::failure::Failure;
use super::inputs::Inputs;
use super::options::NffOptions;
use super::output::{self, Output};
use super::scene_argument::{self, Loaded};
use clap::{Args, Subcommand, ValueEnum};
use raywalk::files::escape_hidden;
use raywalk::scene::file::{SceneFile, schema};
use raywalk::scene::{Around, build_with, builtin, generate};
use std::path::{Path, PathBuf};

/// Check, show, convert, list or generate scenes.
#[derive(Subcommand)]
pub enum SceneCommand {
    /// Report everything that is wrong with a scene
    Check(Named),
    /// Print a scene with all its defaults
    Show(Named),
    /// Convert a scene of another format (NFF) to JSON: one object per primitive, one material per fill
    Convert {
        #[command(flatten)]
        scene: Named,
        /// Where to write; standard output without it
        #[arg(long, short, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print the JSON Schema of scene files, for editors
    Schema,
    /// List the built-in scenes
    List,
    /// Generate a scene or a mesh
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
    /// A scene of 1 + 10 + ... + 10^N spheres that carry spheres, N from 0 to 6
    SphereFlake,
}

/// The scene of a command.
#[derive(Args)]
pub struct Named {
    /// A scene file (JSON or NFF, also compressed with gzip or zstd), `-` for standard input, or a built-in scene
    scene: PathBuf,
    #[command(flatten)]
    nff: NffOptions,
}

impl Named {
    /// The scene, and its files.
    fn without_meshes(&self) -> Result<(SceneFile, Inputs), Failure> {
        let input = scene_argument::read(&self.scene)?;
        let scene = scene_argument::without_meshes(&input, &self.nff.import())?;
        let inputs = input.files(&scene);
        Ok((scene, inputs))
    }
}

impl SceneCommand {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        match self {
            SceneCommand::Check(scene) => {
                let input = scene_argument::read(&scene.scene)?;
                let import = scene.nff.import();
                let loaded = scene_argument::scene(&input, &import)?;
                let Loaded { scene: file, meshes, .. } = loaded;
                let name = escape_hidden(&file.name).into_owned();
                let counted = |count: usize, what| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
                let counts = [
                    counted(file.objects.len(), "object"),
                    counted(file.lights.len(), "light"),
                    counted(file.materials.len(), "material"),
                ];
                let counts = counts.join(", ");
                let built = build_with(file, &meshes, Around::default());
                let built = built.map_err(|unsupported| Failure::caller(unsupported.to_string()))?;
                lights::tell(&input, built);
                output::print(format!("{name}: ok, {counts}\n").as_bytes())
            }
            SceneCommand::Show(scene) => {
                let (file, inputs) = scene.without_meshes()?;
                Output::create(None, &inputs)?.stream(|out| file.write_json(out))
            }
            SceneCommand::Convert { scene, output } => {
                let (file, inputs) = scene.without_meshes()?;
                let output_file = Output::create(output.as_deref(), &inputs)?;
                warn_of_meshes(&file, &scene.scene, output.as_deref());
                output_file.stream(|out| file.write_json(out))
            }
            SceneCommand::Schema => output::print(format!("{:#}\n", schema::json_schema()).as_bytes()),
            SceneCommand::List => {
                let names: String = builtin::names().map(|name| format!("{name}\n")).collect();
                output::print(names.as_bytes())
            }
            SceneCommand::Generate { what, level, output } => {
                if matches!(what, Generated::SphereFlake) && level > generate::MAX_FLAKE_LEVEL {
                    let most = generate::MAX_FLAKE_LEVEL;
                    return Err(Failure::caller(format!(
                        "--level: must be from 0 to {most} for a sphere-flake, found {level}"
                    )));
                }
                let output = Output::create(output.as_deref(), &Inputs::none())?;
                output.stream(|out| match what {
                    Generated::Knot => generate::write_obj(&generate::knot(level), out),
                    Generated::Icosphere => generate::write_obj(&generate::icosphere(level), out),
                    Generated::SphereFlake => generate::sphere_flake(level, out),
                })
            }
        }
    }
}

/// Paths of meshes are relative to the scene file, so they lead nowhere when that is written into another folder.
fn warn_of_meshes(file: &SceneFile, scene: &Path, output: Option<&Path>) {
    let folder = |path: &Path| path.parent().and_then(|folder| folder.join(".").canonicalize().ok());
    let stays = output.is_some_and(|output| {
        let is_file = scene.exists() && scene != Path::new("-");
        is_file && folder(&Path::new(".").join(output)) == folder(&Path::new(".").join(scene))
    });
    let paths = scene_argument::mesh_paths(file);
    if !stays && !paths.is_empty() {
        let list = paths.iter().map(|path| format!("`{}`", escape_hidden(path))).collect::<Vec<_>>().join(", ");
        output::tell(&format!(
            "warning: the meshes {list} are looked for beside the scene that is written: copy them there"
        ));
    }
}
