//! A path as it is asked for: `C R S1`, where a number that is left out stands for all of them.

use crate::log::RayKind;
use std::fmt;
use std::str::FromStr;

/// The rays of a pixel that have a path. Without the number of a sample, or that of a ray among several of its kind from one place, all are
/// meant.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct PathPattern {
    /// Which sample, from 1; all of them where that is `None`.
    pub sample: Option<u32>,
    /// The rays from the eye on; none for what lies outside every ray.
    pub steps: Vec<PathStep>,
}

/// A ray of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathStep {
    /// What the ray is for.
    pub kind: RayKind,
    /// Its number, from 1, among several from one place; 0 if it is alone, in a pattern also where all are meant.
    pub split: u32,
}

/// What is wrong with a path.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{}` is no path, expected C and then R or T for each bounce, at last S and the number of a light, such as `C`, `C R T` or `C R S1`; a sample's number \
     may come first",
    crate::files::escape::escape_hidden(.0)
)]
pub struct PathError(pub String);

/// The most rays of a path.
const LONGEST: usize = 300;

impl PathPattern {
    /// The camera's ray.
    pub fn of_camera() -> PathPattern {
        PathPattern { sample: None, steps: vec![PathStep { kind: RayKind::Camera, split: 0 }] }
    }

    /// The same for all samples, and for all rays of several of a kind.
    pub fn of_all(self) -> PathPattern {
        let steps = self.steps.into_iter().map(|step| PathStep { split: 0, ..step }).collect();
        PathPattern { sample: None, steps }
    }

    /// Whether these rays in this sample (0 if the pixel has no samples) are among those that are meant.
    pub fn matches(&self, sample: u32, steps: &[PathStep]) -> bool {
        let is_like = |(wanted, step): (&PathStep, &PathStep)| {
            wanted.kind == step.kind && (wanted.split == 0 || wanted.split == step.split)
        };
        self.steps.len() == steps.len()
            && self.sample.is_none_or(|wanted| wanted == sample)
            && self.steps.iter().zip(steps).all(is_like)
    }
}

impl FromStr for PathPattern {
    type Err = PathError;

    fn from_str(text: &str) -> Result<PathPattern, PathError> {
        let wrong = || PathError(text.to_owned());
        let mut words = text.split_whitespace().peekable();
        let sample = match words.peek().map(|word| word.parse::<u32>()) {
            Some(Ok(number)) if number > 0 => words.next().map(|_| number),
            _ => None,
        };
        let mut steps: Vec<PathStep> = Vec::new();
        for word in words {
            let (step, count) = step(word).ok_or_else(wrong)?;
            let is_first = steps.is_empty();
            let is_behind_shadow = steps.last().is_some_and(|last| matches!(last.kind, RayKind::Shadow { .. }));
            if is_first != (step.kind == RayKind::Camera) || is_behind_shadow || steps.len() + count > LONGEST {
                return Err(wrong());
            }
            steps.extend(std::iter::repeat_n(step, count));
        }
        Ok(PathPattern { sample, steps })
    }
}

/// A ray, and how often it is repeated: `R`, `R.12`, `S1.4`, `R×46`.
fn step(word: &str) -> Option<(PathStep, usize)> {
    let (word, count) = match word.split_once(['×', 'x']) {
        Some((word, count)) => (word, count.parse().ok().filter(|count| (1..=LONGEST).contains(count))?),
        None => (word, 1),
    };
    let (ray, split) = match word.split_once('.') {
        Some((ray, split)) => (ray, split.parse().ok().filter(|split| *split > 0)?),
        None => (word, 0),
    };
    let kind = match ray {
        "C" => RayKind::Camera,
        "R" => RayKind::Reflected,
        "T" => RayKind::Transmitted,
        _ => RayKind::Shadow { light: ray.strip_prefix('S')?.parse::<u32>().ok()?.checked_sub(1)? },
    };
    let is_bounce = matches!(kind, RayKind::Reflected | RayKind::Transmitted);
    ((count == 1 || is_bounce) && (split == 0 || kind != RayKind::Camera)).then_some((PathStep { kind, split }, count))
}

impl fmt::Display for PathPattern {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let steps = self.steps.iter().map(PathStep::to_string);
        let words: Vec<_> = self.sample.map(|number| number.to_string()).into_iter().chain(steps).collect();
        f.write_str(&words.join(" "))
    }
}

impl fmt::Display for PathStep {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.kind.letter())?;
        if let RayKind::Shadow { light } = self.kind {
            write!(f, "{}", light + 1)?;
        }
        if self.split == 0 { Ok(()) } else { write!(f, ".{}", self.split) }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn paths_read_back() {
        for text in ["", "C", "3", "C R T", "3 C R.12 S1.4", "C T T S12"] {
            assert_eq!(text.parse::<PathPattern>().unwrap().to_string(), text);
        }
        assert_eq!("C R×3 S1".parse::<PathPattern>().unwrap().to_string(), "C R R R S1");
    }

    #[test]
    fn other_words_are_no_paths() {
        for text in [
            "R",
            "C C",
            "C X",
            "C S",
            "C S0",
            "C S1 R",
            "C.1",
            "0 C",
            "C R.0",
            "C R.",
            "C R×0",
            "C R×99999",
            "c",
            "C×2",
        ] {
            assert!(text.parse::<PathPattern>().is_err(), "{text}");
        }
    }

    #[test]
    fn numbers_that_are_left_out_stand_for_all() {
        let steps = |text: &str| text.parse::<PathPattern>().unwrap().steps;
        let matches =
            |pattern: &str, sample, path| pattern.parse::<PathPattern>().unwrap().matches(sample, &steps(path));
        assert!(matches("C R S1", 3, "C R.12 S1.4") && matches("3 C R.12", 3, "C R.12") && matches("C", 0, "C"));
        assert!(!matches("2 C R", 3, "C R") && !matches("C R.1", 3, "C R.12") && !matches("C R S2", 0, "C R S1"));
        assert!(!matches("C", 0, "C R") && !matches("C R", 0, "C T"));
        assert_eq!("3 C R.12 S1.4".parse::<PathPattern>().unwrap().of_all().to_string(), "C R S1");
    }
}
