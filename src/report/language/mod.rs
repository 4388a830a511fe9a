//! Every text that people read in a view of a log, one table a language: a text that a language lacks doesn't compile.
//!
//! Names of a scene go into the texts as they are; whoever writes a format escapes the whole text. Spanish is that of the source
//! text (Ramos, "Trazado de rayos"), with its terms and its decimal commas.

pub mod close_up;
mod en;
mod es;
pub mod viewer;

use super::{Style, number};
use crate::log::{Acceptance, Asking, Miss, Parameter, SkipReason, Skippable, Split, Value};

/// The language of a view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Spanish.
    Spanish,
}

impl Language {
    /// Every language.
    pub const ALL: [Language; 2] = [Language::English, Language::Spanish];

    /// Its texts.
    pub fn texts(self) -> &'static Texts {
        match self {
            Language::English => &en::TEXTS,
            Language::Spanish => &es::TEXTS,
        }
    }

    /// Its code, such as `en`.
    pub fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Spanish => "es",
        }
    }

    /// A number as [`number::number`] writes it, with the language's decimal mark.
    pub fn number(self, x: f64, style: Style) -> String {
        self.marked(number::number(x, style))
    }

    /// A number or triple. Where the decimal mark is a comma, semicolons part the three: `(−0,946; 0,315; 0,079)`.
    pub fn value(self, value: &Value, style: Style) -> String {
        match value {
            Value::Number(x) => self.number(*x, style),
            Value::Triple(xyz) => format!("({})", xyz.map(|x| self.number(x, style)).join(self.texts().separator)),
        }
    }

    /// A parameter of sampling, as exactly as the scene states it.
    pub fn parameter(self, parameter: Parameter) -> String {
        self.marked(parameter.to_string())
    }

    /// A part of a whole, such as `12.5 %`.
    pub fn percent(self, share: f64) -> String {
        self.marked(format!("{:.1} %", 100.0 * share + 0.0))
    }

    /// A number that is written already, with the language's decimal mark.
    pub fn marked(self, text: String) -> String {
        if self.texts().decimal_mark == '.' { text } else { text.replace('.', &self.texts().decimal_mark.to_string()) }
    }
}

/// A text with one name in it.
type OfName = fn(&str) -> String;
/// A text with two names in it.
type OfNames = fn(&str, &str) -> String;

/// The texts of a language.
pub struct Texts {
    /// Before the decimals.
    pub decimal_mark: char,
    /// Between the numbers of a triple.
    pub separator: &'static str,

    // What is walked through.
    /// A pixel by its column and row.
    pub pixel: fn([u32; 2]) -> String,
    /// A region by its sides.
    pub region: fn([u32; 4]) -> String,
    /// A ray by its origin and direction.
    pub ray_along: OfNames,
    /// A method of sampling or one of its parameters by its name in scene files; what isn't known stays as it is.
    pub sampling_word: fn(&str) -> &str,
    /// The depth limit, before its number.
    pub depth: &'static str,
    /// Before inputs, in text.
    pub given: &'static str,
    /// Before the colour, in text.
    pub result: &'static str,
    /// A frame by its number.
    pub frame: fn(u32) -> String,

    // Nodes.
    /// A sample by its number.
    pub sample: fn(u32) -> String,
    /// A ray by its path and what it is for.
    pub ray: OfNames,
    /// The test with an object.
    pub test: OfName,
    /// The test with a triangle of an object.
    pub test_triangle: fn(&str, u32) -> String,
    /// The local model on an object.
    pub local_model: OfName,
    /// A light.
    pub light: OfName,
    /// A point of an area light.
    pub light_point: fn(&str, u32) -> String,
    /// A moving object in its own frame.
    pub motion: OfName,
    /// A zone of a blurred bounce.
    pub zone: fn(Skippable, u32) -> String,
    /// The sum of the three contributions.
    pub weighted_sum: &'static str,
    /// A camera ray.
    pub from_the_eye: &'static str,
    /// A shadow ray to a light.
    pub shadow_ray_to: OfName,
    /// A reflected ray.
    pub reflected: &'static str,
    /// A transmitted ray.
    pub transmitted: &'static str,

    // Decisions.
    /// The object lies on the ray.
    pub hit: &'static str,
    /// It doesn't, and why.
    pub miss: fn(Miss) -> String,
    /// The ray begins outside the solid.
    pub outside: &'static str,
    /// It begins inside.
    pub inside: &'static str,
    /// The nearest object.
    pub nearest: OfName,
    /// An object in the same place as the nearest one, or a triangle of it.
    pub coincident: fn(&str, Option<u32>) -> String,
    /// A medium that the ray begins inside.
    pub immersed: OfName,
    /// Nothing is hit.
    pub background: &'static str,
    /// A shadow ray that nothing stops.
    pub free: &'static str,
    /// Behind a value that was computed with more digits than the others.
    pub twice_the_digits: &'static str,
    /// The object that blocks.
    pub blocked_by: OfName,
    /// The object that a shadow ray passes, and what it keeps.
    pub passes: OfNames,
    /// A pattern that is too fine.
    pub too_fine: OfName,
    /// A quantity without a value.
    pub undefined: OfName,
    /// Total internal reflection.
    pub total_reflection: &'static str,
    /// What the depth limit leaves out.
    pub depth_limit: fn(Skippable) -> String,
    /// The rest of a blocked shadow ray isn't traced.
    pub rest_skipped: &'static str,
    /// What would come through the surface.
    pub leak_guard: fn(Skippable) -> String,
    /// A direction that was bent up above the surface.
    pub bent: fn(Skippable) -> String,
    /// A direction on the wrong side.
    pub rejected: fn(Skippable) -> String,
    /// What is left out, and why.
    pub skipped: fn(Skippable, SkipReason) -> String,
    /// What a decision cost at most.
    pub lost: OfName,
    /// A cell that is the whole pixel.
    pub whole_pixel: &'static str,
    /// A cell by its corner and its side.
    pub cell: fn(&str, &str, &str) -> String,
    /// A cell that is cut in four, and why; the last name is that of an object.
    pub subdivided: fn(&str, Split, &str) -> String,
    /// An object without a name.
    pub an_object: &'static str,
    /// The mean of samples.
    pub mean: &'static str,
    /// What is accepted, and why.
    pub accepted: fn(&str, Acceptance) -> String,
    /// How many points of a light are asked, and why; the last name is that of an object.
    pub asked: fn(&str, Asking, u32, &str) -> String,
    /// How many samples are too few, and how many are taken.
    pub more_samples: fn(u32, u32) -> String,
    /// That the pilots around ask for more samples: how many there are and will be.
    pub more_asked: fn(u32, u32) -> String,
    /// How many digits can be trusted; the counts, and whether they are one single digit.
    pub digits: fn(&str, bool) -> String,
    /// A decision that differs between runs.
    pub decision_differs: &'static str,
    /// A value that hangs on such a decision.
    pub no_digits: &'static str,

    // Where light comes from.
    /// A light on an object.
    pub light_on: OfNames,
    /// Ambient light on an object.
    pub ambient_on: OfName,
    /// The background as a source.
    pub from_background: &'static str,
    /// What the rounding of values adds.
    pub from_rounding: &'static str,
    /// What the operands that a log holds leave unexplained.
    pub unexplained: &'static str,
    /// A light behind the surface.
    pub light_behind: OfName,
    /// A light that an object blocks.
    pub light_blocked: OfNames,
    /// The log ends within a ray.
    pub log_ends: &'static str,
    /// Why a path brings nothing, where nobody knows.
    pub nothing: &'static str,

    /// What a worked solution says beyond that.
    pub solution: Solution,
    /// What a study of roundings says.
    pub causes: Causes,
    /// What figures say.
    pub figure: Figure,
    /// What close-ups say.
    pub close_up: close_up::CloseUp,
    /// What the viewer says.
    pub viewer: viewer::Viewer,
}

/// The texts of a worked solution.
pub struct Solution {
    /// Its title: the subject and the scene.
    pub title: OfNames,
    /// How it was reckoned: arithmetic, algorithm and depth limit.
    pub conditions: fn(&str, &str, u32) -> String,
    /// How a pixel was sampled.
    pub sampled: OfName,
    /// The heading of what the problem states.
    pub data: &'static str,
    /// What is the same for all objects.
    pub everywhere: &'static str,
    /// An object among the data.
    pub object: OfName,
    /// A light among the data.
    pub source: OfName,
    /// The heading of the steps.
    pub steps: &'static str,
    /// Before inputs.
    pub with: &'static str,
    /// The step that makes a ray's direction.
    pub aim: &'static str,
    /// The step that tests an object.
    pub intersection: OfName,
    /// The step that tests a triangle of an object.
    pub intersection_triangle: fn(&str, u32) -> String,
    /// The step that tests a moving object.
    pub intersection_moving: OfName,
    /// The step that finds the point and the normal.
    pub point: &'static str,
    /// The step of the local model on an object.
    pub local: OfName,
    /// The step of the reflected direction.
    pub reflection: &'static str,
    /// The step of the transmitted direction.
    pub transmission: &'static str,
    /// The step of a blurred bounce.
    pub blur: &'static str,
    /// The step of the weighted sum of a ray.
    pub combine: OfName,
    /// The step of choosing samples.
    pub sampling: &'static str,
    /// The steps of a ray go on after those of another.
    pub back: OfName,
    /// The heading of the result.
    pub result: &'static str,
    /// The intensity of the pixel.
    pub conclusion: OfName,
    /// The log has no result.
    pub no_result: &'static str,
    /// The heading of the contributions.
    pub contributions: &'static str,
    /// Their columns: path, origin, class, what it brings, weight, what it adds, share.
    pub columns: [&'static str; 7],
    /// The sum of all of them.
    pub sum: &'static str,
    /// So many smaller ones.
    pub smaller: fn(usize) -> String,
    /// The heading of what brings nothing.
    pub brings_nothing: &'static str,
    /// So many more of those.
    pub more: fn(usize) -> String,
    /// The section of the source text that has a quantity.
    pub section: OfName,
    /// Opens all parts.
    pub open_all: &'static str,
    /// Closes them.
    pub close_all: &'static str,
}

/// The texts of a study of roundings.
pub struct Causes {
    /// The result of the arithmetic that rounds.
    pub rounded: &'static str,
    /// The result in f64.
    pub exact: &'static str,
    /// How far the two are apart.
    pub off: &'static str,
    /// How far they may be expected to be.
    pub expected: &'static str,
    /// From how many runs that is known.
    pub of_runs: fn(u32) -> String,
    /// Rounding changes the ray tree.
    pub other_tree: &'static str,
    /// The columns: only the quantity rounded, all but it, its name, where it stands.
    pub columns: [&'static str; 4],
    /// So many quantities have no effect.
    pub idle: fn(usize) -> String,
    /// What the star behind a change means.
    pub star: &'static str,
}

/// The texts of figures.
pub struct Figure {
    /// The title of the ray tree.
    pub ray_tree: &'static str,
    /// The title of the call tree.
    pub call_tree: &'static str,
    /// The title of the schematic.
    pub schematic: &'static str,
    /// Along which two axes the schematic is drawn.
    pub plane: OfNames,
    /// The root of the ray tree.
    pub eye: &'static str,
    /// Where a ray that meets nothing ends.
    pub background: &'static str,
    /// A shadow ray that doesn't reach its light, by the object.
    pub blocked: OfName,
    /// The tree has too many rays to be drawn in the text.
    pub too_many: fn(usize) -> String,
    /// Only the first sample is drawn.
    pub first_sample: fn(usize) -> String,
    /// What the width of a line means.
    pub width: &'static str,
    /// The kinds of rays: from the eye, reflected, transmitted, shadow, blocked shadow.
    pub kinds: [&'static str; 5],
    /// A ray that adds this to the pixel.
    pub adds: fn(&str, &str) -> String,
    /// There is no ray to be drawn.
    pub no_rays: &'static str,
}
