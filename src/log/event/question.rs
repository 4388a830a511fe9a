//! What a decision answers: two logs that answer the same question may answer it differently.

use super::{Decision, Term};
use crate::log::name::Name;

/// What a decision answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Question {
    IsHit,
    OnWhichSide,
    WhatIsNearest,
    IsCoincident(u32),
    IsImmersed(u32),
    WhatBlocks,
    WhatPasses(u32),
    HasValue(Name),
    IsTraced(Term),
    Leaks(Term),
    IsBent(Term),
    Rejected(Term),
    /// How many points of this light.
    IsAsked(u32),
    /// The cell by its bits; `None` for the pixel.
    IsEnough(Option<[u64; 3]>),
}

impl Question {
    /// The question that a decision answers.
    pub fn of(decision: Decision) -> Question {
        match decision {
            Decision::Hit | Decision::Miss { .. } => Question::IsHit,
            Decision::Outside | Decision::Inside => Question::OnWhichSide,
            Decision::Nearest { .. } | Decision::Background => Question::WhatIsNearest,
            Decision::Coincident { object, .. } => Question::IsCoincident(object),
            Decision::Immersed { object } => Question::IsImmersed(object),
            Decision::Occluded { .. } | Decision::Free => Question::WhatBlocks,
            Decision::Attenuated { object, .. } => Question::WhatPasses(object),
            Decision::Undefined { quantity } => Question::HasValue(quantity),
            Decision::TotalInternalReflection => Question::IsTraced(Term::Transmitted),
            Decision::DepthLimit { what } | Decision::Skipped { what, .. } => Question::IsTraced(what),
            Decision::LeakGuard { what } => Question::Leaks(what),
            Decision::Bent { what } => Question::IsBent(what),
            Decision::Rejected { what } => Question::Rejected(what),
            Decision::Subdivided { cell, .. } => Question::IsEnough(Some(cell.map(f64::to_bits))),
            Decision::Accepted { cell, .. } => Question::IsEnough(cell.map(|cell| cell.map(f64::to_bits))),
            Decision::Asked { light, .. } => Question::IsAsked(light),
            Decision::MoreSamples { .. } => Question::IsEnough(None),
        }
    }
}
