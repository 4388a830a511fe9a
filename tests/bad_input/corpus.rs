//! The corpus of the fuzz targets, replayed: what a fuzzer once found is done again with every file, and with files made from
//! them. `docs/robustness.md` says how to fuzz.

use crate::mutator::{changed, changes};
use crate::targets::{TARGETS, Target};
use proptest::prelude::*;
use proptest::sample::Index;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// The largest file of the corpus.
const MAX_FILE: usize = 8 << 10;

/// All of it.
const MAX_CORPUS: usize = 300 << 10;

/// A file of the corpus.
pub struct Found {
    pub path: PathBuf,
    pub bytes: Vec<u8>,
}

/// The files of a target in the order of their names; none where the package comes without its fuzz targets.
pub fn files_of(target: &str) -> Vec<Found> {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz");
    if !fuzz.exists() {
        return Vec::new();
    }
    let folder = fuzz.join("corpus").join(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry of the folder").path()).collect();
    paths.sort();
    assert!(!paths.is_empty(), "{} is empty", folder.display());
    let read = |path: PathBuf| Found { bytes: fs::read(&path).expect("a file of the corpus"), path };
    paths.into_iter().map(read).collect()
}

fn target(name: &str) -> Target {
    *TARGETS.iter().find(|(known, _)| *known == name).expect("a target of this name")
}

/// Does with every file what its fuzz target does. One that takes forever fails: nobody waits for it.
#[track_caller]
fn replays(name: &str) {
    const FOREVER: Duration = Duration::from_secs(240);
    let (_, answer) = target(name);
    for Found { path, bytes } in files_of(name) {
        let (done, waits) = channel();
        let replay = thread::spawn(move || {
            answer(&bytes);
            // Nobody waits any more if it took forever.
            let _ = done.send(());
        });
        match waits.recv_timeout(FOREVER) {
            Err(RecvTimeoutError::Timeout) => panic!("{} takes for ever", path.display()),
            Ok(()) | Err(RecvTimeoutError::Disconnected) => {
                assert!(replay.join().is_ok(), "{} does harm", path.display());
            }
        }
    }
}

#[test]
fn replayed_scenes() {
    replays("scene");
}

#[test]
fn replayed_nff() {
    replays("nff");
}

#[test]
fn replayed_obj() {
    replays("obj");
}

#[test]
fn replayed_ply() {
    replays("ply");
}

#[test]
fn replayed_logs() {
    replays("log");
}

#[test]
fn replayed_packed_files() {
    replays("packed");
}

#[test]
fn replayed_pictures() {
    replays("picture");
}

#[test]
fn every_target_is_a_fuzz_target_and_the_corpus_is_small() {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz");
    if !fuzz.exists() {
        return;
    }
    let mut whole = 0;
    for (name, _) in TARGETS {
        let caller = fs::read_to_string(fuzz.join(format!("fuzz_targets/{name}.rs"))).expect("the fuzz target");
        assert!(caller.contains(&format!("raywalk_fuzz::{name}(bytes)")), "{caller}");
        for Found { path, bytes } in files_of(name) {
            assert!(bytes.len() <= MAX_FILE, "{}: {} bytes", path.display(), bytes.len());
            whole += bytes.len();
        }
    }
    assert!(whole <= MAX_CORPUS, "{whole} bytes");
    let count = |folder: &str| fs::read_dir(fuzz.join(folder)).expect("a folder").count();
    assert_eq!([count("fuzz_targets"), count("corpus")], [TARGETS.len(); 2]);
}

/// What means something to some of the readers.
const WORDS: &[&str] = &[
    "-1",
    "0",
    "1e-320",
    "1e150",
    "1e999",
    "nan",
    "4294967296",
    "\n",
    " ",
    "[",
    "]",
    "{",
    "}",
    ",",
    "\"",
    "null",
    "#",
    "\0",
];

static CORPUS: LazyLock<Vec<(Target, Vec<Found>)>> =
    LazyLock::new(|| TARGETS.iter().map(|target| (*target, files_of(target.0))).collect());

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

    #[test]
    fn damaged_files_of_the_corpus(changes in changes(WORDS), which in any::<Index>(), file in any::<Index>()) {
        let ((name, answer), files) = which.get(&CORPUS);
        if !files.is_empty() {
            let Found { path, bytes } = file.get(files);
            let damaged = changed(bytes, &changes);
            let answers = std::panic::catch_unwind(|| answer(&damaged)).is_ok();
            prop_assert!(answers, "{}: {} changed to {:?}", name, path.display(), damaged);
        }
    }
}
