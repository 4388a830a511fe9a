//! The digest by which a log is known again that another program wrote anew.

use super::write::{Lines, header_line};
use crate::log::events::Events;
use crate::log::header::Header;
use std::mem;

/// The digest of a log as raywalk writes its lines, however they were spelt where it was read.
pub(super) struct Digest {
    header: Header,
    paths: Vec<String>,
    hasher: blake3::Hasher,
}

impl Digest {
    /// That of the header.
    pub fn new(header: Header) -> Digest {
        let mut hasher = blake3::Hasher::new();
        // A header that was read can be written.
        hasher.update(&header_line(&header).unwrap_or_default());
        Digest { header, paths: Vec::new(), hasher }
    }

    /// Adds further events.
    pub fn add(&mut self, events: &Events) {
        let hasher = &mut self.hasher;
        let mut lines = Lines::new(&self.header);
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
