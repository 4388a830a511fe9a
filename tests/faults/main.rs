//! Every fault of the system is noticed: each system call that reads, writes or orders files fails once, in each of many commands.
//!
//! Whatever fails, and whenever the program is killed, a result is the old one or the new one, and whole; inputs stay as they are; nothing
//! else is left in the folder but by a kill, and the next run sweeps that. What fails is reported, with exit code 3, unless the result doesn't
//! need it.

#![cfg(all(target_os = "linux", target_arch = "x86_64"))]

#[path = "../support/shared.rs"]
#[allow(dead_code)]
mod shared;
mod tracer;

use nix::errno::Errno;
use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Stdio};
use tracer::{Call, Fault, Traced};

const PROGRAM: &str = env!("CARGO_BIN_EXE_raywalk");

/// Files by their names.
type Files = BTreeMap<String, Vec<u8>>;

/// A command, and the files that are there before it.
struct Case {
    before: Files,
    arguments: Vec<&'static str>,
}

/// What a command leaves behind without a fault.
struct Done {
    code: i32,
    out: Vec<u8>,
    files: Files,
    calls: Vec<Call>,
}

impl Case {
    /// The command in a folder where others have been run before.
    fn after(before: &[&[&str]], arguments: &[&'static str]) -> Case {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["textbook.json", "mesh.json", "knot.obj"] {
            fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name), folder.path().join(name))
                .expect("a scene");
        }
        for arguments in before {
            plainly(folder.path(), arguments);
        }
        Case { before: files_in(folder.path()), arguments: arguments.to_vec() }
    }

    fn folder(&self) -> tempfile::TempDir {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, bytes) in &self.before {
            fs::write(folder.path().join(name), bytes).expect("a file");
        }
        folder
    }

    fn run(&self, folder: &Path, fault: Option<(usize, Fault)>) -> Traced {
        tracer::run(folder, PROGRAM, &self.arguments, fault)
    }

    fn without_a_fault(&self) -> Done {
        let folder = self.folder();
        let Traced { status, out, calls, message } = self.run(folder.path(), None);
        let code = status.code().expect("an exit code");
        assert!(code < 2, "{:?}: {message}", self.arguments);
        Done { code, out, files: files_in(folder.path()), calls }
    }

    /// Lets every call fail in every way. Gives how many faults that were.
    fn meets_all_faults(&self) -> usize {
        let done = self.without_a_fault();
        assert!(done.calls.len() > 3, "{:?}: {:?}", self.arguments, done.calls);
        // Before the program looks at its first file, Rust's runtime sets itself up; without memory it can only abort.
        let own = done.calls.iter().position(|call| call.name == "statx").unwrap_or_default();
        let faults: Vec<_> = (0..done.calls.len())
            .filter(|at| *at >= own || !done.calls[*at].asks_for_memory())
            .flat_map(|at| faults_of(&done.calls[at]).iter().map(move |fault| (at, *fault)))
            .collect();
        let mut all_wrong = String::new();
        for (at, fault) in &faults {
            let folder = self.folder();
            let traced = self.run(folder.path(), Some((*at, *fault)));
            let found = match (fault, traced.calls.get(*at)) {
                (Fault::Kill, _) => self.after_a_kill(&done, folder.path(), &traced),
                (_, Some(call)) => self.after_a_fault(&done, folder.path(), &traced, *call, *fault),
                // How many calls threads make at their end isn't always the same: nothing failed.
                _ => Ok(()),
            };
            if let Err(wrong) = found {
                let call = done.calls[*at];
                all_wrong +=
                    &format!("{fault:?} at call {at}, {call:?}: {wrong}\n  {}: {}\n", traced.status, traced.message);
            }
        }
        assert!(all_wrong.is_empty(), "{}:\n{all_wrong}", self.arguments.join(" "));
        faults.len()
    }

    fn after_a_fault(
        &self,
        done: &Done,
        folder: &Path,
        traced: &Traced,
        call: Call,
        fault: Fault,
    ) -> Result<(), String> {
        let files = files_in(folder);
        let code = traced.status.code().ok_or("ended by a signal")?;
        let must_go_on = matches!(fault, Fault::Error(Errno::EINTR) | Fault::Short);
        if code == done.code {
            if files != done.files && call.name != "unlink" {
                return Err(format!("done, but {}", difference(&files, &done.files)));
            }
            return if traced.out == done.out { Ok(()) } else { Err("done, but standard output differs".to_owned()) };
        }
        match code {
            _ if must_go_on => Err("isn't tried again".to_owned()),
            // Where a thread finds no memory to begin with, Rust's runtime says something before.
            3 if !traced.message.lines().any(|line| line.starts_with("error: ")) && !call.writes_to(2) => {
                Err("without a message".to_owned())
            }
            3 => {
                self.is_old_or_new(&files, done, call.name.starts_with("unlink"))?;
                self.goes_on(done, folder)
            }
            code => Err(format!("exit code {code}")),
        }
    }

    /// The next run gets everything right, and sweeps what is left.
    fn goes_on(&self, done: &Done, folder: &Path) -> Result<(), String> {
        plainly(folder, &self.arguments);
        let files = files_in(folder);
        if files == done.files { Ok(()) } else { Err(format!("the next run: {}", difference(&files, &done.files))) }
    }

    fn after_a_kill(&self, done: &Done, folder: &Path, traced: &Traced) -> Result<(), String> {
        if traced.status.signal().is_none() {
            return Err("not killed".to_owned());
        }
        self.is_old_or_new(&files_in(folder), done, true)?;
        self.goes_on(done, folder)
    }

    /// Each file is as it was before or as it is to be. A checkpoint stays until the result is there.
    fn is_old_or_new(&self, files: &Files, done: &Done, may_leave_more: bool) -> Result<(), String> {
        for (name, bytes) in files {
            let is_one_of = |files: &Files| files.get(name) == Some(bytes);
            let is_more = !self.before.contains_key(name) && !done.files.contains_key(name);
            let may_stay = is_more && (may_leave_more || name.ends_with(".checkpoint"));
            if !is_one_of(&self.before) && !is_one_of(&done.files) && !may_stay {
                return Err(format!("{name} is neither as before nor as it is to be ({} bytes)", bytes.len()));
            }
        }
        match self.before.keys().find(|name| !files.contains_key(*name)) {
            Some(name) => Err(format!("{name} is gone")),
            None => Ok(()),
        }
    }
}

/// What may happen to a call.
fn faults_of(call: &Call) -> &'static [Fault] {
    use Fault::{Error, ErrorsFromNowOn, Kill, NoMoreMemory, Short};
    match call.name {
        "write" | "writev" | "pwrite64" => {
            &[Error(Errno::EIO), ErrorsFromNowOn(Errno::ENOSPC), Error(Errno::EINTR), Short, Kill]
        }
        "read" | "readv" | "pread64" => &[Error(Errno::EIO), Error(Errno::EINTR), Short],
        "open" | "openat" => &[Error(Errno::EACCES), Error(Errno::EMFILE)],
        "fsync" | "fdatasync" => &[Error(Errno::EIO), Error(Errno::EINTR), Kill],
        "rename" | "renameat" | "renameat2" | "unlink" | "unlinkat" | "link" | "linkat" => &[Error(Errno::EIO), Kill],
        "mmap" | "mremap" | "brk" => &[NoMoreMemory],
        _ => &[Error(Errno::EIO)],
    }
}

/// Runs the program as usual.
fn plainly(folder: &Path, arguments: &[&str]) {
    let mut command = Command::new(PROGRAM);
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    let output = command.output().expect("it runs");
    assert!(output.status.code().is_some_and(|code| code < 2), "{}", String::from_utf8_lossy(&output.stderr));
}

fn files_in(folder: &Path) -> Files {
    let entries = fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("an entry"));
    let file = |entry: fs::DirEntry| {
        (entry.file_name().to_string_lossy().into_owned(), fs::read(entry.path()).expect("a file"))
    };
    entries.map(file).collect()
}

fn difference(found: &Files, expected: &Files) -> String {
    let names = found.keys().chain(expected.keys());
    let other: Vec<_> = names.filter(|name| found.get(*name) != expected.get(*name)).collect();
    format!("files differ: {other:?}")
}

/// A test for each command, so that they run side by side.
macro_rules! noticed_in {
    ($($name:ident: $before:expr, $arguments:expr;)+) => {$(
        #[test]
        fn $name() {
            if !tracer::can_trace() {
                shared::skipped("commands can't be traced here");
                return;
            }
            let count = Case::after(&$before, &$arguments).meets_all_faults();
            println!("{}: {count} faults noticed", stringify!($name));
        }
    )+};
}

const RENDER: [&str; 7] = ["render", "textbook.json", "--size", "9x7", "--threads", "1", "-q"];

noticed_in! {
    a_picture: [&[RENDER.as_slice(), &["--max-depth", "0", "-o", "a.png"]].concat()],
        ["render", "textbook.json", "--size", "9x7", "--threads", "1", "-q", "-o", "a.png"];
    a_picture_of_a_mesh: [],
        ["render", "mesh.json", "--size", "9x7", "--threads", "1", "-q", "-o", "a.pfm"];
    layers: [],
        ["render", "textbook.json", "--size", "9x7", "--threads", "1", "-q", "--layers", "depth,tests", "-o", "a.exr"];
    a_picture_that_can_be_resumed: [],
        ["render", "textbook.json", "--size", "9x7", "--threads", "1", "-q", "--resume", "-o", "a.png"];
    a_part_that_can_be_resumed: [],
        ["render", "textbook.json", "--size", "9x7", "--threads", "1", "-q", "--resume", "--shard", "1/2", "-o", "a.part"];
    merged_parts: [
            &[RENDER.as_slice(), &["--shard", "1/2", "-o", "a.part"]].concat(),
            &[RENDER.as_slice(), &["--shard", "2/2", "-o", "b.part"]].concat()],
        ["merge", "a.part", "b.part", "-o", "a.png"];
    a_log_packed_by_gzip: [],
        ["trace", "textbook.json", "--pixel", "160,120", "-o", "a.ndjson.gz"];
    a_region_packed_by_zstd: [],
        ["trace", "textbook.json", "--region", "10,10,12,12", "--threads", "1", "-q", "-o", "a.ndjson.zst"];
    a_view_of_a_log: [&["trace", "textbook.json", "--pixel", "160,120", "-o", "a.ndjson.gz"]],
        ["trace", "a.ndjson.gz", "--format", "html", "-o", "a.html"];
    a_walk_as_text: [&["trace", "textbook.json", "--pixel", "160,120", "-o", "a.ndjson.zst"]],
        ["walk", "a.ndjson.zst", "--plain"];
    a_screenshot: [],
        ["walk", "textbook.json", "--threads", "1", "--screenshot", "a.svg"];
    a_difference_of_logs: [
            &["trace", "textbook.json", "--pixel", "160,120", "-o", "a.ndjson"],
            &["trace", "textbook.json", "--pixel", "161,120", "-o", "b.ndjson"]],
        ["diff", "a.ndjson", "b.ndjson"];
    a_difference_of_pictures: [
            &[RENDER.as_slice(), &["-o", "a.exr"]].concat(),
            &[RENDER.as_slice(), &["--max-depth", "0", "-o", "b.exr"]].concat()],
        ["diff", "a.exr", "b.exr"];
    a_converted_scene: [],
        ["scene", "convert", "textbook.json", "-o", "a.json"];
}

/// The tool itself: a call that fails is seen to fail.
#[test]
fn the_tracer_lets_calls_fail() {
    if !tracer::can_trace() {
        shared::skipped("commands can't be traced here");
        return;
    }
    let case = Case::after(&[], &["scene", "convert", "textbook.json", "-o", "a.json"]);
    let done = case.without_a_fault();
    let first_write = done.calls.iter().position(|call| call.transfers() && call.name == "write").expect("a write");
    let folder = case.folder();
    let traced = case.run(folder.path(), Some((first_write, Fault::Error(Errno::ENOSPC))));
    assert_eq!(traced.status.code(), Some(3));
    assert_eq!(traced.message, "error: a.json: cannot write: No space left on device (os error 28)\n");
    let traced = case.run(folder.path(), Some((first_write, Fault::Kill)));
    assert_eq!(traced.status.signal(), Some(9));
}
