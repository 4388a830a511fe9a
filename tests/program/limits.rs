//! The page of limits and the constants in the source text say the same.

use crate::source::files_below;
use std::collections::BTreeMap;

/// The constants of the program whose names begin like limits, with their values as they are written.
fn constants() -> BTreeMap<String, String> {
    let mut constants = BTreeMap::new();
    for file in files_below("src").into_iter().chain(files_below("guard/src")) {
        for line in file.with_strings.lines() {
            let declared = declared(line);
            let Some((name, value)) = declared.and_then(|rest| rest.split_once(": ")) else { continue };
            let Some((_, value)) = value.split_once(" = ") else { continue };
            // From how many primitives on threads share a tree is no limit of anything.
            if (name.starts_with("MAX_") || name.starts_with("MIN_")) && name != "MIN_PARALLEL_PRIMITIVES" {
                let before = constants.insert(name.to_owned(), value.trim_end_matches(';').to_owned());
                assert!(before.is_none(), "two constants are called {name}");
            }
        }
    }
    constants
}

/// What follows `const`, whoever may see it: `pub`, `pub(super)`, `pub(in crate::log)`.
fn declared(line: &str) -> Option<&str> {
    let line = line.trim();
    let line = match line.strip_prefix("pub") {
        Some(seen) if seen.starts_with('(') => seen.split_once(')')?.1,
        Some(seen) => seen,
        None => line,
    };
    line.trim_start().strip_prefix("const ")
}

#[test]
fn constants_are_seen_whoever_may_use_them() {
    for seen in ["", "pub ", "pub(super) ", "pub(crate) ", "pub(in crate::log) "] {
        assert_eq!(declared(&format!("    {seen}const MAX_X: usize = 1;")), Some("MAX_X: usize = 1;"), "{seen}");
    }
    assert_eq!(declared("let x = 1;"), None);
}

/// The number that stands for `1 << 28`, `65_535`, `64 * 1024` or `1e100`.
fn number(expression: &str) -> f64 {
    let parse = |text: &str| text.trim().replace('_', "").parse::<f64>().expect("a number");
    match expression.split_once("<<") {
        Some((number, power)) => parse(number) * (1_u64 << parse(power) as u32) as f64,
        None => expression.split('*').map(parse).product(),
    }
}

#[test]
fn the_page_of_limits_lists_every_limit_with_its_value() {
    let constants = constants();
    assert!(constants.len() > 20, "{} limits, and the scanner is blind", constants.len());
    let page = include_str!("../../docs/limits.md");
    let rows: BTreeMap<_, _> = page.lines().filter_map(row).collect();
    for (name, value) in &constants {
        let listed = rows.get(name.as_str()).unwrap_or_else(|| panic!("docs/limits.md doesn't list {name}"));
        assert_eq!(number(listed), number(value), "{name}");
    }
    for name in rows.keys() {
        assert!(constants.contains_key(*name), "docs/limits.md lists {name}, which isn't there");
    }
}

/// The name and the value of a row such as ``| the longest side | 65535 | `MAX_SIDE` | … |``.
fn row(line: &str) -> Option<(&str, &str)> {
    let cells: Vec<_> = line.split('|').map(str::trim).collect();
    let [_, _, value, name, ..] = cells[..] else { return None };
    Some((name.strip_prefix('`')?.strip_suffix('`')?, value))
}
