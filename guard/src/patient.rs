//! Input and output that go on where a signal has interrupted them.

use std::io::{self, ErrorKind, Read, Write};

/// Does something again as long as a signal interrupts it.
///
/// # Errors
/// Any other of `work`.
pub fn retried<T>(mut work: impl FnMut() -> io::Result<T>) -> io::Result<T> {
    loop {
        match work() {
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            done => return done,
        }
    }
}

/// A file or the like whose `read`, `write` and `flush` are never interrupted. What packs and unpacks bytes doesn't always try again by itself.
#[derive(Debug)]
pub struct Patient<W>(pub W);

impl<W: Write> Write for Patient<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        retried(|| self.0.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        retried(|| self.0.flush())
    }
}

impl<R: Read> Read for Patient<R> {
    fn read(&mut self, place: &mut [u8]) -> io::Result<usize> {
        retried(|| self.0.read(place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Is interrupted at every other call, and takes a few bytes at a time.
    #[derive(Default)]
    struct Restless {
        calls: usize,
        taken: Vec<u8>,
    }

    impl Restless {
        fn call(&mut self) -> io::Result<()> {
            self.calls += 1;
            if self.calls % 2 == 1 { Err(ErrorKind::Interrupted.into()) } else { Ok(()) }
        }
    }

    impl Write for Restless {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.call()?;
            let count = bytes.len().min(7);
            self.taken.extend_from_slice(&bytes[..count]);
            Ok(count)
        }

        fn flush(&mut self) -> io::Result<()> {
            self.call()
        }
    }

    impl Read for Restless {
        fn read(&mut self, place: &mut [u8]) -> io::Result<usize> {
            self.call()?;
            place[0] = self.calls as u8;
            Ok(1)
        }
    }

    #[test]
    fn what_is_interrupted_goes_on() {
        let mut patient = Patient(Restless::default());
        let text: Vec<u8> = (0..=255).collect();
        // Each write is one call of `write`, as packing does it.
        let mut left = &text[..];
        while !left.is_empty() {
            left = &left[patient.write(left).expect("it is tried again")..];
        }
        patient.flush().expect("it is tried again");
        assert!(patient.0.taken == text);
        let mut place = [0];
        for _ in 0..10 {
            assert_eq!(patient.read(&mut place).expect("it is tried again"), 1);
        }
        assert!(retried(|| Err::<(), _>(io::Error::from(ErrorKind::StorageFull))).is_err());
    }
}
