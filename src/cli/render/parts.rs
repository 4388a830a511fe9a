//! Pictures by pieces: shards, and what goes on where it was ended early.

use super::checkpoint::{self, Checkpoint, Kept, Spent};
use super::{Render, Task, failed, names_of};
use crate::cli::failure::{Failure, shown};
use crate::cli::output::{self, Output};
use crate::cli::picture;
use raywalk::files::Wanted;
use raywalk::log::{Shard, Subject};
use raywalk::record;
use raywalk::render::export::Format;
use raywalk::render::part::{Content, PartHeader, Picture, Reader, Writer};
use raywalk::render::pieces::render_pieces;
use raywalk::render::statistics::Seconds;
use raywalk::render::{Canvas, Counter, RenderError};
use std::io::{self, BufReader};
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

/// The most bytes of a part, unpacked: those of the largest picture with all layers.
pub const MAX_PART_BYTES: u64 = 1 << 35;

impl Render {
    /// Renders a picture, from where the same call was ended early; gives its checkpoint, which is of no more use when all frames
    /// are there.
    pub(super) fn resumed_picture(&self, task: &Task, format: Format) -> Result<Spent, Failure> {
        // Made sure of before the work begins, and let go: nothing is left behind by whatever ends it.
        let place = self.place(task, format)?;
        if !place.is_file() {
            return Err(not_a_file(task));
        }
        let header = self.header(task, Shard::WHOLE)?;
        fits(&header)?;
        let (mut checkpoint, kept) = Checkpoint::open(&task.path, &header, &task.inputs)?;
        drop(place);
        let files = || picture::digest(&task.path, format, task.layers.as_ref());
        if checkpoint.is_in(files().ok()) {
            self.tell(&task.path, "exists already");
            return Ok(checkpoint.spent());
        }
        let mut kept = self.render_rest(task, &header, kept, Some(&mut checkpoint))?.0;
        let mut canvas = header.picture.content.canvas(task.settings.crop).map_err(|error| failed(&error))?;
        for (number, _) in header.pieces() {
            if let Some(pixels) = kept.remove(&number) {
                canvas.put(&pixels);
            }
        }
        self.place(task, format)?.write(&canvas, &self.shown(task, &names_of(&task.scene)))?;
        let files = files().map_err(|error| Failure::io(&task.path, "read", &error))?;
        checkpoint.went_into(&header, &files)
    }

    /// Renders a shard into a part, unless it is there.
    pub(super) fn part(&self, task: &Task, mut seconds: Seconds) -> Result<(), Failure> {
        let header = self.header(task, self.shard.unwrap_or(Shard::WHOLE))?;
        fits(&header)?;
        if is_whole(&task.path, &header) {
            self.tell(&task.path, "exists already and is complete");
            output::sweep_around(&task.path);
            // The run that made it may have been killed before it removed its checkpoint.
            return checkpoint::remove_left_of(&task.path, &task.inputs, || Ok(header));
        }
        let create = || Output::create(Some(&task.path), &task.inputs);
        let output = create()?;
        let (mut checkpoint, kept) = match self.resume {
            true if !output.is_file() => return Err(not_a_file(task)),
            true => Checkpoint::open(&task.path, &header, &task.inputs)
                .map(|(checkpoint, kept)| (Some(checkpoint), kept))?,
            false => (None, Kept::new()),
        };
        // As above: what is kept is in the checkpoint.
        let output = Some(output).filter(|_| !self.resume);
        let start = Instant::now();
        let (kept, counts) = self.render_rest(task, &header, kept, checkpoint.as_mut())?;
        seconds.render = start.elapsed().as_secs_f64();
        output.map_or_else(create, Ok)?.stream(|out| {
            let mut writer = Writer::new(out, &header)?;
            kept.iter().try_for_each(|(number, pixels)| writer.piece(*number, pixels))?;
            writer.finish().map(|_| ())
        })?;
        match checkpoint {
            Some(checkpoint) => checkpoint.spent().remove()?,
            None => checkpoint::remove_left_of(&task.path, &task.inputs, || Ok(header))?,
        }
        self.print_statistics(task, Some(counts), seconds, 0)
    }

    /// Renders the pieces that aren't kept, and keeps them.
    fn render_rest(
        &self,
        task: &Task,
        header: &PartHeader,
        mut kept: Kept,
        mut checkpoint: Option<&mut Checkpoint>,
    ) -> Result<(Kept, Counter), Failure> {
        let pixels = |[left, top, right, bottom]: [u32; 4]| u64::from(right - left) * u64::from(bottom - top);
        let (done, missing): (Vec<_>, Vec<_>) = header.pieces().partition(|(number, _)| kept.contains_key(number));
        let count = |pieces: &[(u32, [u32; 4])]| pieces.iter().map(|(_, area)| pixels(*area)).sum::<u64>();
        let progress = self.progress.start(count(&done) + count(&missing));
        progress.advance(count(&done));
        let keep = |number: u32, found: Canvas| -> io::Result<()> {
            if let Some(checkpoint) = &mut checkpoint {
                checkpoint.keep(number, &found)?;
            }
            progress.advance(found.count());
            kept.insert(number, found);
            Ok(())
        };
        let never = AtomicBool::new(false);
        let job = self.job(task)?;
        let rendered = render_pieces(&task.scene, &task.settings, &job, &missing, keep, &never);
        progress.finish();
        match rendered {
            Ok(counts) => Ok((kept, counts)),
            Err(RenderError::Io(error)) => Err(match checkpoint {
                Some(checkpoint) => checkpoint.failure(&error),
                None => Failure::io(&task.path, "keep what is rendered", &error),
            }),
            Err(error) => Err(failed(&error)),
        }
    }

    /// What a part of this picture says about itself.
    pub(super) fn header(&self, task: &Task, shard: Shard) -> Result<PartHeader, Failure> {
        let Task { scene, settings, .. } = task;
        let content = match (&task.layers, self.digits_seed()?) {
            (Some(layers), _) => Content::Layers { names: layers.names(), objects: names_of(scene) },
            (None, Some(seed)) => Content::Digits { seed },
            (None, None) => Content::Colors,
        };
        let log = record::header(scene, Subject::Region(settings.crop), settings.arithmetic);
        Ok(PartHeader::new(Picture::new(log, settings.crop, content, scene.output), shard))
    }

    fn tell(&self, path: &Path, what: &str) {
        if !self.progress.quiet {
            output::tell(&format!("note: {}: {what}", shown(path)));
        }
    }
}

/// Refuses what no part could be read of again.
fn fits(header: &PartHeader) -> Result<(), Failure> {
    let bytes = header.bytes_of_picture();
    if bytes <= MAX_PART_BYTES {
        return Ok(());
    }
    Err(Failure::caller(format!(
        "--layers: too many for parts of this picture: {bytes} bytes, expected at most {MAX_PART_BYTES}"
    )))
}

fn not_a_file(task: &Task) -> Failure {
    Failure::caller(format!("--resume: expected the name of a file, found {}", shown(&task.path)))
}

/// Whether the whole part of this shard is in a file. Whatever else is there will be overwritten, as any result is.
fn is_whole(path: &Path, header: &PartHeader) -> bool {
    if path == Path::new("-") || !path.is_file() {
        return false;
    }
    let Ok(opened) = (Wanted { what: "a part", max_bytes: MAX_PART_BYTES }).open(path) else { return false };
    let Ok(mut reader) = Reader::open(BufReader::new(opened.stream(MAX_PART_BYTES))) else { return false };
    reader.header() == header && reader.each_piece(|_| ()).unwrap_or(false)
}
