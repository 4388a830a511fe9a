//! Lines cut to what is seen of them.

use super::Point;

/// The part of a line inside a rectangle (Liang and Barsky, 1984).
pub fn clip([from, to]: [Point; 2], x: [f64; 2], y: [f64; 2]) -> Option<[Point; 2]> {
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (axis, [low, high]) in [x, y].into_iter().enumerate() {
        let along = to[axis] - from[axis];
        if along == 0.0 {
            if !(low..=high).contains(&from[axis]) {
                return None;
            }
            continue;
        }
        let [one, other] = [low, high].map(|side| (side - from[axis]) / along);
        enters = enters.max(one.min(other));
        leaves = leaves.min(one.max(other));
    }
    let at = |part: f64| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
    (enters <= leaves).then(|| [at(enters), at(leaves)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn clips(line: [[f64; 2]; 2], expected: Option<[[f64; 2]; 2]>) {
        assert_eq!(clip(line, [0.0, 4.0], [0.0, 2.0]), expected, "{line:?}");
    }

    #[test]
    fn lines_are_clipped_at_all_sides() {
        clips([[1.0, 1.0], [3.0, 2.0]], Some([[1.0, 1.0], [3.0, 2.0]]));
        clips([[2.0, 1.0], [6.0, 1.0]], Some([[2.0, 1.0], [4.0, 1.0]]));
        clips([[6.0, 1.0], [-2.0, 1.0]], Some([[4.0, 1.0], [0.0, 1.0]]));
        clips([[1.0, -1.0], [1.0, 5.0]], Some([[1.0, 0.0], [1.0, 2.0]]));
        clips([[-1.0, 1.0], [1.0, 3.0]], Some([[0.0, 2.0], [0.0, 2.0]]));
        clips([[-2.0, 1.0], [1.0, 4.0]], None);
        clips([[5.0, 1.0], [9.0, 1.0]], None);
        clips([[1.0, 3.0], [2.0, 3.0]], None);
    }
}
