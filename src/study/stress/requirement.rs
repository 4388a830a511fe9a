//! What is required of each family.

use crate::log::words::words;

words! {
    /// How errors are measured.
    pub Unit {
        /// In the distance of two neighbouring f64 at the exact answer.
        Ulp = "ulp",
        /// In k: the error over 2⁻⁵³ times the answer times the case's condition number.
        K = "k",
        /// In 2⁻⁵², of vectors of unit length.
        Epsilon = "2^-52",
        /// As a part of the answer.
        Relative = "relative",
        /// There is nothing to measure: only decisions count.
        None = "",
    }
}

/// What is required of the cases of a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Requirement {
    /// How errors are measured.
    pub unit: Unit,
    /// The greatest error.
    pub limit: f64,
    /// The answers that must be equal: hits, order, identity.
    pub decisions: &'static [&'static str],
    /// The answers whose error is measured.
    pub numbers: &'static [&'static str],
    /// Answers of which only a coarse agreement is asked; the error counts as a wrong decision.
    pub coarse: &'static [&'static str],
}

impl Requirement {
    const fn new(unit: Unit, limit: f64, decisions: &'static [&'static str], numbers: &'static [&'static str]) -> Self {
        Requirement { unit, limit, decisions, numbers, coarse: &[] }
    }
}

/// The relative error of a coarse answer.
pub const COARSE: f64 = 1e-6;

/// The requirement of a family; one that isn't known by its number is measured by its operation.
pub fn requirement(family: &str, op: &str) -> Requirement {
    use Unit::{Epsilon, K, Relative, Ulp};
    let number = family.split('_').next().unwrap_or_default();
    match (number, op) {
        ("f02", _) => Requirement::new(K, 0.05, &["hit"], &["t"]),
        ("f04", _) => Requirement::new(K, 1.0, &["hit"], &["t"]),
        (_, "spawn") => Requirement { coarse: &["t", "exit"], ..Requirement::new(Unit::None, 0.0, &[], &[]) },
        (_, "spheres") => Requirement::new(Ulp, 4.0, &["order"], &["t"]),
        (_, "refract") => Requirement::new(K, 4.0, &["tir"], &["cos2"]),
        (_, "refract_hprime") => Requirement::new(Epsilon, 2.0, &[], &["T", "h"]),
        (_, "power") => Requirement::new(K, 2.0, &[], &["y"]),
        (_, "power of a number") => Requirement::new(Ulp, 1.0, &[], &["y"]),
        (_, "mesh" | "nearest") => Requirement::new(Ulp, 4.0, &["hit", "ids"], &["t"]),
        (_, "stack") => Requirement::new(Epsilon, 32.0, &["interfaces"], &["T"]),
        (_, "invalid") => Requirement::new(Unit::None, 0.0, &["expect"], &[]),
        (_, "ellipsoid") => Requirement::new(K, 4.0, &["hit"], &["t"]),
        (_, "visible") => Requirement::new(Unit::None, 0.0, &["visible"], &[]),
        (_, "local") => Requirement::new(Relative, 1e-12, &[], &["H", "R"]),
        (_, "scene") => Requirement::new(Relative, 1e-11, &[], &["rays"]),
        (_, "mean") => Requirement::new(Ulp, 1.0, &[], &["mean"]),
        // `sphere`, `plane`, `triangle`: one shape.
        _ => Requirement::new(Ulp, 4.0, &["hit"], &["t"]),
    }
}
