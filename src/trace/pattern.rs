//! What a pattern makes of the surface's coefficients.

use super::Meeting;
use crate::geometry::Shape;
use crate::geometry::motion::Pose;
use crate::log::{Decision, Name};
use crate::probe::{Probe, Silent};
use crate::scene::{Checker, Color, Material, Scene};
use glam::DVec3;

/// The material as the pattern leaves it at this point.
pub(super) fn material<P: Probe>(scene: &Scene, meeting: &Meeting, pattern: &Checker, probe: &mut P) -> Material {
    let plain = meeting.material;
    let color = color(scene, meeting, pattern, probe);
    probe.given(Name::MaterialAmbientPlain, plain.ambient);
    let ambient = probe.note(Name::MaterialAmbientPatterned, plain.ambient * color);
    probe.given(Name::MaterialDiffusePlain, plain.diffuse);
    let diffuse = probe.note(Name::MaterialDiffusePatterned, plain.diffuse * color);
    Material { ambient, diffuse, ..plain.clone() }
}

/// From here on adjacent numbers differ by more than one, so that none of them is odd.
const LAST_CELL: f64 = 9_007_199_254_740_992.0;

/// The colour of the checkerboard: that of the even cubes, also where the numbers can't tell one cube from the next.
fn color<P: Probe>(scene: &Scene, meeting: &Meeting, checker: &Checker, probe: &mut P) -> Color {
    let axes = axes(scene, meeting);
    probe.given(Name::PatternAxes, axes);
    let moving = own_point(scene, meeting, probe);
    let cell = (moving.unwrap_or(meeting.surface.point) / checker.size).floor();
    let is_countable = cell.is_finite() && (cell * axes).abs().max_element() <= LAST_CELL;
    probe.given(Name::PatternSize, checker.size);
    let is_odd = if is_countable {
        let name = if moving.is_some() { Name::PatternCellMoving } else { Name::PatternCell };
        let cell = probe.note(name, cell);
        let sum = probe.note(Name::PatternSum, probe.dot(axes, cell));
        probe.note(Name::PatternParity, sum - 2.0 * (sum / 2.0).floor()) != 0.0
    } else {
        probe.mark(Decision::Undefined { quantity: Name::PatternCell });
        false
    };
    if is_odd {
        probe.given(Name::PatternB, checker.b);
        probe.note(Name::PatternColorOdd, checker.b)
    } else {
        probe.given(Name::PatternA, checker.a);
        probe.note(Name::PatternColorEven, checker.a)
    }
}

/// Where a moving object is; it takes its pattern along.
fn pose<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Option<Pose> {
    match &scene.objects[meeting.layer.object as usize].shape {
        Shape::Moving(moving) => Some(moving.at(meeting.ray.time, probe)),
        _ => None,
    }
}

/// The point of a moving object where its pattern was made.
fn own_point<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Option<DVec3> {
    let pose = pose(scene, meeting, probe)?;
    Some(pose.own_point(meeting.surface.point, probe))
}

/// 1 on the axes along which cubes are counted. On a flat surface the one nearest to its normal is left out, of equals the
/// first: such a surface often lies exactly between two layers of cubes, where rounding would mix their colours.
fn axes(scene: &Scene, meeting: &Meeting) -> DVec3 {
    if !scene.objects[meeting.layer.object as usize].shape.is_flat(meeting.layer.primitive) {
        return DVec3::ONE;
    }
    let normal = meeting.surface.geometric_normal();
    let normal = pose(scene, meeting, &mut Silent).map_or(normal, |pose| pose.own_direction(normal)).abs();
    if normal.x >= normal.y && normal.x >= normal.z {
        DVec3::new(0.0, 1.0, 1.0)
    } else if normal.y >= normal.z {
        DVec3::new(1.0, 0.0, 1.0)
    } else {
        DVec3::new(1.0, 1.0, 0.0)
    }
}
