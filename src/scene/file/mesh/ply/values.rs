//! The values of a PLY body, one after another, from text or from bytes.

use std::ops::Range;

use super::header::{Kind, Scalar};
use crate::scene::file::foreign::number;
use crate::scene::file::mesh::fault::Fault;
use crate::scene::file::mesh::words::{Syntax, Words};

/// Gives the values of a body in order. Every type of the format fits into an f64.
pub trait Values {
    /// The next value, and where it is.
    fn next(&mut self, scalar: Scalar) -> Result<(f64, Range<usize>), Fault>;

    /// Passes over a value that nobody uses.
    fn skip(&mut self, scalar: Scalar) -> Result<(), Fault> {
        self.next(scalar).map(|_| ())
    }

    /// Begins a record.
    fn begin_record(&mut self) {}

    /// Ends a record.
    fn end_record(&mut self) -> Result<(), Fault> {
        Ok(())
    }

    /// How many records with these properties the rest of the file has room for.
    fn room_for(&self, kinds: &mut dyn Iterator<Item = Kind>) -> u64;
}

/// Values as text.
pub struct Ascii<'t> {
    words: Words<'t>,
    length: usize,
    lines: Lines,
    /// Where the line of this record ended before the record did.
    ended_early: Option<Range<usize>>,
    /// The first value that is left out, and how many lines have such.
    pub left_out: Option<(Range<usize>, usize)>,
}

/// What the ends of lines mean in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines {
    /// Nothing: they are blanks.
    Blanks,
    /// Records: each begins on a line of its own. Further values on that line are left out; a record that goes on in the next
    /// line must end with a line, or else a value is missing.
    Records,
}

/// Values as bytes.
pub struct Binary<'t> {
    bytes: &'t [u8],
    at: usize,
    order: Order,
}

/// In which order the bytes of a value are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The least first.
    Little,
    /// The greatest first.
    Big,
}

impl<'t> Ascii<'t> {
    /// The values from this place on.
    pub fn new(text: &'t [u8], start: usize, lines: Lines) -> Ascii<'t> {
        let length = text.len();
        Ascii { words: Words::new(text, start, Syntax::Plain), length, lines, ended_early: None, left_out: None }
    }

    /// Whether no value is left.
    pub fn is_at_end(&mut self) -> bool {
        self.next_word().is_none()
    }

    /// The next word, on whatever line.
    fn next_word(&mut self) -> Option<Range<usize>> {
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            if !self.words.next_line() {
                return None;
            }
        }
    }

    fn value(&mut self, read: impl FnOnce(&[u8]) -> Option<f64>, scalar: Scalar) -> Result<(f64, Range<usize>), Fault> {
        let found = match self.words.next() {
            None => {
                let end = self.words.here();
                self.ended_early.get_or_insert(end);
                self.next_word()
            }
            found => found,
        };
        let Some(word) = found else { return Err(self.too_early()) };
        match read(self.words.bytes(&word)) {
            Some(value) => Ok((value, word)),
            None => {
                let expected = scalar.expected();
                let message = format!("expected {expected}, found `{}`", self.words.shown(&word));
                Err(Fault::wrong(word, message))
            }
        }
    }

    fn too_early(&mut self) -> Fault {
        let end = self.ended_early.take().unwrap_or(self.words.here());
        Fault::wrong(end, "the line ends too early, expected a number")
    }
}

impl Values for Ascii<'_> {
    fn next(&mut self, scalar: Scalar) -> Result<(f64, Range<usize>), Fault> {
        self.value(|word| parse(word, scalar), scalar)
    }

    /// A colour of 0.5 in whole numbers is no harm.
    fn skip(&mut self, scalar: Scalar) -> Result<(), Fault> {
        self.value(number, scalar).map(|_| ())
    }

    /// Skips empty lines.
    fn begin_record(&mut self) {
        self.ended_early = None;
        loop {
            let mut ahead = Words::new(self.words.text(), self.words.at, Syntax::Plain);
            if ahead.next().is_some() || !ahead.next_line() {
                return;
            }
            self.words.at = ahead.at;
        }
    }

    fn end_record(&mut self) -> Result<(), Fault> {
        if self.lines == Lines::Blanks {
            return Ok(());
        }
        if let Some(word) = self.words.next() {
            if self.ended_early.is_some() {
                return Err(self.too_early());
            }
            self.left_out.get_or_insert((word, 0)).1 += 1;
        }
        self.words.next_line();
        Ok(())
    }

    fn room_for(&self, kinds: &mut dyn Iterator<Item = Kind>) -> u64 {
        // A digit and a space or the end of the line each; the last line may lack its end.
        let least = 2 * kinds.count() as u64;
        (self.length - self.words.at + 1) as u64 / least.max(1)
    }
}

fn parse(word: &[u8], scalar: Scalar) -> Option<f64> {
    let text = std::str::from_utf8(word).unwrap_or_default();
    let whole = |low: f64, high: f64| {
        let value = text.parse::<i64>().ok()? as f64;
        (low <= value && value <= high).then_some(value)
    };
    match scalar {
        Scalar::I8 => whole(-128.0, 127.0),
        Scalar::U8 => whole(0.0, 255.0),
        Scalar::I16 => whole(-32_768.0, 32_767.0),
        Scalar::U16 => whole(0.0, 65_535.0),
        Scalar::I32 => whole(f64::from(i32::MIN), f64::from(i32::MAX)),
        Scalar::U32 => whole(0.0, f64::from(u32::MAX)),
        Scalar::F32 => text.parse::<f32>().ok().map(f64::from).or_else(|| number(word)),
        Scalar::F64 => number(word),
    }
}

impl Scalar {
    /// What a text of this type holds, in words.
    fn expected(self) -> &'static str {
        match self {
            Scalar::I8 => "a whole number from -128 to 127",
            Scalar::U8 => "a whole number from 0 to 255",
            Scalar::I16 => "a whole number from -32768 to 32767",
            Scalar::U16 => "a whole number from 0 to 65535",
            Scalar::I32 => "a whole number from -2147483648 to 2147483647",
            Scalar::U32 => "a whole number from 0 to 4294967295",
            Scalar::F32 | Scalar::F64 => "a number",
        }
    }
}

impl<'t> Binary<'t> {
    /// The values from this place on.
    pub fn new(bytes: &'t [u8], start: usize, order: Order) -> Binary<'t> {
        Binary { bytes, at: start, order }
    }

    /// The next bytes, the least first.
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let mut bytes = *self.bytes.get(self.at..)?.first_chunk::<N>()?;
        self.at += N;
        if self.order == Order::Big {
            bytes.reverse();
        }
        Some(bytes)
    }

    fn value(&mut self, scalar: Scalar) -> Option<f64> {
        Some(match scalar {
            Scalar::I8 => i8::from_le_bytes(self.take()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.take()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.take()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.take()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.take()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.take()?).into(),
            Scalar::F32 => f32::from_le_bytes(self.take()?).into(),
            Scalar::F64 => f64::from_le_bytes(self.take()?),
        })
    }
}

impl Values for Binary<'_> {
    fn next(&mut self, scalar: Scalar) -> Result<(f64, Range<usize>), Fault> {
        let start = self.at;
        match self.value(scalar) {
            Some(value) => Ok((value, start..self.at)),
            None => Err(Fault::wrong(start..start, "the file ends too early")),
        }
    }

    fn room_for(&self, kinds: &mut dyn Iterator<Item = Kind>) -> u64 {
        let least: u64 = kinds.map(Kind::least_size).sum();
        (self.bytes.len() - self.at) as u64 / least.max(1)
    }
}
