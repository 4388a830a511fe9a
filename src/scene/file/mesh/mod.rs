//! Meshes: the files that a scene names, from bytes to [`Mesh`].
//!
//! This module owns the readers of OBJ and PLY and where a mesh may be read from ([`Folder`]). A face of more than three
//! corners becomes a fan of triangles about its first corner. Triangles count from 0 in the order of the file, those of a
//! fan one by one; triangles without area are skipped when rays are traced, but keep their numbers.
//!
//! ```
//! let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
//! let read = raywalk::scene::file::mesh::parse(text, "square.obj").map_err(|error| error.report(false));
//! assert_eq!(read.map(|read| read.mesh.faces), Ok(vec![[0, 1, 2], [0, 2, 3]]));
//! ```

pub(crate) mod limits;

mod collect;
mod fault;
mod load;
mod obj;
mod ply;
#[cfg(test)]
mod tests;
mod words;

pub use load::{Folder, Meshes, Warnings, load};

use crate::files::{FileError, Problem, Source, unpacked_name};
use crate::geometry::mesh::Mesh;
use fault::out_of_memory;
use limits::TREE_BYTES_PER_TRIANGLE;

/// A mesh as it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// The mesh.
    pub mesh: Mesh,
    /// What is odd about it but does not stop anybody.
    pub warnings: Vec<Problem>,
}

/// Reads the mesh in the bytes of an OBJ or PLY file. PLY says what it is; for OBJ the file's name has to.
///
/// # Errors
/// [`FileError::Invalid`] with the first problem; [`FileError::Refused`] when it is neither OBJ nor PLY;
/// [`FileError::Unreadable`] when there is no memory for it.
pub fn parse(bytes: &[u8], file_name: &str) -> Result<Read, FileError> {
    let source = Source { name: file_name, text: bytes };
    let name = unpacked_name(file_name).to_ascii_lowercase();
    let has_ending = |ending: &str| name.ends_with(ending);
    let (mesh, warnings) = if ply::is_ply(bytes) || has_ending(".ply") {
        ply::read(&source)?
    } else if has_ending(".obj") {
        obj::read(&source)?
    } else {
        let reason = "unknown kind of mesh, expected a name that ends in .obj or .ply".to_owned();
        return Err(FileError::Refused { file: file_name.to_owned(), reason });
    };
    // As far as that goes, there is memory for what tracing builds over the mesh: there it could only abort.
    if !raywalk_guard::has_room_for(mesh.faces.len() * TREE_BYTES_PER_TRIANGLE) {
        return Err(out_of_memory(file_name));
    }
    Ok(Read { mesh, warnings })
}
