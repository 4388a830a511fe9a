//! The rows e01 to e10: places where a result can't go, or must not.

use crate::meshes::{folder_with_mesh, make_fifo};
use crate::run::{Answer, answer, names_in, raywalk, raywalk_after};
use crate::shared::skipped;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::Read;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Stdio};

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
}

/// Renders a small picture to a place in the folder.
fn render(folder: &Path, to: &str) -> Answer {
    answer(&mut raywalk(folder, &["render", "textbook", "--size", "16x12", "-q", "-o", to]))
}

#[track_caller]
fn is_picture(path: &Path) {
    assert!(fs::read(path).expect("a picture").starts_with(b"\x89PNG"), "{}", path.display());
}

#[test]
fn e01_out_unwritable() {
    let folder = folder();
    let closed = folder.path().join("closed");
    fs::create_dir(&closed).expect("a folder");
    fs::set_permissions(&closed, Permissions::from_mode(0o555)).expect("permissions");
    if File::create(closed.join("probe")).is_ok() {
        // Nothing is closed to the superuser; /proc is, to everybody.
        render(folder.path(), "/proc/a.png").fails(3, "error: /proc/a.png: cannot write: ");
        return;
    }
    render(folder.path(), "closed/a.png").fails(3, "error: closed/a.png: cannot write: Permission denied");
}

#[test]
fn e02_out_missing_dir() {
    let folder = folder();
    // Said before the rendering starts, which would take minutes.
    let late = ["render", "figure-6", "--size", "20000x10000", "-o", "no/such/dir/x.ppm"];
    let expected = "error: no/such/dir/x.ppm: cannot write: No such file or directory";
    answer(&mut raywalk(folder.path(), &late)).fails(3, expected);
}

#[test]
fn e03_out_is_dir() {
    let folder = folder();
    fs::create_dir(folder.path().join("dir.png")).expect("a folder");
    render(folder.path(), "dir.png").fails(2, "error: dir.png: is a directory, expected the name of a file");
}

#[test]
fn e04_dev_full() {
    let Ok(full) = OpenOptions::new().write(true).open("/dev/full") else { return skipped("there is no /dev/full") };
    let folder = folder();
    symlink("/dev/full", folder.path().join("full.png")).expect("a link");
    render(folder.path(), "full.png").fails(3, "error: full.png: cannot write: No space left on device");
    for arguments in [&["trace", "textbook", "--pixel", "1,1"][..], &["scene", "list"], &["textbook"], &["--help"]] {
        let mut command = raywalk(folder.path(), arguments);
        let output = command.stdout(full.try_clone().expect("a copy")).output().expect("it runs");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(3), "{arguments:?}: {message}");
        assert!(message.contains("No space left on device"), "{arguments:?}: {message}");
    }
}

/// A place for files that is too small: a file system where one can be mounted, else a limit on the size of files.
#[test]
fn e05_disk_full() {
    let folder = folder();
    fs::write(folder.path().join("a.pfm"), "old").expect("written");
    let arguments = ["render", "textbook", "--size", "200x200", "-q", "-o", "a.pfm"];
    // 20 blocks of 512 bytes; the picture has 480,000.
    let limited = answer(&mut raywalk_after("ulimit -f 20", folder.path(), &arguments));
    limited.fails(3, "error: a.pfm: cannot write: File too large");
    assert_eq!(names_in(folder.path()), ["a.pfm"]);
    assert_eq!(fs::read(folder.path().join("a.pfm")).expect("the old one"), b"old");

    let mount = "mount -t tmpfs -o size=64k none . && cd . && echo old > a.pfm";
    let script = format!("{mount} || exit 77; cd \"$PWD\"; \"$0\" \"$@\"; code=$?; ls -A; cat a.pfm; exit $code");
    let mut unshared = Command::new("unshare");
    unshared.args(["-rm", "sh", "-c", &script]).arg(env!("CARGO_BIN_EXE_raywalk")).args(arguments);
    match unshared.current_dir(folder.path()).output() {
        Ok(output) if output.status.code() == Some(3) => {
            let message = String::from_utf8_lossy(&output.stderr);
            assert!(message.contains("a.pfm: cannot write: No space left on device"), "{message}");
            assert_eq!(String::from_utf8_lossy(&output.stdout), "a.pfm\nold\n");
        }
        Ok(output) if output.status.code() == Some(0) => panic!("480,000 bytes on a disk of 64 KiB"),
        _ => skipped("no file system can be mounted here"),
    }
}

#[test]
fn e06_out_symlink() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("elsewhere")).expect("a folder");
    fs::write(path("elsewhere/there.png"), "old").expect("written");
    for (link, target) in [("link.png", "elsewhere/there.png"), ("dangling.png", "elsewhere/new.png")] {
        symlink(target, path(link)).expect("a link");
        render(folder.path(), link).ends_with(0);
        // The link stays, what it points to is replaced.
        assert_eq!(fs::read_link(path(link)).expect("a link"), Path::new(target));
        is_picture(&path(target));
    }
    assert_eq!(names_in(&path("elsewhere")), ["new.png", "there.png"]);
    symlink("loop.png", path("loop.png")).expect("a link");
    render(folder.path(), "loop.png").fails(3, "error: loop.png: cannot write: Too many levels of symbolic links");
}

#[test]
fn e07_out_same_as_scene() {
    let folder = folder_with_mesh("m.obj");
    let mesh = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    fs::write(folder.path().join("m.obj"), mesh).expect("written");
    symlink("m.obj", folder.path().join("mesh.ppm")).expect("a link");
    fs::copy(folder.path().join("t.json"), folder.path().join("t.png")).expect("copied");
    let before: Vec<_> =
        ["t.json", "m.obj", "t.png"].map(|name| fs::read(folder.path().join(name)).expect("it")).into();
    for arguments in [
        &["render", "t.png", "-o", "t.png"][..],
        &["render", "t.png", "-o", "./t.png"],
        &["render", "t.json", "-o", "mesh.ppm"],
        &["trace", "t.json", "--pixel", "0,0", "-o", "m.obj"],
        &["trace", "t.json", "--pixel", "0,0", "-o", "t.json"],
        &["scene", "convert", "t.json", "-o", "t.json"],
        &["scene", "convert", "t.json", "-o", "m.obj"],
    ] {
        answer(&mut raywalk(folder.path(), arguments)).fails(2, ": is the input, which would be overwritten");
    }
    let after: Vec<_> = ["t.json", "m.obj", "t.png"].map(|name| fs::read(folder.path().join(name)).expect("it")).into();
    assert_eq!(after, before);
}

#[test]
fn e08_out_exists() {
    let folder = folder();
    let path = folder.path().join("a.png");
    fs::write(&path, "old").expect("written");
    fs::set_permissions(&path, Permissions::from_mode(0o640)).expect("permissions");
    let mut old = File::open(&path).expect("the old one");
    render(folder.path(), "a.png").ends_with(0);
    is_picture(&path);
    assert_eq!(fs::metadata(&path).expect("the picture").permissions().mode() & 0o777, 0o640);
    // Whoever had it open goes on reading the old bytes, not a mix.
    let mut read = String::new();
    old.read_to_string(&mut read).expect("the old bytes");
    assert_eq!((read.as_str(), names_in(folder.path())), ("old", vec!["a.png".to_owned()]));
}

#[test]
fn e09_stdin_closed() {
    let folder = folder();
    for closed in ["0<&-", "1>&-", "2>&-", "0<&- 1>&- 2>&-"] {
        let arguments = ["render", "textbook", "--size", "16x12", "--stats", "json", "-o", "a.png"];
        let code = answer(&mut raywalk_after(&format!("exec {closed}"), folder.path(), &arguments)).code;
        assert!(matches!(code, Some(0 | 3)), "{closed}: {code:?}");
        is_picture(&folder.path().join("a.png"));
        let trace =
            answer(&mut raywalk_after(&format!("exec {closed}"), folder.path(), &["trace", "-", "--pixel", "0,0"]));
        assert!(matches!(trace.code, Some(2 | 3)), "{closed}: {:?}", trace.code);
    }
    assert_eq!(names_in(folder.path()), ["a.png"]);
}

#[test]
fn e10_sigpipe() {
    let folder = folder();
    make_fifo(&folder.path().join("pipe.pfm"));
    // A picture in a pipe: 900,000 bytes, of which somebody takes 10.
    let head =
        Command::new("head").args(["-c", "10", "pipe.pfm"]).current_dir(folder.path()).stdout(Stdio::null()).spawn();
    let rendered = answer(&mut raywalk(folder.path(), &["render", "textbook", "-q", "-o", "pipe.pfm"])).ends_with(0);
    assert_eq!(rendered.message, "");
    assert!(head.expect("it starts").wait().expect("it ends").success());
    for arguments in [
        &["trace", "hall-of-mirrors", "--max-depth", "200", "--pixel", "160,120"][..],
        &["trace", "figure-6", "--max-depth", "256", "--pixel", "160,120"],
        &["walk", "hall-of-mirrors", "--max-depth", "200"],
        &["scene", "generate", "knot", "--level", "5"],
        &["scene", "list"],
        &["--help"],
    ] {
        let mut command = raywalk(folder.path(), arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        let mut out = child.stdout.take().expect("a pipe");
        let read = out.read(&mut [0; 10]).expect("some bytes");
        assert!(read > 0);
        drop(out);
        let output = child.wait_with_output().expect("it ends");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!((output.status.code(), message.as_ref()), (Some(0), ""), "{arguments:?}");
    }
}
