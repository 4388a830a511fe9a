//! A log a pixel at a time, so that one of a region takes the memory of its largest pixel.

use super::document;
use super::error::{Ending, LogError};
use super::line::{self, Line};
use super::lines::Lines;
use super::read;
use super::reader::{ReadLog, Reader};
use super::write::Writer;
use crate::files::{Kind, LogForm};
use crate::log::event::{Event, Step, What};
use crate::log::events::Events;
use crate::log::header::{Header, Subject};
use std::io::{Read, Write};
use std::mem;

/// A log that is read a pixel at a time.
pub struct PixelReader<R> {
    source: Source<R>,
    /// The pixel whose opening event was read, while its own events weren't passed on yet.
    opened: Option<[u32; 2]>,
    /// Known once all is read.
    ending: Option<Ending>,
    again: Option<Again<R>>,
}

/// Gives the input once more.
type Again<R> = Box<dyn FnOnce() -> Option<R>>;

enum Source<R> {
    Lines {
        lines: Box<Lines<R>>,
        reader: Box<Reader>,
    },
    /// What is one document is read as a whole.
    Document {
        header: Box<Header>,
        rest: Events,
        /// How many of them were passed on.
        taken: usize,
        ending: Ending,
    },
}

/// The events of a pixel, as the log of this pixel alone has them: without the event that opens it in a region.
#[derive(Debug, PartialEq)]
pub struct PixelEvents {
    /// Its column and row; `None` for the log of a ray.
    pub pixel: Option<[u32; 2]>,
    /// The events.
    pub events: Events,
}

impl<R: Read> PixelReader<R> {
    /// Begins to read a log, NDJSON or one JSON document; what is wrong with it is treated as by [`super::read_from`].
    ///
    /// # Errors
    /// Those of [`super::read_from`].
    pub fn open(input: R) -> Result<PixelReader<R>, LogError> {
        let mut lines = Lines::of(input);
        if Kind::of(lines.beginning()?) == Kind::Log(LogForm::Document) {
            let ReadLog { log, ending } = document::read(&lines.whole()?)?;
            let header = Box::new(log.header);
            return Ok(PixelReader::of(Source::Document { header, rest: log.events, taken: 0, ending }));
        }
        let reader = Box::new(Reader::new(read::header(&mut lines)?));
        Ok(PixelReader::of(Source::Lines { lines: Box::new(lines), reader }))
    }

    fn of(source: Source<R>) -> PixelReader<R> {
        let mut reader = PixelReader { source, opened: None, ending: None, again: None };
        if let Subject::Pixel(pixel) = reader.header().subject {
            reader.opened = Some(pixel);
        }
        reader
    }

    /// With what gives the input once more. Whether a log that another program has rewritten is whole takes long to find out: this way only
    /// such a log is asked, when it has been read.
    pub fn with_again(mut self, again: impl FnOnce() -> Option<R> + 'static) -> PixelReader<R> {
        if let Source::Lines { reader, .. } = &mut self.source {
            reader.digest = None;
            self.again = Some(Box::new(again));
        }
        self
    }

    /// What the log says about itself.
    pub fn header(&self) -> &Header {
        match &self.source {
            Source::Lines { reader, .. } => &reader.lookup.header,
            Source::Document { header, .. } => header,
        }
    }

    /// How the log ends; `None` before the last pixel was read.
    pub fn ending(&self) -> Option<&Ending> {
        self.ending.as_ref()
    }

    /// The next pixel; the one pixel or ray of a log that is no region's. `None` behind the last one.
    ///
    /// # Errors
    /// Those of [`super::read_from`].
    pub fn next_pixel(&mut self) -> Result<Option<PixelEvents>, LogError> {
        let mut events = Events::new();
        while self.ending.is_none() {
            let next = self.read_to_pixel(&mut events)?;
            let pixel = mem::replace(&mut self.opened, next);
            // Nothing is before the first pixel of a region.
            if pixel.is_some() || !events.is_empty() {
                return Ok(Some(PixelEvents { pixel, events }));
            }
        }
        Ok(None)
    }

    /// Adds the lines of this log to another log, without a change and without a look at them. `false` if the digest of its bytes doesn't
    /// show that it is whole; lines may have been added then.
    ///
    /// # Errors
    /// [`LogError::Io`].
    pub fn copy_to(self, writer: &mut Writer<'_, impl Write>) -> Result<bool, LogError> {
        const PIECE: usize = 1 << 18;
        let Source::Lines { mut lines, .. } = self.source else { return Ok(false) };
        let (mut text, mut events) = (Vec::new(), 0);
        while let Some(line) = lines.next_line()? {
            if line.text.starts_with(b"{\"end\":") {
                // The pieces before counted none.
                writer.append_text(&text, events)?;
                let end = line::from_text::<Line>(line.text).ok().and_then(|line| line.end);
                let digest = lines.digest();
                let fits = end.is_some_and(|end| end.events == events && end.has(digest));
                // Packed data that were cut off behind it aren't whole.
                return Ok(fits && lines.count_rest()? == 0 && lines.damage().is_none());
            }
            text.extend_from_slice(line.text);
            text.push(b'\n');
            events += 1;
            if text.len() >= PIECE {
                writer.append_text(&text, 0)?;
                text.clear();
            }
        }
        Ok(false)
    }

    /// Adds the events of this log to another log, if this one is whole.
    ///
    /// # Errors
    /// [`LogError::Damaged`] where it isn't, or [`LogError::Io`]; events may have been added then.
    pub fn add_to(self, writer: &mut Writer<'_, impl Write>) -> Result<(), LogError> {
        const PIECE: usize = 4096;
        let ending = match self.source {
            Source::Document { mut rest, taken, ending, .. } => {
                rest.drain(..taken);
                writer.write(&rest)?;
                ending
            }
            Source::Lines { mut lines, mut reader } => loop {
                let ending = read::record(&mut lines, &mut reader)?;
                if ending.is_some() || reader.events.len() >= PIECE {
                    writer.write(&reader.hand_on())?;
                }
                if let Some(ending) = ending {
                    break read::with_damage(ending, &lines);
                }
            },
        };
        let what = match ending {
            Ending::Complete => return Ok(()),
            Ending::Damaged { what } => format!("the log is damaged: {what}"),
            other => other.warning().unwrap_or_default(),
        };
        Err(LogError::damaged(1, 1, &what))
    }

    /// Reads events up to the one that opens a pixel, or to the end; gives the pixel.
    fn read_to_pixel(&mut self, events: &mut Events) -> Result<Option<[u32; 2]>, LogError> {
        match &mut self.source {
            Source::Document { header, rest, taken, ending } => {
                if !matches!(header.subject, Subject::Region(_))
                    && *taken == 0
                    && !rest.iter().any(|event| opens(event).is_some())
                {
                    *events = mem::take(rest);
                }
                for event in &rest[*taken..] {
                    *taken += 1;
                    if let Some(pixel) = opens(event) {
                        return Ok(Some(pixel));
                    }
                    events.add_from(rest, event);
                }
                self.ending = Some(ending.clone());
            }
            Source::Lines { lines, reader } => loop {
                let ending = read::record(lines, reader)?;
                let pixel = reader.events.last().and_then(opens);
                if pixel.is_none() && ending.is_none() {
                    continue;
                }
                *events = reader.hand_on();
                if pixel.is_some() {
                    events.pop();
                }
                self.ending = ending.map(|ending| read::with_damage(ending, lines));
                if matches!(self.ending, Some(Ending::Mismatch { .. }))
                    && let Some(input) = self.again.take().and_then(|again| again())
                {
                    let mut anew = PixelReader::open(input)?;
                    while anew.next_pixel()?.is_some() {}
                    self.ending = anew.ending;
                }
                return Ok(pixel);
            },
        }
        Ok(None)
    }
}

/// The pixel that an event opens.
fn opens(event: &Event) -> Option<[u32; 2]> {
    match event.what {
        What::Enter { step: Step::Pixel(pixel), .. } => Some(pixel),
        _ => None,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::log::Log;
    use crate::log::file::{to_json, to_ndjson};
    use crate::record::{self, Arithmetic};
    use crate::scene::{build, builtin, file};

    fn log(region: Option<[u32; 4]>) -> Log {
        let text = builtin::text("textbook").unwrap();
        let scene = build(&file::check(text.as_bytes(), "test").unwrap().scene, &Default::default()).unwrap();
        match region {
            Some(region) => record::region::bounded(&scene, region, Arithmetic::F64).unwrap(),
            None => record::pixel(&scene, [160, 120], Arithmetic::F64),
        }
    }

    fn pixels(bytes: &[u8]) -> (Vec<PixelEvents>, Ending) {
        let mut reader = PixelReader::open(bytes).unwrap();
        let mut pixels = Vec::new();
        while let Some(pixel) = reader.next_pixel().unwrap() {
            pixels.push(pixel);
        }
        (pixels, reader.ending().unwrap().clone())
    }

    #[test]
    fn a_region_comes_pixel_by_pixel() {
        let log = log(Some([159, 119, 161, 121]));
        for bytes in [to_ndjson(&log).unwrap(), to_json(&log).unwrap()] {
            let (pixels, ending) = pixels(&bytes);
            assert_eq!(ending, Ending::Complete);
            let found: Vec<_> = pixels.iter().map(|pixel| pixel.pixel.unwrap()).collect();
            assert_eq!(found, [[159, 119], [160, 119], [159, 120], [160, 120]]);
            assert_eq!(pixels[3].events, self::log(None).events);
        }
    }

    #[test]
    fn a_pixel_is_one() {
        let log = log(None);
        for bytes in [to_ndjson(&log).unwrap(), to_json(&log).unwrap()] {
            let (pixels, ending) = pixels(&bytes);
            assert_eq!((pixels.len(), ending), (1, Ending::Complete));
            assert_eq!(pixels[0], PixelEvents { pixel: Some([160, 120]), events: log.events.clone() });
        }
    }

    #[test]
    fn what_was_cut_off_is_read_up_to_there() {
        let bytes = to_ndjson(&log(Some([159, 119, 161, 121]))).unwrap();
        let (pixels, ending) = pixels(&bytes[..bytes.len() / 2]);
        assert_eq!(ending, Ending::Missing { incomplete_record: true });
        assert!((2..4).contains(&pixels.len()), "{}", pixels.len());
    }
}
