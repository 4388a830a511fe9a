//! The same bytes everywhere: in debug and in release, for any processor, on any number of threads.
//!
//! The digests are pinned. `.ci/run` asks a program built with all optimizations for this machine's own processor for them, too,
//! by naming it in `RAYWALK_PROGRAM`; one that may not use the processor's best instructions (`RAYWALK_LANES=plain`); and one on a
//! processor, emulated, that has none of them.

#[path = "support/random.rs"]
mod random;
#[path = "support/random_scenes.rs"]
mod random_scenes;
mod support;

use random::Random;
use raywalk::scene::builtin;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::Command;
use support::snapshots;

fn program() -> PathBuf {
    std::env::var_os("RAYWALK_PROGRAM").map_or_else(|| env!("CARGO_BIN_EXE_raywalk").into(), PathBuf::from)
}

/// The digest of a small picture in floats.
fn digest(scene: &str, options: &[&str]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = folder.path().join("a.pfm");
    let mut command = Command::new(program());
    command.args(["render", scene, "--size", "64x48", "-q", "-o"]).arg(&picture).args(options);
    assert!(command.status().expect("it runs").success(), "{scene} {options:?}");
    digest_of(&picture)
}

fn digest_of(picture: &Path) -> String {
    blake3::hash(&std::fs::read(picture).expect("a picture")).to_hex()[..16].to_owned()
}

#[test]
fn pictures_have_the_same_bytes_everywhere() {
    let of_scene = |scene: &str| {
        let one = digest(scene, &["--threads", "1"]);
        assert_eq!(digest(scene, &["--threads", "3"]), one, "{scene} on three threads");
        format!("{one}  {scene}\n")
    };
    let pictures: String = builtin::names().map(of_scene).collect();
    snapshots().bind(|| insta::assert_snapshot!("digests", pictures));
}

#[test]
fn other_arithmetics_have_the_same_bytes_everywhere() {
    let of_arithmetic = |arithmetic: &str| {
        let digest = digest("figure-6", &["--arithmetic", arithmetic]);
        format!("{digest}  {arithmetic}\n")
    };
    let pictures: String = ["f32", "decimal:3", "decimal:15"].into_iter().map(of_arithmetic).collect();
    snapshots().bind(|| insta::assert_snapshot!("digests_of_arithmetics", pictures));
}

/// What a rendering counts, as printed, and a digest of the layer of tests.
fn counts(scene: &Path, lanes: Option<&str>) -> (Value, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = folder.path().join("a.exr");
    let render = |options: &[&str]| {
        let mut command = Command::new(program());
        command.args(["render", "--size", "48x36", "-q", "-o"]).arg(&picture).arg(scene).args(options);
        if let Some(lanes) = lanes {
            command.env("RAYWALK_LANES", lanes);
        }
        let output = command.output().expect("it runs");
        assert!(output.status.success(), "{scene:?} {options:?}: {}", String::from_utf8_lossy(&output.stderr));
        output.stdout
    };
    let mut statistics: Value = serde_json::from_slice(&render(&["--stats", "json"])).expect("JSON");
    render(&["--layers", "tests"]);
    for of_the_machine in ["seconds", "peak_bytes"] {
        statistics.as_object_mut().expect("an object").remove(of_the_machine);
    }
    (statistics, digest_of(&picture))
}

/// Small primitives in a wide space, seen from afar: what is in a box by one more rounding matters most there.
fn tiny_and_far(seed: u64) -> Value {
    let mut random = Random::new(seed);
    let mut place = |size: f64| (random.point() * size).to_array();
    let object = |number: usize| {
        let (at, size) = if number.is_multiple_of(2) { (place(2e-3), 1e-4) } else { (place(1.0), 1e-2) };
        let shape = match number % 4 {
            0 | 1 => json!({"sphere": {"center": at, "radius": size}}),
            _ => {
                json!({"triangle": {"vertices": [at, [at[0] + size, at[1], at[2]], [at[0], at[1] + size, at[2] + size]]}})
            }
        };
        json!({"name": format!("o{number}"), "shape": shape, "material": "m"})
    };
    json!({
        "format": "raywalk-scene/1",
        "camera": {"position": [3.1, 2.5, 3.3], "look_at": [0, 0, 0], "vertical_fov": 0.046, "resolution": [48, 36]},
        "lights": [{"name": "lamp", "point": {"position": [3, 4, 5]}, "color": [1, 1, 1]}],
        "materials": {"m": {"diffuse": [0.5, 0.5, 0.5], "weights": {"local": 1, "reflected": 0.5, "transmitted": 0}}},
        "objects": (0..1200).map(object).collect::<Vec<_>>(),
        "tracing": {"max_depth": 4},
    })
}

/// Filters with fused operations let through fewer boxes and primitives than filters without.
#[test]
fn counts_of_tests_are_the_same_for_every_processor() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: String, text: &[u8]| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).expect("a file");
        file
    };
    let mut scenes = vec![PathBuf::from("mesh")];
    for seed in 0..8 {
        scenes.push(file(format!("tiny-{seed}.json"), tiny_and_far(seed).to_string().as_bytes()));
    }
    for seed in 0..2 {
        scenes.push(file(format!("crowd-{seed}.json"), random_scenes::crowd(seed, 100).to_string().as_bytes()));
    }
    let mut pinned = String::new();
    for scene in &scenes {
        let (statistics, tests) = counts(scene, None);
        assert_eq!(counts(scene, Some("plain")), (statistics.clone(), tests.clone()), "{scene:?}");
        let name = scene.file_stem().expect("a name").to_string_lossy();
        pinned += &format!("{tests}  {name}: {}\n", statistics["tests"]);
    }
    snapshots().bind(|| insta::assert_snapshot!("counts", pinned));
}

#[test]
fn lanes_that_are_not_known_are_refused() {
    let output =
        Command::new(program()).args(["scene", "list"]).env("RAYWALK_LANES", "avx9").output().expect("it runs");
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(
        String::from_utf8_lossy(&output.stderr),
        "error: RAYWALK_LANES is `avx9`, expected `plain` or nothing\n"
    );
}
