//! The table of names is in order, and its names can be distinguished.

#![allow(clippy::unwrap_used)]

use super::*;
use crate::log::formula::{self, Formula, Operator, Several, Unary};
use std::collections::HashSet;

#[test]
fn rows_are_in_the_order_of_the_variants() {
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
fn names_of_one_key_share_their_symbol_and_unit() {
    for name in Name::all() {
        let first = ROWS.iter().find(|(_, row)| row.key == name.key()).unwrap().0;
        let facts = |name: Name| (name.symbol(), name.unit(), name.is_triple());
        assert_eq!(facts(name), facts(first), "{}", name.key());
    }
}

/// The exponents of a formula's value; `None` for a literal 0, which has any unit.
type Dimension = Option<[i32; 4]>;

/// The dimension of a formula that is this name's.
fn dimension(of_name: Name, formula: &Formula) -> Result<Dimension, String> {
    let of = |inner: &Formula| dimension(of_name, inner);
    let number = |inner: &Formula| match of(inner)? {
        None | Some([0, 0, 0, 0]) => Ok(Some([0; 4])),
        other => Err(format!("{inner:?} is {other:?}, expected a number")),
    };
    let same = |left: Dimension, right: Dimension| match (left, right) {
        (Some(left), Some(right)) if left != right => Err(format!("{left:?} and {right:?} in {formula:?}")),
        (left, right) => Ok(left.or(right)),
    };
    let joined = |left: &Formula, right: &Formula, sign: i32| {
        let (left, right) = (of(left)?.unwrap_or([0; 4]), of(right)?.unwrap_or([0; 4]));
        Ok(Some([0, 1, 2, 3].map(|i| left[i] + sign * right[i])))
    };
    match formula {
        Formula::Number(0.0) => Ok(None),
        Formula::Number(_) => Ok(Some([0; 4])),
        Formula::Leaf(symbol) => unit_of(of_name, symbol).map(Some),
        Formula::Triple(components) => {
            components.iter().try_fold(None, |dimension, component| same(dimension, of(component)?))
        }
        Formula::Unary(unary, inner) => match unary {
            Unary::Over(Several::Freedom) => Ok(Some([0; 4])),
            Unary::Negated
            | Unary::Grouped
            | Unary::Length
            | Unary::OverLights
            | Unary::Over(_)
            | Unary::ExtremeComponent(_) => of(inner),
            Unary::Degrees => match of(inner)? {
                Some([0, 0, 0, 1]) => Ok(Some([0; 4])),
                other => Err(format!("{inner:?} is {other:?}, expected an angle")),
            },
            Unary::Function(_) | Unary::Positive | Unary::Floor => number(inner),
            Unary::Squared => joined(inner, inner, 1),
            Unary::Root => match of(inner)? {
                Some(exponents) if exponents.iter().any(|exponent| exponent % 2 != 0) => {
                    Err(format!("√ of {exponents:?}"))
                }
                exponents => Ok(exponents.map(|exponents| exponents.map(|exponent| exponent / 2))),
            },
        },
        Formula::Binary(operator, left, right) => match operator {
            Operator::Plus | Operator::Minus | Operator::Extreme(_) => same(of(left)?, of(right)?),
            Operator::Times | Operator::Channelwise | Operator::Cross => joined(left, right, 1),
            Operator::Over | Operator::ComponentsOver => joined(left, right, -1),
            Operator::Power | Operator::Quantile => number(left).and(number(right)),
        },
    }
}

/// The dimension of a symbol: that of the quantities of the same shape, if one of them has it, else that of all. The shape is in
/// the key or, of a hit's point and normal, in the form.
fn unit_of(of_name: Name, symbol: &str) -> Result<[i32; 4], String> {
    let kind = |name: &Name| name.key().split('.').next().unwrap_or("");
    let all: Vec<Name> = Name::all().filter(|name| name.symbol() == symbol).collect();
    let is_own = |name: &&Name| kind(name) == kind(&of_name) || of_name.form().contains(kind(name));
    let own: Vec<Name> = all.iter().filter(is_own).copied().collect();
    let meant = if own.is_empty() { all } else { own };
    let dimensions: HashSet<_> = meant.iter().map(|name| name.unit().dimension()).collect();
    match dimensions.iter().next() {
        Some(dimension) if dimensions.len() == 1 => Ok(*dimension),
        _ => Err(format!("`{symbol}` may be {dimensions:?}")),
    }
}

#[test]
fn every_formula_agrees_with_the_units() {
    for name in Name::all() {
        let Some(formula) = formula::of(name) else { continue };
        let expected = name.unit().dimension();
        match dimension(name, formula) {
            Ok(found) => assert!(found.is_none_or(|found| found == expected), "{name:?}: {found:?}, not {expected:?}"),
            Err(why) => panic!("{name:?}: {why}"),
        }
    }
}

#[test]
fn wrong_formulas_disagree() {
    for (key, wrong) in [
        ("sphere.t2_a", "r² − L2oc + T_A"),
        ("sphere.t2_a", "r − L2oc + T_A²"),
        ("sphere.t", "T_A − T2_A"),
        ("hit.point", "O + d"),
        ("shade.local", "I_a∘K_a + K_d"),
        ("plane.t", "V_d/V_o"),
        ("pattern.cell", "⌊P⌋"),
        ("motion.shift", "v_M + t_now"),
        ("refract.cos_2", "√(η² − |ℓ|)/η"),
    ] {
        let name = Name::all().find(|name| name.key() == key).unwrap();
        let found = dimension(name, &formula::parse(wrong).unwrap());
        assert!(found.is_err() || found != Ok(Some(name.unit().dimension())), "{key}: {wrong}");
    }
}
