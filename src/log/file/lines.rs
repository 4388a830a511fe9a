//! The lines of a log as they come: little more of its text is held than a block.

use crate::files::without_mark;
use memchr::memchr;
use raywalk_guard::attempt;
use std::io::{self, ErrorKind, Read};

/// How much is read at a time: enough for a fast digest, and soon gone from the cache again.
const BLOCK: usize = 256 << 10;

/// The longest line of a log behind its header, also where it is broken into several: some thousand times as long as those of raywalk.
pub const MAX_LOG_LINE: usize = 1 << 20;

/// The longest header of a log: as long as a scene, whose names it has.
pub const MAX_LOG_HEADER: usize = 1 << 28;

/// The lines of a text, and the digest of those that have gone by.
pub(super) struct Lines<R> {
    input: R,
    /// What was read and isn't done with.
    block: Vec<u8>,
    /// Up to here the block is in the digest.
    digested: usize,
    /// Where the line begins that was asked for last.
    current: usize,
    /// Where the next one begins.
    next: usize,
    /// Whether there is nothing more to read.
    is_at_end: bool,
    /// What ended packed data before their end.
    damage: Option<io::Error>,
    hasher: blake3::Hasher,
    number: usize,
    /// The most bytes of the next line.
    most: usize,
}

/// A line without its end; where other programs have broken a value into several, all of them.
pub(super) struct TextLine<'b> {
    pub text: &'b [u8],
    /// Its number, from 1.
    pub number: usize,
    /// Whether an end of line is after it.
    pub is_terminated: bool,
}

impl<R: Read> Lines<R> {
    /// Those of this input.
    pub fn of(input: R) -> Lines<R> {
        let hasher = blake3::Hasher::new();
        Lines {
            input,
            block: Vec::new(),
            digested: 0,
            current: 0,
            next: 0,
            is_at_end: false,
            damage: None,
            hasher,
            number: 0,
            most: MAX_LOG_HEADER,
        }
    }

    /// The first bytes of the text that aren't white space, some hundreds of them if there are. A byte order mark before them
    /// is no part of the text: no digest has it.
    pub fn beginning(&mut self) -> io::Result<&[u8]> {
        while !self.is_at_end && self.block.trim_ascii_start().len() < 512 {
            self.read_more()?;
        }
        if self.number == 0 {
            self.block.drain(..self.block.len() - without_mark(&self.block).len());
        }
        Ok(self.block.trim_ascii_start())
    }

    /// The whole text, of which no line was asked for yet.
    pub fn whole(mut self) -> io::Result<Vec<u8>> {
        while !self.is_at_end {
            self.read_more()?;
        }
        match self.damage {
            Some(damage) => Err(damage),
            None => Ok(self.block),
        }
    }

    /// The header was read: lines are shorter from there on.
    pub fn pass_header(&mut self) {
        self.most = MAX_LOG_LINE;
    }

    /// The next line. An object that isn't complete there goes on in the next lines, but no further than to one that begins with a brace.
    pub fn next_line(&mut self) -> io::Result<Option<TextLine<'_>>> {
        let (mut end, mut length) = self.length(0)?;
        if length == 0 {
            return Ok(None);
        }
        let number = self.number + 1;
        self.number = number;
        let mut goes_on = self.goes_on(length)?;
        if goes_on && self.block[self.next..self.next + end].trim_ascii_start().starts_with(b"{") {
            let mut brackets = Brackets::default();
            brackets.pass(&self.block[self.next..self.next + end]);
            while goes_on && brackets.are_open() {
                let line = length;
                (end, length) = self.length(line)?;
                brackets.pass(&self.block[self.next + line..self.next + end]);
                goes_on = self.goes_on(length)?;
                self.number += 1;
            }
        }
        (self.current, self.next) = (self.next, self.next + length);
        let text = &self.block[self.current..self.current + end];
        Ok(Some(TextLine { text, number, is_terminated: end < length }))
    }

    /// The bytes from the next line's beginning to the first line end behind the first `searched` of them, without and with that end.
    #[inline]
    fn length(&mut self, mut searched: usize) -> io::Result<(usize, usize)> {
        loop {
            let found = memchr(b'\n', &self.block[self.next + searched..]);
            searched = found.map_or(self.block.len() - self.next, |more| searched + more);
            if searched > self.most {
                return Err(too_long(self.number + 1, self.most));
            }
            if found.is_some() {
                return Ok((searched, searched + 1));
            }
            if self.is_at_end {
                return Ok((searched, searched));
            }
            self.read_on()?;
        }
    }

    /// Whether the text at this distance behind the next line's beginning can be the rest of an object.
    #[inline]
    fn goes_on(&mut self, behind: usize) -> io::Result<bool> {
        while !self.is_at_end && self.block.len() <= self.next + behind {
            self.read_on()?;
        }
        Ok(self.block.get(self.next + behind).is_some_and(|first| *first != b'{'))
    }

    /// Reads more of what the next line may be.
    fn read_on(&mut self) -> io::Result<()> {
        self.forget_to(self.next);
        self.read_more()
    }

    /// What ended the text before its end: packed data that were cut off
    /// ([`UnexpectedEof`](ErrorKind::UnexpectedEof)) or changed ([`InvalidData`](ErrorKind::InvalidData)).
    pub fn damage(&self) -> Option<&io::Error> {
        self.damage.as_ref()
    }

    /// The digest of everything before the line that was asked for last.
    pub fn digest(&mut self) -> blake3::Hash {
        self.digest_to(self.current);
        self.hasher.finalize()
    }

    /// How many bytes there are from the next line on, without white space before and behind.
    pub fn count_rest(&mut self) -> io::Result<u64> {
        let (mut count, mut space) = (0, 0);
        loop {
            for byte in &self.block[self.next..] {
                if !byte.is_ascii_whitespace() {
                    count += 1 + if count > 0 { space } else { 0 };
                    space = 0;
                } else {
                    space += 1;
                }
            }
            if self.is_at_end {
                return Ok(count);
            }
            self.forget_to(self.block.len());
            self.read_more()?;
        }
    }

    fn digest_to(&mut self, end: usize) {
        self.hasher.update(&self.block[self.digested..end]);
        self.digested = end;
    }

    /// Drops what precedes `place`, where the next line begins.
    fn forget_to(&mut self, place: usize) {
        self.digest_to(place);
        self.block.drain(..place);
        (self.digested, self.current, self.next) = (0, 0, 0);
    }

    fn read_more(&mut self) -> io::Result<()> {
        attempt(|| self.block.try_reserve(BLOCK)).map_err(|_| io::Error::from(ErrorKind::OutOfMemory))?;
        match self.input.by_ref().take(BLOCK as u64).read_to_end(&mut self.block) {
            Ok(0) => self.is_at_end = true,
            Ok(_) => {}
            // What came before is as good as that of another file.
            Err(error) if matches!(error.kind(), ErrorKind::UnexpectedEof | ErrorKind::InvalidData) => {
                (self.is_at_end, self.damage) = (true, Some(error));
            }
            Err(error) => return Err(error),
        }
        Ok(())
    }
}

/// What is said of a line that is too long.
pub(super) fn too_long(number: usize, most: usize) -> io::Error {
    let message = format!("line {number} is too long, expected at most {most} bytes in this line of a log, found more");
    io::Error::new(ErrorKind::FileTooLarge, message)
}

/// The brackets of a JSON text that are open. Those in strings don't count.
#[derive(Default)]
pub(super) struct Brackets {
    pub depth: usize,
    in_string: bool,
    is_escaped: bool,
}

impl Brackets {
    /// Goes on with these bytes.
    pub fn pass(&mut self, bytes: &[u8]) {
        for byte in bytes {
            match byte {
                _ if self.is_escaped => self.is_escaped = false,
                b'\\' if self.in_string => self.is_escaped = true,
                b'"' => self.in_string = !self.in_string,
                b'{' | b'[' if !self.in_string => self.depth += 1,
                b'}' | b']' if !self.in_string => self.depth = self.depth.saturating_sub(1),
                _ => {}
            }
        }
    }

    /// Whether none are, outside of strings.
    pub fn are_none(&self) -> bool {
        self.depth == 0 && !self.in_string
    }

    /// Whether some are, outside of strings: no string goes on in another line.
    fn are_open(&self) -> bool {
        self.depth > 0 && !self.in_string
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Gives no more than this many bytes at a time.
    struct Slowly<'b>(&'b [u8], usize);

    impl Read for Slowly<'_> {
        fn read(&mut self, place: &mut [u8]) -> io::Result<usize> {
            let count = self.0.len().min(self.1).min(place.len());
            place[..count].copy_from_slice(&self.0[..count]);
            self.0 = &self.0[count..];
            Ok(count)
        }
    }

    /// The lines, each with the digest of what precedes it.
    fn lines(input: impl Read) -> Vec<(Vec<u8>, usize, bool, blake3::Hash)> {
        let mut lines = Lines::of(input);
        let mut found = Vec::new();
        while let Some(TextLine { text, number, is_terminated }) = lines.next_line().unwrap() {
            let text = text.to_vec();
            found.push((text, number, is_terminated, lines.digest()));
        }
        found
    }

    #[test]
    fn lines_of_all_lengths_come_whole_however_they_are_read() {
        let lengths = [0, 1, 7, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK, 0, 5];
        let text: Vec<u8> = lengths.iter().flat_map(|length| [vec![b'x'; *length], vec![b'\n']].concat()).collect();
        for without in [0, 1, 4] {
            let text = &text[..text.len() - without];
            let mut before = 0;
            let expected: Vec<_> = (1..)
                .zip(text.split_inclusive(|byte| *byte == b'\n'))
                .map(|(number, line)| {
                    let digest = blake3::hash(&text[..before]);
                    before += line.len();
                    let content = line.strip_suffix(b"\n");
                    (content.unwrap_or(line).to_vec(), number, content.is_some(), digest)
                })
                .collect();
            assert_eq!(expected.len(), lengths.len());
            assert!(lines(text) == expected);
            assert!(lines(Slowly(text, 1000)) == expected);
        }
        assert!(lines(&b""[..]).is_empty());
    }

    #[test]
    fn the_rest_is_counted_without_space_around() {
        let count = |text: &[u8]| {
            let mut lines = Lines::of(Slowly(text, 3));
            lines.next_line().unwrap();
            lines.count_rest().unwrap()
        };
        assert_eq!([count(b"a"), count(b"a\n\n  "), count(b"a\n \nb c\n\n"), count(b"a\nbb")], [0, 0, 3, 2]);
        let long = [b"a\n".to_vec(), vec![b' '; BLOCK], vec![b'b'; BLOCK], vec![b' '; BLOCK], vec![b'b'; 2]].concat();
        assert_eq!(count(&long), 2 * BLOCK as u64 + 2);
    }

    #[test]
    fn the_beginning_stays_to_be_read() {
        let mut lines = Lines::of(Slowly(b" \n {\"log\": 1}\nb", 2));
        assert!(lines.beginning().unwrap().starts_with(b"{\"log\""));
        assert_eq!(lines.next_line().unwrap().unwrap().text, b" ");
        assert_eq!(lines.next_line().unwrap().unwrap().text, b" {\"log\": 1}");
    }
}
