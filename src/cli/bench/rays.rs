//! `raywalk bench rays`: how many rays per second are answered.

use super::TableFormat;
use super::machine::Machine;
use super::table;
use crate::cli::failure::{Failure, shown};
use crate::cli::inputs::{Claim, Inputs, place_of};
use crate::cli::options::MAX_THREADS;
use crate::cli::output::{self, Output};
use clap::Args;
use raywalk::files::{FileError, escape_hidden, escape_hidden_json, is_callers_fault};
use raywalk::scene::Scene;
use raywalk::scene::file::raw::{self, Primitives, RayFile};
use raywalk::study::bench::throughput::{self, Hits, Mode, Passes, Throughput, measure};
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};

/// Measure rays per second on files of rays
///
/// A scene is STEM.mesh (one mesh) or STEM.spheres; its rays are STEM.KIND.rays, such as STEM.primary.rays. docs/benchmarks.md has the
/// layouts. After a warm-up pass, whole passes over a file are timed; threads take rays from a queue. JSON has one object per line:
/// first the time to prepare the scene, then the rays.
#[derive(Args)]
pub struct RaysBench {
    /// Scenes, each without the ending of its files
    #[arg(value_name = "STEM", required = true)]
    stems: Vec<PathBuf>,
    /// The numbers of threads, one after the other
    #[arg(long, value_name = "N,…", value_delimiter = ',', default_value = "1,2")]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=MAX_THREADS))]
    threads: Vec<u16>,
    /// About how long each figure takes, in 3 to 15 passes
    #[arg(long, value_name = "S", default_value_t = 0.5, value_parser = seconds, allow_negative_numbers = true)]
    seconds: f64,
    /// How many passes, however long they take
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    passes: Option<u32>,
    /// Write what each ray hit to files in this folder: the distance as f32, the primitive as u32
    #[arg(long, value_name = "DIR")]
    dump: Option<PathBuf>,
    /// How to print the figures
    #[arg(long, value_enum, default_value = "text")]
    format: TableFormat,
}

/// How long it took to make a scene ready.
#[derive(Serialize)]
struct Built<'a> {
    engine: &'static str,
    scene: &'a str,
    build_s: f64,
    build_cpu_s: f64,
    build_threads: u16,
    primitives: usize,
    #[serde(flatten)]
    machine: &'a Machine,
}

/// The figures of a file of rays, under the names that benchmarks of other programs give them.
#[derive(Serialize, Clone, Copy)]
struct Row<'a> {
    engine: &'static str,
    mode: &'static str,
    scene: &'a str,
    rays: &'a str,
    threads: usize,
    n: usize,
    mrays_median: f64,
    mrays_lower_quartile: f64,
    mrays_upper_quartile: f64,
    mrays_best: f64,
    mrays_per_cpu_s: f64,
    passes: usize,
    hits: usize,
    tsum: f64,
}

/// The files of a scene.
struct Files {
    name: String,
    primitives: Primitives,
    rays: Vec<(String, RayFile)>,
}

impl Files {
    /// All of them, so that nothing is measured before all are known to be good.
    fn read(stem: &Path) -> Result<Files, FileError> {
        let primitives = raw::read_primitives(stem)?;
        let read = |(kind, path): (String, PathBuf)| Ok((kind, raw::read_rays(&path)?));
        let rays = raw::find_rays(stem)?.into_iter().map(read).collect::<Result<_, FileError>>()?;
        Ok(Files { name: Files::name(stem), primitives, rays })
    }

    /// The name of a scene.
    fn name(stem: &Path) -> String {
        stem.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}

const ENGINE: &str = "raywalk";

/// For each scene the files of what its rays hit; none is a file of any of the scenes.
struct Dumps {
    paths: Vec<Vec<PathBuf>>,
    inputs: Inputs,
}

impl Dumps {
    fn check(&self) -> Result<(), Failure> {
        self.paths.iter().try_for_each(|of_scene| self.begin(of_scene).map(drop))?;
        let claims: Result<Vec<_>, _> =
            self.paths.iter().flatten().map(|path| Claim::of(path, &place_of(path))).collect();
        claims.map(drop)
    }

    fn begin(&self, of_scene: &[PathBuf]) -> Result<Vec<Output>, Failure> {
        of_scene.iter().map(|path| Output::create(Some(path), &self.inputs)).collect()
    }
}

impl RaysBench {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        let machine = Machine::this();
        if let Some(folder) = &self.dump {
            match fs::metadata(folder) {
                Ok(metadata) if metadata.is_dir() => {}
                Err(error) if !is_callers_fault(&error) => return Err(Failure::io(folder, "write into", &error)),
                _ => {
                    let folder = shown(folder);
                    return Err(Failure::caller(format!("--dump {folder}: expected a folder that is there")));
                }
            }
        }
        let refused = |error: FileError| Failure::scene(&error);
        let dumps = self.dumps(refused)?;
        // Before the work begins it is made sure that they can be written; a file begins in its scene's turn, as there may be many.
        dumps.check()?;
        let mut is_first = true;
        self.stems.iter().zip(&dumps.paths).try_for_each(|(stem, of_scene)| {
            let scene = Files::read(stem).map_err(refused)?;
            let dumps = dumps.begin(of_scene)?;
            if std::mem::take(&mut is_first) {
                self.print_head(&machine)?;
            }
            self.measure(scene, dumps, &machine)
        })
    }

    fn dumps(&self, refused: impl Fn(FileError) -> Failure) -> Result<Dumps, Failure> {
        let Some(folder) = &self.dump else {
            return Ok(Dumps { paths: vec![Vec::new(); self.stems.len()], inputs: Inputs::none() });
        };
        let rays =
            self.stems.iter().map(|stem| raw::find_rays(stem)).collect::<Result<Vec<_>, _>>().map_err(refused)?;
        let primitives = self.stems.iter().flat_map(|stem| raw::primitive_files(stem));
        let inputs = Inputs::of(primitives).and(Inputs::of(rays.iter().flatten().map(|(_, path)| path)));
        let of_scene = |(stem, rays): (&PathBuf, &Vec<(String, PathBuf)>)| {
            let name = Files::name(stem);
            rays.iter().map(|(kind, _)| folder.join(format!("{name}.{kind}.{ENGINE}.hits"))).collect()
        };
        Ok(Dumps { paths: self.stems.iter().zip(&rays).map(of_scene).collect(), inputs })
    }

    /// The heading above all figures.
    fn print_head(&self, machine: &Machine) -> Result<(), Failure> {
        match self.format {
            TableFormat::Text => output::print(format!("{machine}\n").as_bytes()),
            TableFormat::Csv => output::print(format!("{}\n", Row::COLUMNS).as_bytes()),
            TableFormat::Json => Ok(()),
        }
    }

    /// Measures a scene, and prints each figure as soon as it is known.
    fn measure(&self, files: Files, dumps: Vec<Output>, machine: &Machine) -> Result<(), Failure> {
        let Files { name, primitives, rays } = files;
        let mut scene = None;
        for threads in &self.threads {
            drop(scene.take());
            let (built, lap) = throughput::build(&name, &primitives, usize::from(*threads));
            scene = Some(built);
            let (build_s, build_cpu_s) = (lap.seconds, lap.cpu_seconds);
            let (build_threads, primitives) = (*threads, primitives.count());
            let built =
                Built { engine: ENGINE, scene: &name, build_s, build_cpu_s, build_threads, primitives, machine };
            self.print_built(&built)?;
        }
        drop(primitives);
        let Some(scene) = scene else { return Ok(()) };
        if self.format == TableFormat::Text {
            output::print(Row::TITLE.as_bytes())?;
        }
        let dumps = dumps.into_iter().map(Some).chain(std::iter::repeat_with(|| None));
        rays.iter().zip(dumps).try_for_each(|((kind, file), dump)| self.measure_rays(&scene, (kind, file), dump))
    }

    fn measure_rays(&self, scene: &Scene, (kind, file): (&str, &RayFile), dump: Option<Output>) -> Result<(), Failure> {
        let passes = self.passes.map_or(Passes::Seconds(self.seconds), |number| Passes::Number(number as usize));
        let mut hits = Hits::default();
        for mode in Mode::ALL {
            for threads in &self.threads {
                let measured = measure(scene, file, mode, usize::from(*threads), passes, &mut hits);
                self.print_row(&Row::of(scene, (kind, mode), file.rays.len(), &measured))?;
            }
        }
        let Some(dump) = dump else { return Ok(()) };
        let hits = hits.t.iter().zip(&hits.primitive);
        dump.stream(|out| {
            use std::io::Write;
            for (t, primitive) in hits {
                out.write_all(&t.to_le_bytes())?;
                out.write_all(&primitive.to_le_bytes())?;
            }
            Ok(())
        })
    }

    fn print_built(&self, built: &Built) -> Result<(), Failure> {
        let Built { scene, build_s, build_threads, primitives, .. } = built;
        match self.format {
            TableFormat::Json => print_json(built),
            TableFormat::Csv => Ok(()),
            TableFormat::Text => {
                let scene = escape_hidden(scene);
                let text =
                    format!("{scene}: {primitives} primitives, built in {build_s:.4} s, threads: {build_threads}\n");
                output::print(text.as_bytes())
            }
        }
    }

    fn print_row(&self, row: &Row) -> Result<(), Failure> {
        match self.format {
            TableFormat::Json => print_json(row),
            TableFormat::Csv => output::print(table::csv_line(row).as_bytes()),
            TableFormat::Text => output::print(row.text().as_bytes()),
        }
    }
}

impl<'a> Row<'a> {
    const COLUMNS: &'static str = "engine,mode,scene,rays,threads,n,mrays_median,mrays_lower_quartile,mrays_upper_quartile,\
        mrays_best,mrays_per_cpu_s,passes,hits,tsum";
    const TITLE: &'static str =
        "  rays       mode   threads       rays      hits  passes  Mrays/s  (quartiles)     Mrays/cpu s\n";

    fn of(scene: &'a Scene, (rays, mode): (&'a str, Mode), n: usize, measured: &Throughput) -> Row<'a> {
        let Throughput { threads, per_second, per_cpu_second, hits, t_sum } = *measured;
        let mega = |speed: f64| speed * 1e-6;
        Row {
            engine: ENGINE,
            mode: mode.word(),
            scene: &scene.name,
            rays,
            threads,
            n,
            mrays_median: mega(per_second.median),
            mrays_lower_quartile: mega(per_second.lower),
            mrays_upper_quartile: mega(per_second.upper),
            mrays_best: mega(per_second.greatest),
            mrays_per_cpu_s: mega(per_cpu_second.median),
            passes: per_second.count,
            hits,
            tsum: t_sum,
        }
    }

    fn text(&self) -> String {
        let rays = escape_hidden(self.rays);
        let Row { mode, threads, n, mrays_median, mrays_per_cpu_s, passes, hits, .. } = self;
        let quartiles = format!("({:.3} {:.3})", self.mrays_lower_quartile, self.mrays_upper_quartile);
        format!(
            "  {rays:<10} {mode:<6} {threads:>7} {n:>10} {hits:>9} {passes:>7} {mrays_median:>8.3}  {quartiles:<15} \
             {mrays_per_cpu_s:>11.3}\n"
        )
    }
}

fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    let line = serde_json::to_string(value).map_err(|error| Failure::machine(format!("cannot write: {error}")))?;
    output::print(format!("{}\n", escape_hidden_json(&line)).as_bytes())
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| (0.0..=3600.0).contains(seconds));
    seconds.ok_or_else(|| format!("expected seconds from 0 to 3600, found `{text}`"))
}
