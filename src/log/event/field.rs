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

/// An object or a light that a node or a decision names, by number.
pub enum Id<'i> {
    /// An object.
    Object(&'i mut u32),
    /// A light.
    Light(&'i mut u32),
}

/// What a field is, in memory and in a file.
pub trait FieldKind {
    /// Its type in memory.
    type Value;
    /// What files have.
    const OF: Of;
    /// Whether it may be absent there.
    const IS_OPTIONAL: bool = false;

    /// Hands on the object or the light that it is.
    fn each_id(_value: &mut Self::Value, _take: &mut impl FnMut(Id)) {}
}

/// An object, by number; a file has its name.
pub struct Object;
/// A light, by number; a file has its name.
pub struct Light;
/// A whole number, from `LEAST` on.
pub struct Whole<const LEAST: u32>;
/// The number, from 1, of one of several: 0 of what is alone, which a file leaves out.
pub struct Numbered;
/// Three numbers.
pub struct Triple;
/// A quantity; a file has its key.
pub struct Quantity;
/// What may be absent.
pub struct Optional<K>(PhantomData<K>);

impl FieldKind for Object {
    type Value = u32;
    const OF: Of = Of::Object;

    fn each_id(object: &mut u32, take: &mut impl FnMut(Id)) {
        take(Id::Object(object));
    }
}

impl FieldKind for Light {
    type Value = u32;
    const OF: Of = Of::Light;

    fn each_id(light: &mut u32, take: &mut impl FnMut(Id)) {
        take(Id::Light(light));
    }
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

    fn each_id(value: &mut Option<K::Value>, take: &mut impl FnMut(Id)) {
        if let Some(value) = value {
            K::each_id(value, take);
        }
    }
}

impl FieldKind for Numbered {
    type Value = u32;
    const OF: Of = Of::Whole(1);
    const IS_OPTIONAL: bool = true;
}
