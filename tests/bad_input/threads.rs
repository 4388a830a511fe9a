//! How many threads the program starts, and what it does where it can't start any.

use crate::meshes::folder_with_mesh;
use crate::run::{names_in, raywalk};
use crate::shared::skipped;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// A folder with a scene of a mesh whose tree is worth several threads: 130,050 triangles.
fn folder_with_large_mesh() -> tempfile::TempDir {
    const SIDE: usize = 256;
    let folder = folder_with_mesh("m.obj");
    let mut text = String::new();
    for at in 0..SIDE * SIDE {
        let (x, y) = (at % SIDE, at / SIDE);
        text.push_str(&format!("v {x} {y} {}\n", (x * y) % 7));
    }
    for at in (1..=SIDE * (SIDE - 1)).filter(|at| !at.is_multiple_of(SIDE)) {
        text.push_str(&format!("f {at} {} {}\nf {at} {} {}\n", at + 1, at + SIDE + 1, at + SIDE + 1, at + SIDE));
    }
    fs::write(folder.path().join("m.obj"), text).expect("written");
    folder
}

/// The most threads that a call had at a time, looked at as often as that goes.
#[cfg(target_os = "linux")]
fn most_threads(folder: &Path, arguments: &[&str]) -> usize {
    let mut command = raywalk(folder, arguments);
    // Rayon's own wish is nobody's here.
    let command = command.env("RAYON_NUM_THREADS", "64").stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().expect("it starts");
    let tasks = format!("/proc/{}/task", child.id());
    let mut most = 0;
    loop {
        most = fs::read_dir(&tasks).map_or(0, Iterator::count).max(most);
        if let Some(status) = child.try_wait().expect("a status") {
            assert!(status.success(), "{arguments:?}: {status}");
            return most;
        }
    }
}

#[test]
#[cfg(target_os = "linux")]
fn no_more_threads_are_started_than_are_asked_for() {
    let folder = folder_with_large_mesh();
    let most = |arguments: &[&str]| most_threads(folder.path(), arguments);
    let mesh = ["render", "t.json", "--size", "100x75", "-q", "-o", "a.pfm", "--threads"];
    let region = ["trace", "figure-6", "--region", "100,100,130,120", "-q", "-o", "a.ndjson", "--threads"];
    for call in [&mesh[..], &region] {
        assert_eq!(most(&[call, &["1"]].concat()), 1, "{call:?}");
        // The one that waits for them is there, too.
        assert_eq!(most(&[call, &["3"]].concat()), 4, "{call:?}");
    }
    let resumed = ["--resume", "--layers", "depth", "--threads", "1", "-o", "a.exr"];
    assert_eq!(most(&[&mesh[..5], &resumed].concat()), 1);
    assert_eq!(most(&["walk", "figure-6", "--threads", "1", "--screenshot", "a.svg", "--keys", "p"]), 1);
    // What is small starts none, however many there could be.
    for small in [
        &["scene", "check", "table-top"][..],
        &["trace", "figure-6", "--pixel", "160,120"],
        &["render", "figure-6", "--size", "16x16", "-q", "-o", "a.png"],
        &["walk", "textbook"],
        &["textbook"],
    ] {
        assert_eq!(most(small), 1, "{small:?}");
    }
}

#[test]
fn where_no_thread_can_be_started_the_work_goes_on() {
    let folder = folder_with_large_mesh();
    fs::set_permissions(folder.path(), std::os::unix::fs::PermissionsExt::from_mode(0o777)).expect("permissions");
    // The superuser may start as many as it likes: another user is needed, with no process but this one.
    let limited = |arguments: &[&str]| {
        let call = "ulimit -u 1 || exit 77; exec \"$0\" \"$@\"";
        let mut command = Command::new("setpriv");
        command.args(["--reuid", "65533", "--clear-groups", "bash", "-c", call]).arg(env!("CARGO_BIN_EXE_raywalk"));
        command.args(arguments).current_dir(folder.path()).stdin(Stdio::null()).output()
    };
    match limited(&["--version"]) {
        Ok(output) if output.status.success() => {}
        _ => return skipped("no other user's processes can be limited here"),
    }
    for (name, call) in [
        ("a.pfm", &["render", "t.json", "--size", "64x48", "--threads", "8"][..]),
        ("b.pfm", &["render", "figure-6", "--size", "64x48"]),
        ("c.exr", &["render", "figure-6", "--size", "64x48", "--layers", "depth,rays", "--resume"]),
        ("d.part", &["render", "figure-6", "--size", "64x48", "--shard", "1/2"]),
        ("e.ndjson", &["trace", "figure-6", "--region", "100,100,130,120"]),
        ("f.obj", &["trace", "figure-6", "--region", "100,100,130,120", "--format", "obj"]),
    ] {
        let call = [call, &["-q", "-o", name]].concat();
        let output = limited(&call).expect("it runs");
        assert_eq!(output.status.code(), Some(0), "{call:?}: {}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
        let found = fs::read(folder.path().join(name)).expect("a result");
        fs::remove_file(folder.path().join(name)).expect("removed");
        assert!(raywalk(folder.path(), &call).status().expect("it runs").success());
        assert!(fs::read(folder.path().join(name)).expect("a result") == found, "{name}");
        fs::remove_file(folder.path().join(name)).expect("removed");
    }
    let screenshot = ["walk", "figure-6", "--screenshot", "g.svg", "--keys", "p"];
    assert_eq!(limited(&screenshot).expect("it runs").status.code(), Some(0));
    assert_eq!(names_in(folder.path()), ["g.svg", "m.obj", "t.json"]);
}
