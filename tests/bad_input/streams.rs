//! Standard streams that are closed, and places that nobody may look into: the machine's errors, and never an answer.

use crate::run::{answer, names_in, raywalk, raywalk_after};
use crate::shared::skipped;
use std::fs::{self, File, OpenOptions, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};

/// Calls whose results go to standard output.
const CALLS: &[&str] = &[
    "",
    "--help",
    "--version",
    "help render",
    "walk textbook --plain",
    "trace textbook --pixel 1,1",
    "trace textbook --pixel 1,1 --format text -o -",
    "render textbook --size 8x6 -q --stats json -o a.png",
    "diff a.pfm a.pfm",
    "rays textbook",
    "textbook",
    "stress --answers",
    "log schema",
    "scene list",
    "scene show textbook",
    "scene check textbook",
    "scene convert textbook",
    "scene schema",
    "scene generate knot --level 0",
    "completions bash",
    "man",
];

#[test]
fn e09_stdout_closed_is_reported() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.pfm"), b"Pf 1 1 -1.0\n\0\0\0\0").expect("written");
    for call in CALLS {
        let words: Vec<_> = call.split_whitespace().collect();
        let closed = answer(&mut raywalk_after("exec 1>&-", folder.path(), &words));
        let expected = "error: standard output: cannot write: it is closed\n";
        assert!(
            closed.code == Some(3) && closed.message.ends_with(expected),
            "{call}: {:?} {}",
            closed.code,
            closed.message
        );
        // Who wants no answer says so, and there are several ways.
        for honest in ["exec 1>/dev/null", "exec 1>>/dev/null", "exec 1>/dev/null 2>&1", "exec 0<>/dev/null 1>&0 2>&0"]
        {
            let said = answer(&mut raywalk_after(honest, folder.path(), &words));
            assert_eq!(said.code, Some(0), "{honest}; {call}: {}", said.message);
        }
        let closed = answer(&mut raywalk_after("exec 0<&- 1>&-", folder.path(), &words));
        assert_eq!(closed.code, Some(3), "{call}: {}", closed.message);
        let both = OpenOptions::new().read(true).write(true).open("/dev/null").expect("nothing");
        let mut command = raywalk(folder.path(), &words);
        assert!(command.stdout(both).stderr(Stdio::null()).status().expect("it runs").success(), "{call}");
    }
    // Where nothing is written there, nobody misses it.
    let render = ["render", "textbook", "--size", "8x6", "-q", "-o", "b.png"];
    answer(&mut raywalk_after("exec 1>&-", folder.path(), &render)).ends_with(0);
}

#[test]
fn e09_stdin_closed_is_reported() {
    let folder = tempfile::tempdir().expect("a folder");
    let expected = "cannot read: it is closed";
    for call in [
        "trace - --pixel 1,1",
        "walk -",
        "render - -o a.png",
        "scene check -",
        "diff - a.png",
        "textbook --with -",
        "stress -",
        "rays textbook",
    ] {
        let words: Vec<_> = call.split(' ').collect();
        answer(&mut raywalk_after("exec 0<&-", folder.path(), &words)).fails(3, expected);
        let empty = answer(&mut raywalk_after("exec 0</dev/null", folder.path(), &words));
        let code = if call.starts_with("rays") { 0 } else { 2 };
        assert_eq!(empty.code, Some(code), "{call}: {}", empty.message);
    }
    assert_eq!(names_in(folder.path()), [""; 0]);
}

/// The program as somebody whom permissions bind, as they don't the superuser.
fn bound(folder: &Path, arguments: &[&str]) -> Option<Command> {
    let probe = folder.join("probe");
    fs::create_dir(&probe).ok()?;
    fs::set_permissions(&probe, Permissions::from_mode(0o0)).ok()?;
    let is_bound = File::create(probe.join("a")).is_err();
    fs::remove_dir_all(&probe).ok()?;
    let nobody = ["setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups"];
    let command = |arguments: &[&str]| {
        let before: &[&str] = if is_bound { &[] } else { &nobody };
        let words = [before, &[env!("CARGO_BIN_EXE_raywalk")], arguments].concat();
        let mut command = Command::new(words[0]);
        command.args(&words[1..]).current_dir(folder).env_remove("NO_COLOR").stdin(Stdio::null());
        command
    };
    let runs = command(&["--version"]).output().is_ok_and(|said| said.status.success());
    runs.then(|| command(arguments))
}

#[test]
fn e26_folder_without_permission() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::set_permissions(folder.path(), Permissions::from_mode(0o777)).expect("permissions");
    let closed = folder.path().join("closed");
    fs::create_dir(&closed).expect("a folder");
    let scene = r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 5], "direction": [0, 0, -1]},
        "objects": [{"name": "m", "shape": {"mesh": {"path": "closed/m.obj"}}}]}"#;
    fs::write(folder.path().join("s.json"), scene).expect("written");
    fs::set_permissions(&closed, Permissions::from_mode(0o0)).expect("permissions");
    for call in [
        // Whether there is such a file can't be known, so it is no built-in scene either.
        "render closed/textbook -o a.png",
        "trace closed/textbook --pixel 1,1",
        "walk closed/textbook",
        "scene show closed/s.json",
        "scene check s.json",
        "rays closed/s.json",
        "diff closed/a closed/b",
        "merge closed/1 closed/2 -o a.png",
        "stress closed/a.json",
        "textbook --with closed/a.csv",
        "bench error closed/s.json",
        "bench rays closed/r",
        "bench rays r --dump closed/dump",
        "render textbook -o closed/a.png",
        "render textbook -o closed/a.png --resume",
        "render textbook -o closed/a.part --shard 1/2",
        "trace textbook --pixel 1,1 -o closed/a",
        "man -o closed/man",
    ] {
        let words: Vec<_> = call.split(' ').collect();
        let Some(mut command) = bound(folder.path(), &words) else {
            return skipped("nobody is bound by permissions here");
        };
        answer(&mut command).fails(3, "Permission denied");
    }
    assert_eq!(names_in(folder.path()), ["closed", "s.json"]);
    // In a folder that may not be searched nothing can be told from absent.
    let Some(mut command) = bound(folder.path(), &["scene", "show", "textbook"]) else { return };
    let name = "textbook: cannot read: Permission denied";
    let inside = format!("cd {} && chmod 0 . && exec \"$0\" \"$@\"", closed.display());
    fs::set_permissions(&closed, Permissions::from_mode(0o777)).expect("permissions");
    let mut shell = Command::new("sh");
    shell.args(["-c", &inside]).arg(command.get_program()).args(command.get_args()).stdin(Stdio::null());
    answer(&mut shell).fails(3, name);
    fs::set_permissions(&closed, Permissions::from_mode(0o700)).expect("permissions");
    answer(&mut command).ends_with(0);
}
