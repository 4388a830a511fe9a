//! Which objects a ray can meet: those without end, and those whose box it passes.

use super::Object;
use crate::geometry::Bounds;
use crate::geometry::bvh::{Bvh, Form, Search};
use crate::geometry::ray::Ray;
use crate::probe::Probe;

/// The objects of a scene, so arranged that a ray is tested with few of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Index {
    tree: Bvh,
}

/// Up to so many bounded objects boxes cost more than they save.
const WITHOUT_TREE: usize = 8;

impl Index {
    /// Arranges these objects.
    pub fn new(objects: &[Object]) -> Index {
        let is_bounded = |object: &u32| objects[*object as usize].shape.bounds().is_some();
        let (bounded, unbounded): (Vec<u32>, Vec<u32>) = (0..objects.len() as u32).partition(is_bounded);
        if bounded.len() <= WITHOUT_TREE {
            return Index::of_all(objects);
        }
        let form = |object: u32| objects[object as usize].shape.form().unwrap_or(Form::Within(Bounds::EMPTY));
        Index { tree: Bvh::new(unbounded, &bounded, form) }
    }

    /// Shows every ray all objects in the order of the scene, as a log of every test wants it.
    pub fn of_all(objects: &[Object]) -> Index {
        Index { tree: Bvh::new((0..objects.len() as u32).collect(), &[], |_| Form::Within(Bounds::EMPTY)) }
    }

    /// Shows `meet` every object that the ray can meet, near ones first. `meet` gives the distance up to which objects still
    /// matter; a negative one ends the search.
    #[inline(always)]
    pub fn nearest_first<P: Probe>(&self, ray: &Ray, probe: &mut P, meet: impl FnMut(u32, &mut P) -> f64) {
        self.visit(ray, true, probe, meet);
    }

    /// The same without any order.
    #[inline(always)]
    pub fn in_any_order<P: Probe>(&self, ray: &Ray, probe: &mut P, meet: impl FnMut(u32, &mut P) -> f64) {
        self.visit(ray, false, probe, meet);
    }

    #[inline(always)]
    fn visit<P: Probe>(&self, ray: &Ray, nearest_first: bool, probe: &mut P, mut meet: impl FnMut(u32, &mut P) -> f64) {
        let search = Search { nearest_first, one_by_one: probe.certifies() };
        let tested = self.tree.visit::<P>(
            ray,
            search,
            #[inline(always)]
            |object| meet(object, probe),
        );
        probe.bounds_tested(tested);
    }
}
