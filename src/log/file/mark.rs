//! Decisions in a line of a log, read and written as the table of [`decisions`] has them.

use super::line::Word;
use super::reader::Reader;
use super::write::{string, text, triple};
use crate::log::event::decision::decisions;
use crate::log::event::field::{FieldKind, Light, Object, Optional, Quantity, Triple, Whole};
use crate::log::event::{Acceptance, Asking, Decision, Miss, SkipReason, Split, Term};
use crate::log::header::Header;
use crate::log::name::Name;
use crate::log::whole;
use serde::Deserialize;

/// How a field is read and written.
pub(super) trait InFile: FieldKind {
    /// As it is read.
    type Read<'t>;

    /// What was read: names are looked up.
    fn resolve(read: Self::Read<'_>, reader: &Reader) -> Result<Self::Value, String>;

    /// Writes it, without its key.
    fn write(out: &mut Vec<u8>, header: &Header, value: &Self::Value);

    /// Whether it is there.
    fn is_there(_value: &Self::Value) -> bool {
        true
    }
}

impl InFile for Object {
    type Read<'t> = Word<'t>;

    fn resolve(name: Word, reader: &Reader) -> Result<u32, String> {
        reader.object(&name)
    }

    fn write(out: &mut Vec<u8>, header: &Header, object: &u32) {
        string(out, header.object(*object));
    }
}

impl InFile for Light {
    type Read<'t> = Word<'t>;

    fn resolve(name: Word, reader: &Reader) -> Result<u32, String> {
        reader.light(&name)
    }

    fn write(out: &mut Vec<u8>, header: &Header, light: &u32) {
        string(out, header.light(*light));
    }
}

impl<const LEAST: u32> InFile for Whole<LEAST> {
    type Read<'t> = whole::Whole<u32>;

    fn resolve(whole::Whole(number): whole::Whole<u32>, _: &Reader) -> Result<u32, String> {
        Ok(number)
    }

    fn write(out: &mut Vec<u8>, _: &Header, number: &u32) {
        text(out, &number.to_string());
    }
}

impl InFile for Triple {
    type Read<'t> = [f64; 3];

    fn resolve(numbers: [f64; 3], _: &Reader) -> Result<[f64; 3], String> {
        Ok(numbers)
    }

    fn write(out: &mut Vec<u8>, _: &Header, numbers: &[f64; 3]) {
        triple(out, numbers);
    }
}

impl InFile for Quantity {
    type Read<'t> = Word<'t>;

    fn resolve(key: Word, _: &Reader) -> Result<Name, String> {
        Name::all().find(|name| name.key() == &*key).ok_or_else(|| unknown("quantity", &key))
    }

    fn write(out: &mut Vec<u8>, _: &Header, quantity: &Name) {
        text(out, &format!("\"{}\"", quantity.key()));
    }
}

impl<K: InFile> InFile for Optional<K> {
    type Read<'t> = Option<K::Read<'t>>;

    fn resolve(read: Self::Read<'_>, reader: &Reader) -> Result<Option<K::Value>, String> {
        read.map(|read| K::resolve(read, reader)).transpose()
    }

    fn write(out: &mut Vec<u8>, header: &Header, value: &Option<K::Value>) {
        if let Some(value) = value {
            K::write(out, header, value);
        }
    }

    fn is_there(value: &Option<K::Value>) -> bool {
        value.is_some()
    }
}

macro_rules! words {
    ($($name:ident $called:literal,)*) => {$(
        impl InFile for $name {
            type Read<'t> = Word<'t>;

            fn resolve(word: Word, _: &Reader) -> Result<$name, String> {
                $name::find(&word).ok_or_else(|| unknown($called, &word))
            }

            fn write(out: &mut Vec<u8>, _: &Header, value: &$name) {
                text(out, &format!("\"{}\"", value.word()));
            }
        }
    )*};
}

words! {
    Miss "reason",
    Term "work",
    SkipReason "rule",
    Split "reason",
    Acceptance "reason",
    Asking "reason",
}

/// What messages say of a word that isn't in its list.
pub(super) fn unknown(what: &str, word: &str) -> String {
    format!("unknown {what} `{word}`")
}

/// Writes a field behind a decision's opening brace or behind another field.
fn field<K: InFile>(out: &mut Vec<u8>, header: &Header, key: &str, value: &K::Value) {
    if K::is_there(value) {
        text(out, if out.ends_with(b"{") { "\"" } else { ",\"" });
        text(out, key);
        text(out, "\":");
        K::write(out, header, value);
    }
}

macro_rules! define {
    ($($variant:ident $word:literal $meaning:literal $({ $($field:ident: $type:ty as $kind:ty,)* })?;)*) => {
        /// A decision as it is read.
        #[derive(Deserialize)]
        pub(super) enum Mark<'t> {
            $(
                #[serde(rename = $word)]
                $variant { $($(#[serde(borrow)] $field: <$kind as InFile>::Read<'t>,)*)? },
            )*
        }

        impl Mark<'_> {
            /// The decision, with objects and lights by number.
            pub fn decision(self, reader: &Reader) -> Result<Decision, String> {
                Ok(match self {
                    $(Mark::$variant { $($($field,)*)? } => {
                        Decision::$variant $({ $($field: <$kind as InFile>::resolve($field, reader)?,)* })?
                    })*
                })
            }
        }

        /// Writes the decision as the value of `mark`.
        pub(super) fn write_mark(out: &mut Vec<u8>, header: &Header, decision: &Decision) {
            match decision {
                $(Decision::$variant $({ $($field,)* })? => {
                    text(out, concat!("{\"", $word, "\":{"));
                    $($(field::<$kind>(out, header, stringify!($field), $field);)*)?
                })*
            }
            text(out, "}}");
        }
    };
}

decisions!(define);
