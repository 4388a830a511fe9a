//! Broken files, thousands of them: they are read or refused, and nothing panics or hangs.

use proptest::prelude::*;
use proptest::sample::Index;

use super::super::parse;
use super::{SQUARE, ply};

/// A change of a file.
#[derive(Clone, Debug)]
enum Change {
    Replace(Index, u8),
    Insert(Index, Vec<u8>),
    Remove(Index, u8),
    Repeat(Index, Index),
    Cut(Index),
}

fn change() -> impl Strategy<Value = Change> {
    let words = ["-1", "99999999999", "4294967296", "1e999", "nan", "/", "//", "\\\n", "\n", "\r", " ", "f ", "v "];
    let word = proptest::sample::select(words.to_vec()).prop_map(|word| word.as_bytes().to_vec());
    let bytes = proptest::collection::vec(any::<u8>(), 1..6);
    prop_oneof![
        (any::<Index>(), any::<u8>()).prop_map(|(at, byte)| Change::Replace(at, byte)),
        (any::<Index>(), prop_oneof![word, bytes]).prop_map(|(at, bytes)| Change::Insert(at, bytes)),
        (any::<Index>(), 1..20_u8).prop_map(|(at, count)| Change::Remove(at, count)),
        (any::<Index>(), any::<Index>()).prop_map(|(from, to)| Change::Repeat(from, to)),
        any::<Index>().prop_map(Change::Cut),
    ]
}

fn apply(bytes: &mut Vec<u8>, change: &Change) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    match change {
        Change::Replace(at, byte) => bytes[at.index(length)] = *byte,
        Change::Insert(at, inserted) => {
            let at = at.index(length);
            bytes.splice(at..at, inserted.iter().copied());
        }
        Change::Remove(at, count) => {
            let at = at.index(length);
            bytes.drain(at..(at + usize::from(*count)).min(length));
        }
        Change::Repeat(from, to) => {
            let (from, to) = (from.index(length), to.index(length));
            let part = bytes[from.min(to)..from.max(to)].to_vec();
            bytes.extend(part);
        }
        Change::Cut(at) => bytes.truncate(at.index(length)),
    }
}

fn answers(bytes: &[u8], name: &str) -> Result<(), TestCaseError> {
    match parse(bytes, name) {
        Ok(read) => {
            let count = read.mesh.positions.len() as u32;
            prop_assert!(read.mesh.faces.iter().flatten().all(|corner| *corner < count));
            prop_assert!(read.mesh.positions.iter().all(|position| position.is_finite()));
            for triangle in 0..read.mesh.faces.len() as u32 {
                let _ = read.mesh.corner_normals(triangle);
            }
        }
        Err(error) => {
            prop_assert_eq!(error.exit_code(), 2);
            let report = error.report(false);
            prop_assert!(report.len() < 1000 && !report.chars().any(|c| c.is_control() && c != '\n'), "{:?}", report);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(4000) })]

    #[test]
    fn obj(changes in proptest::collection::vec(change(), 1..6)) {
        let mut bytes = format!("vn 0 0 1\nvn 0 1 1\n{SQUARE}f -1//1 -2//2 -3//-1 \\\n1//1\n").into_bytes();
        changes.iter().for_each(|change| apply(&mut bytes, change));
        answers(&bytes, "a.obj")?;
    }

    #[test]
    fn ply(changes in proptest::collection::vec(change(), 1..6), encoding in 0..3) {
        let mut bytes = [ply::ascii, ply::little, ply::big][encoding as usize]();
        changes.iter().for_each(|change| apply(&mut bytes, change));
        answers(&bytes, "a.ply")?;
    }

    #[test]
    fn any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        answers(&bytes, "a.obj")?;
        answers(&bytes, "a.ply")?;
    }
}
