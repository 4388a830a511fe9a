//! Bytes from outside, of bounded size and never by waiting for a device.

use raywalk_guard::{Patient, attempt, stdin_was_closed};
use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::mem;
use std::path::{Path, PathBuf};

use super::error::FileError;
use super::packed::Packing;
use super::there::is_callers_fault;

/// How much of a file is looked at to tell what it is.
const BEGINNING: u64 = 512;

/// The name that standard input has in messages.
pub const STANDARD_INPUT: &str = "<stdin>";

/// What kind of file is read.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// The kind, in words.
    pub what: &'static str,
    /// The largest one.
    pub max_bytes: u64,
}

/// An opened file, or standard input, unpacked if it is compressed with gzip or zstd.
pub struct Opened {
    wanted: Wanted,
    name: String,
    /// Where it can be opened again.
    path: Option<PathBuf>,
    /// How many bytes the file has before decompression; 0 where that is unknown.
    size: u64,
    packing: Option<Packing>,
    beginning: Vec<u8>,
    rest: Box<dyn Read>,
}

impl Wanted {
    /// Reads a regular file, or standard input for `-`; what is compressed with gzip or zstd is unpacked.
    ///
    /// # Errors
    /// [`FileError::Refused`] when it is missing, no regular file or too large; [`FileError::Unreadable`] when the machine
    /// did not give the bytes.
    pub fn read(self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.open(path)?.bytes()
    }

    /// Opens such a file, or standard input for `-`; errors are those of [`Wanted::read`], but for the size.
    pub fn open(self, path: &Path) -> Result<Opened, FileError> {
        let name = display_name(path);
        if path == Path::new("-") {
            if stdin_was_closed() {
                return Err(FileError::Unreadable { file: name, source: io::Error::other("it is closed") });
            }
            return self.begin(io::stdin(), 0, name);
        }
        // Asked before opening, because opening a FIFO would wait for a writer.
        let metadata = fs::metadata(path).map_err(|error| self.failure(&name, error))?;
        if let Some(kind) = irregular(&metadata) {
            return Err(refused(&name, format!("expected a regular file, found {kind}")));
        }
        let file = File::open(path).map_err(|error| self.failure(&name, error))?;
        Ok(Opened { path: Some(path.to_owned()), ..self.begin(file, metadata.len(), name)? })
    }

    /// Begins to read such a file of `size` bytes (0 where that is unknown) from anywhere: looks at the beginning, which tells what it
    /// is.
    ///
    /// # Errors
    /// Those of [`Wanted::open`].
    pub fn begin(self, input: impl Read + 'static, size: u64, name: String) -> Result<Opened, FileError> {
        let mut input = Patient(input);
        let mut beginning = Vec::new();
        let read = input.by_ref().take(BEGINNING).read_to_end(&mut beginning);
        read.map_err(|error| self.failure(&name, error))?;
        let path = None;
        let Some(packing) = Packing::of(&beginning) else {
            return Ok(Opened { wanted: self, name, path, size, packing: None, beginning, rest: Box::new(input) });
        };
        let mut rest = packing.unpacked(io::Cursor::new(beginning).chain(input));
        let mut beginning = Vec::new();
        let read = rest.by_ref().take(BEGINNING).read_to_end(&mut beginning);
        let mut opened = Opened { wanted: self, name, path, size, packing: Some(packing), beginning, rest };
        match read {
            Ok(_) => Ok(opened),
            // What there is of it may be enough.
            Err(error) if packing.damage(&error).is_some() && !opened.beginning.is_empty() => {
                opened.rest = Box::new(Broken(Some(error)));
                Ok(opened)
            }
            Err(error) => Err(opened.failure(error)),
        }
    }

    fn failure(self, name: &str, source: io::Error) -> FileError {
        let what = self.what;
        if source.kind() == ErrorKind::NotFound {
            refused(name, format!("no such file, expected {what}"))
        } else if is_callers_fault(&source) {
            refused(name, format!("expected {what}: {source}"))
        } else {
            FileError::Unreadable { file: name.to_string(), source }
        }
    }

    fn too_large(self, name: &str, found: &str) -> FileError {
        refused(name, format!("too large, expected at most {} bytes, {found}", self.max_bytes))
    }
}

impl Opened {
    /// The name in messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What opens it again, which standard input can't be.
    pub fn again(&self) -> Option<impl FnOnce() -> Result<Opened, FileError> + use<>> {
        let (wanted, path) = (self.wanted, self.path.clone()?);
        Some(move || wanted.open(&path))
    }

    /// How many bytes there are, where that is known.
    pub fn size(&self) -> Option<u64> {
        Some(self.size).filter(|size| *size > 0 && self.packing.is_none())
    }

    /// The first bytes, some hundreds of them if there are.
    pub fn beginning(&self) -> &[u8] {
        &self.beginning
    }

    /// The whole of it, which must be no larger than a scene file may be.
    ///
    /// # Errors
    /// Those of [`Wanted::read`].
    pub fn bytes(mut self) -> Result<Vec<u8>, FileError> {
        let most = self.wanted.max_bytes;
        if self.size > most {
            return Err(self.wanted.too_large(&self.name, &format!("found {} bytes", self.size)));
        }
        let mut bytes = mem::take(&mut self.beginning);
        let expected = usize::try_from(self.size().unwrap_or(0)).unwrap_or(usize::MAX).saturating_sub(bytes.len());
        attempt(|| bytes.try_reserve(expected)).map_err(|_| self.failure(ErrorKind::OutOfMemory.into()))?;
        let left = (most + 1).saturating_sub(bytes.len() as u64);
        let read = attempt(|| self.rest.by_ref().take(left).read_to_end(&mut bytes));
        read.map_err(|error| self.failure(error))?;
        if bytes.len() as u64 <= most {
            return Ok(bytes);
        }
        let found = if self.packing.is_some() { "found more when decompressed" } else { "found more" };
        Err(self.wanted.too_large(&self.name, found))
    }

    /// The whole of it as it is read, of any size up to `most` bytes. What is packed may end with
    /// [`UnexpectedEof`](ErrorKind::UnexpectedEof) if it was cut off and with [`InvalidData`](ErrorKind::InvalidData) if it is
    /// damaged; what is larger is [`FileTooLarge`](ErrorKind::FileTooLarge).
    pub fn stream(self, most: u64) -> impl Read {
        let Opened { beginning, rest, packing, .. } = self;
        Stream { input: io::Cursor::new(beginning).chain(rest), packing, most, left: most }
    }

    fn failure(&self, error: io::Error) -> FileError {
        match self.packing.and_then(|packing| packing.damage(&error)) {
            Some(damage) => refused(&self.name, damage),
            _ => self.wanted.failure(&self.name, error),
        }
    }
}

/// What packed data end with that are damaged or end too early.
struct Broken(Option<io::Error>);

impl Read for Broken {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        Err(self.0.take().unwrap_or_else(|| ErrorKind::UnexpectedEof.into()))
    }
}

struct Stream<R> {
    input: R,
    packing: Option<Packing>,
    most: u64,
    left: u64,
}

impl<R: Read> Read for Stream<R> {
    fn read(&mut self, place: &mut [u8]) -> io::Result<usize> {
        let count =
            self.input.read(place).map_err(|error| match self.packing.and_then(|packing| packing.damage(&error)) {
                Some(damage) => {
                    let kind = match error.kind() {
                        ErrorKind::UnexpectedEof => ErrorKind::UnexpectedEof,
                        _ => ErrorKind::InvalidData,
                    };
                    io::Error::new(kind, damage)
                }
                _ => error,
            })?;
        let Some(left) = self.left.checked_sub(count as u64) else {
            let message = format!("too large, expected at most {} bytes, found more", self.most);
            return Err(io::Error::new(ErrorKind::FileTooLarge, message));
        };
        self.left = left;
        Ok(count)
    }
}

/// The name of a file as messages show it.
pub fn display_name(path: &Path) -> String {
    if path == Path::new("-") { STANDARD_INPUT.to_string() } else { path.to_string_lossy().into_owned() }
}

/// What a path that is no regular file is, in words.
pub fn irregular(metadata: &Metadata) -> Option<&'static str> {
    let kind = metadata.file_type();
    if kind.is_file() {
        return None;
    }
    if kind.is_dir() {
        return Some("a directory");
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_fifo() {
            return Some("a FIFO");
        }
        if kind.is_char_device() || kind.is_block_device() {
            return Some("a device");
        }
        if kind.is_socket() {
            return Some("a socket");
        }
    }
    Some("something else")
}

fn refused(name: &str, reason: String) -> FileError {
    FileError::Refused { file: name.to_string(), reason }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::GzEncoder;
    use std::io::Write;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    fn scene_file() -> Wanted {
        Wanted { what: "a scene file", max_bytes: 256 << 20 }
    }

    #[track_caller]
    fn refuses(path: &Path, exit_code: u8, part: &str) {
        let error = scene_file().read(path).unwrap_err();
        assert_eq!(error.exit_code(), exit_code);
        assert!(error.to_string().contains(part), "{error}");
    }

    #[test]
    fn a_missing_file() {
        refuses(Path::new("/no/such/scene.json"), 2, "no such file");
    }

    #[test]
    fn a_directory() {
        refuses(&std::env::temp_dir(), 2, "expected a regular file, found a directory");
    }

    #[test]
    #[cfg(unix)]
    fn an_endless_device() {
        refuses(Path::new("/dev/zero"), 2, "found a device");
    }

    #[test]
    #[cfg(unix)]
    fn a_fifo_that_nobody_writes_does_not_hang() {
        let folder = tempfile::tempdir().unwrap();
        let fifo = folder.path().join("fifo");
        let made = std::process::Command::new("mkfifo").arg(&fifo).status().unwrap();
        assert!(made.success());
        refuses(&fifo, 2, "found a FIFO");
    }

    #[test]
    fn a_huge_file_is_refused_by_its_size() {
        let file = tempfile::NamedTempFile::new().unwrap();
        file.as_file().set_len(5 << 30).unwrap();
        refuses(file.path(), 2, "expected at most 268435456 bytes, found 5368709120 bytes");
    }

    #[test]
    fn endless_input_ends_at_the_limit() {
        let opened = || scene_file().begin(io::repeat(b' '), 0, "-".to_owned()).unwrap();
        let error = opened().bytes().unwrap_err();
        assert_eq!(error.exit_code(), 2);
        assert!(error.to_string().contains("at most 268435456 bytes, found more"), "{error}");
        let error = opened().stream(1000).read_to_end(&mut Vec::new()).unwrap_err();
        assert_eq!(error.to_string(), "too large, expected at most 1000 bytes, found more");
    }

    /// What is said of these packed bytes, read whole.
    fn read_packed(bytes: Vec<u8>, max_bytes: u64) -> Result<Vec<u8>, String> {
        let wanted = Wanted { max_bytes, ..scene_file() };
        let opened = wanted.begin(io::Cursor::new(bytes), 0, "a".to_owned());
        opened.and_then(Opened::bytes).map_err(|error| {
            assert_eq!(error.exit_code(), 2);
            error.to_string().trim_start_matches("a: ").to_owned()
        })
    }

    #[test]
    fn what_is_not_packed_stays_as_it_is() {
        assert_eq!(read_packed(b"{}".to_vec(), 2), Ok(b"{}".to_vec()));
        assert_eq!(read_packed(Vec::new(), 1), Ok(Vec::new()));
    }

    #[test]
    fn packed_bytes_come_back_also_in_several_members() {
        let two = [packed(b"s 0 0"), packed(b" 0 1")].concat();
        assert_eq!(read_packed(two, 9), Ok(b"s 0 0 0 1".to_vec()));
    }

    #[test]
    fn a_bomb_ends_at_the_limit() {
        let bomb = packed(&vec![b' '; 1 << 20]);
        assert!(bomb.len() < 2000);
        let message = "too large, expected at most 1000 bytes, found more when decompressed";
        assert_eq!(read_packed(bomb.clone(), 1000), Err(message.to_string()));
        assert_eq!(read_packed(bomb, 1 << 20).map(|bytes| bytes.len()), Ok(1 << 20));
    }

    #[test]
    fn damage_is_said_of_short_and_of_long_files() {
        for length in [20_u32, 40_000] {
            let whole = packed(&(0..length).map(|k| (k * k % 251) as u8).collect::<Vec<_>>());
            let short = whole[..whole.len() - 9].to_vec();
            let message = "the gzip data end too early, expected a whole file";
            assert_eq!(read_packed(short.clone(), 1 << 20), Err(message.to_string()));
            // As a stream it ends there, so that what came before can be shown.
            let mut read = Vec::new();
            let opened = scene_file().begin(io::Cursor::new(short), 0, "a".to_owned()).unwrap();
            let error = opened.stream(1 << 20).read_to_end(&mut read).unwrap_err();
            assert_eq!(error.kind(), ErrorKind::UnexpectedEof);
            assert!(read.len() > length as usize / 2);
            let mut changed = whole;
            let crc = changed.len() - 6;
            changed[crc] ^= 1;
            assert!(read_packed(changed.clone(), 1 << 20).unwrap_err().starts_with("damaged gzip data ("));
            let mut read = Vec::new();
            let opened = scene_file().begin(io::Cursor::new(changed), 0, "a".to_owned()).unwrap();
            let error = opened.stream(1 << 20).read_to_end(&mut read).unwrap_err();
            assert_eq!((error.kind(), read.len()), (ErrorKind::InvalidData, length as usize));
        }
    }

    #[test]
    fn a_failing_disk_may_be_tried_again() {
        let error = scene_file().failure("a", ErrorKind::PermissionDenied.into());
        assert_eq!(error.exit_code(), 3);
    }
}
