//! Runs a command under `ptrace` and lets one of its system calls fail.
//!
//! Calls are counted over all threads of the command, from the start of Rust's runtime on, so that what the dynamic loader does isn't among
//! them. It works where replaced library functions wouldn't: for crates that call the kernel themselves, too.

use nix::errno::Errno;
use nix::libc;
use nix::sys::ptrace::{self, Options};
use nix::sys::signal::{Signal, kill, killpg};
use nix::sys::wait::{WaitPidFlag, WaitStatus, waitpid};
use nix::unistd::Pid;
use std::collections::HashMap;
use std::fs::{self, File};
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// A command that takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(60);

/// What may fail: what reads, writes and orders files, and what asks for memory.
const CALLS: [(i64, &str); 27] = [
    (libc::SYS_read, "read"),
    (libc::SYS_readv, "readv"),
    (libc::SYS_pread64, "pread64"),
    (libc::SYS_write, "write"),
    (libc::SYS_writev, "writev"),
    (libc::SYS_pwrite64, "pwrite64"),
    (libc::SYS_open, "open"),
    (libc::SYS_openat, "openat"),
    (libc::SYS_fsync, "fsync"),
    (libc::SYS_fdatasync, "fdatasync"),
    (libc::SYS_rename, "rename"),
    (libc::SYS_renameat, "renameat"),
    (libc::SYS_renameat2, "renameat2"),
    (libc::SYS_link, "link"),
    (libc::SYS_linkat, "linkat"),
    (libc::SYS_unlink, "unlink"),
    (libc::SYS_unlinkat, "unlinkat"),
    (libc::SYS_ftruncate, "ftruncate"),
    (libc::SYS_lseek, "lseek"),
    (libc::SYS_statx, "statx"),
    (libc::SYS_fstat, "fstat"),
    (libc::SYS_newfstatat, "newfstatat"),
    (libc::SYS_fchmod, "fchmod"),
    (libc::SYS_flock, "flock"),
    (libc::SYS_mmap, "mmap"),
    (libc::SYS_mremap, "mremap"),
    (libc::SYS_brk, "brk"),
];

/// What happens to a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It fails with this error and does nothing.
    Error(Errno),
    /// It and all further calls of its name fail with this error, but for messages on standard error.
    ErrorsFromNowOn(Errno),
    /// From it on there is no more memory.
    NoMoreMemory,
    /// It reads or writes half of what was asked for.
    Short,
    /// The command is killed before it.
    Kill,
}

/// A call that was counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Call {
    /// Its name.
    pub name: &'static str,
    /// Its first argument, of most calls a file descriptor.
    pub first: u64,
    /// Its third argument, of reading and writing a length.
    pub length: u64,
}

impl Call {
    /// Whether it writes to this file descriptor.
    pub fn writes_to(&self, descriptor: u64) -> bool {
        self.name.contains("write") && self.first == descriptor
    }

    /// Whether it asks for memory.
    pub fn asks_for_memory(&self) -> bool {
        matches!(self.name, "mmap" | "mremap" | "brk")
    }

    /// Whether it reads or writes.
    pub fn transfers(&self) -> bool {
        self.name.contains("write") || self.name.contains("read")
    }
}

/// What a traced command did.
pub struct Traced {
    /// How it ended.
    pub status: ExitStatus,
    /// What it wrote to standard output.
    pub out: Vec<u8>,
    /// What it wrote to standard error.
    pub message: String,
    /// All calls that can fail, in their order.
    pub calls: Vec<Call>,
}

/// Whether commands can be traced here; containers may forbid it.
pub fn can_trace() -> bool {
    let folder = tempfile::tempdir().expect("a folder");
    Tracer::of(&mut stopped(folder.path(), "true", &[])).is_ok_and(|tracer| tracer.run(None).is_ok())
}

/// Runs a program in a folder to its end. The call of the number, the first being 0, meets the fault.
pub fn run(folder: &Path, program: &str, arguments: &[&str], fault: Option<(usize, Fault)>) -> Traced {
    let places = tempfile::tempdir().expect("a folder");
    let [out, message] = ["out", "message"].map(|name| places.path().join(name));
    let file = |path: &Path| File::create(path).expect("a file");
    let mut command = stopped(folder, program, arguments);
    let tracer = Tracer::of(command.stdout(file(&out)).stderr(file(&message))).expect("it is traced");
    let (status, calls) = tracer.run(fault).expect("it is traced to its end");
    let message = String::from_utf8_lossy(&fs::read(message).expect("the message")).into_owned();
    Traced { status, out: fs::read(out).expect("the output"), message, calls }
}

/// A program that waits for its tracer: a shell that stops itself, and then becomes the program.
fn stopped(folder: &Path, program: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", "kill -STOP $$; exec \"$0\" \"$@\"", program]).args(arguments);
    // Its process group tells its threads from what other tests run.
    command.current_dir(folder).stdin(Stdio::null()).env_remove("NO_COLOR").process_group(0);
    command
}

struct Tracer {
    child: Child,
    group: Pid,
    /// Whether Rust's runtime has started, whose first call this is.
    has_begun: bool,
    calls: Vec<Call>,
    fault: Option<(usize, Fault)>,
    /// The threads in a call with other arguments, and their own. A command expects to find them again.
    altered: HashMap<Pid, [u64; 2]>,
}

impl Tracer {
    fn of(command: &mut Command) -> nix::Result<Tracer> {
        let child = command.spawn().expect("a shell");
        let group = Pid::from_raw(child.id().cast_signed());
        let tracer = Tracer { child, group, has_begun: false, calls: Vec::new(), fault: None, altered: HashMap::new() };
        waitpid(group, Some(WaitPidFlag::WUNTRACED))?;
        let options = Options::PTRACE_O_TRACESYSGOOD
            | Options::PTRACE_O_TRACECLONE
            | Options::PTRACE_O_TRACEEXEC
            | Options::PTRACE_O_EXITKILL;
        if let Err(error) = ptrace::seize(group, options) {
            let _ = killpg(group, Signal::SIGKILL);
            return Err(error);
        }
        killpg(group, Signal::SIGCONT)?;
        Ok(tracer)
    }

    /// Follows all threads to their end.
    fn run(mut self, fault: Option<(usize, Fault)>) -> nix::Result<(ExitStatus, Vec<Call>)> {
        self.fault = fault;
        let group = self.group;
        let (ended, end) = mpsc::channel::<()>();
        let watchdog = thread::spawn(move || {
            let hangs = end.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout);
            if hangs {
                let _ = killpg(group, Signal::SIGKILL);
            }
            hangs
        });
        let status = self.follow();
        // Its end has been seen; the standard library sees it.
        let _ = self.child.try_wait();
        drop(ended);
        assert!(!watchdog.join().expect("a watchdog"), "hangs, with the fault {fault:?}");
        Ok((status?, self.calls))
    }

    fn follow(&mut self) -> nix::Result<ExitStatus> {
        let any = Pid::from_raw(-self.group.as_raw());
        loop {
            // What a signal was for is forgotten by `wait`'s types; the number is what counts.
            let stop = match waitpid(any, Some(WaitPidFlag::__WALL)) {
                Ok(stop) => stop,
                Err(Errno::EINTR) => continue,
                Err(error) => return Err(error),
            };
            let resumed = match stop {
                WaitStatus::Exited(pid, code) if pid == self.group => return Ok(ExitStatus::from_raw(code << 8)),
                WaitStatus::Signaled(pid, signal, _) if pid == self.group => {
                    return Ok(ExitStatus::from_raw(signal as i32));
                }
                WaitStatus::PtraceSyscall(thread) => self.meet(thread).and_then(|()| ptrace::syscall(thread, None)),
                WaitStatus::PtraceEvent(thread, ..) => ptrace::syscall(thread, None),
                WaitStatus::Stopped(thread, signal) => {
                    let signal = Some(signal).filter(|signal| !matches!(signal, Signal::SIGSTOP | Signal::SIGTRAP));
                    ptrace::syscall(thread, signal)
                }
                _ => Ok(()),
            };
            match resumed {
                // The thread has been killed meanwhile.
                Ok(()) | Err(Errno::ESRCH) => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// A thread is about to make a call, or comes back from one.
    fn meet(&mut self, thread: Pid) -> nix::Result<()> {
        let mut registers = ptrace::getregs(thread)?;
        let about_to = registers.rax.cast_signed() == -i64::from(libc::ENOSYS);
        if !about_to {
            if let Some([first, third]) = self.altered.remove(&thread) {
                (registers.rdi, registers.rdx) = (first, third);
                ptrace::setregs(thread, registers)?;
            }
            return Ok(());
        }
        let number = registers.orig_rax.cast_signed();
        if number == libc::SYS_poll && registers.rsi == 3 {
            self.has_begun = true;
        }
        let Some((_, name)) = CALLS.iter().find(|(call, _)| *call == number && self.has_begun) else { return Ok(()) };
        let call = Call { name, first: registers.rdi, length: registers.rdx };
        let at = self.calls.len();
        self.calls.push(call);
        let Some((first, fault)) = self.fault else { return Ok(()) };
        let is_hit = match fault {
            Fault::ErrorsFromNowOn(_) => at >= first && self.calls[first].name == *name && !call.writes_to(2),
            Fault::NoMoreMemory => at >= first && call.asks_for_memory(),
            _ => at == first,
        };
        if !is_hit {
            return Ok(());
        }
        self.altered.insert(thread, [registers.rdi, registers.rdx]);
        match fault {
            Fault::Error(error) | Fault::ErrorsFromNowOn(error) => fails_with(error, &mut registers),
            // It never fails, but gives the end that the memory has; asked for none it does so and does nothing.
            Fault::NoMoreMemory if call.name == "brk" => registers.rdi = 0,
            Fault::NoMoreMemory => fails_with(Errno::ENOMEM, &mut registers),
            Fault::Short => registers.rdx = registers.rdx.div_ceil(2),
            Fault::Kill => return kill(self.group, Signal::SIGKILL),
        }
        ptrace::setregs(thread, registers)
    }
}

fn fails_with(error: Errno, registers: &mut libc::user_regs_struct) {
    // No call has this number, so that the kernel does nothing and leaves the result as it is.
    registers.orig_rax = u64::MAX;
    registers.rax = (-i64::from(error as i32)).cast_unsigned();
}
