//! The files that a run reads, and those that it writes: a result is never one of its inputs, and no two results are one file.

use super::failure::{Failure, shown};
use raywalk::files::is_callers_fault;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, Metadata};
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// The files that a run reads, by all of which [`Output::create`](super::output::Output::create) is asked: the arguments, and what they
/// name.
#[derive(Clone, Debug, Default)]
pub struct Inputs(Vec<PathBuf>);

impl Inputs {
    /// Of a result that is made of no file.
    pub fn none() -> Inputs {
        Inputs::default()
    }

    /// These files; `-` is standard input.
    pub fn of(paths: impl IntoIterator<Item = impl Into<PathBuf>>) -> Inputs {
        let paths: Vec<PathBuf> = paths.into_iter().map(Into::into).collect();
        let file = |path: &PathBuf| if is_stdin(path) { stdin() } else { file_at(path) };
        let files = paths.iter().filter_map(|path| Some((file(path)?, path.clone())));
        READ.lock().unwrap_or_else(PoisonError::into_inner).extend(files);
        Inputs(paths)
    }

    /// Those and these.
    pub fn and(mut self, others: Inputs) -> Inputs {
        self.0.extend(others.0);
        self
    }

    /// Refuses a result whose file is one of them, by whatever name or link. Where that can't be found out, the machine says why.
    pub fn refuse(&self, result: &Path, metadata: &Metadata) -> Result<(), Failure> {
        match self.find(metadata)? {
            None => Ok(()),
            Some(_) => Err(Failure::caller(format!("{}: is the input, which would be overwritten", shown(result)))),
        }
    }

    fn find(&self, result: &Metadata) -> Result<Option<&Path>, Failure> {
        for input in &self.0 {
            let found = match is_stdin(input) {
                true => standard_file(&io::stdin()),
                false => match fs::metadata(input) {
                    Ok(found) => Some(found),
                    // A mesh that nobody has looked for may be missing.
                    Err(error) if is_callers_fault(&error) => None,
                    Err(error) => return Err(Failure::io(input, "read", &error)),
                },
            };
            if found.is_some_and(|found| (found.dev(), found.ino()) == (result.dev(), result.ino())) {
                return Ok(Some(input));
            }
        }
        Ok(None)
    }
}

/// What the inputs of this run are, for all that is only printed. There may be more than any one result is made of.
static READ: Mutex<BTreeMap<File, PathBuf>> = Mutex::new(BTreeMap::new());

/// These files are read by this run, which makes no result of them but what it prints.
pub fn reads(paths: impl IntoIterator<Item = impl Into<PathBuf>>) {
    let _ = Inputs::of(paths);
}

/// Refuses to print into a file that is read: it would never end, or be spoiled.
pub fn refuse_printing() -> Result<(), Failure> {
    let Some(metadata) = standard_file(&io::stdout()) else { return Ok(()) };
    match READ.lock().unwrap_or_else(PoisonError::into_inner).get(&(metadata.dev(), metadata.ino())) {
        Some(input) => Err(Failure::caller(format!("{}: is the input and standard output, too", shown(input)))),
        None => Ok(()),
    }
}

fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

fn stdin() -> Option<File> {
    standard_file(&io::stdin()).map(|metadata| (metadata.dev(), metadata.ino()))
}

/// What a standard stream is, if it is a regular file.
fn standard_file(stream: &impl std::os::fd::AsFd) -> Option<Metadata> {
    let file = fs::File::from(stream.as_fd().try_clone_to_owned().ok()?);
    file.metadata().ok().filter(Metadata::is_file)
}

/// The places of this run's results, written or about to be, and what is there: device and inode.
static RESULTS: Mutex<Results> = Mutex::new(Results { places: BTreeSet::new(), files: BTreeSet::new() });

struct Results {
    places: BTreeSet<PathBuf>,
    files: BTreeSet<File>,
}

/// The identity of a file, whatever its names are.
type File = (u64, u64);

/// A place that is one result's alone, from when it is begun on; dropped without [`Claim::keep`] it is free again.
pub struct Claim {
    place: PathBuf,
    /// What the result is to replace.
    replaced: Option<File>,
    is_kept: bool,
}

impl Claim {
    /// Claims a place, which `named` leads to.
    pub fn of(named: &Path, place: &Path) -> Result<Claim, Failure> {
        let mut results = RESULTS.lock().unwrap_or_else(PoisonError::into_inner);
        let replaced = file_at(place);
        if results.places.contains(place) || replaced.is_some_and(|file| results.files.contains(&file)) {
            let message = format!("{}: is another result of this call, expected a file for each", shown(named));
            return Err(Failure::caller(message));
        }
        results.places.insert(place.to_owned());
        results.files.extend(replaced);
        Ok(Claim { place: place.to_owned(), replaced, is_kept: false })
    }

    /// The result is there: nothing else of this run may go to its place.
    pub fn keep(mut self) {
        self.is_kept = true;
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        let mut results = RESULTS.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(replaced) = self.replaced {
            results.files.remove(&replaced);
        }
        if self.is_kept {
            results.files.extend(file_at(&self.place));
        } else {
            results.places.remove(&self.place);
        }
    }
}

fn file_at(place: &Path) -> Option<File> {
    fs::metadata(place).ok().map(|metadata| (metadata.dev(), metadata.ino()))
}

/// Where a path leads, also by links that lead to nothing yet: they stay, and what they point to is written. The folder is spelt without
/// links where it is there.
pub fn place_of(path: &Path) -> PathBuf {
    const MOST_LINKS: usize = 40;
    if let Ok(place) = fs::canonicalize(path) {
        return place;
    }
    let mut place = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(target) = fs::read_link(&place) else { break };
        place = place.parent().unwrap_or(Path::new("")).join(target);
    }
    let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match (fs::canonicalize(folder), place.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => place,
    }
}
