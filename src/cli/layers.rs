//! `render --layers`: what pixels cost and what they see, in the picture's own file or beside it.

use super::failure::{Failure, shown};
use super::inputs::Inputs;
use super::output::Output;
use raywalk::render::export::{self, Encoded, Format};
use raywalk::render::layers::{Layer, Layered, false_colors};
use std::path::{Path, PathBuf};

/// The layers that are wanted, each once, in the order of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layers(Vec<Layer>);

/// The files of layers that are beside a picture, made sure of before the work begins.
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
                return Err(format!("the layer `{}` occurs twice", word.trim()));
            }
            layers.push(layer);
        }
        Ok(Layers(layers))
    }
}

impl Layers {
    /// Those with these names, as a part has them; `None` if there is one that isn't known or is there twice.
    pub fn named(names: &[String]) -> Option<Layers> {
        if names.is_empty() { Some(Layers(Vec::new())) } else { names.join(",").parse().ok() }
    }

    /// Whether this one is wanted.
    pub fn has(&self, layer: Layer) -> bool {
        self.0.contains(&layer)
    }

    /// Their names.
    pub fn names(&self) -> Vec<String> {
        self.0.iter().map(|layer| layer.word().to_owned()).collect()
    }

    /// Refuses formats that have no place for layers.
    pub fn check(&self, format: Format) -> Result<(), Failure> {
        match format {
            Format::Exr | Format::Png8 | Format::Png16 => Ok(()),
            _ => Err(Failure::caller("layers: expected a picture in .exr, which holds them, or in .png")),
        }
    }

    /// The files for them beside a picture; none where the picture's file holds them.
    pub fn files(&self, picture: &Path, format: Format, inputs: &Inputs) -> Result<Files, Failure> {
        let file = |(layer, path): (&Layer, PathBuf)| {
            let output = Output::create(Some(&path), inputs)?;
            Ok((*layer, path, output))
        };
        self.0.iter().zip(self.paths(picture, format)).map(file).collect::<Result<_, Failure>>().map(Files)
    }

    /// Where they are beside a picture; nowhere if the picture's file holds them.
    pub fn paths(&self, picture: &Path, format: Format) -> Vec<PathBuf> {
        let path = |layer: &Layer| picture.with_extension(format!("{}.png", layer.word()));
        if format == Format::Exr { Vec::new() } else { self.0.iter().map(path).collect() }
    }

    /// The bytes of an OpenEXR file with them.
    pub fn encode(&self, layered: &Layered) -> Result<Encoded, export::EncodeError> {
        let layers = self.0.iter().map(|layer| layered.layer(*layer)).collect();
        export::with_layers(&layered.film(), layers)
    }
}

impl Files {
    /// No layers.
    pub fn none() -> Files {
        Files(Vec::new())
    }

    /// Writes each layer in false colours; a legend names the objects of the scene.
    pub fn write(self, layered: &Layered, objects: &[String]) -> Result<(), Failure> {
        for (layer, path, output) in self.0 {
            let bytes = false_colors(layered, layer, objects);
            let bytes = bytes.map_err(|error| Failure::machine(format!("{}: cannot encode: {error}", shown(&path))))?;
            output.commit(&bytes)?;
        }
        Ok(())
    }
}
