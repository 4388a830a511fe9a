//! From a checked scene file to a scene that can be traced.

use super::file::converted::converted;
use super::file::mesh::Meshes;
use super::file::schema as file;
use super::profile::CosineProfile;
use super::unsupported::{self, Unsupported};
use super::{
    Adaptive, AreaLight, AroundEye, Camera, Ceilings, Checker, Color, Effects, Formulas, Index, Light, LightKind,
    LightSurface, Material, Object, Scene, Shadows, Skip, Tracing, Weights,
};
use crate::geometry::Shape;
use crate::geometry::mesh::Mesh;
use crate::geometry::motion::{Motion, Turn};
use crate::geometry::shape::{
    Cone, Cuboid, Cylinder, Disk, Ellipsoid, Moving, Plane, Polygon, Sphere, SphereMethod, Triangle, TriangleMesh,
};
use crate::log::FrameId;
use glam::DVec3;
use std::collections::HashMap;
use std::io::{BufWriter, Write};
use std::sync::Arc;

/// What no scene file says of how a scene is traced.
#[derive(Clone, Copy, Debug)]
pub struct Around {
    /// The formulas that the computation implies where the scene names none: one by hand implies those of the notes.
    pub formulas: Formulas,
    /// What is left out because it can't change the picture.
    pub skip: Skip,
    /// Whether every ray is tested with all objects in the order of the scene, as a log of every test wants it.
    pub shows_all_tests: bool,
    /// Which frame of an animation it is; `None` where there is one only.
    pub frame: Option<FrameId>,
}

impl Default for Around {
    fn default() -> Around {
        Around { formulas: Formulas::Robust, skip: Skip::ALL, shows_all_tests: false, frame: None }
    }
}

/// Makes a checked scene file and the meshes that it names ready to be traced, with the robust formulas unless it names others.
pub fn build(scene: &file::SceneFile, meshes: &Meshes) -> Result<Scene, Unsupported> {
    build_with(scene.clone(), meshes, Around::default())
}

/// The same with what the file doesn't say. What the scene file holds is given back while the scene grows: both have room for as many objects, and
/// they aren't there at once.
pub fn build_with(scene: file::SceneFile, meshes: &Meshes, around: Around) -> Result<Scene, Unsupported> {
    let digest = digest(&scene, meshes);
    let tracing = Tracing { skip: around.skip, ..tracing(&scene.tracing, around.formulas) };
    let sphere_method = tracing.sphere_method;
    let (names, of_file) = scene.materials.into_parts();
    // Materials that are one piece of memory in the file are one here, too.
    let mut materials = Vec::new();
    let mut latest: Option<Arc<file::Material>> = None;
    let numbers = converted(of_file, |_, each| {
        if !latest.as_ref().is_some_and(|latest| Arc::ptr_eq(latest, &each)) {
            materials.push(self::material(&each));
        }
        latest = Some(each);
        Ok(materials.len() - 1)
    })?;
    let default_material = materials.len();
    materials.push(self::material(&file::Material::default()));
    let moves = scene.objects.iter().any(|object| object.motion.is_some());
    let mut trees = Trees { meshes, built: HashMap::new() };
    let object = |index: usize, object: file::Object| {
        let named = object.material.and_then(|name| names.get(&name));
        let material = named.map_or(default_material, |place| numbers[*place as usize]);
        let shape = shape(object.shape, sphere_method, index, &mut trees)?;
        let shape = moving(shape, object.motion.as_deref(), index, scene.camera.shutter);
        Ok(Object {
            name: object.name,
            slack: shape.slack(),
            inside: if materials[material].transmits() { shape.inside() } else { None },
            shape,
            one_sided: !scene.tracing.two_sided && !materials[material].lets_light_through(),
            material,
        })
    };
    let objects = converted(scene.objects, object)?;
    let camera = camera(&scene.camera, moves);
    let lights = converted(scene.lights, |_, each| Ok(light(each)))?;
    let built = Scene {
        name: scene.name,
        digest,
        effects: Effects::of(&camera, &lights, &materials),
        around_eye: AroundEye::of(&camera, &objects),
        camera,
        ambient: color(scene.ambient),
        background: color(scene.background),
        lights,
        index: if around.shows_all_tests { Index::of_all(&objects) } else { Index::new(&objects) },
        objects,
        materials,
        tracing,
        ceilings: Ceilings::default(),
        sampling: scene.sampling,
        seed: scene.seed,
        frame: around.frame,
        output: scene.output,
    };
    // What a cutoff may lose is only asked where there is one.
    let ceilings = if built.tracing.cutoff > 0.0 { Ceilings::of(&built) } else { Ceilings::default() };
    Ok(Scene { ceilings, ..built })
}

/// A colour without negative zeros, so that all that is computed from colours is at least +0.
fn color(rgb: impl Into<[f64; 3]>) -> Color {
    Color::from(rgb.into()) + Color::ZERO
}

/// The digest of the resolved scene and the files of its meshes, as a log's header names it.
fn digest(scene: &file::SceneFile, meshes: &Meshes) -> String {
    let mut hasher = blake3::Hasher::new();
    // Through a buffer, so that the text of a large scene isn't there as a whole. Writing plain numbers and strings to it can't fail.
    let mut text = BufWriter::with_capacity(1 << 16, &mut hasher);
    let _ = serde_json::to_writer(&mut text, scene).and_then(|()| text.flush().map_err(serde_json::Error::io));
    drop(text);
    for (path, digest) in meshes.digests() {
        hasher.update(path.as_bytes()).update(digest.as_bytes());
    }
    format!("blake3:{}", hasher.finalize().to_hex())
}

/// The meshes with trees over them, one for each file, however many objects have it.
struct Trees<'m> {
    meshes: &'m Meshes,
    /// By the place of the mesh in memory, which is the same under all names of its file.
    built: HashMap<*const Mesh, Arc<TriangleMesh>>,
}

impl Trees<'_> {
    fn get(&mut self, path: &str) -> Option<Shape> {
        let mesh = self.meshes.get(path)?;
        let tree = self.built.entry(Arc::as_ptr(mesh)).or_insert_with(|| Arc::new(TriangleMesh::new(mesh.clone())));
        Some(Shape::Mesh(tree.clone()))
    }
}

fn camera(camera: &file::Camera, moves: bool) -> Camera {
    let direction = DVec3::from(camera.direction());
    let resolution = camera.resolution;
    let mut built = Camera::new(camera.position.into(), direction, camera.up.into(), camera.vertical_fov, resolution);
    built.shutter = moves.then_some(camera.shutter);
    built.lens = camera.lens;
    built
}

fn light(light: file::Light) -> Light {
    let kind = match light.kind {
        file::LightKind::Point(file::PointLight { position }) => LightKind::Point { position: position.into() },
        file::LightKind::Directional(file::DirectionalLight { direction }) => {
            let direction = DVec3::from(direction);
            LightKind::Directional { travel: direction / direction.length() }
        }
        file::LightKind::Rectangle(file::RectangleLight { corner, edge_u, edge_v }) => {
            area(LightSurface::rectangle(corner.into(), edge_u.into(), edge_v.into()), &light)
        }
        file::LightKind::Disk(file::DiskLight { center, normal, radius }) => {
            area(LightSurface::disk(center.into(), normal.into(), radius), &light)
        }
        file::LightKind::Sphere(file::SphereLight { center, radius }) => {
            area(LightSurface::Sphere { center: center.into(), radius }, &light)
        }
    };
    let fades = !matches!(kind, LightKind::Directional { .. }) && light.attenuation != [1.0, 0.0, 0.0];
    let attenuation = fades.then_some(light.attenuation);
    Light { name: light.name, kind, color: color(light.color), attenuation }
}

fn area(surface: LightSurface, light: &file::Light) -> LightKind {
    let profile = match light.profile {
        Some(file::Profile::CosinePower(power)) if power > 0.0 => Some(CosineProfile::new(power)),
        _ => None,
    };
    let by = light.by.unwrap_or_default();
    let (samples, adaptive) = match light.samples {
        None => (1, None),
        Some(file::LightSamples::Count(samples)) => (samples, None),
        Some(file::LightSamples::Range { min, max }) => (max, Some(Adaptive::new(&surface, by, min))),
    };
    LightKind::Area(Box::new(AreaLight { surface, profile, samples, by, adaptive }))
}

pub(super) fn material(material: &file::Material) -> Material {
    Material {
        ambient: color(material.ambient),
        diffuse: color(material.diffuse),
        specular: color(material.specular),
        transmission: color(material.transmission),
        shininess: material.shininess,
        transmission_exponent: material.transmission_exponent,
        ior: material.ior,
        weights: Weights {
            local: color(material.weights.local.rgb()),
            reflected: color(material.weights.reflected.rgb()),
            transmitted: color(material.weights.transmitted.rgb()),
        },
        gloss_exponent: material.gloss_exponent,
        translucency_exponent: material.translucency_exponent,
        zones: next_square(material.samples),
        pattern: material.pattern.as_deref().map(|file::Pattern::Checker(checker)| {
            Box::new(Checker { a: color(checker.a), b: color(checker.b), size: checker.size })
        }),
    }
}

/// The shape with its motion, if it has one.
fn moving(shape: Shape, motion: Option<&file::Motion>, index: usize, shutter: [f64; 2]) -> Shape {
    let Some(motion) = motion else { return shape };
    let turn = motion
        .rotation
        .as_ref()
        .map(|rotation| Turn::new(rotation.axis.into(), rotation.point.into(), rotation.degrees));
    let motion = Motion { translation: motion.translation.into(), turn };
    Shape::Moving(Box::new(Moving::new(shape, motion, index as u32, shutter)))
}

/// The next square number.
fn next_square(n: u32) -> u32 {
    let root = libm::sqrt(f64::from(n)) as u32;
    if root * root < n { (root + 1) * (root + 1) } else { root * root }
}

fn shape(
    shape: file::Shape,
    sphere_method: SphereMethod,
    index: usize,
    trees: &mut Trees,
) -> Result<Shape, Unsupported> {
    Ok(match shape {
        file::Shape::Plane(plane) => Shape::Plane(Plane::new(plane.coefficients)),
        file::Shape::Sphere(sphere) => {
            Shape::Sphere(Sphere::new(sphere.center.into(), sphere.radius, sphere.inward, sphere_method))
        }
        file::Shape::Ellipsoid(ellipsoid) => Shape::Ellipsoid(Box::new(Ellipsoid::new(
            ellipsoid.center.into(),
            ellipsoid.radii.into(),
            ellipsoid.rotation.map(|rows| *rows),
        ))),
        file::Shape::Triangle(triangle) => {
            Shape::Triangle(Box::new(Triangle::new(triangle.vertices, triangle.normals.map(|normals| *normals))))
        }
        file::Shape::Polygon(polygon) => {
            Shape::Polygon(Box::new(Polygon::of(polygon.vertices, polygon.normals.as_deref())))
        }
        file::Shape::Box(cuboid) => Shape::Cuboid(Cuboid::new(cuboid.min.into(), cuboid.max.into())),
        file::Shape::Cylinder(cylinder) => {
            let (base, apex) = (cylinder.base.into(), cylinder.apex.into());
            Shape::Cylinder(Box::new(Cylinder::new(base, apex, cylinder.radius, cylinder.caps, cylinder.inward)))
        }
        file::Shape::Cone(cone) => {
            let (base, apex) = ((cone.base.into(), cone.base_radius), (cone.apex.into(), cone.apex_radius));
            Shape::Cone(Box::new(Cone::new(base, apex, cone.caps, cone.inward)))
        }
        file::Shape::Disk(disk) => {
            Shape::Disk(Box::new(Disk::new(disk.center.into(), disk.normal.into(), disk.radius)))
        }
        file::Shape::Mesh(mesh) => trees.get(&mesh.path).ok_or_else(|| unsupported::not_loaded(index))?,
    })
}

pub(super) fn tracing(tracing: &file::Tracing, implied: Formulas) -> Tracing {
    let formulas = tracing.formulas.unwrap_or(implied);
    let implied = match formulas {
        Formulas::Robust => SphereMethod::Robust,
        Formulas::Notes => SphereMethod::Geometric,
    };
    Tracing {
        algorithm: tracing.algorithm,
        max_depth: tracing.max_depth,
        specular: tracing.specular,
        formulas,
        sphere_method: tracing.sphere_method.unwrap_or(implied),
        reflected_scale: tracing.reflected_scale,
        cutoff: tracing.cutoff,
        two_sided: tracing.two_sided,
        shadows: Shadows::PerSurface,
        skip: Skip::ALL,
    }
}
