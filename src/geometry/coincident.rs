//! Which of the crossings of a ray coincide, and which of those is the nearest.

use super::nearest::{Hit, Nearest};
use super::ray::{Crossing, Ray, Side};
use super::shape::{Intersect, Shape, Target};
use crate::probe::{Probe, ROUNDINGS};
use glam::DVec3;
use std::collections::{HashMap, HashSet};

impl Shape {
    /// The first point where the ray crosses the target, which has this shape.
    pub fn first_crossing<P: Probe>(&self, target: Target, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        let mut nearest = Nearest::of(ray);
        self.nearest(target, ray, &mut nearest, probe);
        nearest.place(ray, |_| self, probe).first().map(|hit| hit.crossing)
    }
}

impl Nearest {
    /// The surfaces coincident with the nearest of all crossings, in the order of the scene: the first is the one that the ray hits.
    /// `shape` gives the shape of an object.
    pub fn place<'s, P: Probe>(self, ray: &Ray, shape: impl Fn(u32) -> &'s Shape, probe: &P) -> Vec<Hit> {
        let Some(nearest) = self.hit else { return Vec::new() };
        let Some(mut hits) = self.others.map(|hits| *hits) else { return vec![nearest] };
        // Of several at the same distance this is the one that was found first.
        hits.sort_by(|one, other| one.crossing.t.total_cmp(&other.crossing.t).then(one.rank().cmp(&other.rank())));
        let nearest = hits.first().copied().filter(|hit| hit.crossing.t <= nearest.crossing.t).unwrap_or(nearest);
        let slope = |hit: &Hit| shape(hit.object).slope(ray, hit.crossing);
        let size = |hit: &Hit| shape(hit.object).size(hit.crossing.primitive);
        let (its_slope, its_size) = (slope(&nearest), size(&nearest));
        let is_here = |hit: &Hit| {
            let gap = (hit.crossing.t - nearest.crossing.t) * its_slope.max(slope(hit));
            let points = 2.0 * (ray.origin.abs().element_sum() + hit.crossing.t);
            gap <= probe.slack(points) + ROUNDINGS * (its_size + size(hit))
        };
        hits.retain(is_here);
        hits.insert(0, nearest);
        let mut here = if hits.len() <= FEW { once_each(&hits, shape) } else { once_each_of_many(&hits, shape) };
        here.sort_by_key(Hit::rank);
        here
    }
}

/// Up to this many hits it is quicker to compare each with each.
const FEW: usize = 16;

/// The hits without those of a surface that is already hit: an edge or a corner is crossed once, on the triangle that is hit first.
fn once_each<'s>(hits: &[Hit], shape: impl Fn(u32) -> &'s Shape) -> Vec<Hit> {
    let mut kept: Vec<Hit> = Vec::new();
    for hit in hits {
        let is_same = |other: &Hit| {
            other == hit
                || other.object == hit.object
                    && shape(hit.object).are_neighbors(other.crossing.primitive, hit.crossing.primitive)
        };
        if !kept.iter().any(is_same) {
            kept.push(*hit);
        }
    }
    kept
}

/// The same, in time that grows with their number. Where roundings leave it open whether triangles at an edge are in one plane, the first of
/// them decides.
#[cold]
fn once_each_of_many<'s>(hits: &[Hit], shape: impl Fn(u32) -> &'s Shape) -> Vec<Hit> {
    let mut kept = Vec::new();
    let mut known = HashSet::new();
    let mut met = Met::default();
    for hit in hits {
        let Hit { object, crossing: Crossing { t, side, primitive } } = *hit;
        let corners = shape(object).corners_of(primitive);
        // Whatever is crossed again of another shape is the same surface.
        let key = corners.map(|_| (primitive, t.to_bits(), side == Side::Front));
        if known.insert((object, key)) && corners.is_none_or(|corners| met.adds(object, primitive, corners, &shape)) {
            kept.push(*hit);
        }
    }
    kept
}

/// A corner of an object's mesh.
type Corner = (u32, [u64; 3]);

/// The triangles that were kept, by what they have in common with others.
///
/// Those at one edge all overlap, in one plane and on one side, as otherwise they would be neighbours: the first stands for all of them. So
/// the first stands for those that have all three corners in common.
#[derive(Default)]
struct Met {
    outlines: HashSet<[Corner; 3]>,
    /// How many outlines have a corner.
    corners: HashMap<Corner, usize>,
    /// How many have an edge, and the first of them.
    edges: HashMap<[Corner; 2], (usize, u32)>,
}

impl Met {
    /// Adds a triangle unless it is a neighbour of one that is there.
    fn adds<'s>(&mut self, object: u32, triangle: u32, corners: [DVec3; 3], shape: &impl Fn(u32) -> &'s Shape) -> bool {
        // With one zero for both.
        let mut outline = corners.map(|corner| (object, corner.to_array().map(|x| (x + 0.0).to_bits())));
        outline.sort_unstable();
        let [a, b, c] = outline;
        if self.outlines.contains(&outline) {
            return true;
        }
        let edges = [[a, b], [a, c], [b, c]];
        let at_edges: Vec<_> = edges.iter().filter_map(|edge| self.edges.get(edge)).copied().collect();
        let with_corners: usize = outline.iter().filter_map(|corner| self.corners.get(corner)).sum();
        // One with two corners in common is at both; any more have one in common.
        let with_edges: usize = at_edges.iter().map(|(count, _)| 2 * count).sum();
        let is_neighbor = with_corners > with_edges
            || at_edges.iter().any(|(_, first)| shape(object).are_neighbors(*first, triangle));
        if is_neighbor {
            return false;
        }
        self.outlines.insert(outline);
        for corner in outline {
            *self.corners.entry(corner).or_default() += 1;
        }
        for edge in edges {
            self.edges.entry(edge).or_insert((0, triangle)).0 += 1;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Mesh;
    use crate::geometry::shape::{Plane, TriangleMesh};
    use crate::random::hash;
    use glam::DVec3;
    use std::sync::Arc;

    /// Triangles that share corners and edges, overlap, and are there several times, and what is hit of them and of spheres.
    fn hits_at_random(seed: u64) -> (Vec<Hit>, [Shape; 2]) {
        let draw = |number: u64, below: u64| hash(seed, number) % below;
        let positions = (0..9).map(|k| DVec3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
        let faces = (0..40).map(|k| [0, 1, 2].map(|corner| draw(3 * k + corner, 9) as u32));
        let faces: Vec<_> = faces.filter(|[a, b, c]| a != b && b != c && c != a).collect();
        let count = faces.len() as u64;
        let mesh = TriangleMesh::new(Arc::new(Mesh { positions, faces, ..Mesh::default() }));
        let shapes = [Shape::Mesh(Arc::new(mesh)), Shape::Plane(Plane::new([0.0, 0.0, 1.0, 0.0]))];
        let hit = |k: u64| {
            let object = draw(1000 + k, 3).saturating_sub(1) as u32;
            let primitive = if object == 0 { draw(2000 + k, count) as u32 } else { 0 };
            let side = if draw(3000 + k, 8) == 0 { Side::Back } else { Side::Front };
            Hit { object, crossing: Crossing { t: 1.0 + draw(4000 + k, 2) as f64, side, primitive } }
        };
        ((0..100).map(hit).collect(), shapes)
    }

    #[test]
    fn an_index_keeps_the_same_hits() {
        for seed in 0..500 {
            let (hits, shapes) = hits_at_random(seed);
            let shape = |object: u32| &shapes[object as usize];
            assert_eq!(once_each_of_many(&hits, shape), once_each(&hits, shape), "{seed}");
        }
    }
}
