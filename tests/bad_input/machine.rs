//! The rows e20 to e25: little memory, many threads, other locales, odd arguments, scenes that are no files.

use crate::meshes::{folder_with_mesh, make_fifo};
use crate::run::{Answer, answer, names_in, raywalk, raywalk_after};
use crate::scenes::TEXTBOOK;
use std::ffi::OsStr;
use std::fs::{self, File, Permissions};
use std::io::Write;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Stdio;

/// What a call answers that has 300,000 KiB of addresses.
fn with_little_memory(folder: &Path, arguments: &[&str]) -> Answer {
    answer(&mut raywalk_after("ulimit -v 300000", folder, arguments))
}

#[test]
fn e20_memory_limit() {
    let folder = folder_with_mesh("m.obj");
    fs::write(folder.path().join("m.obj"), format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}", "f 1 2 3\n".repeat(3_000_000)))
        .expect("written");
    let render = ["render", "t.json", "--size", "9x9", "-q", "-o", "a.png"];
    with_little_memory(folder.path(), &render).fails(3, "error: m.obj: ");
    assert_eq!(names_in(folder.path()), ["m.obj", "t.json"]);
    // What is large in other ways is reported before the work begins, too.
    let large = ["render", "textbook", "--size", "16000x16000", "-q", "-o", "a.png"];
    with_little_memory(folder.path(), &large)
        .fails(3, "error: not enough memory for a picture of 16000 x 16000 pixels");
    // Where there is no room for the stacks of all threads, there is for some.
    let threads = ["render", "textbook", "--size", "500x500", "--threads", "4000", "-q", "-o", "b.png"];
    with_little_memory(folder.path(), &threads).ends_with(0);
    // Nor do what the C library's allocator sets aside for threads and the number of threads together take what the picture needs.
    for limit in [160_000, 190_000, 220_000, 250_000, 280_000] {
        answer(&mut raywalk_after(&format!("ulimit -v {limit}"), folder.path(), &threads)).ends_with(0);
    }
    assert_eq!(names_in(folder.path()), ["b.png", "m.obj", "t.json"]);
    let small = ["render", "textbook", "--size", "9x9", "--threads", "2", "-q", "-o", "a.png"];
    with_little_memory(folder.path(), &small).ends_with(0);
}

#[test]
fn e20_memory_limit_of_logs() {
    let folder = tempfile::tempdir().expect("a folder");
    let long = |format: &str, to: &str| {
        let trace = ["trace", "figure-6", "--pixel", "160,120", "--max-depth", "39", "--format", format, "-o", to];
        let mut command = raywalk_after("ulimit -v 300000", folder.path(), &trace);
        command.stderr(Stdio::piped()).output().expect("it runs")
    };
    // A million events fit into no such memory, but into a file, line by line.
    let document = long("json", "a.json");
    assert_eq!(document.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&document.stderr).starts_with("error: not enough memory for the log, expected"));
    assert_eq!(names_in(folder.path()), [""; 0]);
    assert_eq!(long("ndjson", "a.ndjson").status.code(), Some(0));
    let walk = ["walk", "a.ndjson"];
    let walked = answer(&mut raywalk_after("ulimit -v 150000", folder.path(), &walk));
    walked.fails(3, "error: a.ndjson: cannot read: out of memory");
}

#[test]
fn e20_memory_limit_of_scenes() {
    let folder = tempfile::tempdir().expect("a folder");
    let ball = |k: u32| {
        format!("{{\"name\": \"b{k}\", \"shape\": {{\"sphere\": {{\"center\": [{k}, 0, 0], \"radius\": 0.1}}}}}}")
    };
    let balls: Vec<_> = (0..300_000).map(ball).collect();
    let scene = format!(
        "{{\"format\": \"raywalk-scene/1\", \"camera\": {{\"position\": [0, 0, 9], \"direction\": [0, 0, -1]}}, \"objects\": [{}]}}",
        balls.join(",\n")
    );
    fs::write(folder.path().join("t.json"), scene).expect("written");
    let render = ["render", "t.json", "--size", "9x9", "-q", "-o", "a.png"];
    with_little_memory(folder.path(), &render).fails(3, "error: t.json: ");
}

#[test]
fn e21_threads() {
    let folder = tempfile::tempdir().expect("a folder");
    let render = |threads: &str| {
        let arguments = ["render", "figure-6", "--size", "40x30", "--threads", threads, "-q", "-o", "a.pfm"];
        answer(&mut raywalk(folder.path(), &arguments)).ends_with(0);
        fs::read(folder.path().join("a.pfm")).expect("a picture")
    };
    let one = render("1");
    for threads in ["0", "2", "7", "1000"] {
        assert!(render(threads) == one, "{threads} threads give other bytes");
    }
    for variable in ["1", "7", "x", "0"] {
        let arguments = ["render", "figure-6", "--size", "40x30", "-q", "-o", "a.pfm"];
        answer(raywalk(folder.path(), &arguments).env("RAYON_NUM_THREADS", variable)).ends_with(0);
        assert!(fs::read(folder.path().join("a.pfm")).expect("a picture") == one, "RAYON_NUM_THREADS={variable}");
    }
    for threads in ["x", "-1", "1.5", "5000", "99999999999"] {
        let arguments = ["render", "figure-6", &format!("--threads={threads}"), "-o", "b.pfm"];
        answer(&mut raywalk(folder.path(), &arguments)).fails(2, &format!("invalid value '{threads}' for '--threads"));
    }
    assert_eq!(names_in(folder.path()), ["a.pfm"]);
}

#[test]
fn e22_clock_locale() {
    let folder = tempfile::tempdir().expect("a folder");
    let calls = [
        &["trace", "textbook", "--pixel", "160,120"][..],
        &["walk", "textbook"],
        &["textbook", "--format", "json"],
        &["scene", "show", "figure-6"],
    ];
    for arguments in calls {
        let usual = answer(raywalk(folder.path(), arguments).env("LC_ALL", "C").env("TZ", "UTC")).ends_with(0);
        let odd = answer(raywalk(folder.path(), arguments).env("LC_ALL", "de_DE.UTF-8").env("TZ", "Asia/Kathmandu"));
        assert!(odd.ends_with(0).out == usual.out, "{arguments:?}");
    }
}

#[test]
fn e23_args() {
    let folder = tempfile::tempdir().expect("a folder");
    let says = |arguments: &[&str], expected: &str| {
        let refused = answer(&mut raywalk(folder.path(), arguments)).ends_with(2);
        assert_eq!(refused.out, b"");
        assert!(refused.message.contains(expected), "{arguments:?}: {}", refused.message);
    };
    says(&["render", "textbook", "-o", "a.png", "--sise", "9x9"], "a similar argument exists: '--size'");
    says(&["--nonsense"], "Usage: raywalk");
    says(&["--", "nothing"], "Usage: raywalk");
    says(&[""], "Usage: raywalk");
    says(&["render", "", "-o", "a.png"], "a value is required for '<SCENE>'");
    says(&["render", "textbook", "-o", ""], "");
    says(&["render", "textbook", "-o", "a.png", "--max-depth", "1000000000"], "is not in 0..=256");
    says(&["render", &"x".repeat(100_000), "-o", "a.png"], "error: ");
    says(&["render", "textbook", "-o", "a.png", "--size", &"9".repeat(100_000)], "error: ");
    says(&[&"x".repeat(100_000)], "error: ");
    let odd = folder.path().join(OsStr::from_bytes(b"\xff\x1b[31m.json"));
    fs::write(&odd, TEXTBOOK).expect("written");
    let mut command = raywalk(folder.path(), &["render", "--size", "9x9", "-q"]);
    answer(command.arg(&odd).arg("-o").arg(odd.with_extension("png"))).ends_with(0);
    assert!(odd.with_extension("png").exists());
    fs::write(&odd, "[]").expect("written");
    answer(raywalk(folder.path(), &["scene", "check"]).arg(&odd)).fails(2, "\\u{1b}[31m.json:1:1: expected an object");
}

#[test]
fn e24_scene_is_dir() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("dir")).expect("a folder");
    let fails = |code: i32, scene: &str, expected: &str| {
        for arguments in [&["scene", "check", scene][..], &["render", scene, "-o", "a.png"], &["walk", scene]] {
            answer(&mut raywalk(folder.path(), arguments)).fails(code, expected);
        }
    };
    fails(2, "dir", "error: dir: expected a regular file, found a directory");
    fails(2, "/dev/null", "error: /dev/null: expected a regular file, found a device");
    fails(2, "missing.json", "error: missing.json: no such file or built-in scene");
    let closed = folder.path().join("closed.json");
    fs::write(&closed, TEXTBOOK).expect("written");
    fs::set_permissions(&closed, Permissions::from_mode(0o000)).expect("permissions");
    // The superuser can read everything but what the kernel itself refuses.
    let is_superuser = File::open(&closed).is_ok();
    let unreadable = if is_superuser { "/proc/self/mem" } else { "closed.json" };
    fails(3, unreadable, &format!("error: {unreadable}: "));
}

#[test]
fn e25_scene_huge() {
    let folder = tempfile::tempdir().expect("a folder");
    // A file of 5 GB that takes no room.
    File::create(folder.path().join("huge.json")).and_then(|file| file.set_len(5_000_000_000)).expect("a file");
    make_fifo(&folder.path().join("fifo.json"));
    let refused = |scene: &str, expected: &str| {
        answer(&mut raywalk(folder.path(), &["scene", "check", scene])).fails(2, expected);
    };
    refused("huge.json", "error: huge.json: too large, expected at most 268435456 bytes, found 5000000000 bytes");
    refused("fifo.json", "error: fifo.json: expected a regular file, found a FIFO");
    refused("/dev/zero", "error: /dev/zero: expected a regular file, found a device");
    // Standard input says no size beforehand.
    let mut child = raywalk(folder.path(), &["scene", "check", "-"])
        .stdin(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let mut input = child.stdin.take().expect("a pipe");
    let spaces = vec![b' '; 1 << 20];
    let written = (0..5000).take_while(|_| input.write_all(&spaces).is_ok()).count();
    drop(input);
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(2));
    assert!(written < 300, "{written} MiB were read");
    assert!(String::from_utf8_lossy(&output.stderr).contains("too large, expected at most 268435456 bytes"));
}
