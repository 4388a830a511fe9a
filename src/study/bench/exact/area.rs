//! How much of a square a polygon or an ellipse covers, exactly up to rounding.

use crate::sampling::ellipse::Ellipse;

/// The area of a polygon that doesn't cross itself in the unit square with this top left corner.
///
/// The square cuts off a side at a time (Sutherland and Hodgman, "Reentrant polygon clipping", 1974). What it leaves of a concave polygon may be joined by edges
/// that run to and fro, which have no area.
pub fn of_polygon(corners: &[[f64; 2]], [left, top]: [f64; 2]) -> f64 {
    let at_origin = corners.iter().map(|[x, y]| [x - left, y - top]).collect();
    let sides: [fn([f64; 2]) -> f64; 4] = [|[x, _]| x, |[x, _]| 1.0 - x, |[_, y]| y, |[_, y]| 1.0 - y];
    let kept = sides.into_iter().fold(at_origin, |kept: Vec<_>, inside| clipped(&kept, inside));
    shoelace(&kept).abs()
}

/// The part of a polygon where `inside` isn't negative.
fn clipped(corners: &[[f64; 2]], inside: fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    for [from, to] in edges(corners) {
        let (a, b) = (inside(from), inside(to));
        if a >= 0.0 {
            kept.push(from);
        }
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            let part = a / (a - b);
            kept.push([from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]);
        }
    }
    kept
}

/// The edges around a polygon, in a plane or in space.
pub(super) fn edges<P: Copy>(corners: &[P]) -> impl Iterator<Item = [P; 2]> + '_ {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(from, to)| [*from, *to])
}

/// The area inside a polygon, positive or negative by the way in which it runs.
fn shoelace(corners: &[[f64; 2]]) -> f64 {
    edges(corners).map(|[from, to]| cross(from, to)).sum::<f64>() / 2.0
}

fn cross([x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> f64 {
    x * to_y - y * to_x
}

/// The area of an ellipse in the unit square with this top left corner: that of the unit disc in the parallelogram which the square becomes
/// where the ellipse is a circle, as a part of the disc's.
pub fn of_ellipse(ellipse: &Ellipse, [left, top]: [f64; 2]) -> f64 {
    let square = [[left, top], [left + 1.0, top], [left + 1.0, top + 1.0], [left, top + 1.0]];
    let corners = square.map(|corner| ellipse.circled(corner));
    let in_disc: f64 = edges(&corners).map(|[from, to]| swept(from, to)).sum();
    (in_disc / std::f64::consts::PI).abs() * ellipse.area()
}

/// The area of the unit disc that the way from the centre to a point sweeps over while the point runs along an edge: a triangle where
/// the edge runs inside, a sector where it doesn't.
fn swept(from: [f64; 2], to: [f64; 2]) -> f64 {
    let way = [to[0] - from[0], to[1] - from[1]];
    let along = |part: f64| [from[0] + way[0] * part, from[1] + way[1] * part];
    let square = way[0] * way[0] + way[1] * way[1];
    // The foot of the perpendicular from the centre, and how far from there the edge's line leaves the disc.
    let foot = -(from[0] * way[0] + from[1] * way[1]) / square;
    let distance = cross(from, to) / square.sqrt();
    let half = ((1.0 - distance * distance) / square).sqrt();
    let sector = |from, to| {
        let dot = |[x, y]: [f64; 2], [to_x, to_y]: [f64; 2]| x * to_x + y * to_y;
        libm::atan2(cross(from, to), dot(from, to)) / 2.0
    };
    // Where the line passes outside, half is no number.
    if half.is_nan() || half == 0.0 {
        return sector(from, to);
    }
    let (enters, leaves) = ((foot - half).clamp(0.0, 1.0), (foot + half).clamp(0.0, 1.0));
    let (at_entry, at_exit) = (along(enters), along(leaves));
    sector(from, at_entry) + cross(at_entry, at_exit) / 2.0 + sector(at_exit, to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_by_hand() {
        let half = [[-3.0, -3.0], [5.0, -3.0], [5.0, 5.0]];
        assert_eq!(of_polygon(&half, [0.0, 0.0]), 0.5);
        assert_eq!((of_polygon(&half, [1.0, 0.0]), of_polygon(&half, [0.0, 1.0])), (1.0, 0.0));
        // A comb of which two teeth reach into the square, clockwise and counter-clockwise.
        let mut comb = vec![
            [-1.0, 1.5],
            [0.2, 1.5],
            [0.2, 0.5],
            [0.3, 0.5],
            [0.3, 1.5],
            [0.6, 1.5],
            [0.6, 0.25],
            [0.8, 0.25],
            [0.8, 2.0],
        ];
        comb.push([-1.0, 2.0]);
        for _ in 0..2 {
            assert!((of_polygon(&comb, [0.0, 0.0]) - (0.1 * 0.5 + 0.2 * 0.75)).abs() < 1e-15);
            comb.reverse();
        }
    }
}
