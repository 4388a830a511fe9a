//! What the fields of steps and decisions are.

use crate::log::name::Name;
use std::marker::PhantomData;

/// What the value of a field is, as files have it.
#[derive(Clone, Copy)]
pub enum Of {
    /// The name of an object, one of the header's.
    Object,
    /// The name of a light, one of the header's.
    Light,
    /// One of these words.
    Words(fn() -> Vec<&'static str>),
    /// A whole number, from this one on.
    Whole(u32),
    /// Three numbers.
    Triple,
    /// The key of a quantity.
    Quantity,
}

/// What a field is, in memory and in a file.
pub trait FieldKind {
    /// Its type in memory.
    type Value;
    /// What files have.
    const OF: Of;
    /// Whether it may be absent there.
    const IS_OPTIONAL: bool = false;
}

/// An object, by number; a file has its name.
pub struct Object;
/// A light, by number; a file has its name.
pub struct Light;
/// A whole number, from `LEAST` on.
pub struct Whole<const LEAST: u32>;
/// Three numbers.
pub struct Triple;
/// A quantity; a file has its key.
pub struct Quantity;
/// What may be absent.
pub struct Optional<K>(PhantomData<K>);

impl FieldKind for Object {
    type Value = u32;
    const OF: Of = Of::Object;
}

impl FieldKind for Light {
    type Value = u32;
    const OF: Of = Of::Light;
}

impl<const LEAST: u32> FieldKind for Whole<LEAST> {
    type Value = u32;
    const OF: Of = Of::Whole(LEAST);
}

impl FieldKind for Triple {
    type Value = [f64; 3];
    const OF: Of = Of::Triple;
}

impl FieldKind for Quantity {
    type Value = Name;
    const OF: Of = Of::Quantity;
}

impl<K: FieldKind> FieldKind for Optional<K> {
    type Value = Option<K::Value>;
    const OF: Of = K::OF;
    const IS_OPTIONAL: bool = true;
}
