//! Whether the numbers of a scene make sense: every problem of a [`SceneFile`], each with its path.
//!
//! This module knows the meaning of keys and the documented [`limits`]. It knows nothing of text and places: a scene may also
//! come from another format or from options of the command line.

pub mod limits;

mod camera;
mod checker;
mod light;
mod material;
mod settings;
mod shape;
pub(super) mod vector;

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use super::schema::{FORMAT, Sampling, SceneFile, digest};
use crate::files::escape::{hidden, look, quoted};
use crate::files::{FileError, KeyPath, Problem};
use checker::Checker;

/// Something about a value of the scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The way to the value.
    pub path: KeyPath,
    /// What is wrong, what was expected.
    pub message: String,
    /// Whether it is about the last key of the path rather than its value.
    pub is_about_key: bool,
}

/// All that validation found.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Findings {
    /// Why the scene cannot be traced, at most [`limits::MAX_PROBLEMS`].
    pub errors: Vec<Finding>,
    /// What is odd, at most [`limits::MAX_PROBLEMS`].
    pub warnings: Vec<Finding>,
    /// How many more errors there are.
    pub omitted: usize,
    /// How many more warnings there are.
    pub omitted_warnings: usize,
}

/// Checks a whole scene; it may be traced when there are no errors.
pub fn validate(scene: &SceneFile) -> Findings {
    let mut check = Checker::default();
    if scene.format != FORMAT {
        check.at("format").error(unknown_format(&scene.format));
    }
    name(check.at("name"), &scene.name);
    camera::camera(check.at("camera"), &scene.camera);
    check.color("ambient", scene.ambient);
    check.color("background", scene.background);
    lights(check.at("lights"), scene);
    materials(check.at("materials"), scene);
    objects(check.at("objects"), scene);
    settings::tracing(check.at("tracing"), &scene.tracing);
    settings::sampling(&mut check.at("sampling"), &scene.sampling);
    if let Some(frames) = &scene.frames {
        settings::frames(check.at("frames"), frames);
    }
    settings::output(check.at("output"), &scene.output);
    check.findings()
}

/// The message for another `format`.
pub fn unknown_format(found: &str) -> String {
    format!("this program reads `{FORMAT}`, found {}", quoted(found))
}

/// The warnings and how many more there are, when there are no errors.
pub(super) fn judge(
    findings: Findings,
    place: impl Fn(&[Finding]) -> Vec<Problem>,
) -> Result<(Vec<Problem>, usize), FileError> {
    if findings.errors.is_empty() {
        return Ok((place(&findings.warnings), findings.omitted_warnings));
    }
    Err(FileError::Invalid { problems: place(&findings.errors), omitted: findings.omitted })
}

/// Checks which rays make a pixel, by itself: what is wrong, with paths that begin at the method.
pub fn sampling(sampling: &Sampling) -> Vec<Finding> {
    let mut check = Checker::default();
    settings::sampling(&mut check, sampling);
    check.findings().errors
}

fn lights(mut check: Checker<'_>, scene: &SceneFile) {
    let mut names = Names::of(scene.lights.iter().map(|light| light.name.as_str()));
    for (index, each) in scene.lights.iter().enumerate() {
        let mut check = check.at(index);
        unique_name(check.at("name"), &each.name, &mut names);
        light::light(&mut check, each);
    }
}

fn materials(mut check: Checker<'_>, scene: &SceneFile) {
    let mut is_used = vec![false; scene.materials.len()];
    let of_objects = scene.objects.iter().filter_map(|object| scene.materials.index_of(object.material.as_ref()?));
    of_objects.for_each(|place| is_used[place] = true);
    let mut names = Names::of(scene.materials.iter().map(|(name, _)| name));
    for ((key, each), is_used) in scene.materials.iter().zip(is_used) {
        let mut check = check.at(key.to_string());
        for problem in names.take(key).into_iter().chain(wrong_name(key)) {
            check.error_in_key(problem);
        }
        if !is_used {
            check.warning_in_key("no object has this material".to_string());
        }
        material::material(&mut check, each);
    }
}

fn objects(mut check: Checker<'_>, scene: &SceneFile) {
    if scene.objects.is_empty() {
        check.warning("no objects: only the background will be seen".to_string());
    }
    let last = scene.frames.map_or(0.0, |frames| frames.duration);
    let times: Vec<_> = scene.camera.shutter.into_iter().flat_map(|time| [time, time + last]).collect();
    let mut names = Names::of(scene.objects.iter().map(|object| object.name.as_str()));
    for (index, object) in scene.objects.iter().enumerate() {
        let mut check = check.at(index);
        unique_name(check.at("name"), &object.name, &mut names);
        shape::shape(check.at("shape"), &object.shape);
        if let Some(name) = &object.material {
            material::reference(check.at("material"), name, &scene.materials);
        }
        if let Some(motion) = &object.motion {
            shape::motion(check.at("motion"), motion, &times);
        }
    }
}

/// Names by what people see of them. Of a million names that all look different no more is kept than it takes to tell that.
struct Names<'s> {
    /// What represents the looks that more than one name has, as far as digests tell.
    shared: HashSet<u64>,
    taken: HashMap<Cow<'s, str>, &'s str>,
}

impl<'s> Names<'s> {
    fn of(names: impl Iterator<Item = &'s str>) -> Names<'s> {
        let mut digests: Vec<u64> = names.map(|name| digest(&look(name))).collect();
        digests.sort_unstable();
        let shared = digests.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]).collect();
        Names { shared, taken: HashMap::new() }
    }

    /// Takes a name, which must look different from those that are taken.
    fn take(&mut self, given: &'s str) -> Option<String> {
        let look = look(given);
        if !self.shared.contains(&digest(&look)) {
            return None;
        }
        let other = self.taken.insert(look, given)?;
        let shown = quoted(given);
        Some(match other == given {
            true => format!("names must be unique, found {shown} a second time"),
            false => format!("names must not look alike, found {shown} beside {}", quoted(other)),
        })
    }
}

fn unique_name<'s>(mut check: Checker<'_>, given: &'s str, names: &mut Names<'s>) {
    if let Some(problem) = names.take(given) {
        check.error(problem);
    }
    name(check, given);
}

fn name(mut check: Checker<'_>, given: &str) {
    if let Some(problem) = wrong_name(given) {
        check.error(problem);
    }
}

fn wrong_name(name: &str) -> Option<String> {
    if name.is_empty() {
        return Some("a name must not be empty".to_string());
    }
    if let Some((at, hidden)) = hidden(name).next() {
        let what = if hidden.is_control() { "control" } else { "invisible" };
        let escaped = hidden.escape_default();
        let before = match at {
            0 => String::new(),
            _ => format!(" behind {}", quoted(&name[..at])),
        };
        return Some(format!("a name must not hold {what} characters, found {escaped}{before}"));
    }
    look(name).is_empty().then(|| "a name must not be blank".to_string())
}
