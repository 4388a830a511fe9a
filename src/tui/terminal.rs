//! The terminal: entered by a guard that always restores it, and read for keys, sizes and signals.
//!
//! Only this file of the module does input and output. Whatever ends the viewer (a key, an error, a panic, a signal, a
//! terminal that is gone), the terminal gets back its screen, its cursor and its modes.

use super::effect::Exit;
use crossterm::clipboard::CopyToClipboard;
use crossterm::cursor::{Hide, Show};
use crossterm::event::{
    self, DisableBracketedPaste, DisableMouseCapture, EnableBracketedPaste, EnableMouseCapture, Event, KeyEvent,
    MouseEvent,
};
use crossterm::terminal::{
    BeginSynchronizedUpdate, EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode,
    enable_raw_mode,
};
use crossterm::{execute, queue};
use ratatui::backend::CrosstermBackend;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use raywalk_guard::{hold_terminal, release_terminal};
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;
use rustix::process::{Signal, getpgrp, getsid, kill_current_process_group};
use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGWINCH};
use signal_hook::{SigId, flag, low_level};
use std::cell::Cell;
use std::fs::File;
use std::io::{self, IsTerminal, Read, Stdout, Write};
use std::mem::ManuallyDrop;
use std::os::fd::AsFd;
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Once};
use std::time::{Duration, Instant};

/// How long to wait for a key where something is to be done meanwhile.
const TICK: Duration = Duration::from_millis(50);

/// How long to wait where nothing is, until it is looked whether the terminal is still there.
const LONGEST: Duration = Duration::from_secs(1);

/// How long to wait for what has already come: keys are read only where one waits for them.
const AT_ONCE: Duration = Duration::from_millis(1);

/// The terminal in the viewer's modes. Dropping it restores the terminal.
pub(super) struct Terminal {
    /// Never dropped: it would show the cursor, as `restore` does, and panic where the terminal is gone and can't show the error.
    screen: ManuallyDrop<ratatui::Terminal<CrosstermBackend<Stdout>>>,
    signals: Signals,
    /// When the next tick is due, while somebody waits for one.
    due: Option<Instant>,
}

/// What comes from outside.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Input {
    /// A key.
    Key(KeyEvent),
    /// The mouse.
    Mouse(MouseEvent),
    /// A text that was pasted.
    Paste(String),
    /// It is time for what happens at intervals.
    Beat,
    /// Columns and rows.
    Size(u16, u16),
    /// A request to quit.
    Leave(Exit),
    /// A request to suspend.
    Suspend,
    /// Nothing has come for a moment.
    Tick,
    /// The terminal may have changed: the viewer was stopped and goes on, or something else has written.
    Resume,
}

impl Terminal {
    /// Takes the terminal over.
    pub(super) fn enter() -> io::Result<Terminal> {
        restore_before_panic_messages();
        let signals = Signals::watch()?;
        take_over()?;
        let screen = ratatui::Terminal::new(CrosstermBackend::new(io::stdout())).inspect_err(|_| restore())?;
        Ok(Terminal { screen: ManuallyDrop::new(screen), signals, due: None })
    }

    /// Columns and rows.
    pub(super) fn size(&self) -> io::Result<(u16, u16)> {
        self.screen.size().map(|size| (size.width, size.height))
    }

    /// Shows a frame, all at once where the terminal can.
    pub(super) fn draw(&mut self, paint: impl FnOnce(&mut Buffer)) -> io::Result<()> {
        queue!(io::stdout(), BeginSynchronizedUpdate)?;
        self.screen.draw(|frame| paint(frame.buffer_mut()))?;
        execute!(io::stdout(), EndSynchronizedUpdate)
    }

    /// Waits for what comes next: with `ticks` no longer than for a moment, with an interval no longer than that after the
    /// last beat.
    pub(super) fn next(&mut self, ticks: bool, interval: Option<Duration>) -> io::Result<Input> {
        let latest = interval.map(|interval| Instant::now() + interval);
        self.due = latest.map(|latest| self.due.map_or(latest, |due| due.min(latest)));
        let mut has_waited = false;
        loop {
            if let Some(input) = self.signals.take() {
                return Ok(input);
            }
            // Its signal may go to another process, such as the shell of a script.
            if is_gone() {
                return Ok(Input::Leave(Exit::HungUp));
            }
            let left = self.due.map(|due| due.saturating_duration_since(Instant::now()));
            if left == Some(Duration::ZERO) {
                self.due = None;
                return Ok(Input::Beat);
            }
            match read(AT_ONCE) {
                Ok(Some(input)) => return Ok(input),
                Ok(None) if has_waited && ticks => return Ok(Input::Tick),
                Ok(None) => {}
                Err(error) => return self.left_by(error).map(Input::Leave),
            }
            let longest = if ticks { TICK } else { LONGEST };
            self.signals.wait(left.map_or(longest, |left| left.min(longest)))?;
            has_waited = true;
        }
    }

    /// Why to leave after an error. A terminal that is gone can't be read or written, and its signal may be a moment late.
    pub(super) fn left_by(&self, error: io::Error) -> io::Result<Exit> {
        std::thread::sleep(TICK);
        match self.signals.take() {
            Some(Input::Leave(exit)) => Ok(exit),
            _ if is_gone() => Ok(Exit::HungUp),
            _ => Err(error),
        }
    }

    /// What has already come, if anything, so that a frame isn't drawn for each key of many.
    pub(super) fn next_at_once(&mut self) -> io::Result<Option<Input>> {
        match self.signals.take() {
            Some(input) => Ok(Some(input)),
            None => read(AT_ONCE),
        }
    }

    /// Asks for the mouse, or gives it back.
    pub(super) fn use_mouse(&mut self, wanted: bool) -> io::Result<()> {
        match (wanted, HAS_MOUSE.swap(wanted, Ordering::SeqCst)) {
            (true, false) => execute!(io::stdout(), EnableMouseCapture),
            (false, true) => execute!(io::stdout(), DisableMouseCapture),
            _ => Ok(()),
        }
    }

    /// Puts a text on the clipboard, where the terminal lets us.
    pub(super) fn copy(&mut self, text: &str) -> io::Result<()> {
        execute!(io::stdout(), CopyToClipboard::to_clipboard_from(text))
    }

    /// Gives the terminal to the shell and stops; says whether there is a shell to come back from.
    pub(super) fn suspend(&mut self, asked_by: Asker) -> io::Result<bool> {
        // Without job control nobody could continue us: the system ignores SIGTSTP in such a group, and so do we.
        let has_shell = getsid(None).is_ok_and(|session| session != getpgrp());
        if has_shell {
            restore();
            if asked_by == Asker::Key {
                // As the terminal itself does: a pipeline stops as a whole.
                kill_current_process_group(Signal::TSTP)?;
            }
            low_level::emulate_default_handler(SIGTSTP)?;
            self.resume()?;
        }
        Ok(has_shell)
    }

    /// Gives the terminal to the user's editor at a line of a file, and takes it back. Inside, why there is no editor, or what it ended with.
    pub(super) fn edit(&mut self, file: &Path, line: usize) -> io::Result<Result<(), String>> {
        let editor =
            ["VISUAL", "EDITOR"].into_iter().find_map(|name| std::env::var(name).ok().filter(|word| !word.is_empty()));
        restore();
        // The variable is a command with its options, as a shell reads it.
        let command = format!("{} \"$@\"", editor.unwrap_or_else(|| "vi".to_owned()));
        let mut words = Command::new("sh");
        words.args(["-c", &command, "sh", &format!("+{line}")]).arg(file);
        let status = words.status();
        self.resume()?;
        Ok(match status {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(status.to_string()),
            Err(error) => Err(error.to_string()),
        })
    }

    /// Takes the terminal over again, and redraws everything.
    pub(super) fn resume(&mut self) -> io::Result<()> {
        self.signals.forget_suspension();
        // The shell has changed the modes behind our back, so that they must really be set again.
        restore();
        take_over()?;
        // Not `clear`, which asks the terminal where its cursor is, and waits for an answer.
        let size = self.screen.size()?;
        self.screen.resize(Rect::from((Position::ORIGIN, size)))
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        restore();
    }
}

/// Who wants the viewer to stop for a while.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asker {
    /// `^Z`: everything in the foreground.
    Key,
    /// A signal to this process.
    Signal,
}

/// Whether the terminal was closed: what is left of it is none.
fn is_gone() -> bool {
    !io::stdout().is_terminal()
}

fn read(timeout: Duration) -> io::Result<Option<Input>> {
    if !event::poll(timeout)? {
        return Ok(None);
    }
    Ok(match event::read()? {
        Event::Key(key) => Some(Input::Key(key)),
        Event::Mouse(mouse) => Some(Input::Mouse(mouse)),
        Event::Paste(text) => Some(Input::Paste(text)),
        Event::Resize(width, height) => Some(Input::Size(width, height)),
        _ => None,
    })
}

/// Whether the terminal is in the viewer's modes.
static IS_TAKEN: AtomicBool = AtomicBool::new(false);

/// Whether it reports the mouse.
static HAS_MOUSE: AtomicBool = AtomicBool::new(false);

fn take_over() -> io::Result<()> {
    IS_TAKEN.store(true, Ordering::SeqCst);
    // Without it a pasted text would be read as keys.
    let modes = || execute!(io::stdout(), EnterAlternateScreen, Hide, EnableBracketedPaste);
    // Where memory runs out nothing below is called any more. A terminal that doesn't report its modes can't get them back.
    let _ = hold_terminal();
    enable_raw_mode().and_then(|()| modes()).inspect_err(|_| restore())
}

/// Gives the terminal back as it was. What fails here fails because the terminal is gone.
fn restore() {
    if IS_TAKEN.swap(false, Ordering::SeqCst) {
        let mut out = io::stdout();
        if HAS_MOUSE.swap(false, Ordering::SeqCst) {
            let _ = execute!(out, DisableMouseCapture);
        }
        let _ = execute!(out, EndSynchronizedUpdate, DisableBracketedPaste, LeaveAlternateScreen, Show);
        let _ = out.flush();
        let _ = disable_raw_mode();
        release_terminal();
    }
}

/// Whether something else has written to the screen.
static IS_STALE: AtomicBool = AtomicBool::new(false);

thread_local! {
    /// Whether this is the thread that draws.
    static DRAWS: Cell<bool> = const { Cell::new(false) };
}

/// Lets the message of a panic appear on the usual screen. The viewer goes on if it was another thread that panicked.
fn restore_before_panic_messages() {
    static HOOK: Once = Once::new();
    DRAWS.set(true);
    HOOK.call_once(|| {
        let usual = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            let goes_on = IS_TAKEN.load(Ordering::SeqCst) && !DRAWS.get();
            restore();
            usual(panic);
            if goes_on {
                IS_STALE.store(take_over().is_ok(), Ordering::SeqCst);
            }
        }));
    });
}

/// The signals that have come. While the viewer runs they only leave a note here; after it they act as usual again.
struct Signals {
    /// Where keys come from.
    keys: File,
    /// Has something to read when a signal has come.
    wakes: UnixStream,
    /// What writes there.
    writers: Vec<SigId>,
    leave: Arc<AtomicUsize>,
    suspend: Arc<AtomicBool>,
    resume: Arc<AtomicBool>,
    is_over: Arc<AtomicBool>,
}

impl Signals {
    fn watch() -> io::Result<Signals> {
        let (wakes, writer) = UnixStream::pair()?;
        wakes.set_nonblocking(true)?;
        let mut signals = Signals {
            keys: keyboard()?,
            wakes,
            writers: Vec::new(),
            leave: Arc::default(),
            suspend: Arc::default(),
            resume: Arc::default(),
            is_over: Arc::default(),
        };
        for signal in [SIGTERM, SIGINT, SIGHUP, SIGQUIT] {
            flag::register_conditional_default(signal, Arc::clone(&signals.is_over))?;
            flag::register_usize(signal, Arc::clone(&signals.leave), signal as usize)?;
        }
        flag::register_conditional_default(SIGTSTP, Arc::clone(&signals.is_over))?;
        flag::register(SIGTSTP, Arc::clone(&signals.suspend))?;
        flag::register(SIGCONT, Arc::clone(&signals.resume))?;
        // After the notes above: who is woken finds them.
        for signal in [SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT, SIGWINCH] {
            signals.writers.push(low_level::pipe::register(signal, writer.try_clone()?)?);
        }
        Ok(signals)
    }

    /// Waits until there is something to read, a signal comes, or the time is over; of a terminal that is gone at most for a moment.
    fn wait(&self, longest: Duration) -> io::Result<()> {
        let mut sources = [PollFd::new(&self.keys, PollFlags::IN), PollFd::new(&self.wakes, PollFlags::IN)];
        let until = Timespec::try_from(longest).ok();
        match poll(&mut sources, until.as_ref()) {
            Ok(_) | Err(Errno::INTR) => {}
            Err(error) => return Err(error.into()),
        }
        let gone = PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL;
        if sources[0].revents().intersects(gone) && !is_gone() {
            std::thread::sleep(TICK.min(longest));
        }
        let mut wakes = &self.wakes;
        while wakes.read(&mut [0; 64]).is_ok_and(|count| count > 0) {}
        Ok(())
    }

    fn take(&self) -> Option<Input> {
        match self.leave.load(Ordering::SeqCst) {
            0 => {}
            signal if signal == SIGINT as usize => return Some(Input::Leave(Exit::Interrupted)),
            signal if signal == SIGHUP as usize => return Some(Input::Leave(Exit::HungUp)),
            _ => return Some(Input::Leave(Exit::Terminated)),
        }
        if self.suspend.swap(false, Ordering::SeqCst) {
            return Some(Input::Suspend);
        }
        let is_stale = IS_STALE.swap(false, Ordering::SeqCst);
        let goes_on = self.resume.swap(false, Ordering::SeqCst);
        (is_stale || goes_on).then_some(Input::Resume)
    }

    fn forget_suspension(&self) {
        self.suspend.store(false, Ordering::SeqCst);
        self.resume.store(false, Ordering::SeqCst);
    }
}

impl Drop for Signals {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::SeqCst);
        for writer in self.writers.drain(..) {
            low_level::unregister(writer);
        }
    }
}

/// Where keys come from: the terminal at standard input, or else the one that this process belongs to.
fn keyboard() -> io::Result<File> {
    let input = io::stdin();
    if input.is_terminal() {
        return Ok(File::from(input.as_fd().try_clone_to_owned()?));
    }
    File::open("/dev/tty")
}
