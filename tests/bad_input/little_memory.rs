//! Little memory, at many levels: a result or a message with exit code 3, and no half of a result.

use crate::run::{names_in, raywalk, raywalk_after};
use std::fs;
use std::path::Path;
use std::process::Output;

fn with_addresses(kibibytes: u64, folder: &Path, arguments: &[&str]) -> Output {
    raywalk_after(&format!("ulimit -c 0; ulimit -v {kibibytes}"), folder, arguments).output().expect("it runs")
}

/// The least memory in which the program begins at all.
fn least(folder: &Path) -> u64 {
    let begins = |kibibytes: &u64| with_addresses(*kibibytes, folder, &["--version"]).status.success();
    (1..).map(|step| step * 2000).find(begins).expect("there is as much memory somewhere")
}

#[test]
fn little_memory_is_said_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let least = least(folder.path());
    let make = |arguments: &[&str]| assert!(raywalk(folder.path(), arguments).status().expect("it runs").success());
    for (name, depth) in [("a", "3"), ("b", "4")] {
        let picture = ["render", "figure-6", "--size", "300x200", "-q", "--max-depth", depth, "-o"];
        make(&[&picture[..], &[&format!("{name}.exr")]].concat());
    }
    make(&["render", "figure-6", "--size", "300x200", "-q", "--shard", "1/1", "-o", "a.part"]);
    make(&["trace", "figure-6", "--pixel", "160,120", "--max-depth", "8", "-q", "-o", "a.ndjson"]);
    let before = names_in(folder.path());
    let mut refused = 0;
    for call in [
        &["render", "textbook", "--size", "400x300", "-q", "--threads", "4", "-o", "r"][..],
        &["render", "textbook", "--size", "400x300", "-q", "--resume", "--threads", "1", "-o", "r"],
        &["render", "textbook", "--size", "200x150", "-q", "--layers", "all", "--threads", "2", "-o", "r.exr"],
        &["merge", "a.part", "-q", "-o", "r"],
        &["diff", "a.exr", "b.exr", "-o", "r"],
        &["trace", "figure-6", "--pixel", "160,120", "--max-depth", "8", "--format", "html", "-q", "-o", "r.html"],
        &["trace", "figure-6", "--region", "100,100,120,120", "-q", "-o", "r.ndjson"],
        &["walk", "a.ndjson"],
    ] {
        let call: Vec<_> = call.iter().map(|word| if *word == "r" { "r.png" } else { word }).collect();
        // Steps of less than the memory that the work takes, from too little to enough.
        for step in 0..12 {
            let kibibytes = least + 1200 * step;
            let output = with_addresses(kibibytes, folder.path(), &call);
            let message = String::from_utf8_lossy(&output.stderr);
            match output.status.code() {
                Some(0 | 1) => {}
                Some(3) => {
                    assert!(message.starts_with("error: "), "{call:?} in {kibibytes}: {message}");
                    assert_eq!(message.trim_end().lines().count(), 1, "{call:?} in {kibibytes}: {message}");
                    refused += 1;
                }
                _ => panic!("{call:?} in {kibibytes}: {}, {message}", output.status),
            }
            let left = |name: &String| !before.contains(name) && name.ends_with(".part");
            assert_eq!(names_in(folder.path()).into_iter().find(left), None, "{call:?} in {kibibytes}");
            for name in names_in(folder.path()).iter().filter(|name| !before.contains(name)) {
                fs::remove_file(folder.path().join(name)).expect("removed");
            }
        }
    }
    assert!(refused > 8, "{refused} calls had too little memory");
}
