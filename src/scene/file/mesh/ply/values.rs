//! The values of a PLY body, one after another, from text or from bytes.

use std::ops::Range;

use super::header::{Kind, Scalar};
use crate::scene::file::mesh::fault::Fault;
use crate::scene::file::mesh::words::{Syntax, Words};

/// Gives the values of a body in order. Every type of the format fits into an f64.
pub trait Values {
    /// The next value, and where it stands.
    fn next(&mut self, scalar: Scalar) -> Result<(f64, Range<usize>), Fault>;

    /// Begins a record.
    fn begin_record(&mut self) {}

    /// Ends a record.
    fn end_record(&mut self) -> Result<(), Fault> {
        Ok(())
    }

    /// How many records with these properties the rest of the file has room for.
    fn room_for(&self, kinds: &mut dyn Iterator<Item = Kind>) -> u64;
}

/// Values as text, one record a line.
pub struct Ascii<'t> {
    words: Words<'t>,
    length: usize,
}

/// Values as bytes.
pub struct Binary<'t> {
    bytes: &'t [u8],
    at: usize,
    order: Order,
}

/// In which order the bytes of a value stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The least first.
    Little,
    /// The greatest first.
    Big,
}

impl<'t> Ascii<'t> {
    /// The values from this place on.
    pub fn new(text: &'t [u8], start: usize) -> Ascii<'t> {
        Ascii { words: Words::new(text, start, Syntax::Plain), length: text.len() }
    }
}

impl Values for Ascii<'_> {
    fn next(&mut self, scalar: Scalar) -> Result<(f64, Range<usize>), Fault> {
        let Some(word) = self.words.next() else {
            return Err(Fault::wrong(self.words.here(), "the line ends too early, expected a number"));
        };
        let text = std::str::from_utf8(self.words.bytes(&word)).unwrap_or_default();
        match parse(text, scalar) {
            Some(value) => Ok((value, word)),
            None => {
                let expected = scalar.expected();
                let message = format!("expected {expected}, found `{}`", self.words.shown(&word));
                Err(Fault::wrong(word, message))
            }
        }
    }

    /// Skips empty lines.
    fn begin_record(&mut self) {
        loop {
            let mut ahead = Words::new(self.words.text(), self.words.at, Syntax::Plain);
            if ahead.next().is_some() || !ahead.next_line() {
                return;
            }
            self.words.at = ahead.at;
        }
    }

    fn end_record(&mut self) -> Result<(), Fault> {
        if let Some(word) = self.words.next() {
            let message = format!("expected the end of the line, found `{}`", self.words.shown(&word));
            return Err(Fault::wrong(word, message));
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

fn parse(text: &str, scalar: Scalar) -> Option<f64> {
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
        Scalar::F32 => text.parse::<f32>().ok().map(f64::from),
        Scalar::F64 => text.parse().ok(),
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
