//! The panes and the bottom line.

use super::super::{OfName, OfNames};

/// The texts of the bottom line.
pub struct Status {
    /// The step, of how many.
    pub step: fn(usize, usize) -> String,
    /// The section of the source text that has a quantity.
    pub section: OfName,
    /// The keys to begin with, from the longest way to say it to the shortest; the longest with those that move.
    pub hints: [&'static str; 3],
    /// All of them, around those that move.
    pub all_hints: OfName,
    /// The keys that move in the tree, and in other panes.
    pub moves: [&'static str; 2],
    /// It plays, at so many steps a second.
    pub playing: fn(u32) -> String,
    /// The tree grows.
    pub growing: &'static str,
    /// The tree is filtered.
    pub filtered: &'static str,
    /// The mouse is used.
    pub mouse: &'static str,
    /// A search isn't complete.
    pub counting: &'static str,
    /// Which match, of how many.
    pub matches: OfNames,
    /// How many were right in a quiz, of how many.
    pub quiz: fn(u32, u32) -> String,
    /// Before a line that filters.
    pub filter: &'static str,
    /// Before a breakpoint.
    pub break_at: &'static str,
    /// Before what keys are looked for by.
    pub keys_with: &'static str,
    /// Before an answer.
    pub answer: &'static str,
    /// Before a warning.
    pub warning: &'static str,
    /// The terminal is too small.
    pub too_small: [&'static str; 3],
}

/// The texts of panes.
pub struct Panes {
    /// The algorithm, by its name.
    pub algorithm: OfName,
    /// The calls below it.
    pub calls: &'static str,
    /// A shadow ray among them.
    pub shadow_ray: OfName,
    /// The end of a node.
    pub end: &'static str,
    /// The end of a node, by what it is.
    pub end_of: OfName,
    /// A decision that is hidden.
    pub hidden_decision: &'static str,
    /// A result that is hidden.
    pub hidden_result: &'static str,
    /// What is still to come.
    pub not_computed: &'static str,
    /// A colour as the result.
    pub result: OfName,
    /// A ray by what it is for, without its path.
    pub ray: OfName,
    /// How many rays a closed node hides.
    pub hidden_rays: fn(u32) -> String,
    /// What nodes came to.
    pub outcomes: Outcomes,
    /// So many samples are drawn.
    pub samples: fn(usize) -> String,
    /// The picture.
    pub picture: Picture,
    /// The schematic.
    pub schematic: Schematic,
}

/// What a node came to, in a word or two.
pub struct Outcomes {
    /// A shadow ray that reaches its light.
    pub lit: &'static str,
    /// A hit.
    pub hit: &'static str,
    /// A miss.
    pub miss: &'static str,
    /// Nothing is hit.
    pub background: &'static str,
    /// An object stands before the light.
    pub blocked_by: OfName,
    /// A direction on the wrong side.
    pub rejected: &'static str,
    /// An object weakens the light.
    pub weakened_by: OfName,
    /// The depth limit.
    pub depth_limit: &'static str,
    /// Total internal reflection.
    pub total_reflection: &'static str,
}

/// The texts of the picture.
pub struct Picture {
    /// Its layers: the colours, the depth, the rays, the samples, the error of single precision.
    pub layers: [&'static str; 5],
    /// The exposure in stops.
    pub exposure: OfName,
    /// The depth of a pixel.
    pub depth: OfName,
    /// The rays of a pixel.
    pub rays: fn(u32) -> String,
    /// Its levels in a file.
    pub levels: fn([u8; 3]) -> String,
    /// The cursor is at the edge.
    pub ends: &'static str,
}

/// The texts of the schematic.
pub struct Schematic {
    /// From where it is seen: from above, from the front, from the eye.
    pub views: [&'static str; 3],
    /// The key that turns it.
    pub turns: &'static str,
    /// There is no ray to be drawn.
    pub no_rays: &'static str,
    /// The rays are too long to be drawn.
    pub too_far: &'static str,
}
