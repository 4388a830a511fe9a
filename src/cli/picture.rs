//! A picture and the files that it goes into: one that was rendered, or put together from parts.

use super::failure::{Failure, shown};
use super::inputs::Inputs;
use super::layers::{Files, Layers};
use super::output::{self, Output};
use raywalk::files::escape_hidden;
use raywalk::render::digits::{Summary, false_colors};
use raywalk::render::export::{self, Clipped, EncodeError, Encoded, Format};
use raywalk::render::layers::Layer;
use raywalk::render::{Canvas, Film};
use raywalk::scene;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// How it is shown.
pub struct Shown<'s> {
    /// How values become numbers.
    pub output: scene::Output,
    /// The names of the scene's objects, for the legend of a layer.
    pub objects: &'s [String],
    /// Whether nothing is said about it.
    pub is_quiet: bool,
}

/// What was written.
pub struct Written {
    /// How many pixels were brighter than white.
    pub clipped_pixels: u64,
}

/// Where a picture goes, made sure of before the work begins.
pub struct Place {
    path: PathBuf,
    format: Format,
    output: Output,
    layers: Option<Layers>,
    /// What is beside it.
    files: Files,
}

/// The digest of a picture's files in this format, those of layers beside it among them.
pub fn digest(path: &Path, format: Format, layers: Option<&Layers>) -> io::Result<blake3::Hash> {
    let mut hasher = blake3::Hasher::new();
    hasher.update(format!("{format:?}").as_bytes());
    for path in [path.to_owned()].into_iter().chain(layers.map_or_else(Vec::new, |layers| layers.paths(path, format))) {
        let bytes = raywalk_guard::attempt(|| fs::read(path))?;
        hasher.update(&bytes.len().to_le_bytes()).update(&bytes);
    }
    Ok(hasher.finalize())
}

/// The format that a name asks for.
pub fn format_of(path: &Path, png16: bool) -> Result<Format, Failure> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    let format = Format::of_ending(&ending, png16).ok_or_else(|| {
        let path = shown(path);
        Failure::caller(format!("{path}: unknown picture format, expected a name that ends in {}", Format::endings()))
    })?;
    if png16 && format != Format::Png16 {
        let path = shown(path);
        return Err(Failure::caller(format!("--png16: only PNG has 16 bits a channel, expected .png, found {path}")));
    }
    Ok(format)
}

impl Place {
    /// Begins the files of a picture of this size, none of which may be one of the inputs.
    pub fn create(
        path: &Path,
        format: Format,
        size: [u32; 2],
        layers: Option<&Layers>,
        inputs: &Inputs,
    ) -> Result<Place, Failure> {
        if let Some(longest) = format.longest_side().filter(|longest| size.iter().any(|side| side > longest)) {
            let ([width, height], path) = (size, shown(path));
            return Err(Failure::caller(format!(
                "{path}: the format has at most {longest} pixels along a side, found {width} x {height}"
            )));
        }
        let output = Output::create(Some(path), inputs)?;
        let files = layers.map_or_else(|| Ok(Files::none()), |layers| layers.files(path, format, inputs))?;
        Ok(Place { path: path.to_owned(), format, output, layers: layers.cloned(), files })
    }

    /// Whether the picture is a file that nobody sees before it is whole.
    pub fn is_file(&self) -> bool {
        self.output.is_file()
    }

    /// Writes a picture, and says what there is to say about it.
    pub fn write(self, rendered: &Canvas, how: &Shown) -> Result<Written, Failure> {
        let encoded = match (rendered, &self.layers) {
            (Canvas::Colors(film), _) => export::encode(film, self.format, &how.output),
            (Canvas::Digits(film), _) => encode_digits(film, self.format),
            (Canvas::Layers(film), Some(layers)) if self.format == Format::Exr => layers.encode(film),
            (Canvas::Layers(film), _) => export::encode(&film.film(), self.format, &how.output),
        };
        let cannot_encode = |error| Failure::machine(format!("{}: cannot encode: {error}", shown(&self.path)));
        let Encoded { bytes, clipped } = encoded.map_err(cannot_encode)?;
        // The layers first: where the picture is, they are.
        if let Canvas::Layers(film) = rendered {
            self.files.write(film, how.objects, &how.output)?;
        }
        self.output.commit(&bytes)?;
        if let (Some(text), false) = (of_clipped(&clipped, rendered.count()), how.is_quiet) {
            output::tell(&text);
        }
        if let (Canvas::Digits(film), false) = (rendered, how.is_quiet) {
            let Summary { fewest, median, without } = Summary::of(film);
            output::tell(&format!("note: digits: at least {fewest}, median {median}; {without} pixels have none"));
        }
        if let (Canvas::Layers(film), Some(layers), false) = (rendered, &self.layers, how.is_quiet)
            && layers.has(Layer::Error)
            && film.pixels().iter().all(|seen| seen.error.is_none())
        {
            output::tell("note: layer error: a single sample has no error, and no pixel has more");
        }
        if let (Canvas::Layers(film), Some(layers), false) = (rendered, &self.layers, how.is_quiet) {
            for name in layers.empty(film) {
                output::tell(&format!("note: layer {}: no pixel has it", escape_hidden(&name)));
            }
        }
        Ok(Written { clipped_pixels: clipped.pixels })
    }
}

/// What is said of clipped pixels, out of this many: a warning where they are more than a tenth of the picture.
fn of_clipped(clipped: &Clipped, all: u64) -> Option<String> {
    let Clipped { pixels, fitting_exposure } = *clipped;
    // Rounded down, so that only a picture of which nothing is left has 100 %.
    let percent = pixels * 100 / all.max(1);
    let advice = fitting_exposure.map(|stops| format!("; --exposure {stops:.1} shows all"));
    let advice = advice.unwrap_or_default();
    match pixels {
        0 => None,
        _ if pixels * 10 > all => Some(format!(
            "warning: {percent} % of the pixels ({pixels} of {all}) were brighter than white and clipped{advice}"
        )),
        _ => Some(format!("note: {pixels} pixels were brighter than white and clipped{advice}")),
    }
}

/// Digits as numbers where the format has numbers, else in false colours, whatever white the scene has.
fn encode_digits(digits: &Film, format: Format) -> Result<Encoded, EncodeError> {
    let plain = scene::Output::default();
    match format.highest() {
        None => export::encode(digits, format, &plain),
        Some(_) => export::encode(&false_colors(digits), format, &plain),
    }
}
