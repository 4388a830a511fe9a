//! `raywalk bench scaling`: how time and memory grow with primitives and pixels.

use super::TableFormat;
use super::machine::{Machine, peak_bytes};
use super::table::{self, or_blank, quartiles};
use crate::cli::failure::Failure;
use crate::cli::options::{self, TracingOptions};
use crate::cli::scene_argument;
use clap::Args;
use raywalk::files::escape_hidden;
use raywalk::render::ask_for_memory;
use raywalk::study::bench::Spread;
use raywalk::study::bench::scaling::{OfSize, OfSpheres, of_size, of_spheres};
use serde::Serialize;
use serde_json::json;
use std::path::PathBuf;

/// Measure how time and memory grow with the number of spheres and the size of a picture
///
/// Random spheres in a cube, each ten times as many as before, are built and traced on one thread; then a scene is rendered, each
/// time in twice the width and height. `growth` is how many times as long a ray, or a pixel, takes as in the row above.
#[derive(Args)]
pub struct ScalingBench {
    /// The scene whose picture grows: a file or a built-in name
    #[arg(value_name = "SCENE", default_value = "figure-6")]
    scene: PathBuf,
    /// The most spheres
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = clap::value_parser!(u32).range(100..=4_000_000))]
    spheres: u32,
    /// The largest picture: pixels across and down
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "1280x960")]
    size: [u32; 2],
    /// How many passes over the rays, and how many pictures of each size, are timed
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=10_000))]
    passes: u16,
    /// The number of threads that render pictures; 0 is one per core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=options::MAX_THREADS))]
    threads: u16,
    /// How to print the tables
    #[arg(long, value_enum, default_value = "text")]
    format: TableFormat,
}

/// A row with what is known of the whole program.
#[derive(Serialize)]
struct Row<T> {
    #[serde(flatten)]
    measured: T,
    /// How many times as long as in the row before.
    #[serde(skip_serializing_if = "Option::is_none")]
    growth: Option<f64>,
    /// The most memory that the program has held so far.
    #[serde(skip_serializing_if = "Option::is_none")]
    peak_bytes: Option<u64>,
}

/// The fewest spheres.
const FEWEST: u32 = 100;

/// How often the largest picture is halved.
const HALVINGS: u32 = 5;

impl ScalingBench {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        raywalk::threads::want(self.threads.into());
        let machine = Machine::this();
        // Before anything is measured.
        let loaded = scene_argument::load(&self.scene, &TracingOptions::default().import())?;
        let in_size = |size: [u32; 2]| {
            let tracing = TracingOptions { size: Some(size), ..TracingOptions::default() };
            tracing.apply(loaded.clone())
        };
        let name = in_size(self.size)?.name;
        let [width, height] = self.size;
        ask_for_memory([0, 0, width, height]).map_err(|error| Failure::machine(error.to_string()))?;
        let passes = usize::from(self.passes);
        let counts = std::iter::successors(Some(FEWEST), |count| count.checked_mul(10));
        let spheres = counts.take_while(|count| *count <= self.spheres);
        let spheres: Vec<_> = spheres.map(|count| Row::of(of_spheres(count, passes))).collect();
        let sizes = (0..=HALVINGS).rev().map(|halvings| self.size.map(|side| side >> halvings));
        let of_size = |size: [u32; 2]| {
            let measured = of_size(&in_size(size)?, self.threads.into(), passes);
            measured.map(Row::of).map_err(|error| Failure::machine(error.to_string()))
        };
        let sizes = sizes.filter(|[width, height]| width * height > 0).map(of_size).collect::<Result<Vec<_>, _>>()?;
        let spheres = grown(spheres, |row| row.ns_per_random_ray.median);
        let sizes = grown(sizes, |row| row.ns_per_pixel.median);
        let text = || text(&machine, &spheres, &name, &sizes);
        let json = || json!({ "machine": machine, "spheres": spheres, "picture": { "scene": name, "sizes": sizes } });
        table::print(self.format, text, || csv(&spheres, &sizes), json)
    }
}

impl<T> Row<T> {
    /// A row as soon as it is measured.
    fn of(measured: T) -> Row<T> {
        Row { measured, growth: None, peak_bytes: peak_bytes() }
    }

    fn peak(&self) -> String {
        self.peak_bytes
            .map_or_else(|| "unknown".to_owned(), |bytes| format!("{:.1}", bytes as f64 / f64::from(1 << 20)))
    }
    fn growth(&self) -> String {
        self.growth.map_or_else(String::new, |growth| format!("{growth:.2}"))
    }
}

/// The rows with how much each is above the one before.
fn grown<T>(mut rows: Vec<Row<T>>, time: impl Fn(&T) -> f64) -> Vec<Row<T>> {
    for at in 1..rows.len() {
        rows[at].growth = Some(time(&rows[at].measured) / time(&rows[at - 1].measured));
    }
    rows
}

fn text(machine: &Machine, spheres: &[Row<OfSpheres>], scene: &str, sizes: &[Row<OfSize>]) -> String {
    let shown =
        |Spread { median, lower, upper, .. }: Spread| [format!("{median:.0}"), format!("({lower:.0} {upper:.0})")];
    let of_spheres = |row: &Row<OfSpheres>| {
        let OfSpheres { spheres, build_s, ns_per_camera_ray, ns_per_random_ray, .. } = row.measured;
        let built = [spheres.to_string(), format!("{build_s:.4}")];
        [&built[..], &shown(ns_per_camera_ray), &shown(ns_per_random_ray), &[row.growth(), row.peak()]].concat()
    };
    let of_size = |row: &Row<OfSize>| {
        let OfSize { width, height, ns_per_pixel } = row.measured;
        [&[format!("{width}x{height}")][..], &shown(ns_per_pixel), &[row.growth(), row.peak()]].concat()
    };
    let heads = ["build s", "ns/camera ray", "(quartiles)", "ns/random ray", "(quartiles)", "growth", "peak MiB"];
    let spheres = table::text(&[&["spheres"], &heads[..]].concat(), spheres.iter().map(of_spheres));
    let heads = ["size", "ns/pixel", "(quartiles)", "growth", "peak MiB"];
    let sizes = table::text(&heads, sizes.iter().map(of_size));
    let scene = escape_hidden(scene);
    let peak = match peak_bytes() {
        Some(_) => "the most memory of the program until then",
        None => "this system doesn't report how much memory a program held",
    };
    format!(
        "{machine}\nrandom spheres in a cube, one thread, processor time\n{spheres}\
        pictures of {scene}, by the clock\n{sizes}peak: {peak}\n"
    )
}

fn csv(spheres: &[Row<OfSpheres>], sizes: &[Row<OfSize>]) -> String {
    let heads = "of,number,build_s,ns,ns_lower_quartile,ns_upper_quartile,growth,peak_bytes";
    let row = |of: &str, number: u64, build: Option<f64>, ns: Spread, growth: Option<f64>, peak: Option<u64>| {
        let about = [of.to_owned(), number.to_string(), or_blank(build)];
        [&about[..], &quartiles(&ns), &[or_blank(growth), or_blank(peak)]].concat()
    };
    let spheres = spheres.iter().flat_map(|Row { measured, growth, peak_bytes }| {
        let OfSpheres { spheres, build_s, ns_per_camera_ray, ns_per_random_ray, .. } = *measured;
        let of_rays = |of, ns, growth| row(of, spheres.into(), Some(build_s), ns, growth, *peak_bytes);
        [of_rays("camera_rays", ns_per_camera_ray, None), of_rays("random_rays", ns_per_random_ray, *growth)]
    });
    let sizes = sizes.iter().map(|Row { measured: OfSize { width, height, ns_per_pixel }, growth, peak_bytes }| {
        row("pixels", u64::from(*width) * u64::from(*height), None, *ns_per_pixel, *growth, *peak_bytes)
    });
    table::csv(heads, spheres.chain(sizes))
}
