//! Which objects a ray can meet: those without end, and those whose box it passes.

use super::Object;
use crate::geometry::bvh::Bvh;
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
        let bounds: Vec<_> = (0..).zip(objects).map(|(object, thing)| (object, thing.shape.bounds())).collect();
        let bounded: Vec<_> = bounds.iter().filter_map(|(object, bounds)| Some((*object, (*bounds)?))).collect();
        if bounded.len() <= WITHOUT_TREE {
            return Index::of_all(objects);
        }
        let unbounded = bounds.iter().filter(|(_, bounds)| bounds.is_none()).map(|(object, _)| *object).collect();
        Index { tree: Bvh::new(unbounded, bounded) }
    }

    /// Shows every ray all objects in the order of the scene, as a log of every test wants it.
    pub fn of_all(objects: &[Object]) -> Index {
        Index { tree: Bvh::new((0..objects.len() as u32).collect(), []) }
    }

    /// Shows `meet` every object that the ray can meet. `meet` gives the distance up to which objects still matter; a
    /// negative one ends the search.
    #[inline]
    pub fn visit<P: Probe>(&self, ray: &Ray, probe: &mut P, mut meet: impl FnMut(u32, &mut P) -> f64) {
        let tested = self.tree.visit(ray, |object| meet(object, probe));
        probe.bounds_tested(tested);
    }
}
