//! What decisions and nodes say in words: enums whose variants are written as words in a log.

use super::field::{FieldKind, Of};
use crate::log::words::words;

macro_rules! fields {
    ($($name:ident)*) => {$(
        impl FieldKind for $name {
            type Value = $name;
            const OF: Of = Of::Words(|| $name::ALL.iter().map(|value| value.word()).collect());
        }
    )*};
}

fields!(Miss Term SkipReason Split Asking Acceptance);

words! {
    /// Why a ray misses an object.
    pub Miss {
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
    pub Term {
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
    pub SkipReason {
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
    pub Split {
        /// The colours at its corners differ by more than the threshold.
        Color = "color",
        /// Its corners see different objects.
        Objects = "objects",
        /// A small object lies in it, and no corner sees that.
        SmallObject = "small_object",
    }
}

words! {
    /// Why this many points of an area light are asked.
    pub Asking {
        /// Nothing can lie between, and the light is smooth: the points of a rule, without shadow rays.
        Rule = "rule",
        /// Nothing can lie between: all random points, without shadow rays.
        InView = "in_view",
        /// An object hides all of the light.
        Hidden = "hidden",
        /// It may be seen in part: all.
        All = "all",
    }
}

words! {
    /// Why the samples so far are enough.
    pub Acceptance {
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
