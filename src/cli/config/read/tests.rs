//! Configurations, and what is wrong with some.

use super::*;
use crate::cli::look::{Look, ThemeChoice};
use crate::cli::views::Lang;

fn read(text: &str) -> Config {
    config(text.as_bytes(), "config.toml").unwrap_or_else(|error| panic!("{}", error.report(false)))
}

/// The text has these mistakes: their lines and columns, and the beginnings of what is said.
#[track_caller]
fn is_wrong(text: &str, expected: &[(usize, usize, &str)]) {
    let error = config(text.as_bytes(), "config.toml").expect_err("something is wrong with it");
    let found: Vec<_> = error.problems().iter().map(|one| (one.line, one.column, one.message.as_str())).collect();
    assert_eq!(found.len(), expected.len(), "{text}:\n{found:?}");
    for ((line, column, said), (expected_line, expected_column, beginning)) in found.into_iter().zip(expected) {
        assert_eq!((line, column), (*expected_line, *expected_column), "{text}: {said}");
        assert!(said.starts_with(beginning), "{text}: {said}\nexpected {beginning}");
    }
}

const FULL: &str = r#"theme = "light"
ascii = false
mouse = true
language = "es"
digits = 6
[keys]
"ctrl-n" = "next-value"
"X" = ":pixel 10,20"
"F5" = ":set objects.sphere.shape.sphere.radius 2"
"q" = "none"
"Q" = "quit"
"gg" = "first"
"g" = "none"
"A" = "mark"
"\\" = ":search \"\u202e"
[keys-in-lists]
"x" = "delete"
"#;

#[test]
fn everything_can_be_said() {
    let config = read(FULL);
    assert_eq!(config.look, Look { ascii: Some(false), theme: Some(ThemeChoice::Light) });
    assert_eq!((config.has_mouse, config.language, config.digits), (true, Lang::Es, 6));
    let lines: Vec<_> = config.bindings.lines().map(|(chord, line)| (chord.text(), line.to_owned())).collect();
    let lines: Vec<_> = lines.iter().map(|(key, line)| (key.as_str(), line.as_str())).collect();
    let radius = "set objects.sphere.shape.sphere.radius 2";
    assert_eq!(lines, [("F5", radius), ("X", "pixel 10,20"), ("\\", "search \"\u{202e}")]);
}

#[test]
fn nothing_said_changes_nothing() {
    assert_eq!(read(""), Config::default());
    assert_eq!(read("\u{feff}# nothing\n[keys]\n"), Config::default());
    // What a key does anyway is no change.
    assert_eq!(read("[keys]\n\"n\" = \"next-value\"\n\"&\" = \"none\"\n"), Config::default());
}

#[test]
fn a_printed_configuration_reads_back() {
    for text in ["", "theme = \"16\"\nascii = true", FULL] {
        let config = read(text);
        let file = config.file();
        let mut again = read(&file);
        // What isn't said is printed as it is then.
        again.look.theme = again.look.theme.filter(|theme| config.look.theme.is_some() || *theme != ThemeChoice::Auto);
        assert_eq!(again, config, "{file}");
        assert_eq!(read(&file).file(), file);
        let has_hidden = file.chars().any(|character| character.is_control() && character != '\n');
        assert!(!has_hidden && !file.contains('\u{202e}'), "{file}");
    }
}

#[test]
fn the_printed_configuration_names_every_action() {
    let file = Config::default().file();
    for name in keys::names(false).into_iter().chain(keys::names(true)).filter(|name| name != keys::NOTHING) {
        assert!(file.contains(&format!("= \"{name}\"")), "{name}");
    }
}

#[test]
fn mistakes_have_their_places() {
    is_wrong("thme = \"dark\"", &[(1, 1, "unknown key `thme`, did you mean `theme`?")]);
    is_wrong("\ntheme = \"drak\"", &[(2, 9, "unknown word `drak`, did you mean `dark`?")]);
    is_wrong("mouse = 1", &[(1, 9, "expected true or false, found the number `1`")]);
    is_wrong("digits = 16", &[(1, 10, "expected a whole number from 0 to 15, found the number `16`")]);
    is_wrong("digits = -1", &[(1, 10, "expected a whole number from 0 to 15")]);
    is_wrong("language = 1979-05-27", &[(1, 12, "expected \"en\" or \"es\", found a date")]);
    is_wrong("keys = \"q\"", &[(1, 8, "expected a table of keys")]);
    is_wrong("a = 1\nb = 2", &[(1, 1, "unknown key `a`"), (2, 1, "unknown key `b`")]);
}

#[test]
fn mistakes_of_keys() {
    is_wrong("[keys]\n\"PgDwn\" = \"quit\"", &[(2, 1, "no key is called `PgDwn`, did you mean `PgDn`?")]);
    is_wrong("[keys]\n\"\" = \"quit\"", &[(2, 1, "no key is called ``")]);
    is_wrong("[keys]\n\"abc\" = \"quit\"", &[(2, 1, "no key is called `abc`")]);
    is_wrong("[keys]\nX = \"next-valeu\"", &[(2, 5, "no action is called `next-valeu`, did you mean `next-value`?")]);
    is_wrong("[keys]\nX = \"delete\"", &[(2, 5, "`delete` is for the table `keys-in-lists`")]);
    is_wrong("[keys]\nX = 3", &[(2, 5, "expected the name of an action")]);
    is_wrong("[keys]\nEsc = \"quit\"", &[(2, 1, "Esc and Enter stay")]);
    is_wrong("[keys]\n5 = \"quit\"", &[(2, 1, "Esc and Enter stay")]);
    is_wrong("[keys]\n\"^x\" = \"mark\"", &[(2, 8, "a letter follows `mark`")]);
    is_wrong("[keys]\nX = \":pixle 3\"", &[(2, 5, "no command :pixle; did you mean :pixel?")]);
    is_wrong("[keys]\nX = \":write\"", &[(2, 5, "expected :write FILE")]);
    is_wrong("[keys]\nX = \":quit now\"", &[(2, 5, "nothing may follow :quit")]);
    is_wrong("[keys-in-lists]\nX = \"quit\"", &[(2, 5, "no action is called `quit`; `delete` or `none`")]);
}

#[test]
fn one_key_twice_is_refused() {
    is_wrong("[keys]\n\"X\" = \"quit\"\n\"X\" = \"help\"", &[(3, 1, "duplicate key")]);
    is_wrong("[keys]\n\"^x\" = \"quit\"\n\"ctrl-x\" = \"help\"", &[(3, 1, "`^x` is bound twice")]);
    // `z` begins `zz` and `zo`.
    is_wrong("[keys]\nz = \"quit\"", &[(2, 1, "`z` does something alone"), (2, 1, "`z` does something alone")]);
    is_wrong("[keys]\nnn = \"quit\"", &[(2, 1, "`n` does something alone, and `nn` begins with it")]);
    is_wrong("[keys]\nma = \"quit\"", &[(2, 1, "`m` does something alone, and `ma` begins with it")]);
    read("[keys]\nz = \"quit\"\nzz = \"none\"\nzo = \"none\"");
}

#[test]
fn a_way_out_is_left() {
    let all_but = |rest: &str| format!("[keys]\nq = \"none\"\n\"^c\" = \"none\"\n{rest}");
    is_wrong(&all_but("\":\" = \"none\""), &[(1, 1, "no key is left that leaves the viewer")]);
    read(&all_but(""));
    read(&all_but("\":\" = \"none\"\nX = \"quit\""));
}

#[test]
fn what_is_no_toml_is_said_with_its_place() {
    is_wrong("theme = dark", &[(1, 9, "")]);
    is_wrong("a\u{0} = 1", &[(1, 2, "invalid unquoted key")]);
    let error = config(b"theme = \"\xff\"", "config.toml").expect_err("it is no text");
    assert_eq!(error.report(false).lines().next(), Some("error: config.toml:1:10: expected text in UTF-8"));
    // However deep it goes, it ends.
    let deep = format!("a = {}", "[".repeat(100_000));
    assert!(config(deep.as_bytes(), "config.toml").is_err());
    let many: String = (0..50).map(|number| format!("k{number} = 1\n")).collect();
    let error = config(many.as_bytes(), "config.toml").expect_err("no key is known");
    assert!(error.report(false).ends_with("and 30 more problems, not shown"), "{}", error.report(false));
}
