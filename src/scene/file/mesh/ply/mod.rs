//! Reads PLY (Greg Turk, 1994): ASCII and binary, its elements `vertex` and `face`. Other elements are skipped.
//!
//! Own code rather than the crate `ply-rs-bw`, which builds a map a vertex and believes the counts of the header. A
//! property declared `float` is read in single precision, as its writer meant it, so that the ASCII and the binary file of
//! a mesh are the same mesh; `double` is read in double precision.

mod body;
mod header;
mod values;

use super::fault::without_place;
use crate::geometry::mesh::Mesh;
use crate::scene::file::{Problem, SceneError, Source};
use header::{Encoding, Header};
use values::{Ascii, Binary, Order};

/// Whether a file says that it is PLY.
pub fn is_ply(bytes: &[u8]) -> bool {
    bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r")
}

/// The mesh in the bytes of a PLY file, and warnings.
pub fn read(source: &Source) -> Result<(Mesh, Vec<Problem>), SceneError> {
    let header = Header::read(source.text).map_err(|fault| fault.in_text(source))?;
    let (text, start) = (source.text, header.length);
    let collected = match header.encoding {
        Encoding::Ascii => body::read(&header, Ascii::new(text, start)),
        Encoding::LittleEndian => body::read(&header, Binary::new(text, start, Order::Little)),
        Encoding::BigEndian => body::read(&header, Binary::new(text, start, Order::Big)),
    };
    let collected = collected.map_err(|fault| match header.encoding {
        Encoding::Ascii => fault.in_text(source),
        Encoding::LittleEndian | Encoding::BigEndian => fault.in_binary(source, start),
    })?;
    let (mesh, warnings) = collected.finish();
    Ok((mesh, warnings.into_iter().map(|message| without_place(source.name, message)).collect()))
}
