//! Collects findings while it walks down the keys.

use crate::files::{KeyPath, Step};
use crate::scene::file::schema::{Rgb, Vec3};

use super::limits::{MAX_COORDINATE, MAX_PROBLEMS, MAX_RATIO, MIN_LENGTH};
use super::vector::{distance, size};
use super::{Finding, Findings};

/// Findings of a whole scene and the way to where they are being made.
#[derive(Default)]
struct Walk {
    path: KeyPath,
    findings: Findings,
}

/// Checks the values at one place; [`at`](Checker::at) goes deeper and comes back when its result is dropped.
pub struct Checker<'w> {
    walk: Place<'w>,
}

enum Place<'w> {
    Root(Walk),
    Inside(&'w mut Walk),
}

impl Default for Checker<'_> {
    fn default() -> Self {
        Self { walk: Place::Root(Walk::default()) }
    }
}

impl Drop for Checker<'_> {
    fn drop(&mut self) {
        if let Place::Inside(walk) = &mut self.walk {
            walk.path.pop();
        }
    }
}

impl Checker<'_> {
    /// The checker one step deeper.
    pub fn at(&mut self, step: impl Into<Step>) -> Checker<'_> {
        let walk = self.walk();
        walk.path.push(step);
        Checker { walk: Place::Inside(walk) }
    }

    /// What was found.
    pub fn findings(mut self) -> Findings {
        std::mem::take(&mut self.walk().findings)
    }

    /// Something that stops the scene.
    pub fn error(&mut self, message: String) {
        self.add_error(message, false);
    }

    /// Something that stops the scene, in the key that leads here.
    pub fn error_in_key(&mut self, message: String) {
        self.add_error(message, true);
    }

    /// Something odd.
    pub fn warning(&mut self, message: String) {
        self.add_warning(message, false);
    }

    /// Something odd about the key that leads here.
    pub fn warning_in_key(&mut self, message: String) {
        self.add_warning(message, true);
    }

    /// Whether further errors are only counted, so that their messages need no care.
    pub fn is_full(&mut self) -> bool {
        self.walk().findings.errors.len() >= MAX_PROBLEMS
    }

    fn add_error(&mut self, message: String, is_about_key: bool) {
        let walk = self.walk();
        if walk.findings.errors.len() < MAX_PROBLEMS {
            walk.findings.errors.push(Finding { path: walk.path.clone(), message, is_about_key });
        } else {
            walk.findings.omitted += 1;
        }
    }

    fn add_warning(&mut self, message: String, is_about_key: bool) {
        let walk = self.walk();
        if walk.findings.warnings.len() < MAX_PROBLEMS {
            walk.findings.warnings.push(Finding { path: walk.path.clone(), message, is_about_key });
        } else {
            walk.findings.omitted_warnings += 1;
        }
    }

    fn walk(&mut self) -> &mut Walk {
        match &mut self.walk {
            Place::Root(walk) => walk,
            Place::Inside(walk) => walk,
        }
    }

    fn require(&mut self, step: impl Into<Step>, value: f64, holds: bool, rule: &str) {
        if !(holds && value.abs() <= MAX_COORDINATE) {
            let rule = if !value.is_finite() {
                "must be finite"
            } else if value.abs() > MAX_COORDINATE {
                "must be at most 1e100 in size"
            } else {
                rule
            };
            self.at(step).error(format!("{rule}, found {}", number(value)));
        }
    }

    /// A finite number.
    pub fn finite(&mut self, step: impl Into<Step>, value: f64) {
        self.require(step, value, true, "must be finite");
    }

    /// A number above 0.
    pub fn positive(&mut self, step: impl Into<Step>, value: f64) {
        self.require(step, value, value > 0.0, "must be positive");
    }

    /// A number above 0 whose quotients with its like have finite squares.
    pub fn ratio(&mut self, step: impl Into<Step>, value: f64) {
        let holds = value <= 0.0 || (1.0 / MAX_RATIO..=MAX_RATIO).contains(&value);
        let rule = if holds { "must be positive" } else { "must be from 1e-50 to 1e50" };
        self.require(step, value, holds && value > 0.0, rule);
    }

    /// A number from 0.
    pub fn not_negative(&mut self, step: impl Into<Step>, value: f64) {
        self.require(step, value, value >= 0.0, "must be 0 or more");
    }

    /// A number between two others, themselves left out.
    pub fn between(&mut self, step: impl Into<Step>, value: f64, low: f64, high: f64) {
        let rule = format!("must be between {low} and {high}, both excluded");
        self.require(step, value, low < value && value < high, &rule);
    }

    /// A number from −limit to limit.
    pub fn within(&mut self, step: impl Into<Step>, value: f64, limit: f64) {
        let rule = format!("must be from -{limit} to {limit}");
        self.require(step, value, value.abs() <= limit, &rule);
    }

    /// A whole number from `low` to `high`.
    pub fn count(&mut self, step: impl Into<Step>, value: u32, low: u32, high: u32) {
        if !(low..=high).contains(&value) {
            self.at(step).error(format!("must be from {low} to {high}, found {value}"));
        }
    }

    /// Finite coordinates.
    pub fn point(&mut self, step: impl Into<Step>, value: Vec3) {
        self.each(step, value, |check, axis, coordinate| check.finite(axis, coordinate));
    }

    /// Channels from 0 to the limit of all numbers.
    pub fn color(&mut self, step: impl Into<Step>, value: Rgb) {
        self.each(step, value, |check, channel, value| check.not_negative(channel, value));
    }

    /// Components above 0.
    pub fn positive_each(&mut self, step: impl Into<Step>, value: Vec3) {
        self.each(step, value, |check, axis, value| check.positive(axis, value));
    }

    /// A vector that has a direction; says whether it does.
    pub fn direction(&mut self, step: impl Into<Step>, value: Vec3) -> bool {
        let step = step.into();
        self.point(step.clone(), value);
        if value.iter().any(|component| !component.is_finite()) {
            return false;
        }
        let size = size(value);
        let problem = if size == 0.0 {
            "must not be the zero vector".to_string()
        } else if size < MIN_LENGTH {
            format!("must have a length of at least {MIN_LENGTH:e}")
        } else {
            return true;
        };
        self.at(step).error(format!("{problem}, found {}", triple(value)));
        false
    }

    /// A point away from another one, so that there is a direction from that to it; says whether there is.
    pub fn point_away(&mut self, step: impl Into<Step>, point: Vec3, from: Vec3, other: &str) -> bool {
        let step = step.into();
        self.point(step.clone(), point);
        let distance = distance(point, from);
        if !distance.is_finite() {
            return false;
        }
        let problem = if distance == 0.0 {
            format!("must not be {other}, found {}", triple(point))
        } else if distance < MIN_LENGTH {
            format!("must be at least {MIN_LENGTH:e} from {other}, found {}", number(distance))
        } else {
            return true;
        };
        self.at(step).error(problem);
        false
    }

    fn each(&mut self, step: impl Into<Step>, value: [f64; 3], mut component: impl FnMut(&mut Self, usize, f64)) {
        self.walk().path.push(step);
        for (index, value) in value.into_iter().enumerate() {
            component(self, index, value);
        }
        self.walk().path.pop();
    }
}

/// A number as people write it: 1, -0.5, 1e300.
pub fn number(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map(str::to_string).unwrap_or(text)
}

/// A vector as the file writes it.
pub fn triple(value: Vec3) -> String {
    format!("[{}]", value.map(number).join(", "))
}
