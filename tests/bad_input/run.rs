//! Running the program within the limits that every row has.

use std::env;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The most time on a processor. On a busy machine a call may well take longer on the clock.
pub const MOST_TIME: Duration = Duration::from_secs(2);
/// The most memory, in KiB.
const MOST_MEMORY: u64 = 256 << 10;
/// After so long a call hangs.
const PATIENCE: Duration = Duration::from_secs(60);

/// What a call answered.
pub struct Answer {
    /// The exit code; a call that a signal ended has none.
    pub code: Option<i32>,
    /// Standard output.
    pub out: Vec<u8>,
    /// Standard error.
    pub message: String,
    /// The most memory it had, in KiB.
    pub peak: u64,
}

/// The program with these arguments, in a folder. Messages are not coloured, whatever the tests run in.
pub fn raywalk(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raywalk"));
    command.args(arguments).current_dir(folder).env_remove("NO_COLOR").stdin(Stdio::null());
    command
}

/// The program with these arguments, started by a shell that has run `before`, such as `ulimit -f 10`.
pub fn raywalk_after(before: &str, folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", &format!("{before}; exec \"$0\" \"$@\"")]).arg(env!("CARGO_BIN_EXE_raywalk")).args(arguments);
    command.current_dir(folder).env_remove("NO_COLOR").stdin(Stdio::null());
    command
}

/// Runs a call to its end, within the limits of time and memory.
#[track_caller]
pub fn answer(command: &mut Command) -> Answer {
    let answer = unlimited_answer(command);
    assert!(answer.peak <= MOST_MEMORY, "{command:?}: took {} KiB of memory", answer.peak);
    answer
}

/// Runs a call to its end, however much memory it takes.
#[track_caller]
pub fn unlimited_answer(command: &mut Command) -> Answer {
    limited_answer(command, MOST_TIME)
}

/// Runs a call to its end, if it takes at most so much time on a processor.
#[track_caller]
pub fn limited_answer(command: &mut Command, most_time: Duration) -> Answer {
    let place = tempfile::tempdir().expect("a folder");
    let [out, message] = ["out", "message"].map(|name| place.path().join(name));
    let file = |path: &Path| File::create(path).expect("a file");
    let child = command.stdout(file(&out)).stderr(file(&message)).spawn().expect("it starts");
    let (status, peak) = wait(child, most_time);
    let message = String::from_utf8_lossy(&fs::read(message).expect("the message")).into_owned();
    let answer = Answer { code: status.code(), out: fs::read(out).expect("the output"), message, peak };
    assert!(answer.code.is_some(), "{command:?}: ended by a signal, {status}");
    let has_panicked = answer.code == Some(101) || answer.message.contains("panicked");
    assert!(!has_panicked, "{command:?}: {}", answer.message);
    answer
}

/// Waits for the end of a call that takes at most so much time on a processor; gives the most memory it had, in KiB.
#[track_caller]
pub fn wait(mut child: Child, most_time: Duration) -> (ExitStatus, u64) {
    let (start, mut peak) = (Instant::now(), 0);
    loop {
        let (time, memory) = spent(child.id());
        peak = memory.max(peak);
        if let Some(status) = child.try_wait().expect("a status") {
            return (status, peak);
        }
        if time > most_time || start.elapsed() > PATIENCE {
            child.kill().expect("it is ended");
            child.wait().expect("it ends");
            panic!("took too long: {time:?} on a processor, {:?} on the clock", start.elapsed());
        }
        sleep(Duration::from_millis(2));
    }
}

/// The time on a processor that a process took, and the most memory it had in KiB; 0 where the system doesn't tell.
fn spent(process: u32) -> (Duration, u64) {
    let read = |name: &str| fs::read_to_string(format!("/proc/{process}/{name}")).unwrap_or_default();
    // Just after it was started the process may still be in the memory of the tests, and be them.
    let has_begun = fs::read_link(format!("/proc/{process}/exe")).ok() != env::current_exe().ok();
    let status = if has_begun { read("status") } else { String::new() };
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let peak = peak.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok()).unwrap_or(0);
    // The fields behind the name, which may hold anything; the 12th and 13th are the times, 100 ticks a second.
    let stat = read("stat");
    let fields = stat.rsplit(')').next().unwrap_or_default().split_whitespace();
    let ticks: u64 = fields.skip(11).take(2).filter_map(|ticks| ticks.parse::<u64>().ok()).sum();
    (Duration::from_millis(ticks * 10), peak)
}

impl Answer {
    /// The call ended with this code.
    #[track_caller]
    pub fn ends_with(self, code: i32) -> Answer {
        assert_eq!(self.code, Some(code), "{}", self.message);
        self
    }

    /// The call failed with this code, printed no result, and said so in one message that starts or goes on like this.
    #[track_caller]
    pub fn fails(self, code: i32, expected: &str) -> Answer {
        let answer = self.ends_with(code);
        assert_eq!(String::from_utf8_lossy(&answer.out), "");
        let message = &answer.message;
        assert!(message.contains(expected), "expected `{expected}` in: {message}");
        assert!(message.starts_with("error: "), "{message}");
        assert!(!message.chars().any(|c| c.is_control() && c != '\n'), "{message:?}");
        answer
    }
}

/// The names in a folder.
pub fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}
