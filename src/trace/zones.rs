//! Blurred reflection and transmission: rays through the zones of a lobe about the sharp direction (Ramos, section 1.5, figure 22;
//! Cook, Porter and Carpenter, "Distributed ray tracing", 1984).

use super::Meeting;
use super::follow::Bounce;
use crate::log::{Decision, Name, Step, Term};
use crate::probe::Probe;
use crate::random::{Dimension, Splits, warp};
use crate::scene::light_surface::least_axis;
use crate::scene::square::place_in_square;
use crate::scene::{Color, Scene};
use glam::DVec3;

/// The lobe cosⁿ about a direction.
pub(super) struct Lobe {
    /// Which bounce is blurred.
    pub what: Term,
    /// The sharp direction.
    pub middle: DVec3,
    /// The exponent n.
    pub exponent: f64,
}

/// The mean over the zones of the lobe, which are equally likely: one ray in each, in a random direction. Directions on the wrong side
/// of the surface are rejected, and the mean is over the others; black if there are none.
// Kept out of the way of sharp bounces.
#[inline(never)]
pub(super) fn mean<P: Probe>(scene: &Scene, meeting: &Meeting, lobe: &Lobe, bounce: &Bounce, probe: &mut P) -> Color {
    let zones = meeting.material.zones;
    let route = meeting.path.route();
    let dimension = match lobe.what {
        Term::Transmitted => Dimension::Transmission { route },
        _ => Dimension::Reflection { route },
    };
    let splits = Splits::new(meeting.path.draws, dimension, zones);
    let axes = axes(lobe, probe);
    let mut sum: Option<Color> = None;
    let mut kept = 0;
    for part in 0..zones {
        let split = if zones == 1 { 0 } else { part + 1 };
        let color = probe.within(Step::Zone { what: lobe.what, number: part + 1 }, |probe| {
            let square = place_in_square(splits.pick(part), probe);
            let direction = direction(meeting, lobe, &axes, square, probe)?;
            Some(bounce.follow(scene, meeting, direction, split, probe))
        });
        let Some(color) = color else { continue };
        kept += 1;
        probe.given(Name::LobeColor, color);
        sum = Some(match sum {
            None => probe.note(Name::LobeSumFirst, color),
            Some(sum) => probe.note(Name::LobeSum, sum + color),
        });
    }
    let Some(sum) = sum else { return Color::ZERO };
    probe.given(Name::LobeKept, f64::from(kept));
    probe.note(Name::LobeMean, sum / f64::from(kept))
}

/// Two axes across the lobe.
fn axes<P: Probe>(lobe: &Lobe, probe: &mut P) -> [DVec3; 2] {
    let helper = least_axis(lobe.middle);
    probe.given(Name::LobeMiddle, lobe.middle);
    probe.given(Name::LobeHelper, helper);
    let across = lobe.middle.cross(helper);
    let across = probe.note(Name::LobeAxis1, across / across.dot(across).sqrt());
    [across, probe.note(Name::LobeAxis2, lobe.middle.cross(across))]
}

/// The direction for a point of the unit square; `None`, marked, if it lies on the wrong side of the surface.
fn direction<P: Probe>(
    meeting: &Meeting,
    lobe: &Lobe,
    axes: &[DVec3; 2],
    square: [f64; 2],
    probe: &mut P,
) -> Option<DVec3> {
    probe.given(Name::LobeExponent, lobe.exponent);
    let [x, y, z] = warp::lobe(lobe.exponent, square);
    let x = probe.note(Name::LobeX, x);
    let y = probe.note(Name::LobeY, y);
    let z = probe.note(Name::LobeZ, z);
    let direction = probe.note(Name::LobeDirection, axes[0] * x + axes[1] * y + lobe.middle * z);
    let name = if meeting.surface.beneath.is_some() { Name::LobeHeightGeometric } else { Name::LobeHeight };
    let height = probe.note(name, probe.dot(meeting.surface.geometric_normal(), direction));
    let is_wrong = if lobe.what == Term::Transmitted { height > 0.0 } else { height < 0.0 };
    if is_wrong {
        probe.mark(Decision::Rejected { what: lobe.what });
        return None;
    }
    Some(direction)
}
