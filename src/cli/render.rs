//! `raywalk render`: all pixels, on all cores.

mod checkpoint;
mod parts;

pub use parts::MAX_PART_BYTES;

use self::checkpoint::Spent;
use super::bench::peak_bytes;
use super::failure::Failure;
use super::frames::{self, Frame, FrameRange};
use super::inputs::Inputs;
use super::layers::Layers;
use super::options::{ReportFormat, TracingOptions, numbers, region_in, warning_of_sampling};
use super::output;
use super::picture::{Place, Shown, format_of};
use super::progress::ProgressOptions;
use super::scene_argument::{self, Loaded};
use clap::Args;
use raywalk::files::escape_hidden;
use raywalk::log::Shard;
use raywalk::record::Arithmetic;
use raywalk::render::export::Format;
use raywalk::render::layers::Planes;
use raywalk::render::statistics::{Seconds, Statistics};
use raywalk::render::{Canvas, Counter, Job, RenderError, Rendered, Settings, TileOrder, render_job};
use raywalk::scene::Scene;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

/// Render a picture.
#[derive(Args)]
pub struct Render {
    /// A scene file (JSON or NFF, also compressed with gzip or zstd), `-` for standard input, or a built-in scene
    scene: PathBuf,
    /// The picture: .png, .ppm, .bmp, .tga, .qoi, .tiff, .jpg, .webp, .pfm or .exr by its ending; with --shard a part for
    /// `raywalk merge`, whatever its ending
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Only a part: left, top, right and bottom in pixels, the last two exclusive
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = numbers::<u32, 4>, allow_hyphen_values = true)]
    crop: Option<[u32; 4]>,
    /// Show where few digits can be trusted instead of the colours: the fewest significant digits of a pixel's channels
    /// over several runs in perturbed arithmetic, 0 where the runs decide differently. In formats of integers, such as .png,
    /// black is all 15.95 digits and bright yellow none; .pfm and .exr hold the numbers
    #[arg(long)]
    digits: bool,
    /// Also write what each pixel costs and sees: rays, tests, depth, normal, object, samples, error (the standard error
    /// estimated from its samples), time; several with commas between them, or all. Also by name: value:KEY@PATH, a quantity of
    /// the log at a path such as `value:shade.n_dot_l@C R`; light:NAME, what a light brings (light:ambient, light:background;
    /// light:all for each); class:PATTERN, what the paths of a class bring, such as class:LDSE or class:L(D|S)S*E (class:all for
    /// each). In .exr they are channels such as depth.Z; with .png each has a file of its own, such as out.depth.png, in false
    /// colours with a legend
    #[arg(long, value_name = "LAYER,…", conflicts_with_all = ["digits", "stats"])]
    layers: Option<Layers>,
    /// The frames of an animation, the last inclusive; #### in the picture's name becomes the frame's number
    #[arg(long, value_name = "A-B")]
    frames: Option<FrameRange>,
    /// Render only the I-th of N shards into a part; `raywalk merge` joins the parts. A part that
    /// is already complete isn't rendered again
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// Keep the rendered part in FILE.checkpoint until the picture is complete, and continue from it if the same call was interrupted
    #[arg(long, conflicts_with = "stats")]
    resume: bool,
    /// Write PNG with 16 bits a channel; for shards `raywalk merge` takes it
    #[arg(long)]
    png16: bool,
    /// Print counts and times to standard output
    #[arg(long, value_enum, value_name = "FORMAT")]
    stats: Option<ReportFormat>,
    #[command(flatten)]
    progress: ProgressOptions,
    #[command(flatten)]
    tracing: TracingOptions,
}

/// What is rendered: a scene with all options, and the files that no result may overwrite.
struct Task {
    scene: Scene,
    settings: Settings,
    inputs: Inputs,
    /// Where it goes.
    path: PathBuf,
    /// The layers beside it, as the scene has them.
    layers: Option<Layers>,
    /// Those of them that are asked for by name.
    planes: Planes,
}

impl Render {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        self.check()?;
        self.tracing.use_threads();
        let load = Instant::now();
        let loaded = scene_argument::load(&self.scene, &self.tracing.import())?;
        let load = load.elapsed().as_secs_f64();
        let mut frames = frames::frames(&loaded.scene, self.frames, &self.output)?;
        let last = frames.pop();
        // Those of finished frames stay until all are: a picture alone doesn't say of what it is.
        let mut finished = Vec::new();
        for frame in frames {
            let seconds = Seconds { load, ..Seconds::default() };
            finished.extend(self.render_frame(loaded.clone(), &frame, seconds)?.map(Spent::let_go));
        }
        if let Some(last) = last {
            let seconds = Seconds { load, ..Seconds::default() };
            finished.extend(self.render_frame(loaded, &last, seconds)?);
        }
        finished.into_iter().try_for_each(Spent::remove)
    }

    /// Refuses what can't be done before anything is read.
    fn check(&self) -> Result<(), Failure> {
        if self.shard.is_some() && self.png16 {
            return Err(Failure::caller(
                "--png16: a part holds the traced values themselves; expected --png16 at `raywalk merge`, which writes the picture",
            ));
        }
        let format = self.format()?;
        if let (Some(layers), Some(format)) = (&self.layers, format) {
            layers.check(format)?;
        }
        if self.tracing.arithmetic() == Arithmetic::Printed {
            return Err(Failure::caller(
                "render: --arithmetic printed is for the walk of the numeric example's one pixel",
            ));
        }
        self.digits_seed().map(|_| ())
    }

    /// Renders one frame into its file; gives a finished picture's checkpoint.
    fn render_frame(&self, loaded: Loaded, frame: &Frame, mut seconds: Seconds) -> Result<Option<Spent>, Failure> {
        let inputs = loaded.inputs.clone();
        let build = Instant::now();
        let scene = self.tracing.apply(frames::at(loaded, frame.number))?;
        seconds.build = build.elapsed().as_secs_f64();
        if let (true, false, Some(warning)) = (frame.is_first, self.progress.quiet, warning_of_sampling(&scene)) {
            output::tell(&format!("warning: {}: {warning}", escape_hidden(&self.scene.to_string_lossy())));
        }
        let settings = Settings {
            crop: self.crop_in(&scene)?,
            arithmetic: self.tracing.arithmetic(),
            threads: self.tracing.threads.into(),
            counts_rays: self.stats.is_some(),
            order: TileOrder::Rows,
        };
        let layers = self.layers.as_ref().map(|layers| layers.in_scene(&scene)).transpose()?;
        let planes = layers.as_ref().map_or_else(|| Ok(Planes::default()), |layers| layers.planes(&scene))?;
        let task = Task { scene, settings, inputs, path: frame.path.clone(), layers, planes };
        match self.format()? {
            Some(format) if !self.resume => self.whole_picture(&task, format, seconds).map(|()| None),
            Some(format) => self.resumed_picture(&task, format).map(Some),
            None => self.part(&task, seconds).map(|()| None),
        }
    }

    /// Renders a picture in one go.
    fn whole_picture(&self, task: &Task, format: Format, mut seconds: Seconds) -> Result<(), Failure> {
        let place = self.place(task, format)?;
        let start = Instant::now();
        let Rendered { film, counts } = self.rendered(task)?;
        seconds.render = start.elapsed().as_secs_f64();
        let written = place.write(&film, &self.shown(task, &names_of(&task.scene)))?;
        // Of an earlier run that was killed when the picture was there.
        checkpoint::remove_left_of(&task.path, &task.inputs, || self.header(task, Shard::WHOLE))?;
        self.print_statistics(task, counts, seconds, written.clipped_pixels)
    }

    /// The picture of colours, of digits, or with layers.
    fn rendered(&self, task: &Task) -> Result<Rendered<Canvas>, Failure> {
        let Task { scene, settings, .. } = task;
        let [left, top, right, bottom] = settings.crop;
        let progress = self.progress.start(u64::from(right - left) * u64::from(bottom - top));
        let (advance, never) = (|pixels| progress.advance(pixels), AtomicBool::new(false));
        let rendered = render_job(self.job(task)?, scene, settings, advance, &never);
        progress.finish();
        rendered.map_err(|error| failed(&error))
    }

    fn job(&self, task: &Task) -> Result<Job, Failure> {
        Ok(match (&task.layers, self.digits_seed()?) {
            (Some(_), _) => Job::Layers(task.planes.clone()),
            (None, Some(seed)) => Job::Digits { seed },
            (None, None) => Job::Colors,
        })
    }

    fn place(&self, task: &Task, format: Format) -> Result<Place, Failure> {
        let [left, top, right, bottom] = task.settings.crop;
        Place::create(&task.path, format, [right - left, bottom - top], task.layers.as_ref(), &task.inputs)
    }

    fn shown<'s>(&self, task: &Task, objects: &'s [String]) -> Shown<'s> {
        Shown { output: task.scene.output, objects, is_quiet: self.progress.quiet }
    }

    /// Prints the counts, if they are asked for.
    fn print_statistics(
        &self,
        task: &Task,
        counts: Option<Counter>,
        seconds: Seconds,
        clipped_pixels: u64,
    ) -> Result<(), Failure> {
        let (Some(format), Some(counts)) = (self.stats, counts) else { return Ok(()) };
        let share = task.scene.sampling.largest_share();
        let statistics = counts.statistics_of(share, clipped_pixels, seconds, peak_bytes().unwrap_or(0));
        print_statistics(&statistics, format)
    }

    /// The seed of the first run, if digits are asked for.
    fn digits_seed(&self) -> Result<Option<u64>, Failure> {
        match self.tracing.arithmetic() {
            _ if !self.digits => Ok(None),
            Arithmetic::F64 => Ok(Some(0)),
            Arithmetic::Perturbed(seed) => Ok(Some(seed)),
            other => Err(Failure::caller(format!(
                "render: --digits counts the digits of f64: expected --arithmetic perturbed:SEED or none, found {other}"
            ))),
        }
    }

    /// The format of the picture; `None` for a part, which has its own.
    fn format(&self) -> Result<Option<Format>, Failure> {
        self.shard.is_none().then(|| format_of(&self.output, self.png16)).transpose()
    }

    fn crop_in(&self, scene: &Scene) -> Result<[u32; 4], Failure> {
        let [width, height] = scene.camera.resolution;
        self.crop.map_or(Ok([0, 0, width, height]), |crop| region_in(scene, "--crop", crop))
    }
}

fn names_of(scene: &Scene) -> Vec<String> {
    scene.objects.iter().map(|object| object.name.to_string()).collect()
}

fn failed(error: &RenderError) -> Failure {
    Failure::machine(error.to_string())
}

fn print_statistics(statistics: &Statistics, format: ReportFormat) -> Result<(), Failure> {
    let text = match format {
        ReportFormat::Json => serde_json::to_string(statistics)
            .map_err(|error| Failure::machine(format!("cannot write statistics: {error}")))?,
        ReportFormat::Text => statistics.to_string(),
    };
    output::print(format!("{}\n", text.trim_end()).as_bytes())
}
