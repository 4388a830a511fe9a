//! `render --layers`: what pixels cost and see, and what is asked for by name, in the picture's own file or beside it.

use super::failure::{Failure, shown};
use super::inputs::Inputs;
use super::output::Output;
use raywalk::files::{escape_hidden, suggest};
use raywalk::log::plane::{Class, Plane, PlaneError};
use raywalk::render::export::{self, EncodeError, Encoded, Format};
use raywalk::render::layers::{Layer, Layered, Planes, classes_of, false_colors, lights_of, of_plane};
use raywalk::scene::{self, Scene};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// The layers that are wanted, each once, in the order of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layers(Vec<Wanted>);

/// A layer, or several that a scene knows.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Wanted {
    /// What a pixel costs or sees.
    Fact(Layer),
    /// What is asked for by name.
    Plane(Plane),
    /// One for each light.
    AllLights,
    /// One for each class of paths.
    AllClasses,
}

/// The word for all lights, and for all classes.
const ALL_LIGHTS: &str = "light:all";
const ALL_CLASSES: &str = "class:all";

/// The files of layers that are beside a picture, made sure of before the work begins.
pub struct Files(Vec<(Wanted, PathBuf, Output)>);

impl FromStr for Layers {
    type Err = String;

    fn from_str(text: &str) -> Result<Layers, String> {
        if text == "all" {
            return Ok(Layers(Layer::ALL.iter().copied().map(Wanted::Fact).collect()));
        }
        let layers = text.split(',').map(|word| word.trim().parse()).collect::<Result<Vec<_>, _>>()?;
        each_once(&layers)?;
        Ok(Layers(layers))
    }
}

impl FromStr for Wanted {
    type Err = String;

    fn from_str(word: &str) -> Result<Wanted, String> {
        if let Some(layer) = Layer::find(word) {
            return Ok(Wanted::Fact(layer));
        }
        match word {
            ALL_LIGHTS => return Ok(Wanted::AllLights),
            ALL_CLASSES => return Ok(Wanted::AllClasses),
            _ => {}
        }
        let unknown = |word: &str| {
            let known = || Layer::ALL.iter().map(|layer| layer.word());
            let meant = suggest(word, known()).map_or(String::new(), |near| format!(", did you mean `{near}`?"));
            let known = known().collect::<Vec<_>>().join(", ");
            format!(
                "unknown layer `{}`{meant}, expected one or several of {known}, value:KEY@PATH, light:NAME and class:PATTERN, with commas between them",
                escape_hidden(word)
            )
        };
        word.parse().map(Wanted::Plane).map_err(|error| match error {
            PlaneError::Kind => unknown(word),
            error => error.to_string(),
        })
    }
}

/// Refuses what is there twice.
fn each_once(layers: &[Wanted]) -> Result<(), String> {
    match layers.iter().enumerate().find(|(at, layer)| layers[..*at].contains(layer)) {
        Some((_, layer)) => Err(format!("the layer `{}` occurs twice", escape_hidden(&layer.name()))),
        None => Ok(()),
    }
}

impl Wanted {
    /// As it is asked for.
    fn name(&self) -> String {
        match self {
            Wanted::Fact(layer) => layer.word().to_owned(),
            Wanted::Plane(plane) => plane.to_string(),
            Wanted::AllLights => ALL_LIGHTS.to_owned(),
            Wanted::AllClasses => ALL_CLASSES.to_owned(),
        }
    }

    /// What it is called in a file's name.
    fn file_name(&self) -> String {
        match self {
            Wanted::Plane(plane) => plane.file_name(),
            _ => self.name(),
        }
    }

    fn plane(&self) -> Option<&Plane> {
        match self {
            Wanted::Plane(plane) => Some(plane),
            _ => None,
        }
    }
}

impl Layers {
    /// Those with these names, as a part has them; `None` if there is one that isn't known or is there twice.
    pub fn named(names: &[String]) -> Option<Layers> {
        let layers: Vec<Wanted> = names.iter().map(|name| name.parse().ok()).collect::<Option<_>>()?;
        each_once(&layers).ok().map(|()| Layers(layers))
    }

    /// The same with what the scene has of lights and classes.
    pub fn in_scene(&self, scene: &Scene) -> Result<Layers, Failure> {
        let all = |wanted: &Wanted| match wanted {
            Wanted::AllLights => lights_of(scene),
            Wanted::AllClasses => {
                classes_of(scene).iter().filter_map(|class| class.parse::<Class>().ok()).map(Plane::Class).collect()
            }
            Wanted::Fact(_) | Wanted::Plane(_) => Vec::new(),
        };
        let layers: Vec<Wanted> = self
            .0
            .iter()
            .flat_map(|wanted| match wanted {
                Wanted::Fact(_) | Wanted::Plane(_) => vec![wanted.clone()],
                Wanted::AllLights | Wanted::AllClasses => all(wanted).into_iter().map(Wanted::Plane).collect(),
            })
            .collect();
        each_once(&layers).map_err(|error| Failure::caller(format!("--layers: {error}")))?;
        Ok(Layers(layers))
    }

    /// Those that a scene has to be asked for.
    pub fn planes(&self, scene: &Scene) -> Result<Planes, Failure> {
        let names: Vec<Plane> = self.0.iter().filter_map(Wanted::plane).cloned().collect();
        Planes::of(scene, &names).map_err(|error| Failure::caller(format!("--layers: {error}")))
    }

    /// Whether this one is wanted.
    pub fn has(&self, layer: Layer) -> bool {
        self.0.contains(&Wanted::Fact(layer))
    }

    /// Their names.
    pub fn names(&self) -> Vec<String> {
        self.0.iter().map(Wanted::name).collect()
    }

    /// The names of those that show nothing: no pixel has the value, no path brings light.
    pub fn empty(&self, layered: &Layered) -> Vec<String> {
        let is_empty = |(wanted, at): &(&Wanted, usize)| {
            wanted.plane().is_some_and(|plane| {
                (*at..*at + plane.numbers()).all(|at| match plane {
                    Plane::Value(_) => layered.numbers_of(at).all(f64::is_nan),
                    Plane::Light(_) | Plane::Class(_) => layered.numbers_of(at).all(|number| number == 0.0),
                })
            })
        };
        self.with_places().filter(is_empty).map(|(wanted, _)| wanted.name()).collect()
    }

    /// Each with the place of its first number among those of a pixel.
    fn with_places(&self) -> impl Iterator<Item = (&Wanted, usize)> {
        let place = |next: &mut usize, wanted| {
            let at = *next;
            *next += Wanted::plane(wanted).map_or(0, Plane::numbers);
            Some((wanted, at))
        };
        self.0.iter().scan(0, place)
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
        let file = |(layer, path): (&Wanted, PathBuf)| {
            let output = Output::create(Some(&path), inputs)?;
            Ok((layer.clone(), path, output))
        };
        self.0.iter().zip(self.paths(picture, format)).map(file).collect::<Result<_, Failure>>().map(Files)
    }

    /// Where they are beside a picture; nowhere if the picture's file holds them.
    pub fn paths(&self, picture: &Path, format: Format) -> Vec<PathBuf> {
        let path = |layer: &Wanted| picture.with_extension(format!("{}.png", layer.file_name()));
        if format == Format::Exr { Vec::new() } else { self.0.iter().map(path).collect() }
    }

    /// The bytes of an OpenEXR file with them.
    pub fn encode(&self, layered: &Layered) -> Result<Encoded, EncodeError> {
        let layer = |(wanted, at): (&Wanted, usize)| match wanted {
            Wanted::Fact(layer) => Some(layered.layer(*layer)),
            Wanted::Plane(plane) => Some(layered.plane(plane, at)),
            Wanted::AllLights | Wanted::AllClasses => None,
        };
        export::with_layers(&layered.film(), self.with_places().filter_map(layer).collect())
    }
}

impl Files {
    /// No layers.
    pub fn none() -> Files {
        Files(Vec::new())
    }

    /// Writes each layer in false colours, with a legend that names the objects of the scene; light in the colours of the picture.
    pub fn write(self, layered: &Layered, objects: &[String], output: &scene::Output) -> Result<(), Failure> {
        let layers = Layers(self.0.iter().map(|(wanted, ..)| wanted.clone()).collect());
        let places: Vec<usize> = layers.with_places().map(|(_, at)| at).collect();
        for ((wanted, path, file), at) in self.0.into_iter().zip(places) {
            let bytes = match &wanted {
                Wanted::Fact(layer) => false_colors(layered, *layer, objects),
                Wanted::Plane(plane) => of_plane(layered, plane, at, output),
                Wanted::AllLights | Wanted::AllClasses => continue,
            };
            let bytes = bytes.map_err(|error| Failure::machine(format!("{}: cannot encode: {error}", shown(&path))))?;
            file.commit(&bytes)?;
        }
        Ok(())
    }
}
