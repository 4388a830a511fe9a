//! The book's own numbers: where the printed example departs from its rules, the computation goes on with what it prints.

use super::{Alteration, Quantity};
use crate::log::{Name, Step, round_half_away, tree::path_of_child};
use std::sync::LazyLock;

/// The decimals of the printed example.
const DIGITS: u32 = 3;

/// What the numeric example (Ramos, section 1.3) prints, in its order and with its digits: the ray's path, the
/// quantity's key, the step of the calculation, the text. The intensities are printed for red only.
const PRINTED: &[(&str, &str, &str, &str)] = &[
    ("C", "ray.length", "1", "12.689"),
    ("C", "ray.direction", "1", "(-0.946, 0.315, 0.079)"),
    ("C", "plane.v_d", "2", "-0.946"),
    ("C", "plane.v_o", "2", "-12"),
    ("C", "plane.t", "2", "12.685"),
    ("C", "hit.point", "3", "(4, 6, 8)"),
    ("C", "reflect.direction", "4", "(0.946, 0.315, 0.079)"),
    ("C R", "sphere.oc", "5a", "(13, 3, 0)"),
    ("C R", "sphere.l2_oc", "5a", "178"),
    ("C R", "sphere.t_a", "5b", "13.243"),
    ("C R", "sphere.t2_a", "5d", "6.377"),
    ("C R", "sphere.t", "5e", "10.718"),
    ("C R", "hit.point", "5f", "(14.139, 9.376, 8.847)"),
    ("C R", "hit.normal", "5g", "(-0.954, 0.125, 0.282)"),
    ("C R", "light.vector", "6", "(-5.139, 2.624, 7.153)"),
    ("C R", "light.distance", "6", "9.190"),
    ("C R", "light.direction", "6", "(-0.559, 0.286, 0.778)"),
    ("C R", "view.direction", "6", "(-0.946, -0.315, -0.079)"),
    ("C R", "half.sum", "6", "(-1.505, -0.029, 0.699)"),
    ("C R", "half.length", "6", "1.66"),
    ("C R", "half.direction", "6", "(-0.907, -0.017, 0.421)"),
    ("C R", "shade.n_dot_l", "7", "0.788"),
    ("C R", "shade.n_dot_h", "7", "0.982"),
    ("C R", "shade.local", "7", "289.19"),
    ("C", "view.direction", "8", "(0.946, -0.315, -0.079)"),
    ("C", "light.vector", "8", "(5, 6, 8)"),
    ("C", "light.distance", "8", "11.180"),
    ("C", "light.direction", "8", "(0.447, 0.537, 0.716)"),
    ("C", "half.sum", "8", "(1.393, 0.222, 0.637)"),
    ("C", "half.length", "8", "1.548"),
    ("C", "half.direction", "8", "(0.9, 0.143, 0.412)"),
    ("C", "shade.n_dot_l", "8", "0.447"),
    ("C", "shade.n_dot_h", "8", "0.9"),
    ("C", "shade.local", "8", "104.838"),
    ("C", "combine.color", "8", "394.028"),
];

/// A value as the book prints it.
#[derive(Clone, Debug, PartialEq)]
pub struct PrintedValue {
    /// The path of the ray that it belongs to.
    pub path: &'static str,
    /// The key of the quantity.
    pub key: &'static str,
    /// The step of the book's calculation, such as `5d`.
    pub step: &'static str,
    /// The text, such as `1.66` or `(4, 6, 8)`.
    pub text: &'static str,
    /// Its numbers: one component, three, or red only.
    pub components: Vec<f64>,
}

/// Replaces each quantity by what the book prints for it; the rest is rounded to 3 decimals, as the book does.
#[derive(Clone, Debug, Default)]
pub struct Printed {
    /// The paths of the open nodes.
    paths: Vec<String>,
}

impl Printed {
    /// What the book prints for a quantity of the ray with this path.
    pub fn of(path: &str, key: &str) -> Option<&'static PrintedValue> {
        Printed::all().iter().find(|printed| printed.path == path && printed.key == key)
    }

    /// Everything that the book prints, in its order.
    pub fn all() -> &'static [PrintedValue] {
        static VALUES: LazyLock<Vec<PrintedValue>> = LazyLock::new(|| {
            let value = |&(path, key, step, text): &(&'static str, &'static str, &'static str, &'static str)| {
                let numbers = text.trim_matches(['(', ')']).split(", ");
                PrintedValue {
                    path,
                    key,
                    step,
                    text,
                    components: numbers.filter_map(|number| number.parse().ok()).collect(),
                }
            };
            PRINTED.iter().map(value).collect()
        });
        &VALUES
    }

    /// The path of the ray in whose node the computation is. Shadow rays have paths of their own.
    pub fn path(&self) -> &str {
        self.paths.last().map_or("", String::as_str)
    }
}

impl Alteration for Printed {
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let printed = Printed::of(self.path(), name.key()).map_or(&[][..], |printed| &printed.components);
        value.map(|index, x| printed.get(index).copied().unwrap_or_else(|| round_half_away(x, DIGITS)))
    }

    fn enter(&mut self, step: Step) {
        self.paths.push(path_of_child(self.path(), step));
    }

    fn leave(&mut self) {
        self.paths.pop();
    }
}
