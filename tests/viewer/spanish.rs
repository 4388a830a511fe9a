//! The viewer in Spanish: its frames, and that none of them says anything in English.

mod keys;

use crate::frames::usual;
use crate::source::{SourceFile, files_below};
use crate::support::{scene, snapshots};
use assert_cmd::Command;
use keys::{EVERYWHERE, LINES};
use raywalk::log::{Log, Subject};
use raywalk::record::{self, Arithmetic, Part};
use raywalk::report::language::Language;
use raywalk::tui::{self, Dot, Image, Live, Options, Palette, Refusal, Theme, Wanted, dump::dump};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

/// The numeric example with a picture, in Spanish.
struct Example;

impl Live for Example {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        match pixel {
            [160, 120] => Ok(by_hand()),
            [0, _] => Err(Refusal::OnePixelPrinted),
            [1, _] => Err(Refusal::TooLong(1 << 20)),
            [_, 0] => Err(Refusal::NoMemory),
            _ => Err(Refusal::RegionsNotCompared),
        }
    }

    fn picture(&mut self, _: Wanted) -> Option<Arc<Image>> {
        let mut image = Image::empty([320, 240], Arc::new(|color, _| color.map(|part| (255.0 * part) as u8)));
        image.dots.fill(Some(Dot {
            color: [0.25; 3],
            depth: Some(12.75),
            rays: 3,
            samples: 1,
            error: Some(1.5e-7),
            ..Dot::default()
        }));
        Some(Arc::new(image))
    }

    fn compare(&mut self, _: Subject) -> Result<Vec<Log>, Refusal> {
        let arithmetics = [Arithmetic::Decimal(3), Arithmetic::F32, Arithmetic::F64, Arithmetic::Perturbed(0)];
        let log = |arithmetic| record::bounded(&scene("textbook"), Part::Pixel([160, 120]), arithmetic);
        arithmetics.into_iter().map(|arithmetic| log(arithmetic).map_err(|_| Refusal::NoMemory)).collect()
    }
}

fn by_hand() -> Log {
    record::pixel(&scene("textbook"), [160, 120], Arithmetic::Decimal(3))
}

fn options(palette: Palette, ascii: bool) -> Options {
    usual(Theme::new(palette, ascii), Language::Spanish)
}

/// The frame of a log after these keys, with a scene behind it or without.
fn frame_of(log: Log, live: bool, keys: &str, size: (u16, u16), options: &Options) -> String {
    let mut example = Example;
    let live = live.then_some(&mut example as &mut dyn Live);
    let model = tui::opened_with_keys(log, options, live, keys, size);
    dump(&tui::frame(&model, size.0, size.1, &options.theme))
}

/// The frame of the numeric example after these keys.
fn frame_after(keys: &str, size: (u16, u16)) -> String {
    frame_of(by_hand(), false, keys, size, &options(Palette::Indexed, false))
}

#[test]
fn frames_in_spanish() {
    snapshots().bind(|| {
        insta::assert_snapshot!("viewer_es_80x24", frame_after("28n", (80, 24)));
        insta::assert_snapshot!("viewer_es_200x60", frame_after("28n", (200, 60)));
        insta::assert_snapshot!("viewer_es_40x12", frame_after("28n", (40, 12)));
        insta::assert_snapshot!("viewer_es_help", frame_after("?", (100, 120)));
        let lines = "bhit Enter bT2_A<0,5 Enter bobject sphere Enter";
        insta::assert_snapshot!("viewer_es_breakpoints", frame_after(&format!("{lines} B j Space"), (80, 24)));
        insta::assert_snapshot!("viewer_es_stops", frame_after(&format!("{lines} 3r L"), (80, 24)));
        insta::assert_snapshot!("viewer_es_why", frame_after("w", (120, 24)));
        insta::assert_snapshot!("viewer_es_operands", frame_after("31n d", (80, 24)));
        insta::assert_snapshot!("viewer_es_quiz", frame_after("Q 4n = 12,5 Enter = 1 Enter", (80, 24)));
        let live = |keys: &str| frame_of(by_hand(), true, keys, (80, 24), &options(Palette::Indexed, false));
        insta::assert_snapshot!("viewer_es_arithmetics", live("3n a"));
    });
}

#[test]
fn ascii_keeps_the_letters_of_spanish_words() {
    let options = options(Palette::None, true);
    for keys in ["28n", "?", "w", "B", "Q", ":x Enter"] {
        let frame = frame_of(by_hand(), true, keys, (100, 40), &options);
        assert!(frame.is_ascii(), "{frame}");
    }
    let help = frame_of(by_hand(), true, "?", (100, 40), &options);
    assert!(help.contains("Recorrer el calculo paso a paso"), "{help}");
}

#[test]
fn the_language_is_changed_while_one_looks() {
    let text = |keys: &str| frame_after(keys, (80, 24)).split("styles:").next().map(str::to_owned).unwrap_or_default();
    assert_eq!(text(":lang en Enter :lang es Enter Esc"), text(""));
    assert!(text(":lang en Enter").contains("in English"));
    assert!(text(":lang fr Enter").contains("se espera un idioma"));
    // A search looks for the words and the numbers of the other language then.
    let searched = "/13,24 Enter";
    assert!(text(searched).contains("coincidencia 1/"), "{}", text(searched));
    assert!(text(&format!("{searched} :lang en Enter")).contains("match -/0"));
}

#[test]
fn the_walk_as_text_is_the_log_as_text() {
    let said = |arguments: &[&str]| {
        let output = Command::new(assert_cmd::cargo::cargo_bin!("raywalk")).args(arguments).assert().success();
        String::from_utf8(output.get_output().stdout.clone()).expect("text")
    };
    let walk = said(&["walk", "textbook", "--plain", "--lang", "es"]);
    assert_eq!(walk, said(&["trace", "textbook", "--pixel", "160,120", "--format", "text", "--lang", "es"]));
    assert!(walk.contains("rayo de sombra hacia F"), "{walk}");
}

#[test]
fn no_frame_says_anything_in_english() {
    let log = by_hand();
    let foreign = Foreign::beside_names_of(&log);
    let mut wrong = Vec::new();
    for keys in EVERYWHERE.into_iter().chain(LINES).chain(crate::values::KEYS) {
        for (size, live) in
            [((19, 5), false), ((40, 12), false), ((80, 24), true), ((200, 60), false), ((200, 60), true)]
        {
            let options = options(Palette::None, false);
            wrong.extend(foreign.check(&frame_of(log.clone(), live, keys, size, &options), keys, size));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn other_logs_say_nothing_in_english_either() {
    let mut wrong = Vec::new();
    for (name, pixel) in [("glass-and-mirror", None), ("figure-19", Some([20, 8])), ("figure-6", None)] {
        let scene = scene(name);
        let pixel = pixel.unwrap_or(scene.camera.resolution.map(|side| side / 2));
        let log = record::pixel(&scene, pixel, Arithmetic::F64);
        let foreign = Foreign::beside_names_of(&log);
        for keys in ["", "g", "g C", "40n", "80s", "200s", "300s o", "w", "31n d", "40n D", "Tab Tab", "t 60s", "Q 60s"]
        {
            let options = options(Palette::None, false);
            wrong.extend(foreign.check(&frame_of(log.clone(), false, keys, (200, 60), &options), keys, (200, 60)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The English and the Spanish strings of the tables of texts. A row has first the English text and then the Spanish one; words that
/// several texts share are pairs.
fn strings_by_language() -> [Vec<String>; 2] {
    let mut found = [Vec::new(), Vec::new()];
    for file in files_below("src/report/language") {
        if file.path == "words.rs" {
            for (number, (_, text)) in file.strings().into_iter().enumerate() {
                found[number % 2].push(text.to_owned());
            }
            continue;
        }
        if ["viewer/glossary.rs", "viewer/glossary/shapes.rs", "viewer/glossary/sampling.rs"].contains(&&*file.path) {
            // A key or a sign, and what it means in both.
            for (number, (_, text)) in file.strings().into_iter().enumerate().filter(|(number, _)| number % 3 > 0) {
                found[number % 3 - 1].push(text.to_owned());
            }
            continue;
        }
        let spanish = spanish_parts(&file);
        for (at, text) in file.strings() {
            found[usize::from(spanish.iter().any(|part| part.contains(&at)))].push(text.to_owned());
        }
    }
    found
}

/// Where the Spanish texts of a file's tables are.
fn spanish_parts(file: &SourceFile) -> Vec<Range<usize>> {
    let mut parts = Vec::new();
    for table in file.find("texts! {").chain(file.find("named_texts! {")) {
        let (mut depth, mut is_in_parameters) = (0, false);
        // Where the row's Spanish text begins, and the last character but for spaces.
        let (mut spanish, mut before) = (None, ' ');
        for (at, character) in file.code[table..].char_indices() {
            match character {
                // Those of a closure, at the beginning of a text.
                '|' if is_in_parameters || before == '=' || before == ',' => is_in_parameters = !is_in_parameters,
                _ if is_in_parameters => {}
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth -= 1,
                ',' if depth == 1 && spanish.is_none() => spanish = Some(table + at),
                ';' if depth == 1 => parts.extend(spanish.take().map(|start| start..table + at)),
                _ => {}
            }
            if depth == 0 && character == '}' {
                break;
            }
            before = if character.is_whitespace() { before } else { character };
        }
    }
    parts
}

/// What would be English.
struct Foreign {
    /// The words of the English texts that no Spanish text has, nor a part of one at its beginning or end.
    words: BTreeSet<String>,
}

impl Foreign {
    fn new() -> Foreign {
        let [english, spanish] = strings_by_language()
            .map(|texts| texts.iter().flat_map(|text| words_of(&without_names(text))).collect::<BTreeSet<_>>());
        assert!(english.len() > 300 && spanish.len() > 300, "{} and {}", english.len(), spanish.len());
        // Beside a list that lies over it a Spanish word may look like an English one: `model` of `modelo`.
        let is_cut = |word: &str| spanish.iter().any(|whole| whole.starts_with(word) || whole.ends_with(word));
        let is_shown = |word: &String| word.chars().count() > 3 && !is_cut(word) && !TYPED.contains(&word.as_str());
        Foreign { words: english.difference(&spanish).filter(|word| is_shown(word)).cloned().collect() }
    }

    /// The same, but for the names in a log, and what is left of them beside a list that lies over a part of them.
    fn beside_names_of(log: &Log) -> Foreign {
        let mut foreign = Foreign::new();
        let names: Vec<_> =
            log.header.objects.iter().chain(&log.header.lights).flat_map(|name| words_of(name)).collect();
        foreign.words.retain(|word| !names.iter().any(|name| name.contains(word.as_str())));
        foreign
    }

    /// What is wrong with a frame, if anything is.
    fn check(&self, frame: &str, keys: &str, size: (u16, u16)) -> Option<String> {
        let text = frame.split("styles:").next().unwrap_or_default();
        let english: Vec<_> = words_of(text).into_iter().filter(|word| self.words.contains(word)).collect();
        let points: Vec<_> = text.lines().filter(|line| has_decimal_point(line)).collect();
        let is_fine = english.is_empty() && points.is_empty();
        (!is_fine).then(|| format!("{english:?} after {keys} at {size:?}, with points {points:#?}"))
    }
}

/// The names of keys, and words of breakpoints that are proposed.
const TYPED: [&str; 13] = [
    "down", "left", "right", "home", "space", "enter", "camera", "kind", "branch", "pixel", "vectors", "front", "side",
];

/// A format string without the names of what is put into it.
fn without_names(text: &str) -> String {
    let mut pieces = text.split('{');
    let first = pieces.next().unwrap_or_default().to_owned();
    first + &pieces.filter_map(|piece| piece.split_once('}')).map(|(_, rest)| format!(" {rest}")).collect::<String>()
}

/// The words of a text in lower case. Names of quantities, which have a `.` or `_` in them, and of commands behind `:` are none.
fn words_of(text: &str) -> Vec<String> {
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '-' | '\'' | ':');
    let words = text
        .split(|c: char| !is_part(c))
        .map(|word| word.trim_start_matches(['.', '-', '\'']).trim_end_matches(['.', '-', '\'', ':']));
    let is_word = |word: &&str| !word.is_empty() && word.chars().all(char::is_alphabetic);
    words.filter(is_word).map(str::to_lowercase).collect()
}

/// Whether a line has a point between two digits that isn't in the number of a section, nor in a path such as `S1.4`.
fn has_decimal_point(line: &str) -> bool {
    let words = line.split(|c: char| c.is_whitespace() || matches!(c, '(' | ')' | ';' | '='));
    let mut before = "";
    words.filter(|word| !word.is_empty()).any(|word| {
        let is_section = std::mem::replace(&mut before, word) == "sección";
        let letters: Vec<char> = word.chars().collect();
        let has_point =
            letters.windows(3).any(|three| three[0].is_ascii_digit() && three[1] == '.' && three[2].is_ascii_digit());
        has_point && !is_section && !letters[0].is_alphabetic()
    })
}
