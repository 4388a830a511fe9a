//! Reads PLY (Greg Turk, 1994): ASCII and binary, its elements `vertex`, `face` and `tristrips`. Other elements are skipped.
//!
//! A text is read by its values, whatever its lines, where that comes out even. Where it doesn't, each record begins on a
//! line of its own, and what a line has more is left out.
//!
//! Own code rather than the crate `ply-rs-bw`, which builds a map a vertex and believes the counts of the header. A
//! property declared `float` is read in single precision, as its writer meant it, so that the ASCII and the binary file of
//! a mesh are the same mesh; `double` is read in double precision.

mod body;
mod header;
mod values;

use std::ops::Range;

use super::collect::{Collector, counted};
use super::fault::{Fault, without_place};
use crate::files::{FileError, Problem, Source};
use crate::geometry::mesh::Mesh;
use crate::scene::file::foreign::without_end_mark;
use header::{Encoding, Header};
use values::{Ascii, Binary, Lines, Order};

/// Whether a file says that it is PLY.
pub fn is_ply(bytes: &[u8]) -> bool {
    bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r")
}

/// The mesh in the bytes of a PLY file, and warnings.
pub fn read(source: &Source) -> Result<(Mesh, Vec<Problem>), FileError> {
    let header = Header::read(source.text).map_err(|fault| fault.in_text(source))?;
    let (text, start) = (source.text, header.length);
    let collected = match header.encoding {
        Encoding::Ascii => read_text(&header, without_end_mark(text)),
        Encoding::LittleEndian => read_bytes(&header, Binary::new(text, start, Order::Little)),
        Encoding::BigEndian => read_bytes(&header, Binary::new(text, start, Order::Big)),
    };
    let (collected, left_out) = collected.map_err(|fault| match header.encoding {
        Encoding::Ascii => fault.in_text(source),
        Encoding::LittleEndian | Encoding::BigEndian => fault.in_binary(source, start),
    })?;
    let (mesh, warnings) = collected.finish();
    let left_out = left_out.map(|(span, lines)| {
        let lines = counted(lines, "line has", "lines have");
        let message = format!("{lines} more values than the header says, such are left out");
        source.problem(span, Default::default(), message)
    });
    let warnings = warnings.into_iter().map(|message| without_place(source.name, message));
    Ok((mesh, left_out.into_iter().chain(warnings).collect()))
}

/// What is read, and of a text the first value that was left out and how many lines have such.
type Collected = (Collector, Option<(Range<usize>, usize)>);

fn read_bytes(header: &Header, mut values: Binary) -> Result<Collected, Fault> {
    Ok((body::read(header, &mut values)?, None))
}

fn read_text(header: &Header, text: &[u8]) -> Result<Collected, Fault> {
    let mut values = Ascii::new(text, header.length, Lines::Blanks);
    match body::read(header, &mut values) {
        Ok(collected) if values.is_at_end() => return Ok((collected, None)),
        Err(Fault::OutOfMemory) => return Err(Fault::OutOfMemory),
        Ok(_) | Err(Fault::Wrong { .. }) => {}
    }
    let mut values = Ascii::new(text, header.length, Lines::Records);
    let collected = body::read(header, &mut values)?;
    Ok((collected, values.left_out))
}
