//! What the viewer does while nobody presses a key, and what one waits for.

use crate::session::Session;
use std::thread;
use std::time::Duration;

/// An idle viewer wakes about once a second, to see whether its terminal is still there; signals and keys wake it at once.
#[test]
#[cfg(target_os = "linux")]
fn an_idle_viewer_sleeps() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("a.ndjson");
    let mut traced = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
    traced.args(["trace", "textbook", "--pixel", "160,120", "-o"]).arg(&log).assert().success();
    let mut session = Session::start(&["walk", log.to_str().expect("a path in UTF-8")], 80, 24);
    session.shows("step 1/");
    thread::sleep(Duration::from_millis(300));
    let status = format!("/proc/{}/status", session.child.process_id().expect("it runs"));
    let wakes = || {
        let text = std::fs::read_to_string(&status).expect("it runs");
        let line =
            text.lines().find_map(|line| line.strip_prefix("voluntary_ctxt_switches:")).expect("the kernel counts");
        line.trim().parse::<u32>().expect("a count")
    };
    let before = wakes();
    thread::sleep(Duration::from_secs(3));
    let woken = wakes() - before;
    assert!(woken <= 20, "it woke {woken} times in three seconds");
    session.press("n");
    session.shows("ray.length");
    session.press("q");
    session.ends_with(0);
}

/// Where the picture isn't shown a screenshot doesn't wait for it; where it is, for the pixels that are seen. The whole of this one would take
/// hours.
#[test]
fn a_screenshot_waits_for_what_it_shows_only() {
    let folder = tempfile::tempdir().expect("a folder");
    for screen in ["60x20", "100x28"] {
        let file = folder.path().join(format!("{screen}.svg"));
        let mut walk = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
        walk.args(["walk", "textbook", "--sampling", "regular:16", "--size", "15000x10000", "--pixel", "7500,5000"]);
        walk.args(["--screen", screen, "--screenshot"]).arg(&file).timeout(Duration::from_secs(120)).assert().success();
        let picture = std::fs::read_to_string(&file).expect("it was written");
        assert!(!picture.contains(" %"), "all that is seen is there");
    }
}

/// Before the first frame the terminal says what is being done.
#[test]
fn what_takes_long_is_said() {
    let mut session = Session::start(&["walk", "textbook"], 80, 24);
    session.shows("step 1/");
    assert!(session.has_written("reading textbook.json ...") && session.has_written("tracing the pixel ..."));
    session.press("q");
    session.ends_with(0);
}
