//! In which arithmetic and by which formulas cases are answered.

use super::watch::Watch;
use crate::geometry::Ray;
use crate::geometry::shape::SphereMethod;
use crate::log::Name;
use crate::probe::{Alteration, Altered, Decimal, Erased, Probe, Single};
use crate::record::Arithmetic;
use crate::scene::Formulas;
use glam::DVec3;

/// A way to compute: an arithmetic and a choice of formulas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// f64, f32 or by hand.
    arithmetic: Arithmetic,
    /// Those that keep their digits, or those of the notes, with the geometric sphere.
    formulas: Formulas,
}

impl Way {
    /// The program's own way: f64 with formulas that keep their digits.
    pub const OWN: Way = Way { arithmetic: Arithmetic::F64, formulas: Formulas::Robust };

    /// The ways that a report shows beside the program's own: the formulas of the notes in f64, f32, and the notes by hand.
    pub fn others(decimals: u32) -> [Way; 3] {
        [
            Way { formulas: Formulas::Notes, ..Way::OWN },
            Way { arithmetic: Arithmetic::F32, ..Way::OWN },
            Way { arithmetic: Arithmetic::Decimal(decimals), formulas: Formulas::Notes },
        ]
    }

    /// Its arithmetic.
    pub fn arithmetic(&self) -> Arithmetic {
        self.arithmetic
    }

    /// Its formulas.
    pub fn formulas(&self) -> Formulas {
        self.formulas
    }

    /// What it is called at the head of a column.
    pub fn name(&self) -> String {
        match (self.arithmetic, self.formulas) {
            (Arithmetic::F64, Formulas::Notes) => "notes".to_owned(),
            (arithmetic, _) => arithmetic.to_string(),
        }
    }

    /// By which formulas it meets spheres.
    pub(super) fn sphere_method(&self) -> SphereMethod {
        match self.formulas {
            Formulas::Robust => SphereMethod::Robust,
            Formulas::Notes => SphereMethod::Geometric,
        }
    }

    /// Whether the answers to an operation depend on the way: input is judged, and samples are added up, before and behind all arithmetic.
    pub(super) fn has_a_say_in(&self, op: &str) -> bool {
        *self == Way::OWN || !matches!(op, "invalid" | "mean")
    }

    /// What a computation gives in this arithmetic, and what was noted.
    pub(super) fn watched<T>(&self, computation: impl FnOnce(&mut Erased) -> T) -> (T, Watch) {
        match self.arithmetic {
            Arithmetic::F32 => altered(Single, computation),
            Arithmetic::Decimal(digits) => altered(Decimal::new(digits), computation),
            _ => {
                let mut watch = Watch::default();
                let result = computation(&mut Erased::of(&mut watch));
                (result, watch)
            }
        }
    }

    /// The same for who wants the result only.
    pub(super) fn computed<T>(&self, computation: impl FnOnce(&mut Erased) -> T) -> T {
        self.watched(computation).0
    }

    /// The ray with the direction that this arithmetic makes of its own.
    pub(super) fn ray(&self, ray: Ray) -> Ray {
        if *self == Way::OWN {
            return ray;
        }
        let direction = self.computed(|probe| probe.note(Name::RayDirection, ray.direction));
        // Few digits may leave nothing of it.
        if direction == ray.direction || direction == DVec3::ZERO {
            ray
        } else {
            Ray { direction, vector: direction, ..ray }
        }
    }
}

fn altered<T>(alteration: impl Alteration, computation: impl FnOnce(&mut Erased) -> T) -> (T, Watch) {
    let mut altered = Altered { alteration, probe: Watch::default() };
    let result = computation(&mut Erased::of(&mut altered));
    (result, altered.probe)
}
