//! Which objects a ray can meet: those without end, and those whose box it passes.

use super::Object;
use crate::geometry::bvh::Bvh;
use crate::geometry::ray::Ray;
use crate::probe::Probe;

/// The objects of a scene, so arranged that a ray is tested with few of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Index {
    /// Objects that every ray is tested with, in the order of the scene.
    everywhere: Vec<u32>,
    /// Objects with a box, as the tree numbers them.
    bounded: Vec<u32>,
    tree: Bvh,
}

/// Up to so many bounded objects boxes cost more than they save.
const WITHOUT_TREE: usize = 4;

impl Index {
    /// Arranges these objects.
    pub fn new(objects: &[Object]) -> Index {
        let boxes = (0..).zip(objects).filter_map(|(object, thing)| Some((object, thing.shape.bounds()?)));
        let (bounded, bounds): (Vec<u32>, Vec<_>) = boxes.unzip();
        if bounded.len() <= WITHOUT_TREE {
            return Index { everywhere: (0..objects.len() as u32).collect(), ..Index::default() };
        }
        let has_no_box = |object: &u32| bounded.binary_search(object).is_err();
        let everywhere = (0..objects.len() as u32).filter(has_no_box).collect();
        Index { everywhere, tree: Bvh::new(&bounds), bounded }
    }

    /// Shows `meet` every object that the ray can meet before `t_max`. `meet` gives the new `t_max`; a negative one ends
    /// the search.
    #[inline]
    pub fn visit<P: Probe>(&self, ray: &Ray, probe: &mut P, mut meet: impl FnMut(u32, &mut P) -> f64) {
        let mut t_max = ray.t_max;
        for object in &self.everywhere {
            t_max = meet(*object, probe);
            if t_max < 0.0 {
                return;
            }
        }
        if !self.bounded.is_empty() {
            let tested = self.tree.visit(ray, t_max, |thing| meet(self.bounded[thing as usize], probe));
            probe.bounds_tested(tested);
        }
    }
}
