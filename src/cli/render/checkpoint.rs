//! What is rendered already, kept beside a picture until it is there: whatever ends the program, the next one goes on from there.

use crate::cli::failure::{Failure, shown};
use crate::cli::inputs::{Claim, Inputs, place_of};
use crate::cli::lock::{Lock, is_at, lock};
use crate::cli::unfinished::sync_folder;
use raywalk::files::escape_hidden;
use raywalk::render::Canvas;
use raywalk::render::part::{PartError, PartHeader, Reader, Record, Writer};
use raywalk_guard::retried;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, ErrorKind, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// How often it is made sure that even a loss of power doesn't lose it.
const SYNCED_EVERY: Duration = Duration::from_secs(10);

/// A file of pieces.
pub struct Checkpoint {
    path: PathBuf,
    writer: Writer<File>,
    /// The same file, to be synced.
    file: File,
    synced: Instant,
    /// Into which picture it went already.
    went_into: Option<blake3::Hash>,
    /// It is neither a result nor an input.
    claim: Claim,
}

/// The pixels of pieces by their numbers.
pub type Kept = BTreeMap<u32, Canvas>;

impl Checkpoint {
    /// The checkpoint of a picture's file, and what it has of it: nothing if it is begun now.
    pub fn open(picture: &Path, header: &PartHeader, inputs: &Inputs) -> Result<(Checkpoint, Kept), Failure> {
        let path = path_of(picture);
        let cannot = |error: &io::Error| Failure::io(&path, "keep what is rendered", error);
        let (file, claim) = locked(&path, inputs, true)?;
        let found = read(&file, &path, header)?;
        // What was cut off behind what is good is written again.
        let good = found.as_ref().map_or(0, |found| found.good);
        let begin = || -> io::Result<Writer<File>> {
            file.set_len(good)?;
            let mut out = file.try_clone()?;
            out.seek(SeekFrom::Start(good))?;
            if found.is_some() { Ok(Writer::going_on(out)) } else { Writer::new(out, header) }
        };
        let writer = begin().map_err(|error| cannot(&error))?;
        let Found { kept, went_into, .. } = found.unwrap_or_default();
        Ok((Checkpoint { path, writer, file, synced: Instant::now(), went_into, claim }, kept))
    }

    /// Keeps a piece.
    pub fn keep(&mut self, number: u32, pixels: &Canvas) -> io::Result<()> {
        self.writer.piece(number, pixels)?;
        if self.synced.elapsed() >= SYNCED_EVERY {
            retried(|| self.file.sync_data())?;
            self.synced = Instant::now();
        }
        Ok(())
    }

    /// Says that files with this digest were made of it; the pieces themselves are of no more use. Gives what is left of it, to be removed
    /// when it isn't asked for any more.
    pub fn went_into(self, header: &PartHeader, files: &blake3::Hash) -> Result<Spent, Failure> {
        let note = || -> io::Result<()> {
            self.file.set_len(0)?;
            let mut out = self.file.try_clone()?;
            out.rewind()?;
            Writer::new(out, header)?.went_into(files)
        };
        note().map_err(|error| self.failure(&error))?;
        Ok(self.spent())
    }

    /// Whether it went into files with this digest.
    pub fn is_in(&self, files: Option<blake3::Hash>) -> bool {
        self.went_into.is_some() && self.went_into == files
    }

    /// It is of no more use.
    pub fn spent(self) -> Spent {
        self.claim.keep();
        Spent { path: self.path, file: Some(self.file) }
    }

    /// Why nothing more can be kept.
    pub fn failure(&self, error: &io::Error) -> Failure {
        Failure::io(&self.path, "keep what is rendered", error)
    }
}

/// A checkpoint that is of no more use. It stays locked until it is gone, so that nobody goes on in a file that vanishes.
pub struct Spent {
    path: PathBuf,
    /// Kept open for its lock.
    file: Option<File>,
}

impl Spent {
    /// Unlocks it: a process may have only a limited number of files open, and an animation may have a million frames.
    pub fn let_go(self) -> Spent {
        Spent { file: None, ..self }
    }

    /// Removes it, as the picture is there for good.
    pub fn remove(self) -> Result<(), Failure> {
        let path = &self.path;
        let Some(_locked) = self.file.or_else(|| File::open(path).ok().filter(|file| lock(file) != Lock::Taken)) else {
            // It is gone, or another run is at work on it.
            return Ok(());
        };
        // The run that put the picture there may have been killed before it made sure of that.
        let picture = path.with_extension("");
        if let Some(folder) = fs::canonicalize(&picture).ok().as_deref().and_then(Path::parent) {
            sync_folder(folder).map_err(|error| Failure::io(&picture, "write", &error))?;
        }
        match retried(|| fs::remove_file(path)) {
            Err(error) if error.kind() != ErrorKind::NotFound => Err(Failure::io(path, "remove", &error)),
            _ => Ok(()),
        }
    }
}

/// The file of a checkpoint, locked; begun if it isn't there and may be.
fn locked(path: &Path, inputs: &Inputs, may_begin: bool) -> Result<(File, Claim), Failure> {
    let cannot = |error: &io::Error| Failure::io(path, "keep what is rendered", error);
    loop {
        match fs::metadata(path) {
            Ok(metadata) if !metadata.is_file() => {
                return Err(Failure::caller(format!("{}: is no regular file", shown(path))));
            }
            Ok(metadata) => inputs.refuse(path, &metadata)?,
            Err(error) if error.kind() == ErrorKind::NotFound && may_begin => {}
            Err(error) => return Err(cannot(&error)),
        }
        let file = OpenOptions::new().read(true).write(true).create(may_begin).truncate(false).open(path);
        let file = file.map_err(|error| cannot(&error))?;
        if lock(&file) == Lock::Taken {
            return Err(Failure::machine(format!("{}: another raywalk is at work on it", shown(path))));
        }
        // The process that had it locked a moment ago may have removed it: then another one is begun.
        if is_at(&file, path).map_err(|error| cannot(&error))? {
            return Ok((file, Claim::of(path, &place_of(path))?));
        }
    }
}

/// Removes the checkpoint that was left beside a picture which is there, if there is one of this very picture. Anything else, and one that
/// another run is at work on, is nobody's business here.
pub fn remove_left_of(
    picture: &Path,
    inputs: &Inputs,
    header: impl FnOnce() -> Result<PartHeader, Failure>,
) -> Result<(), Failure> {
    let path = path_of(picture);
    if !path.exists() {
        return Ok(());
    }
    let header = header()?;
    let Ok((file, claim)) = locked(&path, inputs, false) else { return Ok(()) };
    // A file without a header may be anybody's, an empty one above all.
    match read(&file, &path, &header) {
        Ok(Some(_)) => {
            claim.keep();
            Spent { path, file: Some(file) }.remove()
        }
        Ok(None) | Err(_) => Ok(()),
    }
}

/// What a checkpoint holds.
#[derive(Default)]
struct Found {
    kept: Kept,
    went_into: Option<blake3::Hash>,
    /// How many bytes of it are good.
    good: u64,
}

/// What an earlier run left; `None` if there is nothing of use.
fn read(file: &File, path: &Path, header: &PartHeader) -> Result<Option<Found>, Failure> {
    let metadata = file.metadata().map_err(|error| Failure::io(path, "read", &error))?;
    if metadata.len() == 0 {
        return Ok(None);
    }
    let mut reader = match Reader::open(BufReader::new(file)) {
        Ok(reader) => reader,
        Err(PartError::Io(error)) => return Err(Failure::io(path, "read", &error)),
        // One whose header was cut off has nothing; anything else isn't ours to overwrite.
        Err(PartError::CutOff) => return Ok(None),
        Err(error) => return Err(Failure::caller(format!("{}: {error}", shown(path)))),
    };
    if reader.header() != header {
        let theirs = reader.header();
        let reason = match header.picture.difference(&theirs.picture) {
            Some((what, [ours, found])) => {
                format!("{what}: {} there, {} here", escape_hidden(&found), escape_hidden(&ours))
            }
            None => format!("shard {} there, {} here", theirs.shard, header.shard),
        };
        let expected = "expected the same call, or to remove the file and start again";
        return Err(Failure::caller(format!("{}: is of another picture ({reason}); {expected}", shown(path))));
    }
    let mut found = Found::default();
    loop {
        match reader.next_record().map_err(|error| Failure::io(path, "read", &error))? {
            Some(Record::Piece(number, pixels)) => {
                found.kept.insert(number, pixels);
            }
            Some(Record::WentInto(digest)) => found.went_into = Some(digest),
            Some(Record::End) | None => break,
        }
    }
    found.good = reader.good();
    Ok(Some(found))
}

/// `FILE.checkpoint`.
fn path_of(picture: &Path) -> PathBuf {
    let mut name = OsString::from(picture);
    name.push(".checkpoint");
    name.into()
}
