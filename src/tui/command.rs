//! The command line: what is typed behind `:`.

mod completions;

pub(super) use completions::{completions, file_in, is_of_parameter};

use super::effect::{Change, Effect, Exit};
use super::keys::Walk;
use super::model::Model;
use super::model::list::Kind;
use super::{bookmarks, breakpoints, drawn, edit, eval, jumps, plane, search, understanding, walk, watch};
use crate::files::suggest;
use crate::log::{Step, Subject};
use crate::report::Style;
use crate::report::language::Language;
use crate::report::language::viewer::Commands;
use crate::report::words::plain;

/// What a finished line asks for, or what is wrong with it.
pub(super) type Done = Result<Effect, String>;

/// A command.
struct Command {
    name: &'static str,
    argument: Argument,
    run: fn(&mut Model, &str) -> Done,
}

/// What follows a command.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Argument {
    Nothing,
    Bookmark,
    Note,
    Condition,
    Text,
    Pixel,
    Language,
    Parameter,
    File,
    Number,
    Name,
    MaybeName,
    Decimals,
    Plane,
    Schematic,
    Expression,
    /// The key of a quantity, or nothing.
    Quantity,
    Key,
}

impl Argument {
    /// Whether a command says by itself that it is missing.
    fn is_needed(self) -> bool {
        matches!(
            self,
            Argument::File | Argument::Number | Argument::Name | Argument::Note | Argument::Expression | Argument::Key
        )
    }

    /// How it is written where commands are listed.
    fn word(self, texts: &Commands) -> &'static str {
        match self {
            Argument::Nothing => "",
            Argument::Bookmark => texts.letter_and_note,
            Argument::Note => texts.text,
            Argument::Condition => texts.condition,
            Argument::Text => texts.text,
            Argument::Pixel => "X,Y",
            Argument::Language => "en|es",
            Argument::Parameter => texts.path_and_value,
            Argument::File => texts.file,
            Argument::Number => texts.number,
            Argument::Name | Argument::MaybeName => texts.name,
            Argument::Decimals => "N",
            Argument::Plane => texts.plane,
            Argument::Schematic => texts.what_or_side,
            Argument::Expression => texts.expression,
            Argument::Quantity => texts.quantity,
            Argument::Key => texts.key,
        }
    }
}

/// Every command; a beginning that only one of them has stands for it.
const COMMANDS: &[Command] = &[
    Command {
        name: "algorithm",
        argument: Argument::Name,
        run: |_, word| Ok(Effect::Change(Change::Algorithm(word.to_owned()))),
    },
    Command {
        name: "arithmetic",
        argument: Argument::Name,
        run: |_, word| Ok(Effect::Change(Change::Arithmetic(word.to_owned()))),
    },
    Command { name: "book", argument: Argument::Nothing, run: |model, _| Ok(understanding::open(model, Kind::Book)) },
    Command { name: "bookmark", argument: Argument::Bookmark, run: bookmark },
    Command { name: "bookmarks", argument: Argument::Nothing, run: |model, _| go(model, Walk::Marks) },
    Command { name: BREAK, argument: Argument::Condition, run: |model, text| plainly(breakpoints::add(model, text)) },
    Command { name: "breakpoints", argument: Argument::Nothing, run: |model, _| go(model, Walk::Breakpoints) },
    Command {
        name: "causes",
        argument: Argument::MaybeName,
        run: |model, arithmetic| Ok(understanding::study(model, arithmetic)),
    },
    Command { name: "compare", argument: Argument::Nothing, run: |_, _| Ok(Effect::Beside) },
    Command {
        name: "depth",
        argument: Argument::Number,
        run: |_, number| Ok(Effect::Change(Change::Depth(number.to_owned()))),
    },
    Command { name: "digits", argument: Argument::Decimals, run: digits },
    Command { name: "edit", argument: Argument::Nothing, run: |model, _| Ok(edit::object(model)) },
    Command { name: EVAL, argument: Argument::Expression, run: |model, text| plainly(eval::answer(model, text)) },
    Command { name: "export", argument: Argument::File, run: export },
    Command { name: "filter", argument: Argument::Text, run: |model, text| plainly(search::filter(model, text)) },
    Command {
        name: "glossary",
        argument: Argument::Nothing,
        run: |model, _| Ok(understanding::open(model, Kind::Glossary)),
    },
    Command { name: "grow", argument: Argument::Nothing, run: |model, _| go(model, Walk::Grow) },
    Command { name: "help", argument: Argument::Nothing, run: |model, _| Ok(walk::open_help(model)) },
    Command {
        name: HISTORY,
        argument: Argument::Quantity,
        run: |model, text| plainly(watch::open_history(model, text)),
    },
    Command { name: LANG, argument: Argument::Language, run: language },
    Command { name: "mouse", argument: Argument::Nothing, run: |model, _| go(model, Walk::Mouse) },
    Command { name: "note", argument: Argument::Note, run: bookmarks::note },
    Command { name: plane::PICTURE, argument: Argument::Plane, run: plane::run },
    Command { name: "pixel", argument: Argument::Pixel, run: pixel },
    Command { name: "play", argument: Argument::Nothing, run: |model, _| go(model, Walk::Play) },
    Command { name: "quit", argument: Argument::Nothing, run: |_, _| Ok(Effect::Leave(Exit::Quit)) },
    Command { name: "rays", argument: Argument::Nothing, run: |model, _| plainly(drawn::rays_over(model)) },
    Command {
        name: "sampling",
        argument: Argument::Name,
        run: |_, spec| Ok(Effect::Change(Change::Sampling(spec.to_owned()))),
    },
    Command {
        name: SCHEMATIC,
        argument: Argument::Schematic,
        run: |model, word| plainly(drawn::schematic(model, word)),
    },
    Command { name: "screenshot", argument: Argument::File, run: |_, path| Ok(Effect::Screenshot(path.to_owned())) },
    Command { name: "search", argument: Argument::Text, run: |model, text| plainly(search::begin(model, text)) },
    Command { name: SET, argument: Argument::Parameter, run: set },
    Command {
        name: "shadows",
        argument: Argument::Nothing,
        run: |model, _| {
            drawn::toggle_shadows(model);
            Ok(Effect::None)
        },
    },
    Command { name: "stops", argument: Argument::Nothing, run: |model, _| go(model, Walk::Stops) },
    Command { name: "undo", argument: Argument::Nothing, run: |_, _| Ok(Effect::Change(Change::Undo)) },
    Command { name: UNWATCH, argument: Argument::Key, run: |model, text| plainly(watch::remove(model, text)) },
    Command { name: WATCH, argument: Argument::Quantity, run: |model, text| plainly(watch::add(model, text)) },
    Command { name: "write", argument: Argument::File, run: |_, path| Ok(Effect::Save(path.to_owned())) },
];

/// The command for breakpoints.
const BREAK: &str = "break";

/// The commands for values.
const EVAL: &str = "eval";
const HISTORY: &str = "history";
const WATCH: &str = "watch";
const UNWATCH: &str = "unwatch";

/// Letters that many type from habit, and that several commands begin with.
const SHORT: [(&str, &str); 4] = [("e", "edit"), ("h", "help"), ("u", "undo"), ("w", "write")];

/// The command for parameters of the scene.
const SET: &str = "set";

/// The command for what the schematic shows, and from where.
const SCHEMATIC: &str = "schematic";

/// The command for the language.
const LANG: &str = "lang";

/// Does what was typed.
pub(super) fn run(model: &mut Model, text: &str) -> Done {
    let text = text.trim();
    if text.is_empty() {
        return Ok(Effect::None);
    }
    if let Some(number) = number(text) {
        return step(model, number);
    }
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let texts = &model.texts().commands;
    let command = find(word, texts)?;
    if command.argument == Argument::Nothing && !rest.is_empty() {
        return Err((texts.nothing_behind)(command.name));
    }
    if command.argument.is_needed() && rest.trim().is_empty() {
        return Err((texts.expected_more)(command.name, command.argument.word(texts)));
    }
    (command.run)(model, rest.trim())
}

/// Says what is wrong with a line, as far as that can be told of it alone.
///
/// # Errors
/// What is wrong with it.
pub fn check(line: &str) -> Result<(), String> {
    if number(line.trim()).is_some() {
        return Ok(());
    }
    let texts = &Language::English.texts().viewer.commands;
    let (word, rest) = line.trim().split_once(char::is_whitespace).unwrap_or((line.trim(), ""));
    let command = find(word, texts)?;
    let (has_none, is_missing) = (command.argument == Argument::Nothing, rest.trim().is_empty());
    match (has_none, is_missing) {
        (true, false) => Err((texts.nothing_behind)(command.name)),
        (false, true) if command.argument.is_needed() => {
            Err((texts.expected_more)(command.name, command.argument.word(texts)))
        }
        _ => Ok(()),
    }
}

/// A number, also one that is that of no step.
fn number(text: &str) -> Option<f64> {
    let is_made_of_digits = text.chars().all(|c| c.is_ascii_digit() || "+-.".contains(c));
    text.parse().ok().filter(|_| is_made_of_digits)
}

/// The command that a word or the beginning of one stands for.
fn find(word: &str, texts: &Commands) -> Result<&'static Command, String> {
    let word = SHORT.iter().find(|(short, _)| *short == word).map_or(word, |(_, name)| *name);
    let begun: Vec<_> = COMMANDS.iter().filter(|command| command.name.starts_with(word)).collect();
    if let Some(exact) = begun.iter().find(|command| command.name == word) {
        return Ok(exact);
    }
    match begun[..] {
        [command] => Ok(command),
        [] => Err(match suggest(word, COMMANDS.iter().map(|command| command.name)) {
            Some(near) => (texts.like)(&plain(word), near),
            None => (texts.unknown)(&plain(word)),
        }),
        _ => Err((texts.may_be)(&plain(word), &usages(begun.into_iter(), texts))),
    }
}

/// Every command with what follows it: for the help, which has a line of its own for the language.
pub(super) fn usage(texts: &Commands) -> String {
    format!("{}, {}", texts.step, usages(COMMANDS.iter().filter(|command| command.name != LANG), texts))
}

fn usages(commands: impl Iterator<Item = &'static Command>, texts: &Commands) -> String {
    let usage = |command: &Command| format!(":{} {}", command.name, command.argument.word(texts)).trim_end().to_owned();
    commands.map(usage).collect::<Vec<_>>().join(", ")
}

/// Nothing is left to do for what was done in the model.
fn plainly(done: Result<(), String>) -> Done {
    done.map(|()| Effect::None)
}

fn go(model: &mut Model, walk: Walk) -> Done {
    Ok(walk::update(model, walk, None))
}

/// Goes to a step, or to the one at that end of the log beyond which the number lies.
fn step(model: &mut Model, number: f64) -> Done {
    let count = model.log.events.len();
    let what_there_is = (model.texts().commands.steps)(count);
    if number.fract() != 0.0 {
        return Err(what_there_is);
    }
    // Negative and huge numbers become the nearest that there are.
    let step = number as usize;
    jumps::to_event(model, step.saturating_sub(1));
    if step == 0 || step > count {
        model.say(&what_there_is);
    }
    Ok(Effect::None)
}

/// Speaks the language with this code.
fn language(model: &mut Model, code: &str) -> Done {
    match Language::ALL.into_iter().find(|language| language.code() == code) {
        Some(language) => {
            model.language = language;
            // What is searched for is looked for in its words and numbers.
            search::renew(model);
            model.say(model.texts().messages.language);
            Ok(Effect::None)
        }
        None => Err(model.texts().commands.expected_language.to_owned()),
    }
}

/// Shows numbers with so many decimals.
fn digits(model: &mut Model, text: &str) -> Done {
    let texts = &model.texts().commands;
    let Some(digits) = text.parse().ok().filter(|digits| *digits <= Style::MOST_DIGITS) else {
        return Err((texts.expected_decimals)(Style::MOST_DIGITS));
    };
    model.numbers = model.numbers.with(digits);
    model.say(&(texts.decimals)(digits));
    // What was made is written with the others, and values are searched as they are shown.
    model.understanding.listing = None;
    search::renew(model);
    breakpoints::renew(model);
    Ok(Effect::None)
}

/// Another value of a parameter. A path has no blanks unless a name in it has: then it ends where the value begins, which is the last word.
fn set(model: &mut Model, text: &str) -> Done {
    let Some((path, value)) = text.split_once(char::is_whitespace) else {
        return Err(model.texts().messages.no_path.to_owned());
    };
    Ok(Effect::Change(Change::Set { path: path.to_owned(), value: value.trim().to_owned() }))
}

fn bookmark(model: &mut Model, text: &str) -> Done {
    let (letter, note) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let mut characters = letter.chars();
    match (characters.next(), characters.next()) {
        (Some(letter), None) if letter.is_alphanumeric() => bookmarks::set(model, letter, note.trim()),
        _ => Err(model.texts().commands.expected_letter.to_owned()),
    }
}

/// Saves the log in another format: with all its results.
fn export(model: &mut Model, path: &str) -> Done {
    match model.hides_outcome() {
        Some(why) => Err(why.to_owned()),
        None => Ok(Effect::Export(path.to_owned())),
    }
}

/// Goes to a pixel of the log, or has it traced.
fn pixel(model: &mut Model, text: &str) -> Done {
    let numbers: Vec<_> = text.split([',', ' ']).filter(|part| !part.is_empty()).map(str::parse).collect();
    let [Ok(x), Ok(y)] = numbers[..] else {
        return Err(model.texts().commands.expected_pixel.to_owned());
    };
    let is_it = |step: Option<Step>| step == Some(Step::Pixel([x, y]));
    let found = model.tree.children(0).find(|node| is_it(model.tree.nodes()[*node].step));
    let begins_at = match found {
        Some(node) => Some(model.tree.nodes()[node].events.start),
        None => (model.pixel() == Some([x, y])).then_some(0),
    };
    if let Some(event) = begins_at {
        jumps::to_event(model, event);
        return Ok(Effect::None);
    }
    if let Subject::Region([left, top, right, bottom]) = model.log.header.subject {
        let last = [left, top, right.saturating_sub(1), bottom.saturating_sub(1)];
        return Err((model.texts().commands.log_has)(last));
    }
    match model.picture.as_ref().map(|view| view.image.size) {
        Some([width, height]) if x >= width || y >= height => {
            Err((model.texts().commands.picture_has)([width - 1, height - 1]))
        }
        _ => {
            jumps::remember(model);
            Ok(Effect::Trace([x, y]))
        }
    }
}
