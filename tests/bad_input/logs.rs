//! The rows e15 to e19: logs of other versions, cut off, damaged, growing, and two writers at once.

use crate::run::{Answer, answer, names_in, raywalk};
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::process::Stdio;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// A folder with the log of the numeric example's pixel, and its bytes.
fn folder_with_log() -> (tempfile::TempDir, Vec<u8>) {
    let folder = tempfile::tempdir().expect("a folder");
    let trace = ["trace", "textbook", "--pixel", "160,120", "-o", "a.ndjson"];
    answer(&mut raywalk(folder.path(), &trace)).ends_with(0);
    let log = fs::read(folder.path().join("a.ndjson")).expect("the log");
    (folder, log)
}

fn walk(folder: &Path, log: impl AsRef<[u8]>) -> Answer {
    fs::write(folder.join("b.ndjson"), log).expect("written");
    answer(&mut raywalk(folder, &["walk", "b.ndjson"]))
}

#[test]
fn e15_log_other_version() {
    let (folder, log) = folder_with_log();
    let other = String::from_utf8(log).expect("UTF-8").replacen("raywalk-log/1", "raywalk-log/2", 1);
    let expected = "error: b.ndjson:1:1: log: this program reads `raywalk-log/1`, the log is `raywalk-log/2`";
    walk(folder.path(), other).fails(2, expected);
    walk(folder.path(), "{\"log\":7}\n").fails(2, "error: b.ndjson:1:1: not a log");
}

#[test]
fn e16_log_truncated() {
    let (folder, log) = folder_with_log();
    for length in [log.len() - 1, log.len() - 30, log.len() / 2] {
        let cut = walk(folder.path(), &log[..length]).ends_with(0);
        let is_whole_line = log[length - 1] == b'\n';
        let expected = if is_whole_line { "no end line" } else { "1 incomplete record" };
        // An end line that lacks its last byte only, the line's end, is all there.
        let is_complete = length == log.len() - 1;
        assert!(is_complete || cut.message.contains(expected), "{length}: {}", cut.message);
        assert!(cut.out.starts_with("textbook · pixel 160,120".as_bytes()));
    }
}

#[test]
fn e17_log_corrupt_middle() {
    let (folder, log) = folder_with_log();
    let whole = walk(folder.path(), &log).ends_with(0);
    assert_eq!(whole.message, "");
    for at in (1000..log.len()).step_by(log.len() / 40) {
        let mut damaged = log.clone();
        damaged[at] ^= 4;
        let answer = walk(folder.path(), &damaged);
        let line = log[..at].iter().filter(|byte| **byte == b'\n').count() + 1;
        match answer.code {
            // The record can't be read: it is named, and what precedes it is shown. A line that lost its end is named with
            // the next one.
            Some(0) if answer.message.contains("damaged") => {
                let is_named = [line, line + 1].iter().any(|l| answer.message.contains(&format!(" {l}:")));
                assert!(is_named, "{at}: {}", answer.message);
            }
            // It can, but its value is not the one that was written: never shown as good.
            Some(0) => {
                let warns =
                    answer.message.contains("changed after it was written") || answer.message.contains("cut off");
                assert!(warns, "{at}: {}", answer.message);
            }
            code => panic!("{at}: {code:?} {}", answer.message),
        }
    }
}

#[test]
fn e18_log_growing() {
    let (folder, log) = folder_with_log();
    let path = folder.path().join("growing.ndjson");
    fs::write(&path, &log[..2000]).expect("written");
    let is_read = AtomicBool::new(false);
    thread::scope(|scope| {
        scope.spawn(|| {
            let mut file = File::options().append(true).open(&path).expect("the log");
            for piece in log[2000..].chunks(97) {
                file.write_all(piece).expect("written");
                thread::sleep(Duration::from_millis(2));
            }
            // In the end another log takes its place.
            while !is_read.load(Ordering::SeqCst) {
                fs::copy(folder.path().join("a.ndjson"), folder.path().join("copy")).expect("copied");
                fs::rename(folder.path().join("copy"), &path).expect("replaced");
            }
        });
        for _ in 0..10 {
            let read = answer(&mut raywalk(folder.path(), &["walk", "growing.ndjson"])).ends_with(0);
            let is_whole = read.message.is_empty();
            assert!(is_whole || read.message.contains("cut off"), "{}", read.message);
        }
        is_read.store(true, Ordering::SeqCst);
    });
}

#[test]
fn e19_two_writers() {
    let folder = tempfile::tempdir().expect("a folder");
    let render = |size: &str, to: &str| {
        let mut command = raywalk(folder.path(), &["render", "textbook", "--size", size, "-q", "-o", to]);
        command.stderr(Stdio::piped()).spawn().expect("it starts")
    };
    let sizes = ["150x100", "151x100"];
    let pictures = sizes.map(|size| {
        assert!(render(size, "alone.pfm").wait().expect("it ends").success());
        fs::read(folder.path().join("alone.pfm")).expect("a picture")
    });
    for _ in 0..5 {
        let both = sizes.map(|size| render(size, "same.pfm"));
        for mut child in both {
            assert!(child.wait().expect("it ends").success());
        }
        let same = fs::read(folder.path().join("same.pfm")).expect("a picture");
        assert!(pictures.contains(&same), "a mix of two pictures");
    }
    assert_eq!(names_in(folder.path()), ["alone.pfm", "same.pfm"]);
}
