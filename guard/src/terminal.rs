//! The modes of a terminal, which it gets back also where the program ends in the middle of the work.

use rustix::fs::{Mode, OFlags};
use rustix::termios::{OptionalActions, Termios, isatty, tcgetattr, tcsetattr};
use std::io;
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::ptr;
use std::sync::atomic::{AtomicPtr, Ordering};

/// What gives a terminal back its usual screen, cursor and input: it shows what is held back of a frame, tells of the mouse and marks pasted
/// text no more (<https://invisible-island.net/xterm/ctlseqs/ctlseqs.html>).
const USUAL: &[u8] =
    b"\x1b[?2026l\x1b[?1006l\x1b[?1015l\x1b[?1003l\x1b[?1002l\x1b[?1000l\x1b[?2004l\x1b[?1049l\x1b[?25h";

/// How the terminal was.
struct Before {
    modes: Termios,
    /// The terminal, where it isn't standard input.
    opened: Option<OwnedFd>,
}

/// The terminal that was opened, or else standard input.
fn of(opened: &Option<OwnedFd>) -> BorrowedFd<'_> {
    match opened {
        Some(opened) => opened.as_fd(),
        None => rustix::stdio::stdin(),
    }
}

static BEFORE: AtomicPtr<Before> = AtomicPtr::new(ptr::null_mut());

/// Remembers how the terminal is, before its modes are changed: an early end of the program gives it back like that, until this is
/// [released](release_terminal).
///
/// # Errors
/// Where there is no terminal.
pub fn hold_terminal() -> io::Result<()> {
    let opened = if isatty(rustix::stdio::stdin()) {
        None
    } else {
        Some(rustix::fs::open("/dev/tty", OFlags::RDWR | OFlags::CLOEXEC, Mode::empty())?)
    };
    let modes = tcgetattr(of(&opened))?;
    put(Box::into_raw(Box::new(Before { modes, opened })));
    Ok(())
}

/// The terminal is as it was.
pub fn release_terminal() {
    put(ptr::null_mut());
}

fn put(next: *mut Before) {
    let before = BEFORE.swap(next, Ordering::SeqCst);
    if !before.is_null() {
        // SAFETY: a pointer in the place is that of a box, and the swap gives it to nobody else.
        drop(unsafe { Box::from_raw(before) });
    }
}

/// Gives the terminal back. Safe in the handler of a signal: two system calls, and what was taken out is never freed.
pub(super) fn restore() {
    let before = BEFORE.swap(ptr::null_mut(), Ordering::SeqCst);
    // SAFETY: as above; it stays valid, for nobody frees it.
    if let Some(before) = unsafe { before.as_ref() } {
        let _ = rustix::io::write(rustix::stdio::stdout(), USUAL);
        let _ = tcsetattr(of(&before.opened), OptionalActions::Now, &before.modes);
    }
}
