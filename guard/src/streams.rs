//! Which standard streams were closed when the program was started.
//!
//! Before `main` the standard library opens `/dev/null` in the places of closed streams, and nothing tells that from a `/dev/null` which
//! whoever started the program wanted. So they are looked at before that, by a function which the system calls as soon as the
//! program is loaded.

use std::sync::atomic::{AtomicBool, Ordering};

static CLOSED: [AtomicBool; 2] = [const { AtomicBool::new(false) }; 2];

/// Whether standard input was closed when the program was started; false where the system doesn't tell.
pub fn stdin_was_closed() -> bool {
    CLOSED[0].load(Ordering::Relaxed)
}

/// The same of standard output.
pub fn stdout_was_closed() -> bool {
    CLOSED[1].load(Ordering::Relaxed)
}

#[cfg(any(target_os = "linux", target_os = "freebsd", target_vendor = "apple"))]
mod before_main {
    use super::CLOSED;
    use rustix::io::{Errno, fcntl_getfd};
    use std::os::fd::BorrowedFd;
    use std::sync::atomic::Ordering;

    extern "C" fn look() {
        for (number, closed) in (0..).zip(&CLOSED) {
            // SAFETY: the contract of `borrow_raw` is for whoever uses the descriptor. It is used for one system call, which is there to ask
            // whether it is one and does nothing to it; nothing else runs yet.
            let stream = unsafe { BorrowedFd::borrow_raw(number) };
            closed.store(fcntl_getfd(stream) == Err(Errno::BADF), Ordering::Relaxed);
        }
    }

    // SAFETY: the section is a list of such functions. This one needs nothing of the standard library that `main` would set up: it makes two
    // system calls and stores what they say.
    #[used]
    #[cfg_attr(not(target_vendor = "apple"), unsafe(link_section = ".init_array"))]
    #[cfg_attr(target_vendor = "apple", unsafe(link_section = "__DATA,__mod_init_func"))]
    static LOOK: extern "C" fn() = look;
}
