//! The yardstick's scene, from the numbers of a scene file.

use super::shapes::{Plane, Shape, Sphere};
use super::{Light, Material, Object, Rules, Yardstick, unit};
use glam::DVec3;
use raywalk::geometry::shape::SphereMethod;
use raywalk::scene::file::schema as file;

impl Yardstick {
    /// The scene, by the program's default rules of what is left out.
    pub fn new(scene: &file::SceneFile) -> Yardstick {
        let camera = &scene.camera;
        let forward = DVec3::from(camera.direction());
        let right = forward.cross(camera.up.into());
        let half_height = libm::tan(camera.vertical_fov.to_radians() / 2.0);
        let mut materials: Vec<_> = scene.materials.iter().map(|(_, material)| material.clone()).collect();
        materials.push(file::Material::default());
        Yardstick {
            eye: camera.position.into(),
            forward,
            length: forward.length(),
            right: unit(right),
            up: unit(right.cross(forward)),
            pixel_side: 2.0 * half_height / f64::from(camera.resolution[1]),
            resolution: camera.resolution,
            ambient: scene.ambient.into(),
            background: scene.background.into(),
            lights: scene.lights.iter().map(Light::new).collect(),
            materials: materials.iter().map(Material::new).collect(),
            objects: scene.objects.iter().map(|object| Object::new(object, scene)).collect(),
            rules: Rules {
                algorithm: scene.tracing.algorithm,
                specular: scene.tracing.specular,
                max_depth: scene.tracing.max_depth,
                cutoff: scene.tracing.cutoff,
                skips_zero_weight: true,
                skips_no_local_term: true,
                skips_blocked: true,
                skips_cutoff: true,
            },
        }
    }
}

impl Light {
    fn new(light: &file::Light) -> Light {
        let color = light.color.into();
        match light.kind {
            file::LightKind::Point(file::PointLight { position }) => {
                let fading = (light.attenuation != [1.0, 0.0, 0.0]).then_some(light.attenuation);
                Light::Point { position: position.into(), color, fading }
            }
            file::LightKind::Directional(file::DirectionalLight { direction }) => {
                Light::Sun { toward: -unit(direction.into()), color }
            }
            _ => panic!("the yardstick has no light `{}`", light.kind.key()),
        }
    }
}

impl Object {
    fn new(object: &file::Object, scene: &file::SceneFile) -> Object {
        let shape = match object.shape {
            file::Shape::Plane(file::Plane { coefficients: [a, b, c, d] }) => {
                let normal = DVec3::new(a, b, c);
                Shape::Plane(Plane { normal, offset: d, unit_normal: unit(normal) })
            }
            file::Shape::Sphere(file::Sphere { center, radius, inward }) => {
                let is_geometric = scene.tracing.sphere_method == Some(SphereMethod::Geometric);
                Shape::Sphere(Sphere {
                    center: center.into(),
                    radius,
                    radius_squared: radius * radius,
                    is_geometric,
                    is_hollow: inward,
                })
            }
            _ => panic!("the yardstick has no shape `{}`", object.shape.key()),
        };
        let named = object.material.as_deref().and_then(|name| scene.materials.index_of(name));
        let of_file = named.and_then(|number| scene.materials.iter().nth(number));
        let is_opaque = of_file.is_none_or(|(_, material)| {
            let material = Material::new(material);
            material.transmitted == DVec3::ZERO && material.transmission == DVec3::ZERO
        });
        let is_one_sided = is_opaque && !scene.tracing.two_sided;
        Object { shape, material: named.unwrap_or(scene.materials.len()), is_one_sided }
    }
}

impl Material {
    fn new(material: &file::Material) -> Material {
        let weight = |weight: file::Weight| DVec3::from(weight.rgb());
        Material {
            ambient: material.ambient.into(),
            diffuse: material.diffuse.into(),
            specular: material.specular.into(),
            transmission: material.transmission.into(),
            shininess: material.shininess,
            transmission_exponent: material.transmission_exponent,
            ior: material.ior,
            local: weight(material.weights.local),
            reflected: weight(material.weights.reflected),
            transmitted: weight(material.weights.transmitted),
        }
    }
}
