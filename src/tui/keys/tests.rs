//! What keys mean.

#![allow(clippy::unwrap_used)]

use super::*;

#[track_caller]
fn does(typed: &str, key: &str, expected: Action) {
    let mut pending = Pending::default();
    for character in typed.chars() {
        match character.to_digit(10) {
            Some(digit) => pending.count = Some(digit),
            None => pending.prefix = Some(character),
        }
    }
    assert_eq!(action(&pending, parse(key).unwrap()), Some(expected), "{typed}{key}");
}

/// In a list a key may mean something of its own.
fn is_in_lists(row: &Row) -> bool {
    row.action == Walk(Walk::Delete)
}

#[test]
fn every_key_of_the_table_does_what_its_row_says() {
    for row in rows() {
        for key in row.keys {
            match *key {
                "zz" => does("z", "z", row.action),
                "zo" => does("z", "o", row.action),
                "''" => does("'", "'", row.action),
                // A letter of one's choice follows.
                "m+letter" => does("m", "q", Walk(Walk::Mark('q'))),
                "'+letter" => does("'", "q", Walk(Walk::GoTo('q'))),
                key if is_in_lists(row) => assert_eq!(key, "d"),
                key => does("", key, row.action),
            }
        }
    }
}

#[test]
fn no_key_is_in_two_rows() {
    let mut keys: Vec<_> = rows().filter(|row| !is_in_lists(row)).flat_map(|row| row.keys).collect();
    let count = keys.len();
    keys.sort();
    keys.dedup();
    assert_eq!(keys.len(), count);
}

#[test]
fn shift_and_tab_have_one_name() {
    does("", "Shift-Tab", PreviousPane);
    // What terminals call it is understood, too.
    does("", "BackTab", PreviousPane);
}

#[test]
fn digits_make_counts() {
    does("", "5", Digit(5));
    does("", "0", Walk(Walk::FirstStep));
    does("1", "0", Digit(0));
    does("7", "j", Down);
}

#[test]
fn pairs_and_what_only_looks_like_one() {
    does("", "z", Prefix('z'));
    does("z", "z", Center);
    does("z", "j", Unknown);
    does("", "Z", Unknown);
    does("", "^", Unknown);
    does("", "@", Unknown);
}
