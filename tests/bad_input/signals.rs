//! The rows s01 to s05: signals in the middle of the work.

use crate::run::{answer, names_in, raywalk, wait};
use crate::shared::skipped;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// More rays than anybody would wait for.
const ENDLESS: [&str; 8] = ["figure-6", "--max-depth", "256", "--size", "400x300", "-q", "-o", "a.pfm"];

fn folder_with_old_picture() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.pfm"), "old").expect("written");
    folder
}

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill").args(["-s", signal, &child.id().to_string()]).status().expect("kill runs");
    assert!(sent.success());
}

/// Starts a rendering and waits until it is at work.
fn start(folder: &Path, arguments: &[&str]) -> Child {
    let mut command = raywalk(folder, &[&["render"], arguments].concat());
    let child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("it starts");
    let begun = Instant::now();
    while !names_in(folder).iter().any(|name| name.ends_with(".part")) {
        assert!(begun.elapsed() < Duration::from_secs(30), "it doesn't begin");
        sleep(Duration::from_millis(1));
    }
    child
}

/// A signal ends the work with this code within 200 ms, and only the old picture is there.
#[track_caller]
fn ends(signals: &[&str], code: i32) {
    let attempt = |pause: u64| {
        let folder = folder_with_old_picture();
        let mut child = start(folder.path(), &ENDLESS);
        sleep(Duration::from_millis(pause));
        let asked = Instant::now();
        // The child ends only when it is waited for, so that every signal has a receiver.
        signals.iter().for_each(|signal| send(signal, &child));
        let status = child.wait().expect("it ends");
        let took = asked.elapsed();
        assert_eq!(status.code(), Some(code), "{status}");
        assert_eq!(names_in(folder.path()), ["a.pfm"]);
        assert_eq!(fs::read(folder.path().join("a.pfm")).expect("the picture"), b"old");
        took
    };
    // The fastest of some, because other programs run here too.
    let fastest = [0, 5, 20, 50, 150].map(attempt).into_iter().min().expect("five");
    assert!(fastest < Duration::from_millis(200), "{fastest:?}");
}

#[test]
fn s01_sigint() {
    ends(&["INT"], 130);
    ends(&["INT", "INT"], 130);
}

#[test]
fn s01_sigint_leaves_a_log_without_its_end() {
    log_without_end("INT", Some(130));
}

/// A log that grows on standard output is read up to its last full record.
#[track_caller]
fn log_without_end(signal: &str, code: Option<i32>) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.ndjson");
    let mut trace = raywalk(folder.path(), &["trace", "figure-6", "--max-depth", "256", "--pixel", "160,120"]);
    let mut child = trace.stdout(File::create(&path).expect("a file")).spawn().expect("it starts");
    while fs::metadata(&path).expect("the log").len() < 100_000 {
        sleep(Duration::from_millis(1));
    }
    send(signal, &child);
    assert_eq!(child.wait().expect("it ends").code(), code);
    // Of a long log only the beginning is looked at, to keep this short.
    let mut log = fs::read(&path).expect("the log");
    log.truncate(1_000_000);
    fs::write(&path, log).expect("written");
    let read = answer(&mut raywalk(folder.path(), &["walk", "a.ndjson"])).ends_with(0);
    assert!(read.message.contains("the log was cut off") || read.message.contains("no end line"), "{}", read.message);
    assert!(read.out.len() > 10_000);
}

#[test]
fn s02_sigterm() {
    ends(&["TERM"], 143);
    log_without_end("TERM", Some(143));
}

/// Where the program aborts itself it leaves nothing behind, and no core dump.
#[test]
fn s02_sigabrt() {
    ends(&["ABRT"], 3);
}

/// What a killed process left goes with the next run in its folder; what a living one is at work on stays.
#[test]
fn s03_sigkill_leaves_nothing_for_long() {
    let folder = folder_with_old_picture();
    let small = || {
        let arguments = ["render", "textbook", "--size", "16x12", "-q", "-o", "b.png"];
        answer(&mut raywalk(folder.path(), &arguments)).ends_with(0);
        names_in(folder.path())
    };
    let mut child = start(folder.path(), &ENDLESS);
    let during = small();
    assert_eq!(during.len(), 3, "{during:?}");
    assert!(during[0].starts_with(".raywalk-") && during[0].ends_with(".part"), "{during:?}");
    child.kill().expect("it is killed");
    child.wait().expect("it ends");
    assert_eq!(names_in(folder.path()), during);
    assert_eq!(small(), ["a.pfm", "b.png"]);
}

#[test]
fn s03_sigkill() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["render", "figure-6", "--size", "120x90", "--max-depth", "6", "-q", "-o", "a.pfm"];
    let render = || raywalk(folder.path(), &arguments).spawn().expect("it starts");
    let begun = Instant::now();
    assert!(render().wait().expect("it ends").success());
    let whole = begun.elapsed();
    let picture = fs::read(folder.path().join("a.pfm")).expect("a picture");
    let (mut old, mut random) = (0, 1_u32);
    for _ in 0..50 {
        fs::write(folder.path().join("a.pfm"), "old").expect("written");
        let mut child = render();
        // Numbers that look random and are the same in every run; the fractions go a bit beyond the end.
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        sleep(whole * (random >> 16) / 60_000);
        child.kill().expect("it is killed");
        child.wait().expect("it ends");
        let found = fs::read(folder.path().join("a.pfm")).expect("a picture");
        let is_old = found == b"old";
        assert!(is_old || found == picture, "{} bytes of a picture", found.len());
        old += u32::from(is_old);
    }
    assert!(old > 0, "no render was caught in the middle");
    // What was left behind does no harm.
    assert!(render().wait().expect("it ends").success());
    assert_eq!(fs::read(folder.path().join("a.pfm")).expect("a picture"), picture);
    assert_eq!(names_in(folder.path()), ["a.pfm"]);
    log_without_end("KILL", None);
}

#[test]
fn s04_sigstop() {
    let folder = tempfile::tempdir().expect("a folder");
    let render = |to: &str| {
        let arguments = ["figure-6", "--size", "200x150", "--max-depth", "6", "-q", "-o", to];
        start(folder.path(), &arguments)
    };
    assert!(render("alone.pfm").wait().expect("it ends").success());
    let mut child = render("a.pfm");
    for _ in 0..10 {
        for signal in ["STOP", "WINCH", "CONT", "WINCH"] {
            send(signal, &child);
            sleep(Duration::from_millis(1));
        }
    }
    assert!(child.wait().expect("it ends").success());
    let [alone, stopped] = ["alone.pfm", "a.pfm"].map(|name| fs::read(folder.path().join(name)).expect("a picture"));
    assert!(alone == stopped, "other bytes after a stop");
}

#[test]
fn s05_sighup() {
    // Where these tests themselves run under nohup, so does the program.
    if is_hang_up_ignored() {
        skipped("SIGHUP is ignored here, and so it is by what is started here");
    } else {
        ends(&["HUP"], 129);
    }
    // Whoever starts it with nohup wants it to go on.
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = Command::new("nohup");
    command.arg(env!("CARGO_BIN_EXE_raywalk")).args(["render", "figure-6", "--size", "200x150", "--max-depth", "6"]);
    command.args(["-q", "-o", "a.pfm"]).current_dir(folder.path()).stdout(Stdio::null()).stderr(Stdio::null());
    let child = command.stdin(Stdio::null()).spawn().expect("it starts");
    while names_in(folder.path()).is_empty() {
        sleep(Duration::from_millis(1));
    }
    send("HUP", &child);
    assert!(wait(child, Duration::from_secs(60)).0.success());
}

fn is_hang_up_ignored() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).is_some_and(|mask| mask & 1 != 0)
}
