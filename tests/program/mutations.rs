//! Broken files, ten thousand for each reader: they are read or refused, and nothing panics or hangs.

use crate::mutator::{changed, changes};
use crate::support::scene;
use proptest::prelude::*;
use raywalk::files::FileError;
use raywalk::log::file::{read, to_json, to_ndjson};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::file::mesh::{self, Meshes};
use raywalk::scene::file::raw::{self, Primitives};
use raywalk::scene::file::{self};
use raywalk::scene::{build, builtin};
use raywalk::study::bench::throughput::{self, Hits, Mode, Passes};
use std::sync::LazyLock;

/// Every message is short, and holds nothing that would do something to a terminal.
fn is_a_message(error: &FileError) -> Result<(), TestCaseError> {
    prop_assert_eq!(error.exit_code(), 2);
    let report = error.report(false);
    let has_control = report.chars().any(|c| c.is_control() && c != '\n');
    prop_assert!(report.len() < 20_000 && !has_control, "{:?}", report);
    Ok(())
}

/// A scene that is accepted can be traced, too.
fn scene_answers(bytes: &[u8], name: &str) -> Result<(), TestCaseError> {
    match file::check(bytes, name) {
        Ok(loaded) => {
            if let Ok(scene) = build(&loaded.scene, &Meshes::default()) {
                let color = record::pixel_color(&scene, [0, 0], Arithmetic::F64);
                prop_assert!(!color.is_nan(), "{}", color);
            }
            Ok(())
        }
        Err(error) => is_a_message(&error),
    }
}

fn mesh_answers(bytes: &[u8], name: &str) -> Result<(), TestCaseError> {
    match mesh::parse(bytes, name) {
        Ok(read) => {
            let count = read.mesh.positions.len() as u32;
            prop_assert!(read.mesh.faces.iter().flatten().all(|corner| *corner < count));
            prop_assert!(read.mesh.positions.iter().all(|position| position.is_finite()));
            for triangle in 0..read.mesh.faces.len() as u32 {
                let _ = read.mesh.corner_normals(triangle);
            }
            Ok(())
        }
        Err(error) => is_a_message(&error),
    }
}

/// Primitives that are accepted can be traced by rays that are accepted.
fn raw_answers(bytes: &[u8]) -> Result<(), TestCaseError> {
    let rays = raw::parse_rays(bytes, "a.rays");
    let primitives = match raw::parse_mesh(bytes, "a.mesh") {
        Ok(mesh) => Ok(Primitives::Mesh(mesh)),
        Err(error) => {
            is_a_message(&error)?;
            raw::parse_spheres(bytes, "a.spheres").map(Primitives::Spheres)
        }
    };
    for error in [rays.as_ref().err(), primitives.as_ref().err()].into_iter().flatten() {
        is_a_message(error)?;
    }
    let rays = rays.or_else(|_| raw::parse_rays(&raw_file(2), "good"));
    let primitives = primitives.or_else(|_| raw::parse_mesh(&raw_file(0), "good").map(Primitives::Mesh));
    if let (Ok(rays), Ok(primitives)) = (rays, primitives) {
        let (scene, _) = throughput::build("a", &primitives, 1);
        let mut hits = Hits::default();
        let [alone, measured] =
            Mode::ALL.map(|mode| throughput::measure(&scene, &rays, mode, 1, Passes::Number(1), &mut hits));
        prop_assert_eq!((alone.hits, alone.t_sum), (measured.hits, measured.t_sum));
        prop_assert!(measured.hits <= rays.rays.len() && hits.t.iter().all(|t| !t.is_nan()));
    }
    Ok(())
}

/// A mesh of two triangles, two spheres, or two rays that hit them.
fn raw_file(which: usize) -> Vec<u8> {
    let floats = |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
    let whole = |numbers: &[u32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
    let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let ray = [0.75, 0.25, 3.0, 0.0, 0.0, 0.0, -1.0, f32::INFINITY];
    match which {
        0 => [b"RWMESH01", &whole(&[4, 0, 2, 0])[..], &floats(&corners), &whole(&[0, 1, 2, 0, 2, 3])].concat(),
        1 => [b"RWSPHR01", &whole(&[2, 0])[..], &floats(&[0.0, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.5])].concat(),
        _ => [b"RWRAYS01", &whole(&[0, 2, 1, 0, 2, 0])[..], &floats(&ray), &floats(&ray)].concat(),
    }
}

fn log_answers(bytes: &[u8]) -> Result<(), TestCaseError> {
    if let Err(error) = read(bytes) {
        let message = error.to_string();
        let has_control = message.chars().any(|c| c.is_control() && c != '\n');
        prop_assert!(message.len() < 1000 && !has_control, "{:?}", message);
    }
    Ok(())
}

const NFF: &str = "# all entities\nb .1 .2 .3\nv from 0 0 9 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 16 12\nl 5 5 9\n\
                   l -5 5 9 .5 .5 1\nf 1 .5 .2 .8 .25 30 .5 1.5\ns 0 0 0 1\nc 0 0 0 1 0 2 0 .5\np 3 0 0 0 1 0 0 0 1 0\n\
                   pp 3 0 0 0 0 0 1 1 0 0 0 1 1 0 1 0 0 0 1\nf 1 1 1 1 0 100000 0 0\ns 1 1 1 -.5\n";

const OBJ: &str = "vn 0 0 1\nvn 0 1 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n\
                   f -1//1 -2//2 -3//-1 \\\n1//1\n";

/// A square with normals as PLY in one of the three encodings.
fn ply(encoding: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat {encoding} 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\n\
         property uchar flags\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 2\n\
         property list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.5], [0.0, 1.0_f32]];
    let is_big = encoding == "binary_big_endian";
    let float = |x: f32| if is_big { x.to_be_bytes() } else { x.to_le_bytes() };
    let double = |x: f64| if is_big { x.to_be_bytes() } else { x.to_le_bytes() };
    let int = |x: i32| if is_big { x.to_be_bytes() } else { x.to_le_bytes() };
    if encoding == "ascii" {
        corners.iter().for_each(|[x, y]| bytes.extend(format!("{x} {y} 0 7 0 0 1\n").as_bytes()));
        bytes.extend(b"3 0 1 2\n3 0 2 3\n");
        return bytes;
    }
    for [x, y] in corners {
        bytes.extend(float(x));
        bytes.extend(double(y.into()));
        bytes.extend(float(0.0));
        bytes.push(7);
        [0.0, 0.0, 1.0].iter().for_each(|n| bytes.extend(float(*n)));
    }
    for face in [[0, 1, 2], [0, 2, 3]] {
        bytes.push(3);
        face.iter().for_each(|corner| bytes.extend(int(*corner)));
    }
    bytes
}

/// The log of a pixel with reflection, refraction and shadows, as lines and as a document.
static LOGS: LazyLock<[Vec<u8>; 2]> = LazyLock::new(|| {
    // In this arithmetic events have numbers of digits too.
    let part = record::Part::Pixel([150, 130]);
    let log = record::bounded(&scene("transmission"), part, Arithmetic::Perturbed(1)).expect("a short log");
    [to_ndjson(&log).expect("memory"), to_json(&log).expect("memory")]
});

const NUMBERS_AND_SIGNS: &[&str] = &[
    "-1",
    "0",
    "1e-320",
    "1e150",
    "1e999",
    "nan",
    "99999999999",
    "4294967296",
    "\n",
    "\r",
    " ",
    "\\\n",
    "#",
    "/",
    "\0",
];
const JSON: &[&str] = &[
    "null",
    "true",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "{}",
    "[]",
    "-0",
    "1e-320",
    "1e150",
    "1e999",
    "-1",
    "256",
    "\"radius\":",
    "\"sphere\":",
    "\"plane\":",
    "\\ud800",
    "\u{feff}",
    "//",
    "\"node\":",
    "\"enter\":",
    "\"leave\":{}",
];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(10_000) })]

    #[test]
    fn scenes(changes in changes(JSON), which in 0..3_usize) {
        let name = ["textbook", "transmission", "total-reflection"][which];
        let text = builtin::text(name).expect("a built-in scene");
        scene_answers(&changed(text.as_bytes(), &changes), "a.json")?;
    }

    #[test]
    fn nff(changes in changes(NUMBERS_AND_SIGNS)) {
        scene_answers(&changed(NFF.as_bytes(), &changes), "a.nff")?;
    }

    #[test]
    fn obj(changes in changes(NUMBERS_AND_SIGNS)) {
        mesh_answers(&changed(OBJ.as_bytes(), &changes), "a.obj")?;
    }

    #[test]
    fn meshes_as_ply(changes in changes(NUMBERS_AND_SIGNS), encoding in 0..3_usize) {
        let encoding = ["ascii", "binary_little_endian", "binary_big_endian"][encoding];
        mesh_answers(&changed(&ply(encoding), &changes), "a.ply")?;
    }

    #[test]
    fn raw_files(changes in changes(NUMBERS_AND_SIGNS), which in 0..3_usize) {
        raw_answers(&changed(&raw_file(which), &changes))?;
    }

    #[test]
    fn logs(changes in changes(JSON)) {
        log_answers(&changed(&LOGS[0], &changes))?;
    }

    #[test]
    fn logs_as_documents(changes in changes(JSON)) {
        log_answers(&changed(&LOGS[1], &changes))?;
    }

    #[test]
    fn any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        for name in ["a.json", "a.nff", "a"] {
            scene_answers(&bytes, name)?;
        }
        for name in ["a.obj", "a.ply"] {
            mesh_answers(&bytes, name)?;
        }
        log_answers(&bytes)?;
        raw_answers(&bytes)?;
    }
}

#[test]
fn what_is_damaged_was_whole() {
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        assert_eq!(mesh::parse(&ply(encoding), "a.ply").expect("a mesh").mesh.faces.len(), 2);
    }
    assert_eq!(mesh::parse(OBJ.as_bytes(), "a.obj").expect("a mesh").mesh.faces.len(), 4);
    assert_eq!(file::check(NFF.as_bytes(), "a.nff").expect("a scene").scene.objects.len(), 5);
    assert_eq!(raw::parse_mesh(&raw_file(0), "a").expect("a mesh").faces.len(), 2);
    assert_eq!(raw::parse_spheres(&raw_file(1), "a").expect("spheres").len(), 2);
    assert_eq!(raw::parse_rays(&raw_file(2), "a").expect("rays").rays.len(), 2);
    for log in LOGS.iter() {
        assert!(read(log).expect("a log").log.events.len() > 50);
    }
}
