//! The header of a PLY file: which elements follow, and what their properties are.

use std::ops::Range;

use crate::files::escape::{QUOTED, shortened};
use crate::files::unknown;
use crate::scene::file::mesh::fault::Fault;
use crate::scene::file::mesh::words::{Syntax, Words};

/// What the header says.
#[derive(Debug)]
pub struct Header {
    /// How the body is written.
    pub encoding: Encoding,
    /// What it holds, in order.
    pub elements: Vec<Element>,
    /// The header's length in bytes.
    pub length: usize,
}

/// How the body is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// As text.
    Ascii,
    /// Binary, the least byte first.
    LittleEndian,
    /// Binary, the greatest byte first.
    BigEndian,
}

/// A kind of element in the file.
#[derive(Debug)]
pub struct Element {
    /// Its name.
    pub name: String,
    /// How many there are, if the header is right.
    pub count: u64,
    /// What each has.
    pub properties: Vec<Property>,
    /// Where the header has it.
    pub span: Range<usize>,
}

/// What each item of an element has.
#[derive(Debug)]
pub struct Property {
    /// Its name.
    pub name: String,
    /// Its type.
    pub kind: Kind,
    /// Where the header has it.
    pub span: Range<usize>,
}

/// The type of a property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One number.
    Scalar(Scalar),
    /// A count and this many numbers.
    List {
        /// The type of the count.
        count: Scalar,
        /// The type of the numbers.
        item: Scalar,
    },
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// The names of the types.
const SCALARS: [(&str, Scalar); 16] = [
    ("char", Scalar::I8),
    ("uchar", Scalar::U8),
    ("short", Scalar::I16),
    ("ushort", Scalar::U16),
    ("int", Scalar::I32),
    ("uint", Scalar::U32),
    ("float", Scalar::F32),
    ("double", Scalar::F64),
    ("int8", Scalar::I8),
    ("uint8", Scalar::U8),
    ("int16", Scalar::I16),
    ("uint16", Scalar::U16),
    ("int32", Scalar::I32),
    ("uint32", Scalar::U32),
    ("float32", Scalar::F32),
    ("float64", Scalar::F64),
];

/// The most elements, and the most properties of one, of a header.
const MAX_PLY_ENTRIES: usize = 1000;

impl Header {
    /// Reads the header of a PLY file.
    pub fn read(text: &[u8]) -> Result<Header, Fault> {
        let mut lines = Lines { words: Words::new(text, 0, Syntax::Plain) };
        let first = lines.words.next();
        if first.as_ref().is_none_or(|word| lines.words.bytes(word) != b"ply") {
            return Err(Fault::wrong(first.unwrap_or(0..0), "expected a PLY file, whose first line is `ply`"));
        }
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            if !lines.words.next_line() {
                return Err(Fault::wrong(lines.words.here(), "the header ends too early, expected `end_header`"));
            }
            let Some(keyword) = lines.words.next() else { continue };
            match lines.words.bytes(&keyword) {
                b"comment" | b"obj_info" => {}
                b"format" => encoding = Some(lines.encoding()?),
                b"element" if elements.len() < MAX_PLY_ENTRIES => {
                    let element = lines.element(keyword.start)?;
                    if elements.iter().any(|known| known.name == element.name) {
                        let message = format!("the element `{}` occurs twice, expected it once", shown(&element.name));
                        return Err(Fault::wrong(element.span, message));
                    }
                    elements.push(element);
                }
                b"property" => {
                    let property = lines.property(keyword.start)?;
                    match elements.last_mut() {
                        Some(element) if element.properties.len() < MAX_PLY_ENTRIES => {
                            element.properties.push(property)
                        }
                        Some(_) => return Err(too_many(keyword)),
                        None => return Err(Fault::wrong(keyword, "expected an `element` before its properties")),
                    }
                }
                b"element" => return Err(too_many(keyword)),
                b"end_header" => break,
                _ => {
                    let shown = lines.words.shown(&keyword);
                    let message =
                        format!("expected `format`, `comment`, `element`, `property` or `end_header`, found `{shown}`");
                    return Err(Fault::wrong(keyword, message));
                }
            }
        }
        let end = lines.words.at;
        let Some(encoding) = encoding else {
            return Err(Fault::wrong(0..3, "the header has no `format`, expected such as `format ascii 1.0`"));
        };
        // The body may begin with any byte, so only the end of this very line is skipped.
        lines.words.next_line();
        let length = lines.words.at;
        if length == end {
            return Err(Fault::wrong(end..end, "the file ends with its header"));
        }
        Ok(Header { encoding, elements, length })
    }
}

/// A name of the header as messages show it.
pub fn shown(name: &str) -> String {
    shortened(name, QUOTED)
}

fn too_many(span: Range<usize>) -> Fault {
    Fault::wrong(span, format!("too many, expected at most {MAX_PLY_ENTRIES}"))
}

struct Lines<'t> {
    words: Words<'t>,
}

impl Lines<'_> {
    fn encoding(&mut self) -> Result<Encoding, Fault> {
        let word = self.word("`ascii`, `binary_little_endian` or `binary_big_endian`")?;
        let encoding = match self.words.bytes(&word) {
            b"ascii" => Encoding::Ascii,
            b"binary_little_endian" => Encoding::LittleEndian,
            b"binary_big_endian" => Encoding::BigEndian,
            _ => {
                let shown = self.words.shown(&word);
                let expected = "expected `ascii`, `binary_little_endian` or `binary_big_endian`";
                return Err(Fault::wrong(word, format!("{expected}, found `{shown}`")));
            }
        };
        let version = self.word("the version `1.0`")?;
        if self.words.bytes(&version) != b"1.0" {
            let shown = self.words.shown(&version);
            return Err(Fault::wrong(version, format!("expected the version `1.0`, found `{shown}`")));
        }
        Ok(encoding)
    }

    fn element(&mut self, start: usize) -> Result<Element, Fault> {
        let name = self.word("the name of an element")?;
        let count = self.word("the number of its records")?;
        let number = std::str::from_utf8(self.words.bytes(&count)).ok().and_then(|word| word.parse().ok());
        let Some(number) = number else {
            let shown = self.words.shown(&count);
            return Err(Fault::wrong(count, format!("expected the number of records, found `{shown}`")));
        };
        let name = String::from_utf8_lossy(self.words.bytes(&name)).into_owned();
        Ok(Element { name, count: number, properties: Vec::new(), span: start..count.end })
    }

    fn property(&mut self, start: usize) -> Result<Property, Fault> {
        let first = self.word("the type of a property")?;
        let kind = if self.words.bytes(&first) == b"list" {
            let count = self.word("the type of the list's count")?;
            let (at, count) = (count.clone(), self.scalar(count)?);
            if matches!(count, Scalar::F32 | Scalar::F64) {
                return Err(Fault::wrong(at, "expected a count of whole numbers"));
            }
            let item = self.word("the type of the list's items")?;
            Kind::List { count, item: self.scalar(item)? }
        } else {
            Kind::Scalar(self.scalar(first)?)
        };
        let name = self.word("the name of a property")?;
        let span = start..name.end;
        Ok(Property { name: String::from_utf8_lossy(self.words.bytes(&name)).into_owned(), kind, span })
    }

    fn scalar(&self, word: Range<usize>) -> Result<Scalar, Fault> {
        let name = String::from_utf8_lossy(self.words.bytes(&word));
        if let Some((_, scalar)) = SCALARS.iter().find(|(known, _)| *known == name) {
            return Ok(*scalar);
        }
        Err(Fault::wrong(word, unknown("type", &name, &SCALARS.map(|(known, _)| known))))
    }

    fn word(&mut self, expected: &str) -> Result<Range<usize>, Fault> {
        let here = self.words.here();
        self.words.next().ok_or_else(|| Fault::wrong(here, format!("the line ends too early, expected {expected}")))
    }
}

impl Kind {
    /// How many bytes a value has at least in a binary file.
    pub fn least_size(self) -> u64 {
        match self {
            Kind::Scalar(scalar) => scalar.size(),
            Kind::List { count, .. } => count.size(),
        }
    }
}

impl Scalar {
    /// How many bytes it has in a binary file.
    pub fn size(self) -> u64 {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }
}
