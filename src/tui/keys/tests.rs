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
    assert_eq!(action(&Bindings::default(), &pending, parse(key).unwrap()), Some(expected), "{typed}{key}");
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
    does("", "&", Unknown);
    does("", "^", Unknown);
    does("", "~", Unknown);
}

#[test]
fn every_action_has_a_name_of_its_own() {
    let mut names: Vec<_> = rows().map(Row::name).collect();
    assert_eq!([&names[0], &names[9]], ["next-value", "in"]);
    let count = names.len();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), count);
    assert!(names.iter().all(|name| name.chars().all(|c| c.is_ascii_lowercase() || c == '-')), "{names:?}");
}

/// The keys of the table but for these.
#[track_caller]
fn bound(keys: &[(&str, &str)]) -> Bindings {
    let mut bindings = Bindings::default();
    for (key, to) in keys {
        bind(&mut bindings, key, to, |_| Ok(())).unwrap();
    }
    bindings
}

#[track_caller]
fn types(bindings: &Bindings, keys: &str, expected: Action) {
    let mut pending = Pending::default();
    let mut last = None;
    for key in sequence(keys) {
        last = super::action(bindings, &pending, key);
        pending = match last {
            Some(Prefix(first)) => Pending { prefix: Some(first), ..pending },
            Some(Digit(digit)) => Pending { count: Some(digit.into()), ..pending },
            _ => Pending::default(),
        };
    }
    assert_eq!(last, Some(expected), "{keys}");
}

#[test]
fn bound_keys_do_what_they_are_bound_to() {
    let own = bound(&[
        ("ctrl-n", "next-value"),
        ("n", "none"),
        ("X", ":pixel 3,4"),
        ("F5", ":quit"),
        ("A", "mark"),
        ("m", "up"),
        ("gg", "first"),
        ("g", "none"),
        ("zz", "none"),
    ]);
    types(&own, "^n", NextValue);
    types(&own, "n", Unknown);
    types(&own, "N", PreviousValue);
    // By their order.
    types(&own, "F5", Line(0));
    types(&own, "X", Line(1));
    types(&own, "Ab", Walk(Walk::Mark('b')));
    types(&own, "A1", Walk(Walk::Mark('1')));
    types(&own, "m", Up);
    types(&own, "gg", First);
    types(&own, "gx", Unknown);
    types(&own, "zz", Unknown);
    types(&own, "zo", OnlyPane);
    types(&own, "''", Walk(Walk::GoTo('\'')));
    types(&own, "5^n", NextValue);
}

#[test]
fn keys_in_force_are_shown() {
    let own = bound(&[("X", "next-value"), ("n", "none"), ("A", "mark"), ("w", "none"), ("q", "help")]);
    let keys_of = |name: &str| in_force(&own, rows().find(|row| row.name() == name).unwrap());
    assert_eq!(keys_of("next-value"), ["X"]);
    assert_eq!(keys_of("previous-value"), ["N", "p"]);
    assert_eq!(keys_of("mark"), ["m+letter", "A+letter"]);
    assert_eq!(keys_of("help"), ["?", "F1", "q"]);
    assert_eq!(keys_of("quit"), [""; 0]);
    assert_eq!(keys_of("delete"), ["d"]);
    let now = |hint: &str| super::hint(&own, hint);
    assert_eq!(["n next value", "j k move", "w why", "q quit"].map(now), ["X next value", "j k move", "", ""]);
    assert_eq!(now("; next  , previous"), "; next  , previous");
    assert_eq!(now("n select, w goes, Esc closes"), "X select, Esc closes");
    assert_eq!(super::hint(&Bindings::default(), "w why"), "w why");
}

#[test]
fn control_keys_may_be_written_in_words() {
    assert_eq!(chord("ctrl-N"), chord("^n"));
    assert_eq!(chord("<C-n>"), chord("^n"));
    assert_eq!(chord("Ctrl-x").unwrap().text(), "^x");
    assert_eq!([chord(""), chord("abc"), chord("^aa"), chord("Tab Tab")], [None, None, None, None]);
}
