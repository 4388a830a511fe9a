//! Cutting a part of the things in two, where the surface area heuristic says so.

use super::build::Kind;
use super::node::Box32;
use glam::Vec4;
use std::ops::Range;

/// How many things a block has room for.
pub(super) const BLOCK: usize = 8;

/// In how many slices an axis is cut.
const BINS: usize = 16;

/// A thing as the builder sees it.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub(super) struct Rough {
    pub min: [f32; 3],
    pub thing: u32,
    pub max: [f32; 3],
    pub kind: Kind,
}

impl Rough {
    #[inline(always)]
    fn around(&self) -> Extent {
        let [min, max] = [self.min, self.max].map(|[x, y, z]| Vec4::new(x, y, z, 0.0));
        Extent { min, max }
    }

    /// Twice the centre.
    #[inline(always)]
    fn center(&self) -> Vec4 {
        let Extent { min, max } = self.around();
        min + max
    }
}

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

/// A range of things with what is known of it.
#[derive(Clone, Debug)]
pub(super) struct Part {
    range: Range<usize>,
    around: Extent,
    centers: Extent,
}

/// A place to cut.
struct Cut {
    cost: f32,
    axis: usize,
    /// The first slice on the far side.
    bin: i32,
}

impl Part {
    /// The part that has this range of things.
    pub fn of(things: &[Rough], range: Range<usize>) -> Part {
        let (mut around, mut centers) = (Extent::EMPTY, Extent::EMPTY);
        for thing in &things[range.clone()] {
            around = around.union(thing.around());
            centers = centers.with(thing.center());
        }
        Part { range, around, centers }
    }

    pub fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    pub fn len(&self) -> usize {
        self.range.len()
    }

    /// The same part where its first thing is the first of all.
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
    pub fn is_leaf(&self, things: &[Rough]) -> bool {
        if self.len() > BLOCK {
            return false;
        }
        let things = &things[self.range()];
        match things[0].kind {
            Kind::Other => things.len() == 1,
            kind => things.iter().all(|thing| thing.kind == kind),
        }
    }

    /// Cuts the part in two; into halves if that is asked for, or if nothing else makes sense.
    pub fn split(&self, things: &mut [Rough], into_halves: bool) -> [Part; 2] {
        let cut = if into_halves { None } else { self.best_cut(&things[self.range()]) };
        match cut {
            Some(cut) => self.cut(things, &cut),
            None => self.halves(things),
        }
    }

    /// By how much the slice of a centre grows along each axis.
    fn slices(&self) -> Vec4 {
        let width = self.centers.max - self.centers.min;
        // Just below, so that the last centre is in the last slice.
        let per = |width: f32| if width > 0.0 { BINS as f32 * (1.0 - 1e-6) / width } else { 0.0 };
        Vec4::new(per(width.x), per(width.y), per(width.z), 0.0)
    }

    fn best_cut(&self, things: &[Rough]) -> Option<Cut> {
        let (low, per) = (self.centers.min, self.slices());
        if per == Vec4::ZERO || !per.is_finite() {
            return None;
        }
        let mut bins = [[(Extent::EMPTY, 0_u32); BINS]; 3];
        for thing in things {
            let around = thing.around();
            let slice = ((around.min + around.max - low) * per).to_array();
            for axis in 0..3 {
                let bin = &mut bins[axis][(slice[axis] as usize).min(BINS - 1)];
                *bin = (bin.0.union(around), bin.1 + thing.kind.room());
            }
        }
        let cuts = (0..3).filter(|axis| per[*axis] > 0.0).filter_map(|axis| cheapest(axis, &bins[axis]));
        cuts.min_by(|one, other| one.cost.total_cmp(&other.cost))
    }

    fn cut(&self, things: &mut [Rough], cut: &Cut) -> [Part; 2] {
        let (low, per) = (self.centers.min[cut.axis], self.slices()[cut.axis]);
        let is_near = |thing: &Rough| {
            let slice = (thing.min[cut.axis] + thing.max[cut.axis] - low) * per;
            ((slice as usize).min(BINS - 1) as i32) < cut.bin
        };
        let Range { start, end } = self.range;
        let mut sides = [(Extent::EMPTY, Extent::EMPTY); 2];
        let (mut next, mut last) = (start, end);
        while next < last {
            let thing = things[next];
            let near = is_near(&thing);
            let side = &mut sides[usize::from(!near)];
            *side = (side.0.union(thing.around()), side.1.with(thing.center()));
            if near {
                next += 1;
            } else {
                last -= 1;
                things.swap(next, last);
            }
        }
        let part = |range, (around, centers)| Part { range, around, centers };
        let [near, far] = sides;
        [part(start..next, near), part(next..end, far)]
    }

    /// Halves along the longest side of the centres; things of one kind stay together where centres are the same.
    fn halves(&self, things: &mut [Rough]) -> [Part; 2] {
        let width = (self.centers.max - self.centers.min).to_array();
        let axis = (0..3).fold(0, |longest, axis| if width[axis] > width[longest] { axis } else { longest });
        let Range { start, end } = self.range;
        let place = |thing: &Rough| thing.min[axis] + thing.max[axis];
        things[self.range()].sort_unstable_by(|a, b| {
            place(a).total_cmp(&place(b)).then(a.kind.cmp(&b.kind)).then(a.thing.cmp(&b.thing))
        });
        let middle = start + self.len() / 2;
        [Part::of(things, start..middle), Part::of(things, middle..end)]
    }
}

/// The cheapest cut between two slices with their boxes and the room that their things take in blocks: the least sum of the areas on both
/// sides, each times its room. Whole blocks instead of room would fill the blocks better, but rays would meet more of them.
fn cheapest(axis: usize, bins: &[(Extent, u32); BINS]) -> Option<Cut> {
    let cost = |around: Extent, room: u32| around.half_area() * room as f32;
    let mut far_costs = [f32::INFINITY; BINS];
    let (mut around, mut room) = (Extent::EMPTY, 0);
    for bin in (1..BINS).rev() {
        around = around.union(bins[bin].0);
        room += bins[bin].1;
        if room > 0 {
            far_costs[bin] = cost(around, room);
        }
    }
    let (mut around, mut room) = (Extent::EMPTY, 0);
    let mut best: Option<Cut> = None;
    for bin in 1..BINS {
        around = around.union(bins[bin - 1].0);
        room += bins[bin - 1].1;
        let total = if room > 0 { cost(around, room) + far_costs[bin] } else { f32::INFINITY };
        if total < best.as_ref().map_or(f32::INFINITY, |best| best.cost) {
            best = Some(Cut { cost: total, axis, bin: bin as i32 });
        }
    }
    best
}
