//! What a row of the table of names is: the macro that declares it, and how a name gives what is in it.

use super::{Name, ROWS, Unit};
use std::collections::HashMap;
use std::sync::LazyLock;

/// Declares [`Name`] from rows `Variant: key, form, symbol, formula, source section, unit`; of a triple `[unit; 3]`.
macro_rules! names {
    ($($variant:ident: $key:literal, $form:literal, $symbol:literal, $formula:literal, $section:literal, $unit:tt;)*) => {
        /// A named quantity of the computation.
        ///
        /// Several names may share a key: they are the same quantity computed by different formulas, distinguished in the
        /// log by their `form`.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
        #[repr(u16)]
        pub enum Name {
            $(#[doc = concat!("`", $key, "`: ", $symbol, " = ", $formula)] $variant,)*
        }

        const ROWS: &[(Name, Row)] = &[$((Name::$variant, Row {
            key: $key, form: $form, symbol: $symbol, formula: $formula, section: $section, unit: unit!($unit), is_triple: is_triple!($unit),
        }),)*];
    };
}

macro_rules! unit {
    ([$unit:ident; 3]) => {
        Unit::$unit
    };
    ($unit:ident) => {
        Unit::$unit
    };
}

macro_rules! is_triple {
    ([$unit:ident; 3]) => {
        true
    };
    ($unit:ident) => {
        false
    };
}

/// A row of the table.
pub(super) struct Row {
    pub key: &'static str,
    pub form: &'static str,
    pub symbol: &'static str,
    pub formula: &'static str,
    pub section: &'static str,
    pub unit: Unit,
    pub is_triple: bool,
}

impl Name {
    /// Every name, in the order of the table.
    pub fn all() -> impl Iterator<Item = Name> {
        ROWS.iter().map(|(name, _)| *name)
    }

    /// The name with this key and form, if there is one.
    pub fn find(key: &str, form: &str) -> Option<Name> {
        static NAMES: LazyLock<HashMap<(&str, &str), Name>> =
            LazyLock::new(|| ROWS.iter().map(|(name, row)| ((row.key, row.form), *name)).collect());
        NAMES.get(&(key, form)).copied()
    }

    /// The first name with this key.
    pub fn with_key(key: &str) -> Option<Name> {
        Name::all().find(|name| name.key() == key)
    }

    /// The first name with its key, which represents the quantity by whatever formula.
    pub fn quantity(self) -> Name {
        static FIRST: LazyLock<Vec<Name>> =
            LazyLock::new(|| Name::all().map(|name| Name::with_key(name.key()).unwrap_or(name)).collect());
        FIRST[self as usize]
    }

    /// Whether both are the same quantity, by whatever formula.
    pub fn is(self, other: Name) -> bool {
        self == other || self.quantity() == other.quantity()
    }

    /// The key of the quantity in a log, such as `sphere.t2_a`.
    pub fn key(self) -> &'static str {
        self.row().key
    }

    /// Which of several formulas gave the quantity, such as `far`; empty for the usual one.
    pub fn form(self) -> &'static str {
        self.row().form
    }

    /// The symbol of the quantity in formulas, such as `T2_A`.
    pub fn symbol(self) -> &'static str {
        self.row().symbol
    }

    /// The formula text, such as `r² − L2oc + T_A²`; `None` for what is given.
    pub fn formula(self) -> Option<&'static str> {
        Some(self.row().formula).filter(|text| !text.is_empty())
    }

    /// The section of the source text (Ramos, "Trazado de rayos") that has the quantity; empty where the text has no formula for it.
    pub fn section(self) -> &'static str {
        self.row().section
    }

    /// What the quantity is measured in.
    pub fn unit(self) -> Unit {
        self.row().unit
    }

    /// Whether its values are triples (points, vectors, colours) and not numbers.
    pub fn is_triple(self) -> bool {
        self.row().is_triple
    }

    /// Whether the quantity was computed with twice the digits of f64, its operands too, and rounded once in the end.
    pub fn is_doubled(self) -> bool {
        self.form().starts_with("doubled") || self.formula().is_some_and(|text| text.starts_with("Σ_"))
    }

    fn row(self) -> &'static Row {
        &ROWS[self as usize].1
    }
}
