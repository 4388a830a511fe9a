//! An adapter around a JSON deserializer that accepts exactly one spelling of everything.
//!
//! Derived serde code also takes an array for a struct, `null` for an optional key, `{"word": null}` for a word, and
//! leaves surplus elements of a vector to a later, puzzling error. [`Strict`] refuses all of these in their place.

use std::fmt;

use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, IgnoredAny, IntoDeserializer, MapAccess, SeqAccess, Unexpected,
    VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;

/// A self-describing deserializer (JSON), made strict.
pub struct Strict<D>(pub D);

/// What the visitor of a value is prepared to see.
#[derive(Clone, Copy)]
enum Form {
    Anything,
    Object,
    Tuple { length: usize },
    Variant { names: &'static [&'static str] },
}

impl<'de, D: Deserializer<'de>> Deserializer<'de> for Strict<D> {
    type Error = D::Error;

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct seq map
        identifier ignored_any
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
        self.expect(Form::Anything, visitor)
    }

    // A key that is there has a value: `null` is never one.
    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, D::Error> {
        self.expect(Form::Tuple { length }, visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        self.expect(Form::Tuple { length }, visitor)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        self.expect(Form::Object, visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        self.expect(Form::Variant { names }, visitor)
    }
}

impl<'de, D: Deserializer<'de>> Strict<D> {
    fn expect<V: Visitor<'de>>(self, form: Form, delegate: V) -> Result<V::Value, D::Error> {
        self.0.deserialize_any(StrictVisitor { delegate, form })
    }
}

struct StrictVisitor<V> {
    delegate: V,
    form: Form,
}

impl<'de, V: Visitor<'de>> StrictVisitor<V> {
    /// Hands a plain value on, unless an enum is wanted, which the derived visitor would report in words for programmers.
    fn plain<E: Error>(self, found: Unexpected, visit: impl FnOnce(V) -> Result<V::Value, E>) -> Result<V::Value, E> {
        match self.form {
            Form::Variant { .. } => Err(E::invalid_type(found, &self)),
            Form::Anything | Form::Object | Form::Tuple { .. } => visit(self.delegate),
        }
    }
}

impl<'de, V: Visitor<'de>> Visitor<'de> for StrictVisitor<V> {
    type Value = V::Value;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self.form {
            Form::Variant { names } => {
                let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
                write!(formatter, "one of {}", quoted.join(", "))
            }
            Form::Object => formatter.write_str("an object"),
            Form::Anything | Form::Tuple { .. } => self.delegate.expecting(formatter),
        }
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<V::Value, E> {
        self.plain(Unexpected::Bool(value), |delegate| delegate.visit_bool(value))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<V::Value, E> {
        self.plain(Unexpected::Signed(value), |delegate| delegate.visit_i64(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<V::Value, E> {
        self.plain(Unexpected::Unsigned(value), |delegate| delegate.visit_u64(value))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<V::Value, E> {
        self.plain(Unexpected::Float(value), |delegate| delegate.visit_f64(value))
    }

    fn visit_unit<E: Error>(self) -> Result<V::Value, E> {
        self.plain(Unexpected::Unit, |delegate| delegate.visit_unit())
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<V::Value, E> {
        match self.form {
            Form::Variant { .. } => self.delegate.visit_enum(Word::<E>(value, Default::default())),
            Form::Anything | Form::Object | Form::Tuple { .. } => self.delegate.visit_str(value),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<V::Value, A::Error> {
        match self.form {
            Form::Object | Form::Variant { .. } => Err(A::Error::invalid_type(Unexpected::Seq, &self)),
            Form::Anything => self.delegate.visit_seq(Elements(elements)),
            Form::Tuple { length } => {
                let value = self.delegate.visit_seq(Elements(&mut elements))?;
                let mut found = length;
                while elements.next_element::<IgnoredAny>()?.is_some() {
                    found += 1;
                }
                if found > length {
                    let expected = format!("an array of length {length}");
                    return Err(A::Error::invalid_length(found, &expected.as_str()));
                }
                Ok(value)
            }
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<V::Value, A::Error> {
        match self.form {
            Form::Anything | Form::Object | Form::Tuple { .. } => self.delegate.visit_map(Entries(entries)),
            Form::Variant { .. } => {
                let value = self.delegate.visit_enum(Variant(&mut entries))?;
                match entries.next_key::<String>()? {
                    None => Ok(value),
                    Some(second) => Err(A::Error::custom(format_args!(
                        "expected an object with exactly one key, found a second one, `{second}`"
                    ))),
                }
            }
        }
    }
}

struct Elements<A>(A);

impl<'de, A: SeqAccess<'de>> SeqAccess<'de> for Elements<A> {
    type Error = A::Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, A::Error> {
        self.0.next_element_seed(StrictSeed(seed))
    }
}

struct Entries<A>(A);

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Entries<A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        self.0.next_key_seed(seed)
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, A::Error> {
        self.0.next_value_seed(StrictSeed(seed))
    }
}

struct StrictSeed<T>(T);

impl<'de, T: DeserializeSeed<'de>> DeserializeSeed<'de> for StrictSeed<T> {
    type Value = T::Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<T::Value, D::Error> {
        self.0.deserialize(Strict(deserializer))
    }
}

/// An enum written as an object of one key.
struct Variant<'m, A>(&'m mut A);

impl<'de, A: MapAccess<'de>> EnumAccess<'de> for Variant<'_, A> {
    type Error = A::Error;
    type Variant = Self;

    fn variant_seed<K: DeserializeSeed<'de>>(self, seed: K) -> Result<(K::Value, Self), A::Error> {
        match self.0.next_key_seed(seed)? {
            Some(name) => Ok((name, self)),
            None => Err(A::Error::custom("expected an object with exactly one key, found none")),
        }
    }
}

impl<'de, A: MapAccess<'de>> VariantAccess<'de> for Variant<'_, A> {
    type Error = A::Error;

    fn unit_variant(self) -> Result<(), A::Error> {
        Err(A::Error::custom("expected the word alone, as a string, found it as a key"))
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, A::Error> {
        self.0.next_value_seed(StrictSeed(seed))
    }

    fn tuple_variant<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, A::Error> {
        let form = Form::Tuple { length };
        self.0.next_value_seed(FormSeed { form, visitor })
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, A::Error> {
        let form = Form::Object;
        self.0.next_value_seed(FormSeed { form, visitor })
    }
}

struct FormSeed<V> {
    form: Form,
    visitor: V,
}

impl<'de, V: Visitor<'de>> DeserializeSeed<'de> for FormSeed<V> {
    type Value = V::Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<V::Value, D::Error> {
        Strict(deserializer).expect(self.form, self.visitor)
    }
}

/// An enum written as a string: good for words only.
struct Word<'s, E>(&'s str, std::marker::PhantomData<E>);

impl<'de, E: Error> EnumAccess<'de> for Word<'_, E> {
    type Error = E;
    type Variant = Self;

    fn variant_seed<K: DeserializeSeed<'de>>(self, seed: K) -> Result<(K::Value, Self), E> {
        Ok((seed.deserialize(self.0.into_deserializer())?, self))
    }
}

impl<E: Error> Word<'_, E> {
    fn needs_value<T>(self) -> Result<T, E> {
        let word = self.0;
        Err(E::custom(format_args!("expected an object, `{{\"{word}\": …}}`, found the word alone")))
    }
}

impl<'de, E: Error> VariantAccess<'de> for Word<'_, E> {
    type Error = E;

    fn unit_variant(self) -> Result<(), E> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, _seed: T) -> Result<T::Value, E> {
        self.needs_value()
    }

    fn tuple_variant<V: Visitor<'de>>(self, _length: usize, _visitor: V) -> Result<V::Value, E> {
        self.needs_value()
    }

    fn struct_variant<V: Visitor<'de>>(self, _fields: &'static [&'static str], _visitor: V) -> Result<V::Value, E> {
        self.needs_value()
    }
}
