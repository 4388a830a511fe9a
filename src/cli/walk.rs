//! `raywalk walk`: the viewer; without a terminal the same walk as text.

use super::config::{Config, ConfigChoice};
use super::failure::{Failure, HUNG_UP, INTERRUPTED, TERMINATED, shown};
use super::frames;
use super::inputs::Inputs;
use super::live::workbench::Workbench;
use super::live::{SavedLog, Session};
use super::look::Look;
use super::options::{ColorChoice, TracingOptions, biased_effects};
use super::output::{self, Output};
use super::progress::ProgressOptions;
use super::saved_log::{self, Saved};
use super::scene_argument::{self, Input, Named};
use super::trace::{Subject, short_log};
use super::views::Lang;
use clap::Args;
use raywalk::files::{Opened, escape_hidden};
use raywalk::log::{Header, Log};
use raywalk::report::language::Language;
use raywalk::report::language::viewer::Warnings;
use raywalk::report::{self, Style};
use raywalk::tui::screenshot::Form;
use raywalk::tui::{self, Exit, Outcome, Theme};
use raywalk_guard::Endings;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

/// Walk through a pixel, a ray or a saved log in the terminal.
#[derive(Args, Default)]
pub struct Walk {
    /// A scene file (JSON or NFF), a saved log, `-` for standard input, or a built-in scene; without it the numeric
    /// example
    #[arg(value_name = "SCENE or LOG")]
    walked: Option<PathBuf>,
    #[command(flatten)]
    subject: Subject,
    /// Which frame of an animation, from 1; without it the first
    #[arg(long, value_name = "K", value_parser = frames::number)]
    frames: Option<u32>,
    /// The step to begin at
    #[arg(long, value_name = "STEP")]
    at: Option<usize>,
    /// Print the walk as text instead of opening the viewer
    #[arg(long)]
    plain: bool,
    #[command(flatten)]
    look: Look,
    /// The language of the viewer and of the walk as text, without it en; `:lang` in the viewer changes it
    #[arg(long, value_enum, value_name = "LANGUAGE")]
    lang: Option<Lang>,
    /// Decimals, without it 3
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=i64::from(Style::MOST_DIGITS)))]
    digits: Option<u32>,
    #[command(flatten)]
    config: ConfigChoice,
    /// Print the configuration of the viewer, with these options, as a file that says the same
    #[arg(long)]
    print_config: bool,
    /// Write a picture of the viewer instead of opening it, as .svg or .txt
    #[arg(long, value_name = "FILE.svg")]
    screenshot: Option<PathBuf>,
    /// The keys to press before the screenshot, such as `nnn` or `l<Down><Space>`
    #[arg(long, value_name = "KEYS", requires = "screenshot", default_value = "", hide_default_value = true)]
    keys: String,
    /// The size of the screenshot in characters
    #[arg(long, value_name = "COLUMNSxROWS", requires = "screenshot", value_parser = screen)]
    screen: Option<[u16; 2]>,
    #[command(flatten)]
    tracing: TracingOptions,
    #[command(flatten)]
    progress: ProgressOptions,
}

/// What is walked through.
struct Walked {
    /// Its name in messages.
    name: String,
    log: Log,
    /// What to warn of.
    warning: Option<String>,
    /// Who traces the scene, unless it is a saved log.
    session: Option<Session>,
    /// The files that were read.
    inputs: Inputs,
}

/// The most columns or rows of a screenshot.
const MAX_SCREEN: u16 = 1000;

/// The screenshot's size unless it is asked for.
const SCREEN: [u16; 2] = [110, 30];

impl Walk {
    /// The walk of `raywalk` alone.
    pub fn of_the_numeric_example() -> Walk {
        Walk::default()
    }

    /// Runs the command.
    pub fn run(self, colors: ColorChoice, signals: Option<Endings>) -> Result<(), Failure> {
        let is_viewer = self.screenshot.is_none() && !self.plain && has_terminal();
        let config = match is_viewer || self.print_config || self.config.is_named() {
            true => self.config.read()?,
            false => Config::default(),
        };
        let config = self.over(config);
        if self.print_config {
            return output::print(config.file().as_bytes());
        }
        self.tracing.use_threads();
        let walked = self.walked.as_deref().unwrap_or(Path::new("textbook"));
        let named = match &self.walked {
            Some(path) => scene_argument::open(path)?,
            None => Named::Scene(scene_argument::built_in("textbook")?),
        };
        let Walked { name, log, warning, mut session, inputs } = match named {
            Named::Scene(input) => self.of_scene(input, &config)?,
            Named::Log(opened) => self.of_log(opened, walked, &config)?,
        };
        let was_log = session.is_none();
        let mut saved = SavedLog::new(log.header.scene.digest.clone(), inputs.clone(), walked);
        let live: Option<&mut dyn tui::Live> = Some(match &mut session {
            Some(session) => session,
            None => &mut saved,
        });
        if let Some(path) = &self.screenshot {
            let form = self.check_screenshot(path)?;
            let [width, height] = self.screen.unwrap_or(SCREEN);
            let options = self.options(&log.header, config.look.in_picture(), warning, &config);
            let picture = tui::picture_as(form, log, &options, live, &self.keys, (width, height));
            return Output::create(Some(path), &inputs)?.commit(picture.as_bytes());
        }
        if !is_viewer {
            // That a log is damaged is no advice: it is always reported.
            if let Some(warning) = warning.filter(|_| was_log || !self.progress.quiet) {
                let before = Language::from(config.language).texts().viewer.status.warning;
                output::tell(&format!("{before}{name}: {warning}"));
            }
            let style = Style::of(&log.header, config.digits);
            return output::print(report::text::text(config.language.into(), &log, style).as_bytes());
        }
        // From here on the viewer minds its signals itself: it has a terminal to give back.
        if let Some(signals) = signals {
            signals.give_up();
        }
        let options = self.options(&log.header, config.look.in_terminal(colors), warning, &config);
        let outcome = tui::run(log, options, live)
            .map_err(|error| Failure::machine(format!("the terminal can't be used: {error}")))?;
        self.leave(walked, was_log, &config, &outcome)
    }

    /// A log that was saved.
    fn of_log(&self, opened: Opened, path: &Path, config: &Config) -> Result<Walked, Failure> {
        let has_options = self.tracing != TracingOptions::default() || self.subject != Subject::default();
        if has_options || self.frames.is_some() {
            return Err(saved_log::is_traced_already(&opened));
        }
        let Saved { name, log, ending } = saved_log::read(opened, &self.progress)?;
        Ok(Walked { name, log, warning: (warnings(config).ending)(&ending), session: None, inputs: Inputs::of([path]) })
    }

    /// The log of what is traced now.
    fn of_scene(&self, input: Input, config: &Config) -> Result<Walked, Failure> {
        // Only here it may be a log, too.
        if input.bytes.trim_ascii().is_empty() {
            let name = escape_hidden(&input.name);
            return Err(Failure::caller(format!("{name}: expected a scene or a log, found an empty file")));
        }
        let name = escape_hidden(&input.name).to_string();
        let doing = self.progress.doing(&format!("reading {name}"));
        let loaded = scene_argument::scene(&input, &self.tracing.import())?;
        doing.now("building the scene");
        let inputs = loaded.inputs.clone();
        let workbench = Workbench::new(input, loaded, self.tracing.clone(), self.frames);
        let scene = workbench.scene()?;
        let part = self.subject.part(&scene, self.tracing.arithmetic())?;
        let warning = biased_effects(&scene).filter(|_| self.subject.ray.is_none());
        let warning = warning.map(|effects| (warnings(config).biased)(&effects));
        doing.now("tracing the pixel");
        let log = short_log(&scene, part, self.tracing.arithmetic())?;
        // For a screenshot there is nothing to be shown before the whole of it.
        let session = Some(Session::new(scene, workbench, self.screenshot.is_some()));
        Ok(Walked { name, log, warning, session, inputs })
    }

    /// The configuration with what the options of this call say instead of it.
    fn over(&self, config: Config) -> Config {
        Config {
            look: self.look.over(config.look),
            language: self.lang.unwrap_or(config.language),
            digits: self.digits.unwrap_or(config.digits),
            ..config
        }
    }

    fn options(&self, header: &Header, theme: Theme, warning: Option<String>, config: &Config) -> tui::Options {
        let (numbers, language) = (Style::of(header, config.digits), config.language.into());
        tui::Options { theme, start: self.at, warning, note: None, numbers, language, controls: config.controls() }
    }

    /// The call that leads back to the place where the viewer was left: this one, with the pixel and the step.
    fn call_back(&self, walked: &Path, was_log: bool, config: &Config, outcome: &Outcome) -> String {
        let words: Vec<String> = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
        let walked = self.walked.is_none().then(|| walked.to_string_lossy().into_owned());
        let pixel = outcome.position.pixel.filter(|_| !was_log);
        let language = Some(outcome.language).filter(|language| *language != config.language.into());
        let digits = Some(outcome.numbers.digits).filter(|digits| *digits != config.digits);
        let words = words_back(words, walked, pixel, (language, digits), outcome.position.at);
        let words: Vec<_> = words.iter().map(|word| quoted(word)).collect();
        format!("raywalk {}", words.join(" "))
    }

    fn check_screenshot(&self, path: &Path) -> Result<Form, Failure> {
        let Some(form) = Form::of_name(&path.to_string_lossy()) else {
            return Err(Failure::caller(format!("{}: expected a name that ends in .svg or .txt", shown(path))));
        };
        if let Some(name) = tui::keys::unknown_name(&self.keys) {
            let message = format!("--keys: no key is called `{}`; `?` in the viewer lists them", escape_hidden(name));
            return Err(Failure::caller(message));
        }
        match self.screen {
            Some([0, _] | [_, 0]) => Err(Failure::caller("--screen: at least 1 column and 1 row".to_owned())),
            Some([width, height]) if width > MAX_SCREEN || height > MAX_SCREEN => {
                Err(Failure::caller(format!("--screen {width}x{height}: at most {MAX_SCREEN} columns and rows")))
            }
            _ => Ok(form),
        }
    }

    /// Ends as the viewer was left; prints the way back to the place.
    fn leave(&self, walked: &Path, was_log: bool, config: &Config, outcome: &Outcome) -> Result<(), Failure> {
        left(outcome.exit)?;
        if walked == Path::new("-") || self.progress.quiet {
            return Ok(());
        }
        let call = self.call_back(walked, was_log, config, outcome);
        let back_here = (outcome.language.texts().viewer.messages.back_here)(&call);
        output::print(format!("{back_here}\n").as_bytes())
    }
}

fn warnings(config: &Config) -> &'static Warnings {
    &Language::from(config.language).texts().viewer.messages.warnings
}

/// The size of a screen: `110x30`, or with a comma.
fn screen(text: &str) -> Result<[u16; 2], String> {
    let size =
        || text.split_once(['x', 'X', ',']).map(|(columns, rows)| [columns, rows].map(|side| side.trim().parse().ok()));
    match size() {
        Some([Some(columns), Some(rows)]) => Ok([columns, rows]),
        _ => Err("expected columns and rows, such as 110x30".to_owned()),
    }
}

/// Ends as a viewer was left.
pub fn left(exit: Exit) -> Result<(), Failure> {
    let code = match exit {
        Exit::Quit => return Ok(()),
        Exit::Interrupted => INTERRUPTED,
        Exit::Terminated => TERMINATED,
        Exit::HungUp => HUNG_UP,
    };
    Err(Failure::silent(code))
}

/// The words of a call, so that they lead to a pixel (if it isn't that of a ray or a log), a language and decimals (if they were changed) and a
/// step.
/// `walked` is the scene if the call named none.
fn words_back(
    words: Vec<String>,
    walked: Option<String>,
    pixel: Option<[u32; 2]>,
    (language, digits): (Option<Language>, Option<u32>),
    at: u32,
) -> Vec<String> {
    let mut options = words;
    // What follows `--` is no option.
    let end = options.iter().position(|word| word == "--").unwrap_or(options.len());
    let rest = options.split_off(end);
    let mut forget = |option: &str| {
        if let Some(at) = options.iter().position(|word| word == option) {
            options.drain(at..options.len().min(at + 2));
        }
        options.retain(|word| !word.starts_with(&format!("{option}=")));
    };
    forget("--at");
    if language.is_some() {
        forget("--lang");
    }
    if digits.is_some() {
        forget("--digits");
    }
    if pixel.is_some() {
        forget("--pixel");
        forget("--ray");
    }
    if let Some(walked) = walked {
        match options.iter().position(|word| word == "walk") {
            Some(at) => options.insert(at + 1, walked),
            None => options.extend(["walk".to_owned(), walked]),
        }
    }
    if let Some([x, y]) = pixel {
        options.extend(["--pixel".to_owned(), format!("{x},{y}")]);
    }
    if let Some(language) = language {
        options.extend(["--lang".to_owned(), language.code().to_owned()]);
    }
    if let Some(digits) = digits {
        options.extend(["--digits".to_owned(), digits.to_string()]);
    }
    options.extend(["--at".to_owned(), at.to_string()]);
    options.extend(rest);
    options
}

/// A word as a shell reads it back.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./,:=+%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", escape_hidden(word).replace('\'', "'\\''"))
    }
}

/// Whether there is a terminal that can show the viewer.
pub fn has_terminal() -> bool {
    let is_dumb = std::env::var_os("TERM").is_none_or(|term| term.is_empty() || term == "dumb");
    io::stdout().is_terminal() && !is_dumb
}

#[cfg(test)]
mod tests {
    use super::words_back;
    use raywalk::report::language::Language;

    #[track_caller]
    fn leads(call: &str, walked: Option<&str>, pixel: Option<[u32; 2]>, expected: &str) {
        let words = call.split_whitespace().map(str::to_owned).collect();
        assert_eq!(
            words_back(words, walked.map(str::to_owned), pixel, (None, None), 7).join(" "),
            expected,
            "after {call}"
        );
    }

    #[test]
    fn links_lead_to_the_pixel_where_the_viewer_was_left() {
        let there = Some([10, 20]);
        leads("walk a.json", None, there, "walk a.json --pixel 10,20 --at 7");
        leads("walk --pixel 1,2 a.json --at 3", None, there, "walk a.json --pixel 10,20 --at 7");
        leads("walk a.json --pixel=1,2 --at=3", None, there, "walk a.json --pixel 10,20 --at 7");
        leads("walk a.json --ray 1,2,3,-4,5,6", None, there, "walk a.json --pixel 10,20 --at 7");
        leads("walk a.json --ray -1,2,3,-4,5,6", None, None, "walk a.json --ray -1,2,3,-4,5,6 --at 7");
        leads("", Some("textbook"), there, "walk textbook --pixel 10,20 --at 7");
        let options = "--color never walk --arithmetic f32";
        leads(options, Some("textbook"), there, "--color never walk textbook --arithmetic f32 --pixel 10,20 --at 7");
        let words = "walk a.json --lang en".split(' ').map(str::to_owned).collect();
        let back = words_back(words, None, None, (Some(Language::Spanish), Some(6)), 7);
        assert_eq!(back.join(" "), "walk a.json --lang es --digits 6 --at 7");
        leads("walk -- a.json", None, there, "walk --pixel 10,20 --at 7 -- a.json");
    }
}
