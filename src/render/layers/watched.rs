//! A probe beside those that catch what planes name.

use super::catcher::Catcher;
use super::parts::Parts;
use super::planes::Planes;
use crate::log::plane::Emitter;
use crate::log::{Decision, Name, Step};
use crate::probe::{Probe, Quantity, forward};
use glam::DVec3;

/// Sees what `probe` sees, and keeps what planes name of it.
pub(in crate::render) struct Watched<'p, P> {
    /// Who sees it, too.
    pub probe: P,
    catcher: Catcher<'p>,
    parts: Parts<'p>,
    numbers: usize,
    sees_parts: bool,
}

impl<'p, P> Watched<'p, P> {
    /// Before a pixel.
    pub fn new(probe: P, planes: &'p Planes) -> Watched<'p, P> {
        let wanted = planes.resolved();
        let (catcher, parts) = (Catcher::new(wanted), Parts::new(wanted));
        let sees_parts = parts.is_wanted();
        Watched { probe, catcher, parts, numbers: planes.numbers(), sees_parts }
    }

    /// The probe, and the numbers of all planes.
    pub fn finish(self) -> (P, Vec<f64>) {
        let mut numbers = vec![f64::NAN; self.numbers];
        self.catcher.finish(&mut numbers);
        self.parts.finish(&mut numbers);
        (self.probe, numbers)
    }
}

impl<P: Probe> Probe for Watched<'_, P> {
    forward!(self => Probe of self.probe; bounds_tested certifies slack fallback rays_saved aim aimed);

    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        self.probe.given(name, value);
        self.catcher.given(name, value);
        if self.sees_parts {
            self.parts.given(name, value);
        }
    }

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let noted = self.probe.note(name, value);
        self.catcher.note(name, noted);
        noted
    }

    fn mark(&mut self, decision: Decision) {
        self.probe.mark(decision);
        self.catcher.mark(decision);
        if self.sees_parts {
            self.parts.mark(decision);
        }
    }

    fn decimals_of_products(&self) -> Option<u32> {
        self.probe.decimals_of_products()
    }

    fn sees_parts(&self) -> bool {
        self.sees_parts
    }

    fn part(&mut self, emitter: Emitter, color: DVec3) {
        self.parts.part(emitter, color);
    }

    fn enter(&mut self, step: Step) {
        self.probe.enter(step);
        self.catcher.enter(step);
        if self.sees_parts {
            self.parts.enter(step);
        }
    }

    fn leave(&mut self) {
        self.catcher.leave();
        if self.sees_parts {
            self.parts.leave();
        }
        self.probe.leave();
    }
}
