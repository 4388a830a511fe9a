//! The quiz: results after the current step are hidden, and what somebody reckons instead is judged.

use super::model::Model;
use super::prompt::{Prompt, Purpose};
use crate::log::{Value, What};
use crate::report::answer::{self, Verdict};
use crate::report::number;

/// A quiz that is on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Quiz {
    /// How many answers were right.
    pub right: u32,
    /// How many results were asked for and are known now.
    pub asked: u32,
    /// How often the current step was answered wrongly.
    misses: u32,
    /// The step that was.
    missed: usize,
}

/// The misses after which a result is shown.
const MOST_MISSES: u32 = 2;

impl Model {
    /// Whether the quiz hides the result of an event: it stands at the current step or after it and wasn't answered yet.
    pub fn hides(&self, event: usize) -> bool {
        let is_result = || {
            let what = self.log.events.get(event).map(|event| &event.what);
            matches!(what, Some(What::Note { .. } | What::Result { .. }))
        };
        let understanding = &self.understanding;
        understanding.quiz.is_some() && event >= self.event && !understanding.answered.contains(&event) && is_result()
    }

    /// Whether the quiz hides what goes into an event: it stands after the current step, and its operands would tell results.
    pub fn hides_operands(&self, event: usize) -> bool {
        self.understanding.quiz.is_some() && event > self.event
    }

    /// What the status line says of the quiz.
    pub fn score(&self) -> Option<String> {
        self.understanding.quiz.map(|quiz| format!("quiz {} of {}", quiz.right, quiz.asked))
    }
}

/// Begins the quiz, or ends it.
pub(super) fn toggle(model: &mut Model) {
    match model.understanding.quiz.take() {
        Some(quiz) => model.say(&format!("the quiz is over: {} of {} right", quiz.right, quiz.asked)),
        None => {
            model.understanding.quiz = Some(Quiz::default());
            model.understanding.answered.clear();
            model.say("quiz: n goes to the next value, = answers it, Q ends");
        }
    }
}

/// Asks for the result of the current step.
pub(super) fn ask(model: &mut Model) {
    if model.understanding.quiz.is_none() {
        return model.say("no quiz is on; Q begins one");
    }
    if !model.hides(model.event) {
        return model.say("this step hides no result; n goes to the next");
    }
    model.prompt = Some(Prompt::new(Purpose::Answer));
}

/// Judges an answer.
pub(super) fn answer(model: &mut Model, line: &str) -> Result<(), String> {
    let event = model.event;
    let truth = match model.log.events.get(event).map(|event| &event.what) {
        Some(What::Note { value, .. }) => *value,
        Some(What::Result { color }) => Value::Triple(*color),
        _ => return Ok(()),
    };
    let Some(mut quiz) = model.understanding.quiz else { return Ok(()) };
    let given = answer::parse(line, matches!(truth, Value::Triple(_)))?;
    if quiz.missed != event {
        (quiz.missed, quiz.misses) = (event, 0);
    }
    let is_known = match answer::judge(&given, &truth, model.numbers) {
        Verdict::Right => {
            quiz.right += 1;
            model.say("right");
            true
        }
        Verdict::Off(by) => {
            quiz.misses += 1;
            let off = number::number(by, model.numbers);
            let is_last = quiz.misses >= MOST_MISSES;
            let truth = if is_last {
                format!("; it is {}", number::value(&truth, model.numbers))
            } else {
                "; try again".to_owned()
            };
            model.say(&format!("off by {off}{truth}"));
            is_last
        }
    };
    if is_known {
        quiz.asked += 1;
        quiz.misses = 0;
        model.understanding.answered.insert(event);
    }
    model.understanding.quiz = Some(quiz);
    Ok(())
}
