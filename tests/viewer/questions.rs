//! Where people got stuck: which rounding caused the error, the example on paper, and what is asked for in the first minutes.

use crate::frames::usual;
use crate::support::{scene, snapshots};
use assert_cmd::Command;
use raywalk::log::{Log, Name, RayKind, Subject, What};
use raywalk::record::{self, Arithmetic, Part};
use raywalk::report::causes::Study;
use raywalk::report::language::Language;
use raywalk::report::paper::Paper;
use raywalk::study::rounding::{self, Rounding};
use raywalk::study::textbook::{Example, table};
use raywalk::tui::{self, Live, Model, Palette, Refusal, Theme, dump::dump};

/// The numeric example, by hand.
struct ByHand;

const MIDDLE: [u32; 2] = [160, 120];

impl Live for ByHand {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        Ok(record::pixel(&scene("textbook"), pixel, Arithmetic::Decimal(3)))
    }

    fn compare(&mut self, _: Subject) -> Result<Vec<Log>, Refusal> {
        let arithmetics = [Arithmetic::Decimal(3), Arithmetic::F32, Arithmetic::F64, Arithmetic::Perturbed(0)];
        Ok(arithmetics.map(|arithmetic| record::pixel(&scene("textbook"), MIDDLE, arithmetic)).into())
    }

    fn study(&mut self, _: Subject, _: Option<&str>) -> Result<Study, Refusal> {
        rounding::study(&scene("textbook"), Part::Pixel(MIDDLE), Rounding::Decimal(3)).map_err(|_| Refusal::NoMemory)
    }

    fn book(&mut self, subject: Subject) -> Result<Paper, Refusal> {
        let example = Example::Textbook;
        match subject {
            Subject::Pixel(MIDDLE) => {
                Ok(Paper { scene: example.scene(), rows: table(example, &scene("textbook")).steps })
            }
            _ => Err(Refusal::NoExample),
        }
    }
}

fn model_after(keys: &str, language: Language, size: (u16, u16)) -> Model {
    let theme = Theme::new(Palette::None, false);
    let options = usual(theme, language);
    let log = record::pixel(&scene("textbook"), MIDDLE, Arithmetic::Decimal(3));
    tui::opened_with_keys(log, &options, Some(&mut ByHand), keys, size)
}

fn frame_in(language: Language, keys: &str, (width, height): (u16, u16)) -> String {
    dump(&tui::frame(&model_after(keys, language, (width, height)), width, height, &Theme::new(Palette::None, false)))
}

/// After these keys the numeric example is at this quantity of the ray with this path.
#[track_caller]
fn leads_to(keys: &str, path: &str, name: Name) {
    let model = model_after(keys, Language::English, (100, 30));
    let What::Note { name: found, .. } = model.log.events[model.event].what else { panic!("no value after {keys}") };
    assert_eq!((model.tree.path(model.cursor).as_str(), found.key()), (path, name.key()), "after {keys}");
    assert_eq!(model.overlay, None, "after {keys}");
}

/// The lists in both languages at three sizes.
fn frames(name: &str, keys: &str) {
    snapshots().bind(|| {
        for (language, code) in [(Language::English, ""), (Language::Spanish, "_es")] {
            for (width, height) in [(40, 12), (80, 24), (140, 40)] {
                let frame = frame_in(language, keys, (width, height));
                insta::assert_snapshot!(format!("viewer_{name}_{width}x{height}{code}"), frame);
            }
        }
    });
}

#[test]
fn which_rounding_caused_the_error() {
    frames("causes", "W");
    // The greatest first: of the camera ray's direction, of the reflected one, and so on.
    leads_to("W Enter", "C", Name::RayDirection);
    leads_to("W j Enter", "C", Name::ReflectDirection);
    leads_to(":causes Enter j Enter ^o W Enter", "C", Name::RayDirection);
    let shown = frame_in(Language::English, "W", (140, 40));
    for expected in ["rounded    (394.134,", "in f64     (393.054,", "off by     (+1.080,"] {
        assert!(shown.contains(expected), "{expected}\n{shown}");
    }
    // A quiz doesn't tell, and neither does a tree that grows.
    for keys in ["Q W", "t W", "Q :book Enter", "t :book Enter"] {
        assert_eq!(model_after(keys, Language::English, (100, 30)).overlay, None, "after {keys}");
    }
}

#[test]
fn the_example_as_it_is_printed() {
    frames("book", ":book Enter");
    leads_to(":book Enter Enter", "C", Name::RayLength);
    leads_to(":book Enter 11j Enter", "C R", Name::SphereT2a);
    // The book shades the sphere before the plane.
    leads_to(":book Enter 15j Enter", "C R", Name::LightVector);
    leads_to(":book Enter G Enter", "C", Name::CombineColor);
    let model = model_after("k :book Enter", Language::English, (100, 30));
    assert!(model.overlay.is_some());
    let elsewhere = model_after(":pixel 3,4 Enter :book Enter", Language::English, (100, 30));
    let said = elsewhere.message.as_ref().map(|message| message.text.as_str()).unwrap_or_default();
    assert!(elsewhere.overlay.is_none() && said.starts_with("no book has this pixel"), "{said}");
}

#[test]
fn the_pixel_s_colour_in_all_arithmetics() {
    let shown = frame_in(Language::English, "g a", (140, 40));
    for expected in ["colour 1  394.134", "393.0543292251"] {
        assert!(shown.contains(expected), "{expected}\n{shown}");
    }
}

/// The rows of the tree, from its first on, without the lines before them.
fn rows(model: &Model) -> Vec<String> {
    let nodes = std::iter::successors(Some(0), |row| model.fold.below(&model.tree, *row));
    nodes.map(|node| model.title(node)).collect()
}

#[test]
fn without_tests_the_tree_is_that_of_figure_7() {
    let figure = [
        "pixel 160,120",
        "ray C, from the eye",
        "local model on plane",
        "light F",
        "ray C S1, shadow ray to F",
        "ray C R, reflected",
        "local model on sphere",
        "light F",
        "ray C R S1, shadow ray to F",
        "weighted sum",
        "weighted sum",
    ];
    let model = model_after("T", Language::English, (100, 30));
    assert_eq!(rows(&model), figure);
    let everything = rows(&model_after("T T", Language::English, (100, 30)));
    assert_eq!(everything.len(), model.tree.nodes().len());
    let tests = everything.iter().filter(|row| row.starts_with("test ")).count();
    assert_eq!(everything.len() - tests, figure.len());
    // What one steps to is seen all the same, and the filter goes with it.
    let at_test = model_after("T 3n", Language::English, (100, 30));
    assert_eq!(rows(&at_test).len(), figure.len() + 1);
    let reflected = ["pixel 160,120", "ray C, from the eye", "ray C R, reflected"];
    let sum = ["local model on sphere", "light F", "ray C R S1, shadow ray to F", "weighted sum"];
    let filtered = rows(&model_after("T f reflected Enter", Language::English, (100, 30)));
    assert_eq!(filtered, [reflected.as_slice(), sum.as_slice()].concat());
    let in_spanish = rows(&model_after("f reflected Enter T", Language::Spanish, (100, 30)));
    assert_eq!(in_spanish.len(), filtered.len());
    frames("no_tests", "T");
}

#[test]
fn a_filter_leaves_what_is_transmitted() {
    let text = scene("figure-8");
    let pixel = text.camera.resolution.map(|side| side / 2);
    let log = record::pixel(&text, pixel, Arithmetic::F64);
    let theme = Theme::new(Palette::None, false);
    let options = usual(theme, Language::English);
    let model = tui::opened_with_keys(log, &options, None, "f transmitted Enter E", (100, 30));
    let is_brought = |node: usize| model.tree.around(node).any(|at| model.tree.ray(at) == Some(RayKind::Transmitted));
    let shown: Vec<_> = std::iter::successors(Some(0), |row| model.fold.below(&model.tree, *row)).collect();
    let around = |node: usize| (node..model.tree.nodes()[node].subtree_end).any(is_brought);
    assert!(shown.iter().all(|node| is_brought(*node) || around(*node)));
    let brought = (0..model.tree.nodes().len()).filter(|node| is_brought(*node)).count();
    assert_eq!(shown.iter().filter(|node| is_brought(**node)).count(), brought);
    assert!(brought > 5, "{brought}");
}

#[test]
fn symbols_are_explained() {
    // At T2_A it comes first.
    let shown = frame_in(Language::English, "/ T2_A Enter V", (140, 40));
    let lines: Vec<_> = shown.lines().skip_while(|line| !line.contains("Here:")).collect();
    let expected = "square of half the chord; negative if the ray passes beside the sphere";
    assert!(lines[1].contains("T2_A") && lines[1].contains(expected), "{shown}");
    leads_to("/ T2_A Enter V Enter", "C", Name::SphereT2a);
    for keys in ["V", "F2", ":glossary Enter"] {
        let whole = frame_in(Language::English, keys, (140, 120));
        for expected in ["V_d", "normal · direction; 0 if", "L(D|S)E", "class of a path of light", "Here:", "Signs:"] {
            assert!(whole.contains(expected), "{expected} after {keys}\n{whole}");
        }
    }
    // In a quiz only what was computed is there.
    assert!(!frame_in(Language::English, "Q V", (140, 120)).contains("T2_A"));
    frames("glossary", "V");
}

#[test]
fn hints_are_those_of_the_pane_and_the_mode() {
    let bottom = |keys: &str, width: u16| {
        let frame = frame_in(Language::English, keys, (width, 40));
        frame.lines().nth(39).unwrap_or_default().to_owned()
    };
    let in_tree = bottom("", 140);
    for hint in ["w why  d made of  a digits  / find  b break  T no tests", "? help  q quit"] {
        assert!(in_tree.contains(hint), "{in_tree}");
    }
    assert!(bottom("Tab", 140).contains("n next value  d made of  D used in"), "{}", bottom("Tab", 140));
    assert!(bottom("/ plane Enter", 140).contains("; next  , previous  n next value"));
    assert!(bottom("Q n", 140).contains("= answer  Q end"));
    assert!(bottom("", 40).ends_with("? help  q quit"), "{}", bottom("", 40));
    assert!(bottom("/ plane Enter", 80).contains("; next  , previous"), "{}", bottom("/ plane Enter", 80));
    for (keys, width, expected) in [
        ("zo", 80, "raywalk: pixel 160,120 of textbook, 98 steps - decimal:3"),
        ("zo", 60, "raywalk: pixel 160,120 of textbook - decimal:3"),
        ("", 200, "pixel 160,120 of textbook - decimal:3"),
        ("zo", 40, "raywalk: textbook - decimal:3"),
        ("", 80, "textbook - decimal:3"),
    ] {
        let shown = frame_in(Language::English, keys, (width, 40));
        assert!(shown.lines().next().is_some_and(|title| title.contains(expected)), "{expected}\n{shown}");
    }
}

/// The program itself, with the scene behind the viewer or a saved log.
#[test]
fn the_program_answers_the_same_questions() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("saved.ndjson").to_string_lossy().into_owned();
    let raywalk = || Command::new(assert_cmd::cargo::cargo_bin!("raywalk"));
    raywalk().args(["trace", "textbook", "--pixel", "160,120", "-o", &log]).assert().success();
    let shows = |walk: &[&str], keys: &str, expected: &str| {
        let picture = folder.path().join("shown.svg");
        let size = ["--screen", "140,50", "--screenshot"];
        raywalk().arg("walk").args(walk).args(["--keys", keys]).args(size).arg(&picture).assert().success();
        let shown = std::fs::read_to_string(&picture).expect("a picture");
        assert!(shown.contains(expected), "{expected} after {keys} in {walk:?}");
        shown
    };
    shows(&["textbook"], ":book<Enter>", "The example on paper: textbook");
    shows(&["refraction"], ":book<Enter>", "The example on paper: refraction");
    shows(&[&log], ":book<Enter>", "The example on paper: textbook");
    shows(&[&log], "W", "a saved log has no scene to trace");
    shows(&[&log], "a", "a saved log has no scene to trace");
    // In another size it is another scene.
    let small = ["textbook", "--size=33x25"];
    shows(&small, ":book<Enter>", "no book has this pixel as its example");
    shows(&small, "W", "Which rounding caused the error, decimal:3");
    shows(&[small[0], small[1], "--arithmetic=f32"], "W", "Which rounding caused the error, f32");
    // In the scene's own white most of it would be white; who asks for an exposure gets it.
    shows(&small, "<BackTab>zo", "above white: shown -");
    let bright = shows(&[small[0], small[1], "--exposure=1"], "<BackTab>zo", "16,12");
    assert!(!bright.contains("above white"), "{bright}");
}
