//! The book's own numbers: where the printed example departs from its rules, the computation goes on with what it prints.

use super::{Alteration, Quantity, altered::round_half_away};
use crate::log::{Name, RayKind, Step};

/// The decimals of the printed example.
const DIGITS: u32 = 3;

/// What the numeric example (Ramos, section 1.3) prints: the ray's path, the quantity's key, its components.
///
/// The intensities are printed for red only.
const PRINTED: &[(&str, &str, &[f64])] = &[
    ("C", "ray.length", &[12.689]),
    ("C", "ray.direction", &[-0.946, 0.315, 0.079]),
    ("C", "plane.v_d", &[-0.946]),
    ("C", "plane.v_o", &[-12.0]),
    ("C", "plane.t", &[12.685]),
    ("C", "hit.point", &[4.0, 6.0, 8.0]),
    ("C", "reflect.direction", &[0.946, 0.315, 0.079]),
    ("C R", "sphere.oc", &[13.0, 3.0, 0.0]),
    ("C R", "sphere.l2_oc", &[178.0]),
    ("C R", "sphere.t_a", &[13.243]),
    ("C R", "sphere.t2_a", &[6.377]),
    ("C R", "sphere.t", &[10.718]),
    ("C R", "hit.point", &[14.139, 9.376, 8.847]),
    ("C R", "hit.normal", &[-0.954, 0.125, 0.282]),
    ("C R", "light.vector", &[-5.139, 2.624, 7.153]),
    ("C R", "light.distance", &[9.190]),
    ("C R", "light.direction", &[-0.559, 0.286, 0.778]),
    ("C R", "view.direction", &[-0.946, -0.315, -0.079]),
    ("C R", "half.sum", &[-1.505, -0.029, 0.699]),
    ("C R", "half.length", &[1.66]),
    ("C R", "half.direction", &[-0.907, -0.017, 0.421]),
    ("C R", "shade.n_dot_l", &[0.788]),
    ("C R", "shade.n_dot_h", &[0.982]),
    ("C R", "shade.local", &[289.19]),
    ("C", "view.direction", &[0.946, -0.315, -0.079]),
    ("C", "light.vector", &[5.0, 6.0, 8.0]),
    ("C", "light.distance", &[11.180]),
    ("C", "light.direction", &[0.447, 0.537, 0.716]),
    ("C", "half.sum", &[1.393, 0.222, 0.637]),
    ("C", "half.length", &[1.548]),
    ("C", "half.direction", &[0.9, 0.143, 0.412]),
    ("C", "shade.n_dot_l", &[0.447]),
    ("C", "shade.n_dot_h", &[0.9]),
    ("C", "shade.local", &[104.838]),
    ("C", "combine.color", &[394.028]),
];

/// Replaces each quantity by what the book prints for it; the rest is rounded to 3 decimals, as the book does.
#[derive(Clone, Debug, Default)]
pub struct Printed {
    /// The paths of the open nodes.
    paths: Vec<String>,
}

impl Printed {
    /// What the book prints for a quantity of the ray with this path: one component, three, or red only.
    pub fn of(path: &str, key: &str) -> Option<&'static [f64]> {
        PRINTED.iter().find(|(of, printed, _)| *of == path && *printed == key).map(|(_, _, value)| *value)
    }

    /// Everything that the book prints: the ray's path, the quantity's key and its components, in the book's order.
    pub fn all() -> impl Iterator<Item = (&'static str, &'static str, &'static [f64])> {
        PRINTED.iter().copied()
    }
}

impl Alteration for Printed {
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let path = self.paths.last().map_or("", String::as_str);
        // The book tests the sphere with the reflected ray only; shadow rays carry a path of their own.
        let printed = Printed::of(path, name.key()).unwrap_or_default();
        value.map(|index, x| printed.get(index).copied().unwrap_or_else(|| round_half_away(x, DIGITS)))
    }

    fn enter(&mut self, step: Step) {
        let path = self.paths.last().map_or("", String::as_str);
        self.paths.push(match step {
            Step::Ray { kind: RayKind::Shadow { .. }, .. } => format!("{path} S"),
            _ => crate::log::tree::path_of_child(path, step),
        });
    }

    fn leave(&mut self) {
        self.paths.pop();
    }
}
