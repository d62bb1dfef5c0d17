//! `Keys`: what is pressed, one key at a time.

use std::io::{ErrorKind, IsTerminal, Read};

use console::Term;

/// What a key is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Key {
    Accept,
    Reject,
    Skip,
    Back,
    Undo,
    Help,
    Quit,
    Other,
}

/// Where keys come from: the terminal, or letters in a pipe, whose end is `q`.
pub(super) enum Keys {
    Terminal(Term),
    Pipe(std::io::Stdin),
}

impl Keys {
    pub(super) fn here() -> Self {
        let stdin = std::io::stdin();
        if stdin.is_terminal() { Self::Terminal(Term::stdout()) } else { Self::Pipe(stdin) }
    }

    /// Waits for the next key.
    ///
    /// # Errors
    /// A terminal that cannot be read.
    pub(super) fn next(&mut self) -> std::io::Result<Key> {
        match self {
            Self::Terminal(term) => match term.read_key_raw() {
                Ok(key) => Ok(of_key(&key)),
                Err(error) if error.kind() == ErrorKind::Interrupted => Ok(Key::Quit),
                Err(error) => Err(error),
            },
            Self::Pipe(stdin) => {
                let mut byte = [0];
                let count = stdin.lock().read(&mut byte)?;
                Ok(if count == 0 { Key::Quit } else { of_letter(char::from(byte[0])) })
            }
        }
    }
}

fn of_key(key: &console::Key) -> Key {
    match key {
        console::Key::Char(letter) => of_letter(*letter),
        console::Key::Enter | console::Key::ArrowRight => Key::Skip,
        console::Key::ArrowLeft => Key::Back,
        console::Key::CtrlC | console::Key::Escape => Key::Quit,
        _ => Key::Other,
    }
}

fn of_letter(letter: char) -> Key {
    match letter.to_ascii_lowercase() {
        'a' => Key::Accept,
        'r' => Key::Reject,
        's' | 'n' => Key::Skip,
        'p' => Key::Back,
        'u' => Key::Undo,
        '?' | 'h' => Key::Help,
        'q' => Key::Quit,
        _ => Key::Other,
    }
}
