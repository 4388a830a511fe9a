//! Which objects a ray can hit: those without end, and those whose box it passes.

use super::Object;
use crate::geometry::bvh::{Bvh, Form, PerRay, RayMask, Search};
use crate::geometry::{Bounds, Intersect, Leaving, RaySource, Shaft, Shape};
use crate::probe::Probe;
use crate::threads::share;
use arrayvec::ArrayVec;
use glam::DVec3;
use rayon::prelude::*;

/// The objects of a scene, so arranged that a ray is tested with few of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Index {
    tree: Bvh,
    /// A box around all objects; `None` where one has no end.
    bounds: Option<Bounds>,
    /// What is known of each object, in the order of the scene; nothing where there is a tree.
    extents: Vec<Extent>,
    /// Of an index that shows every ray all objects (`--tests all`), the one without that option. What decides how many points of a light are asked looks
    /// there, so that a log has the picture's values.
    usual: Option<Box<Index>>,
    /// Whether there is a tree, of objects or of a mesh's triangles, in which rays save time by walking together.
    has_large_trees: bool,
}

/// Where an object is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Extent {
    /// In this ball.
    Ball { center: DVec3, radius: f64 },
    /// On a plane, which no ray hits that leaves it.
    Plane,
    /// Anywhere.
    Endless,
}

/// The objects that can lie between a point and a light.
pub type Between = ArrayVec<u32, MOST_BETWEEN>;

/// Up to this many bounded objects boxes cost more than they save.
const WITHOUT_TREE: usize = 8;

/// The most objects that are looked at for a whole light.
const MOST_BETWEEN: usize = 16;

/// In a tree over fewer primitives rays find what they hit as soon alone as together.
const WORTH_PACKETS: usize = 64;

/// How many objects one core looks at at a time.
const CHUNK: usize = 1 << 12;

/// Fewer objects are tested in less time than the tree takes.
const WORTH_TESTING: usize = 8;

/// Far more than all roundings, as a part of the squares of the lengths that are compared.
const MARGIN: f64 = 1e-6;

impl Extent {
    fn of(object: &Object) -> Extent {
        match (&object.shape, object.shape.form()) {
            (_, Some(Form::Sphere { center, radius })) => Extent::Ball { center, radius },
            (Shape::Plane(_), _) => Extent::Plane,
            (_, None) => Extent::Endless,
            (_, Some(form)) => {
                let Bounds { min, max } = form.bounds();
                Extent::Ball { center: (min + max) * 0.5, radius: (max - min).length() * 0.5 }
            }
        }
    }

    /// Whether the object can lie between a point and a ball (C, R). What lies between them at the part s of the way is at most s·R
    /// from P + s(C − P). So the object's ball (B, r) is beside it if |B − P − s(C − P)| > r + s·R for all s from 0 to 1: a
    /// quadratic in s, whose least value decides.
    fn reaches(&self, point: DVec3, (light, light_radius): (DVec3, f64), is_left: bool) -> bool {
        let (center, radius) = match *self {
            Extent::Ball { center, radius } => (center, radius),
            Extent::Plane => return !is_left,
            Extent::Endless => return true,
        };
        let (to_object, to_light) = (center - point, light - point);
        let square = to_light.dot(to_light) - light_radius * light_radius;
        let linear = to_object.dot(to_light) + radius * light_radius;
        let constant = to_object.dot(to_object) - radius * radius;
        let least = if square > 0.0 { (linear / square).clamp(0.0, 1.0) } else { 0.0 };
        let size = to_object.dot(to_object) + to_light.dot(to_light) + radius * radius + light_radius * light_radius;
        let apart = constant - 2.0 * least * linear + least * least * square;
        // What isn't a number is no proof. Nor is anything inside the light's own ball, where there is no least value.
        !(apart > MARGIN * size && square > 0.0)
    }
}

impl Index {
    /// Arranges these objects.
    pub fn new(objects: &[Object]) -> Index {
        let Sorted { unbounded, around } = sorted(objects);
        if objects.len() - unbounded.len() <= WITHOUT_TREE {
            let extents =
                if objects.len() <= MOST_BETWEEN { objects.iter().map(Extent::of).collect() } else { Vec::new() };
            return Index { extents, ..Index::without_tree(objects) };
        }
        let bounds = unbounded.is_empty().then_some(around);
        let bounded: Vec<u32> =
            (0..objects.len() as u32).filter(|object| unbounded.binary_search(object).is_err()).collect();
        let form = |object: u32| objects[object as usize].shape.form().unwrap_or(Form::Within(Bounds::EMPTY));
        let has_large_trees = bounded.len() >= WORTH_PACKETS || has_large_meshes(objects);
        let tree = Bvh::new(unbounded, bounded, form);
        Index { tree, bounds, extents: Vec::new(), usual: None, has_large_trees }
    }

    /// Shows every ray all objects in the order of the scene, as a log of every test wants it.
    pub fn of_all(objects: &[Object]) -> Index {
        Index { usual: Some(Box::new(Index::new(objects))), ..Index::without_tree(objects) }
    }

    fn without_tree(objects: &[Object]) -> Index {
        let tree = Bvh::new((0..objects.len() as u32).collect(), Vec::new(), |_| Form::Within(Bounds::EMPTY));
        let Sorted { unbounded, around } = sorted(objects);
        let bounds = unbounded.is_empty().then_some(around);
        Index { tree, bounds, extents: Vec::new(), usual: None, has_large_trees: has_large_meshes(objects) }
    }

    /// Whether there are trees in which rays save time by walking together.
    pub fn has_large_trees(&self) -> bool {
        self.has_large_trees
    }

    /// Whether it was asked to show every ray all objects.
    pub fn shows_all(&self) -> bool {
        self.usual.is_some()
    }

    /// The index without the wish to show every ray all objects.
    pub fn usual(&self) -> &Index {
        self.usual.as_deref().unwrap_or(self)
    }

    /// The objects that can lie between a point on the surface of `leaving` and any point of a ball; `None` where nothing is known
    /// but by asking the tree for each ray.
    #[inline]
    pub fn between(&self, point: DVec3, ball: (DVec3, f64), leaving: u32) -> Option<Between> {
        if self.extents.is_empty() {
            return None;
        }
        let reaches =
            |(object, extent): (u32, &Extent)| extent.reaches(point, ball, object == leaving).then_some(object);
        Some((0..).zip(&self.extents).filter_map(reaches).collect())
    }

    /// The objects that a ray along a segment of the shaft can cross; `None` where these are too many, or would take too long to find.
    /// `leaving` is the surface that all these rays leave, and the side on which they set off; `among` the objects that may be crossed, where
    /// others are excluded already.
    #[inline(never)]
    pub fn in_shaft(
        &self,
        objects: &[Object],
        shaft: &Shaft,
        leaving: Leaving,
        among: Option<&[u32]>,
    ) -> Option<Between> {
        let mut found = Between::new();
        let mut look_at = |object: u32| {
            let leaving = Some(leaving).filter(|leaving| leaving.object == object);
            if !objects[object as usize].shape.can_be_crossed_in(shaft, leaving) {
                return true;
            }
            let has_room = among.is_some() || found.len() < WORTH_TESTING;
            has_room && found.try_push(object).is_ok()
        };
        let is_all = match among {
            Some(among) => among.iter().all(|object| look_at(*object)),
            None => self.tree.between(shaft, look_at),
        };
        is_all.then_some(found)
    }

    /// Whether a half line, its direction of any length, certainly meets no object.
    #[inline(always)]
    pub fn is_surely_missed(&self, origin: DVec3, direction: DVec3) -> bool {
        self.bounds.is_some_and(|bounds| bounds.is_surely_missed(origin, direction))
    }

    /// Shows `meet` every object that the ray can hit, in the order of the search, and says whether it certainly crosses it. `meet`
    /// gives the distance up to which objects still matter; a negative one ends the search.
    #[inline(always)]
    pub fn visit<P: Probe>(
        &self,
        source: &impl RaySource,
        search: Search,
        probe: &mut P,
        mut meet: impl FnMut(u32, bool, &mut P) -> f64,
    ) {
        let tested = self.tree.visit::<P>(
            source,
            search,
            #[inline(always)]
            |object, is_sure| meet(object, is_sure, probe),
        );
        probe.bounds_tested(tested);
    }
}

impl Index {
    /// The same for several rays (see [`Bvh::visit_together`]). The number of tested boxes isn't reported.
    #[inline(always)]
    pub fn visit_together<P: Probe, S: RaySource>(
        &self,
        sources: &[S],
        rays: RayMask,
        search: Search,
        limits: &mut PerRay<f64>,
        meet: impl FnMut(RayMask, u32, bool, &mut PerRay<f64>),
    ) {
        self.tree.visit_together::<P, S>(sources, rays, search, limits, meet);
    }
}

fn has_large_meshes(objects: &[Object]) -> bool {
    let is_large = |object: &Object| match object.shape.at_rest() {
        Shape::Mesh(mesh) => mesh.mesh().faces.len() >= WORTH_PACKETS,
        _ => false,
    };
    objects.iter().any(is_large)
}

/// The objects without end, and a box around the others.
struct Sorted {
    unbounded: Vec<u32>,
    around: Bounds,
}

fn sorted(objects: &[Object]) -> Sorted {
    let with = |mut sorted: Sorted, object: u32| {
        match objects[object as usize].shape.bounds() {
            Some(bounds) => sorted.around = sorted.around.union(bounds),
            None => sorted.unbounded.push(object),
        }
        sorted
    };
    let join = |mut one: Sorted, other: Sorted| {
        one.unbounded.extend(other.unbounded);
        Sorted { around: one.around.union(other.around), ..one }
    };
    let nothing = || Sorted { unbounded: Vec::new(), around: Bounds::EMPTY };
    let numbers = 0..objects.len() as u32;
    share(objects.len(), || numbers.into_par_iter().with_min_len(CHUNK).fold(nothing, with).reduce(nothing, join))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Side;
    use crate::geometry::shape::{Plane, Sphere, SphereMethod};
    use crate::random::{hash, unit, warp};
    use crate::scene::Scene;

    /// Whatever a segment from the point to some point of the light meets can lie between them.
    #[test]
    fn nothing_that_shadows_a_part_of_a_light_is_left_out() {
        let (mut shadows, mut left_out) = (0, 0);
        for k in 0..20_000_u64 {
            let number = |axis: u64| unit(hash(k, axis));
            let place = |axis: u64| DVec3::new(number(axis), number(axis + 1), number(axis + 2)) * 4.0;
            let (point, light, light_radius) = (place(0), place(3), number(6) * 0.5);
            let extent = Extent::Ball { center: place(7), radius: number(10) * 0.8 };
            let Extent::Ball { center, radius } = extent else { unreachable!("it was made as a ball") };
            let reaches = extent.reaches(point, (light, light_radius), false);
            let is_met = (0..40).any(|at| {
                let number = |axis: u64| unit(hash(hash(k, at), axis));
                let asked = light + DVec3::from(warp::sphere([number(0), number(1)])) * light_radius;
                let segment = asked - point;
                let nearest = ((center - point).dot(segment) / segment.dot(segment)).clamp(0.0, 1.0);
                (point + segment * nearest - center).length() <= radius
            });
            assert!(reaches || !is_met, "{k}");
            shadows += u32::from(is_met);
            left_out += u32::from(!reaches);
        }
        assert!(shadows > 1000 && left_out > 5000, "{shadows} {left_out}");
    }

    /// A ball on a floor: what leaves it meets neither again on its way to a light above.
    #[test]
    fn a_ball_and_the_floor_under_it_are_out_of_the_way_to_a_light_above() {
        let ball = Shape::Sphere(Sphere::new(DVec3::Y, 1.0, false, SphereMethod::Robust));
        let floor = Shape::Plane(Plane::new([0.0, 1.0, 0.0, 0.0]));
        let objects = Scene::of_shapes("ball", [floor, ball]).objects;
        let index = Index::new(&objects);
        let between = |height: f64, side: Side| {
            let center = DVec3::new(0.0, height, 0.0);
            let light = Bounds { min: center - 0.1, max: center + 0.1 };
            let shaft = Shaft::new(DVec3::Y * 2.0, light, (center, 0.2));
            let leaving = Leaving { object: 1, primitive: 0, side };
            index.in_shaft(&objects, &shaft, leaving, Some(&[0, 1])).map(|found| found.to_vec())
        };
        assert_eq!(between(5.0, Side::Front), Some(vec![]));
        // Inside the ball, and beneath the floor.
        assert_eq!(between(1.0, Side::Back), Some(vec![1]));
        assert_eq!(between(-1.0, Side::Back), Some(vec![0, 1]));
    }

    #[test]
    fn only_the_plane_that_a_ray_leaves_is_out_of_its_way() {
        let ball = (DVec3::Y, 0.1);
        assert!(!Extent::Plane.reaches(DVec3::ZERO, ball, true));
        assert!(Extent::Plane.reaches(DVec3::ZERO, ball, false) && Extent::Endless.reaches(DVec3::ZERO, ball, true));
    }
}
