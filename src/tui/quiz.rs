//! The quiz: results and decisions from the current step on are hidden, and the user's answers are judged.

use super::model::Model;
use super::model::breakpoint::kind;
use super::model::prompt::{Prompt, Purpose};
use super::model::understanding::Quiz;
use super::search;
use crate::log::{Decision, Value, What};
use crate::report::answer::{self, Unreadable, Verdict};

/// The misses after which a result is shown.
const MOST_MISSES: u32 = 2;

/// Begins the quiz, or ends it.
pub(super) fn toggle(model: &mut Model) {
    match model.understanding.quiz.take() {
        Some(quiz) => model.say(&(model.texts().quiz.ends)(quiz.right, quiz.asked)),
        None => {
            model.understanding.quiz = Some(Quiz::default());
            model.understanding.answered.clear();
            model.say(model.texts().quiz.begins);
        }
    }
    // What the quiz hides isn't found, and is again after it.
    search::renew(model);
}

/// Asks for the result of the current step.
pub(super) fn ask(model: &mut Model) {
    if model.understanding.quiz.is_none() {
        return model.say(model.texts().quiz.none);
    }
    if !model.hides(model.event) {
        return model.say(model.texts().quiz.nothing_hidden);
    }
    if model.hides_name(model.event) {
        model.say(model.texts().quiz.what_is_decided);
    }
    model.prompt = Some(Prompt::new(Purpose::Answer));
}

/// Judges an answer.
pub(super) fn answer(model: &mut Model, line: &str) -> Result<(), String> {
    let event = model.event;
    let Some(what) = model.log.events.get(event).map(|event| &event.what) else { return Ok(()) };
    let Some(mut quiz) = model.understanding.quiz else { return Ok(()) };
    let judged = match (what, what.value()) {
        (_, Some(value)) => judged_value(model, line, &value)?,
        (What::Mark(decision), _) => judged_decision(model, line, decision)?,
        _ => return Ok(()),
    };
    let pixel = model.pixel();
    if quiz.missed != (pixel, event) {
        (quiz.missed, quiz.misses) = ((pixel, event), 0);
    }
    let is_known = match judged {
        Judged::Right => {
            quiz.right += 1;
            model.say(model.texts().quiz.right);
            true
        }
        Judged::Wrong { off, truth } => {
            quiz.misses += 1;
            let is_last = quiz.misses >= MOST_MISSES;
            let texts = &model.texts().quiz;
            model.say(&if is_last { (texts.it_is)(&off, &truth) } else { (texts.try_again)(&off) });
            is_last
        }
    };
    if is_known {
        quiz.asked += 1;
        quiz.misses = 0;
        model.understanding.answered.entry(pixel).or_default().insert(event);
    }
    model.understanding.quiz = Some(quiz);
    Ok(())
}

/// What an answer is worth.
enum Judged {
    Right,
    /// How wrong it is, and what would have been right.
    Wrong {
        off: String,
        truth: String,
    },
}

fn judged_value(model: &Model, line: &str, truth: &Value) -> Result<Judged, String> {
    let texts = &model.texts().quiz;
    let given = answer::parse(line, matches!(truth, Value::Triple(_))).map_err(|why| match why {
        Unreadable::NoNumber => texts.no_number.to_owned(),
        Unreadable::NoTriple => texts.no_triple.to_owned(),
    })?;
    Ok(match answer::judge(&given, truth, model.numbers) {
        Verdict::Right => Judged::Right,
        Verdict::Off(by) => {
            Judged::Wrong { off: (texts.off)(&model.value(&Value::Number(by))), truth: model.value(truth) }
        }
    })
}

/// A decision is answered by a word for it, as breakpoints have them, or by the name of the object that it chooses.
fn judged_decision(model: &Model, line: &str, truth: &Decision) -> Result<Judged, String> {
    let header = &model.log.header;
    let chosen = match truth {
        Decision::Nearest { object }
        | Decision::Coincident { object, .. }
        | Decision::Immersed { object }
        | Decision::Occluded { object }
        | Decision::Attenuated { object, .. } => Some(header.object(*object)),
        _ => None,
    };
    let line = line.trim();
    let kind = kind::find(line);
    let is_object = header.objects.iter().any(|name| name == line);
    if kind.is_none() && !is_object {
        return Err(model.texts().quiz.no_decision.to_owned());
    }
    let is_right = chosen == Some(line) || kind.is_some_and(|kind| kind::of(&What::Mark(*truth)).contains(&kind));
    let truth = model.decision(truth);
    Ok(if is_right { Judged::Right } else { Judged::Wrong { off: model.texts().quiz.not_it.to_owned(), truth } })
}
