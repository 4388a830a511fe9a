//! The numbers of a raw file, one after the other.

use crate::files::{FileError, escape_hidden};
use std::io::{self, ErrorKind};

/// A raw file that is being read, from its first byte on.
pub struct Fields<'b> {
    name: &'b str,
    bytes: &'b [u8],
    at: usize,
}

/// What a file claims to hold.
pub struct Claim {
    /// What is counted, such as `triangles`.
    pub what: &'static str,
    /// How many.
    pub count: u64,
    /// The bytes of each.
    pub size: usize,
    /// The most that are read.
    pub most: usize,
}

impl<'b> Fields<'b> {
    /// A file that begins with these eight letters and has a head of this many bytes, the letters included.
    pub fn of(bytes: &'b [u8], name: &'b str, letters: &str, head: usize) -> Result<Fields<'b>, FileError> {
        let fields = Fields { name, bytes, at: letters.len() };
        if bytes.is_empty() {
            return Err(fields.refused(format!("is empty, expected it to begin with `{letters}`")));
        }
        if !bytes.starts_with(letters.as_bytes()) {
            let found = String::from_utf8_lossy(&bytes[..bytes.len().min(letters.len())]).into_owned();
            return Err(
                fields.refused(format!("expected it to begin with `{letters}`, found `{}`", escape_hidden(&found)))
            );
        }
        if bytes.len() < head {
            return Err(fields.refused(format!("ends within its head, expected {head} bytes, found {}", bytes.len())));
        }
        Ok(fields)
    }

    /// Makes sure that what follows is exactly what the head claims.
    pub fn must_hold(&self, claims: &[Claim]) -> Result<(), FileError> {
        for Claim { what, count, most, .. } in claims {
            if *count > *most as u64 {
                return Err(self.refused(format!("too many {what}, expected at most {most}, found {count}")));
            }
        }
        let expected: u64 = claims.iter().map(|claim| claim.count * claim.size as u64).sum::<u64>() + self.at as u64;
        if expected == self.bytes.len() as u64 {
            return Ok(());
        }
        let counts: Vec<_> = claims.iter().map(|claim| format!("{} {}", claim.count, claim.what)).collect();
        let (counts, found) = (counts.join(" and "), self.bytes.len());
        Err(self.refused(format!("its head says {counts}, which are {expected} bytes in all, found {found} bytes")))
    }

    /// Reads this many items, each by `read`.
    pub fn list<T>(
        &mut self,
        count: u64,
        mut read: impl FnMut(&mut Self, u64) -> Result<T, FileError>,
    ) -> Result<Vec<T>, FileError> {
        let mut list = Vec::new();
        // The counts were compared with the length of the file.
        raywalk_guard::attempt(|| list.try_reserve_exact(count as usize)).map_err(|_| self.out_of_memory())?;
        for number in 0..count {
            list.push(read(self, number)?);
        }
        Ok(list)
    }

    /// This many bytes, zeros beyond the end: the length was looked at before.
    fn next<const N: usize>(&mut self) -> [u8; N] {
        let found = self.bytes.get(self.at..self.at + N).and_then(|bytes| bytes.try_into().ok());
        self.at += N;
        found.unwrap_or([0; N])
    }

    pub fn u32(&mut self) -> u32 {
        u32::from_le_bytes(self.next())
    }

    pub fn u64(&mut self) -> u64 {
        u64::from_le_bytes(self.next())
    }

    pub fn f32(&mut self) -> f32 {
        f32::from_le_bytes(self.next())
    }

    /// Numbers that are finite.
    pub fn finite<const N: usize>(&mut self, what: &str, number: u64) -> Result<[f32; N], FileError> {
        let begin = self.at;
        let numbers = [(); N].map(|()| self.f32());
        match numbers.iter().position(|x| !x.is_finite()) {
            None => Ok(numbers),
            Some(k) => {
                let (found, at) = (numbers[k], begin + 4 * k);
                Err(self.refused(format!("{what} {number}: expected finite numbers, found {found} (at byte {at})")))
            }
        }
    }

    /// The file, and what is wrong with it.
    pub fn refused(&self, reason: impl Into<String>) -> FileError {
        FileError::Refused { file: self.name.to_owned(), reason: reason.into() }
    }

    /// There is no room for what the file holds.
    pub fn out_of_memory(&self) -> FileError {
        FileError::Unreadable { file: self.name.to_owned(), source: io::Error::from(ErrorKind::OutOfMemory) }
    }
}
