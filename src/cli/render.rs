//! `raywalk render`: all pixels, on all cores.

use super::bench::peak_bytes;
use super::failure::Failure;
use super::frames::{self, Frame, FrameRange};
use super::layers::{self, Layers};
use super::options::{ColorChoice, TracingOptions, numbers, region_in, warning_of_sampling};
use super::output::{self, Output};
use super::progress::ProgressOptions;
use super::scene_argument::{self, Loaded};
use clap::{Args, ValueEnum};
use raywalk::record::Arithmetic;
use raywalk::render::digits::{Summary, false_colors, render_digits};
use raywalk::render::export::{self, EncodeError, Encoded, Format};
use raywalk::render::layers::render_layers;
use raywalk::render::statistics::{Seconds, Statistics};
use raywalk::render::{Film, Rendered, Settings, TileOrder, render};
use raywalk::scene::file::visible;
use raywalk::scene::{self, Scene};
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Instant;

/// Render a picture.
#[derive(Args)]
pub struct Render {
    /// A scene file (JSON or NFF, also packed by gzip or zstd), `-` for standard input, or a built-in scene
    scene: PathBuf,
    /// The picture: .png, .ppm, .pfm or .exr by its ending
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Only a part: left, top, right and bottom in pixels, the last two exclusive
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = numbers::<u32, 4>)]
    crop: Option<[u32; 4]>,
    /// Show where few digits can be trusted instead of the colours: the fewest significant digits of a pixel's channels
    /// over several runs in perturbed arithmetic, 0 where the runs decide differently. In .png and .ppm black is all
    /// 15.95 digits and bright yellow none; .pfm and .exr hold the numbers
    #[arg(long)]
    digits: bool,
    /// What each pixel costs and sees, beside its colour: rays, tests, depth, normal, object, samples, error (the standard error
    /// estimated from its samples), time; several with commas between them, or all. In .exr they are channels such as depth.Z;
    /// with .png each has a file of its own, such as out.depth.png, in false colours with a legend
    #[arg(long, value_name = "LAYER,…", conflicts_with_all = ["digits", "stats"])]
    layers: Option<Layers>,
    /// The frames of an animation, the last inclusive; #### in the picture's name becomes the frame's number
    #[arg(long, value_name = "A-B")]
    frames: Option<FrameRange>,
    /// Write PNG with 16 bits a channel
    #[arg(long)]
    png16: bool,
    /// Print counts and times to standard output
    #[arg(long, value_enum, value_name = "FORMAT")]
    stats: Option<StatsFormat>,
    #[command(flatten)]
    progress: ProgressOptions,
    #[command(flatten)]
    tracing: TracingOptions,
}

#[derive(Clone, Copy, ValueEnum)]
enum StatsFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
}

impl Render {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        let format = self.format()?;
        if let Some(layers) = &self.layers {
            layers.check(format)?;
        }
        if self.tracing.arithmetic == Arithmetic::Printed {
            return Err(Failure::caller(
                "render: --arithmetic printed is for the walk of the numeric example's one pixel",
            ));
        }
        // Before anything is read.
        self.digits_seed()?;
        let load = Instant::now();
        let loaded = scene_argument::load(&self.scene, &self.tracing.import(), colors)?;
        let load = load.elapsed().as_secs_f64();
        let mut frames = frames::frames(&loaded.scene, self.frames, &self.output)?;
        let last = frames.pop();
        for frame in frames {
            self.render_frame(loaded.clone(), &frame, format, Seconds { load, ..Seconds::default() })?;
        }
        last.map_or(Ok(()), |last| self.render_frame(loaded, &last, format, Seconds { load, ..Seconds::default() }))
    }

    /// Renders one frame into its file.
    fn render_frame(&self, loaded: Loaded, frame: &Frame, format: Format, mut seconds: Seconds) -> Result<(), Failure> {
        let inputs = loaded.inputs(&self.scene);
        let build = Instant::now();
        let scene = self.tracing.apply(frames::at(loaded, frame.number))?;
        seconds.build = build.elapsed().as_secs_f64();
        if let (true, false, Some(warning)) = (frame.is_first, self.progress.quiet, warning_of_sampling(&scene)) {
            output::tell(&format!("warning: {}: {warning}", visible(&self.scene.to_string_lossy())));
        }
        let settings = Settings {
            crop: self.crop_in(&scene)?,
            arithmetic: self.tracing.arithmetic,
            threads: self.tracing.threads.into(),
            counts_rays: self.stats.is_some(),
            order: TileOrder::Rows,
        };
        let output = Output::create(Some(&frame.path), &inputs)?;
        if let Some(layers) = &self.layers {
            let files = layers.files(&frame.path, format, &inputs)?;
            return self.render_layers(layers, &scene, &settings, (&frame.path, format), (output, files));
        }
        let start = Instant::now();
        let rendered = self.picture(&scene, &settings)?;
        seconds.render = start.elapsed().as_secs_f64();
        let clipped_pixels = self.save(&rendered.film, &scene, (&frame.path, format), output)?;
        match (self.stats, rendered.counts) {
            (Some(stats), Some(counts)) => {
                let share = scene.sampling.largest_share();
                print_statistics(
                    &counts.statistics_of(share, clipped_pixels, seconds, peak_bytes().unwrap_or(0)),
                    stats,
                )
            }
            _ => Ok(()),
        }
    }

    /// The picture of colours or of digits.
    fn picture(&self, scene: &Scene, settings: &Settings) -> Result<Rendered, Failure> {
        let [left, top, right, bottom] = settings.crop;
        let progress = self.progress.start(u64::from(right - left) * u64::from(bottom - top));
        let advance = |pixels| progress.advance(pixels);
        let rendered = match self.digits_seed()? {
            None => render(scene, settings, advance, &AtomicBool::new(false)),
            Some(seed) => render_digits(scene, settings, seed, advance, &AtomicBool::new(false)),
        };
        progress.finish();
        rendered.map_err(|error| Failure::machine(error.to_string()))
    }

    /// Renders a picture with layers into its file, or files.
    fn render_layers(
        &self,
        layers: &Layers,
        scene: &Scene,
        settings: &Settings,
        (path, format): (&Path, Format),
        (output, files): (Output, layers::Files),
    ) -> Result<(), Failure> {
        let [left, top, right, bottom] = settings.crop;
        let progress = self.progress.start(u64::from(right - left) * u64::from(bottom - top));
        let layered = render_layers(scene, settings, |pixels| progress.advance(pixels), &AtomicBool::new(false));
        progress.finish();
        let layered = layered.map_err(|error| Failure::machine(error.to_string()))?;
        let encoded = match format {
            Format::Exr => layers.encode(&layered),
            _ => export::encode(&layered.film(), format, &scene.output),
        };
        self.write(encoded, path, output)?;
        files.write(&layered, scene)
    }

    /// Writes the picture into its file; says how many pixels were clipped.
    fn save(&self, film: &Film, scene: &Scene, place: (&Path, Format), output: Output) -> Result<u64, Failure> {
        let (path, format) = place;
        let encoded =
            if self.digits { encode_digits(film, format) } else { export::encode(film, format, &scene.output) };
        let clipped_pixels = self.write(encoded, path, output)?;
        if self.digits && !self.progress.quiet {
            let Summary { fewest, median, without } = Summary::of(film);
            output::tell(&format!("note: digits: at least {fewest}, median {median}; {without} pixels have none"));
        }
        Ok(clipped_pixels)
    }

    /// Writes what was encoded, and tells about pixels that were clipped.
    fn write(&self, encoded: Result<Encoded, EncodeError>, path: &Path, output: Output) -> Result<u64, Failure> {
        let Encoded { bytes, clipped_pixels } =
            encoded.map_err(|error| Failure::machine(format!("{}: cannot encode: {error}", path.display())))?;
        output.commit(&bytes)?;
        if clipped_pixels > 0 && !self.progress.quiet {
            output::tell(&format!("note: {clipped_pixels} pixels were brighter than white and clipped"));
        }
        Ok(clipped_pixels)
    }

    /// The seed of the first run, if digits are asked for.
    fn digits_seed(&self) -> Result<Option<u64>, Failure> {
        match self.tracing.arithmetic {
            _ if !self.digits => Ok(None),
            Arithmetic::F64 => Ok(Some(0)),
            Arithmetic::Perturbed(seed) => Ok(Some(seed)),
            other => Err(Failure::caller(format!(
                "render: --digits counts the digits of f64: expected --arithmetic perturbed:SEED or none, found {other}"
            ))),
        }
    }

    fn format(&self) -> Result<Format, Failure> {
        let ending = self.output.extension().unwrap_or_default().to_string_lossy();
        Format::of_ending(&ending, self.png16).ok_or_else(|| {
            let path = self.output.display();
            Failure::caller(format!("{path}: unknown picture format, expected a name that ends in {}", Format::ENDINGS))
        })
    }

    fn crop_in(&self, scene: &Scene) -> Result<[u32; 4], Failure> {
        let [width, height] = scene.camera.resolution;
        self.crop.map_or(Ok([0, 0, width, height]), |crop| region_in(scene, "--crop", crop))
    }
}

/// Digits as numbers where the format has numbers, else in false colours, whatever white the scene has.
fn encode_digits(digits: &Film, format: Format) -> Result<Encoded, EncodeError> {
    let plain = scene::Output { white: 1.0, transfer: scene::Transfer::Linear, exposure: 0.0 };
    match format {
        Format::Pfm | Format::Exr => export::encode(digits, format, &plain),
        Format::Png8 | Format::Png16 | Format::Ppm => export::encode(&false_colors(digits), format, &plain),
    }
}

fn print_statistics(statistics: &Statistics, format: StatsFormat) -> Result<(), Failure> {
    let text = match format {
        StatsFormat::Json => serde_json::to_string(statistics)
            .map_err(|error| Failure::machine(format!("cannot write statistics: {error}")))?,
        StatsFormat::Text => statistics.to_string(),
    };
    output::print(format!("{}\n", text.trim_end()).as_bytes())
}
