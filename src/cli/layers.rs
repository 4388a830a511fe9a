//! `render --layers`: what pixels cost and what they see, in the picture's own file or beside it.

use super::failure::Failure;
use super::output::Output;
use raywalk::render::export::{self, Encoded, Format};
use raywalk::render::layers::{Layer, Layered, false_colors};
use raywalk::scene::Scene;
use std::path::{Path, PathBuf};

/// The layers that are wanted, each once, in the order of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layers(Vec<Layer>);

/// The files of layers that stand beside a picture, made sure of before the work begins.
pub struct Files(Vec<(Layer, PathBuf, Output)>);

impl std::str::FromStr for Layers {
    type Err = String;

    fn from_str(text: &str) -> Result<Layers, String> {
        if text == "all" {
            return Ok(Layers(Layer::ALL.to_vec()));
        }
        let mut layers = Vec::new();
        for word in text.split(',') {
            let layer = word.trim().parse()?;
            if layers.contains(&layer) {
                return Err(format!("the layer `{}` stands there twice", word.trim()));
            }
            layers.push(layer);
        }
        Ok(Layers(layers))
    }
}

impl Layers {
    /// Refuses formats that have no place for layers.
    pub fn check(&self, format: Format) -> Result<(), Failure> {
        match format {
            Format::Exr | Format::Png8 | Format::Png16 => Ok(()),
            Format::Ppm | Format::Pfm => {
                Err(Failure::caller("render: --layers: expected a picture in .exr, which holds them, or in .png"))
            }
        }
    }

    /// The files for them beside a picture; none where the picture's file holds them.
    pub fn files(&self, picture: &Path, format: Format, inputs: &[PathBuf]) -> Result<Files, Failure> {
        if format == Format::Exr {
            return Ok(Files(Vec::new()));
        }
        let file = |layer: &Layer| {
            let path = picture.with_extension(format!("{}.png", layer.word()));
            let output = Output::create(Some(&path), inputs)?;
            Ok((*layer, path, output))
        };
        self.0.iter().map(file).collect::<Result<_, Failure>>().map(Files)
    }

    /// The bytes of an OpenEXR file with them.
    pub fn encode(&self, layered: &Layered) -> Result<Encoded, export::EncodeError> {
        let layers = self.0.iter().map(|layer| layered.layer(*layer)).collect();
        export::with_layers(&layered.film(), layers)
    }
}

impl Files {
    /// Writes each layer in false colours.
    pub fn write(self, layered: &Layered, scene: &Scene) -> Result<(), Failure> {
        let names: Vec<String> = scene.objects.iter().map(|object| object.name.clone()).collect();
        for (layer, path, output) in self.0 {
            let bytes = false_colors(layered, layer, &names);
            let bytes =
                bytes.map_err(|error| Failure::machine(format!("{}: cannot encode: {error}", path.display())))?;
            output.commit(&bytes)?;
        }
        Ok(())
    }
}
