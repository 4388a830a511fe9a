//! `--frames A-B`: the pictures of an animation, each in a file whose name has its number.

use super::failure::Failure;
use super::scene_argument::Loaded;
use raywalk::files::escape_hidden;
use raywalk::scene::file::schema::SceneFile;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// The first and the last of the frames that are wanted, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRange {
    first: u32,
    last: u32,
}

/// A frame and the file for its picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Its number, from 1.
    pub number: u32,
    /// Whether it is the first one that is wanted.
    pub is_first: bool,
    /// Where its picture goes.
    pub path: PathBuf,
}

impl FromStr for FrameRange {
    type Err = String;

    fn from_str(text: &str) -> Result<FrameRange, String> {
        let expected = || format!("expected the first and the last frame, such as 1-24, found `{text}`");
        let (first, last) = text.split_once('-').unwrap_or((text, text));
        let number = |text: &str| text.parse().ok().filter(|number| *number > 0).ok_or_else(expected);
        let (first, last) = (number(first)?, number(last)?);
        if first > last {
            return Err(format!("{}: the first comes after the last", expected()));
        }
        Ok(FrameRange { first, last })
    }
}

/// The frames of a scene that are wanted, with their files; without a wish the first, in the file as it is named.
pub fn frames(scene: &SceneFile, wanted: Option<FrameRange>, path: &Path) -> Result<Vec<Frame>, Failure> {
    let Some(FrameRange { first, last }) = wanted else {
        return Ok(vec![Frame { number: 1, is_first: true, path: path.to_owned() }]);
    };
    let option = format!("--frames {first}-{last}");
    check(scene, last, &option)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if first < last && !name.contains('#') {
        let expected = "expected #### in the name of the picture for the frame's number";
        return Err(Failure::caller(format!("{option}: {expected}, found {}", escape_hidden(&name))));
    }
    let path = |number: u32| path.with_file_name(numbered(&name, number));
    let frame = |number: u32| Frame { number, is_first: number == first, path: path(number) };
    Ok((first..=last).map(frame).collect())
}

/// The scene as it is in the one frame that is wanted; without a wish in the first.
pub fn at_one(loaded: Loaded, wanted: Option<u32>) -> Result<Loaded, Failure> {
    if let Some(frame) = wanted {
        check(&loaded.scene, frame, &format!("--frames {frame}"))?;
    }
    Ok(at(loaded, wanted.unwrap_or(1)))
}

/// Refuses a frame that the scene doesn't have.
fn check(scene: &SceneFile, frame: u32, option: &str) -> Result<(), Failure> {
    match scene.frames {
        None => Err(Failure::caller(format!("{option}: the scene is no animation, expected `frames` in it"))),
        Some(frames) if frame > frames.count => {
            Err(Failure::caller(format!("{option}: the scene has {} frames", frames.count)))
        }
        Some(_) => Ok(()),
    }
}

/// Reads the number of a frame.
pub fn number(text: &str) -> Result<u32, String> {
    let number = text.parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| format!("expected the number of one frame, from 1, found `{text}`"))
}

/// The scene as it is in a frame.
pub fn at(mut loaded: Loaded, frame: u32) -> Loaded {
    if let Some(frames) = loaded.scene.frames {
        let shutter = &mut loaded.scene.camera.shutter;
        *shutter = shutter.map(|time| time + frames.time_of(frame));
    }
    loaded.frame = frame;
    loaded
}

/// The first run of `#` in a name as a number of as many digits at least.
pub fn numbered(name: &str, number: u32) -> String {
    let Some(start) = name.find('#') else { return name.to_owned() };
    let rest = name[start..].trim_start_matches('#');
    let width = name.len() - start - rest.len();
    format!("{}{number:0width$}{rest}", &name[..start])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_number_has_as_many_digits_as_there_are_marks() {
        assert_eq!(numbered("wheel-####.png", 7), "wheel-0007.png");
        assert_eq!(numbered("#.png", 12), "12.png");
        assert_eq!(numbered("a##b##.png", 3), "a03b##.png");
        assert_eq!(numbered("wheel.png", 3), "wheel.png");
    }

    #[test]
    fn ranges() {
        assert_eq!("3-5".parse(), Ok(FrameRange { first: 3, last: 5 }));
        assert_eq!("4".parse(), Ok(FrameRange { first: 4, last: 4 }));
        for text in ["", "0-3", "3-", "-3", "5-3", "a-b", "1-2-3"] {
            assert!(text.parse::<FrameRange>().is_err(), "{text}");
        }
    }
}
