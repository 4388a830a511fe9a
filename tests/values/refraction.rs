//! The second worked example against arithmetic that is written out here, with plain rounding and without the tracer.

use crate::support::{changed_scene, middle, scene, snapshots};
use raywalk::log::{Tree, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::language::Language;
use raywalk::report::{Style, text};
use raywalk::scene::file::schema::Formulas;
use raywalk::study::textbook::{self, Example, Table, Verdict};
use std::cell::Cell;

type Triple = [f64; 3];

/// A person who rounds every number to three decimals, and how near the nearest of them came to a tie, in units of the last decimal.
struct Person {
    nearest_tie: Cell<f64>,
}

impl Person {
    fn rounds(&self, x: f64) -> f64 {
        let scaled = (x * 1000.0).abs();
        let from_tie = (scaled - scaled.floor() - 0.5).abs();
        self.nearest_tie.set(self.nearest_tie.get().min(from_tie));
        x.signum() * (scaled + 0.5).floor() / 1000.0
    }

    fn rounds_each(&self, triple: Triple) -> Triple {
        triple.map(|x| self.rounds(x))
    }
}

fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn plus(a: Triple, b: Triple) -> Triple {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn times(a: Triple, x: f64) -> Triple {
    a.map(|component| component * x)
}

fn minus(a: Triple, b: Triple) -> Triple {
    plus(a, times(b, -1.0))
}

/// The sheet as it is filled in: the steps in their order, each with its name and its numbers.
struct Sheet {
    person: Person,
    rows: Vec<(&'static str, &'static str, Vec<f64>)>,
}

impl Sheet {
    fn number(&mut self, step: &'static str, name: &'static str, x: f64) -> f64 {
        let x = self.person.rounds(x);
        self.rows.push((step, name, vec![x]));
        x
    }

    fn triple(&mut self, step: &'static str, name: &'static str, triple: Triple) -> Triple {
        let triple = self.person.rounds_each(triple);
        self.rows.push((step, name, triple.to_vec()));
        triple
    }
}

const EYE: Triple = [1.0, 2.0, 0.0];
const VECTOR: Triple = [8.0, -1.0, 4.0];
const CENTER: Triple = [8.0, 1.0, 5.0];
const BALL: f64 = 3.0;
const BUBBLE: f64 = 1.0;
const LIGHTS: [Triple; 2] = [[6.0, 4.0, 8.0], [28.0, 4.0, -1.0]];
const GLASS: f64 = 1.6;

#[rustfmt::skip]
fn by_hand() -> Sheet {
    let mut s = Sheet { person: Person { nearest_tie: Cell::new(f64::MAX) }, rows: Vec::new() };
    // 1 The ray.
    let length = s.number("1", "|R_d|", dot(VECTOR, VECTOR).sqrt());
    let d0 = s.triple("1", "R_d", times(VECTOR, 1.0 / length));
    // 2 The ball: the nearer crossing.
    let oc = s.triple("2a", "OC", minus(CENTER, EYE));
    let l2 = s.number("2a", "L_2oc", dot(oc, oc));
    let ta = s.number("2b", "T_A", dot(oc, d0));
    assert!(l2 > BALL * BALL && ta > 0.0, "the ray begins outside and the ball lies before it");
    let t2 = s.number("2d", "T_2A", BALL * BALL - l2 + ta * ta);
    let t = s.number("2e", "t", ta - t2.sqrt());
    let p1 = s.triple("2f", "P_1", plus(EYE, times(d0, t)));
    let n1 = s.triple("2g", "N_1", times(minus(p1, CENTER), 1.0 / BALL));
    // It passes the bubble.
    assert!(BUBBLE * BUBBLE - l2 + ta * ta < 0.0);
    // 3 Refraction into the glass.
    let eta = s.number("3", "η", GLASS);
    let c1 = s.number("3", "cos φ_1", -dot(n1, d0));
    let c2 = s.number("3", "cos φ_2", (1.0 - (1.0 - c1 * c1) / (eta * eta)).sqrt());
    let t1 = minus(times(d0, 1.0 / eta), times(n1, c2 - c1 / eta));
    let t1 = s.triple("3", "T_1", times(t1, 1.0 / dot(t1, t1).sqrt()));
    // 4 The bubble.
    let oc = s.triple("4a", "OC", minus(CENTER, p1));
    let l2 = s.number("4a", "L_2oc", dot(oc, oc));
    let ta = s.number("4b", "T_A", dot(oc, t1));
    assert!(l2 > BUBBLE * BUBBLE && ta > 0.0);
    let t2 = s.number("4d", "T_2A", BUBBLE * BUBBLE - l2 + ta * ta);
    let t = s.number("4e", "t", ta - t2.sqrt());
    let p2 = s.triple("4f", "P_2", plus(p1, times(t1, t)));
    let n2 = s.triple("4g", "N_2", times(minus(p2, CENTER), 1.0 / BUBBLE));
    // 5 Total reflection.
    let eta = s.number("5", "η", 1.0 / GLASS);
    let c1 = s.number("5", "cos φ_1", -dot(n2, t1));
    assert!(1.0 - (1.0 - c1 * c1) / (eta * eta) < 0.0, "there is no transmitted ray");
    let r2 = minus(t1, times(n2, 2.0 * dot(t1, n2)));
    let r2 = s.triple("5", "R_2", times(r2, 1.0 / dot(r2, r2).sqrt()));
    // 6 The ball from inside: the farther crossing, the normal turned inward.
    let oc = s.triple("6a", "OC", minus(CENTER, p2));
    let l2 = s.number("6a", "L_2oc", dot(oc, oc));
    let ta = s.number("6b", "T_A", dot(oc, r2));
    assert!(l2 < BALL * BALL, "the ray begins inside");
    let t2 = s.number("6d", "T_2A", BALL * BALL - l2 + ta * ta);
    let t = s.number("6e", "t", ta + t2.sqrt());
    let p3 = s.triple("6f", "P_3", plus(p2, times(r2, t)));
    let n3 = s.triple("6g", "N_3", times(minus(CENTER, p3), 1.0 / BALL));
    // 7 Refraction out of the glass.
    let eta = s.number("7", "η", 1.0 / GLASS);
    let c1 = s.number("7", "cos φ_1", -dot(n3, r2));
    let c2 = s.number("7", "cos φ_2", (1.0 - (1.0 - c1 * c1) / (eta * eta)).sqrt());
    let t3 = minus(times(r2, 1.0 / eta), times(n3, c2 - c1 / eta));
    let t3 = s.triple("7", "T_3", times(t3, 1.0 / dot(t3, t3).sqrt()));
    // 8 The screen, x = 14.
    let n4 = [-1.0, 0.0, 0.0];
    let vd = s.number("8", "V_d", dot(n4, t3));
    let vo = s.number("8", "V_o", -(dot(n4, p3) + 14.0));
    let t = s.number("8", "t", vo / vd);
    let p4 = s.triple("8", "P_4", plus(p3, times(t3, t)));
    s.triple("8", "N_4", n4);
    let v = s.triple("9", "V_4", times(t3, -1.0));
    // 10, 11 The light in front, through the ball: two surfaces keep 0.8 of red each.
    let l1 = s.triple("10", "F_1 − P_4", minus(LIGHTS[0], p4));
    let distance = s.number("10", "|F_1 − P_4|", dot(l1, l1).sqrt());
    let l1 = s.triple("10", "L_1", times(l1, 1.0 / distance));
    let n_l1 = s.number("10", "N_4·L_1", dot(n4, l1));
    let oc = s.person.rounds_each(minus(CENTER, p4));
    let beside = dot(oc, oc) - dot(oc, l1) * dot(oc, l1);
    assert!(n_l1 > 0.0 && beside < BALL * BALL && beside > BUBBLE * BUBBLE, "through the glass, past the bubble");
    let tau = s.triple("10", "τ_1", [0.8 * 0.8, 0.9 * 0.9, 0.7 * 0.7]);
    let h = s.triple("11", "L_1 + V_4", plus(l1, v));
    let length = s.number("11", "|L_1 + V_4|", dot(h, h).sqrt());
    let h = s.triple("11", "H_4", times(h, 1.0 / length));
    let n_h = s.number("11", "N_4·H_4", dot(n4, h));
    // 12, 13 The light behind the screen.
    let l2 = s.triple("12", "F_2 − P_4", minus(LIGHTS[1], p4));
    let distance = s.number("12", "|F_2 − P_4|", dot(l2, l2).sqrt());
    let l2 = s.triple("12", "L_2", times(l2, 1.0 / distance));
    let n_l2 = s.number("12", "N_4·L_2", dot(n4, l2));
    assert!(n_l2 < 0.0, "it stands behind");
    let eta = s.number("13", "η", 1.0 / 1.6);
    let h = s.triple("13", "h′", times(plus(l2, times(v, eta)), -1.0 / (eta - 1.0)));
    let length = s.number("13", "|h′|", dot(h, h).sqrt());
    let h = s.triple("13", "H′_4", times(h, 1.0 / length));
    let n_h2 = s.number("13", "−N_4·H′_4", -dot(n4, h));
    // 14, 15 Red.
    let front = 220.0 * tau[0] * (0.5 * n_l1 + 0.3 * libm::pow(n_h, 8.0));
    let behind = 200.0 * 0.6 * libm::pow(n_h2, 4.0);
    let i4 = s.number("14", "I_local-4 (red)", 180.0 * 0.2 + front + behind);
    let i3 = s.number("15", "I_3 (red)", 0.8 * i4);
    let i2 = s.number("15", "I_2 (red)", 0.9 * i3);
    s.number("15", "I_1 (red)", 0.8 * i2);
    s
}

fn table() -> Table {
    textbook::table(
        Example::Refraction,
        &changed_scene("refraction", |file| file.tracing.formulas = Some(Formulas::Notes)),
    )
}

#[track_caller]
fn are_equal(what: &str, found: &[f64], expected: &[f64]) {
    let is_same = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(is_same, "{what}: {found:?} is not {expected:?}");
}

#[test]
fn a_person_gets_the_sheet_and_so_does_the_program() {
    let sheet = by_hand();
    let table = table();
    assert_eq!(table.steps.len(), sheet.rows.len());
    for (row, (step, name, numbers)) in table.steps.iter().zip(&sheet.rows) {
        assert_eq!((row.step, row.called), (*step, *name));
        are_equal(name, &row.printed.components, numbers);
        are_equal(name, &row.recomputed, numbers);
        are_equal(name, &row.strict, numbers);
        assert_eq!(row.verdict, Verdict::Agrees, "{name}");
    }
    // No number lies so near to a tie that the noise of f64, or a slip in the last digit of an operand's own noise, could turn it.
    assert!(sheet.person.nearest_tie.get() > 0.03, "{}", sheet.person.nearest_tie.get());
    assert_eq!(table.steps.last().map(|row| row.strict.clone()), Some(vec![90.285]));
}

/// Three decimals lead to the right result: by hand it errs by a thousandth.
#[test]
fn by_hand_is_near_the_exact_result() {
    for row in &table().steps {
        for (by_hand, exact) in row.strict.iter().zip(&row.exact) {
            assert!((by_hand - exact).abs() <= 0.03 * exact.abs().max(0.3), "{}: {by_hand}, {exact}", row.called);
        }
    }
}

#[test]
fn snapshots_of_the_second_example() {
    let scene = changed_scene("refraction", |file| file.tracing.formulas = Some(Formulas::Notes));
    let log = record::pixel(&scene, middle(&scene), Arithmetic::Decimal(3));
    let marks = |wanted: &str| {
        let is_wanted =
            |what: &What| matches!(what, What::Mark(decision) if format!("{decision:?}").starts_with(wanted));
        log.events.iter().filter(|event| is_wanted(&event.what)).count()
    };
    assert_eq!((marks("TotalInternalReflection"), marks("Attenuated")), (1, 2));
    assert_eq!(Tree::of(&log.events).path(1), "C");
    let table = table();
    snapshots().bind(|| {
        insta::assert_snapshot!("refraction_table", table.text());
        insta::assert_snapshot!("refraction_table_markdown", table.markdown());
        insta::assert_snapshot!("refraction_walk_by_hand", text::text(Language::English, &log, Style::default()));
    });
}

/// The robust formulas in f64 and those of the notes say the same.
#[test]
fn both_kinds_of_formulas_agree_in_f64() {
    let robust = scene("refraction");
    let notes = changed_scene("refraction", |file| file.tracing.formulas = Some(Formulas::Notes));
    let [a, b] = [&robust, &notes].map(|scene| record::pixel_color(scene, middle(scene), Arithmetic::F64));
    assert!((a - b).abs().max_element() < 1e-10, "{a} is not {b}");
}
