//! Where texts in a figure are: none lies on another, and those that may move lie on no ray.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// The texts of a figure, and what is drawn under them.
pub(super) struct Labels {
    area: Rect,
    /// Of each cell whether a text has it, and whether a ray runs through it.
    has_text: Vec<bool>,
    has_ray: Vec<bool>,
}

/// How far from its place a text may be, in columns and rows.
pub(super) type Reach = [i32; 2];

/// A letter whose colour says what it belongs to.
pub(super) const FAR: Reach = [12, 4];

/// A name, which belongs to what is beside it.
pub(super) const CLOSE: Reach = [4, 2];

impl Labels {
    pub(super) fn new(area: Rect) -> Labels {
        let cells = usize::from(area.width) * usize::from(area.height);
        Labels { area, has_text: vec![false; cells], has_ray: vec![false; cells] }
    }

    /// Keeps texts away from a line from one place to another, in columns and rows of the area.
    pub(super) fn avoid_line(&mut self, [from, to]: [[f64; 2]; 2]) {
        let along = [to[0] - from[0], to[1] - from[1]];
        // Half a cell at a time, so that none is missed where the line has more than a corner of it.
        let steps = (2.0 * along[0].abs().max(along[1].abs())).ceil().clamp(1.0, 4000.0) as u32;
        for step in 0..=steps {
            let part = f64::from(step) / f64::from(steps);
            self.avoid([0, 1].map(|axis| (from[axis] + along[axis] * part).floor() as i32));
        }
    }

    /// Keeps texts away from what is drawn here.
    pub(super) fn avoid_drawn(&mut self, buffer: &Buffer) {
        for position in self.area.intersection(buffer.area).positions() {
            if buffer.cell(position).is_some_and(|cell| cell.symbol() != " ") {
                self.avoid([i32::from(position.x - self.area.x), i32::from(position.y - self.area.y)]);
            }
        }
    }

    fn avoid(&mut self, cell: [i32; 2]) {
        if let Some(index) = self.index(cell) {
            self.has_ray[index] = true;
        }
    }

    /// The area of a text that begins in this very cell, if it fits and no other has it.
    pub(super) fn at(&mut self, [column, row]: [f64; 2], width: usize) -> Option<Rect> {
        let [column, row] = [column, row].map(|place| place.floor() as i32);
        self.is_free([column, row], width as i32, false).then(|| self.take([column, row], width))
    }

    /// The area of a text as near to a place as there is room beside texts and rays, rather toward a direction.
    pub(super) fn near(&mut self, [x, y]: [f64; 2], toward: [f64; 2], width: usize, reach: Reach) -> Option<Rect> {
        if !(x.is_finite() && y.is_finite()) || width > usize::from(self.area.width) {
            return None;
        }
        let length = libm::hypot(toward[0], 2.0 * toward[1]);
        let [right, down] = if length > 0.0 { [toward[0] / length, 2.0 * toward[1] / length] } else { [0.0, 0.0] };
        let wide = width as i32;
        let [first, row] = [x, y].map(|place| place.floor().clamp(-1e6, 1e6) as i32);
        let columns = first - reach[0] - wide + 1..=first + reach[0];
        let rows = row - reach[1]..=row + reach[1];
        let cells = rows.flat_map(|row| columns.clone().map(move |column| [column, row]));
        let places = cells.filter(|cell| self.is_free(*cell, wide, true)).map(|[column, row]| {
            // The nearest of its own cells counts, and a row is as far as two columns.
            let nearest = (x - 0.5).clamp(f64::from(column), f64::from(column + wide - 1));
            let away = [nearest - (x - 0.5), 2.0 * (f64::from(row) + 0.5 - y)];
            let middle = f64::from(column) + f64::from(wide - 1) / 2.0 - (x - 0.5);
            let ahead = (middle * right + away[1] * down) / (middle.abs() + away[1].abs()).max(1.0);
            (libm::hypot(away[0], away[1]) + 0.05 * middle.abs() - 1.5 * ahead, [column, row])
        });
        let (_, cell) = places.min_by(|(one, _), (other, _)| one.total_cmp(other))?;
        Some(self.take(cell, width))
    }

    fn index(&self, [column, row]: [i32; 2]) -> Option<usize> {
        let is_inside =
            (0..i32::from(self.area.width)).contains(&column) && (0..i32::from(self.area.height)).contains(&row);
        is_inside.then(|| row as usize * usize::from(self.area.width) + column as usize)
    }

    /// Whether a text has room here: no other touches it at its sides.
    fn is_free(&self, [column, row]: [i32; 2], width: i32, avoids_rays: bool) -> bool {
        let is_empty = |column: i32| self.index([column, row]).is_none_or(|index| !self.has_text[index]);
        let fits = |column: i32| {
            self.index([column, row]).is_some_and(|index| !(self.has_text[index] || avoids_rays && self.has_ray[index]))
        };
        let touches = width > 1 && !(is_empty(column - 1) && is_empty(column + width));
        width > 0 && !touches && (column..column + width).all(fits)
    }

    fn take(&mut self, [column, row]: [i32; 2], width: usize) -> Rect {
        for column in column..column + width as i32 {
            if let Some(index) = self.index([column, row]) {
                self.has_text[index] = true;
            }
        }
        Rect { x: self.area.x + column as u16, y: self.area.y + row as u16, width: width as u16, height: 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_text_moves_to_the_side_that_is_asked_for() {
        let place = |toward| Labels::new(Rect::new(5, 7, 20, 9)).near([10.5, 4.5], toward, 1, FAR);
        assert_eq!(place([1.0, 0.0]), Some(Rect::new(16, 11, 1, 1)));
        assert_eq!(place([-1.0, 0.0]), Some(Rect::new(14, 11, 1, 1)));
        assert_eq!(place([0.0, 0.0]), Some(Rect::new(15, 11, 1, 1)));
    }

    #[test]
    fn texts_keep_away_from_rays_and_need_room() {
        let mut labels = Labels::new(Rect::new(0, 0, 6, 2));
        labels.avoid_line([[0.0, 0.5], [6.0, 0.5]]);
        assert_eq!(labels.near([2.5, 0.5], [0.0, 0.0], 2, CLOSE).map(|area| area.y), Some(1));
        assert_eq!(labels.near([2.5, 0.5], [0.0, 0.0], 5, FAR), None);
        assert_eq!(labels.near([f64::NAN, 0.5], [0.0, 0.0], 1, FAR), None);
        // The letter of a ray lies on it.
        assert_eq!(labels.at([3.7, 0.2], 1), Some(Rect::new(3, 0, 1, 1)));
        assert_eq!(labels.at([3.2, 0.9], 1), None);
        assert_eq!(labels.at([6.0, 0.9], 1), None);
    }

    proptest! {
        #[test]
        fn no_text_lies_on_another_or_outside(
            size in (0_u16..50, 0_u16..20),
            lines in prop::collection::vec([-10.0_f64..60.0, -10.0..30.0, -10.0..60.0, -10.0..30.0], 0..6),
            texts in prop::collection::vec((-10.0_f64..60.0, -10.0_f64..30.0, 0_usize..12, -1.0_f64..1.0, any::<bool>()), 0..30),
        ) {
            let area = Rect::new(3, 2, size.0, size.1);
            let mut labels = Labels::new(area);
            lines.iter().for_each(|[x, y, u, v]| labels.avoid_line([[*x, *y], [*u, *v]]));
            let mut placed: Vec<Rect> = Vec::new();
            for (x, y, width, toward, may_move) in texts {
                let found = if may_move { labels.near([x, y], [toward, 0.3], width, FAR) } else { labels.at([x, y], width) };
                if let Some(found) = found {
                    prop_assert_eq!(area.intersection(found), found);
                    prop_assert!(placed.iter().all(|other| other.intersection(found).is_empty()));
                    placed.push(found);
                }
            }
        }
    }
}
