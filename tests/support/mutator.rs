//! Files that were damaged at random: bytes changed, put in, taken out, repeated, exchanged, cut off.

use proptest::prelude::*;
use proptest::sample::Index;

/// A change of a file.
#[derive(Clone, Debug)]
pub enum Change {
    Replace(Index, u8),
    Flip(Index, u8),
    Insert(Index, Vec<u8>),
    Overwrite(Index, Vec<u8>),
    Remove(Index, u8),
    Repeat(Index, Index),
    Move(Index, Index, Index),
    Cut(Index),
}

/// A few changes, some of which put in words that mean something to the reader.
pub fn changes(words: &'static [&'static str]) -> impl Strategy<Value = Vec<Change>> {
    let word = || proptest::sample::select(words).prop_map(|word| word.as_bytes().to_vec());
    let bytes = proptest::collection::vec(any::<u8>(), 1..6);
    let place = any::<Index>;
    let change = prop_oneof![
        (place(), any::<u8>()).prop_map(|(at, byte)| Change::Replace(at, byte)),
        (place(), 0..8_u8).prop_map(|(at, bit)| Change::Flip(at, bit)),
        (place(), prop_oneof![word(), bytes]).prop_map(|(at, bytes)| Change::Insert(at, bytes)),
        (place(), word()).prop_map(|(at, bytes)| Change::Overwrite(at, bytes)),
        (place(), 1..20_u8).prop_map(|(at, count)| Change::Remove(at, count)),
        (place(), place()).prop_map(|(from, to)| Change::Repeat(from, to)),
        (place(), place(), place()).prop_map(|(from, to, at)| Change::Move(from, to, at)),
        place().prop_map(Change::Cut),
    ];
    proptest::collection::vec(change, 1..6)
}

/// The file with these changes.
pub fn changed(file: &[u8], changes: &[Change]) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for change in changes.iter() {
        if !bytes.is_empty() {
            apply(&mut bytes, change);
        }
    }
    bytes
}

fn apply(bytes: &mut Vec<u8>, change: &Change) {
    let length = bytes.len();
    let part = |from: &Index, to: &Index| {
        let (from, to) = (from.index(length), to.index(length));
        from.min(to)..from.max(to)
    };
    match change {
        Change::Replace(at, byte) => bytes[at.index(length)] = *byte,
        Change::Flip(at, bit) => bytes[at.index(length)] ^= 1 << bit,
        Change::Insert(at, inserted) => {
            let at = at.index(length);
            bytes.splice(at..at, inserted.iter().copied());
        }
        Change::Overwrite(at, new) => {
            let at = at.index(length);
            bytes.splice(at..(at + new.len()).min(length), new.iter().copied());
        }
        Change::Remove(at, count) => {
            let at = at.index(length);
            bytes.drain(at..(at + usize::from(*count)).min(length));
        }
        Change::Repeat(from, to) => {
            let repeated = bytes[part(from, to)].to_vec();
            bytes.extend(repeated);
        }
        Change::Move(from, to, at) => {
            let moved: Vec<u8> = bytes.drain(part(from, to)).collect();
            let at = at.index(bytes.len() + 1);
            bytes.splice(at..at, moved);
        }
        Change::Cut(at) => bytes.truncate(at.index(length)),
    }
}
