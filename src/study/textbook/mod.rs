//! The numeric example of the source text (Ramos, section 1.3): printed, following the book, by hand from the start, and
//! exact, side by side.

mod example;
mod follow;
mod views;
mod worked;

pub use example::Example;
pub use worked::{Checked, CheckedRow, MAX_TABLE_BYTES, Order, TableError, Worked};

use crate::probe::PrintedValue;
use crate::record::{self, Arithmetic};
pub use crate::report::paper::{Row, Verdict};
use crate::scene::{Formulas, Scene, Tracing};
use example::Line;
use follow::{Listed, Place, Values};

/// The decimals of the printed example.
const DIGITS: u32 = 3;

/// The table: each printed quantity in the book's order.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Which example it is of.
    pub example: Example,
    /// The rows.
    pub steps: Vec<Row>,
}

/// What the book calls each printed quantity, in the order of [`Printed::all`].
const CALLED: &[&str] = &[
    "|R_d|",
    "R_d",
    "V_d",
    "V_o",
    "t",
    "P_1",
    "R_d1",
    "OC",
    "L_2oc",
    "T_A",
    "T_2Ai",
    "t_i",
    "P_2",
    "N_2",
    "F − P_2",
    "|F − P_2|",
    "L_2",
    "V_1",
    "L_2 + V_1",
    "|L_2 + V_1|",
    "H_2",
    "N_2·L_2",
    "N_2·H_2",
    "I_local-2 (red)",
    "V_0",
    "F − P_1",
    "|F − P_1|",
    "L_1",
    "L_1 + V_0",
    "|L_1 + V_0|",
    "H_1",
    "N_1·L_1",
    "N_1·H_1",
    "I_local-1 (red)",
    "I_global (red)",
];

/// Why the book departs from its own rules, where it does: path, quantity, reason.
const REASONS: &[(&str, &str, &str)] = &[
    ("C", "hit.point", "the book prints the exact point (4, 6, 8); its own R_d and t, rounded, give (4, 5.996, 8.002)"),
    ("C", "half.direction", "0.637/1.548 = 0.41150 rounds to 0.411; no effect, because N_1 = (1, 0, 0)"),
    ("C R", "shade.local", "printed with two decimals: 54 + 86.68 + 154·0.964324 = 289.186"),
];

/// Computes the table of an example on its scene, which was built for a computation by hand.
pub fn table(example: Example, scene: &Scene) -> Table {
    let pixel = middle(scene);
    let by_hand = |arithmetic| Values::of(&record::pixel(scene, pixel, arithmetic));
    let strict = by_hand(Arithmetic::Decimal(DIGITS));
    let strict_products = by_hand(Arithmetic::DecimalProducts(DIGITS));
    let exact = exact(scene, pixel);
    let listed: Listed = example.lines().iter().map(|line| (line.place(), line.printed.components.clone())).collect();
    let recomputed = Values::following(scene, pixel, &listed);
    let row = |line: &'static Line| {
        let printed = &line.printed;
        // Of colours only red is printed.
        let components = |values: &Values| values.components(&line.place(), printed.components.len());
        let recomputed = components(&recomputed);
        Row {
            step: printed.step,
            called: line.called,
            quantity: printed.key,
            number: line.nth,
            printed,
            verdict: verdict(printed, &recomputed),
            recomputed,
            strict: components(&strict),
            strict_products: components(&strict_products),
            exact: components(&exact),
        }
    };
    Table { example, steps: example.lines().iter().map(row).collect() }
}

/// The values in f64, by the robust formulas.
fn exact(scene: &Scene, pixel: [u32; 2]) -> Values {
    let tracing = Tracing { formulas: Formulas::Robust, ..scene.tracing.clone() };
    Values::of(&record::pixel(&Scene { tracing, ..scene.clone() }, pixel, Arithmetic::F64))
}

/// The pixel of the example.
fn middle(scene: &Scene) -> [u32; 2] {
    scene.camera.resolution.map(|side| side / 2)
}

/// Where a printed quantity is in the walk.
fn place_of(printed: &PrintedValue) -> Place {
    Place { path: printed.path.to_owned(), key: printed.key, nth: 0 }
}

fn verdict(printed: &PrintedValue, recomputed: &[f64]) -> Verdict {
    if printed.components != recomputed {
        let reason = REASONS.iter().find(|(path, key, _)| *path == printed.path && *key == printed.key);
        return Verdict::Departs { why: reason.map_or("the rules of the book give another number", |(_, _, why)| why) };
    }
    agreement(printed.text)
}

/// The verdict on a text that has the right numbers.
fn agreement(text: &str) -> Verdict {
    let mut numbers = text.trim_matches(['(', ')']).split(',').map(str::trim);
    if numbers.all(has_the_books_digits) { Verdict::Agrees } else { Verdict::Format }
}

/// Whether a number is printed whole or with all three decimals.
fn has_the_books_digits(text: &str) -> bool {
    text.split_once('.').is_none_or(|(_, decimals)| decimals.len() == DIGITS as usize)
}
