//! The digest that recognises a log after another program has rewritten it.

use super::write::{Lines, Paths, write_header};
use crate::log::events::Events;
use crate::log::header::Header;
use std::mem;

/// The digest of a log as raywalk writes its lines, however they were spelt where it was read.
pub(super) struct Digest {
    paths: Paths,
    hasher: blake3::Hasher,
}

impl Digest {
    /// That of the header.
    pub fn new(header: &Header) -> Digest {
        let mut hasher = blake3::Hasher::new();
        let written = write_header(header, &mut hasher);
        debug_assert!(written.is_ok(), "a header that was read can be written");
        Digest { paths: Paths::default(), hasher }
    }

    /// Adds further events of a log with this header.
    pub fn add(&mut self, header: &Header, events: &Events) {
        let hasher = &mut self.hasher;
        let mut lines = Lines::new(header);
        lines.paths = mem::take(&mut self.paths);
        let added = lines.hand_on(events, |text| {
            hasher.update(text);
            Ok(())
        });
        self.paths = lines.paths;
        debug_assert!(added.is_ok(), "nothing is written");
    }

    /// The digest of what was added.
    pub fn finish(&self) -> blake3::Hash {
        self.hasher.finalize()
    }
}
