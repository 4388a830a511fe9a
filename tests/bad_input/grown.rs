//! Large files of every kind, made from the corpus of the fuzz targets by repeating a piece of one: memory and time are bounded by the bytes
//! that there are.

use crate::corpus::files_of;
use crate::meshes::folder_with_mesh;
use crate::run::{limited_answer, raywalk};
use proptest::prelude::*;
use proptest::sample::Index;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// The size that files grow to.
const GROWN: usize = 2 << 20;

/// What the program has without any input, in bytes.
const PROGRAM: u64 = 32 << 20;

/// The most memory for this many bytes of input, as docs/robustness.md has it, and a third more. Files of this size are within 64 MiB and 8 bytes per byte,
/// whatever is in them; what is asked here is less.
fn most_memory(target: &str, bytes: usize) -> u64 {
    let (fixed, by_the_byte) = match target {
        // Two of them are compared.
        "log" => (64 << 20, 2 * 8),
        "scene" => (12 << 20, 16),
        "nff" => (12 << 20, 30),
        _ => (12 << 20, 32),
    };
    let most = PROGRAM + fixed + by_the_byte * bytes as u64;
    most.min(PROGRAM + (64 << 20) + 2 * 8 * bytes as u64)
}

/// A program built for tests is several times as slow as a release. Something quadratic would take hours.
const MOST_TIME: Duration = Duration::from_secs(40);

/// The file with a piece of it, whole lines if there are any, repeated until it has grown.
fn grown(file: &[u8], [from, to]: [&Index; 2], by_lines: bool) -> Vec<u8> {
    if file.is_empty() {
        return Vec::new();
    }
    let (from, to) = (from.index(file.len()), to.index(file.len()));
    let mut piece = from.min(to)..from.max(to) + 1;
    if by_lines {
        let is_end = |byte: &u8| *byte == b'\n';
        piece.start = file[..piece.start].iter().rposition(is_end).map_or(0, |end| end + 1);
        piece.end = file[piece.end - 1..].iter().position(is_end).map_or(file.len(), |end| piece.end + end);
    }
    let count = GROWN.saturating_sub(file.len()) / piece.len();
    let mut grown = file[..piece.start].to_vec();
    grown.extend(file[piece.clone()].repeat(count.max(1)));
    grown.extend(&file[piece.end..]);
    grown
}

/// Gives the file to each of the commands that read its kind.
fn is_bounded(target: &str, file: &[u8]) {
    let commands: &[&[&str]] = match target {
        "log" => &[&["walk", "--plain", "grown"], &["trace", "grown", "--format", "html"], &["diff", "grown", "grown"]],
        // `check` traces, too, which takes as long as lights and surfaces in one place make it.
        "scene" | "nff" => &[&["scene", "show", "grown"]],
        _ => &[&["scene", "check", "t.json"]],
    };
    let name = match target {
        "obj" | "ply" => format!("grown.{target}"),
        _ => "grown".to_owned(),
    };
    let folder = folder_with_mesh(&name);
    fs::write(folder.path().join(&name), file).expect("a file");
    for arguments in commands {
        let answer = limited_answer(&mut raywalk(folder.path(), arguments), MOST_TIME);
        assert!(
            answer.peak <= most_memory(target, file.len()) >> 10,
            "{arguments:?}: took {} KiB of memory",
            answer.peak
        );
        let ends = matches!(answer.code, Some(0..=3));
        assert!(ends, "{arguments:?}: {:?} {}", answer.code, answer.message);
    }
}

/// Of a picture the pixels are what was packed, in a few bytes if they are alike; `memory.rs` has what lies beside them.
const TARGETS: [&str; 5] = ["scene", "nff", "obj", "ply", "log"];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, max_shrink_iters: 0, ..ProptestConfig::with_cases(60) })]

    #[test]
    fn large_files_take_bounded_memory_and_time(
        target in proptest::sample::select(&TARGETS[..]),
        which in any::<Index>(),
        piece in any::<[Index; 2]>(),
        by_lines in any::<bool>(),
    ) {
        let files = files_of(target);
        if !files.is_empty() {
            let found = which.get(&files);
            let file = grown(&found.bytes, [&piece[0], &piece[1]], by_lines);
            let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join("grown");
            fs::write(&kept, &file).expect("a file");
            let is_good = std::panic::catch_unwind(|| is_bounded(target, &file)).is_ok();
            prop_assert!(is_good, "{target}: {}, grown to {}", found.path.display(), kept.display());
        }
    }
}
