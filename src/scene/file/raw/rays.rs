//! Rays.

use super::MAX_RAW_BYTES;
use super::fields::{Claim, Fields};
use crate::files::{FileError, Wanted, display_name};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// What is asked about the rays of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// The nearest hit.
    Closest,
    /// Whether there is any hit.
    Occlusion,
}

/// The rays of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct RayFile {
    /// What is asked about them.
    pub question: Question,
    /// Columns and rows of the picture whose rays they are; 0 where they are not those of a picture.
    pub resolution: [u32; 2],
    /// The rays.
    pub rays: Vec<RawRay>,
}

/// A ray as it is written: hits lie between `t_min` and `t_max`, in units of the direction, which is about 1 long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RawRay {
    /// Where it begins.
    pub origin: [f32; 3],
    /// Hits lie beyond this distance.
    pub t_min: f32,
    /// Where it goes; not zero.
    pub direction: [f32; 3],
    /// Hits lie before this distance; may be infinite.
    pub t_max: f32,
}

/// The files of rays of a scene, `STEM.KIND.rays`, with their kinds, in the order of the kinds' names but for primary rays, which come
/// first.
///
/// # Errors
/// [`FileError::Refused`] where there are none; [`FileError::Unreadable`] where the folder can't be read.
pub fn find_rays(stem: &Path) -> Result<Vec<(String, PathBuf)>, FileError> {
    let file = || display_name(stem);
    let none = || {
        let reason = "no rays, expected files of that name with .primary.rays or the like behind it".to_owned();
        FileError::Refused { file: file(), reason }
    };
    let begin = stem.file_name().ok_or_else(none)?.to_string_lossy().into_owned();
    let folder = stem.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let unreadable = |source: io::Error| match source.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => none(),
        _ => FileError::Unreadable { file: file(), source },
    };
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let rest = name.strip_prefix(&begin).and_then(|rest| rest.strip_prefix('.'));
        let kind = rest.and_then(|rest| rest.strip_suffix(".rays")).filter(|kind| !kind.contains('.'));
        found.extend(kind.map(|kind| (kind.to_owned(), entry.path())));
    }
    found.sort_by_key(|(kind, _)| (kind != "primary", kind.clone()));
    if found.is_empty() { Err(none()) } else { Ok(found) }
}

/// Reads a file of rays.
///
/// # Errors
/// [`FileError::Refused`] where it is missing or damaged; [`FileError::Unreadable`] where the machine doesn't give the bytes or
/// has no room for them.
pub fn read_rays(path: &Path) -> Result<RayFile, FileError> {
    let bytes = Wanted { what: "raw rays", max_bytes: MAX_RAW_BYTES }.read(path)?;
    parse_rays(&bytes, &display_name(path))
}

/// Reads rays.
///
/// # Errors
/// [`FileError::Refused`] where they are damaged; [`FileError::Unreadable`] where there is no room for them.
pub fn parse_rays(bytes: &[u8], name: &str) -> Result<RayFile, FileError> {
    let mut fields = Fields::of(bytes, name, "RWRAYS01", 32)?;
    let (question, width, height, reserved) = (fields.u32(), fields.u32(), fields.u32(), fields.u32());
    let question = match (question, reserved) {
        (0, 0) => Question::Closest,
        (1, 0) => Question::Occlusion,
        (found, 0) => {
            return Err(fields.refused(format!("expected the question 0 (nearest hit) or 1 (any hit), found {found}")));
        }
        (_, found) => return Err(fields.refused(format!("expected 0 behind width and height, found {found}"))),
    };
    let count = fields.u64();
    fields.must_hold(&[Claim { what: "rays", count, size: 32, most: MAX_RAW_BYTES as usize / 32 }])?;
    if count == 0 {
        return Err(fields.refused("holds no rays"));
    }
    let rays = fields.list(count, ray)?;
    Ok(RayFile { question, resolution: [width, height], rays })
}

fn ray(fields: &mut Fields, number: u64) -> Result<RawRay, FileError> {
    let [x, y, z, t_min] = fields.finite("ray", number)?;
    let direction = fields.finite("ray", number)?;
    let t_max = fields.f32();
    let wrong = |what: String| Err(fields.refused(format!("ray {number}: {what}")));
    if direction == [0.0; 3] {
        wrong("expected a direction that is not zero".to_owned())
    } else if t_max.is_nan() {
        wrong("expected a number as t_max, found NaN".to_owned())
    } else {
        Ok(RawRay { origin: [x, y, z], t_min, direction, t_max })
    }
}
