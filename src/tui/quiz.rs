//! The quiz: results and decisions from the current step on are hidden, and the user's answers are judged.

use super::model::Model;
use super::model::breakpoint::kind;
use super::model::hidden::is_asked;
use super::model::prompt::{Prompt, Purpose};
use super::model::understanding::{Known, Quiz};
use super::{plane, search};
use crate::log::{Decision, Value, What};
use crate::report::answer::{self, Unreadable, Verdict};

/// The misses after which a result is shown.
const MOST_MISSES: u32 = 2;

/// Begins the quiz, or ends it.
pub(super) fn toggle(model: &mut Model) {
    match model.understanding.quiz.take() {
        Some(quiz) => model.say(&(model.texts().quiz.ends)(quiz.score())),
        None => {
            model.understanding.quiz = Some(Quiz::default());
            renew(model);
            plane::hide(model);
            model.say(model.texts().quiz.begins);
        }
    }
    // What the quiz hides isn't found, and is again after it.
    search::renew(model);
}

/// Goes on in another log.
pub(super) fn renew(model: &mut Model) {
    if let Some(quiz) = &mut model.understanding.quiz {
        let events = (0..).zip(model.log.events.iter());
        quiz.asked = events.filter(|(_, event)| is_asked(&event.what)).map(|(number, _)| number).collect();
    }
    visit(model);
}

/// Counts what was passed on the way to the current step.
pub(super) fn visit(model: &mut Model) {
    let pixel = model.pixel();
    if let Some(quiz) = &mut model.understanding.quiz {
        quiz.visit(pixel, model.event);
    }
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
    if model.understanding.quiz.is_none() {
        return Ok(());
    }
    let judged = match (what, what.value()) {
        (_, Some(value)) => judged_value(model, line, &value)?,
        (What::Mark(decision), _) => judged_decision(model, line, decision)?,
        _ => return Ok(()),
    };
    let (pixel, texts) = (model.pixel(), &model.texts().quiz);
    let Some(quiz) = &mut model.understanding.quiz else { return Ok(()) };
    if quiz.missed != (pixel, event) {
        (quiz.missed, quiz.misses) = ((pixel, event), 0);
    }
    quiz.visit(pixel, event);
    let Some(here) = quiz.pixels.get_mut(&pixel) else { return Ok(()) };
    let said = match judged {
        Judged::Right(said) => {
            let is_new = quiz.misses == 0 && event >= here.unseen;
            here.known.insert(event, if is_new { Known::AtOnce } else { Known::Later });
            said
        }
        Judged::Wrong { off, .. } if quiz.misses + 1 < MOST_MISSES => {
            quiz.misses += 1;
            (texts.try_again)(&off)
        }
        Judged::Wrong { off, truth } => {
            here.known.insert(event, Known::Told);
            (texts.it_is)(&off, &truth)
        }
    };
    model.say(&said);
    Ok(())
}

/// What an answer is worth.
enum Judged {
    /// It is right; what is said of it.
    Right(String),
    /// How wrong it is, and what would have been right.
    Wrong { off: String, truth: String },
}

/// A value is answered by itself, or by what its formula gives with the operands as they are on the screen.
fn judged_value(model: &Model, line: &str, truth: &Value) -> Result<Judged, String> {
    let texts = &model.texts().quiz;
    let given = answer::parse(line, matches!(truth, Value::Triple(_))).map_err(|why| match why {
        Unreadable::NoNumber => texts.no_number.to_owned(),
        Unreadable::NoTriple => texts.no_triple.to_owned(),
    })?;
    let Verdict::Off(by) = answer::judge(&given, truth, model.numbers) else {
        return Ok(Judged::Right(texts.right.to_owned()));
    };
    let from_shown = answer::from_shown(&model.log, &model.tree, model.event, model.numbers);
    let follows = |shown: &Value| answer::judge(&given, shown, model.numbers) == Verdict::Right;
    let truth = model.value(truth);
    if from_shown.as_ref().is_some_and(follows) {
        return Ok(Judged::Right((texts.right_as_shown)(&truth)));
    }
    let off = (texts.off)(&model.value(&Value::Number(by)));
    let shown = from_shown.map(|shown| model.value(&shown)).filter(|shown| *shown != truth);
    Ok(Judged::Wrong { off, truth: shown.map_or(truth.clone(), |shown| (texts.and_as_shown)(&truth, &shown)) })
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
    Ok(if is_right {
        Judged::Right(model.texts().quiz.right.to_owned())
    } else {
        Judged::Wrong { off: model.texts().quiz.not_it.to_owned(), truth }
    })
}
