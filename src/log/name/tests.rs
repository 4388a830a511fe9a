//! The table of names is in order, and its names can be told apart.

#![allow(clippy::unwrap_used)]

use super::*;
use std::collections::HashSet;

#[test]
fn rows_stand_in_the_order_of_the_variants() {
    for (index, (name, _)) in ROWS.iter().enumerate() {
        assert_eq!(*name as usize, index);
    }
}

#[test]
fn key_and_form_tell_every_name_apart() {
    let pairs: HashSet<_> = Name::all().map(|name| (name.key(), name.form())).collect();
    assert_eq!(pairs.len(), ROWS.len());
    for name in Name::all() {
        assert_eq!(Name::find(name.key(), name.form()), Some(name));
    }
}

#[test]
fn names_of_one_key_share_their_symbol() {
    for name in Name::all() {
        let first = ROWS.iter().find(|(_, row)| row.key == name.key()).unwrap().0;
        assert_eq!(name.symbol(), first.symbol(), "{}", name.key());
    }
}
