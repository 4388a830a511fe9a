//! The same bytes everywhere: in debug and in release, for any processor, on any number of threads.
//!
//! The digests are pinned. `.ci/run` asks a program built with all optimizations for this machine's own processor for them, too,
//! by naming it in `RAYWALK_PROGRAM`.

mod support;

use raywalk::scene::builtin;
use std::path::PathBuf;
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
    blake3::hash(&std::fs::read(&picture).expect("a picture")).to_hex()[..16].to_owned()
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
