//! What happens in a computation, as typed data. Objects and lights are numbers here; the header of the log names them.

use super::name::Name;
use super::value::Value;
use std::ops::Range;

/// An event of the log, in the order of the computation.
#[derive(Clone, Debug)]
pub struct Event {
    /// The number of the event in its pixel, from 1 (0 opens a pixel of a region log).
    pub at: u32,
    /// The node that the event belongs to; for [`What::Enter`] the new node itself.
    pub node: u32,
    /// What happened.
    pub what: What,
    /// Inputs that the problem states and no arithmetic rounds, used from this event on: [`Events::given`](super::Events::given) has them.
    pub given: Given,
    /// How far several perturbed runs agree on it, if there were any.
    pub digits: Option<Box<Digits>>,
}

impl Event {
    /// The one that opens a pixel of a region log.
    pub fn opening(pixel: [u32; 2]) -> Event {
        let what = What::Enter { parent: 0, step: Step::Pixel(pixel) };
        Event { at: 0, node: 0, what, given: Given::default(), digits: None }
    }
}

/// Where the inputs of an event stand among those of its log.
#[derive(Clone, Copy, Debug, Default)]
pub struct Given {
    start: u32,
    end: u32,
}

impl Given {
    /// Events have numbers of 32 bits, too.
    pub(super) fn of(start: usize, end: usize) -> Given {
        Given { start: start as u32, end: end as u32 }
    }

    pub(super) fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// How far several runs of a computation, each perturbed in its own way, agree on what an event says.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Digits {
    /// So many significant decimal digits of each component are the same.
    Significant(Value),
    /// None: the decision isn't the same in all runs, or one that stands before this value.
    DecisionDiffers,
}

/// What an event says.
#[derive(Clone, PartialEq, Debug)]
pub enum What {
    /// A node begins, inside the node `parent`.
    Enter {
        /// The enclosing node (0 is the pixel).
        parent: u32,
        /// What the node is.
        step: Step,
    },
    /// A named quantity was computed; the computation went on with this value.
    Note {
        /// Which quantity, by which formula.
        name: Name,
        /// Its value.
        value: Value,
    },
    /// A decision was taken.
    Mark(Decision),
    /// The node ends.
    Leave,
    /// The colour of the pixel.
    Result {
        /// Red, green, blue; linear, not clipped.
        color: [f64; 3],
    },
}

/// What a node of the computation is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Step {
    /// A pixel (opens the pixels of a region log).
    Pixel([u32; 2]),
    /// One sample of a pixel that takes several.
    Sample {
        /// Its number, from 1.
        number: u32,
    },
    /// A ray with everything that it brings.
    Ray {
        /// What the ray is for.
        kind: RayKind,
        /// Its level in the ray tree; the camera's ray has 0. A shadow ray has its surface's.
        depth: u32,
        /// Its number, from 1, among several of its kind from one place; 0 if it is alone.
        split: u32,
    },
    /// How a moving object is met: the ray in the object's own frame, with the tests there, or the hit carried back from it.
    Motion {
        /// The object.
        object: u32,
    },
    /// An intersection test of the enclosing ray with an object.
    Test {
        /// The object.
        object: u32,
        /// The triangle, for a mesh.
        triangle: Option<u32>,
    },
    /// The local model at the hit of the enclosing ray.
    Shade {
        /// The object that was hit.
        object: u32,
    },
    /// What one light adds to the local model.
    Light {
        /// The light.
        light: u32,
        /// Of several points of an area light, its number from 1; 0 if there is one.
        split: u32,
    },
    /// A zone of the lobe about a blurred bounce: a direction in it, and what comes from there.
    Zone {
        /// Which bounce.
        what: Skippable,
        /// Its number, from 1.
        number: u32,
    },
    /// The weighted sum of the three contributions.
    Combine,
}

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
    /// The word that stands for the kind in a log.
    pub fn word(self) -> &'static str {
        match self {
            RayKind::Camera => "camera",
            RayKind::Shadow { .. } => "shadow",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
        }
    }

    /// The letter of the kind in a path such as `C R T S1`.
    pub fn letter(self) -> char {
        match self {
            RayKind::Camera => 'C',
            RayKind::Shadow { .. } => 'S',
            RayKind::Reflected => 'R',
            RayKind::Transmitted => 'T',
        }
    }
}

/// A decision of the computation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Decision {
    /// The tested object lies on the ray.
    Hit,
    /// It doesn't.
    Miss {
        /// Why not.
        why: Miss,
    },
    /// The ray's origin lies outside the tested solid.
    Outside,
    /// The ray's origin lies inside the tested solid.
    Inside,
    /// This object is the nearest on the ray.
    Nearest {
        /// The object.
        object: u32,
    },
    /// Another surface lies in the same place as the nearest one. It comes later in the scene, so it counts as lying just behind.
    Coincident {
        /// The object.
        object: u32,
        /// The triangle, for a mesh.
        triangle: Option<u32>,
    },
    /// The ray begins inside this medium; of several the innermost comes last.
    Immersed {
        /// The object.
        object: u32,
    },
    /// The ray leaves the scene and gets the background colour.
    Background,
    /// Nothing stands in the way of the shadow ray.
    Free,
    /// The shadow ray ends at an opaque object.
    Occluded {
        /// The object.
        object: u32,
    },
    /// The shadow ray passes a surface that lets a part of the light through.
    Attenuated {
        /// The object.
        object: u32,
        /// The part let through, per channel.
        factor: [f64; 3],
    },
    /// A quantity has no value in this arithmetic: what it is divided by came to zero. The computation goes on without.
    Undefined {
        /// The quantity.
        quantity: Name,
    },
    /// No ray can be transmitted here.
    TotalInternalReflection,
    /// A bounce isn't traced because it would lie too deep in the ray tree.
    DepthLimit {
        /// Which bounce.
        what: Skippable,
    },
    /// What was traced counts as black: the interpolated normal put it on a side of the surface where it isn't.
    LeakGuard {
        /// Which ray.
        what: Skippable,
    },
    /// The direction by the interpolated normal ran below the surface, and was bent up to the nearest one above it.
    Bent {
        /// Which bounce.
        what: Skippable,
    },
    /// A direction of a blurred bounce lies on the wrong side of the surface. No ray goes there, and the mean is over the others.
    Rejected {
        /// Which bounce.
        what: Skippable,
    },
    /// Work isn't done because it can't change the colour.
    Skipped {
        /// What isn't done.
        what: Skippable,
        /// By which rule.
        why: SkipReason,
    },
    /// A cell of the pixel is cut in four.
    Subdivided {
        /// Its left and upper side, in pixels from the pixel's own, and how long they are.
        cell: [f64; 3],
        /// Why.
        why: Split,
        /// The object that no corner met, if it was one.
        object: Option<u32>,
    },
    /// What is known of a cell, or of the whole pixel, is enough.
    Accepted {
        /// The cell, as in [`Decision::Subdivided`]; `None` for the pixel.
        cell: Option<[f64; 3]>,
        /// Why.
        why: Acceptance,
    },
    /// How many points of an area light are asked that takes as few as tell enough.
    Asked {
        /// The light's number.
        light: u32,
        /// Why so many.
        why: Asking,
        /// How many.
        points: u32,
        /// The object that hides all of the light, if one does.
        object: Option<u32>,
    },
    /// The samples so far don't tell the pixel's colour well enough.
    MoreSamples {
        /// How many there are.
        from: u32,
        /// How many there will be.
        to: u32,
    },
}

/// Declares an enum whose variants stand as words in a log.
macro_rules! words {
    ($(#[$doc:meta])* $name:ident { $($(#[$variant_doc:meta])* $variant:ident = $word:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        pub enum $name { $($(#[$variant_doc])* $variant,)* }

        impl $name {
            /// Every value.
            pub const ALL: &[$name] = &[$($name::$variant,)*];

            /// The word in a log.
            pub fn word(self) -> &'static str {
                match self { $($name::$variant => $word,)* }
            }

            /// The value that a word stands for.
            pub fn find(word: &str) -> Option<$name> {
                Self::ALL.iter().copied().find(|value| value.word() == word)
            }
        }
    };
}

words! {
    /// Why a ray misses an object.
    Miss {
        /// The ray runs parallel to the surface.
        Parallel = "parallel",
        /// The object lies behind the ray's origin.
        Behind = "behind",
        /// The line of the ray passes beside the object.
        Beside = "beside",
        /// The surface lies beyond the end of the ray (the light).
        Beyond = "beyond",
        /// The surface shows its back, which isn't there.
        FacesAway = "faces_away",
        /// The ray begins on the surface, as far as rounding can tell.
        BeginsThere = "begins_there",
    }
}

words! {
    /// What may be left out, or count as black.
    Skippable {
        /// The reflected ray.
        Reflected = "reflected",
        /// The transmitted ray.
        Transmitted = "transmitted",
        /// The shadow ray.
        Shadow = "shadow",
        /// The whole local model.
        Local = "local",
        /// The specular term of a light.
        Specular = "specular",
    }
}

words! {
    /// The rule by which work is left out; `docs/skipping.md` has the proof of each. Each but [`SkipReason::Behind`], which is the
    /// algorithm's own, can be switched off (`--skip`).
    SkipReason {
        /// A bounce whose weight is zero in all channels.
        ZeroWeight = "zero_weight",
        /// A shadow ray to a light that no coefficient of the surface could use.
        NoLocalTerm = "no_local_term",
        /// The rest of a shadow ray that is fully blocked.
        Blocked = "blocked",
        /// A bounce whose product of weights lies below `tracing.cutoff`.
        Cutoff = "cutoff",
        /// A bounce whose weight isn't zero, while in each channel some weight on its path is.
        ZeroPath = "zero_path",
        /// The local model where its weight is zero in all channels.
        ZeroLocal = "zero_local",
        /// A term of the local model whose coefficient is zero in all channels.
        ZeroTerm = "zero_term",
        /// The shadow ray to a light behind a surface that doesn't let its light through.
        Behind = "behind",
        /// The shadow ray to a light whose colour and the coefficients that could use it leave nothing of any channel.
        ZeroLight = "zero_light",
        /// The local model where in each channel its weight, which isn't zero, or some weight on the path to it is.
        ZeroPathLocal = "zero_path_local",
        /// The shadow ray to a light of which the weights on the path, that of the local model, the light's colour and the coefficients
        /// together leave nothing of any channel.
        ZeroPathLight = "zero_path_light",
    }
}

words! {
    /// Why a cell of a pixel is cut in four.
    Split {
        /// The colours at its corners differ by more than the threshold.
        Color = "color",
        /// Its corners see different objects.
        Objects = "objects",
        /// A small object lies in it, and no corner sees that.
        SmallObject = "small_object",
    }
}

words! {
    /// Why so many points of an area light are asked.
    Asking {
        /// Nothing can stand between, and the light is smooth: the points of a rule, without shadow rays.
        Rule = "rule",
        /// Nothing can stand between: all random points, without shadow rays.
        InView = "in_view",
        /// An object hides all of the light.
        Hidden = "hidden",
        /// It may be seen in part: all.
        All = "all",
    }
}

words! {
    /// Why the samples so far are enough.
    Acceptance {
        /// They agree.
        Alike = "alike",
        /// The cell may not be cut further.
        Depth = "depth",
        /// The interval of the mean is narrow enough.
        Interval = "interval",
        /// There may not be more.
        Max = "max",
        /// They are as many as the pilots of the pixels around ask for.
        Guided = "guided",
    }
}
