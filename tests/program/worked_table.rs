//! `textbook --with`: worked examples of somebody's own, checked by the rules of the book.

#![allow(clippy::unwrap_used)]

use crate::calls::{prints, raywalk, says};
use crate::support;
use raywalk::study::textbook::{self, Order, Verdict, Worked};
use std::fs;

/// The book's own table, as comma-separated values.
fn book() -> String {
    let table = textbook::table(textbook::Example::Textbook, &support::scene("textbook"));
    let rows: Vec<_> = table.steps.iter().map(|row| format!("{},\"{}\"\n", row.quantity, row.printed.text)).collect();
    format!("quantity,printed\n{}", rows.concat())
}

fn checked(table: &str) -> textbook::Checked {
    let worked = Worked::parse(table.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
    worked.check(&support::scene("textbook")).unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn refuses(table: &str, expected: &str) {
    let scene = support::scene("textbook");
    let error = Worked::parse(table.as_bytes()).and_then(|worked| worked.check(&scene)).map(|_| ()).unwrap_err();
    assert!(error.to_string().contains(expected), "expected `{expected}` in: {error}");
}

#[test]
fn the_books_own_table_has_the_books_verdicts() {
    let checked = checked(&book());
    let table = textbook::table(textbook::Example::Textbook, &support::scene("textbook"));
    assert_eq!(checked.order, Order::Book);
    assert_eq!(checked.rows.len(), table.steps.len());
    for (row, step) in checked.rows.iter().zip(&table.steps) {
        assert_eq!((row.quantity, row.verdict.word()), (step.quantity, step.verdict.word()), "{}", step.called);
        assert_eq!((&row.recomputed, &row.strict, &row.exact), (&step.recomputed, &step.strict, &step.exact));
    }
    let departures: Vec<_> = checked.departures().map(|row| (row.quantity, &*row.path)).collect();
    assert_eq!(departures, [("hit.point", "C"), ("shade.local", "C R"), ("half.direction", "C")]);
}

#[test]
fn rows_may_follow_the_walk_instead_of_the_book() {
    let table = "quantity,printed\nlight.vector,\"(5, 6.004, 7.998)\"\nlight.vector,\"(−5.139, 2.628, 7.151)\"\n";
    let walk = checked(table);
    assert_eq!((walk.order, walk.departures().count()), (Order::Walk, 0));
    let paths: Vec<_> = walk.rows.iter().map(|row| &*row.path).collect();
    assert_eq!(paths, ["C", "C R"]);
}

/// Listed values are the operands of those after them; what isn't listed is computed by hand.
#[test]
fn a_slip_is_reported_once_and_what_follows_from_it_agrees() {
    // T_2A would be 6.380 by hand; from a radius that was slipped in T_A everything after it follows.
    let slip = checked("quantity,printed,path\nsphere.t_a,13.000,C R\nsphere.t2_a,-0.024,C R\n");
    let verdicts: Vec<_> = slip.rows.iter().map(|row| row.verdict.word()).collect();
    assert_eq!(verdicts, ["departs", "agrees"], "{slip:?}");
    let red = checked("quantity,printed\ncombine.color,394.134\n");
    assert_eq!(red.rows[0].verdict, Verdict::Agrees);
    let digits = checked("quantity,printed\nhalf.length,1.66\n");
    assert_eq!(digits.rows[0].verdict, Verdict::Format);
    // A discriminant of the second test that is no longer negative: the walk goes another way.
    let elsewhere = checked("quantity,printed\nplane.v_d,0\nplane.t,12.685\n");
    assert!(elsewhere.rows[1].recomputed.is_empty() && elsewhere.text().contains("goes another way"), "{elsewhere:?}");
    let passed_over = checked("quantity,printed\nhit.point,\nhit.point,\"(14.139, 9.372, 8.849)\"\n");
    assert_eq!((passed_over.rows.len(), &*passed_over.rows[0].path), (1, "C R"));
}

#[test]
fn what_is_wrong_with_a_table_is_reported_with_its_line() {
    refuses("", "expected the columns `quantity` and `printed`");
    refuses("name,value\n", "found `name`, `value`");
    refuses("quantity,printed\n", "expected at least one row");
    refuses("quantity,printed\nhit.pont,3\n", "line 2: unknown quantity `hit.pont`, did you mean `hit.point`?");
    refuses("quantity,printed\nhit.point,\n", "expected at least one row with a printed value");
    refuses("quantity,printed\nsphere.l2_oc,1e308\n", "line 2: `1e308` is no value");
    refuses(&format!("quantity,printed\n{}", "hit.point,\n".repeat(5000)), "line 4098: expected at most 4096 rows");
    refuses("quantity,printed\nray.length,x\n", "line 2: `x` is no value");
    refuses("quantity,printed\nray.length,inf\n", "line 2: `inf` is no value");
    refuses("quantity,printed\nhit.point,\"(1, 2)\"\n", "line 2: `(1, 2)` is no value");
    refuses("quantity,printed\nray.length,\"(1, 2, 3)\"\n", "line 2: `ray.length` is a number");
    refuses("quantity,printed\nhit.point,1\n", "line 2: `hit.point` is a triple");
    refuses("quantity,printed\nray.length,1\nray.length,2\n", "line 3: the walk has 1 of `ray.length`");
    refuses("quantity,printed,path\nhit.point,1,C T\n", "line 2: the walk has 0 of `hit.point` on the ray `C T`");
    refuses("quantity,printed\nray.length\n", "line: 2");
}

#[test]
fn the_exit_code_says_whether_all_follows() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.csv");
    let path = path.to_str().unwrap();
    fs::write(path, "quantity,printed\nray.length,12.689\n").unwrap();
    assert!(
        prints(&["textbook", "--with", path])
            .ends_with("1 value checked, 0 depart; rows of one name in the order of the book.\n")
    );
    fs::write(path, book()).unwrap();
    let output = raywalk(&["textbook", "--with", path]).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    support::snapshots().bind(|| insta::assert_snapshot!("textbook_with", String::from_utf8(output.stdout).unwrap()));
    let output = raywalk(&["textbook", "--with", path, "--format", "json"]).output().unwrap();
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&json["departures"], &json["order"]), (&3.into(), &"book".into()));
    let first = serde_json::json!({"line": 2, "quantity": "ray.length", "path": "C", "printed": 12.689, "recomputed": 12.689,
        "strict": 12.689, "exact": 12.68857754044952, "verdict": "agrees"});
    assert_eq!(json["steps"][0], first);
    says(2, &["textbook", "--with", "/there/is/no.csv"], "no such file, expected a table");
}
