//! Whether the catalogue and the tests have the same rows.

use crate::shared::shared;
use std::collections::BTreeSet;

/// The text of every file that holds rows.
const TESTS: &[&str] = &[
    include_str!("logs.rs"),
    include_str!("machine.rs"),
    include_str!("meshes.rs"),
    include_str!("numbers.rs"),
    include_str!("obj.rs"),
    include_str!("output.rs"),
    include_str!("signals.rs"),
    include_str!("text.rs"),
    // Those that need a terminal share its sessions.
    include_str!("../viewer/terminal.rs"),
];

/// A row's id without its name: `b01` of `b01_empty`.
fn id(name: &str) -> &str {
    name.split('_').next().unwrap_or_default()
}

/// The ids in the names of the tests.
fn tested() -> BTreeSet<&'static str> {
    let functions = TESTS.iter().flat_map(|text| text.split("\nfn ").skip(1));
    functions.map(id).filter(|id| id.len() == 3 && id[1..].bytes().all(|byte| byte.is_ascii_digit())).collect()
}

#[test]
fn every_row_has_a_test() {
    let Some(catalogue) = shared("reference/bad-input/bad_inputs.csv") else { return };
    let catalogue = std::fs::read_to_string(catalogue).expect("the catalogue");
    let rows: BTreeSet<&str> = catalogue.lines().skip(1).filter(|line| !line.is_empty()).map(id).collect();
    assert!(rows.len() > 80, "{} rows", rows.len());
    let tested = tested();
    let untested: Vec<_> = rows.difference(&tested).collect();
    assert!(untested.is_empty(), "rows without a test: {untested:?}");
    let unknown: Vec<_> = tested.difference(&rows).collect();
    assert!(unknown.is_empty(), "tests without a row: {unknown:?}");
}
