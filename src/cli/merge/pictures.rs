//! Parts of pictures.

use super::{Merge, open, some_of};
use crate::cli::failure::{Failure, shown};
use crate::cli::frames::numbered;
use crate::cli::inputs::Inputs;
use crate::cli::layers::Layers;
use crate::cli::picture::{Place, Shown, format_of};
use crate::cli::render::MAX_PART_BYTES;
use raywalk::files::escape_hidden;
use raywalk::render::Canvas;
use raywalk::render::part::{Content, PartError, PartHeader, Picture, Reader};
use raywalk::render::pieces::pieces;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead, BufReader};
use std::path::Path;

/// A part, and what it says about itself.
struct Part<'p> {
    path: &'p Path,
    header: PartHeader,
}

impl Merge {
    /// Joins parts of one picture, or of one picture a frame.
    pub(super) fn pictures(&self) -> Result<(), Failure> {
        let format = format_of(&self.output, self.png16)?;
        let mut frames: BTreeMap<Option<u32>, Vec<Part>> = BTreeMap::new();
        for path in &self.parts {
            let header = part_in(path)?.header().clone();
            let frame = header.picture.frame.map(|frame| frame.number);
            frames.entry(frame).or_default().push(Part { path, header });
        }
        of_one_animation(frames.values().map(|parts| &parts[0]))?;
        let name = self.output.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if frames.len() > 1 && !name.contains('#') {
            let several = frames.keys().map(|frame| frame.map_or("none".to_owned(), |frame| frame.to_string()));
            let several = some_of(&several.collect::<Vec<_>>());
            return Err(Failure::caller(format!(
                "merge: the parts are of several frames ({several}); expected #### in the name of the picture, found {}",
                escape_hidden(&name)
            )));
        }
        // All of them, before the first one is written.
        frames.values().try_for_each(|parts| check(parts))?;
        for path in &self.parts {
            each_piece(path, |_| ())?;
        }
        for (frame, parts) in &frames {
            let path = match frame {
                Some(frame) if name.contains('#') => self.output.with_file_name(numbered(&name, *frame)),
                _ => self.output.clone(),
            };
            let picture = &parts[0].header.picture;
            let (names, objects) = match &picture.content {
                Content::Layers { names, objects } => (names.as_slice(), objects.as_slice()),
                Content::Colors | Content::Digits { .. } => (&[][..], &[][..]),
            };
            let layers = Layers::named(names)
                .ok_or_else(|| Failure::caller(format!("{}: has layers that aren't known", shown(parts[0].path))))?;
            let layers = Some(layers).filter(|_| !names.is_empty());
            if let Some(layers) = &layers {
                layers.check(format)?;
            }
            let [left, top, right, bottom] = picture.crop;
            let size = [right - left, bottom - top];
            let place = Place::create(&path, format, size, layers.as_ref(), &Inputs::of(&self.parts))?;
            let rendered = joined(parts, picture)?;
            let shown = Shown { output: self.shown.over(picture.output.into()), objects, is_quiet: self.quiet };
            place.write(&rendered, &shown)?;
        }
        Ok(())
    }
}

fn part_in(path: &Path) -> Result<Reader<impl BufRead + use<>>, Failure> {
    let input = BufReader::new(open(path)?.stream(MAX_PART_BYTES));
    Reader::open(input).map_err(|error| match error {
        PartError::Io(error) => Failure::io(path, "read", &error),
        error => Failure::caller(format!("{}: {error}", shown(path))),
    })
}

/// Refuses frames that aren't of one animation, of which these are parts.
fn of_one_animation<'p>(mut frames: impl Iterator<Item = &'p Part<'p>>) -> Result<(), Failure> {
    let Some(first) = frames.next() else { return Ok(()) };
    frames
        .try_for_each(|other| same(first, other, first.header.picture.difference_of_animations(&other.header.picture)))
}

/// Refuses two parts that differ in something, said as the two have it.
fn same(first: &Part, other: &Part, difference: Option<(&str, [String; 2])>) -> Result<(), Failure> {
    let Some((what, [a, b])) = difference else { return Ok(()) };
    let [first, other] = [first, other].map(|part| shown(part.path));
    let [a, b] = [a, b].map(|said| escape_hidden(&said).into_owned());
    Err(Failure::caller(format!("{first} and {other}: are of different pictures, {what}: {a} against {b}")))
}

/// Refuses parts that aren't the whole of one picture, each piece once.
fn check(parts: &[Part]) -> Result<(), Failure> {
    let (first, rest) = (&parts[0], &parts[1..]);
    for other in rest {
        same(first, other, first.header.picture.difference(&other.header.picture))?;
    }
    let count = pieces(first.header.picture.crop).count();
    let mut owners: Vec<Option<&Part>> = vec![None; count];
    for part in parts {
        for (number, _) in part.header.pieces() {
            if let Some(before) = owners[number as usize].replace(part) {
                let [a, b] = [before, part].map(|part| format!("{} (shard {})", shown(part.path), part.header.shard));
                return Err(Failure::caller(format!("{a} and {b}: overlap, each piece is wanted once")));
            }
        }
    }
    // Shards of a picture with few pieces may have none; such parts aren't missed.
    if owners.iter().any(Option::is_none) {
        return Err(Failure::caller(format!("merge: shards are missing: {}", missing(parts, &owners))));
    }
    Ok(())
}

/// What is missing: as shards of the finest division, where that is one of all others, too.
fn missing(parts: &[Part], owners: &[Option<&Part>]) -> String {
    let of = parts.iter().map(|part| part.header.shard.of()).max().unwrap_or(1);
    let missing = || (0_u32..).zip(owners).filter(|(_, owner)| owner.is_none()).map(|(piece, _)| piece);
    if !parts.iter().all(|part| of.is_multiple_of(part.header.shard.of())) {
        return format!(
            "{} of {} pieces are in no part, whose divisions don't fit together",
            missing().count(),
            owners.len()
        );
    }
    let shards: BTreeSet<u32> = missing().map(|piece| piece % of + 1).collect();
    some_of(&shards.iter().map(|number| format!("{number}/{of}")).collect::<Vec<_>>())
}

/// The picture that the parts are of.
fn joined(parts: &[Part], picture: &Picture) -> Result<Canvas, Failure> {
    let canvas = picture.content.canvas(picture.crop);
    let mut canvas = canvas.map_err(|error| Failure::machine(error.to_string()))?;
    for Part { path, .. } in parts {
        each_piece(path, |piece| canvas.put(&piece))?;
    }
    Ok(canvas)
}

/// Hands on every piece of a part that is whole.
fn each_piece(path: &Path, take: impl FnMut(Canvas)) -> Result<(), Failure> {
    match part_in(path)?.each_piece(take) {
        Ok(true) => Ok(()),
        Ok(false) => Err(Failure::caller(format!(
            "{}: was cut off or damaged; expected a whole part, which the same `render --shard` writes again",
            shown(path)
        ))),
        Err(error) => Err(Failure::io(path, "read", &error)),
    }
}
