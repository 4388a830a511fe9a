//! What a line shows is what was computed: the numbers put in, read back as a formula, give the shown result, as far as the
//! rounding of the shown numbers tells.
//!
//! Every number that is read stands for all that are rounded to it, and the formula is evaluated on these intervals.

use crate::intervals::agrees;
use crate::notations::{of_html, of_tex};
use crate::random_scenes;
use crate::support;
use raywalk::log::formula::QUANTILE;
use raywalk::log::{Log, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::report::language::Language;
use raywalk::report::schematic::Stage;
use raywalk::report::solution::{Task, html, latex, markdown};
use raywalk::report::{Style, computation};
use raywalk::scene::builtin;

#[test]
fn shown_lines_read_back() {
    let mut read = 0;
    for arithmetic in [Arithmetic::F64, Arithmetic::Decimal(3), Arithmetic::DecimalProducts(3), Arithmetic::F32] {
        for name in builtin::names() {
            let scene = support::scene(name);
            for pixel in support::grid(&scene, 4) {
                read += check(&record::pixel(&scene, pixel, arithmetic), arithmetic);
            }
        }
        for seed in 0..40 {
            let scene = random_scenes::scene(seed);
            for pixel in [[2, 2], [4, 3], [6, 5]] {
                read += check(&record::pixel(&scene, pixel, arithmetic), arithmetic);
            }
        }
    }
    assert!(read > 20_000, "{read} lines");
}

#[test]
fn the_issue_s_lines_are_bracketed() {
    let scene = support::scene("motion-blur");
    let log = record::pixel(&scene, [60, 40], Arithmetic::F64);
    let tree = Tree::of(&log.events);
    let lines: Vec<_> = (0..log.events.len())
        .filter_map(|event| computation(Language::English, &log, &tree, event, Style::default()))
        .filter_map(|computation| computation.substituted)
        .collect();
    assert!(!lines.iter().any(|line| line.contains("/1.000·10") || line.contains("⁻⁵²")), "{lines:#?}");
}

/// Where the products of dot products are rounded they are shown so: step 7 of the source text.
#[test]
fn rounded_products_are_shown() {
    let scene = support::scene_in("textbook", Arithmetic::DecimalProducts(3));
    let log = record::pixel(&scene, [160, 120], Arithmetic::DecimalProducts(3));
    let tree = Tree::of(&log.events);
    let lines = (0..log.events.len())
        .filter_map(|event| computation(Language::English, &log, &tree, event, Style::default()))
        .filter(|computation| computation.symbol == "N·L")
        .map(|computation| computation.line());
    let lines: Vec<_> = lines.collect();
    assert_eq!(lines[1], "N·L = 0.533 + 0.035 + 0.220 = 0.788");
}

#[test]
fn a_wrong_line_is_found() {
    for (line, result, is_right) in [
        ("9 − 178.024 + 13.244²", "6.379", true),
        ("9 − 178.024 + 13.244²", "6.579", false),
        ("9 − 25 + (5.000·10⁻⁵)²", "-16.000", true),
        ("-12/1.000·10⁻⁵", "-1.200·10⁶", false),
        ("-12/(1.000·10⁻⁵)", "-1.200·10⁶", true),
        ("√(4)·(1, 2, 3)", "(2, 4, 6)", true),
        ("√(4)·(1, 2, 3)", "(2, 4, 7)", false),
        ("|(3, 4, 0)|²", "25", true),
        ("min(1, 1/(0.500 + 0.100·2))", "1", true),
    ] {
        assert_eq!(agrees(line, result, '.', 0.0).unwrap_or(false), is_right, "{line} = {result}");
    }
}

/// The worked solutions put in the same numbers, in their own notations.
#[test]
fn worked_solutions_read_back() {
    let mut read = [0; 3];
    let scenes = builtin::names().map(support::scene).chain((0..20).map(random_scenes::scene));
    for scene in scenes {
        let log = record::pixel(&scene, support::middle(&scene), Arithmetic::F64);
        // What is written out in full takes long.
        if log.events.len() > 4000 {
            continue;
        }
        let tree = Tree::of(&log.events);
        for (language, mark) in [(Language::English, '.'), (Language::Spanish, ',')] {
            let stage = Stage { wireframes: &[], upright: 1 };
            let task = Task { log: &log, tree: &tree, stage, language, style: Style::default() };
            let texts = [of_tex(&markdown(&task)), of_tex(&latex(&task)), of_html(&html(&task))];
            for (format, equations) in texts.iter().enumerate() {
                for (line, result) in equations {
                    let verdict = agrees(line, result, mark, 0.0);
                    assert_eq!(verdict, Ok(true), "{}, {format}: {line} = {result}", scene.name);
                    read[format] += 1;
                }
            }
        }
    }
    assert!(read.iter().all(|read| *read > 1000), "{read:?}");
}

/// Reads all lines of a log in both languages; how many there were.
fn check(log: &Log, arithmetic: Arithmetic) -> usize {
    // By hand a value was rounded before it was shown; in single precision it may have become zero.
    let rounding = match arithmetic {
        Arithmetic::Decimal(_) | Arithmetic::DecimalProducts(_) => 5.001e-4,
        Arithmetic::F32 => f64::from(f32::MIN_POSITIVE),
        _ => 0.0,
    };
    let tree = Tree::of(&log.events);
    let mut read = 0;
    for (language, mark) in [(Language::English, '.'), (Language::Spanish, ',')] {
        for event in 0..log.events.len() {
            for digits in [3, 1] {
                let Some(computation) = computation(language, log, &tree, event, Style::default().with(digits)) else {
                    continue;
                };
                let Some(line) = computation.substituted else { continue };
                // What is left out of a long sum can't be read, and quantiles have tests of their own.
                if line.contains('…') || line.starts_with(QUANTILE) {
                    continue;
                }
                let verdict = agrees(&line, &computation.result, mark, rounding);
                let place = || format!("{}, event {event}: {}", log.header.scene.name, computation.symbol);
                assert_eq!(verdict, Ok(true), "{}: {line} = {}", place(), computation.result);
                read += 1;
            }
        }
    }
    read
}
