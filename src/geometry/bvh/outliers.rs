//! Primitives so large, or so far from the others, that they would spoil the space in which the others lie.

use crate::geometry::bounds::Bounds;
use glam::DVec3;
use rayon::prelude::*;

/// A primitive that reaches this many times farther out than all others is an outlier.
const FAR: f64 = 1024.0;

/// The most outliers there can be.
const MOST: usize = 8;

/// How many primitives are looked at by one core at a time.
const CHUNK: usize = 1 << 12;

/// How many primitives are looked at to find where most are.
const SAMPLE: usize = 1 << 10;

/// Primitives, the outliers apart from the others.
pub(super) struct Sorted {
    pub outliers: Vec<u32>,
    /// The others in their order.
    pub kept: Vec<u32>,
    /// The box around those that are kept.
    pub around: Bounds,
}

/// Finds the outliers.
pub(super) fn sorted(mut primitives: Vec<u32>, bounds_of: impl Fn(u32) -> Bounds + Sync) -> Sorted {
    let step = primitives.len().div_ceil(SAMPLE).max(1);
    let middle = median(primitives.iter().step_by(step).map(|primitive| bounds_of(*primitive).center()).collect());
    let look_at = |chunk: &[u32]| {
        let mut around = Bounds::EMPTY;
        let reach = |primitive: &u32| {
            let bounds = bounds_of(*primitive);
            around = around.union(bounds);
            ((bounds.min - middle).abs().max((bounds.max - middle).abs()).max_element(), *primitive)
        };
        (farthest(chunk.iter().map(reach)), around)
    };
    let join = |(one, around): (Vec<_>, Bounds), (other, around_other): (Vec<_>, Bounds)| {
        (farthest(one.into_iter().chain(other)), around.union(around_other))
    };
    let nothing = || (Vec::new(), Bounds::EMPTY);
    let (farthest, around) = primitives.par_chunks(CHUNK).map(look_at).reduce(nothing, join);
    let is_gap = |pair: &[(f64, u32)]| pair[0].0 > FAR * pair[1].0;
    let Some(last) = farthest.windows(2).rposition(is_gap) else {
        return Sorted { outliers: Vec::new(), kept: primitives, around };
    };
    let mut outliers: Vec<u32> = farthest[..=last].iter().map(|(_, primitive)| *primitive).collect();
    outliers.sort_unstable();
    primitives.retain(|primitive| outliers.binary_search(primitive).is_err());
    let around = primitives.iter().fold(Bounds::EMPTY, |around, primitive| around.union(bounds_of(*primitive)));
    Sorted { outliers, kept: primitives, around }
}

/// The primitives that reach farthest out, one more than there can be outliers, the farthest first.
fn farthest(primitives: impl Iterator<Item = (f64, u32)>) -> Vec<(f64, u32)> {
    let mut farthest: Vec<(f64, u32)> = Vec::with_capacity(MOST + 2);
    for (reach, primitive) in primitives {
        if farthest.len() > MOST && reach <= farthest[MOST].0 {
            continue;
        }
        let at = farthest.partition_point(|(other, number)| (*other, primitive) > (reach, *number));
        farthest.insert(at, (reach, primitive));
        farthest.truncate(MOST + 1);
    }
    farthest
}

/// The median of points, axis by axis.
fn median(points: Vec<DVec3>) -> DVec3 {
    let of_axis = |axis: usize| {
        let mut places: Vec<f64> = points.iter().map(|point| point[axis]).collect();
        places.sort_by(f64::total_cmp);
        places.get(places.len() / 2).copied().unwrap_or(0.0)
    };
    DVec3::new(of_axis(0), of_axis(1), of_axis(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_floor_is_put_beside_a_crowd() {
        let bounds_of = |primitive: u32| {
            let at = DVec3::new(f64::from(primitive), 0.0, 0.0);
            let half = if primitive == 3 { 1e6 } else { 0.5 };
            Bounds { min: at - half, max: at + half }
        };
        let primitives: Vec<u32> = (0..20).collect();
        let Sorted { outliers, kept, around } = sorted(primitives, bounds_of);
        assert_eq!((outliers, kept.len()), (vec![3], 19));
        assert_eq!(around, Bounds { min: DVec3::splat(-0.5), max: DVec3::new(19.5, 0.5, 0.5) });
        assert!(sorted(kept, bounds_of).outliers.is_empty());
    }
}
