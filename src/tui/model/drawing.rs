//! The scene as lines, for the schematic, and from where it is looked at.

use crate::report::language::Language;
pub use crate::report::schematic::Wireframe;
use std::fmt;
use std::sync::Arc;

/// The scene as lines in space.
#[derive(Clone)]
pub struct Drawing {
    /// The objects.
    pub objects: Vec<Wireframe>,
    /// The lights; one at a place is a line of one point.
    pub lights: Vec<Wireframe>,
    /// The eye.
    pub eye: [f64; 3],
    /// The place of a point in the picture, in pixels from the top left corner; `None` behind the eye.
    pub place_of: PlaceOf,
    /// Columns and rows of the picture.
    pub size: [u32; 2],
}

/// From a point to its place in the picture.
pub type PlaceOf = Arc<dyn Fn([f64; 3]) -> Option<[f64; 2]> + Send + Sync>;

/// From where the schematic is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// From above: x to the right, z toward the one who looks.
    Top,
    /// From the front, where z comes from: x to the right, y up.
    Front,
    /// From the right, where x goes: z to the left, y up.
    Side,
    /// From the eye, as the picture.
    Camera,
}

impl fmt::Debug for Drawing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Drawing of {} objects and {} lights", self.objects.len(), self.lights.len())
    }
}

impl Projection {
    /// What the schematic is called that is seen so.
    pub fn title(self, language: Language) -> &'static str {
        language.texts().viewer.panes.schematic.views[self as usize]
    }

    /// The next one.
    pub fn next(self) -> Projection {
        match self {
            Projection::Top => Projection::Front,
            Projection::Front => Projection::Side,
            Projection::Side => Projection::Camera,
            Projection::Camera => Projection::Top,
        }
    }

    /// The one from which these points spread most: over the largest area, of equal ones the first.
    pub fn widest(points: &[[f64; 3]]) -> Projection {
        let area = |side: Projection| {
            let places = points.iter().filter_map(|point| side.of(None, *point)).collect();
            if points.is_empty() { 0.0 } else { hull_area(places) }
        };
        let (top, front, side) = (area(Projection::Top), area(Projection::Front), area(Projection::Side));
        // Rounding alone turns nothing.
        let is_more = |one: f64, other: f64| one > other * (1.0 + 1e-9);
        match (is_more(front, top), is_more(side, top.max(front))) {
            (_, true) => Projection::Side,
            (true, false) => Projection::Front,
            (false, false) => Projection::Top,
        }
    }

    /// The projection with this word in commands.
    pub fn called(word: &str) -> Option<Projection> {
        Projection::ALL.into_iter().zip(Projection::WORDS).find(|(_, known)| *known == word).map(|(side, _)| side)
    }

    /// Every projection, in the order in which they follow each other.
    pub const ALL: [Projection; 4] = [Projection::Top, Projection::Front, Projection::Side, Projection::Camera];

    /// What they are called in commands.
    pub const WORDS: [&'static str; 4] = ["top", "front", "side", "eye"];

    /// Where a point is drawn, x to the right and y up; `None` where it can't be seen. Without a scene nobody knows the eye.
    pub fn of(self, drawing: Option<&Drawing>, [x, y, z]: [f64; 3]) -> Option<[f64; 2]> {
        let place = match self {
            Projection::Top => [x, -z],
            Projection::Front => [x, y],
            Projection::Side => [-z, y],
            Projection::Camera => (drawing?.place_of)([x, y, z]).map(|[column, row]| [column, -row])?,
        };
        place.iter().all(|number| number.is_finite()).then_some(place)
    }
}

/// The part of a line that can be seen from here, from one end to the other. What can't is on one side of a plane, that of the eye.
pub fn seen_part(of: impl Fn([f64; 3]) -> Option<[f64; 2]>, from: [f64; 3], to: [f64; 3]) -> Option<[[f64; 2]; 2]> {
    /// Halvings of the line, until the place where it comes into view is known; nearer to the eye rounding would be seen.
    const STEPS: u32 = 24;
    let at = |part: f64| of(std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * part));
    let from_view = |seen: f64, hidden: f64| {
        let halved = (0..STEPS).fold((seen, hidden), |(seen, hidden), _| {
            let middle = (seen + hidden) / 2.0;
            if at(middle).is_some() { (middle, hidden) } else { (seen, middle) }
        });
        at(halved.0)
    };
    match (at(0.0), at(1.0)) {
        (Some(begin), Some(end)) => Some([begin, end]),
        (Some(begin), None) => Some([begin, from_view(0.0, 1.0)?]),
        (None, Some(end)) => Some([from_view(1.0, 0.0)?, end]),
        (None, None) => None,
    }
}

/// The area of the smallest convex region around places (Andrew's chains).
fn hull_area(mut places: Vec<[f64; 2]>) -> f64 {
    let turn = |[a, b, c]: [[f64; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let chain = |places: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for place in places {
            while let [.., a, b] = chain[..]
                && turn([a, b, place]) <= 0.0
            {
                chain.pop();
            }
            chain.push(place);
        }
        chain
    };
    let hull = [chain(&mut places.iter().copied()), chain(&mut places.iter().rev().copied())].concat();
    let Some(first) = hull.first().copied() else { return 0.0 };
    let area: f64 = hull.windows(2).map(|ends| turn([first, ends[0], ends[1]])).sum();
    if area.is_finite() { area / 2.0 } else { f64::MAX }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_area_is_that_of_the_hull() {
        assert_eq!(hull_area(vec![[0.0, 0.0], [4.0, 3.0], [4.0, 0.0], [0.0, 3.0], [1.0, 1.0], [2.0, 0.0]]), 12.0);
        assert_eq!(hull_area(vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]), 6.0);
        assert_eq!(hull_area(vec![[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]]), 0.0);
        assert_eq!((hull_area(vec![]), hull_area(vec![[1.0, 2.0]])), (0.0, 0.0));
    }

    #[test]
    fn the_side_is_the_one_from_which_points_spread_most() {
        let plane = |axes: [usize; 2]| {
            let point = |x: f64, y: f64| {
                std::array::from_fn(|axis| [x, y, 0.0][axes.iter().position(|a| *a == axis).unwrap_or(2)])
            };
            Projection::widest(&[point(0.0, 0.0), point(5.0, 1.0), point(2.0, 3.0)])
        };
        assert_eq!(
            [plane([0, 2]), plane([0, 1]), plane([2, 1])],
            [Projection::Top, Projection::Front, Projection::Side]
        );
        // In the plane x = z, from above and from the front: as wide, and a line from one of them.
        assert_eq!(Projection::widest(&[[0.0; 3], [3.0, 1.0, 3.0], [1.0, 2.0, 1.0]]), Projection::Front);
        // A line says nothing, nor do no points.
        assert_eq!(Projection::widest(&[[0.0; 3], [0.0, 0.0, 9.0]]), Projection::Top);
        assert_eq!(Projection::widest(&[]), Projection::Top);
    }

    #[test]
    fn what_is_behind_the_eye_is_cut_off() {
        // The eye looks along z from 0.
        let of = |[x, y, z]: [f64; 3]| (z > 0.0).then(|| [x / z, y / z]);
        assert_eq!(seen_part(of, [1.0, 0.0, 1.0], [1.0, 0.0, 2.0]), Some([[1.0, 0.0], [0.5, 0.0]]));
        assert_eq!(seen_part(of, [1.0, 0.0, -1.0], [1.0, 0.0, -2.0]), None);
        for ends in [[[1.0, 0.0, -1.0], [1.0, 0.0, 2.0]], [[1.0, 0.0, 2.0], [1.0, 0.0, -1.0]]] {
            let [begin, end] = seen_part(of, ends[0], ends[1]).expect("a part of the line");
            let (near, far) = (begin[0].max(end[0]), begin[0].min(end[0]));
            assert!(near > 1e6 && far == 0.5, "{begin:?} {end:?}");
        }
    }
}
