//! NFF, the Neutral File Format of Eric Haines's Standard Procedural Databases: import as a [`SceneFile`](super::SceneFile).
//!
//! ASCII tokens separated by any white space; `#` begins a comment that ends with the line. The entities are
//!
//! | entity | meaning |
//! |---|---|
//! | `b` r g b | background |
//! | `v` `from` x y z `at` x y z `up` x y z `angle` a `hither` h `resolution` x y | view; `hither` is ignored |
//! | `l` x y z \[r g b\] | point light; without a colour each has 1/√(number of lights) |
//! | `f` r g b Kd Ks Shine T ior | fill for what follows |
//! | `c` base x y z r apex x y z r | open cone or cylinder; negative radii: the inside is the front |
//! | `s` x y z r | sphere; negative radius: the inside is the front |
//! | `p` n, n × (x y z) | polygon |
//! | `pp` n, n × (x y z, normal) | polygon with normals |
//!
//! Of what other programs add, a texture name or an ambient factor after `f`, `shader`, `tess`, `number` n, `g` with six
//! bounds, and the texture coordinates of `tpp` n × (x y z, normal, u v) are understood and ignored; a warning says so
//! of all but `tess`. A normal that is no number (`nan`, `1.#IND`) counts as none. There are at most [`MAX_PRIMITIVES`] primitives.
//!
//! This module turns bytes into a checked scene file. What the checks of [`validate`] find is placed in the NFF text.

mod entities;
mod mapping;
mod mistake;
mod places;
mod reader;
mod records;
mod shapes;
#[cfg(test)]
mod tests;
mod tokens;

use super::Loaded;
use super::validate::{judge, validate};
use crate::files::{FileError, Source, unpacked_name};
use records::Records;
use tokens::Tokens;

/// The most primitives of a file, 2²².
pub const MAX_PRIMITIVES: usize = 1 << 22;

/// What a view's `angle` is measured between.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum))]
pub enum Angle {
    /// The centres of the first and the last row of pixels.
    #[default]
    Centers,
    /// The picture's top and bottom edge.
    Edges,
}

/// How an NFF file is read.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Import {
    /// What the view's angle is measured between.
    pub angle: Angle,
    /// Pixels across and down instead of the view's; the view's angle stays.
    pub resolution: Option<[u32; 2]>,
}

/// Whether a file is NFF: by the ending of its name, else by its first token.
pub fn is_nff(bytes: &[u8], file_name: &str) -> bool {
    match unpacked_name(file_name).to_ascii_lowercase() {
        name if name.ends_with(".nff") => true,
        name if name.ends_with(".json") => false,
        _ => Tokens::new(bytes).next().is_some_and(|first| entities::may_begin_file(first.text)),
    }
}

/// Parses and validates the bytes of an NFF file.
///
/// # Errors
/// [`FileError::Invalid`], with every problem that validation finds, or the first that parsing finds.
pub fn check(bytes: &[u8], file_name: &str, import: &Import) -> Result<Loaded, FileError> {
    let source = Source { name: file_name, text: bytes };
    let records = records(&source)?;
    let mut warnings: Vec<_> = records.passed_over.iter().map(|passed| passed.problem(&source)).collect();
    let (scene, places) = mapping::scene(records, file_name, import);
    let place = |findings: &_| places.place(findings, &source);
    let (found, more_warnings) = judge(validate(&scene), place)?;
    warnings.extend(found);
    Ok(Loaded { scene, warnings, more_warnings })
}

fn records(source: &Source) -> Result<Records, FileError> {
    entities::read(source.text).map_err(|mistake| mistake.problem(source).into())
}
