//! What goes into the cases, typed.

use crate::geometry::Mesh;
use glam::DVec3;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// A triple of numbers.
pub(super) type Triple = [f64; 3];

/// The input of a case as this type.
pub(super) fn input<T: DeserializeOwned>(input: &Map<String, Value>) -> Result<T, String> {
    let value = Value::Object(input.clone());
    serde_path_to_error::deserialize(value).map_err(|error| match error.path().to_string().as_str() {
        "." => format!("in: {}", error.inner()),
        path => format!("in.{path}: {}", error.inner()),
    })
}

/// What goes into a case under this key. What is absent is null.
pub(super) fn field<T: DeserializeOwned>(case: &Map<String, Value>, key: &str) -> Result<T, String> {
    let value = case.get(key).cloned().unwrap_or_default();
    serde_path_to_error::deserialize(value).map_err(|error| match error.path().to_string().as_str() {
        "." => format!("in.{key}: {}", error.inner()),
        path => format!("in.{key}.{path}: {}", error.inner()),
    })
}

/// What goes into it under each of these keys, all of one type.
pub(super) fn fields<T: Copy + Default + DeserializeOwned, const N: usize>(
    case: &Map<String, Value>,
    keys: [&str; N],
) -> Result<[T; N], String> {
    let mut found = [T::default(); N];
    for (found, key) in found.iter_mut().zip(keys) {
        *found = field(case, key)?;
    }
    Ok(found)
}

/// A ray: from `o` along `d`, of any length.
#[derive(Clone, Copy, Debug, Deserialize)]
pub(super) struct RayInput {
    pub o: Triple,
    pub d: Triple,
}

/// A shape.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(super) enum ShapeInput {
    Sphere { c: Triple, r: f64 },
    Plane { abcd: [f64; 4] },
    Triangle { v0: Triple, v1: Triple, v2: Triple },
    Mesh(MeshData),
    Ellipsoid { m: [[f64; 4]; 3] },
}

/// A mesh: corners, and the triangles between them.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct MeshData {
    pub v: Vec<Triple>,
    pub f: Vec<[u32; 3]>,
}

impl MeshData {
    /// The mesh, if its triangles name corners that there are.
    pub fn mesh(&self) -> Result<Mesh, String> {
        let count = self.v.len();
        if let Some(face) = self.f.iter().find(|face| face.iter().any(|corner| *corner as usize >= count)) {
            return Err(format!("mesh.f: {face:?} names a corner that isn't one of the {count}"));
        }
        let positions = self.v.iter().copied().map(DVec3::from).collect();
        Ok(Mesh { positions, normals: None, faces: self.f.clone() })
    }
}

/// A shape and what it is made of.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct ObjectInput {
    #[serde(flatten)]
    pub shape: ShapeInput,
    #[serde(default)]
    pub mat: MaterialInput,
}

/// A material, in the letters of the source text.
#[derive(Clone, Debug, Deserialize)]
#[serde(default)]
pub(super) struct MaterialInput {
    pub ka: Triple,
    pub kd: Triple,
    pub ke: Triple,
    pub kt: Triple,
    pub n: f64,
    pub nt: f64,
    pub ior: f64,
    pub wl: f64,
    pub wr: f64,
    pub wt: f64,
}

impl Default for MaterialInput {
    fn default() -> MaterialInput {
        let none = [0.0; 3];
        MaterialInput { ka: none, kd: none, ke: none, kt: none, n: 1.0, nt: 1.0, ior: 1.0, wl: 1.0, wr: 0.0, wt: 0.0 }
    }
}

/// A light at a point.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct LightInput {
    pub p: Triple,
    pub color: Triple,
    pub att: Triple,
}

/// A whole scene.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct SceneInput {
    pub max_depth: u32,
    pub specular: SpecularInput,
    pub shadow: ShadowInput,
    pub background: Triple,
    pub ambient: Triple,
    pub lights: Vec<LightInput>,
    pub objects: Vec<ObjectInput>,
}

/// The specular term: with H or with R.
#[derive(Clone, Copy, Debug, Deserialize)]
pub(super) enum SpecularInput {
    H,
    R,
}

/// What a transparent object does to light.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ShadowInput {
    PerSurface,
    Opaque,
}

/// A number that JSON may have no way to write: `"nan"`, `"inf"` and `"-inf"` are read too.
pub(super) fn any_number(case: &Map<String, Value>, key: &str) -> Result<f64, String> {
    case.get(key).and_then(any).ok_or_else(|| format!("in.{key}: expected a number"))
}

/// As [`any_number`], of a value.
pub(super) fn any(value: &Value) -> Option<f64> {
    match value {
        Value::String(text) if text == "nan" => Some(f64::NAN),
        Value::String(text) if text == "inf" => Some(f64::INFINITY),
        Value::String(text) if text == "-inf" => Some(f64::NEG_INFINITY),
        value => value.as_f64(),
    }
}
