//! Any probe behind a pointer: one compiled tracer for all the probes that needn't hurry.

use super::{Probe, Quantity, Saving, forward};
use crate::log::plane::Emitter;
use crate::log::{Decision, Name, Step, Value};
use glam::DVec3;

/// Hands all on to a probe whose type is erased, and goes on with what that returns.
///
/// The tracing path is compiled for every type of probe it is run before, all shapes and samplers with it. The ones of a render
/// and of a recording are worth that. All others run before this one, at the price of a call for every quantity.
pub struct Erased<'p> {
    probe: &'p mut dyn Methods,
    decimals_of_products: Option<u32>,
    sees_parts: bool,
}

impl<'p> Erased<'p> {
    /// The same probe with its type erased.
    pub fn of<P: Probe>(probe: &'p mut P) -> Erased<'p> {
        let (decimals_of_products, sees_parts) = (probe.decimals_of_products(), probe.sees_parts());
        Erased { probe, decimals_of_products, sees_parts }
    }
}

/// The methods of [`Probe`], with a quantity as a log holds it.
trait Methods {
    fn given(&mut self, name: Name, value: Value);
    fn note(&mut self, name: Name, value: Value) -> Value;
    fn mark(&mut self, decision: Decision);
    fn bounds_tested(&mut self, count: u64);
    fn certifies(&self) -> bool;
    fn slack(&self, size: f64) -> f64;
    fn fallback(&mut self);
    fn rays_saved(&mut self, why: Saving, rays: u64);
    fn part(&mut self, emitter: Emitter, color: DVec3);
    fn aim(&mut self, place: [f64; 2]);
    fn aimed(&mut self);
    fn enter(&mut self, step: Step);
    fn leave(&mut self);
}

impl<P: Probe> Methods for P {
    forward!(self => Probe of *self; mark bounds_tested certifies slack fallback rays_saved part aim aimed enter leave);

    fn given(&mut self, name: Name, value: Value) {
        match value {
            Value::Number(number) => Probe::given(self, name, number),
            Value::Triple(triple) => Probe::given(self, name, DVec3::from(triple)),
        }
    }

    fn note(&mut self, name: Name, value: Value) -> Value {
        match value {
            Value::Number(number) => Probe::note(self, name, number).value(),
            Value::Triple(triple) => Probe::note(self, name, DVec3::from(triple)).value(),
        }
    }
}

impl Probe for Erased<'_> {
    forward!(self => Methods of *self.probe; mark bounds_tested certifies slack fallback rays_saved part aim aimed enter leave);

    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        self.probe.given(name, value.value());
    }

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let noted = self.probe.note(name, value.value());
        let components = noted.components();
        value.map(|index, _| components[index])
    }

    fn decimals_of_products(&self) -> Option<u32> {
        self.decimals_of_products
    }

    fn sees_parts(&self) -> bool {
        self.sees_parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probe::{Altered, Decimal, Recorder};
    use crate::render::Counter;
    use crate::sampling;
    use crate::scene::{Scene, build, builtin, file};

    fn scenes() -> impl Iterator<Item = Scene> {
        ["textbook", "glass-and-mirror", "motion-blur"].into_iter().map(|name| {
            let text = builtin::text(name).unwrap_or_default();
            let loaded = file::check(text.as_bytes(), name).unwrap_or_else(|error| panic!("{}", error.report(false)));
            build(&loaded.scene, &Default::default()).unwrap_or_else(|unsupported| panic!("{unsupported}"))
        })
    }

    #[test]
    fn a_probe_sees_the_same_with_its_type_erased() {
        for scene in scenes() {
            let pixel = scene.camera.resolution.map(|side| side / 2);
            let (mut typed, mut erased) = (Recorder::default(), Recorder::default());
            let color = sampling::pixel(&scene, pixel, &mut typed);
            assert_eq!(sampling::pixel(&scene, pixel, &mut Erased::of(&mut erased)), color);
            assert!(erased.finish([0.0; 3]) == typed.finish([0.0; 3]));

            let (mut typed, mut erased) = (Counter::default(), Counter::default());
            sampling::pixel(&scene, pixel, &mut typed);
            sampling::pixel(&scene, pixel, &mut Erased::of(&mut erased));
            assert!(typed.rays() > 0 && typed.bounds_tests() + typed.primitive_tests() > 0);
            assert_eq!(
                (erased.rays(), erased.bounds_tests(), erased.primitive_tests(), erased.samples()),
                (typed.rays(), typed.bounds_tests(), typed.primitive_tests(), typed.samples())
            );
            let saved = |counter: Counter| counter.statistics(0, Default::default(), 0).saved;
            assert_eq!(saved(erased), saved(typed));
        }
    }

    #[test]
    fn the_computation_goes_on_with_what_a_probe_returns() {
        for scene in scenes() {
            let pixel = scene.camera.resolution.map(|side| side / 2);
            let by_hand = || Altered { alteration: Decimal::new(2), probe: Recorder::default() };
            let (mut typed, mut erased) = (by_hand(), by_hand());
            let color = sampling::pixel(&scene, pixel, &mut typed);
            assert_eq!(sampling::pixel(&scene, pixel, &mut Erased::of(&mut erased)), color);
            assert!(erased.probe.finish([0.0; 3]) == typed.probe.finish([0.0; 3]));
        }
    }
}
