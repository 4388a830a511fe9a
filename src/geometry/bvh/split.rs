//! Cutting a part of the primitives in two, where the surface area heuristic says so.

use super::block::{BLOCK, Kind};
use super::node::Box32;
use glam::Vec4;
use rayon::prelude::*;
use std::ops::Range;

/// In how many slices an axis is cut.
const BINS: usize = 16;

/// How many primitives are looked at by one core at a time.
const CHUNK: usize = 1 << 14;

/// A primitive as the builder sees it.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct Rough {
    /// Its box, with the bits of its number and of its kind for fourth components.
    around: Extent,
}

impl Rough {
    /// Of a primitive with a number less than 2³⁰, in this box.
    pub fn new(primitive: u32, kind: Kind, around: &Box32) -> Rough {
        let corner = |[x, y, z]: [f32; 3], w: u32| Vec4::new(x, y, z, f32::from_bits(NORMAL | w));
        Rough { around: Extent { min: corner(around.min, primitive), max: corner(around.max, kind as u32) } }
    }

    pub fn primitive(&self) -> u32 {
        self.around.min.w.to_bits() & !NORMAL
    }

    #[inline(always)]
    pub fn kind(&self) -> Kind {
        match self.around.max.w.to_bits() & !NORMAL {
            0 => Kind::Triangle,
            1 => Kind::Sphere,
            _ => Kind::Other,
        }
    }

    /// Twice the centre.
    #[inline(always)]
    fn center(&self) -> Vec4 {
        self.around.min + self.around.max
    }
}

/// With this bit a whole number less than 2³⁰ has the bits of a number of single precision that isn't subnormal: those are slow.
const NORMAL: u32 = 1 << 30;

/// A box; the fourth component means nothing.
#[derive(Clone, Copy, Debug)]
struct Extent {
    min: Vec4,
    max: Vec4,
}

impl Extent {
    const EMPTY: Extent = Extent { min: Vec4::INFINITY, max: Vec4::NEG_INFINITY };

    #[inline(always)]
    fn with(self, point: Vec4) -> Extent {
        Extent { min: self.min.min(point), max: self.max.max(point) }
    }

    #[inline(always)]
    fn union(self, other: Extent) -> Extent {
        Extent { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    #[inline(always)]
    fn half_area(self) -> f32 {
        let [x, y, z, _] = (self.max - self.min).to_array();
        x * y + y * z + z * x
    }
}

/// A range of primitives with what is known of it.
#[derive(Clone, Debug)]
pub(super) struct Part {
    range: Range<usize>,
    around: Extent,
    /// A box around twice the centres.
    centers: Extent,
    is_leaf: bool,
}

/// A place to cut.
struct Cut {
    cost: f32,
    axis: usize,
    /// The first slice on the far side.
    bin: u32,
    /// The boxes around what is on the near side and on the far side.
    around: [Extent; 2],
}

impl Part {
    /// The part that has this range of primitives.
    pub fn of(primitives: &[Rough], range: Range<usize>) -> Part {
        let of_chunk = |primitives: &[Rough]| {
            let (mut around, mut centers) = (Extent::EMPTY, Extent::EMPTY);
            for primitive in primitives {
                around = around.union(primitive.around);
                centers = centers.with(primitive.center());
            }
            (around, centers)
        };
        let own = &primitives[range.clone()];
        let (around, centers) = if own.len() <= CHUNK {
            of_chunk(own)
        } else {
            let join = |one: (Extent, Extent), other: (Extent, Extent)| (one.0.union(other.0), one.1.union(other.1));
            own.par_chunks(CHUNK).map(of_chunk).reduce(|| (Extent::EMPTY, Extent::EMPTY), join)
        };
        Part::new(primitives, range, around, centers)
    }

    fn new(primitives: &[Rough], range: Range<usize>, around: Extent, centers: Extent) -> Part {
        let is_leaf = range.len() <= BLOCK && can_be_leaf(&primitives[range.clone()]);
        Part { range, around, centers, is_leaf }
    }

    pub fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    pub fn len(&self) -> usize {
        self.range.len()
    }

    /// The same part where its first primitive is the first of all.
    pub fn as_whole(&self) -> Part {
        Part { range: 0..self.len(), ..*self }
    }

    pub fn half_area(&self) -> f32 {
        self.around.half_area()
    }

    pub fn around(&self) -> Box32 {
        let [min, max] = [self.around.min, self.around.max].map(|corner| corner.truncate().to_array());
        Box32 { min, max }
    }

    /// Whether one leaf can hold it.
    pub fn is_leaf(&self) -> bool {
        self.is_leaf
    }

    /// Cuts the part in two; into halves if that is asked for, or if nothing else makes sense.
    pub fn split(&self, primitives: &mut [Rough], into_halves: bool) -> [Part; 2] {
        let cut = if into_halves { None } else { self.best_cut(&primitives[self.range()]) };
        match cut {
            Some(cut) => self.cut(primitives, &cut),
            None => self.halves(primitives),
        }
    }

    /// How centres lie in slices; `None` where they all lie in one place.
    fn slices(&self) -> Option<Slices> {
        let width = self.centers.max - self.centers.min;
        // Just below, so that the last centre is in the last slice.
        let per = |width: f32| if width > 0.0 { BINS as f32 * (1.0 - 1e-6) / width } else { 0.0 };
        let per = Vec4::new(per(width.x), per(width.y), per(width.z), 0.0);
        (per != Vec4::ZERO && per.is_finite()).then_some(Slices { low: self.centers.min, per })
    }

    fn best_cut(&self, primitives: &[Rough]) -> Option<Cut> {
        let slices = self.slices()?;
        let bins = Bins::of(primitives, &slices);
        let axes = (0..3).filter(|axis| slices.per[*axis] > 0.0);
        axes.filter_map(|axis| bins.cheapest(axis)).min_by(|one, other| one.cost.total_cmp(&other.cost))
    }

    fn cut(&self, primitives: &mut [Rough], cut: &Cut) -> [Part; 2] {
        let Some(slices) = self.slices() else { return self.halves(primitives) };
        let Range { start, end } = self.range;
        let own = &mut primitives[start..end];
        let [mut near, mut far] = [Extent::EMPTY; 2];
        let mut count = 0;
        // Without a branch that depends on the primitive: half of them would be mispredicted.
        for at in 0..own.len() {
            let primitive = own[at];
            let center = primitive.center();
            let is_near = slices.of(center)[cut.axis] < cut.bin;
            own[at] = own[count];
            own[count] = primitive;
            count += usize::from(is_near);
            let [in_near, in_far] = if is_near { [0.0, f32::INFINITY] } else { [f32::INFINITY, 0.0] }.map(Vec4::splat);
            near = Extent { min: near.min.min(center + in_near), max: near.max.max(center - in_near) };
            far = Extent { min: far.min.min(center + in_far), max: far.max.max(center - in_far) };
        }
        let middle = start + count;
        let [around_near, around_far] = cut.around;
        [Part::new(primitives, start..middle, around_near, near), Part::new(primitives, middle..end, around_far, far)]
    }

    /// Halves along the longest side of the centres; primitives of one kind stay together where centres are the same.
    fn halves(&self, primitives: &mut [Rough]) -> [Part; 2] {
        let width = (self.centers.max - self.centers.min).to_array();
        let axis = (0..3).fold(0, |longest, axis| if width[axis] > width[longest] { axis } else { longest });
        let Range { start, end } = self.range;
        let place = |primitive: &Rough| primitive.center()[axis];
        primitives[self.range()].sort_unstable_by(|a, b| {
            place(a).total_cmp(&place(b)).then(a.kind().cmp(&b.kind())).then(a.primitive().cmp(&b.primitive()))
        });
        let middle = start + self.len() / 2;
        [Part::of(primitives, start..middle), Part::of(primitives, middle..end)]
    }
}

/// Whether one leaf can hold these primitives, eight at most.
fn can_be_leaf(primitives: &[Rough]) -> bool {
    match primitives.first().map(Rough::kind) {
        Some(Kind::Other) => primitives.len() == 1,
        Some(kind) => primitives.iter().all(|primitive| primitive.kind() == kind),
        None => true,
    }
}

/// How the centres of primitives lie in slices.
struct Slices {
    /// Where the first slices begin.
    low: Vec4,
    /// By how much the slice of a centre grows along each axis.
    per: Vec4,
}

impl Slices {
    /// The slices of a centre by axis, less than [`BINS`].
    #[inline(always)]
    fn of(&self, center: Vec4) -> [u32; 4] {
        /// From here on whole numbers are neighbours, so that a sum with it is rounded to one.
        const WHOLE: f32 = (1 << 23) as f32;
        let rounded = (center - self.low) * self.per + Vec4::splat(WHOLE - 0.5);
        rounded.max(Vec4::splat(WHOLE)).to_array().map(|x| x.to_bits() & (BINS as u32 - 1))
    }
}

/// What lies in the slices of each axis.
struct Bins {
    around: [[Extent; BINS]; 3],
    /// The room that it takes in blocks.
    room: [[u32; BINS]; 3],
}

impl Bins {
    const EMPTY: Bins = Bins { around: [[Extent::EMPTY; BINS]; 3], room: [[0; BINS]; 3] };

    /// Of all primitives, on all cores where they are many.
    fn of(primitives: &[Rough], slices: &Slices) -> Bins {
        if primitives.len() <= CHUNK {
            return Bins::of_chunk(primitives, slices);
        }
        let of_chunk = |primitives| Bins::of_chunk(primitives, slices);
        primitives.par_chunks(CHUNK).map(of_chunk).reduce(|| Bins::EMPTY, Bins::union)
    }

    fn union(mut self, other: Bins) -> Bins {
        for axis in 0..3 {
            for bin in 0..BINS {
                let around = &mut self.around[axis][bin];
                *around = around.union(other.around[axis][bin]);
                self.room[axis][bin] += other.room[axis][bin];
            }
        }
        self
    }

    fn of_chunk(primitives: &[Rough], slices: &Slices) -> Bins {
        let mut bins = Bins::EMPTY;
        for primitive in primitives {
            let [x, y, z, _] = slices.of(primitive.center());
            let room = primitive.kind().room();
            for (axis, slice) in [x, y, z].into_iter().enumerate() {
                let slice = slice as usize % BINS;
                let around = &mut bins.around[axis][slice];
                *around = around.union(primitive.around);
                bins.room[axis][slice] += room;
            }
        }
        bins
    }

    /// The cheapest cut between two slices of an axis: the least sum of the areas on both sides, each times the room that its primitives take in
    /// blocks. Whole blocks instead of room would fill the blocks better, but rays would hit more of them.
    fn cheapest(&self, axis: usize) -> Option<Cut> {
        let (arounds, rooms) = (&self.around[axis], &self.room[axis]);
        let cost = |around: Extent, room: u32| around.half_area() * room as f32;
        let mut far = [(Extent::EMPTY, f32::INFINITY); BINS];
        let (mut around, mut room) = (Extent::EMPTY, 0);
        for bin in (1..BINS).rev() {
            around = around.union(arounds[bin]);
            room += rooms[bin];
            far[bin] = (around, if room > 0 { cost(around, room) } else { f32::INFINITY });
        }
        let (mut around, mut room) = (Extent::EMPTY, 0);
        let mut best: Option<Cut> = None;
        for bin in 1..BINS {
            around = around.union(arounds[bin - 1]);
            room += rooms[bin - 1];
            let total = if room > 0 { cost(around, room) + far[bin].1 } else { f32::INFINITY };
            if total < best.as_ref().map_or(f32::INFINITY, |best| best.cost) {
                best = Some(Cut { cost: total, axis, bin: bin as u32, around: [around, far[bin].0] });
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roughs(count: u32) -> Vec<Rough> {
        let place = |primitive: u32, k: u32| (primitive.wrapping_mul(k) >> 8) as f32 / 1e7 - 0.8;
        let rough = |primitive: u32| {
            let min = [2_654_435_761, 2_246_822_519, 3_266_489_917].map(|k| place(primitive, k));
            let kind = if primitive.is_multiple_of(7) { Kind::Other } else { Kind::Triangle };
            Rough::new(primitive, kind, &Box32 { min, max: min.map(|x| x + 0.01 * (primitive % 5) as f32) })
        };
        (0..count).map(rough).collect()
    }

    /// A part keeps its primitives, and what is known of its sides without looking at them again is right.
    #[test]
    fn a_part_is_cut_into_what_was_in_it() {
        for count in [2, 9, 30, 1000, 2 * CHUNK as u32 + 3] {
            let mut primitives = roughs(count);
            let whole = Part::of(&primitives, 0..primitives.len());
            for into_halves in [false, true] {
                let sides = whole.split(&mut primitives, into_halves);
                assert_eq!(
                    [sides[0].range.start, sides[0].range.end, sides[1].range.end],
                    [0, sides[1].range.start, count as usize]
                );
                for side in sides {
                    let again = Part::of(&primitives, side.range());
                    assert!(side.len() > 0 && side.is_leaf() == again.is_leaf());
                    let corners = |part: &Part| {
                        [part.around, part.centers].map(|extent| [extent.min, extent.max].map(Vec4::truncate))
                    };
                    assert_eq!(corners(&side), corners(&again), "{count}");
                }
                let mut numbers: Vec<u32> = primitives.iter().map(Rough::primitive).collect();
                numbers.sort_unstable();
                assert!(numbers.into_iter().eq(0..count));
            }
        }
    }

    #[test]
    fn the_cut_is_the_cheapest_of_all_between_slices() {
        let mut primitives = roughs(200);
        let whole = Part::of(&primitives, 0..primitives.len());
        let cost = |side: &[Rough]| {
            let room: u32 = side.iter().map(|primitive| primitive.kind().room()).sum();
            Part::of(side, 0..side.len()).half_area() * room as f32
        };
        let slices = whole.slices().expect("centres in more than one place");
        let mut least = f32::INFINITY;
        for axis in 0..3 {
            for bin in 1..BINS as u32 {
                let (near, far): (Vec<Rough>, Vec<Rough>) =
                    primitives.iter().partition(|primitive| slices.of(primitive.center())[axis] < bin);
                if !near.is_empty() && !far.is_empty() {
                    least = least.min(cost(&near) + cost(&far));
                }
            }
        }
        let sides = whole.split(&mut primitives, false);
        assert_eq!(sides.iter().map(|side| cost(&primitives[side.range()])).sum::<f32>(), least);
    }

    #[test]
    fn slices_are_counted_from_the_first_centre_to_the_last() {
        let slices = Slices { low: Vec4::splat(-1.0), per: Vec4::splat(8.0 * (1.0 - 1e-6)) };
        for (center, slice) in [(-1.0, 0), (-0.9, 0), (-0.8, 1), (0.01, 8), (0.99, 15), (1.0, 15), (f32::NAN, 0)] {
            assert_eq!(slices.of(Vec4::splat(center)), [slice; 4], "{center}");
        }
    }

    #[test]
    fn a_number_keeps_its_kind() {
        for primitive in [0, 1, 1 << 23, (1 << 30) - 1] {
            for kind in [Kind::Triangle, Kind::Sphere, Kind::Other] {
                let rough = Rough::new(primitive, kind, &Box32 { min: [0.0; 3], max: [1.0; 3] });
                assert_eq!((rough.primitive(), rough.kind()), (primitive, kind));
            }
        }
    }
}
