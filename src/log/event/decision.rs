//! The decisions of a computation: the one table from which their type, their lines in a file, and the page and the schema of the format follow.

use super::field::{FieldKind, Id, Light, Object, Optional, Quantity, Triple, Whole};
use super::{Acceptance, Asking, Miss, SkipReason, Split, Term};
use crate::log::name::Name;

/// Passes the table to a macro, after the tokens meant for that macro alone. A row has a variant, its word in a log, what it means, and its fields: each with its type here, and with the
/// [`FieldKind`](super::field::FieldKind) that says how files have it.
macro_rules! decisions {
    ($with:ident $($more:tt)*) => {
        $with! {
            $($more)*
            Hit "hit" "the tested object lies on the ray";
            Miss "miss" "it doesn't" {
                why: Miss as Miss,
            };
            Outside "outside" "the ray begins outside the tested solid";
            Inside "inside" "the ray begins inside it";
            Nearest "nearest" "this object is the nearest on the ray" {
                object: u32 as Object,
            };
            Coincident "coincident" "another surface in the same place, which counts as lying just behind" {
                object: u32 as Object,
                triangle: Option<u32> as Optional<Whole<0>>,
            };
            Immersed "immersed" "the ray begins inside this medium; of several the innermost comes last" {
                object: u32 as Object,
            };
            Background "background" "the ray leaves the scene and gets the background's colour";
            Free "free" "nothing weakens the light on the way of the shadow ray, or from a point in full view";
            Occluded "occluded" "the shadow ray ends at an opaque object" {
                object: u32 as Object,
            };
            Attenuated "attenuated" "it passes a surface that lets this part of the light through, per channel" {
                object: u32 as Object,
                factor: [f64; 3] as Triple,
            };
            Undefined "undefined" "the quantity has no value in this arithmetic, and the computation goes on without it" {
                quantity: Name as Quantity,
            };
            TotalInternalReflection "total_internal_reflection" "no ray can be transmitted here";
            DepthLimit "depth_limit" "a bounce isn't traced because it would lie too deep in the ray tree" {
                what: Term as Term,
            };
            LeakGuard "leak_guard"
                "what was traced counts as black: the interpolated normal put it on a side where it isn't" {
                what: Term as Term,
            };
            Bent "bent" "the direction ran below the surface, and was bent up to the nearest one above" {
                what: Term as Term,
            };
            Rejected "rejected" "a direction of a blurred bounce lies on the wrong side; the mean is over the others" {
                what: Term as Term,
            };
            Skipped "skipped" "work isn't done because it can't change the colour" {
                what: Term as Term,
                why: SkipReason as SkipReason,
            };
            Subdivided "subdivided"
                "a cell of the pixel (left, top, side; in pixels) is cut in four; object is the one that no corner hit" {
                cell: [f64; 3] as Triple,
                why: Split as Split,
                object: Option<u32> as Optional<Object>,
            };
            Accepted "accepted" "what is known of a cell, or without one of the pixel, is enough" {
                cell: Option<[f64; 3]> as Optional<Triple>,
                why: Acceptance as Acceptance,
            };
            Asked "asked" "this many points of an area light with `min` and `max` are asked" {
                light: u32 as Light,
                why: Asking as Asking,
                points: u32 as Whole<1>,
                object: Option<u32> as Optional<Object>,
            };
            MoreSamples "more_samples" "the samples so far aren't enough: how many there are, and will be" {
                from: u32 as Whole<0>,
                to: u32 as Whole<0>,
            };
        }
    };
}

pub(in crate::log) use decisions;

macro_rules! define {
    ($($variant:ident $word:literal $meaning:literal $({ $($field:ident: $type:ty as $kind:ty,)* })?;)*) => {
        /// A decision of the computation.
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum Decision {
            $(
                #[doc = concat!("`", $word, "`: ", $meaning, ".")]
                #[allow(missing_docs)]
                $variant $({ $($field: $type,)* })?,
            )*
        }

        impl Decision {
            /// The word of every decision in a log.
            pub const WORDS: &[&str] = &[$($word,)*];

            /// The word in a log.
            pub fn word(&self) -> &'static str {
                match self { $(Decision::$variant { .. } => $word,)* }
            }

            /// Which decision it is, whatever its fields: the number of its row in the table.
            pub fn number(&self) -> u64 {
                enum Row { $($variant,)* }
                match self { $(Decision::$variant { .. } => Row::$variant as u64,)* }
            }

            /// Hands on the objects and lights that it names.
            pub fn each_id(&mut self, take: &mut impl FnMut(Id)) {
                match self {
                    $(Decision::$variant $({ $($field,)* })? => { $($(<$kind as FieldKind>::each_id($field, take);)*)? })*
                }
            }
        }
    };
}

decisions!(define);
