//! The rules of the architecture, read off the source text: which module may know which, who does input and output, and what no
//! code of ours does. `docs/architecture.md` says why.

mod support {
    pub mod circles;
    pub mod source;
}

use std::collections::BTreeSet;
use support::circles::circles;
use support::source::{SourceFile, files_below, program};

/// The top-level modules, lowest first: each may import those before it.
const MODULES: &[&str] = &[
    "threads", "files", "log", "random", "probe", "geometry", "scene", "trace", "sampling", "record", "render",
    "report", "study", "tui", "cli",
];

/// Modules that may import less than all that lies below them.
const NARROW: &[(&str, &[&str])] = &[
    // Files are opened and recognised without knowing a format.
    ("files", &["files"]),
    // A log knows no geometry: it can be read by a program that has none. Only its files come from outside.
    ("log", &["log", "files"]),
    // Random numbers are numbers: whoever draws them says what for.
    ("random", &["random"]),
    // A report is made of the log alone, and rounds as the probes do.
    ("report", &["report", "log", "probe", "files/escape"]),
    // The viewer shows a log and an image that it is handed; it computes no geometry.
    ("tui", &["tui", "log", "report", "files/escape", "files/suggest"]),
    // The state of the viewer knows neither what keys do nor how it is drawn.
    ("tui/model", &["tui/model", "tui/text", "tui/theme", "log", "report", "files/suggest"]),
    // The scene file is the numbers and words as they are written, whatever becomes of them. Those of a mesh file are the mesh.
    ("scene/file", &["scene/file", "geometry/mesh", "geometry/shape/SphereMethod", "files"]),
];

/// Where input and output happen.
const DOORS: &[&str] = &[
    "main.rs",
    "cli/",
    "files/",
    "scene/file/mesh",
    "scene/file/raw/",
    "log/file/",
    "render/export/",
    "tui/terminal.rs",
];

/// Files of the viewer with texts of their own: the comparison of two logs, which is in English throughout, pictures in SVG, and
/// what `Debug` writes.
const OWN_PROSE: &[&str] = &["tui/beside/view.rs", "tui/screenshot.rs", "tui/model/picture.rs", "tui/model/drawing.rs"];

/// What input and output look like. Its error type may be used everywhere.
const INPUT_AND_OUTPUT: &[&str] = &[
    "std::fs",
    "std::net",
    "std::process",
    "std::env",
    "File::",
    "stdin",
    "stdout",
    "stderr",
    "println!",
    "print!",
    "eprintln!",
    "eprint!",
    "dbg!",
];

/// Methods of the standard library whose last bits differ between machines, or that round once where the text has two
/// operations.
const INEXACT: &[&str] = &[
    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "sin_cos",
    "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "cbrt", "hypot", "mul_add",
];

/// Methods of vectors that hide a quantity which a log should show.
const HIDING: &[&str] = &[
    "normalize",
    "normalize_or",
    "normalize_or_zero",
    "normalize_and_length",
    "try_normalize",
    "reflect",
    "refract",
    "project_onto",
    "reject_from",
    "angle_between",
    "move_towards",
];

/// Files whose `expect` is a method of their own: it returns an error and never panics.
const OWN_EXPECT: &[&str] = &["log/formula.rs", "scene/file/strict.rs"];

#[test]
fn a_module_imports_only_modules_below_it() {
    let rank = |module: &str| MODULES.iter().position(|known| *known == module);
    let mut wrong = Vec::new();
    let mut seen = BTreeSet::new();
    for file in program() {
        let Some(module) = module_of(&file) else { continue };
        let Some(own) = rank(&module) else {
            wrong.push(format!("{}: the module `{module}` has no place in the order", file.path));
            continue;
        };
        for (at, path) in file.imports() {
            let Some(other) = path.first() else { continue };
            if rank(other).is_none_or(|other| other > own) {
                wrong.push(format!("{}: `{module}` imports `{}`", file.place(at), path.join("::")));
            }
            seen.insert((module.clone(), other.clone()));
        }
    }
    assert_none("imports against the order of the modules", &wrong);
    // What the scanner must have seen, if it sees at all.
    for (module, other) in [("trace", "geometry"), ("geometry", "log"), ("report", "log"), ("cli", "record")] {
        assert!(
            seen.contains(&(module.to_owned(), other.to_owned())),
            "{module} imports {other}, and the scanner is blind"
        );
    }
}

#[test]
fn narrow_modules_import_only_what_they_may_know() {
    let mut wrong = Vec::new();
    for file in program() {
        for (part, allowed) in NARROW.iter().filter(|(part, _)| is_in(&file.path, part)) {
            // `pub(crate)` names no module.
            for (at, path) in file.imports().into_iter().filter(|(_, path)| !path.is_empty()) {
                let target = path.join("/");
                if !allowed.iter().any(|allowed| is_in(&target, allowed)) {
                    wrong.push(format!("{}: `{part}` imports `{}`", file.place(at), path.join("::")));
                }
            }
        }
    }
    assert_none("imports that a module must not know", &wrong);
}

#[test]
fn no_two_files_import_each_other() {
    assert_none("circles of imports", &circles(&program()));
}

#[test]
fn the_scanner_sees_circles() {
    let file = |path: &str, text: &str| SourceFile::new(path.to_owned(), text);
    let room = file("room/mod.rs", "mod a; mod b; mod c; pub use a::A; pub use c::C; use b::B; fn f(b: B) {}");
    let files = [
        file("lib.rs", "mod room;"),
        room,
        file("room/a.rs", "use super::b::B; pub struct A; fn f() { super::f() }"),
        file("room/b.rs", "use crate::room::{C, f}; pub struct B;"),
        file("room/c.rs", "pub struct C; impl C { fn f(a: super::A) {} }"),
        file("room/d.rs", "use super::{A, b};"),
    ];
    assert_eq!(circles(&files), ["room/a.rs -> room/b.rs: B\nroom/b.rs -> room/c.rs: C\nroom/c.rs -> room/a.rs: A"]);
    assert!(circles(&files[..4]).is_empty(), "without the third file there is no circle");
}

#[test]
fn only_listed_modules_do_input_and_output() {
    let is_door = |file: &SourceFile| DOORS.iter().any(|door| file.path.starts_with(door));
    let (doors, inside): (Vec<_>, Vec<_>) = program().into_iter().partition(is_door);
    assert_none("input and output outside the listed modules", &occurrences(&inside, INPUT_AND_OUTPUT));
    assert!(!occurrences(&doors, INPUT_AND_OUTPUT).is_empty(), "files are read somewhere, and the scanner is blind");
}

/// What the viewer says is said in `report/language`, in every language. Of a single word nobody can tell whether it is shown or typed.
#[test]
fn the_viewer_has_no_prose_of_its_own() {
    let is_viewer =
        |file: &SourceFile| file.path.starts_with("tui/") && !OWN_PROSE.iter().any(|own| file.path.starts_with(own));
    let mut wrong = Vec::new();
    for file in program().iter().filter(|file| is_viewer(file)) {
        let prose = file.strings().into_iter().filter(|(_, text)| is_prose(text));
        wrong.extend(prose.map(|(at, text)| format!("{}: \"{text}\"", file.place(at))));
    }
    assert_none("texts of the viewer outside `report/language`", &wrong);
    let table: Vec<_> = program().into_iter().filter(|file| file.path.starts_with("report/language/")).collect();
    let found = table.iter().flat_map(SourceFile::strings).filter(|(_, text)| is_prose(text)).count();
    assert!(found > 600, "{found} texts in the tables of the languages, and the scanner is blind");
}

#[test]
fn no_code_is_unsafe_but_that_of_the_guard() {
    assert_none("unsafe code", &occurrences(&program(), &["unsafe"]));
    assert!(!occurrences(&files_below("guard/src"), &["unsafe"]).is_empty(), "the scanner is blind");
}

#[test]
fn nothing_panics_without_naming_the_invariant() {
    let files = program();
    let never = [".unwrap()", ".unwrap_err()", ".expect_err(", "panic!", "todo!", "unimplemented!"];
    let mut wrong = occurrences(&files, &never);
    for file in &files {
        for call in [".expect(", "unreachable!("] {
            for at in file.find(call) {
                let has_own = call == ".expect(" && OWN_EXPECT.contains(&file.path.as_str());
                if !has_own && !states_an_invariant(&file.with_strings[at + call.len()..]) {
                    wrong.push(format!("{}: `{call}…` states no invariant", file.place(at)));
                }
            }
        }
    }
    assert_none("panics", &wrong);
}

#[test]
fn every_machine_gives_the_same_bits() {
    let called = |name: &&str| [format!(".{name}("), format!("f64::{name}"), format!("f32::{name}")];
    // Commands have a method `log` that makes one; clippy, which knows types, tells it from that of numbers.
    let calls: Vec<_> = INEXACT.iter().flat_map(called).filter(|call| call != ".log(").collect();
    let calls: Vec<_> = calls.iter().map(String::as_str).collect();
    assert_none("inexact functions (`libm` has exact ones)", &occurrences(&program(), &calls));
    let manifest = include_str!("../Cargo.toml");
    assert!(!manifest.contains("fast-math"), "fast-math reorders sums");
    let glam = manifest.lines().find(|line| line.starts_with("glam = ")).unwrap_or_default();
    assert!(glam.contains("\"libm\""), "without `libm` glam calls the machine's functions: {glam}");
}

#[test]
fn no_vector_method_hides_a_quantity() {
    let called = |name: &&str| [format!(".{name}("), format!("DVec3::{name}")];
    let calls: Vec<_> = HIDING.iter().flat_map(called).collect();
    let calls: Vec<_> = calls.iter().map(String::as_str).collect();
    assert_none("vector methods that hide quantities", &occurrences(&program(), &calls));
}

#[test]
fn no_file_is_above_400_lines() {
    for folder in ["src", "tests", "benches", "guard/src"] {
        let long = |file: &SourceFile| (file.lines > 400).then(|| format!("{folder}/{}: {}", file.path, file.lines));
        assert_none("files above 400 lines", &files_below(folder).iter().filter_map(long).collect::<Vec<_>>());
    }
}

#[test]
fn the_scanner_sees_code_only() {
    let text = r##"
        // crate::comment and .unwrap()
        /* crate::block /* nested */ .unwrap() */
        const TEXT: &str = "crate::string \" .unwrap()";
        const RAW: &str = r#"crate::raw " .unwrap()"#;
        const QUOTE: char = '"';
        fn code<'a>(x: &'a str) -> char { crate::seen::function(x, 'é', '\'') }
        #[cfg(test)]
        mod tests { use crate::tested; fn f() { { x.unwrap() } } }
        use crate::behind;
    "##;
    let file = SourceFile::new("module/part.rs".to_owned(), text);
    assert_eq!(paths(&file), ["seen::function", "behind"]);
    assert_none("strings and comments", &occurrences(&[file], &[".unwrap()"]));
}

#[test]
fn test_modules_with_files_of_their_own_are_no_part_of_the_program() {
    let paths = |files: Vec<SourceFile>| files.into_iter().map(|file| file.path).collect::<BTreeSet<_>>();
    let (all, program) = (paths(files_below("src")), paths(program()));
    let for_tests: Vec<_> = all.difference(&program).map(String::as_str).collect();
    assert!(for_tests.contains(&"tui/tests.rs"), "{for_tests:?}");
    assert!(for_tests.iter().all(|path| path.contains("test")), "{for_tests:?}");
}

#[test]
fn the_scanner_resolves_paths() {
    let text = "use crate::{self, a::{b, c::*,}, d as e,};\nuse super::{f, super::g};\npub(super) fn h() -> super::super::i {}";
    let file = SourceFile::new("module/part/file.rs".to_owned(), text);
    assert_eq!(paths(&file), ["", "a::b", "a::c", "d", "module::part::f", "module::g", "module::part", "module::i"]);
    assert_eq!(SourceFile::new("module/part/mod.rs".to_owned(), "").module(), ["module", "part"]);
    assert!(SourceFile::new("lib.rs".to_owned(), "").module().is_empty());
}

#[test]
fn the_scanner_reads_strings() {
    let text = "f(\"one two\", '\"', r#\"a \"b\"#); // \"comment\"\nlet c = \"\\\"x\";";
    let file = SourceFile::new("module/part.rs".to_owned(), text);
    let strings: Vec<_> = file.strings().into_iter().map(|(_, text)| text).collect();
    assert_eq!(strings, ["one two", "a \"b", "\\\"x"]);
    assert!(is_prose("no such key") && is_prose("{x}: played to {y}"));
    assert!(
        !is_prose("object {name}")
            && !is_prose("  {a} {b}")
            && !is_prose("j k")
            && !is_prose("CRT0123. ay")
            && !is_prose("{first word}")
    );
}

#[test]
fn the_scanner_finds_whole_words() {
    let file =
        SourceFile::new("module/part.rs".to_owned(), "eprintln!(); MyFile::new(); File::open(); a.expect(\"b\")");
    assert_eq!(file.find("println!").count(), 0);
    assert_eq!(file.find("File::").count(), 1);
    assert!(states_an_invariant("\"a scene holds only numbers\")"));
    assert!(!states_an_invariant("\"failed\")"));
    assert!(!states_an_invariant("MESSAGE)"));
}

/// The module of a file; `None` for the roots of library and binary.
fn module_of(file: &SourceFile) -> Option<String> {
    file.module().first().map(|module| (*module).to_owned())
}

/// Whether a path with slashes lies in a part of the crate.
fn is_in(path: &str, part: &str) -> bool {
    path.strip_prefix(part).is_some_and(|rest| rest.is_empty() || rest.starts_with(['/', '.']))
}

/// Whether a message that begins here is a sentence of at least four words.
fn states_an_invariant(argument: &str) -> bool {
    let message = argument.trim_start().strip_prefix('"').and_then(|text| text.split_once('"'));
    message.is_some_and(|(message, _)| message.split_whitespace().count() >= 4)
}

/// Whether a text, without what is put into it, has two words with a space between them.
fn is_prose(text: &str) -> bool {
    let mut own = String::new();
    let mut depth = 0;
    for character in text.chars() {
        match character {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ if depth == 0 => own.push(character),
            _ => {}
        }
        if character == '}' {
            own.push('_');
        }
    }
    let is_word = |word: &str| {
        let letters = word.trim_matches(|c: char| c.is_ascii_punctuation() && c != '_');
        letters.chars().count() > 1 && letters.chars().all(|c| c.is_alphabetic() || c == '\'')
    };
    let words: Vec<_> = own.split(' ').collect();
    words.windows(2).any(|pair| pair.iter().all(|word| is_word(word)))
}

fn occurrences(files: &[SourceFile], texts: &[&str]) -> Vec<String> {
    let of_text = |file: &SourceFile, text: &str| -> Vec<String> {
        file.find(text).map(|at| format!("{}: `{text}`", file.place(at))).collect()
    };
    files.iter().flat_map(|file| texts.iter().flat_map(|text| of_text(file, text)).collect::<Vec<_>>()).collect()
}

fn paths(file: &SourceFile) -> Vec<String> {
    file.imports().into_iter().map(|(_, path)| path.join("::")).collect()
}

#[track_caller]
fn assert_none(what: &str, found: &[String]) {
    assert!(found.is_empty(), "{what}:\n{}", found.join("\n"));
}
