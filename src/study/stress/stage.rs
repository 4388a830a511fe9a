//! Cases as scenes: the shapes of a case become shapes of the program's own scene, and rays go through its own tracing.

use super::question::{
    LightInput, MaterialInput, ObjectInput, RayInput, SceneInput, ShadowInput, ShapeInput, SpecularInput,
};
use super::way::Way;
use crate::geometry::shape::{Ellipsoid, Plane, Sphere, Triangle, TriangleMesh};
use crate::geometry::{Leaving, Ray, Shape, Surface};
use crate::log::{Name, RayKind, Step, Value};
use crate::probe::{Probe, Quantity};
use crate::scene::{
    Algorithm, AroundEye, Camera, Effects, Index, Light, LightKind, Material, Object, Output, ReflectedScale, Sampling,
    Scene, Shadows, Skip, Specular, Tracing, Transfer, Weights,
};
use crate::trace::query::Query;
use crate::trace::{Hit, closest_hit};
use glam::DVec3;
use std::collections::HashMap;
use std::sync::Arc;

/// A scene of these shapes, of a plain material, without lights.
pub(super) fn scene_of(way: &Way, shapes: Vec<Shape>) -> Scene {
    let plain = material(&MaterialInput::default());
    let objects: Vec<_> = shapes
        .into_iter()
        .enumerate()
        .map(|(number, shape)| Object {
            slack: shape.slack(),
            name: number.to_string().into(),
            shape,
            material: 0,
            one_sided: false,
            inside: None,
        })
        .collect();
    Scene {
        name: "stress".to_owned(),
        digest: String::new(),
        camera: Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 45.0, [1, 1]),
        ambient: DVec3::ZERO,
        background: DVec3::ZERO,
        effects: Effects::default(),
        lights: Vec::new(),
        materials: vec![plain],
        ceilings: Default::default(),
        index: Index::new(&objects),
        around_eye: AroundEye::Nothing,
        objects,
        tracing: Tracing {
            algorithm: Algorithm::Recursive,
            max_depth: 4,
            specular: Specular::HalfVector,
            formulas: way.formulas(),
            sphere_method: way.sphere_method(),
            reflected_scale: ReflectedScale::Weight,
            cutoff: 0.0,
            two_sided: true,
            shadows: Shadows::PerSurface,
            skip: Skip::ALL,
        },
        sampling: Sampling::Center {},
        seed: 0,
        frame: None,
        output: Output { white: 1.0, transfer: Transfer::Linear, exposure: 0.0 },
    }
}

/// A whole scene as a case describes it.
pub(super) fn whole_scene(way: &Way, input: &SceneInput) -> Result<Scene, String> {
    let mut scene = scene_of(way, shapes(way, &input.objects)?);
    scene.materials = input.objects.iter().map(|object| material(&object.mat)).collect();
    for (number, object) in scene.objects.iter_mut().enumerate() {
        object.material = number;
    }
    scene.ambient = input.ambient.into();
    scene.background = input.background.into();
    scene.lights = input.lights.iter().map(light).collect();
    scene.tracing.max_depth = input.max_depth;
    scene.tracing.specular = match input.specular {
        SpecularInput::H => Specular::HalfVector,
        SpecularInput::R => Specular::ReflectionVector,
    };
    scene.tracing.shadows = match input.shadow {
        ShadowInput::PerSurface => Shadows::PerSurface,
        ShadowInput::Opaque => Shadows::Opaque,
    };
    Ok(scene)
}

/// The shapes of objects.
pub(super) fn shapes(way: &Way, objects: &[ObjectInput]) -> Result<Vec<Shape>, String> {
    objects.iter().map(|object| shape(way, &object.shape)).collect()
}

/// The shape of a shape.
pub(super) fn shape(way: &Way, shape: &ShapeInput) -> Result<Shape, String> {
    Ok(match shape {
        ShapeInput::Sphere { c, r } => sphere(way, *c, *r),
        ShapeInput::Plane { abcd } => Shape::Plane(Plane::new(*abcd)),
        ShapeInput::Triangle { v0, v1, v2 } => Shape::Triangle(Box::new(Triangle::new([*v0, *v1, *v2], None))),
        ShapeInput::Mesh(data) => Shape::Mesh(Arc::new(TriangleMesh::new(Arc::new(data.mesh()?)))),
        ShapeInput::Ellipsoid { m } => {
            let column = |i: usize| DVec3::new(m[0][i], m[1][i], m[2][i]);
            let axes = [column(0), column(1), column(2)];
            let ellipsoid = Ellipsoid::with_axes(column(3), axes).ok_or("the axes of the ellipsoid lie in a plane")?;
            Shape::Ellipsoid(Box::new(ellipsoid))
        }
    })
}

/// A sphere, which is met by the formulas of the way.
pub(super) fn sphere(way: &Way, center: [f64; 3], radius: f64) -> Shape {
    Shape::Sphere(Sphere::new(center.into(), radius, false, way.sphere_method()))
}

/// A material as the scene has it.
pub(super) fn material(input: &MaterialInput) -> Material {
    Material {
        gloss_exponent: None,
        translucency_exponent: None,
        zones: 1,
        pattern: None,
        ambient: input.ka.into(),
        diffuse: input.kd.into(),
        specular: input.ke.into(),
        transmission: input.kt.into(),
        shininess: input.n,
        transmission_exponent: input.nt,
        ior: input.ior,
        weights: Weights {
            local: DVec3::splat(input.wl),
            reflected: DVec3::splat(input.wr),
            transmitted: DVec3::splat(input.wt),
        },
    }
}

fn light(input: &LightInput) -> Light {
    let attenuation = (input.att != [1.0, 0.0, 0.0]).then_some(input.att);
    let kind = LightKind::Point { position: input.p.into() };
    Light { name: "light".into(), kind, color: input.color.into(), attenuation }
}

/// The ray that a query sends for this input.
pub(super) fn ray(way: &Way, scene: &Scene, input: &RayInput) -> Ray {
    let (origin, direction) = (input.o.into(), input.d.into());
    way.ray(Query::new(origin, direction).ray(scene).0)
}

/// What a ray hits first, and the surface there, with what was noted on the way.
pub(super) fn meet(way: &Way, scene: &Scene, ray: &Ray) -> (Option<(Hit, Surface)>, Watch) {
    way.watched(|probe| {
        let hit = closest_hit(scene, ray, probe)?;
        let surface = scene.objects[hit.object as usize].shape.surface(ray, hit.crossing, probe);
        Some((hit, surface))
    })
}

/// The outward normal of a surface, which faces the arriving ray.
pub(super) fn outward(surface: &Surface) -> DVec3 {
    match surface.side {
        crate::geometry::Side::Front => surface.geometric_normal(),
        crate::geometry::Side::Back => -surface.geometric_normal(),
    }
}

/// The surface of a hit, for a ray that leaves it on the side of the arriving ray or on the other one.
pub(super) fn leaving(hit: &Hit, surface: &Surface, on_this_side: bool) -> Leaving {
    let side = if on_this_side { surface.side } else { surface.side.opposite() };
    Leaving { object: hit.object, primitive: hit.crossing.primitive, side }
}

/// Remembers the latest value of every quantity, and counts transmitted rays.
#[derive(Clone, Debug, Default)]
pub(super) struct Watch {
    latest: HashMap<&'static str, Value>,
    /// How many transmitted rays there were.
    pub transmitted_rays: u64,
}

impl Watch {
    /// The latest number noted under this name's key.
    pub fn number(&self, name: Name) -> Option<f64> {
        self.latest.get(name.key()).and_then(|value| value.components().first().copied())
    }

    /// The latest triple noted under this name's key.
    pub fn triple(&self, name: Name) -> Option<[f64; 3]> {
        self.latest.get(name.key()).and_then(|value| value.components().try_into().ok())
    }
}

impl Probe for Watch {
    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        self.latest.insert(name.key(), value.value());
        value
    }

    fn enter(&mut self, step: Step) {
        if let Step::Ray { kind: RayKind::Transmitted, .. } = step {
            self.transmitted_rays += 1;
        }
    }
}
