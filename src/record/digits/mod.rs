//! How many digits of each value can be trusted: several runs, each perturbed in its own way, and what they have in common
//! (CESTAC: Vignes 1993).

mod align;
mod significant;

pub use significant::{ALL_DIGITS, RUNS, significant};

use super::{Arithmetic, Computation};
use crate::log::{Digits, Events, Value, What};
use crate::probe::{CutOff, Erased, Perturbed, Probe, RayTree};
use align::{Alignment, Run, components};
use raywalk_guard::{attempt, has_room_for};

/// The arithmetics of the runs, the first with `seed` itself.
fn arithmetics(seed: u64) -> [Arithmetic; RUNS] {
    std::array::from_fn(|run| Arithmetic::Perturbed(Perturbed::seed_of_run(seed, run as u64)))
}

/// The number of digits of a computation's colour, that of its least exact channel; 0 if the runs took different
/// decisions. `probe` sees all runs.
pub fn of_color<P: Probe, C: Computation + Copy>(computation: C, seed: u64, mut probe: P) -> (f64, P) {
    let mut colors = [[0.0; 3]; RUNS];
    let mut digests = [0; RUNS];
    for (run, arithmetic) in arithmetics(seed).into_iter().enumerate() {
        let mut tree = RayTree::before(probe);
        let (color, _) = arithmetic.run(Erased::of(&mut tree), computation);
        (colors[run], digests[run]) = (color.to_array(), tree.digest());
        probe = tree.probe;
    }
    if digests.iter().any(|digest| *digest != digests[0]) {
        return (0.0, probe);
    }
    let channels = (0..3).map(|channel| significant(&colors.map(|color| color[channel])));
    (channels.fold(ALL_DIGITS, f64::min), probe)
}

/// Puts the number of digits of each value into the log of a run perturbed by `seed`; `record` makes those of the others.
///
/// # Errors
/// [`CutOff`] if another run has no place, or there is no memory to compare them.
pub(super) fn put_into(
    events: &mut Events,
    seed: u64,
    record: impl Fn(Arithmetic) -> Result<Events, CutOff>,
) -> Result<(), CutOff> {
    // The numbers of digits themselves: in the middle of the work an allocation that fails could only abort.
    if !has_room_for(2 * events.len() * size_of::<Digits>()) {
        return Err(CutOff::Memory);
    }
    let mut differs = filled(events.len(), false)?;
    let mut values = Vec::with_capacity(RUNS);
    let ours = Run::of(events);
    for arithmetic in &arithmetics(seed)[1..] {
        let others = record(*arithmetic)?;
        let mut of_run = filled(events.len(), [0.0; 3])?;
        let theirs = Run::of(&others);
        let mut alignment = Alignment { ours: &ours, theirs: &theirs, values: &mut of_run, differs: &mut differs };
        alignment.node(0, 0);
        values.push(of_run);
    }
    for (at, event) in events.iter_mut().enumerate() {
        let own = components(&event.what);
        let digits = |component: usize| {
            significant(&std::array::from_fn(|run| if run == 0 { own } else { values[run - 1][at] }[component]))
        };
        let digits = match event.what {
            What::Enter { .. } | What::Leave => None,
            _ if differs[at] => Some(Digits::DecisionDiffers),
            What::Mark(_) => None,
            What::Note { value: Value::Number(_), .. } => Some(Digits::Significant(Value::Number(digits(0)))),
            _ => Some(Digits::Significant(Value::Triple([0, 1, 2].map(digits)))),
        };
        event.digits = digits.map(Box::new);
    }
    Ok(())
}

/// Memory for something of each event.
fn filled<T: Copy>(count: usize, content: T) -> Result<Vec<T>, CutOff> {
    let mut filled = Vec::new();
    attempt(|| filled.try_reserve_exact(count)).map_err(|_| CutOff::Memory)?;
    filled.resize(count, content);
    Ok(filled)
}
