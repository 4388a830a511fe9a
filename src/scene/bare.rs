//! Scenes of shapes alone, for ray queries.

use super::file::schema as file;
use super::{AroundEye, Camera, Ceilings, Color, Effects, Formulas, Index, Object, Output, Sampling, Scene, build};
use crate::geometry::Shape;
use crate::threads::share;
use compact_str::CompactString;
use glam::DVec3;
use rayon::prelude::*;

impl Scene {
    /// A scene of these shapes alone, which is only asked about rays: two-sided, dark, in the default material, seen by nobody. Objects
    /// have no names, so that a million of them cost no more than their shapes.
    pub fn of_shapes(
        name: &str,
        shapes: impl IntoParallelIterator<Iter = impl IndexedParallelIterator<Item = Shape>, Item = Shape>,
    ) -> Scene {
        let object = |shape| Object {
            name: CompactString::default(),
            slack: Shape::slack(&shape),
            shape,
            material: 0,
            one_sided: false,
            inside: None,
        };
        let shapes = shapes.into_par_iter();
        let objects: Vec<_> = share(shapes.len(), || shapes.map(object).collect());
        Scene {
            name: name.to_owned(),
            digest: String::new(),
            camera: Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 45.0, [1, 1]),
            ambient: Color::ZERO,
            background: Color::ZERO,
            lights: Vec::new(),
            materials: vec![build::material(&file::Material::default())],
            effects: Effects::default(),
            index: Index::new(&objects),
            around_eye: AroundEye::Nothing,
            objects,
            tracing: build::tracing(&file::Tracing::default(), Formulas::Robust),
            ceilings: Ceilings::default(),
            sampling: Sampling::default(),
            seed: 0,
            frame: None,
            output: Output::default(),
        }
    }
}
