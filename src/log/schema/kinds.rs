//! What a line can say: the nodes that begin, the decisions, and the fields of each.

use crate::log::event::decision::decisions;
pub use crate::log::event::field::Of;
use crate::log::event::field::{FieldKind, Light, Object, Optional, Quantity, Triple, Whole};
use crate::log::event::{Acceptance, Asking, Miss, SkipReason, Split, Term};

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

/// A field that is always there.
const fn field(key: &'static str, value: Of) -> Field {
    Field { key, value, is_optional: false }
}

/// A field that may be absent.
const fn optional(key: &'static str, value: Of) -> Field {
    Field { key, value, is_optional: true }
}

const fn of<K: FieldKind>(key: &'static str) -> Field {
    Field { key, value: K::OF, is_optional: K::IS_OPTIONAL }
}

const fn kind(word: &'static str, fields: &'static [Field], meaning: &'static str) -> Kind {
    Kind { word, meaning, fields }
}

const OBJECT: Field = field("object", Of::Object);
const TRIANGLE: Field = optional("triangle", Of::Whole(0));
const SPLIT: Field = optional("split", Of::Whole(1));
const WHAT: Field = field("what", Term::OF);

fn kinds_of_rays() -> Vec<&'static str> {
    vec!["camera", "shadow", "reflected", "transmitted"]
}

/// The nodes. That of a pixel isn't among them: it is `{"pixel":[x,y]}`.
pub const STEPS: &[Kind] = &[
    kind("sample", &[field("number", Of::Whole(1))], "one of several samples of a pixel"),
    kind(
        "ray",
        &[field("kind", Of::Words(kinds_of_rays)), field("depth", Of::Whole(0)), optional("light", Of::Light), SPLIT],
        "a ray and all that it brings; depth is its level in the ray tree, light that of a shadow ray, split its number among several of a kind from one place",
    ),
    kind(
        "motion",
        &[OBJECT],
        "a moving object is tested: the ray in the object's frame, or the hit carried back from it",
    ),
    kind("test", &[OBJECT, TRIANGLE], "the ray is tested with an object; triangle is that of a mesh"),
    kind("shade", &[OBJECT], "the local model at the hit of the ray"),
    kind(
        "light",
        &[field("light", Of::Light), SPLIT],
        "what a light adds there; split is the number of a point of an area light",
    ),
    kind("zone", &[WHAT, field("number", Of::Whole(1))], "a zone of the lobe about a blurred bounce"),
    kind("combine", &[], "the weighted sum of the three contributions"),
];

macro_rules! define {
    ($($variant:ident $word:literal $meaning:literal $({ $($field:ident: $type:ty as $kind:ty,)* })?;)*) => {
        /// The decisions.
        pub const MARKS: &[Kind] = &[$(kind($word, &[$($(of::<$kind>(stringify!($field)),)*)?], $meaning),)*];
    };
}

decisions!(define);
