//! The report of `raywalk stress` in other ways of computing than the program's own.

use assert_cmd::Command;
use std::process::Output;

fn raywalk(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_raywalk")).args(arguments).output().expect("it runs")
}

/// What a call prints that ends well.
#[track_caller]
fn prints(arguments: &[&str]) -> String {
    let output = raywalk(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The notes' formulas and other arithmetics are listed beside what is required, and nothing is required of them.
#[test]
fn stability_is_reported_in_other_ways_of_computing() {
    let table = prints(&["stress", "--decimals", "3"]);
    let head = table.lines().next().expect("a head");
    assert!(head.split_whitespace().collect::<Vec<_>>().ends_with(&["notes", "f32", "decimal:3"]), "{head}");
    assert!(
        ["\nulp  ", "\nk  ", "\n2^-52  ", "\nrelative  ", "\nwrong  "].iter().all(|unit| table.contains(unit)),
        "{table}"
    );
    let text = prints(&["stress", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    let row =
        |family: &str| rows.iter().find(|row| row["family"].as_str().is_some_and(|name| name.starts_with(family)));
    let column = |family: &str, k: usize| row(family).expect("a family")["columns"][k].clone();
    let ways = [("notes", "f64", "notes"), ("f32", "f32", "robust"), ("decimal:6", "decimal:6", "notes")];
    for (k, (way, arithmetic, formulas)) in ways.into_iter().enumerate() {
        let found = column("f01", k);
        assert_eq!((&found["way"], &found["arithmetic"]), (&way.into(), &arithmetic.into()));
        assert_eq!(found["formulas"], formulas);
        // Input is judged before all arithmetic.
        assert_eq!((column("f19", k).get("wrong"), column("f19", k).get("worst")), (None, None));
    }
    let worst = |family: &str, k: usize| column(family, k)["worst"].as_f64().expect("an error");
    let own = |family: &str| row(family).expect("a family")["worst"].as_f64().expect("an error");
    // The geometric sphere loses digits far away, 1 − (1 − cos²φ₁)/η² decides wrongly at the critical angle, and (−L − ηV)/(η − 1) near η = 1.
    assert!(worst("f01", 0) > 1e3 * own("f01") && worst("f09", 0) > 4.0 * own("f09"));
    assert!(column("f08", 0)["wrong"].as_u64() > Some(0) && column("f08", 0)["worst"].is_f64());
    // A number of f32 has 24 digits, of which f64 has 29 more.
    assert!((1e-8..1e-3).contains(&worst("f23", 1)) && (1e-7..1e-2).contains(&worst("f23", 2)));
    assert_eq!(raywalk(&["stress", "--decimals", "16"]).status.code(), Some(2));
    assert_eq!(raywalk(&["stress", "--decimals", "3", "--answers"]).status.code(), Some(2));
}
