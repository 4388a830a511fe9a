//! On how many threads work is shared: a pool that is begun when there is enough work for it, and kept.
//!
//! Everything else calls rayon as if a pool were there. Work that is small, or meant for one thread, stays on the thread that asks. What is
//! computed depends on neither, so where the system lets no more threads start the work goes on with those that it has.

use rayon::{ThreadBuilder, ThreadPool, ThreadPoolBuilder};
use raywalk_guard::has_room_for;
use std::cell::Cell;
use std::io;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, available_parallelism};

/// How many threads the command was asked to use; 0 is one per core.
static WANTED: AtomicUsize = AtomicUsize::new(0);

/// The pool that was begun last, and how many threads were asked for then.
static POOL: Mutex<Option<(usize, Arc<ThreadPool>)>> = Mutex::new(None);

thread_local! {
    /// Whether this thread works by itself until there is work to share.
    static IS_ALONE: Cell<bool> = const { Cell::new(false) };
}

/// This many threads, or as many of them as could be started.
#[derive(Clone, Debug)]
pub struct Threads(Workers);

#[derive(Clone, Debug)]
enum Workers {
    /// The thread that asks.
    Alone,
    /// Those of the pool that this is called in.
    Here,
    /// Those of a pool.
    Pool(Arc<ThreadPool>),
}

/// The default number of threads from here on; 0 is one per core.
pub fn want(count: usize) {
    WANTED.store(count, Ordering::Relaxed);
}

/// The argument of [`want`].
pub fn wanted() -> usize {
    WANTED.load(Ordering::Relaxed)
}

/// Lets the current thread do by itself what isn't [shared](share): without this rayon would begin a pool of its own for any small
/// parallel work.
pub fn work_alone() {
    if rayon::current_thread_index().is_some() {
        return;
    }
    let pool = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    // The pool is this thread, and ends with it.
    if let Ok(pool) = pool {
        std::mem::forget(pool);
        IS_ALONE.set(true);
    }
}

/// Does work on this many items, each of them little, on the threads that were [wanted](want) if it is enough for several.
pub fn share<T: Send>(items: usize, work: impl FnOnce() -> T + Send) -> T {
    /// Fewer are done before a thread has started.
    const FEW: usize = 1 << 14;
    /// So many are worth a thread.
    const EACH: usize = 1 << 12;
    let is_shared = !IS_ALONE.get() && rayon::current_thread_index().is_some();
    if is_shared || items < FEW { work() } else { Threads::of(wanted(), items / EACH).run(work) }
}

impl Threads {
    /// Threads for this many pieces of work: as many as are wanted (0 is one per core) but no more than there are pieces.
    pub fn of(wanted: usize, pieces: usize) -> Threads {
        let most = if wanted == 0 { cores() } else { wanted };
        let count = most.min(pieces);
        let here =
            if IS_ALONE.get() { None } else { rayon::current_thread_index().map(|_| rayon::current_num_threads()) };
        Threads(match here {
            _ if count <= 1 => Workers::Alone,
            Some(here) if here == count => Workers::Here,
            _ => pool(count, most).map_or(Workers::Alone, Workers::Pool),
        })
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        match &self.0 {
            Workers::Alone => 1,
            Workers::Here => rayon::current_num_threads(),
            Workers::Pool(pool) => pool.current_num_threads(),
        }
    }

    /// Does the work on them.
    pub fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Workers::Pool(pool) => pool.install(work),
            Workers::Here => work(),
            Workers::Alone if rayon::current_thread_index().is_some() && rayon::current_num_threads() == 1 => {
                let _unshared = Unshared(IS_ALONE.replace(false));
                work()
            }
            // Outside of any pool rayon would begin one of its own, and that of somebody else has more threads than are wanted.
            Workers::Alone => match begin(1) {
                Some(pool) => pool.install(work),
                None => work(),
            },
        }
    }

    /// Does one task on them while the thread that asks does another, which gets what the first hands over: a few pieces at a time, in
    /// their order. Alone one comes after the other, piece by piece.
    ///
    /// # Errors
    /// The first of `take`, after which nothing more is made.
    pub fn hand_over<T: Send, E>(
        &self,
        mut make: impl FnMut() -> Option<T> + Send,
        mut take: impl FnMut(T) -> Result<(), E>,
    ) -> Result<(), E> {
        let Workers::Pool(pool) = &self.0 else {
            while let Some(made) = self.run(&mut make) {
                take(made)?;
            }
            return Ok(());
        };
        pool.in_place_scope(|scope| {
            // While one piece is taken the next is made, and no more, so that memory doesn't grow where taking is slow.
            let (sender, receiver) = std::sync::mpsc::sync_channel(1);
            scope.spawn(move |_| {
                while let Some(made) = make() {
                    if sender.send(made).is_err() {
                        return;
                    }
                }
            });
            receiver.into_iter().try_for_each(&mut take)
        })
    }
}

/// Work that is meant for one thread: nothing within it is shared.
struct Unshared(bool);

impl Drop for Unshared {
    fn drop(&mut self) {
        IS_ALONE.set(self.0);
    }
}

/// How many cores the program may use.
fn cores() -> usize {
    available_parallelism().map_or(1, usize::from)
}

/// A pool of `count` threads or of as many as can be started, but of no more than `most`; `None` where there aren't two.
fn pool(count: usize, most: usize) -> Option<Arc<ThreadPool>> {
    let mut kept = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((asked, pool)) = &*kept
        && *asked >= count
        && pool.current_num_threads() <= most
    {
        return Some(Arc::clone(pool));
    }
    let pool = Arc::new(begin(count).filter(|pool| count == 1 || pool.current_num_threads() > 1)?);
    *kept = Some((count, Arc::clone(&pool)));
    Some(pool)
}

/// Begins as many of these threads as the system lets start. `None` where that is none.
fn begin(count: usize) -> Option<ThreadPool> {
    // Each waits for its number in the pool: how many a pool has must be known before.
    let mut waiting: Vec<Sender<ThreadBuilder>> = Vec::new();
    for _ in 0..count_with_room(count) {
        let (sender, receiver) = channel::<ThreadBuilder>();
        let work = move || {
            if let Ok(thread) = receiver.recv() {
                thread.run();
            }
        };
        if thread::Builder::new().spawn(work).is_err() {
            break;
        }
        waiting.push(sender);
    }
    let pool = ThreadPoolBuilder::new().num_threads(waiting.len().max(1)).spawn_handler(|thread| {
        let sent = waiting.pop().is_some_and(|sender| sender.send(thread).is_ok());
        if sent { Ok(()) } else { Err(io::ErrorKind::WouldBlock.into()) }
    });
    pool.build().ok()
}

/// For how many threads there is room: one that has begun and finds no memory could only abort. Most of the memory is for the work.
fn count_with_room(mut count: usize) -> usize {
    /// What a thread of the standard library gets as its stack.
    const STACK: usize = 2 << 20;
    /// How many times as much must be there.
    const ROOM: usize = 4;
    let is_room = |count: usize| has_room_for(count.saturating_mul(ROOM * STACK));
    while count > 0 && !is_room(count) {
        count /= 2;
    }
    count
}

#[cfg(test)]
mod tests;
