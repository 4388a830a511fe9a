//! Parts of pictures as files, `raywalk-part/1`: what a shard rendered, or what was rendered when the work was ended early.
//!
//! A line of JSON says what the picture is of. Records follow: the number of a piece in four bytes, its pixels row by row, each as so
//! many words of eight bytes, and a check of eight bytes. All is little-endian, colours and other numbers are f64. A part that is
//! whole ends with a record of the number 2³² − 1 and the digest of all that precedes it. What isn't whole is good up to its last
//! whole record.

mod read;
mod words;
mod write;

pub use read::{PartError, Reader, Record};
pub use write::Writer;

use super::pieces::pieces_of;
use super::{Canvas, RenderError};
use crate::log::header::{SceneId, TracingId};
use crate::log::plane::Plane;
use crate::log::{FrameId, Header, Shard};
use crate::scene::{Output, Transfer};
use serde::{Deserialize, Serialize};

/// The name and version of the format.
pub const FORMAT: &str = "raywalk-part/1";

/// The number of the record that ends a whole part.
const END: u32 = u32::MAX;

/// The number of the record that says into which picture a part went.
const WENT_INTO: u32 = u32::MAX - 1;

/// The bytes of a check.
const CHECK: usize = 8;

/// What a part is of, and which.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartHeader {
    /// Always [`FORMAT`].
    pub part: String,
    /// Which shard.
    pub shard: Shard,
    /// The picture.
    #[serde(flatten)]
    pub picture: Picture,
}

/// A picture that parts are of: those of the same picture fit together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// The version of the program.
    pub version: String,
    /// The scene with all that options changed in it.
    pub scene: SceneId,
    /// Which frame of an animation; `None` where there is one only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frame: Option<FrameId>,
    /// In which arithmetic.
    pub arithmetic: String,
    /// How rays are traced, with what no scene file says: what is left out and tested.
    pub tracing: TracingId,
    /// The rectangle of pixels: left, top, right, bottom, the last two exclusive.
    pub crop: [u32; 4],
    /// What of each pixel.
    pub content: Content,
    /// How values become the numbers of integer formats.
    pub output: Levels,
}

/// What a part holds of each pixel.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Content {
    /// The colour.
    Colors,
    /// How many digits of it can be trusted.
    Digits {
        /// The seed of the first run.
        seed: u64,
    },
    /// The colour with what it costs and sees.
    Layers {
        /// Which layers are wanted, by their names.
        names: Vec<String>,
        /// The names of the scene's objects, by number.
        objects: Vec<String>,
    },
}

/// [`Output`] as it is written.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Levels {
    /// The value that is shown as full white.
    pub white: f64,
    /// Whether the curve is that of sRGB.
    pub is_srgb: bool,
    /// Stops of exposure.
    pub exposure: f64,
}

impl PartHeader {
    /// The part of a picture that a shard has.
    pub fn new(picture: Picture, shard: Shard) -> PartHeader {
        PartHeader { part: FORMAT.to_owned(), shard, picture }
    }

    /// How many bytes the pixels of the whole picture take.
    pub fn bytes_of_picture(&self) -> u64 {
        let [left, top, right, bottom] = self.picture.crop;
        let words = words::count(&self.picture.content) as u64;
        u64::from(right - left) * u64::from(bottom - top) * words * size_of::<u64>() as u64
    }

    /// The pieces that the part has when it is whole, with their numbers.
    pub fn pieces(&self) -> impl Iterator<Item = (u32, [u32; 4])> {
        pieces_of(self.picture.crop, self.shard)
    }
}

impl Picture {
    /// The picture whose pixels' logs have this header.
    pub fn new(header: Header, crop: [u32; 4], content: Content, output: Output) -> Picture {
        let Header { version, scene, frame, arithmetic, tracing, .. } = header;
        Picture { version, scene, frame, arithmetic, tracing, crop, content, output: output.into() }
    }

    /// In what two pictures differ that can't be two frames of one animation; `None` if they may be. The scene of each frame has a
    /// digest of its own.
    pub fn difference_of_animations(&self, other: &Picture) -> Option<(&'static str, [String; 2])> {
        let mut here = other.clone();
        here.scene.digest.clone_from(&self.scene.digest);
        if let (Some(frame), Some(_)) = (self.frame, other.frame) {
            here.frame = Some(frame);
        }
        self.difference(&here)
    }

    /// In what two pictures differ first, and what each says; `None` if they are the same.
    pub fn difference(&self, other: &Picture) -> Option<(&'static str, [String; 2])> {
        let both = |name, of: &dyn Fn(&Picture) -> String| {
            let [ours, theirs] = [of(self), of(other)];
            (ours != theirs).then_some((name, [ours, theirs]))
        };
        let frame = |picture: &Picture| picture.frame.map_or("none".to_owned(), |frame| frame.number.to_string());
        both("version", &|picture| picture.version.clone())
            .or_else(|| both("scene", &|picture| picture.scene.name.clone()))
            .or_else(|| both("frame", &frame))
            .or_else(|| both("crop", &|picture| picture.crop.map(|side| side.to_string()).join(",")))
            .or_else(|| both("arithmetic", &|picture| picture.arithmetic.clone()))
            .or_else(|| both("--skip", &|picture| picture.tracing.skip.clone().unwrap_or_else(|| "all".to_owned())))
            .or_else(|| {
                both("--tests", &|picture| picture.tracing.tests.clone().unwrap_or_else(|| "visited".to_owned()))
            })
            .or_else(|| both("what of each pixel", &|picture| picture.content.words()))
            .or_else(|| both("output", &|picture| picture.output.words()))
            .or_else(|| both("the scene with its options", &|picture| picture.scene.digest.clone()))
            .or_else(|| {
                (self != other).then(|| ("tracing", [self, other].map(|picture| format!("{:?}", picture.tracing))))
            })
    }
}

impl Content {
    /// An empty picture for it.
    ///
    /// # Errors
    /// [`RenderError::Memory`].
    pub fn canvas(&self, crop: [u32; 4]) -> Result<Canvas, RenderError> {
        match self {
            Content::Colors => Canvas::colors(crop),
            Content::Digits { .. } => Canvas::digits(crop),
            Content::Layers { .. } => Canvas::layers(crop, self.numbers()),
        }
    }

    /// How many numbers a pixel has of the planes among its layers.
    fn numbers(&self) -> usize {
        match self {
            Content::Colors | Content::Digits { .. } => 0,
            Content::Layers { names, .. } => {
                names.iter().filter_map(|name| name.parse().ok()).map(|plane: Plane| plane.numbers()).sum()
            }
        }
    }

    fn words(&self) -> String {
        match self {
            Content::Colors => "its colour".to_owned(),
            Content::Digits { seed } => format!("its digits from the seed {seed} on"),
            Content::Layers { names, .. } => format!("its colour and the layers {}", names.join(", ")),
        }
    }
}

impl Levels {
    fn words(&self) -> String {
        let Levels { white, is_srgb, exposure } = self;
        format!("white {white}, {}, exposure {exposure}", if *is_srgb { "srgb" } else { "linear" })
    }
}

impl From<Output> for Levels {
    fn from(Output { white, transfer, exposure }: Output) -> Levels {
        Levels { white, is_srgb: transfer == Transfer::Srgb, exposure }
    }
}

impl From<Levels> for Output {
    fn from(Levels { white, is_srgb, exposure }: Levels) -> Output {
        Output { white, transfer: if is_srgb { Transfer::Srgb } else { Transfer::Linear }, exposure }
    }
}

/// The check of a record: the beginning of the digest of what precedes it in the record.
fn check(record: &[u8]) -> [u8; CHECK] {
    let digest = blake3::hash(record);
    let mut check = [0; CHECK];
    check.copy_from_slice(&digest.as_bytes()[..CHECK]);
    check
}
