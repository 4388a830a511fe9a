//! Two logs, pixel by pixel.

use super::Diff;
use crate::cli::failure::Failure;
use crate::cli::options::ColorChoice;
use crate::cli::options::ReportFormat;
use crate::cli::output;
use crate::cli::saved_log::{self, MAX_LOG_BYTES};
use crate::cli::walk::left;
use raywalk::files::{Opened, escape_hidden};
use raywalk::log::file::{PixelEvents, PixelReader};
use raywalk::log::{Events, Header, Log, Subject, Tree};
use raywalk::report::diff::{self, Format, Json, Numbering, Pixel, Rows, Side, Summary, Text, header_differences};
use raywalk::report::side_by_side::Run;
use raywalk::report::words;
use raywalk::report::{Language, forms};
use raywalk::tui::beside::{self, Beside};
use raywalk_guard::Endings;
use std::cmp::Ordering;
use std::io::Read;

impl Diff {
    /// Compares two logs; `false` where they differ.
    pub(super) fn logs(&self, a: Opened, b: Opened) -> Result<bool, Failure> {
        let (a, b) = (Source::open(a)?, Source::open(b)?);
        let mut view = self.view();
        let differences = header_differences(&a.log.header, &b.log.header);
        let mut pairs = Pairs::of(a, b)?;
        output::print(view.begin(&pairs.a.log.header, &pairs.b.log.header, &differences).as_bytes())?;
        let tolerance = self.tolerance();
        let mut summary = Summary::default();
        while let Some((pixel, there)) = pairs.next()? {
            let told = match there {
                There::In(_) if self.common => continue,
                There::In(side) => {
                    summary.add_alone(side);
                    view.alone(pixel, side)
                }
                There::InBoth => {
                    let [tree_a, tree_b] = pairs.trees();
                    let found = diff::compare(pairs.a.run(&tree_a), pairs.b.run(&tree_b), &tolerance);
                    summary.add(pixel, &found);
                    view.pixel(pixel, &found)
                }
            };
            output::print(told.as_bytes())?;
        }
        // Such logs would always be the same.
        if self.common && summary.values == 0 {
            let [a, b] = [&pairs.a.name, &pairs.b.name];
            return Err(Failure::caller(format!("--common: {a} and {b} have no value in common")));
        }
        output::print(view.end(&summary).as_bytes())?;
        self.check_whole(&pairs)?;
        Ok(summary.is_same())
    }

    /// Tells what is wrong with the logs. A damaged one may hide differences, so they aren't reported as equal.
    fn check_whole(&self, pairs: &Pairs) -> Result<(), Failure> {
        let damaged = [&pairs.a, &pairs.b].map(Source::warn).into_iter().flatten().collect::<Vec<_>>();
        if damaged.is_empty() || self.allow_damaged {
            return Ok(());
        }
        let (names, are) = (damaged.join(" and "), if damaged.len() == 1 { "isn't" } else { "aren't" });
        Err(Failure::caller(format!(
            "{names} {are} whole, so that there may be more differences; expected whole logs, or --allow-damaged"
        )))
    }

    /// Walks through two logs; of regions, through the first pixel that differs. `false` where they differ.
    pub(super) fn walk(
        &self,
        a: Opened,
        b: Opened,
        colors: ColorChoice,
        signals: Option<Endings>,
    ) -> Result<bool, Failure> {
        let config = self.config.read()?;
        let mut pairs = Pairs::of(Source::open(a)?, Source::open(b)?)?;
        let tolerance = self.tolerance();
        let (mut walked, mut is_same) = (None::<(Pixel, Log, Log)>, true);
        while let Some((pixel, there)) = pairs.next()? {
            is_same &= self.common || there == There::InBoth;
            if there == There::InBoth {
                let [tree_a, tree_b] = pairs.trees();
                let found = diff::compare(pairs.a.run(&tree_a), pairs.b.run(&tree_b), &tolerance);
                if walked.is_none() || !found.differences.is_empty() {
                    walked = Some((pixel, pairs.a.log.clone(), pairs.b.log.clone()));
                }
                if !found.differences.is_empty() {
                    is_same = false;
                    break;
                }
            }
        }
        let is_whole = self.check_whole(&pairs);
        let Some((pixel, a, b)) = walked else {
            return Err(Failure::caller("--walk: the two logs have no pixel in common"));
        };
        let [tree_a, tree_b] = [&a, &b].map(|log| Tree::of(&log.events));
        let rows = Rows::of(Run { log: &a, tree: &tree_a }, Run { log: &b, tree: &tree_b }, tolerance);
        let beside =
            Beside::new(rows, [title(&pairs.a.name, pixel, &a.header), title(&pairs.b.name, pixel, &b.header)]);
        // From here on the viewer minds its signals itself: it has a terminal to give back.
        if let Some(signals) = signals {
            signals.give_up();
        }
        let (beside, look) = (beside.with_keys(config.bindings), self.look.over(config.look));
        let exit = beside::run(beside, &look.in_terminal(colors))
            .map_err(|error| Failure::machine(format!("the terminal can't be used: {error}")))?;
        left(exit).and(is_whole).map(|()| is_same)
    }

    fn view(&self) -> Box<dyn Format> {
        match self.format {
            ReportFormat::Text => Box::new(Text::new(self.digits, self.brief)),
            ReportFormat::Json => Box::new(Json::new(self.brief)),
        }
    }
}

fn title(name: &str, pixel: Pixel, header: &Header) -> String {
    let subject = pixel.map_or_else(|| words::subject(Language::English, header), |[x, y]| format!("pixel {x},{y}"));
    format!("{name} - {subject} - {}", words::arithmetic(header))
}

/// Two logs, read pixel by pixel in the same order.
struct Pairs {
    a: Source,
    b: Source,
    numbering: Numbering,
    /// Whether pixels are compared one by one, because one of the logs may have several.
    is_region: bool,
}

/// Where a pixel is among those of a region.
fn row_by_row([x, y]: [u32; 2]) -> [u32; 2] {
    [y, x]
}

/// Which of the logs has a pixel.
#[derive(Clone, Copy, PartialEq, Eq)]
enum There {
    InBoth,
    In(Side),
}

impl Pairs {
    fn of(a: Source, mut b: Source) -> Result<Pairs, Failure> {
        let subjects = [a.log.header.subject, b.log.header.subject];
        let is_region = subjects.iter().any(|subject| matches!(subject, Subject::Region(_)));
        if is_region && subjects.iter().any(|subject| matches!(subject, Subject::Ray(_))) {
            let [a, b] = [&a.name, &b.name];
            return Err(Failure::caller(format!(
                "{a} and {b}: the one is the log of a ray, the other of a region; expected two of a kind"
            )));
        }
        let numbering = Numbering::unify(&a.log.header, &mut b.log.header);
        Ok(Pairs { a, b, numbering, is_region })
    }

    /// The next pixel, if there is one more: its number where there may be several, and which logs have it. Those that have it hold
    /// its events then.
    fn next(&mut self) -> Result<Option<(Pixel, There)>, Failure> {
        let is_region = self.is_region;
        let pixel = |found: &PixelEvents| found.pixel.filter(|_| is_region);
        let (a, b) = (self.a.next.as_ref().map(pixel), self.b.next.as_ref().map(pixel));
        // Row by row, as the log of a region goes.
        let place = |pixel: Pixel| pixel.map(row_by_row);
        let there = match (a, b) {
            (None, None) => return Ok(None),
            (Some(_), None) => There::In(Side::A),
            (None, Some(_)) => There::In(Side::B),
            (Some(a), Some(b)) => match place(a).cmp(&place(b)) {
                Ordering::Less => There::In(Side::A),
                Ordering::Equal => There::InBoth,
                Ordering::Greater => There::In(Side::B),
            },
        };
        if there != There::In(Side::B) {
            self.a.take()?;
        }
        if there != There::In(Side::A) {
            self.b.take()?;
            self.numbering.apply(&mut self.b.log.events);
        }
        let pixel = if there == There::In(Side::B) { b } else { a };
        Ok(Some((pixel.flatten(), there)))
    }

    fn trees(&self) -> [Tree; 2] {
        [&self.a, &self.b].map(|source| Tree::of(&source.log.events))
    }
}

/// A log that is read pixel by pixel.
struct Source {
    name: String,
    reader: PixelReader<Box<dyn Read>>,
    /// Its header, and the events of the current pixel.
    log: Log,
    next: Option<PixelEvents>,
    /// Where the pixel of `next` is.
    last: Option<[u32; 2]>,
    /// Whether every pixel so far came after the one before it, row by row.
    is_in_order: bool,
}

impl Source {
    fn open(opened: Opened) -> Result<Source, Failure> {
        let name = escape_hidden(opened.name()).into_owned();
        let input = |opened: Opened| -> Box<dyn Read> { Box::new(opened.stream(MAX_LOG_BYTES)) };
        let again = opened.again();
        let mut reader = PixelReader::open(input(opened)).map_err(|error| saved_log::failure(&name, &error))?;
        if let Some(again) = again {
            reader = reader.with_again(move || again().ok().map(input));
        }
        let log = Log { header: reader.header().clone(), events: Events::new() };
        let mut source = Source { name, reader, log, next: None, last: None, is_in_order: true };
        source.advance()?;
        Ok(source)
    }

    /// Puts the events of the next pixel into the log, and reads on.
    fn take(&mut self) -> Result<(), Failure> {
        self.log.events = self.next.take().map_or_else(Events::new, |pixel| pixel.events);
        forms::find(&mut self.log);
        self.advance()
    }

    fn run<'s>(&'s self, tree: &'s Tree) -> Run<'s> {
        Run { log: &self.log, tree }
    }

    fn advance(&mut self) -> Result<(), Failure> {
        let next = self.reader.next_pixel().map_err(|error| saved_log::failure(&self.name, &error))?;
        let place = |pixel: &PixelEvents| pixel.pixel.map(row_by_row);
        if let (Some(before), Some(next)) = (&self.last, next.as_ref().and_then(place)) {
            self.is_in_order &= *before < next;
        }
        self.last = next.as_ref().and_then(place);
        self.next = next;
        Ok(())
    }

    /// Always reports that a log is damaged or was cut off, and why pixels may seem to be missing. Gives the name of a log
    /// that isn't whole.
    fn warn(&self) -> Option<&str> {
        if !self.is_in_order {
            output::tell(&format!(
                "warning: {}: its pixels don't follow one another row by row, so they can't all be found in the other log",
                self.name
            ));
        }
        // In a walk up to the first pixel that differs the end isn't read.
        let ending = self.reader.ending()?;
        if let Some(warning) = ending.warning() {
            output::tell(&format!("warning: {}: {warning}", self.name));
        }
        (!ending.is_whole()).then_some(self.name.as_str())
    }
}
