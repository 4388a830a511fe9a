//! Which lights reach anything that the camera sees.

use crate::log::{Decision, RayKind, Step};
use crate::probe::{Erased, Probe};
use crate::sampling;
use crate::scene::{Sampling, Scene};

/// The most pixels across and down that are asked.
const MOST: [u32; 2] = [64, 48];

/// How deep rays are followed here: what is seen in the mirror of a mirror of a mirror counts as unseen.
const BOUNCES: u32 = 3;

/// How the lights of a scene do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reach {
    /// For each light, whether it reaches a surface that the camera sees, directly or by bounces.
    pub lights: Vec<bool>,
    /// How many pixels were traced to find out.
    pub pixels: u32,
}

/// Traces a coarse picture and sees which lights have a part in it. Ends as soon as all have.
pub fn reach(mut scene: Scene) -> Reach {
    scene.sampling = Sampling::Center;
    scene.tracing.max_depth = scene.tracing.max_depth.min(BOUNCES);
    let mut probe = Lit { lights: vec![false; scene.lights.len()], open: Vec::new() };
    let size = scene.camera.resolution;
    let [across, down] = [0, 1].map(|side| size[side].min(MOST[side]));
    let place = |k: u32, of: u32, side: u32| ((2 * u64::from(k) + 1) * u64::from(side) / (2 * u64::from(of))) as u32;
    let mut pixels = 0;
    for (column, row) in (0..down).flat_map(|row| (0..across).map(move |column| (column, row))) {
        if probe.lights.iter().all(|is_lit| *is_lit) {
            break;
        }
        let pixel = [place(column, across, size[0]), place(row, down, size[1])];
        sampling::pixel(&scene, pixel, &mut Erased::of(&mut probe));
        pixels += 1;
    }
    Reach { lights: probe.lights, pixels }
}

/// The probe that sees shadow rays arrive.
struct Lit {
    lights: Vec<bool>,
    /// The nodes that the computation is inside; of a shadow ray its light, as long as nothing has blocked it.
    open: Vec<Option<u32>>,
}

impl Probe for Lit {
    fn mark(&mut self, decision: Decision) {
        if let (Decision::Occluded { .. }, Some(light)) = (decision, self.open.last_mut()) {
            *light = None;
        }
    }

    fn enter(&mut self, step: Step) {
        self.open.push(match step {
            Step::Ray { kind: RayKind::Shadow { light }, .. } => Some(light),
            _ => None,
        });
    }

    fn leave(&mut self) {
        if let Some(light) = self.open.pop().flatten() {
            self.lights[light as usize] = true;
        }
    }
}
