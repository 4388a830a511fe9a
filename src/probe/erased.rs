//! Any probe behind a pointer: one compiled tracer for all the probes that needn't hurry.

use super::{Probe, Quantity};
use crate::log::{Decision, Name, Step, Value};

/// Hands all on to a probe whose type is erased, and goes on with what that returns.
///
/// The tracing path is compiled for every type of probe it is run before, all shapes and samplers with it. The ones of a render
/// and of a recording are worth that. All others run before this one, at the price of a call for every quantity.
pub struct Erased<'p> {
    probe: &'p mut dyn Methods,
}

impl<'p> Erased<'p> {
    /// The same probe with its type erased.
    pub fn of<P: Probe>(probe: &'p mut P) -> Erased<'p> {
        Erased { probe }
    }
}

/// The methods of [`Probe`], with a quantity as what stands in a log.
trait Methods {
    fn given(&mut self, name: Name, value: Value);
    fn note(&mut self, name: Name, value: Value) -> Value;
    fn mark(&mut self, decision: Decision);
    fn bounds_tested(&mut self, count: u64);
    fn certifies(&self) -> bool;
    fn fallback(&mut self);
    fn aim(&mut self, place: [f64; 2]);
    fn aimed(&mut self);
    fn enter(&mut self, step: Step);
    fn leave(&mut self);
}

impl<P: Probe> Methods for P {
    fn given(&mut self, name: Name, value: Value) {
        match value {
            Value::Number(number) => Probe::given(self, name, number),
            Value::Triple(triple) => Probe::given(self, name, glam::DVec3::from(triple)),
        }
    }

    fn note(&mut self, name: Name, value: Value) -> Value {
        match value {
            Value::Number(number) => Probe::note(self, name, number).value(),
            Value::Triple(triple) => Probe::note(self, name, glam::DVec3::from(triple)).value(),
        }
    }

    fn mark(&mut self, decision: Decision) {
        Probe::mark(self, decision);
    }

    fn bounds_tested(&mut self, count: u64) {
        Probe::bounds_tested(self, count);
    }

    fn certifies(&self) -> bool {
        Probe::certifies(self)
    }

    fn fallback(&mut self) {
        Probe::fallback(self);
    }

    fn aim(&mut self, place: [f64; 2]) {
        Probe::aim(self, place);
    }

    fn aimed(&mut self) {
        Probe::aimed(self);
    }

    fn enter(&mut self, step: Step) {
        Probe::enter(self, step);
    }

    fn leave(&mut self) {
        Probe::leave(self);
    }
}

impl Probe for Erased<'_> {
    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        self.probe.given(name, value.value());
    }

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let noted = self.probe.note(name, value.value());
        let components = noted.components();
        value.map(|index, _| components[index])
    }

    fn mark(&mut self, decision: Decision) {
        self.probe.mark(decision);
    }

    fn bounds_tested(&mut self, count: u64) {
        self.probe.bounds_tested(count);
    }

    fn certifies(&self) -> bool {
        self.probe.certifies()
    }

    fn fallback(&mut self) {
        self.probe.fallback();
    }

    fn aim(&mut self, place: [f64; 2]) {
        self.probe.aim(place);
    }

    fn aimed(&mut self) {
        self.probe.aimed();
    }

    fn enter(&mut self, step: Step) {
        self.probe.enter(step);
    }

    fn leave(&mut self) {
        self.probe.leave();
    }
}
