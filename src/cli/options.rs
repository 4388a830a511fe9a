//! The options that every tracing command has. They override what the scene says.

pub use super::color::ColorChoice;

use super::failure::Failure;
use super::sampling_spec::{sampling, sampling_help};
use super::scene_argument::Loaded;
use super::shown::ShownOptions;
use clap::{Args, ValueEnum};
use raywalk::files::unknown;
use raywalk::geometry::shape::SphereMethod;
use raywalk::log::{FrameId, SkipReason};
use raywalk::record::Arithmetic;
use raywalk::report::language::Language;
use raywalk::scene::builtin;
use raywalk::scene::file;
use raywalk::scene::file::nff::{Angle, Import};
use raywalk::scene::file::schema::SceneFile;
use raywalk::scene::file::validate::limits::{MAX_DEPTH, MAX_PIXELS, MAX_SIDE};
use raywalk::scene::{Algorithm, Around, Formulas, Sampling, Scene, Skip, Specular, build_with};

/// The most threads.
pub const MAX_THREADS: i64 = 4096;

/// How rays are traced.
#[derive(Args, Debug, Default, Clone, PartialEq)]
#[command(next_help_heading = "Tracing")]
pub struct TracingOptions {
    /// Pixels across and down; the vertical field of view stays
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// The arithmetic: f64, f32, decimal:N (by hand with N decimals), perturbed:SEED (f64 with every quantity moved by
    /// an ulp at random, which shows how many digits can be trusted), printed (the book's own values)
    #[arg(long, value_name = "NAME", default_value = "f64")]
    pub arithmetic: Arithmetic,
    /// By hand (decimal:N), round the products of every dot product too before they are added
    #[arg(long)]
    pub round_products: bool,
    /// Which formulas; by default those of the scene, otherwise notes by hand (decimal:N, printed) and robust in any other arithmetic
    #[arg(long, value_enum, value_name = "NAME")]
    pub formulas: Option<Formulas>,
    /// The specular term
    #[arg(long, value_enum, value_name = "NAME")]
    pub specular: Option<Specular>,
    /// How to intersect spheres; by default as the scene says, otherwise as the formulas do
    #[arg(long, value_enum, value_name = "NAME")]
    pub sphere_method: Option<SphereMethod>,
    /// The algorithm, by its pseudocode
    #[arg(long, value_enum, value_name = "NAME")]
    pub algorithm: Option<Algorithm>,
    /// The depth limit of the ray tree
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=i64::from(MAX_DEPTH)))]
    pub max_depth: Option<u32>,
    #[arg(long, value_name = "SPEC", value_parser = sampling, help = sampling_help())]
    pub sampling: Option<Sampling>,
    /// The seed of the samples' random numbers; another seed gives other noise
    #[arg(long, value_name = "N", value_parser = seed, allow_hyphen_values = true)]
    pub seed: Option<u64>,
    /// Where a pixel's rays go: through its centre, or through its corners, which it shares with its neighbours
    #[arg(long, value_enum, value_name = "PLACE", default_value = "centers")]
    pub pixel_grid: PixelGrid,
    #[command(flatten)]
    pub nff: NffOptions,
    /// What to skip because it can't change the picture: all, none, or rules separated by commas
    #[arg(long, value_name = "RULES", value_parser = skip)]
    pub skip: Option<Skip>,
    /// Show one-sided faces from behind too
    #[arg(long)]
    pub two_sided: bool,
    /// Which intersection tests a log shows
    #[arg(long, value_enum, default_value = "visited")]
    pub tests: TestsChoice,
    /// The number of threads; 0 is one per core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=MAX_THREADS))]
    pub threads: u16,
    #[command(flatten)]
    pub shown: ShownOptions,
}

/// How a report is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ReportFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
}

/// Where the rays of a pixel go that has no other sampling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum PixelGrid {
    /// Through its centre.
    #[default]
    Centers,
    /// Through its corners: `shared:1`.
    Corners,
}

/// How NFF files are read.
#[derive(Args, Debug, Default, Clone, Copy, PartialEq)]
pub struct NffOptions {
    /// What the angle of an NFF view spans: the centres of the first and last row of pixels, or the picture's edges
    #[arg(long, value_enum, value_name = "PLACE", default_value = "centers")]
    pub nff_angle: Angle,
}

impl NffOptions {
    /// How files of another format are read.
    pub fn import(self) -> Import {
        Import { angle: self.nff_angle, resolution: None }
    }
}

/// Which intersection tests a log shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum TestsChoice {
    /// Those that the tracer ran.
    #[default]
    Visited,
    /// Every object's.
    All,
}

impl TracingOptions {
    /// From here on work is shared among as many threads as were asked for.
    pub fn use_threads(&self) {
        raywalk::threads::want(self.threads.into());
    }

    /// How files of another format are read: an NFF view keeps its angle in another size.
    pub fn import(&self) -> Import {
        Import { resolution: self.size, ..self.nff.import() }
    }

    /// The arithmetic, with the products of dot products rounded where that is asked for.
    pub fn arithmetic(&self) -> Arithmetic {
        let rounded = self.round_products.then(|| self.arithmetic.with_rounded_products());
        rounded.flatten().unwrap_or(self.arithmetic)
    }

    /// The scene with what these options say instead of it.
    pub fn settled(&self, mut loaded: Loaded) -> Result<Loaded, Failure> {
        let file = &mut loaded.scene;
        if let Some(size) = self.size {
            file.camera.resolution = size;
        }
        if let Some(algorithm) = self.algorithm {
            file.tracing.algorithm = algorithm;
        }
        if let Some(max_depth) = self.max_depth {
            file.tracing.max_depth = max_depth;
        }
        if let Some(sampling) = self.sampling {
            file.sampling = sampling;
        }
        if let Some(seed) = self.seed {
            file.seed = seed;
        }
        if self.pixel_grid == PixelGrid::Corners {
            file.sampling = through_corners(file.sampling)?;
        }
        file.tracing.two_sided |= self.two_sided;
        if let Some(specular) = self.specular {
            file.tracing.specular = specular;
        }
        file.tracing.sphere_method = self.sphere_method.or(file.tracing.sphere_method);
        if self.round_products && !self.arithmetic().rounds_products() {
            let found = self.arithmetic;
            let message = format!("--round-products: only by hand, with --arithmetic decimal:N, found `{found}`");
            return Err(Failure::caller(message));
        }
        file.output = self.shown.over(file.output);
        if self.arithmetic == Arithmetic::Printed && !is_the_numeric_example(file) {
            return Err(Failure::caller("--arithmetic printed: only for the built-in scene `textbook` as it is"));
        }
        file.tracing.formulas = self.formulas.or(file.tracing.formulas);
        Ok(loaded)
    }

    /// The scene with these options, ready to be traced.
    pub fn apply(&self, loaded: Loaded) -> Result<Scene, Failure> {
        let Loaded { scene: file, meshes, frame: number, .. } = self.settled(loaded)?;
        let frame = file.frames.filter(|frames| frames.count > 1);
        let frame = frame.map(|frames| FrameId { number, time: frames.time_of(number) });
        let around = Around {
            formulas: self.arithmetic.implied_formulas(),
            skip: self.skip.unwrap_or(Skip::ALL),
            shows_all_tests: self.tests == TestsChoice::All,
            frame,
        };
        build_with(file, &meshes, around).map_err(|unsupported| Failure::caller(unsupported.to_string()))
    }
}

/// What to warn of before a scene is sampled.
pub fn warning_of_sampling(scene: &Scene) -> Option<String> {
    biased_effects(scene).map(|effects| (Language::English.texts().viewer.messages.warnings.biased)(&effects))
}

/// The effects with which the scene's sampling is biased, if it is.
pub fn biased_effects(scene: &Scene) -> Option<String> {
    let effects = scene.effects.names();
    let is_biased = matches!(scene.sampling, Sampling::Adaptive { .. }) && !effects.is_empty();
    is_biased.then(|| effects.join(", "))
}

/// `none` becomes `shared:1`; other samplings have their own places.
fn through_corners(sampling: Sampling) -> Result<Sampling, Failure> {
    match sampling {
        Sampling::Center {} => Ok(Sampling::Shared { n: 1 }),
        _ => {
            let found = sampling.key();
            Err(Failure::caller(format!("--pixel-grid corners: only with the sampling `none`, found `{found}`")))
        }
    }
}

/// Whether the scene is the numeric example, the only one for which a book prints numbers.
fn is_the_numeric_example(file: &SceneFile) -> bool {
    let text = builtin::text("textbook").unwrap_or_default();
    file::parse(text.as_bytes(), "textbook.json").is_ok_and(|example| example == *file)
}

/// Numbers separated by commas, exactly `N` of them.
pub fn numbers<T: std::str::FromStr + Copy + Default, const N: usize>(text: &str) -> Result<[T; N], String> {
    let parts: Vec<_> = text.split(',').collect();
    let expected = || format!("expected {N} numbers separated by commas");
    if parts.len() != N {
        return Err(format!("{}, found {}", expected(), parts.len()));
    }
    let mut numbers = [T::default(); N];
    for (number, part) in numbers.iter_mut().zip(parts) {
        *number = part.trim().parse().map_err(|_| match part.trim().parse::<f64>() {
            Ok(_) => format!("expected {N} whole numbers from 0 on, found `{part}`"),
            Err(_) => format!("{}, found `{part}`", expected()),
        })?;
    }
    Ok(numbers)
}

/// A rectangle of pixels, left, top, right and bottom, if it lies in the picture; `option` is who asks.
pub fn region_in(scene: &Scene, option: &str, region: [u32; 4]) -> Result<[u32; 4], Failure> {
    let [width, height] = scene.camera.resolution;
    let [left, top, right, bottom] = region;
    if left < right && right <= width && top < bottom && bottom <= height {
        return Ok(region);
    }
    let found = region.map(|side| side.to_string()).join(",");
    Err(Failure::caller(format!(
        "{option} {found}: expected X0 < X1 <= {width} and Y0 < Y1 <= {height}, the picture has {width} x {height} pixels"
    )))
}

/// A pixel `X,Y` that lies in the picture.
pub fn pixel_in(scene: &Scene, pixel: [u32; 2]) -> Result<[u32; 2], Failure> {
    let [x, y] = pixel;
    let [width, height] = scene.camera.resolution;
    if x < width && y < height {
        Ok(pixel)
    } else {
        Err(Failure::caller(format!("--pixel {x},{y}: outside the picture of {width} x {height} pixels")))
    }
}

pub fn size(text: &str) -> Result<[u32; 2], String> {
    let expected = || format!("expected WIDTHxHEIGHT in pixels, each from 1 to {MAX_SIDE}");
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(expected)?;
    let side = |side: &str| side.parse().ok().filter(|side| (1..=MAX_SIDE).contains(side)).ok_or_else(expected);
    let [width, height]: [u32; 2] = [side(width)?, side(height)?];
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(format!("at most {MAX_PIXELS} pixels in all"));
    }
    Ok([width, height])
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("expected a whole number from 0 to {}, found `{text}`", u64::MAX))
}

fn skip(text: &str) -> Result<Skip, String> {
    match text {
        "all" => return Ok(Skip::ALL),
        "none" => return Ok(Skip::NONE),
        _ => {}
    }
    text.split(',').try_fold(Skip::NONE, |skip, word| {
        let rule = SkipReason::find(word).ok_or_else(|| {
            let words: Vec<_> = ["all", "none"].into_iter().chain(SkipReason::ALL.iter().map(|r| r.word())).collect();
            unknown("rule", word, &words)
        })?;
        Ok(skip.with(rule))
    })
}
