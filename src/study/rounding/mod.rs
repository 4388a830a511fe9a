//! Which rounding caused the error of a result: each quantity on its own, and all but each.

mod rounded;
mod views;

pub use rounded::Rounding;

use crate::log::{Log, Name, Tree, What};
use crate::probe::{Altered, CutOff, Erased, Position, RayTree, Recorder, Silent, until_cut_off};
use crate::record::{self, Arithmetic, Computation, Part, PartOf};
use crate::scene::Scene;
use rounded::{Rounded, Which};

/// The most quantities whose roundings are studied: the time grows with the square of their number.
pub const MAX_CAUSES: usize = 4096;

/// How many runs round every quantity up or down at random.
pub const RUNS: u32 = 100;

/// The error of a result, and what caused it.
#[derive(Clone, Debug)]
pub struct Study {
    /// What was traced, in which arithmetic; its events are those of the computation with nothing rounded.
    pub log: Log,
    /// The result in that arithmetic.
    pub rounded: [f64; 3],
    /// The result in f64.
    pub exact: [f64; 3],
    /// How far such a result may be off: half the root of the mean square by which results are off when every quantity is
    /// rounded up or down at random. Half, because such an error is twice as large as that of rounding to the nearest: in
    /// the mean its square is 1/3 of a step's instead of 1/12.
    pub spread: [f64; 3],
    /// Whether rounding changed the ray tree: then quantities may be missing here, and changes be jumps.
    pub decides_otherwise: bool,
    /// The quantities of the computation in f64, those first that change the result most when only they are rounded.
    pub causes: Vec<Cause>,
}

/// What the rounding of one quantity does.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// The path of the ray around it, such as `C R`.
    pub path: String,
    /// The node that it belongs to.
    pub node: usize,
    /// The quantity.
    pub name: Name,
    /// Which one of that name in its node, from 1.
    pub number: usize,
    /// The result with only this quantity rounded.
    pub only: Change,
    /// The result with all quantities but this one rounded.
    pub all_but: Change,
}

/// A result as it differs from that in f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// Red, green, blue, less what they are in f64.
    pub color: [f64; 3],
    /// Whether the ray tree is another.
    pub decides_otherwise: bool,
}

impl Change {
    /// The largest change of a channel.
    pub fn size(&self) -> f64 {
        self.color.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
    }
}

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
    let mut causes: Vec<_> = occurrences.into_iter().map(with_experiments).collect();
    // Stable: what changes nothing stays in the order of the computation.
    causes.sort_by(|one, other| other.only.size().total_cmp(&one.only.size()));
    let (rounded, tree) = experiments.run(Which::All);
    Ok(Study {
        log,
        rounded,
        exact: experiments.exact,
        spread: experiments.spread(),
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
