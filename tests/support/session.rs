//! A program in a pseudo-terminal, with the screen that it draws.

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::io::{Read, Write};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// A running viewer and the screen that it draws.
pub struct Session {
    pub child: Box<dyn Child + Send + Sync>,
    pub master: Box<dyn MasterPty + Send>,
    pub keys: Box<dyn Write + Send>,
    pub screen: Arc<Mutex<vt100::Parser>>,
    /// Everything that the program wrote.
    pub written: Arc<Mutex<Vec<u8>>>,
}

type Spawned = (Box<dyn Child + Send + Sync>, Box<dyn MasterPty + Send>, Box<dyn Read + Send>);

/// A program in a pseudo-terminal, the terminal, and what reads from it.
pub fn spawned(program: &OsStr, arguments: &[&str], columns: u16, rows: u16) -> Spawned {
    let size = PtySize { rows, cols: columns, pixel_width: 0, pixel_height: 0 };
    let pair = native_pty_system().openpty(size).expect("a pseudo-terminal");
    let mut command = CommandBuilder::new(program);
    command.args(arguments);
    command.cwd(env!("CARGO_MANIFEST_DIR"));
    command.env("TERM", "xterm-256color");
    // Nobody asks the terminal what it is like.
    command.env("COLORFGBG", "15;0");
    command.env("LC_ALL", "C.UTF-8");
    // Whoever runs the tests may have a configuration of their own.
    command.env("RAYWALK_CONFIG", "none");
    command.env_remove("NO_COLOR");
    let child = pair.slave.spawn_command(command).expect("the program starts");
    let reader = pair.master.try_clone_reader().expect("a reader");
    (child, pair.master, reader)
}

pub const PATIENCE: Duration = Duration::from_secs(20);

impl Session {
    pub fn start(arguments: &[&str], columns: u16, rows: u16) -> Session {
        Session::of(env!("CARGO_BIN_EXE_raywalk").as_ref(), arguments, columns, rows)
    }

    /// A program in a pseudo-terminal.
    pub fn of(program: &OsStr, arguments: &[&str], columns: u16, rows: u16) -> Session {
        let (child, master, mut reader) = spawned(program, arguments, columns, rows);
        let keys = master.take_writer().expect("a writer");
        let screen = Arc::new(Mutex::new(vt100::Parser::new(rows.max(1), columns.max(1), 0)));
        let written = Arc::new(Mutex::new(Vec::new()));
        let (screen_here, written_here) = (screen.clone(), written.clone());
        thread::spawn(move || {
            let mut buffer = [0; 4096];
            while let Ok(count) = reader.read(&mut buffer) {
                if count == 0 {
                    break;
                }
                screen_here.lock().expect("the screen").process(&buffer[..count]);
                written_here.lock().expect("the output").extend_from_slice(&buffer[..count]);
            }
        });
        Session { child, master, keys, screen, written }
    }

    pub fn press(&mut self, keys: &str) {
        self.keys.write_all(keys.as_bytes()).expect("keys are read");
        self.keys.flush().expect("keys are read");
    }

    pub fn text(&self) -> String {
        self.screen.lock().expect("the screen").screen().contents()
    }

    /// Waits until the screen shows a text.
    #[track_caller]
    pub fn shows(&self, expected: &str) {
        let start = Instant::now();
        while !self.text().contains(expected) {
            assert!(start.elapsed() < PATIENCE, "expected `{expected}` on:\n{}", self.text());
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// Whether the program has written this.
    pub fn has_written(&self, text: &str) -> bool {
        String::from_utf8_lossy(&self.written.lock().expect("the output")).contains(text)
    }

    /// The numbers of the colours that the program has written with, of letters and of what is behind them.
    pub fn colors(&self) -> BTreeSet<u8> {
        let written = self.written.lock().expect("the output");
        let text = String::from_utf8_lossy(&written);
        let of_sequence = |sequence: &str| -> Vec<u8> {
            let parameters = sequence.split(|c: char| !c.is_ascii_digit() && c != ';').next().unwrap_or_default();
            let numbers: Vec<&str> = parameters.split(';').collect();
            let colors = numbers.windows(3).filter(|three| matches!(three, ["38" | "48", "5", _]));
            colors.filter_map(|three| three[2].parse().ok()).collect()
        };
        text.split("\x1b[").flat_map(of_sequence).collect()
    }

    /// Waits until the screen no longer shows a text.
    #[track_caller]
    pub fn hides(&self, unexpected: &str) {
        let start = Instant::now();
        while self.text().contains(unexpected) {
            assert!(start.elapsed() < PATIENCE, "unexpected `{unexpected}` on:\n{}", self.text());
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// Waits until the screen is the usual one, or the viewer's, with its cursor shown or hidden.
    #[track_caller]
    pub fn is_taken(&self, is_taken: bool) {
        let start = Instant::now();
        let state = || {
            let screen = self.screen.lock().expect("the screen");
            let screen = screen.screen();
            // A shell may want pasted text marked, too.
            [screen.alternate_screen(), screen.hide_cursor(), screen.bracketed_paste() || !is_taken]
        };
        while state() != [is_taken, is_taken, true] {
            assert!(
                start.elapsed() < PATIENCE,
                "alternate screen, cursor hidden, pasted text marked: {:?}\n{}",
                state(),
                self.text()
            );
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// Waits until the terminal reports the mouse to the program, or no longer does.
    #[track_caller]
    pub fn has_mouse(&self, is_told: bool) {
        let start = Instant::now();
        let mode = || self.screen.lock().expect("the screen").screen().mouse_protocol_mode();
        while (mode() != vt100::MouseProtocolMode::None) != is_told {
            assert!(start.elapsed() < PATIENCE, "the mouse: {:?}\n{}", mode(), self.text());
            thread::sleep(Duration::from_millis(10));
        }
    }

    pub fn resize(&self, columns: u16, rows: u16) {
        // The emulator can't put a wide character, of a frame that was on its way, into a single column, nor break a long
        // line of one in a single row.
        self.screen.lock().expect("the screen").screen_mut().set_size(rows.max(2), columns.max(2));
        let size = PtySize { rows, cols: columns, pixel_width: 0, pixel_height: 0 };
        self.master.resize(size).expect("a resize");
    }

    pub fn signal(&self, name: &str) {
        let id = self.child.process_id().expect("a process").to_string();
        let sent = std::process::Command::new("kill").args(["-s", name, &id]).status().expect("kill runs");
        assert!(sent.success());
    }

    /// Waits for the end; gives the exit code. The terminal must be as it was.
    #[track_caller]
    pub fn ends_with(&mut self, code: u32) {
        let start = Instant::now();
        let status = loop {
            if let Some(status) = self.child.try_wait().expect("a status") {
                break status;
            }
            assert!(start.elapsed() < PATIENCE, "the viewer goes on:\n{}", self.text());
            thread::sleep(Duration::from_millis(10));
        };
        assert_eq!(status.exit_code(), code);
        // What was written last may still be on its way.
        thread::sleep(Duration::from_millis(200));
        let screen = self.screen.lock().expect("the screen");
        assert!(!screen.screen().alternate_screen(), "the alternate screen was left on");
        assert!(!screen.screen().hide_cursor(), "the cursor was left hidden");
        assert!(!screen.screen().bracketed_paste(), "pasted text is still marked");
        assert!(self.is_cooked(), "the terminal was left in raw mode");
    }

    /// Whether the terminal echoes and edits lines, as it did before.
    pub fn is_cooked(&self) -> bool {
        let Some(name) = self.master.tty_name() else { return true };
        let said = std::process::Command::new("stty").arg("-a").arg("-F").arg(name).output();
        // Once the last program has left, a pseudo-terminal may have no modes to ask for.
        said.map_or(true, |said| {
            let modes = String::from_utf8_lossy(&said.stdout).into_owned();
            modes.is_empty() || (modes.contains(" icanon") && modes.contains(" echo "))
        })
    }
}
