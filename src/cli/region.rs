//! The log of a region, written as it grows: threads make the lines of pixels, which are written in order.

use super::output::Sink;
use raywalk::log::file::{Lines, Writer};
use raywalk::log::{Event, Header, Shard, Subject};
use raywalk::probe::CutOff;
use raywalk::record::region::{self, Region};
use raywalk::record::{self, Arithmetic, MAX_EVENTS, Part};
use raywalk::scene::Scene;
use raywalk::threads::Threads;
use std::io;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A region whose log is written.
pub struct Traced<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// Which of its pixels.
    pub region: Region,
    /// In which arithmetic.
    pub arithmetic: Arithmetic,
    /// Which part of the region, if it is not all of it.
    pub shard: Option<Shard>,
}

/// The most text that waits to be written: a pixel with more than there is room for is traced where it is written.
const MAX_WAITING: usize = 256 << 20;

/// What a thread made of a pixel.
enum Made<'h> {
    Lines(Lines<'h>),
    /// There was no room for them.
    TooLong,
    Failed(CutOff),
}

impl Traced<'_> {
    /// What the log says about itself.
    pub fn header(&self) -> Header {
        let header = record::header(self.scene, Subject::Region(self.region), self.arithmetic);
        Header { shard: self.shard, ..header }
    }

    /// Its pixels.
    pub fn pixels(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        region::pixels_of(self.region, self.shard.unwrap_or(Shard::WHOLE))
    }

    /// Writes the log; `advance` is called for each pixel.
    pub fn write(&self, threads: &Threads, out: &mut Sink, advance: impl Fn()) -> io::Result<()> {
        let header = self.header();
        let mut writer = Writer::new(out, &header)?;
        let waiting = AtomicUsize::new(0);
        let make = |pixel| self.lines(&header, pixel, &waiting);
        region::in_order(self.pixels(), threads, make, |pixel, made| {
            match made {
                Made::Lines(lines) => {
                    writer.append(&lines)?;
                    waiting.fetch_sub(lines.bytes().len(), Ordering::Relaxed);
                }
                Made::TooLong => {
                    writer.write(&Event::opening(pixel).into())?;
                    let write = &mut |events: &_| writer.write(events);
                    record::stream(self.scene, Part::Pixel(pixel), self.arithmetic, write).map_err(plain)?;
                }
                Made::Failed(cut_off) => return Err(plain(cut_off)),
            }
            advance();
            Ok(())
        })?;
        writer.finish().map(|_| ())
    }

    fn lines<'h>(&self, header: &'h Header, pixel: [u32; 2], waiting: &AtomicUsize) -> Made<'h> {
        let mut lines = Lines::new(header);
        lines.push(&Event::opening(pixel).into());
        if let Arithmetic::Perturbed(_) = self.arithmetic {
            // Its runs are compared before there are digits to write.
            match region::of_pixel(self.scene, pixel, self.arithmetic, MAX_EVENTS) {
                Ok(events) => lines.push(&events),
                Err(cut_off) => return Made::Failed(cut_off),
            }
            waiting.fetch_add(lines.bytes().len(), Ordering::Relaxed);
            return Made::Lines(lines);
        }
        let mut told = 0;
        let mut push = |events: &_| {
            lines.push(events);
            let more = lines.bytes().len() - told;
            told += more;
            let before = waiting.fetch_add(more, Ordering::Relaxed);
            if before + more > MAX_WAITING { Err(io::ErrorKind::StorageFull.into()) } else { Ok(()) }
        };
        match record::stream(self.scene, Part::Pixel(pixel), self.arithmetic, &mut push) {
            Ok(()) => Made::Lines(lines),
            Err(_) => {
                waiting.fetch_sub(told, Ordering::Relaxed);
                Made::TooLong
            }
        }
    }
}

/// What cut a log off, as an error of writing.
pub fn plain(cut_off: CutOff) -> io::Error {
    match cut_off {
        CutOff::Io(error) => error,
        CutOff::TooLong { .. } | CutOff::Memory => io::Error::other(cut_off),
    }
}
