//! The system's allocator, which ends the program where it has no memory for code that can't do without.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::io::{self, Read, Write};

/// The system's allocator. Where it fails, an [`attempt`] is told so; any other allocation ends the program, as it would anyway, but with
/// a message, an exit code and without unfinished files.
#[derive(Debug, Default)]
pub struct Allocator {
    /// The exit code.
    code: u8,
}

impl Allocator {
    /// One that ends the program with this exit code.
    pub const fn new(code: u8) -> Allocator {
        Allocator { code }
    }

    /// Hands on what the system gave.
    #[inline(always)]
    fn given(&self, memory: *mut u8, bytes: usize) -> *mut u8 {
        if memory.is_null() {
            self.fail(bytes);
        }
        memory
    }

    /// There is no memory: goes on in an attempt only.
    #[cold]
    #[inline(never)]
    fn fail(&self, bytes: usize) {
        if ATTEMPTS.try_with(Cell::get).unwrap_or(0) > 0 {
            return;
        }
        super::wait_for_turn(self.code);
        let mut message = [0; 100];
        let room = message.len();
        let mut left = &mut message[..];
        // Without an allocation; a text that is too long would be cut off.
        let _ = writeln!(left, "error: not enough memory: another {bytes} bytes were asked for");
        let written = room - left.len();
        super::end(self.code, &message[..written])
    }
}

// SAFETY: every call is passed on to the system's allocator as it is, and what that gives is handed back as it is.
unsafe impl GlobalAlloc for Allocator {
    #[inline]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are those that the system's allocator asks for.
        self.given(unsafe { System.alloc(layout) }, layout.size())
    }

    #[inline]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        self.given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    #[inline]
    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, bytes: usize) -> *mut u8 {
        // SAFETY: as above.
        self.given(unsafe { System.realloc(memory, layout, bytes) }, bytes)
    }

    #[inline]
    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(memory, layout) }
    }
}

thread_local! {
    /// How many attempts this thread is in.
    static ATTEMPTS: Cell<u32> = const { Cell::new(0) };
}

/// Does something in which an allocation may fail, because it says so: `try_reserve`, and what of the standard library returns
/// [`OutOfMemory`](std::io::ErrorKind::OutOfMemory).
pub fn attempt<T>(work: impl FnOnce() -> T) -> T {
    struct Attempt;
    impl Drop for Attempt {
        fn drop(&mut self) {
            ATTEMPTS.set(ATTEMPTS.get() - 1);
        }
    }
    ATTEMPTS.set(ATTEMPTS.get() + 1);
    let _attempt = Attempt;
    work()
}

/// Whether there is memory for this many bytes at this moment: asked before the work that will take them, in whose middle an allocation that
/// fails could only end the program.
pub fn has_room_for(bytes: usize) -> bool {
    attempt(|| Vec::<u8>::new().try_reserve_exact(bytes)).is_ok()
}

/// Input whose reader has to be given its memory, also where what is read is [attempted](attempt): what unpacks has no way to say that there
/// is none.
#[derive(Debug)]
pub struct Demanding<R>(pub R);

impl<R: Read> Read for Demanding<R> {
    fn read(&mut self, place: &mut [u8]) -> io::Result<usize> {
        struct Restored(u32);
        impl Drop for Restored {
            fn drop(&mut self) {
                ATTEMPTS.set(self.0);
            }
        }
        let _restored = Restored(ATTEMPTS.replace(0));
        self.0.read(place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::catch_unwind;

    #[global_allocator]
    static ALLOCATOR: Allocator = Allocator::new(3);

    #[test]
    fn an_attempt_may_fail() {
        let too_much = isize::MAX as usize;
        assert!(attempt(|| Vec::<u8>::new().try_reserve_exact(too_much)).is_err());
        assert!(attempt(|| vec![1_u8; 100].try_reserve_exact(too_much - 100)).is_err());
        // Also one in which something else went wrong.
        assert!(catch_unwind(|| attempt(|| std::panic::resume_unwind(Box::new(())))).is_err());
        assert_eq!(ATTEMPTS.get(), 0);
        // What reads in one isn't in it.
        struct Asks;
        impl Read for Asks {
            fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
                assert_eq!(ATTEMPTS.get(), 0);
                Ok(0)
            }
        }
        attempt(|| {
            assert_eq!(Demanding(Asks).read(&mut [0]).expect("it is read"), 0);
            assert_eq!(ATTEMPTS.get(), 1);
        });
        let list: Vec<u32> = (0..100_000).collect();
        assert_eq!(list.iter().map(|x| u64::from(*x)).sum::<u64>(), 4_999_950_000);
    }
}
