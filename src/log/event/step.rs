//! The nodes of a computation: the one table from which their type, their lines in a file, and the page and the schema of the format follow.

use super::Term;
use super::field::{FieldKind, Id, Light, Numbered, Object, Optional, Whole};

/// Passes the table to a macro, after the tokens meant for that macro alone. Its rows are those of [`decisions`](super::decision::decisions). Two nodes have no row, since their lines aren't
/// made of fields one by one: `{"pixel":[x,y]}`, and a ray, whose kind takes two fields of its line ([`RayKind`]).
macro_rules! steps {
    ($with:ident $($more:tt)*) => {
        $with! {
            $($more)*
            Sample "sample" "one of several samples of a pixel" {
                /// Its number, from 1.
                number: u32 as Whole<1>,
            };
            Motion "motion" "a moving object is tested: the ray in the object's frame, or the hit carried back from it" {
                /// The object.
                object: u32 as Object,
            };
            Test "test" "the ray is tested with an object; triangle is that of a mesh" {
                /// The object.
                object: u32 as Object,
                /// The triangle, for a mesh.
                triangle: Option<u32> as Optional<Whole<0>>,
            };
            Shade "shade" "the local model at the hit of the ray" {
                /// The object that was hit.
                object: u32 as Object,
            };
            Light "light" "what a light adds there; split is the number of a point of an area light" {
                /// The light.
                light: u32 as Light,
                /// Of several points of an area light, its number from 1; 0 if there is one.
                split: u32 as Numbered,
            };
            Zone "zone" "a zone of the lobe about a blurred bounce" {
                /// Which bounce.
                what: Term as Term,
                /// Its number, from 1.
                number: u32 as Whole<1>,
            };
            Combine "combine" "the weighted sum of the three contributions";
        }
    };
}

pub(in crate::log) use steps;

macro_rules! define {
    ($($variant:ident $word:literal $meaning:literal $({ $($(#[$doc:meta])* $field:ident: $type:ty as $kind:ty,)* })?;)*) => {
        /// What a node of the computation is.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        pub enum Step {
            /// A pixel (opens the pixels of a region log).
            Pixel([u32; 2]),
            /// A ray, with everything traced for it.
            Ray {
                /// What the ray is for.
                kind: RayKind,
                /// Its level in the ray tree; the camera's ray has 0. A shadow ray has its surface's.
                depth: u32,
                /// Its number, from 1, among several of its kind from one place; 0 if it is alone.
                split: u32,
            },
            $(
                #[doc = concat!("`", $word, "`: ", $meaning, ".")]
                $variant $({ $($(#[$doc])* $field: $type,)* })?,
            )*
        }

        impl Step {
            /// The word of every node in a log.
            pub const WORDS: &[&str] = &["pixel", "ray", $($word,)*];

            /// The word in a log.
            pub fn word(&self) -> &'static str {
                match self {
                    Step::Pixel(_) => "pixel",
                    Step::Ray { .. } => "ray",
                    $(Step::$variant { .. } => $word,)*
                }
            }

            /// Hands on the objects and lights that it names.
            pub fn each_id(&mut self, take: &mut impl FnMut(Id)) {
                match self {
                    Step::Ray { kind: RayKind::Shadow { light }, .. } => take(Id::Light(light)),
                    Step::Ray { .. } | Step::Pixel(_) => {}
                    $(Step::$variant $({ $($field,)* })? => { $($(<$kind as FieldKind>::each_id($field, take);)*)? })*
                }
            }
        }
    };
}

steps!(define);

/// What a ray is for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RayKind {
    /// From the eye through the picture.
    Camera,
    /// From a surface toward the light with this number.
    Shadow {
        /// The light, from 0.
        light: u32,
    },
    /// Mirrored at a surface.
    Reflected,
    /// Refracted through a surface.
    Transmitted,
}

impl RayKind {
    /// The word of every kind in a log.
    pub const WORDS: &[&str] = &[
        RayKind::Camera.word(),
        RayKind::Shadow { light: 0 }.word(),
        RayKind::Reflected.word(),
        RayKind::Transmitted.word(),
    ];

    /// The word that stands for the kind in a log.
    pub const fn word(self) -> &'static str {
        match self {
            RayKind::Camera => "camera",
            RayKind::Shadow { .. } => "shadow",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
        }
    }

    /// The kind that a word and the light of a shadow ray stand for.
    pub fn find(word: &str, light: Option<u32>) -> Option<RayKind> {
        let kinds = [RayKind::Camera, RayKind::Reflected, RayKind::Transmitted];
        let shadow = light.map(|light| RayKind::Shadow { light });
        kinds.into_iter().chain(shadow).find(|kind| kind.word() == word)
    }

    /// The light of a shadow ray.
    pub fn light(self) -> Option<u32> {
        match self {
            RayKind::Shadow { light } => Some(light),
            _ => None,
        }
    }

    /// The letter of the kind in a path such as `C R T S1`.
    pub const fn letter(self) -> &'static str {
        match self {
            RayKind::Camera => "C",
            RayKind::Shadow { .. } => "S",
            RayKind::Reflected => "R",
            RayKind::Transmitted => "T",
        }
    }
}
