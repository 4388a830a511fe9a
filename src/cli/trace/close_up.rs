//! `raywalk trace --view`: a close-up of one hit.

use super::{Trace, TraceFormat};
use crate::cli::failure::Failure;
use clap::ValueEnum;
use raywalk::log::{Log, Tree};
use raywalk::report::Style;
use raywalk::report::close_up::{self, CloseUp, CloseUpError, Subject};

/// What is shown of a hit.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CloseUpOf {
    /// N, V, R and T in the plane of incidence; L, and H or H′, for each light (figures 10 to 13).
    Vectors,
    /// The zones of a blurred bounce with their directions (figure 22).
    Zones,
    /// The points of an area light with the weights of their shadow rays.
    Light,
}

impl CloseUpOf {
    fn word(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }
}

impl Trace {
    /// A close-up in its format, which is SVG unless another was asked for.
    pub(super) fn close_up(&self, of: CloseUpOf, log: &Log) -> Result<Vec<u8>, Failure> {
        let make: fn(&Subject) -> Result<CloseUp, CloseUpError> = match of {
            CloseUpOf::Vectors => close_up::vectors,
            CloseUpOf::Zones => close_up::zones,
            CloseUpOf::Light => close_up::light,
        };
        let subject = Subject {
            log,
            tree: &Tree::of(&log.events),
            path: self.path.as_deref(),
            language: self.lang.into(),
            style: Style::of(&log.header, self.digits),
        };
        let made = make(&subject).map_err(|error| Failure::caller(format!("--view {}: {error}", of.word())))?;
        let text = match self.format {
            Some(TraceFormat::Text) => close_up::text(&made),
            Some(TraceFormat::Latex) => close_up::latex(&made),
            _ => close_up::svg(&made),
        };
        Ok(text.into_bytes())
    }

    /// A close-up is of one pixel or ray, in a format that it has.
    pub(super) fn check_close_up(&self, is_region: bool) -> Result<(), Failure> {
        if is_region {
            return Err(Failure::caller("--view: expected a pixel or a ray, found a region"));
        }
        if self.causes || self.shard.is_some() {
            return Err(Failure::caller("--view: expected neither --causes nor --shard, which write other outputs"));
        }
        match self.format {
            None | Some(TraceFormat::Svg | TraceFormat::Latex | TraceFormat::Text) => Ok(()),
            Some(format) => {
                let found = format.word();
                Err(Failure::caller(format!("--view: expected --format svg, latex or text, found {found}")))
            }
        }
    }
}
