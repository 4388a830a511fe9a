//! How the system's allocator hands out large pieces of memory.

/// From this size on a piece of memory is given back to the system as soon as it is free: 1 MiB.
const LARGE: i32 = 1 << 20;

/// So much that is free at the end of all others stays with the program: 16 MiB.
const KEPT: i32 = 16 << 20;

/// An arena of the GNU C library takes this many addresses: 64 MiB, whatever is in it.
const ARENA: u64 = 64 << 20;

/// Large pieces lie apart from small ones, and are given back as soon as they are free.
///
/// The allocator of the GNU C library grows what it calls large by what was given back, up to 32 MiB: of a list of that size the room stayed
/// with the program, where nothing as large fits any more when there is something small in it. It also begins an arena for each of the first threads: where
/// addresses are limited (`ulimit -v`), all arenas together get a quarter of them. Elsewhere this does nothing.
pub fn give_back_large_pieces() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    {
        // From malloc.h.
        const M_TRIM_THRESHOLD: i32 = -1;
        const M_MMAP_THRESHOLD: i32 = -3;
        const M_ARENA_MAX: i32 = -8;
        let arenas = rustix::process::getrlimit(rustix::process::Resource::As)
            .current
            .map(|addresses| i32::try_from(addresses / 4 / ARENA).unwrap_or(i32::MAX).max(1));
        unsafe extern "C" {
            fn mallopt(parameter: i32, value: i32) -> i32;
        }
        // SAFETY: the function takes two numbers, is declared as malloc.h has it, and may be called at any time: it locks what it changes.
        // Where it refuses, all stays as it was.
        unsafe {
            mallopt(M_TRIM_THRESHOLD, KEPT);
            mallopt(M_MMAP_THRESHOLD, LARGE);
            if let Some(arenas) = arenas {
                mallopt(M_ARENA_MAX, arenas);
            }
        }
    }
}
