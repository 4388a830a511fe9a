//! What a line can say: the nodes that begin, the decisions, and the fields of each.

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

/// What the value of a field is.
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

/// A field that is always there.
const fn field(key: &'static str, value: Of) -> Field {
    Field { key, value, is_optional: false }
}

/// A field that may be absent.
const fn optional(key: &'static str, value: Of) -> Field {
    Field { key, value, is_optional: true }
}

const fn kind(word: &'static str, fields: &'static [Field], meaning: &'static str) -> Kind {
    Kind { word, meaning, fields }
}

const OBJECT: Field = field("object", Of::Object);
const TRIANGLE: Field = optional("triangle", Of::Whole(0));
const SPLIT: Field = optional("split", Of::Whole(1));
const WHAT: Field = field("what", Of::Words(term));

fn term() -> Vec<&'static str> {
    Term::ALL.iter().map(|what| what.word()).collect()
}

fn kinds_of_rays() -> Vec<&'static str> {
    vec!["camera", "shadow", "reflected", "transmitted"]
}

fn misses() -> Vec<&'static str> {
    Miss::ALL.iter().map(|why| why.word()).collect()
}

fn rules() -> Vec<&'static str> {
    SkipReason::ALL.iter().map(|why| why.word()).collect()
}

fn splits() -> Vec<&'static str> {
    Split::ALL.iter().map(|why| why.word()).collect()
}

fn askings() -> Vec<&'static str> {
    Asking::ALL.iter().map(|why| why.word()).collect()
}

fn acceptances() -> Vec<&'static str> {
    Acceptance::ALL.iter().map(|why| why.word()).collect()
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

/// The decisions.
pub const MARKS: &[Kind] = &[
    kind("hit", &[], "the tested object lies on the ray"),
    kind("miss", &[field("why", Of::Words(misses))], "it doesn't"),
    kind("outside", &[], "the ray begins outside the tested solid"),
    kind("inside", &[], "the ray begins inside it"),
    kind("nearest", &[OBJECT], "this object is the nearest on the ray"),
    kind("coincident", &[OBJECT, TRIANGLE], "another surface in the same place, which counts as lying just behind"),
    kind("immersed", &[OBJECT], "the ray begins inside this medium; of several the innermost comes last"),
    kind("background", &[], "the ray leaves the scene and gets the background's colour"),
    kind("free", &[], "nothing weakens the light on the way of the shadow ray, or from a point in full view"),
    kind("occluded", &[OBJECT], "the shadow ray ends at an opaque object"),
    kind(
        "attenuated",
        &[OBJECT, field("factor", Of::Triple)],
        "it passes a surface that lets this part of the light through, per channel",
    ),
    kind(
        "undefined",
        &[field("quantity", Of::Quantity)],
        "the quantity has no value in this arithmetic, and the computation goes on without it",
    ),
    kind("total_internal_reflection", &[], "no ray can be transmitted here"),
    kind("depth_limit", &[WHAT], "a bounce isn't traced because it would lie too deep in the ray tree"),
    kind(
        "leak_guard",
        &[WHAT],
        "what was traced counts as black: the interpolated normal put it on a side where it isn't",
    ),
    kind("bent", &[WHAT], "the direction ran below the surface, and was bent up to the nearest one above"),
    kind("rejected", &[WHAT], "a direction of a blurred bounce lies on the wrong side; the mean is over the others"),
    kind("skipped", &[WHAT, field("why", Of::Words(rules))], "work isn't done because it can't change the colour"),
    kind(
        "subdivided",
        &[field("cell", Of::Triple), field("why", Of::Words(splits)), optional("object", Of::Object)],
        "a cell of the pixel (left, top, side; in pixels) is cut in four; object is the one that no corner hit",
    ),
    kind(
        "accepted",
        &[optional("cell", Of::Triple), field("why", Of::Words(acceptances))],
        "what is known of a cell, or without one of the pixel, is enough",
    ),
    kind(
        "asked",
        &[
            field("light", Of::Light),
            field("why", Of::Words(askings)),
            field("points", Of::Whole(1)),
            optional("object", Of::Object),
        ],
        "this many points of an area light with `min` and `max` are asked",
    ),
    kind(
        "more_samples",
        &[field("from", Of::Whole(0)), field("to", Of::Whole(0))],
        "the samples so far aren't enough: how many there are, and will be",
    ),
];
