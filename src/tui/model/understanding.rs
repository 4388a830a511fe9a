//! What is kept to explain with: the list that was opened, and the quiz.

use super::list::{Kind, Listing};
use crate::report::causes::Study;
use crate::report::paper::Paper;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// What the viewer keeps for understanding.
#[derive(Clone, Debug, Default)]
pub struct Understanding {
    /// The list that was opened last, made once.
    pub listing: Option<(Kind, Listing)>,
    /// Which rounding caused the error of the log's result, once somebody asked for it.
    pub study: Option<Arc<Study>>,
    /// The worked example that the log is of, likewise.
    pub book: Option<Arc<Paper>>,
    /// The quiz, while it is on.
    pub quiz: Option<Quiz>,
    /// The steps whose results somebody answered, of each pixel: the score counts none of them twice.
    pub answered: HashMap<Option<[u32; 2]>, HashSet<usize>>,
}

/// A quiz that is on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Quiz {
    /// How many answers were right.
    pub right: u32,
    /// How many results were asked for and are known now.
    pub asked: u32,
    /// How often the current step was answered wrongly.
    pub misses: u32,
    /// The step that was, and its pixel.
    pub missed: (Option<[u32; 2]>, usize),
}
