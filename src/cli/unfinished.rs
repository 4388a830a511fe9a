//! A result while it is written: a file beside its place, which takes its place in one step, and which nothing leaves behind for long.

use super::lock::{Lock, lock};
use raywalk_guard::{Unfinished, retried};
use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io;
use std::os::unix::fs::{MetadataExt, OpenOptionsExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex, PoisonError};
use tempfile::NamedTempFile;

/// What the names of such files begin and end with.
const PREFIX: &str = ".raywalk-";
const SUFFIX: &str = ".part";

/// How many letters of such a name are random.
const RANDOM: usize = 6;

/// A new file gets this, less the umask.
const MODE: u32 = 0o666;

/// Folders in which files of dead processes were looked for already.
static SWEPT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// The letters that distinguish files of this machine from those of others that share the folder: some network file systems keep the
/// locks of each machine apart.
static HOST: LazyLock<String> = LazyLock::new(|| {
    let name = rustix::system::uname().nodename().to_bytes().to_vec();
    blake3::hash(&name).to_hex()[..8].to_owned()
});

/// A file beside the place of a result. As long as its process lives it is locked. An error, a signal or an allocation that fails
/// removes it; after SIGKILL the next that is begun in its folder does.
pub struct Beside {
    file: NamedTempFile<File>,
    folder: PathBuf,
    /// For what ends the program in the middle of the work.
    note: Unfinished,
}

impl Beside {
    /// Begins one in a folder, with the permissions of the file that it is to replace.
    pub fn begin(folder: &Path, permissions: Option<Permissions>) -> io::Result<Beside> {
        sweep(folder);
        let mode = permissions.map_or(MODE, |permissions| permissions.mode());
        let mut note = None;
        let prefix = format!("{PREFIX}{}-", *HOST);
        let begin = |path: &Path| {
            note = Some(Unfinished::new(path));
            let file = OpenOptions::new().write(true).create_new(true).mode(mode).open(path)?;
            // A process that cleans up may have been faster: then another name is tried. Some file systems have no locks.
            let is_lost = lock(&file) == Lock::Taken || file.metadata().is_ok_and(|metadata| metadata.nlink() == 0);
            if is_lost { Err(io::ErrorKind::AlreadyExists.into()) } else { Ok(file) }
        };
        let file = tempfile::Builder::new().prefix(&prefix).suffix(SUFFIX).rand_bytes(RANDOM).make_in(folder, begin)?;
        let note = note.ok_or(io::ErrorKind::NotFound)?;
        Ok(Beside { file, folder: folder.to_owned(), note })
    }

    /// The file, to be written. Not as a temporary file, whose errors name it, which says nothing to anybody.
    pub fn as_file(&self) -> &File {
        self.file.as_file()
    }

    /// Takes the place, for good: also a loss of power doesn't bring back what was there before.
    pub fn take(self, place: &Path) -> io::Result<()> {
        let Beside { mut file, folder, note } = self;
        synced(file.as_file())?;
        let file = loop {
            match file.persist(place) {
                Ok(file) => break file,
                Err(failed) if failed.error.kind() == io::ErrorKind::Interrupted => file = failed.file,
                Err(failed) => return Err(failed.error),
            }
        };
        drop((note, file));
        sync_folder(&folder)
    }
}

/// Makes sure that the names in a folder outlast a loss of power.
pub fn sync_folder(folder: &Path) -> io::Result<()> {
    match retried(|| File::open(folder)) {
        Ok(opened) => synced(&opened),
        // One that may be written and not read.
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => Ok(()),
        Err(error) => Err(error),
    }
}

/// Some file systems and devices have no such call.
fn synced(file: &File) -> io::Result<()> {
    match retried(|| file.sync_all()) {
        Err(error) if matches!(error.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => Ok(()),
        done => done,
    }
}

/// Removes what processes left in a folder that were killed. Only what nobody has locked: whoever writes such a file has.
pub fn sweep(folder: &Path) {
    let mut swept = SWEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if !swept.insert(folder.to_owned()) {
        return;
    }
    // It is no part of the work: where it can't be done, it isn't.
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let is_left = entry.file_name().to_str().is_some_and(is_of_this_machine);
        // By the entry itself, not by what a link leads to.
        if !is_left || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let path = entry.path();
        // Some file systems lock only what is opened for writing; the part of a result that may not be written isn't. The lock is kept until the
        // file is gone.
        if let Ok(file) = OpenOptions::new().write(true).open(&path).or_else(|_| File::open(&path))
            && lock(&file) == Lock::Ours
        {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Whether a name is that of a file beside a result, begun on this machine or by a version that didn't say on which.
fn is_of_this_machine(name: &str) -> bool {
    let Some(middle) = name.strip_prefix(PREFIX).and_then(|rest| rest.strip_suffix(SUFFIX)) else { return false };
    let random = match middle.split_once('-') {
        Some((host, random)) if host == *HOST => random,
        Some(_) => return false,
        None => middle,
    };
    random.len() == RANDOM && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("the folder");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn what_dead_processes_left_goes_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let living = Beside::begin(folder.path(), None).expect("begun");
        let kept = [".raywalk-00000000-aaaaaa.part", ".raywalk-my notes.part", "a.part", "raywalk-aaaaaa.part"];
        let ours = format!(".raywalk-{}-bbbbbb.part", *HOST);
        for name in kept.iter().copied().chain([".raywalk-cccccc.part", &ours]) {
            fs::write(folder.path().join(name), "left").expect("written");
        }
        fs::create_dir(folder.path().join(".raywalk-dddddd.part")).expect("a folder");
        std::os::unix::fs::symlink("a.part", folder.path().join(".raywalk-eeeeee.part")).expect("a link");
        SWEPT.lock().expect("nobody panics").remove(folder.path());
        sweep(folder.path());
        let living_name = living.file.path().file_name().expect("a name").to_string_lossy().into_owned();
        let mut expected: Vec<_> = kept.map(str::to_owned).to_vec();
        expected.extend([".raywalk-dddddd.part".to_owned(), ".raywalk-eeeeee.part".to_owned(), living_name]);
        expected.sort();
        assert_eq!(names(folder.path()), expected);
        living.take(&folder.path().join("a.part")).expect("it takes its place");
        assert!(fs::read(folder.path().join("a.part")).expect("the result").is_empty());
    }

    #[test]
    fn an_unfinished_file_is_locked_and_goes_when_it_is_dropped() {
        let folder = tempfile::tempdir().expect("a folder");
        let beside = Beside::begin(folder.path(), Some(Permissions::from_mode(0o640))).expect("begun");
        let path = beside.file.path().to_owned();
        assert!(is_of_this_machine(&path.file_name().expect("a name").to_string_lossy()));
        assert!(File::open(&path).expect("it is there").try_lock().is_err());
        assert_eq!(fs::metadata(&path).expect("it is there").permissions().mode() & 0o777, 0o640);
        drop(beside);
        assert_eq!(names(folder.path()), [""; 0]);
    }
}
