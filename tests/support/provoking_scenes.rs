//! Scenes made in code, so that what they are to provoke is beside them.

use glam::DVec3;
use raywalk::geometry::Shape;
use raywalk::geometry::shape::{Plane, Sphere, SphereMethod};
use raywalk::scene::{
    Algorithm, Camera, Formulas, Index, Light, LightKind, Material, Object, Output, ReflectedScale, Scene, Skip,
    Specular, Tracing, Transfer, Weights,
};

/// What varies between the scenes of this file.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    pub algorithm: Algorithm,
    pub max_depth: u32,
    pub specular: Specular,
    pub formulas: Formulas,
    pub sphere_method: SphereMethod,
    pub reflected_scale: ReflectedScale,
    pub skip: Skip,
}

impl Options {
    /// The defaults of a scene file.
    pub const DEFAULT: Options = Options {
        algorithm: Algorithm::Recursive,
        max_depth: 4,
        specular: Specular::HalfVector,
        formulas: Formulas::Robust,
        sphere_method: SphereMethod::Robust,
        reflected_scale: ReflectedScale::Weight,
        skip: Skip::ALL,
    };
}

/// A scene in which every kind of light meets every kind of surface: a floor that is seen from its front, a wall from its
/// back, glass with water in it, a milky ball with a transmitted local term and an index of its own, a lampshade with
/// that term and no interface at all, and an opaque ball; a light that fades, one that does not, one behind the balls,
/// and the sun.
pub fn everything(name: &str, eye: [f64; 3], options: Options) -> Scene {
    let plain = Material {
        ambient: DVec3::new(0.2, 0.3, 0.1),
        diffuse: DVec3::new(0.7, 0.5, 0.4),
        specular: DVec3::new(0.3, 0.6, 0.2),
        transmission: DVec3::ZERO,
        shininess: 17.0,
        transmission_exponent: 1.0,
        ior: 1.0,
        weights: Weights { local: DVec3::ONE, reflected: DVec3::ZERO, transmitted: DVec3::ZERO },
        gloss_exponent: None,
        translucency_exponent: None,
        zones: 1,
        pattern: None,
    };
    let mirror = Material { weights: weights([1.0, 0.4, 0.0]), ..plain.clone() };
    let glass = Material { ior: 1.5, weights: weights([0.1, 0.2, 0.8]), ..plain.clone() };
    let water = Material { ior: 1.33, weights: weights([0.1, 0.1, 0.9]), ..plain.clone() };
    let milky = Material {
        transmission: DVec3::new(0.6, 0.7, 0.5),
        transmission_exponent: 3.0,
        weights: weights([0.8, 0.0, 0.2]),
        ..glass.clone()
    };
    let lampshade = Material { ior: 1.0, weights: weights([1.0, 0.0, 0.0]), ..milky.clone() };
    let sphere =
        |center: [f64; 3], radius| Shape::Sphere(Sphere::new(center.into(), radius, false, options.sphere_method));
    let plane = |coefficients| Shape::Plane(Plane::new(coefficients));
    let object = |name: &str, shape, material| Object {
        name: name.into(),
        shape,
        material,
        one_sided: false,
        slack: 0.0,
        inside: None,
    };
    indexed(Scene {
        camera: Camera::new(eye.into(), DVec3::new(0.1, -0.2, -1.0), DVec3::Y, 60.0, [48, 36]),
        background: DVec3::new(0.2, 0.2, 0.3),
        lights: vec![
            point("near", [4.0, 5.0, 2.0], [0.9, 0.8, 0.7], Some([0.5, 0.1, 0.02])),
            point("behind", [-2.0, 4.0, -9.0], [0.5, 0.6, 0.9], None),
            point("in the water", [0.0, 1.0, -4.25], [0.3, 0.3, 0.3], None),
            Light {
                name: "sun".into(),
                kind: LightKind::Directional { travel: DVec3::new(-0.6, -0.8, 0.0) },
                color: DVec3::new(0.4, 0.4, 0.2),
                attenuation: None,
            },
        ],
        materials: vec![plain, mirror, glass, water, milky, lampshade],
        objects: vec![
            object("floor", plane([0.0, 2.0, 0.0, 2.0]), 1),
            object("wall", plane([0.1, 0.0, -1.0, -12.0]), 0),
            object("glass", sphere([0.0, 1.0, -4.0], 1.5), 2),
            object("water", sphere([0.0, 1.0, -4.25], 0.75), 3),
            object("milky", sphere([2.5, 0.5, -6.0], 1.25), 4),
            object("lampshade", sphere([-3.0, 0.75, -6.0], 1.25), 5),
            object("opaque", sphere([-1.5, -0.25, -2.5], 0.5), 0),
        ],
        ..bare(name, options)
    })
}

/// A flat lampshade without an interface, at z = 0, and a light straight behind it. An eye opposite the light sees it
/// through the shade, where the transmitted lobe has narrowed to the straight line.
pub fn straight_through(options: Options) -> Scene {
    let shade = Material {
        ambient: DVec3::splat(0.1),
        diffuse: DVec3::splat(0.5),
        specular: DVec3::splat(0.5),
        transmission: DVec3::new(0.6, 0.7, 0.5),
        shininess: 4.0,
        transmission_exponent: 3.0,
        ior: 1.0,
        weights: weights([1.0, 0.0, 0.0]),
        gloss_exponent: None,
        translucency_exponent: None,
        zones: 1,
        pattern: None,
    };
    indexed(Scene {
        lights: vec![point("behind", [0.0, 0.0, -4.0], [1.0, 0.5, 0.25], None)],
        materials: vec![shade],
        objects: vec![Object {
            name: "shade".into(),
            shape: Shape::Plane(Plane::new([0.0, 0.0, 1.0, 0.0])),
            material: 0,
            one_sided: false,
            slack: 0.0,
            inside: None,
        }],
        ..bare("straight through", options)
    })
}

/// The scene with the index of its objects.
fn indexed(scene: Scene) -> Scene {
    Scene { index: Index::new(&scene.objects), ..scene }
}

fn bare(name: &str, options: Options) -> Scene {
    Scene {
        name: name.to_owned(),
        digest: String::new(),
        camera: Camera::new(DVec3::new(0.0, 0.0, 4.0), DVec3::NEG_Z, DVec3::Y, 45.0, [16, 12]),
        ambient: DVec3::new(0.2, 0.25, 0.3),
        background: DVec3::ZERO,
        effects: Default::default(),
        lights: Vec::new(),
        materials: Vec::new(),
        objects: Vec::new(),
        index: Index::default(),
        around_eye: Default::default(),
        ceilings: Default::default(),
        sampling: raywalk::scene::Sampling::Center {},
        seed: 0,
        frame: None,
        tracing: Tracing {
            algorithm: options.algorithm,
            max_depth: options.max_depth,
            specular: options.specular,
            formulas: options.formulas,
            sphere_method: options.sphere_method,
            reflected_scale: options.reflected_scale,
            cutoff: 0.0,
            two_sided: true,
            shadows: raywalk::scene::Shadows::PerSurface,
            skip: options.skip,
        },
        output: Output { white: 1.0, transfer: Transfer::Linear, exposure: 0.0 },
    }
}

fn weights([local, reflected, transmitted]: [f64; 3]) -> Weights {
    let [local, reflected, transmitted] = [local, reflected, transmitted].map(DVec3::splat);
    Weights { local, reflected, transmitted }
}

fn point(name: &str, position: [f64; 3], color: [f64; 3], attenuation: Option<[f64; 3]>) -> Light {
    let kind = LightKind::Point { position: position.into() };
    Light { name: name.into(), kind, color: color.into(), attenuation }
}
