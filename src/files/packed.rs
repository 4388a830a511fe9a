//! Packed files, which are unpacked as they are read.

use super::{gzip, zstd};
use raywalk_guard::Demanding;
use std::io::{Error, ErrorKind, Read};

/// The name of a file without the ending that says by what it is packed.
pub fn unpacked_name(name: &str) -> &str {
    name.rsplit_once('.').filter(|(_, ending)| Packing::of_ending(ending).is_some()).map_or(name, |(plain, _)| plain)
}

/// By what a file is packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// RFC 1952.
    Gzip,
    /// RFC 8878.
    Zstd,
}

impl Packing {
    /// What a file that begins like this is packed by, if it is.
    pub(super) fn of(beginning: &[u8]) -> Option<Packing> {
        if beginning.starts_with(gzip::MAGIC) {
            Some(Packing::Gzip)
        } else if beginning.starts_with(zstd::MAGIC) {
            Some(Packing::Zstd)
        } else {
            None
        }
    }

    /// What a file with this ending is to be packed by.
    pub fn of_ending(ending: &str) -> Option<Packing> {
        match ending.to_ascii_lowercase().as_str() {
            "gz" => Some(Packing::Gzip),
            "zst" => Some(Packing::Zstd),
            _ => None,
        }
    }

    /// The bytes as they were.
    pub(super) fn unpacked(self, input: impl Read + 'static) -> Box<dyn Read> {
        match self {
            Packing::Gzip => Box::new(Demanding(gzip::unpacked(input))),
            Packing::Zstd => Box::new(Demanding(zstd::unpacked(input))),
        }
    }

    /// What is wrong with a packed file, if that is why it can't be read.
    pub(super) fn damage(self, error: &Error) -> Option<String> {
        let name = match self {
            Packing::Gzip => "gzip",
            Packing::Zstd => "zstd",
        };
        match error.kind() {
            ErrorKind::UnexpectedEof => Some(format!("the {name} data end too early, expected a whole file")),
            ErrorKind::InvalidInput | ErrorKind::InvalidData => {
                Some(format!("damaged {name} data ({error}), expected a whole file"))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_of_what_packs_a_file_is_no_part_of_its_name() {
        for (name, plain) in [("a.obj.gz", "a.obj"), ("A.OBJ.ZST", "A.OBJ"), ("a.obj", "a.obj"), ("zst", "zst")] {
            assert_eq!(unpacked_name(name), plain);
        }
    }
}
