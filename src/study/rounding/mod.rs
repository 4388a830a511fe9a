//! Which rounding caused the error of a result: each quantity on its own, and all but each.

mod rounded;

pub use crate::report::causes::{Cause, Change, Study};
pub use rounded::Rounding;

use crate::log::{Log, Tree, What};
use crate::probe::{Altered, CutOff, Erased, Position, RayTree, Recorder, Silent, until_cut_off};
use crate::record::{self, Arithmetic, Computation, Part, PartOf};
use crate::scene::Scene;
use crate::threads::{Threads, wanted};
use rayon::prelude::*;
use rounded::{Rounded, Which};

/// The most quantities whose roundings are studied: the time grows with the square of their number.
pub const MAX_CAUSES: usize = 4096;

/// How many runs round every quantity up or down at random.
pub const RUNS: u32 = 100;

impl Rounding {
    /// The rounding that makes an arithmetic; `None` for others.
    pub fn of(arithmetic: Arithmetic) -> Option<Rounding> {
        match arithmetic {
            Arithmetic::Decimal(digits) => Some(Rounding::Decimal(digits)),
            Arithmetic::F32 => Some(Rounding::Single),
            Arithmetic::DecimalProducts(_) | Arithmetic::F64 | Arithmetic::Perturbed(_) | Arithmetic::Printed => None,
        }
    }

    fn arithmetic(self) -> Arithmetic {
        match self {
            Rounding::Decimal(digits) => Arithmetic::Decimal(digits),
            Rounding::Single => Arithmetic::F32,
        }
    }
}

/// Studies the roundings of a pixel or ray.
///
/// What is compared with is f64 in the formulas of the other arithmetics, which take no decision with more digits.
///
/// # Errors
/// [`CutOff::TooLong`] if there are more than [`MAX_CAUSES`] quantities.
pub fn study(scene: &Scene, part: Part, rounding: Rounding) -> Result<Study, CutOff> {
    let experiments = Experiments::new(PartOf { scene, part }, rounding);
    let header = record::header(scene, part.subject(), rounding.arithmetic());
    let log = Log { events: experiments.record()?, header };
    let occurrences = occurrences(&log);
    if occurrences.len() > MAX_CAUSES {
        return Err(CutOff::TooLong { most: MAX_CAUSES });
    }
    let with_experiments = |(cause, key): (Cause, u64)| Cause {
        only: experiments.change(Which::Only(key)),
        all_but: experiments.change(Which::AllBut(key)),
        ..cause
    };
    // Each experiment traces everything anew.
    const EACH: usize = 16;
    let threads = Threads::of(wanted(), occurrences.len() / EACH);
    let mut causes: Vec<_> = threads.run(|| occurrences.into_par_iter().map(with_experiments).collect());
    // Stable: what changes nothing stays in the order of the computation.
    causes.sort_by(|one, other| other.only.size().total_cmp(&one.only.size()));
    let (rounded, tree) = experiments.run(Which::All);
    Ok(Study {
        log,
        rounded,
        exact: experiments.exact,
        spread: experiments.spread(),
        runs: RUNS,
        decides_otherwise: tree != experiments.exact_tree,
        causes,
    })
}

/// The computation with this or that rounded.
struct Experiments<'s> {
    computation: PartOf<'s>,
    rounding: Rounding,
    exact: [f64; 3],
    exact_tree: u64,
}

impl<'s> Experiments<'s> {
    fn new(computation: PartOf<'s>, rounding: Rounding) -> Experiments<'s> {
        let mut experiments = Experiments { computation, rounding, exact: [0.0; 3], exact_tree: 0 };
        (experiments.exact, experiments.exact_tree) = experiments.run(Which::None);
        experiments
    }

    /// The result, and the digest of the ray tree.
    fn run(&self, which: Which) -> ([f64; 3], u64) {
        let alteration = Rounded::new(self.rounding, which);
        let mut probe = Altered { alteration, probe: RayTree::before(Silent) };
        let color = self.computation.run(&mut Erased::of(&mut probe));
        (color.to_array(), probe.probe.digest())
    }

    fn change(&self, which: Which) -> Change {
        let (color, tree) = self.run(which);
        Change { color: self.off(color), decides_otherwise: tree != self.exact_tree }
    }

    fn off(&self, color: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|channel| color[channel] - self.exact[channel])
    }

    fn spread(&self) -> [f64; 3] {
        let mut squares = [0.0; 3];
        for seed in 0..RUNS {
            let off = self.off(self.run(Which::EitherWay { seed: seed.into() }).0);
            squares.iter_mut().zip(off).for_each(|(square, off)| *square += off * off);
        }
        squares.map(|square: f64| (square / f64::from(RUNS)).sqrt() / 2.0)
    }

    /// The log of the computation with nothing rounded.
    fn record(&self) -> Result<crate::log::Events, CutOff> {
        until_cut_off(|| {
            let alteration = Rounded::new(self.rounding, Which::None);
            let mut probe = Altered { alteration, probe: Recorder::of_at_most(record::MAX_EVENTS) };
            let color = self.computation.run(&mut Erased::of(&mut probe));
            probe.probe.finish(color.to_array())
        })
    }
}

/// The quantities of a log with their keys, before any experiment.
fn occurrences(log: &Log) -> Vec<(Cause, u64)> {
    const NOTHING: Change = Change { color: [0.0; 3], decides_otherwise: false };
    let tree = Tree::of(&log.events);
    let mut position = Position::new(0);
    let mut occurrences: Vec<(Cause, u64)> = Vec::new();
    for (at, event) in log.events.iter().enumerate() {
        match event.what {
            What::Enter { step, .. } => position.enter(step),
            What::Leave => position.leave(),
            What::Note { name, .. } => {
                let node = tree.owner(at);
                let is_same = |before: &usize| matches!(log.events[*before].what, What::Note { name: other, .. } if other == name);
                let cause = Cause {
                    path: tree.path(node),
                    node,
                    event: at,
                    name,
                    number: tree.own_events_before(node, at).filter(is_same).count() + 1,
                    only: NOTHING,
                    all_but: NOTHING,
                };
                occurrences.push((cause, position.next(name)));
            }
            What::Mark(_) | What::Result { .. } => {}
        }
    }
    occurrences
}
