//! The notes of a saved log: a file beside it, written only when there is something to keep and only when that has changed. A file that isn't
//! one of these is neither replaced nor removed.

use super::results;
use crate::cli::inputs::{Inputs, place_of};
use raywalk::files::{FileError, Wanted, is_there};
use raywalk::log::{self, Log};
use raywalk::tui::{MAX_NOTE_LENGTH, MAX_NOTES, Note, Notes, Refusal, Spelt};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The largest file of notes.
pub const MAX_NOTES_BYTES: u64 = 1 << 22;

/// What the file is, and its version.
const FORMAT: &str = "raywalk-bookmarks/1";

/// The file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    /// The digest of the log.
    log: String,
    bookmarks: Vec<Bookmark>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Bookmark {
    letter: char,
    address: String,
    number: usize,
    step: usize,
    note: String,
}

/// The notes beside a log.
pub struct Notebook {
    /// Where they are; nowhere for a log from standard input.
    path: Option<PathBuf>,
    /// What was in the file when it was last read or written; nothing where there was none.
    known: Option<Vec<u8>>,
    /// The digest of the log, once it was needed.
    digest: Option<String>,
}

impl Notebook {
    /// The notes beside the log with this path.
    pub fn beside(log: &Path) -> Notebook {
        let path = log.file_name().filter(|_| log != Path::new("-")).map(|name| {
            let mut name = name.to_owned();
            name.push(".bookmarks.json");
            log.with_file_name(name)
        });
        Notebook { path, known: None, digest: None }
    }

    /// Where they are kept.
    pub fn file(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// The notes, if there are any.
    pub fn read(&mut self, log: &Log) -> Result<Option<Notes>, Refusal> {
        let Some(path) = self.path.clone() else { return Ok(None) };
        self.known = bytes_of(&path)?;
        let Some(bytes) = &self.known else { return Ok(None) };
        let name = path.to_string_lossy().into_owned();
        let Some(file) = parsed(bytes) else { return Err(Refusal::NotOurs(name)) };
        let is_same_log = file.log == self.digest_of(log)?;
        let note = |Bookmark { letter, address, number, step, note }| Note {
            letter,
            address,
            spelt: Spelt { number, step },
            text: note,
        };
        Ok(Some(Notes { notes: file.bookmarks.into_iter().map(note).collect(), is_same_log, file: name }))
    }

    /// Keeps these notes, and gives the name of the file. Without notes it is removed.
    pub fn write(&mut self, log: &Log, notes: &[Note], inputs: &Inputs) -> Result<String, Refusal> {
        let path = self.path.clone().ok_or(Refusal::OnlyOfLogs)?;
        let name = path.to_string_lossy().into_owned();
        let found = bytes_of(&path)?;
        if found.as_ref().is_some_and(|bytes| parsed(bytes).is_none()) {
            return Err(Refusal::NotOurs(name));
        }
        if found != self.known {
            return Err(Refusal::ChangedMeanwhile(name));
        }
        if notes.is_empty() {
            if found.is_some() {
                fs::remove_file(place_of(&path)).map_err(|error| Refusal::Other(format!("{name}: {error}")))?;
            }
            self.known = None;
            return Ok(name);
        }
        let bookmark = |Note { letter, address, spelt, text }: &Note| Bookmark {
            letter: *letter,
            address: address.clone(),
            number: spelt.number,
            step: spelt.step,
            note: text.clone(),
        };
        let bookmarks = notes.iter().map(bookmark).collect();
        let file = File { format: FORMAT.to_owned(), log: self.digest_of(log)?, bookmarks };
        let text = serde_json::to_string_pretty(&file).map_err(|error| Refusal::Other(error.to_string()))?;
        let bytes = format!("{text}\n").into_bytes();
        results::write(&path, inputs, &bytes)?;
        self.known = Some(bytes);
        Ok(name)
    }

    fn digest_of(&mut self, log: &Log) -> Result<String, Refusal> {
        if let Some(digest) = &self.digest {
            return Ok(digest.clone());
        }
        let digest = log::file::digest(log).map_err(|error| Refusal::Other(error.to_string()))?;
        Ok(self.digest.insert(digest).clone())
    }
}

/// What is in the file, if it is there.
fn bytes_of(path: &Path) -> Result<Option<Vec<u8>>, Refusal> {
    if is_there(path).is_ok_and(|is_there| !is_there) {
        return Ok(None);
    }
    let wanted = Wanted { what: "a file of bookmarks", max_bytes: MAX_NOTES_BYTES };
    wanted.read(path).map(Some).map_err(|error: FileError| Refusal::Other(error.to_string()))
}

/// The file in these bytes, if it is one of this version and within its limits.
fn parsed(bytes: &[u8]) -> Option<File> {
    let file: File = serde_json::from_slice(bytes).ok()?;
    let letters: BTreeSet<char> = file.bookmarks.iter().map(|bookmark| bookmark.letter).collect();
    let is_fine = |bookmark: &Bookmark| {
        bookmark.letter.is_alphanumeric()
            && !bookmark.note.is_empty()
            && bookmark.note.chars().nth(MAX_NOTE_LENGTH).is_none()
    };
    let is_whole = file.format == FORMAT
        && file.bookmarks.len() <= MAX_NOTES
        && letters.len() == file.bookmarks.len()
        && file.bookmarks.iter().all(is_fine);
    is_whole.then_some(file)
}
