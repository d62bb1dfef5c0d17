//! `Keys`: what is pressed, one key at a time.

use std::io::{ErrorKind, IsTerminal, Read};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

use console::Term;

use crate::interrupt::Interrupt;

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

/// The keys that are pressed, waited for beside anything that ends the program.
pub(super) struct Keys {
    interrupt: Interrupt,
    ask: Sender<()>,
    pressed: Receiver<std::io::Result<Key>>,
    usual: Usual,
}

impl Keys {
    pub(super) fn here(interrupt: Interrupt) -> Self {
        let usual = Usual::here();
        let (ask, asked) = channel();
        let (press, pressed) = channel();
        // One key is read for each that is asked for: between them, the terminal is
        // as it was.
        thread::spawn(move || {
            let mut source = Source::here();
            asked.iter().try_for_each(|()| press.send(source.next()))
        });
        Self { interrupt, ask, pressed, usual }
    }

    /// Waits for the next key, or until it is time to end, which is as `q`.
    ///
    /// # Errors
    /// A terminal that cannot be read.
    pub(super) fn next(&mut self) -> std::io::Result<Key> {
        /// How often it is looked whether it is time to end.
        const LOOK_EVERY: Duration = Duration::from_millis(50);
        if self.interrupt.is_set() || self.ask.send(()).is_err() {
            return Ok(Key::Quit);
        }
        loop {
            match self.pressed.recv_timeout(LOOK_EVERY) {
                Ok(key) => return key,
                Err(RecvTimeoutError::Timeout) if !self.interrupt.is_set() => {}
                Err(_) => {
                    // A key is still waited for, in a way that others cannot use.
                    self.usual.restore();
                    return Ok(Key::Quit);
                }
            }
        }
    }
}

/// How the terminal was before a key was waited for.
struct Usual {
    #[cfg(unix)]
    settings: Option<nix::sys::termios::Termios>,
}

impl Usual {
    #[cfg(unix)]
    fn here() -> Self {
        Self { settings: nix::sys::termios::tcgetattr(std::io::stdin()).ok() }
    }

    #[cfg(unix)]
    fn restore(&self) {
        use nix::sys::termios::{SetArg, tcsetattr};
        if let Some(settings) = &self.settings {
            // A terminal that is gone needs none.
            let _ = tcsetattr(std::io::stdin(), SetArg::TCSADRAIN, settings);
        }
    }

    #[cfg(not(unix))]
    fn here() -> Self {
        Self {}
    }

    #[cfg(not(unix))]
    fn restore(&self) {}
}

/// Where keys come from: the terminal, or letters in a pipe, whose end is `q`.
enum Source {
    Terminal(Term),
    Pipe(std::io::Stdin),
}

impl Source {
    fn here() -> Self {
        let stdin = std::io::stdin();
        if stdin.is_terminal() { Self::Terminal(Term::stdout()) } else { Self::Pipe(stdin) }
    }

    fn next(&mut self) -> std::io::Result<Key> {
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
