//! docs/notes.md and docs/notes.es.md: every command of the table runs, every file of it exists, and every number of the errata is right.

use crate::calls::{prints, raywalk};
use crate::support::{changed_scene, scene};
use glam::DVec3;
use raywalk::log::{RayKind, Step, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::study::textbook;
use std::fs;
use std::path::Path;

const PAGES: [&str; 2] = ["docs/notes.md", "docs/notes.es.md"];

fn page(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).expect("a page")
}

/// The rows of the table of what is implemented: section, what, file, command.
fn rows(name: &str) -> Vec<[String; 4]> {
    let text = page(name);
    let cells = |line: &str| {
        let cells: Vec<_> = line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
        <[String; 4]>::try_from(cells).expect("four cells")
    };
    text.lines().filter(|line| line.starts_with('|') && line.contains("`raywalk ")).map(cells).collect()
}

/// What a row is there to show: a part of its `what`, and a text that its command prints.
const SHOWN: [(&str, &str); 13] = [
    ("its weight is zero", "skipped: reflected ray (its weight is zero)"),
    ("vectors L, N, R, T, V, H", ">R</text>"),
    ("vectors L, N, R, T, V, H", ">T</text>"),
    ("vectors L, N, R, T, V, H", ">H</text>"),
    ("H′ of a light behind", ">H′</text>"),
    ("H′ of a light behind", ">H</text>"),
    ("semitransparent blocker", "= (0.810, 0.0625, 0.0400)   [shadow.transmittance 1.2.5]"),
    ("a sample stands for all of its pixel", "+ (0.950, 0.900, 0.800) + … + (0.250, 0.350, 0.600))/16 ="),
    ("stairs on curves", "nearest: flat profile"),
    ("stairs on curves", "nothing is hit: background"),
    ("objects that samples miss", "the pixel is subdivided: C may lie in it, and no corner sees that"),
    ("its quality adjustable", "32 are taken"),
    ("its quality adjustable", "the mean is accepted: its interval is narrow enough"),
];

#[test]
fn commands_of_the_table_show_what_their_rows_say() {
    let rows = rows(PAGES[0]);
    for (part, text) in SHOWN {
        let row = rows.iter().find(|[_, what, ..]| what.contains(part));
        let [.., command] = row.unwrap_or_else(|| panic!("no row has {part}"));
        let words: Vec<_> = command.trim_matches('`').split_whitespace().skip(1).collect();
        let shown = prints(&words);
        assert!(shown.contains(text), "{command} doesn't show {text}");
    }
}

#[test]
fn the_weights_of_the_shadow_rays_of_the_table_differ() {
    let rows = rows(PAGES[0]);
    let [.., command] = rows.iter().find(|[_, what, ..]| what.contains("the weights of those")).expect("the row");
    let words: Vec<_> = command.trim_matches('`').split_whitespace().skip(1).collect();
    let table = prints(&words);
    let weights: Vec<_> = table
        .lines()
        .filter(|line| line.starts_with(|first: char| first.is_ascii_digit()))
        .filter_map(|line| line.split(')').nth(1)?.split_whitespace().next())
        .collect();
    assert_eq!(weights.len(), 9, "{table}");
    assert!(weights.iter().all(|weight| *weight != "0.111"), "{table}");
    assert!(weights.windows(2).all(|pair| pair[0] != pair[1]), "{table}");
}

#[test]
fn every_command_of_the_table_runs_and_prints_something() {
    for name in PAGES {
        let rows = rows(name);
        assert!(rows.len() > 40, "{name}: {} rows", rows.len());
        for [section, what, file, command] in rows {
            let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(file.trim_matches('`'));
            assert!(source.exists(), "{name}: {file}");
            let words: Vec<_> = command.trim_matches('`').split_whitespace().skip(1).collect();
            let output = raywalk(&words).output().expect("it runs");
            assert!(output.status.success(), "{section} {what}: {}", String::from_utf8_lossy(&output.stderr));
            assert!(!output.stdout.is_empty(), "{section} {what}: nothing is printed");
        }
    }
}

#[test]
fn both_pages_have_the_same_commands() {
    let commands = |name| {
        let plain = |[_, _, file, command]: [String; 4]| (file, command.replace("--lang es ", ""));
        rows(name).into_iter().map(plain).collect::<Vec<_>>()
    };
    assert_eq!(commands(PAGES[0]), commands(PAGES[1]));
}

/// Three decimals as the pages write them, with the sign of mathematics; a whole zero stays short.
fn number(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { format!("{x:.3}").replace('-', "−") }
}

fn triple(vector: DVec3) -> String {
    format!("({})", vector.to_array().map(number).join(", "))
}

/// Both pages have this text after that one, in their own notation.
#[track_caller]
fn says(before: &str, text: &str) {
    for name in PAGES {
        let page = page(name);
        let (_, rest) = page.split_once(before).unwrap_or_else(|| panic!("{name} lacks {before}"));
        let rest = rest.split("\n\n").next().unwrap_or(rest).replace('\n', " ");
        let text = if name.ends_with(".es.md") { text.replace(", ", "; ").replace('.', ",") } else { text.to_owned() };
        assert!(rest.contains(&text), "{name}: {text} isn't in {rest}");
    }
}

/// The normal, and the direction to a light at 60°.
fn at_60_degrees() -> (DVec3, DVec3) {
    let half = 0.5;
    (DVec3::Y, DVec3::new((1.0_f64 - half * half).sqrt(), half, 0.0))
}

#[test]
fn the_first_mirrored_vector_has_no_unit_length() {
    let (normal, toward) = at_60_degrees();
    let cosine = normal.dot(toward);
    let first = toward + normal * (2.0 * cosine);
    let second = normal * (2.0 * cosine) - toward;
    assert!((first.length() - (1.0 + 8.0 * cosine * cosine).sqrt()).abs() < 1e-15);
    for text in [triple(toward), triple(first), number(first.length()), triple(second)] {
        says("**`R = L + 2N cos φ` (1.2.1)", &text);
    }
    // With the incident direction it is right.
    assert!((-toward + normal * (2.0 * cosine) - second).length() < 1e-15);
}

/// T = L/η − (cosφ₂ − cosφ₁/η)N.
fn transmitted(l: DVec3, normal: DVec3, eta: f64, cos_1: f64) -> DVec3 {
    let cos_2 = (1.0 - (1.0 - cos_1 * cos_1) / (eta * eta)).sqrt();
    l / eta - normal * (cos_2 - cos_1 / eta)
}

#[test]
fn the_equation_of_t_wants_the_incident_direction() {
    let (normal, across) = at_60_degrees();
    // The light is on the left, so that its light runs to the right.
    let toward = DVec3::new(-across.x, across.y, 0.0);
    let right = transmitted(-toward, normal, 1.5, 0.5);
    let wrong = transmitted(toward, normal, 1.5, 0.5);
    assert!((right.length() - 1.0).abs() < 1e-15);
    // Snell's law.
    assert!((right.x * 1.5 - across.x).abs() < 1e-15);
    for text in [triple(-toward), triple(right), triple(toward), triple(wrong), number(wrong.length())] {
        says("T (1.2.2).**", &text);
    }
}

#[test]
fn the_two_forms_of_h() {
    let (normal, across) = at_60_degrees();
    // As in the erratum about T, the light is on the left.
    let toward = DVec3::new(-across.x, across.y, 0.0);
    let eta = 1.5;
    let view = transmitted(-toward, normal, eta, 0.5);
    let first = (-toward - view * eta) / (eta - 1.0);
    says("**`H′`", &number(first.length()));
    let power = libm::pow(first.length(), 50.0);
    assert!((power / 1e8 - 1.1).abs() < 0.1, "{power}");
    says("**`H′`", "1.1·10⁸");
    let inverse = 1.0 / eta;
    let second = (view - -toward * inverse) / (inverse - 1.0);
    assert!((first - second).length() < 1e-15, "{first} is not {second}");
    let with_the_same_signs = (view - toward * eta) / (eta - 1.0);
    for text in [triple(toward), triple(view), triple(with_the_same_signs)] {
        says("(−L − ηV)/(η − 1), ", &text);
    }
    // What roundings leave of its sideways part.
    assert!(first.x.abs() < 1e-15);
    says("(−L − ηV)/(η − 1), ", &triple(DVec3::new(0.0, first.y, 0.0)));
    // Neither bisector has its direction.
    for light in [toward, -toward] {
        let bisector = (light + view).normalize();
        says("(1.2.1).** ", &triple(bisector));
        says("(1.2.1).** ", &format!("{:.1}°", libm::acos(-bisector.dot(normal)).to_degrees()));
    }
}

#[test]
fn shadow_rays_grow_linearly() {
    let counts = [1, 2, 4, 8].map(|lights: usize| {
        let scene = changed_scene("textbook", |file| {
            let lamp = file.lights[0].clone();
            file.lights = (0..lights)
                .map(|number| raywalk::scene::file::schema::Light { name: format!("F{number}").into(), ..lamp.clone() })
                .collect();
        });
        let log = record::pixel(&scene, [160, 120], Arithmetic::F64);
        let is_shadow = |step: Option<Step>| matches!(step, Some(Step::Ray { kind: RayKind::Shadow { .. }, .. }));
        Tree::of(&log.events).nodes().iter().filter(|node| is_shadow(node.step)).count()
    });
    assert_eq!(counts, [2, 4, 8, 16]);
    for name in PAGES {
        let text = page(name);
        assert!(text.contains("2, 4, 8 and 16") || text.contains("2, 4, 8 y 16"), "{name}");
    }
}

#[test]
fn slips_of_the_numeric_example() {
    let origin = DVec3::new(16.0, 2.0, 7.0);
    let vector = DVec3::new(-12.0, 4.0, 1.0);
    let v_d = -0.946;
    let t = |from: DVec3| -(DVec3::X.dot(from) - 4.0) / v_d;
    assert!((t(origin) - 12.685).abs() < 5e-4);
    says("`P₀`", &number(t(vector)));
    let direction = DVec3::new(-0.946, 0.315, 0.079);
    let mirrored = direction - DVec3::X * (2.0 * direction.dot(DVec3::X));
    says("`R_d·N = (a, 0, 0)`.**", &triple(mirrored));
    says("`R_d1`", &triple(-mirrored));
    let by_the_rule = |step: &str, quantity: &str| {
        let table = textbook::table(textbook::Example::Textbook, &scene("textbook"));
        let row = table.steps.iter().find(|row| row.step == step && row.quantity == quantity).expect("a row");
        row.recomputed.clone()
    };
    assert_eq!(by_the_rule("3", "hit.point"), [4.0, 5.996, 8.002]);
    assert_eq!(by_the_rule("8", "half.direction"), [0.9, 0.143, 0.411]);
    assert_eq!(by_the_rule("7", "shade.local"), [289.186]);
    assert!((0.637_f64 / 1.548 - 0.411_499).abs() < 5e-7);
    assert_eq!(format!("{:.3}", 104.838 + 289.186), "394.024");
    for name in PAGES {
        let text = page(name).replace(',', ".");
        for number in ["394.024", "394.028", "289.186", "0.411499", "394.134", "393.054", "158.871", "335.418"] {
            assert!(text.contains(number), "{name}: {number}");
        }
    }
}
