//! What a line can say: the nodes that begin, the decisions, and the fields of each.

use crate::log::event::decision::decisions;
pub use crate::log::event::field::Of;
use crate::log::event::field::{FieldKind, Light, Numbered, Object, Optional, Quantity, Triple, Whole};
use crate::log::event::step::steps;
use crate::log::event::{Acceptance, Asking, Miss, RayKind, SkipReason, Split, Term};

/// A node or a decision, as the key in its line.
pub struct Kind {
    /// The key.
    pub word: &'static str,
    /// What it means.
    pub meaning: &'static str,
    /// What is in its object.
    pub fields: &'static [Field],
}

/// A field of a node or a decision.
pub struct Field {
    /// Its key.
    pub key: &'static str,
    /// What its value is.
    pub value: Of,
    /// Whether it may be absent.
    pub is_optional: bool,
}

const fn of<K: FieldKind>(key: &'static str) -> Field {
    Field { key, value: K::OF, is_optional: K::IS_OPTIONAL }
}

const fn kind(word: &'static str, fields: &'static [Field], meaning: &'static str) -> Kind {
    Kind { word, meaning, fields }
}

const RAY: Kind = kind(
    "ray",
    &[
        Field { key: "kind", value: Of::Words(|| RayKind::WORDS.to_vec()), is_optional: false },
        of::<Whole<0>>("depth"),
        of::<Optional<Light>>("light"),
        of::<Numbered>("split"),
    ],
    "a ray and everything traced for it; depth is its level in the ray tree, light that of a shadow ray, split its number among several of a kind from one place",
);

macro_rules! kinds {
    (
        $(#[$doc:meta])* $name:ident [$($own:ident)?]
        $($variant:ident $word:literal $meaning:literal $({ $($(#[$of:meta])* $field:ident: $type:ty as $kind:ty,)* })?;)*
    ) => {
        $(#[$doc])*
        pub const $name: &[Kind] = &[$($own,)? $(kind($word, &[$($(of::<$kind>(stringify!($field)),)*)?], $meaning),)*];
    };
}

steps! { kinds
    /// The nodes but for that of a pixel, which has no fields by name: it is `{"pixel":[x,y]}`.
    STEPS [RAY]
}
decisions! { kinds
    /// The decisions.
    MARKS []
}
