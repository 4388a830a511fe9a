//! The outline of an object in the picture: a convex polygon around the places of its corners.

use std::sync::Arc;

/// A rectangle of the picture in pixels: left, top, right, bottom.
pub type Rectangle = [f64; 4];

/// A convex polygon in the picture, in pixels; of two corners or one where all places lie in a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// In their order around it. Cells of many tiles and pixels look at the same.
    corners: Arc<[[f64; 2]]>,
    /// The least distance between two parallel lines that hold it between them.
    width: f64,
}

impl Outline {
    /// The convex hull of some places: its lower and its upper side from left to right (Andrew, "Another efficient algorithm for
    /// convex hulls in two dimensions", 1979).
    pub fn around(mut places: Vec<[f64; 2]>) -> Outline {
        places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        places.dedup();
        let mut corners = half(places.iter());
        corners.extend(half(places.iter().rev()));
        if corners.is_empty() {
            corners = places;
        }
        let extent = |normal: [f64; 2]| {
            let [least, most] = range(&corners, normal);
            most - least
        };
        // The narrowest strip has an edge of the polygon in one of its sides.
        let width = normals(&corners).map(extent).fold(f64::INFINITY, f64::min);
        let width = if corners.len() < 3 { 0.0 } else { width };
        Outline { corners: corners.into(), width }
    }

    /// The same around a figure of which the width is known.
    pub fn with_width(self, width: f64) -> Outline {
        Outline { width, ..self }
    }

    /// The least distance, in pixels, between two parallel lines that hold it between them.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Whether it and another one have something in common.
    pub fn overlaps(&self, other: &Outline) -> bool {
        let corners = [&self.corners, &other.corners];
        corners.iter().flat_map(|corners| normals(corners)).all(|normal| {
            let [[least, most], [from, to]] = corners.map(|corners| range(corners, normal));
            least <= to && from <= most
        })
    }

    /// Whether it and a rectangle have something in common: no direction of an edge of either separates them.
    pub fn reaches_into(&self, [left, top, right, bottom]: Rectangle) -> bool {
        let rectangle = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let overlaps = |normal: [f64; 2]| {
            let ([least, most], [from, to]) = (range(&self.corners, normal), range(&rectangle, normal));
            least < to && from < most
        };
        overlaps([1.0, 0.0])
            && overlaps([0.0, 1.0])
            && normals(&self.corners).all(|normal| {
                let ([least, most], [from, to]) = (range(&self.corners, normal), range(&rectangle, normal));
                least <= to && from <= most
            })
    }
}

/// The corners on one side of the hull of sorted places, but for the last, which begins the other side.
fn half<'p>(places: impl Iterator<Item = &'p [f64; 2]>) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for place in places {
        while let [.., a, b] = kept[..]
            && turn(a, b, *place) <= 0.0
        {
            kept.pop();
        }
        kept.push(*place);
    }
    kept.pop();
    kept
}

/// Positive where the way a, b, c turns to the left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Unit vectors across the edges.
fn normals(corners: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    let edges = (0..corners.len()).map(|k| (corners[k], corners[(k + 1) % corners.len()]));
    let normal = |([x, y], [to_x, to_y]): ([f64; 2], [f64; 2])| {
        let length = libm::hypot(to_x - x, to_y - y);
        (length > 0.0).then(|| [(to_y - y) / length, (x - to_x) / length])
    };
    edges.filter_map(normal)
}

/// The least and the greatest component of places in a direction.
fn range(places: &[[f64; 2]], [x, y]: [f64; 2]) -> [f64; 2] {
    let along = places.iter().map(|place| place[0] * x + place[1] * y);
    along.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], along| [least.min(along), most.max(along)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_width_is_the_least_of_all_directions() {
        let rectangle = [[0.0, 0.0], [4.0, 3.0], [3.4, 3.8], [-0.6, 0.8], [2.0, 2.0]];
        assert!((Outline::around(rectangle.to_vec()).width() - 1.0).abs() < 1e-14);
        let triangle = [[0.0, 0.0], [4.0, 0.0], [1.0, 2.0]];
        assert!((Outline::around(triangle.to_vec()).width() - 2.0).abs() < 1e-14);
        assert_eq!(Outline::around(vec![[1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]).width(), 0.0);
        assert_eq!(Outline::around(vec![[1.0, 1.0], [1.0, 1.0]]).width(), 0.0);
    }

    /// A slanted needle reaches into the cells along its diagonal and into none beside it.
    #[test]
    fn a_needle_reaches_into_the_cells_on_its_way() {
        for needle in [vec![[0.1, 0.1], [3.9, 3.9]], vec![[0.05, 0.1], [0.1, 0.05], [3.9, 3.95], [3.95, 3.9]]] {
            let needle = Outline::around(needle);
            for (column, row) in (0..4).flat_map(|row| (0..4).map(move |column| (column, row))) {
                let [left, top] = [f64::from(column), f64::from(row)];
                // Its flanks pass through the cells that have a corner in common with its own.
                let is_near = needle.reaches_into([left + 0.1, top + 0.1, left + 0.9, top + 0.9]);
                assert_eq!(is_near, column == row, "{column}, {row}");
            }
        }
        let point = Outline::around(vec![[1.5, 1.5]]);
        assert!(point.reaches_into([1.0, 1.0, 2.0, 2.0]) && !point.reaches_into([2.0, 1.0, 3.0, 2.0]));
    }
}
