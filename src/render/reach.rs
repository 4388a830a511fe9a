//! Which lights reach anything that the camera sees.

use crate::log::{Decision, RayKind, SkipReason, Step, Term};
use crate::probe::{CutOff, Erased, Probe, until_cut_off};
use crate::sampling;
use crate::scene::{Sampling, Scene};
use std::panic::resume_unwind;

/// The most pixels across and down that are asked.
const MOST: [u32; 2] = [64, 48];

/// How deep rays are followed here: what is seen in the mirror of a mirror of a mirror counts as unseen.
const BOUNCES: u32 = 3;

/// The most nodes of the computation that are visited: a light, a ray, an intersection test is one. Where thousands of surfaces lie in the way
/// to thousands of lights, finding out what each light reaches would take as long as all of them multiplied.
const MOST_NODES: u32 = 1 << 22;

/// Where these end it, this many pixels say what lights reach; of fewer nothing is said.
const ENOUGH: u32 = 64;

/// How the lights of a scene do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reach {
    /// For each light, whether it reaches a surface that the camera sees, directly or by bounces.
    pub lights: Vec<bool>,
    /// For each light, whether there are surfaces in view of which zeros in its colour and in their coefficients leave nothing.
    pub unusable: Vec<bool>,
    /// For each light, whether a shadow ray to it was blocked or it is behind a surface in view.
    pub hidden: Vec<bool>,
    /// Whether surfaces are in view and none of them has a local term: the weight of each is zero.
    pub is_unweighted: bool,
    /// How many pixels were traced to find out.
    pub pixels: u32,
    /// Whether that was ended so early that nothing is known of lights that reached nothing so far.
    pub is_cut_off: bool,
}

/// Traces a coarse picture and sees which lights have a part in it. Ends as soon as all have.
pub fn reach(mut scene: Scene) -> Reach {
    scene.sampling = Sampling::Center {};
    scene.tracing.max_depth = scene.tracing.max_depth.min(BOUNCES);
    let none = vec![false; scene.lights.len()];
    let mut probe = Lit {
        lights: none.clone(),
        unusable: none.clone(),
        hidden: none,
        has_local: false,
        has_unweighted: false,
        open: Vec::new(),
        nodes: 0,
    };
    let mut is_cut_off = false;
    let size = scene.camera.resolution;
    let [across, down] = [0, 1].map(|side| size[side].min(MOST[side]));
    let place = |k: u32, of: u32, side: u32| ((2 * u64::from(k) + 1) * u64::from(side) / (2 * u64::from(of))) as u32;
    let mut pixels = 0;
    for number in scattered(across * down) {
        let (column, row) = (number % across, number / across);
        if probe.lights.iter().all(|is_lit| *is_lit) {
            break;
        }
        let pixel = [place(column, across, size[0]), place(row, down, size[1])];
        let traced = until_cut_off(|| sampling::pixel(&scene, pixel, &mut Erased::of(&mut probe)));
        if traced.is_err() {
            is_cut_off = pixels < ENOUGH;
            break;
        }
        pixels += 1;
    }
    let Lit { lights, mut unusable, hidden, has_local, has_unweighted, .. } = probe;
    if has_unweighted {
        // No surface without a local term asks for any light.
        unusable.fill(true);
    }
    Reach { lights, unusable, hidden, is_unweighted: has_unweighted && !has_local, pixels, is_cut_off }
}

/// Numbers below this one, each once, so that the first ones lie all over the picture: steps of a part of the whole that is near the golden
/// section and has no divisor in common with it.
fn scattered(count: u32) -> impl Iterator<Item = u32> {
    let divides = |step: u32| (2..=step).any(|divisor| step.is_multiple_of(divisor) && count.is_multiple_of(divisor));
    let step = (1..=(u64::from(count) * 618 / 1000).max(1) as u32).rev().find(|step| !divides(*step)).unwrap_or(1);
    (0..count).map(move |number| (u64::from(number) * u64::from(step) % u64::from(count)) as u32)
}

/// The probe that sees shadow rays arrive.
struct Lit {
    lights: Vec<bool>,
    unusable: Vec<bool>,
    hidden: Vec<bool>,
    /// Whether a surface had a local term.
    has_local: bool,
    /// Whether a surface had none, because its weight, or the weights on the path to it, leave nothing of it.
    has_unweighted: bool,
    /// The nodes that the computation is inside.
    open: Vec<Inside>,
    /// How many there were.
    nodes: u32,
}

/// What a node is of.
#[derive(Clone, Copy)]
enum Inside {
    /// The part of a light in a local model.
    Light(u32),
    /// The shadow ray to a light, as long as nothing has blocked it.
    Shadow(u32),
    Other,
}

impl Probe for Lit {
    fn mark(&mut self, decision: Decision) {
        if let Decision::Skipped { what: Term::Local, .. } = decision {
            self.has_unweighted = true;
        }
        let Some(inside) = self.open.last_mut() else { return };
        match (decision, *inside) {
            (Decision::Occluded { .. }, Inside::Shadow(light)) => {
                self.hidden[light as usize] = true;
                *inside = Inside::Other;
            }
            (Decision::Skipped { why, .. }, Inside::Light(light)) => {
                let light = light as usize;
                match why {
                    SkipReason::Behind => self.hidden[light] = true,
                    SkipReason::NoLocalTerm | SkipReason::ZeroLight | SkipReason::ZeroPathLight => {
                        self.unusable[light] = true;
                    }
                    _ => {}
                }
            }
            _ => {}
        }
    }

    fn enter(&mut self, step: Step) {
        self.nodes += 1;
        if self.nodes > MOST_NODES {
            resume_unwind(Box::new(CutOff::TooLong { most: MOST_NODES as usize }));
        }
        self.has_local |= matches!(step, Step::Shade { .. });
        self.open.push(match step {
            Step::Ray { kind: RayKind::Shadow { light }, .. } => Inside::Shadow(light),
            Step::Light { light, .. } => Inside::Light(light),
            _ => Inside::Other,
        });
    }

    fn leave(&mut self) {
        if let Some(Inside::Shadow(light)) = self.open.pop() {
            self.lights[light as usize] = true;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_is_asked_once() {
        for count in [1, 2, 3, 12, 48, 64, 3072] {
            let mut found: Vec<u32> = scattered(count).collect();
            found.sort_unstable();
            assert_eq!(found, (0..count).collect::<Vec<_>>());
        }
        // The first ones already lie in every quarter.
        let quarters: std::collections::BTreeSet<u32> = scattered(3072).take(12).map(|number| number / 768).collect();
        assert_eq!(quarters.len(), 4);
    }
}
