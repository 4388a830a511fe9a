//! The paths of unfinished files, kept where the handler of a signal can read them: in atomic pointers, of which whoever takes one out
//! owns what it points to.

use std::ffi::CString;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr;
use std::sync::atomic::{AtomicPtr, Ordering};

/// More files than are ever unfinished at a time: a picture and its layers, or what the rays of one scene met.
const PLACES: usize = 64;

static PATHS: [AtomicPtr<CString>; PLACES] = [const { AtomicPtr::new(ptr::null_mut()) }; PLACES];

/// A file that is removed if the program ends early, until this is dropped.
#[derive(Debug)]
pub struct Unfinished {
    /// Where its path is kept, and the path.
    place: Option<(&'static AtomicPtr<CString>, *mut CString)>,
}

// SAFETY: the pointer is compared with others, and followed only by whoever took it out of its place.
unsafe impl Send for Unfinished {}
// SAFETY: as above; nothing is done by a shared reference.
unsafe impl Sync for Unfinished {}

impl Unfinished {
    /// The file of this path, which need not be there yet: so nothing comes between its beginning and the note of it.
    pub fn new(path: &Path) -> Unfinished {
        // A path with a zero byte is none of a file; beyond the last place a file would only be left behind.
        let Ok(path) = CString::new(path.as_os_str().as_bytes()) else { return Unfinished { place: None } };
        let path = Box::into_raw(Box::new(path));
        let take = |place: &&AtomicPtr<CString>| {
            place.compare_exchange(ptr::null_mut(), path, Ordering::SeqCst, Ordering::SeqCst).is_ok()
        };
        let place = PATHS.iter().find(take).map(|place| (place, path));
        if place.is_none() {
            // SAFETY: it is the pointer from `Box::into_raw` above, and no place has it.
            drop(unsafe { Box::from_raw(path) });
        }
        Unfinished { place }
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        let Some((place, path)) = self.place else { return };
        // Where it is gone already, the program is about to end.
        if place.compare_exchange(path, ptr::null_mut(), Ordering::SeqCst, Ordering::SeqCst).is_ok() {
            // SAFETY: it comes from `Box::into_raw`, and the exchange gives it to nobody else.
            drop(unsafe { Box::from_raw(path) });
        }
    }
}

/// Removes them all. Safe in the handler of a signal: what was taken out is never freed.
pub(super) fn remove_all() {
    for place in &PATHS {
        let path = place.swap(ptr::null_mut(), Ordering::SeqCst);
        // SAFETY: pointers in a place are those of boxes, and the swap gives one to nobody else, so that it stays valid.
        if let Some(path) = unsafe { path.as_ref() } {
            // It may be gone already.
            let _ = rustix::fs::unlink(path.as_c_str());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_is_unfinished_goes_and_the_rest_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        let [unfinished, finished] = ["unfinished", "finished"].map(|name| folder.path().join(name));
        let kept = Unfinished::new(&unfinished);
        let dropped = Unfinished::new(&finished);
        for path in [&unfinished, &finished] {
            fs::write(path, "x").expect("written");
        }
        drop(dropped);
        // More than there are places for.
        let many: Vec<_> =
            (0..2 * PLACES).map(|number| Unfinished::new(&folder.path().join(number.to_string()))).collect();
        remove_all();
        assert!(!unfinished.exists() && finished.exists());
        // What was taken out isn't freed again.
        drop((kept, many));
        assert!(PATHS.iter().all(|place| place.load(Ordering::SeqCst).is_null()));
    }
}
