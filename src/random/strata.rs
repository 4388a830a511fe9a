//! Near-square strata: any number of parts of the unit square, all of the same area.

/// A part of the unit square.
///
/// N parts lie in √N rows, rounded; a row of c parts is c/N high and each part is 1/c wide, so that all have the same area
/// whatever N is (Cook, Porter and Carpenter, "Distributed ray tracing", 1984, have the square grid).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stratum {
    /// Its number in its row, from the left.
    pub column: u32,
    /// How many there are in its row.
    pub across: u32,
    /// How many there are in the rows above.
    pub above: u32,
    /// How many there are in all.
    pub count: u32,
}

impl Stratum {
    /// The whole square.
    pub const WHOLE: Stratum = Stratum { column: 0, across: 1, above: 0, count: 1 };

    /// The n-th of `count` parts, from 0, row by row.
    pub fn of(number: u32, count: u32) -> Stratum {
        let rows = rows(count);
        // The rows share the parts as evenly as can be: row r ends where ⌊(r + 1)·count/rows⌋ parts do.
        let start = |row: u64| (row * u64::from(count) / u64::from(rows)) as u32;
        let guess = u64::from(number) * u64::from(rows) / u64::from(count);
        let row = if start(guess + 1) <= number { guess + 1 } else { guess };
        let above = start(row);
        Stratum { column: number - above, across: start(row + 1) - above, above, count }
    }

    /// The place in the square that lies so far, from 0 to 1, across and down the part.
    pub fn at(&self, [across, down]: [f64; 2]) -> [f64; 2] {
        let x = (f64::from(self.column) + across) / f64::from(self.across);
        let y = (f64::from(self.above) + down * f64::from(self.across)) / f64::from(self.count);
        [x, y]
    }
}

/// √count, rounded.
fn rows(count: u32) -> u32 {
    (libm::sqrt(f64::from(count)) + 0.5) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strata_cover_the_square_and_have_the_same_area() {
        for count in (1..200).chain([1000, 1023, 4099]) {
            let mut bottom = 0.0;
            let mut area = 0.0;
            let mut number = 0;
            while number < count {
                let first = Stratum::of(number, count);
                assert_eq!((first.column, first.above), (0, number), "{number} of {count}");
                for column in 0..first.across {
                    assert_eq!(Stratum::of(number + column, count), Stratum { column, ..first });
                    let ([left, top], [right, lower]) =
                        (Stratum { column, ..first }.at([0.0, 0.0]), Stratum { column, ..first }.at([1.0, 1.0]));
                    assert!((top - bottom).abs() < 1e-15);
                    let own = (right - left) * (lower - top);
                    assert!((own * f64::from(count) - 1.0).abs() < 1e-9);
                    let ratio = (right - left) / (lower - top);
                    // Three parts can't be nearer to squares.
                    assert!(
                        (0.49..=if count == 3 { 3.01 } else { 2.01 }).contains(&ratio),
                        "{number} of {count}: {ratio}"
                    );
                    area += own;
                }
                bottom = first.at([0.0, 1.0])[1];
                number += first.across;
            }
            assert!((area - 1.0).abs() < 1e-9 && bottom == 1.0, "{count}");
        }
    }

    #[test]
    fn a_square_number_makes_a_square_grid() {
        assert_eq!(Stratum::of(7, 16), Stratum { column: 3, across: 4, above: 4, count: 16 });
        assert_eq!(Stratum::of(7, 16).at([0.5, 0.5]), [0.875, 0.375]);
    }
}
