//! The scenes that a benchmark renders.

use crate::cli::failure::Failure;
use crate::cli::inputs::Inputs;
use crate::cli::options::{self, TracingOptions};
use crate::cli::scene_argument;
use clap::Args;
use raywalk::render::ask_for_memory;
use raywalk::scene::Scene;
use std::path::{Path, PathBuf};

/// Some scenes of different kinds: what is measured where none is named.
pub const FEW: [&str; 4] = ["textbook", "figure-6", "table-top", "glass-and-mirror"];

/// Scenes of deep ray trees: what their limits are compared on where none is named.
pub const BRANCHING: [&str; 3] = ["glass-and-mirror", "hall-of-mirrors", "table-top"];

/// Scenes of edges, of an area light and of a lens: what methods of sampling are compared on where none is named.
pub const SAMPLED: [&str; 3] = ["figure-17", "penumbra", "depth-of-field"];

/// The scenes, and their size.
#[derive(Args)]
pub struct SceneOptions {
    /// Scenes: files or built-in names; some of the built-in ones where none is named
    #[arg(value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Pixels across and down
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "160x120")]
    size: [u32; 2],
}

impl SceneOptions {
    /// The scenes that are named, or else these.
    pub fn names(&self, otherwise: &[&str]) -> Vec<PathBuf> {
        if self.scenes.is_empty() { otherwise.iter().map(PathBuf::from).collect() } else { self.scenes.clone() }
    }

    /// A scene of that name in this size with its files, and makes sure that there is memory for its picture.
    pub fn load(&self, name: &Path) -> Result<(Scene, Inputs), Failure> {
        let tracing = TracingOptions { size: Some(self.size), ..TracingOptions::default() };
        let loaded = scene_argument::load(name, &tracing.import())?;
        let inputs = loaded.inputs.clone();
        let scene = tracing.apply(loaded)?;
        let [width, height] = self.size;
        ask_for_memory([0, 0, width, height]).map_err(|error| Failure::machine(error.to_string()))?;
        Ok((scene, inputs))
    }
}
