//! How the program goes on where it is interrupted, and ends where it can't: unfinished files go, a message says why, and so does the exit
//! code.
//!
//! Two events can end it in the middle of the work: a signal, and an allocation that fails in code that has no way to say so. Neither
//! may allocate, take a lock or run destructors, so both do the same few system calls: remove the files, give the terminal back, write
//! the message, end.

mod allocator;
mod patient;
mod pieces;
mod streams;
mod terminal;
mod unfinished;

pub use allocator::{Allocator, Demanding, attempt, has_room_for};
pub use patient::{Patient, retried};
pub use pieces::give_back_large_pieces;
pub use streams::{stdin_was_closed, stdout_was_closed};
pub use terminal::{hold_terminal, release_terminal};
pub use unfinished::Unfinished;

use signal_hook::SigId;
use signal_hook::low_level::{exit, register, unregister};
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::sleep;
use std::time::Duration;

/// Whether a thread has begun to end the program.
static ENDING: AtomicBool = AtomicBool::new(false);

/// Whether it has removed what is unfinished: all that is left is to say why, which may wait for a reader forever.
static REMOVED: AtomicBool = AtomicBool::new(false);

/// Signals that end the program, until this is [given up](Endings::give_up).
#[derive(Debug)]
pub struct Endings(Vec<SigId>);

impl Endings {
    /// Ends the program on each of these signals with its exit code, in whatever it is at that moment.
    ///
    /// # Errors
    /// Where the system refuses a handler; those before it stay.
    pub fn on(signals: impl IntoIterator<Item = (i32, u8)>) -> io::Result<Endings> {
        let mut endings = Endings(Vec::new());
        for (signal, code) in signals {
            let handler = move || {
                if !ENDING.swap(true, Ordering::SeqCst) {
                    end(code, b"");
                }
                // A thread that ends the program already may be the one that was interrupted: it goes on, but waits for nobody.
                if REMOVED.load(Ordering::SeqCst) {
                    exit(code.into());
                }
            };
            // SAFETY: the handler swaps atomic values and calls `unlink`, `tcsetattr`, `write` and `_exit`, which POSIX lists among the functions that are
            // safe in handlers of signals. It neither allocates nor locks nor panics.
            endings.0.push(unsafe { register(signal, handler) }?);
        }
        Ok(endings)
    }

    /// From here on they do nothing.
    pub fn give_up(self) {
        for id in self.0 {
            unregister(id);
        }
    }
}

/// Ends the program with this code instead of a core dump where it aborts itself: an allocation that failed in spite of
/// [`Allocator`], a stack that overflowed, a panic in a panic. The reason is on standard error already.
///
/// # Errors
/// Where the system refuses the handler.
pub fn end_on_abort(signal: i32, code: u8) -> io::Result<()> {
    let handler = move || {
        wait_for_turn(code);
        end(code, b"error: the program had to end in the middle of its work\n");
    };
    // SAFETY: as above; `wait_for_turn` only sleeps.
    unsafe { register(signal, handler) }.map(|_| ())
}

/// Goes on in the one thread that ends the program; any other waits here for the end, but no longer than removing files takes: the thread
/// that ends the program may be the one that was interrupted.
fn wait_for_turn(code: u8) {
    const MOST: u32 = 1000;
    let mut waited = 0;
    while ENDING.swap(true, Ordering::SeqCst) {
        if waited == MOST {
            exit(code.into());
        }
        sleep(Duration::from_millis(1));
        waited += 1;
    }
}

/// Removes unfinished files, says why, and ends at once.
fn end(code: u8, message: &[u8]) -> ! {
    unfinished::remove_all();
    terminal::restore();
    REMOVED.store(true, Ordering::SeqCst);
    let mut left = message;
    while !left.is_empty() {
        match rustix::io::write(io::stderr(), left) {
            Ok(written) if written > 0 => left = &left[written..],
            Err(rustix::io::Errno::INTR) => {}
            // Where standard error is closed or full there is nobody to tell.
            _ => break,
        }
    }
    exit(code.into())
}
