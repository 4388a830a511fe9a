//! `raywalk merge`: parts of a picture, or logs of a region's shards, become what one run would have made.

mod logs;
mod pictures;

use super::failure::{Failure, shown};
use super::render::MAX_PART_BYTES;
use super::shown::ShownOptions;
use clap::Args;
use raywalk::files::{Kind, Opened, Wanted};
use std::path::{Path, PathBuf};

/// What `--help` says behind the options.
const MORE: &str = "\
The parts may be named in any order. Together they must be one whole picture or region: a part that is missing, repeated, or of another \
scene, call or version of the program is refused (exit code 2). The result has the bytes that one run without shards would have \
written. Parts hold the traced values: --exposure, --white and --transfer set how they are displayed, and nothing is rendered again.

Examples:
  raywalk render scene.json -o 1.part --shard 1/2
  raywalk render scene.json -o 2.part --shard 2/2
  raywalk merge 1.part 2.part -o picture.png
  raywalk merge frame-*.part -o frame-####.png
  raywalk merge logs/*.ndjson.gz -o region.ndjson.gz";

/// Join the parts that shards rendered, or the logs that they traced.
#[derive(Args)]
#[command(after_long_help = MORE)]
// Nothing is sampled here.
#[command(mut_arg("white", |white| white.help("The value shown as full white")))]
pub struct Merge {
    /// The parts that `render --shard` wrote, or the logs that `trace --region --shard` wrote
    #[arg(required = true, value_name = "PART")]
    parts: Vec<PathBuf>,
    /// The picture: .png, .ppm, .bmp, .tga, .qoi, .tiff, .jpg, .webp, .pfm or .exr by its ending, with #### for the number of the frame
    /// where there are several; or the log
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Write PNG with 16 bits a channel
    #[arg(long)]
    png16: bool,
    #[command(flatten)]
    shown: ShownOptions,
    /// Print errors only
    #[arg(long, short)]
    quiet: bool,
}

impl Merge {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let mut are_logs = Vec::new();
        for path in &self.parts {
            are_logs.push(is_log(path, &open(path)?)?);
        }
        match are_logs.iter().position(|is_log| *is_log != are_logs[0]) {
            Some(other) => {
                let [first, other] = [&self.parts[0], &self.parts[other]].map(|path| shown(path));
                Err(Failure::caller(format!("{first} and {other}: a part of a picture and a log; expected one kind")))
            }
            None if are_logs[0] => self.logs(),
            None => self.pictures(),
        }
    }
}

/// Opens a part, which is read by the way.
fn open(path: &Path) -> Result<Opened, Failure> {
    let what = "a part that `render --shard` wrote or a log";
    if path == Path::new("-") {
        return Err(Failure::caller(format!("-: expected the name of {what}")));
    }
    let wanted = Wanted { what, max_bytes: MAX_PART_BYTES };
    wanted.open(path).map_err(|error| Failure::scene(&error))
}

/// Whether it is a log, and not a part.
fn is_log(path: &Path, opened: &Opened) -> Result<bool, Failure> {
    match Kind::of(opened.beginning()) {
        Kind::Part => Ok(false),
        Kind::Log(_) => Ok(true),
        _ => Err(Failure::caller(format!(
            "{}: expected a part that `render --shard` wrote, or the log of a shard",
            shown(path)
        ))),
    }
}

/// Names of what is missing: the first few.
fn some_of(names: &[String]) -> String {
    const MOST: usize = 8;
    let more = names.len().saturating_sub(MOST);
    let named = names[..names.len() - more].join(", ");
    if more > 0 { format!("{named} and {more} more") } else { named }
}
