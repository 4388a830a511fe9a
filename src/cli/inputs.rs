//! The files that a run reads, and those that it writes: a result is never one of its inputs, and no two results are one file.

use super::failure::{Failure, shown};
use raywalk::scene::file::is_callers_fault;
use std::fs::{self, Metadata};
use std::io;
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
        Inputs(paths.into_iter().map(Into::into).collect())
    }

    /// Those and these.
    pub fn and(mut self, others: Inputs) -> Inputs {
        self.0.extend(others.0);
        self
    }

    /// Refuses a result whose file is one of them, by whatever name or link. Where that can't be found out, the machine says why.
    pub fn refuse(&self, result: &Path, metadata: &Metadata) -> Result<(), Failure> {
        match self.find(result, metadata)? {
            None => Ok(()),
            Some(_) => Err(Failure::caller(format!("{}: is the input, which would be overwritten", shown(result)))),
        }
    }

    /// The same for a result that goes to standard output.
    pub fn refuse_standard_output(&self) -> Result<(), Failure> {
        // What is closed or has no metadata is no file that somebody reads.
        let Some(metadata) = standard_file(&io::stdout()) else { return Ok(()) };
        match self.find(Path::new("/dev/stdout"), &metadata)? {
            None => Ok(()),
            Some(input) => Err(Failure::caller(format!("{}: is the input and standard output, too", shown(input)))),
        }
    }

    fn find(&self, result: &Path, metadata: &Metadata) -> Result<Option<&Path>, Failure> {
        for input in &self.0 {
            let found = match input.as_path() == Path::new("-") {
                true => standard_file(&io::stdin()),
                false => match fs::metadata(input) {
                    Ok(found) => Some(found),
                    // A mesh that nobody has looked for may be missing.
                    Err(error) if is_callers_fault(&error) => None,
                    Err(error) => return Err(Failure::io(input, "read", &error)),
                },
            };
            if found.is_some_and(|found| is_same((result, metadata), (input, &found))) {
                return Ok(Some(input));
            }
        }
        Ok(None)
    }
}

/// What a standard stream is, if it is a regular file.
#[cfg(unix)]
fn standard_file(stream: &impl std::os::fd::AsFd) -> Option<Metadata> {
    let file = fs::File::from(stream.as_fd().try_clone_to_owned().ok()?);
    file.metadata().ok().filter(Metadata::is_file)
}

#[cfg(not(unix))]
fn standard_file<S>(_: &S) -> Option<Metadata> {
    None
}

#[cfg(unix)]
fn is_same((_, a): (&Path, &Metadata), (_, b): (&Path, &Metadata)) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn is_same((a, _): (&Path, &Metadata), (b, _): (&Path, &Metadata)) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

/// The places of this run's results, written or about to be.
static RESULTS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A place that is one result's alone, from when it is begun on; dropped without [`Claim::keep`] it is free again.
pub struct Claim(Option<PathBuf>);

impl Claim {
    /// Claims a place, which `named` leads to.
    pub fn of(named: &Path, place: &Path) -> Result<Claim, Failure> {
        let mut results = RESULTS.lock().unwrap_or_else(PoisonError::into_inner);
        let is_taken = |other: &PathBuf| {
            other == place
                || matches!((fs::metadata(place), fs::metadata(other)),
                    (Ok(ours), Ok(theirs)) if is_same((place, &ours), (other, &theirs)))
        };
        if results.iter().any(is_taken) {
            let message = format!("{}: is another result of this call, expected a file for each", shown(named));
            return Err(Failure::caller(message));
        }
        results.push(place.to_owned());
        Ok(Claim(Some(place.to_owned())))
    }

    /// The result is there: nothing else of this run may go to its place.
    pub fn keep(mut self) {
        self.0 = None;
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        let mut results = RESULTS.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(at) = self.0.take().and_then(|place| results.iter().position(|other| *other == place)) {
            results.swap_remove(at);
        }
    }
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
