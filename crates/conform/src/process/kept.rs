//! `Listener`: hears all that a program prints, and keeps its beginning and end.

use std::collections::VecDeque;
use std::io::Read;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// How much is kept of the beginning, and how much of the end, in bytes.
const KEPT: usize = 4_096;

/// What a program printed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Heard {
    first: Vec<u8>,
    last: VecDeque<u8>,
    bytes: u64,
}

impl Heard {
    fn add(&mut self, more: &[u8]) {
        self.bytes += more.len() as u64;
        let (first, rest) = more.split_at(more.len().min(KEPT - self.first.len()));
        self.first.extend(first);
        self.last.extend(&rest[rest.len().saturating_sub(KEPT)..]);
        self.last.drain(..self.last.len().saturating_sub(KEPT));
    }

    /// How much it was, in bytes.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// As text, with a line in place of what was not kept.
    pub fn text(&self) -> String {
        let last: Vec<u8> = self.last.iter().copied().collect();
        let left_out = self.bytes - (self.first.len() + last.len()) as u64;
        if left_out == 0 {
            return String::from_utf8_lossy(&[&self.first[..], &last].concat()).into_owned();
        }
        let [first, last] = [&self.first, &last].map(|part| String::from_utf8_lossy(part));
        format!("{first}\n[{left_out} bytes are left out here]\n{last}")
    }
}

/// Hears a program, from a thread of its own.
#[derive(Debug)]
pub struct Listener {
    heard: Arc<Mutex<Heard>>,
    /// Ends when there is nothing more to hear.
    end: Receiver<()>,
}

impl Listener {
    /// Listens to this, if there is anything.
    pub fn to(source: Option<impl Read + Send + 'static>) -> Self {
        let heard = Arc::new(Mutex::new(Heard::default()));
        let (sender, end) = channel();
        let ear = heard.clone();
        std::thread::spawn(move || {
            let _open = sender;
            let Some(mut source) = source else { return };
            let mut part = vec![0; 1 << 16];
            loop {
                match source.read(&mut part) {
                    Ok(0) => return,
                    Ok(count) => {
                        let mut heard = ear.lock().unwrap_or_else(PoisonError::into_inner);
                        heard.add(&part[..count]);
                    }
                    Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                    Err(_) => return,
                }
            }
        });
        Self { heard, end }
    }

    /// What was heard of a program that has ended. Whoever got its output from it
    /// and has escaped is not waited for.
    pub fn heard(self) -> Heard {
        /// How long what was printed may take to come here.
        const LATE: Duration = Duration::from_millis(500);
        // An error says that the thread has ended, or that it takes too long.
        let _: Result<(), RecvTimeoutError> = self.end.recv_timeout(LATE);
        self.heard.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(parts: &[&[u8]], expected: &str) {
        let mut heard = Heard::default();
        for part in parts {
            heard.add(part);
        }
        assert_eq!(heard.text(), expected);
    }

    #[test]
    fn the_beginning_and_the_end_are_kept() {
        check(&[], "");
        check(&[b"a", b"", b"bc"], "abc");
        check(&[b"\xff"], "\u{fffd}");
        let [a, b, c] = [b'a', b'b', b'c'].map(|byte| vec![byte; KEPT]);
        let [texta, textb, textc] = [&a, &b, &c].map(|v| String::from_utf8(v.clone()).unwrap());
        check(&[&a, &b], &format!("{texta}{textb}"));
        check(&[&[&a[..], &b].concat()], &format!("{texta}{textb}"));
        let long = format!("{texta}\n[{KEPT} bytes are left out here]\n{textc}");
        check(&[&a, &b, &c], &long);
        check(&[&[&a[..], &b, &c].concat()], &long);
        let mut bytes = Heard::default();
        bytes.add(&a);
        bytes.add(&b);
        bytes.add(b"x");
        assert_eq!(bytes.bytes(), 2 * KEPT as u64 + 1);
        assert!(bytes.text().contains("[1 bytes are left out here]"));
    }
}
