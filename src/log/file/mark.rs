//! Nodes and decisions in a line of a log, read and written as the tables of [`steps`] and [`decisions`] have them.

use super::numbers::Lookup;
use super::spelling::{Word, string, text, triple};
use crate::log::event::decision::decisions;
use crate::log::event::field::{FieldKind, Light, Numbered, Object, Optional, Quantity, Triple, Whole};
use crate::log::event::step::steps;
use crate::log::event::{Acceptance, Asking, Decision, Miss, RayKind, SkipReason, Split, Step, Term};
use crate::log::header::Header;
use crate::log::name::Name;
use crate::log::whole;
use serde::Deserialize;
use std::io::Write;

/// How a field is read and written.
pub(super) trait InFile: FieldKind {
    /// As it is read.
    type Read<'t>;

    /// What was read: names are looked up.
    fn resolve(read: Self::Read<'_>, lookup: &Lookup) -> Result<Self::Value, String>;

    /// Writes it, without its key.
    fn write(out: &mut Vec<u8>, header: &Header, value: &Self::Value);

    /// Whether it is there.
    fn is_there(_value: &Self::Value) -> bool {
        true
    }
}

impl InFile for Object {
    type Read<'t> = Word<'t>;

    fn resolve(name: Word, lookup: &Lookup) -> Result<u32, String> {
        lookup.object(&name)
    }

    fn write(out: &mut Vec<u8>, header: &Header, object: &u32) {
        string(out, header.object(*object));
    }
}

impl InFile for Light {
    type Read<'t> = Word<'t>;

    fn resolve(name: Word, lookup: &Lookup) -> Result<u32, String> {
        lookup.light(&name)
    }

    fn write(out: &mut Vec<u8>, header: &Header, light: &u32) {
        string(out, header.light(*light));
    }
}

impl<const LEAST: u32> InFile for Whole<LEAST> {
    type Read<'t> = whole::Whole<u32>;

    fn resolve(whole::Whole(number): whole::Whole<u32>, _: &Lookup) -> Result<u32, String> {
        Ok(number)
    }

    fn write(out: &mut Vec<u8>, _: &Header, number: &u32) {
        // Writing to memory can't fail.
        let _ = write!(out, "{number}");
    }
}

impl InFile for Triple {
    type Read<'t> = [f64; 3];

    fn resolve(numbers: [f64; 3], _: &Lookup) -> Result<[f64; 3], String> {
        Ok(numbers)
    }

    fn write(out: &mut Vec<u8>, _: &Header, numbers: &[f64; 3]) {
        triple(out, numbers);
    }
}

impl InFile for Quantity {
    type Read<'t> = Word<'t>;

    fn resolve(key: Word, _: &Lookup) -> Result<Name, String> {
        Name::with_key(&key).ok_or_else(|| unknown("quantity", &key))
    }

    fn write(out: &mut Vec<u8>, _: &Header, quantity: &Name) {
        text(out, &format!("\"{}\"", quantity.key()));
    }
}

impl<K: InFile> InFile for Optional<K> {
    type Read<'t> = Option<K::Read<'t>>;

    fn resolve(read: Self::Read<'_>, lookup: &Lookup) -> Result<Option<K::Value>, String> {
        read.map(|read| K::resolve(read, lookup)).transpose()
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

            fn resolve(word: Word, _: &Lookup) -> Result<$name, String> {
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

impl InFile for Numbered {
    type Read<'t> = Option<whole::Whole<u32>>;

    fn resolve(number: Option<whole::Whole<u32>>, _: &Lookup) -> Result<u32, String> {
        Ok(number.unwrap_or_default().0)
    }

    fn write(out: &mut Vec<u8>, header: &Header, number: &u32) {
        Whole::<1>::write(out, header, number);
    }

    fn is_there(number: &u32) -> bool {
        *number > 0
    }
}

/// Writes a field behind an opening brace or behind another field.
fn field<K: InFile>(out: &mut Vec<u8>, header: &Header, key: &str, value: &K::Value) {
    if K::is_there(value) {
        text(out, if out.ends_with(b"{") { "\"" } else { ",\"" });
        text(out, key);
        text(out, "\":");
        K::write(out, header, value);
    }
}

/// How a node is read and written that has no row in the table.
pub(super) trait OwnLine {
    /// As it is read.
    type Read<'t>;

    /// The node, with objects and lights by number.
    fn resolve(read: Self::Read<'_>, lookup: &Lookup) -> Result<Step, String>;

    /// Writes what is behind the word of the node, which is one of these.
    fn write(out: &mut Vec<u8>, header: &Header, step: &Step);
}

pub(super) struct PixelLine;

impl OwnLine for PixelLine {
    type Read<'t> = [whole::Whole<u32>; 2];

    fn resolve(read: Self::Read<'_>, _: &Lookup) -> Result<Step, String> {
        Ok(Step::Pixel(read.map(|whole::Whole(side)| side)))
    }

    fn write(out: &mut Vec<u8>, _: &Header, step: &Step) {
        if let Step::Pixel([x, y]) = step {
            text(out, &format!("[{x},{y}]"));
        }
    }
}

pub(super) struct RayLine;

#[derive(Deserialize)]
pub(super) struct ReadRay<'t> {
    #[serde(borrow)]
    kind: Word<'t>,
    depth: whole::Whole<u32>,
    #[serde(borrow)]
    light: Option<Word<'t>>,
    split: Option<whole::Whole<u32>>,
}

impl OwnLine for RayLine {
    type Read<'t> = ReadRay<'t>;

    fn resolve(read: ReadRay, lookup: &Lookup) -> Result<Step, String> {
        let is_shadow = *read.kind == *RayKind::Shadow { light: 0 }.word();
        let light = read.light.filter(|_| is_shadow).map(|light| lookup.light(&light)).transpose()?;
        let kind = RayKind::find(&read.kind, light).ok_or_else(|| unknown("kind of ray", &read.kind))?;
        Ok(Step::Ray { kind, depth: read.depth.0, split: Numbered::resolve(read.split, lookup)? })
    }

    fn write(out: &mut Vec<u8>, header: &Header, step: &Step) {
        if let Step::Ray { kind, depth, split } = step {
            text(out, "{\"kind\":\"");
            text(out, kind.word());
            text(out, "\"");
            field::<Whole<0>>(out, header, "depth", depth);
            field::<Optional<Light>>(out, header, "light", &kind.light());
            field::<Numbered>(out, header, "split", split);
            text(out, "}");
        }
    }
}

macro_rules! lines {
    (
        $(#[$doc:meta])* $type:ident $read:ident $write:ident { $($own:ident $own_word:literal $own_line:ident,)* }
        $($variant:ident $word:literal $meaning:literal $({ $($(#[$of:meta])* $field:ident: $value:ty as $kind:ty,)* })?;)*
    ) => {
        $(#[$doc])*
        #[derive(Deserialize)]
        pub(super) enum $read<'t> {
            $(
                #[serde(rename = $own_word, borrow)]
                $own(<$own_line as OwnLine>::Read<'t>),
            )*
            $(
                #[serde(rename = $word)]
                $variant { $($(#[serde(borrow)] $field: <$kind as InFile>::Read<'t>,)*)? },
            )*
        }

        impl $read<'_> {
            /// What it says, with objects and lights by number.
            pub fn resolve(self, lookup: &Lookup) -> Result<$type, String> {
                Ok(match self {
                    $($read::$own(line) => $own_line::resolve(line, lookup)?,)*
                    $($read::$variant { $($($field,)*)? } => {
                        $type::$variant $({ $($field: <$kind as InFile>::resolve($field, lookup)?,)* })?
                    })*
                })
            }
        }

        /// Writes it as an object with one key.
        pub(super) fn $write(out: &mut Vec<u8>, header: &Header, said: &$type) {
            match said {
                $($type::$own { .. } => {
                    text(out, concat!("{\"", $own_word, "\":"));
                    $own_line::write(out, header, said);
                })*
                $($type::$variant $({ $($field,)* })? => {
                    text(out, concat!("{\"", $word, "\":{"));
                    $($(field::<$kind>(out, header, stringify!($field), $field);)*)?
                    text(out, "}");
                })*
            }
            text(out, "}");
        }
    };
}

steps! { lines
    /// A node as it is read.
    Step Enter write_enter { Pixel "pixel" PixelLine, Ray "ray" RayLine, }
}
decisions! { lines
    /// A decision as it is read.
    Decision Mark write_mark {}
}
