//! What is kept to explain with: the list that was opened, and the quiz.

use super::list::{Kind, Listing};
use crate::report::causes::Study;
use crate::report::paper::Paper;
use std::collections::HashMap;
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
}

/// A quiz that is on.
#[derive(Clone, Debug, Default)]
pub struct Quiz {
    /// What was answered and passed, by pixel.
    pub pixels: HashMap<Option<[u32; 2]>, Answers>,
    /// The events of the log whose results or decisions are asked for, in order.
    pub asked: Vec<u32>,
    /// How often the current step was answered wrongly.
    pub misses: u32,
    /// The step that was, and its pixel.
    pub missed: (Option<[u32; 2]>, usize),
}

/// What was answered of a pixel.
#[derive(Clone, Debug)]
pub struct Answers {
    /// How the events became known that were asked for.
    pub known: HashMap<usize, Known>,
    /// The first event that one has been at in the quiz.
    pub first: usize,
    /// The first event whose result nobody has seen.
    pub unseen: usize,
    /// How many results were passed without an answer, and are known.
    pub passed: u32,
}

/// How a result became known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// The first answer was right.
    AtOnce,
    /// A later answer was, or the result had been seen before.
    Later,
    /// It was told after wrong answers.
    Told,
}

impl Quiz {
    /// How many results became known: by a right answer at once, by a right one later, told after wrong answers, passed unanswered.
    pub fn score(&self) -> [u32; 4] {
        let mut score = [0; 4];
        for answers in self.pixels.values() {
            for known in answers.known.values() {
                score[*known as usize] += 1;
            }
            score[3] += answers.passed;
        }
        score
    }

    /// Takes note that the step at `event` is the current one.
    pub fn visit(&mut self, pixel: Option<[u32; 2]>, event: usize) {
        let new = || Answers { known: HashMap::new(), first: event, unseen: event, passed: 0 };
        let here = self.pixels.entry(pixel).or_insert_with(new);
        here.first = here.first.min(event);
        here.unseen = here.unseen.max(event);
        let before = |event: usize| self.asked.partition_point(|asked| (*asked as usize) < event);
        let answered = here.known.keys().filter(|known| (here.first..event).contains(known)).count();
        here.passed = (before(event) - before(here.first) - answered) as u32;
    }
}
