//! Two logs, pixel by pixel.

use super::{Diff, DiffFormat};
use crate::cli::failure::Failure;
use crate::cli::output;
use crate::cli::saved_log::{self, MAX_LOG_BYTES};
use raywalk::log::file::{PixelEvents, PixelReader};
use raywalk::log::{Event, Header, Log, Subject, Tree};
use raywalk::report::diff::{
    self, Comparison, HeaderDifference, Json, Numbering, Side, Summary, Text, header_differences,
};
use raywalk::report::side_by_side::Run;
use raywalk::scene::file::{Opened, visible};
use std::cmp::Ordering;
use std::io::Read;

impl Diff {
    /// Compares two logs; `false` where they differ.
    pub(super) fn logs(&self, a: Opened, b: Opened) -> Result<bool, Failure> {
        let (mut a, mut b) = (Source::open(a)?, Source::open(b)?);
        let is_region = is_of_region(&a, &b)?;
        let mut view = self.view();
        let differences = header_differences(&a.log.header, &b.log.header);
        output::print(view.begin(&a.log.header, &b.log.header, &differences).as_bytes())?;
        let numbering = Numbering::unify(&a.log.header, &mut b.log.header);
        let tolerance = self.tolerance();
        let mut summary = Summary::default();
        loop {
            let pixel = |found: &PixelEvents| found.pixel.filter(|_| is_region);
            let order = match (&a.next, &b.next) {
                (None, None) => break,
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                // Row by row, as the log of a region goes.
                (Some(a), Some(b)) => pixel(a).map(|[x, y]| [y, x]).cmp(&pixel(b).map(|[x, y]| [y, x])),
            };
            let at = if order == Ordering::Greater { &b.next } else { &a.next };
            let at = at.as_ref().and_then(pixel);
            let told = match order {
                Ordering::Less => alone(&mut summary, &mut view, at, Side::A),
                Ordering::Greater => alone(&mut summary, &mut view, at, Side::B),
                Ordering::Equal => {
                    a.take(|_| ());
                    b.take(|events| numbering.apply(events));
                    let [tree_a, tree_b] = [&a, &b].map(|source| Tree::of(&source.log.events));
                    let [run_a, run_b] = [Run { log: &a.log, tree: &tree_a }, Run { log: &b.log, tree: &tree_b }];
                    let found = diff::compare(run_a, run_b, &tolerance);
                    summary.add(at, &found);
                    view.pixel(at, &found)
                }
            };
            output::print(told.as_bytes())?;
            if order != Ordering::Greater {
                a.advance()?;
            }
            if order != Ordering::Less {
                b.advance()?;
            }
        }
        output::print(view.end(&summary).as_bytes())?;
        a.warn();
        b.warn();
        Ok(summary.is_same())
    }

    fn view(&self) -> View {
        match self.format {
            DiffFormat::Text => View::Text(Text { digits: self.digits, is_brief: self.brief, has_first: false }),
            DiffFormat::Json => View::Json(Json::new(self.brief)),
        }
    }
}

/// Whether pixels are compared one by one, because one of the logs may have several.
fn is_of_region(a: &Source, b: &Source) -> Result<bool, Failure> {
    let subjects = [a, b].map(|source| source.log.header.subject);
    let is_region = |subject: &Subject| matches!(subject, Subject::Region(_));
    if subjects.iter().any(is_region) && subjects.iter().any(|subject| matches!(subject, Subject::Ray(_))) {
        let [a, b] = [&a.name, &b.name];
        let message =
            format!("{a} and {b}: the one is the log of a ray, the other of a region; expected two of a kind");
        return Err(Failure::caller(message));
    }
    Ok(subjects.iter().any(is_region))
}

fn alone(summary: &mut Summary, view: &mut View, pixel: Option<[u32; 2]>, side: Side) -> String {
    summary.add_alone(side);
    view.alone(pixel, side)
}

/// A log that is read pixel by pixel.
struct Source {
    name: String,
    reader: PixelReader<Box<dyn Read>>,
    /// Its header, and the events of the current pixel.
    log: Log,
    next: Option<PixelEvents>,
}

impl Source {
    fn open(opened: Opened) -> Result<Source, Failure> {
        let name = visible(opened.name()).into_owned();
        let input: Box<dyn Read> = Box::new(opened.stream(MAX_LOG_BYTES));
        let reader = PixelReader::open(input).map_err(|error| saved_log::failure(&name, &error))?;
        let log = Log { header: reader.header().clone(), events: Vec::new() };
        let mut source = Source { name, reader, log, next: None };
        source.advance()?;
        Ok(source)
    }

    /// Puts the events of the next pixel into the log, changed by `change`.
    fn take(&mut self, change: impl FnOnce(&mut [Event])) {
        self.log.events = self.next.take().map_or_else(Vec::new, |pixel| pixel.events);
        change(&mut self.log.events);
    }

    fn advance(&mut self) -> Result<(), Failure> {
        self.next = self.reader.next_pixel().map_err(|error| saved_log::failure(&self.name, &error))?;
        Ok(())
    }

    /// That a log is damaged or was cut off is told in any case.
    fn warn(&self) {
        if let Some(warning) = self.reader.ending().and_then(raywalk::log::file::Ending::warning) {
            output::tell(&format!("warning: {}: {warning}", self.name));
        }
    }
}

/// How the comparison is written.
enum View {
    Text(Text),
    Json(Json),
}

impl View {
    fn begin(&self, a: &Header, b: &Header, differences: &[HeaderDifference]) -> String {
        match self {
            View::Text(text) => text.begin(a, b, differences),
            View::Json(json) => json.begin(a, b, differences),
        }
    }

    fn pixel(&mut self, pixel: Option<[u32; 2]>, found: &Comparison) -> String {
        match self {
            View::Text(text) => text.pixel(pixel, found),
            View::Json(json) => json.pixel(pixel, found),
        }
    }

    fn alone(&mut self, pixel: Option<[u32; 2]>, side: Side) -> String {
        match self {
            View::Text(text) => text.alone(pixel, side),
            View::Json(json) => json.alone(pixel, side),
        }
    }

    fn end(&self, summary: &Summary) -> String {
        match self {
            View::Text(text) => text.end(summary),
            View::Json(json) => json.end(summary),
        }
    }
}
