//! `Interrupt`: that somebody wants this program to end, so that it ends well.

use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::Duration;

use harness::store;

use crate::CannotAsk;

/// Known to all that wait; set by Ctrl-C, and by a terminal that is closed.
#[derive(Debug, Clone, Default)]
pub struct Interrupt(Arc<(Mutex<bool>, Condvar)>);

impl Interrupt {
    /// From now on, the first Ctrl-C is told here, and the second one ends the
    /// program, with no file half-written.
    ///
    /// # Errors
    /// The system does not tell of it.
    pub fn listen() -> Result<Self, CannotAsk> {
        let interrupt = Self::default();
        let heard = interrupt.clone();
        ctrlc::set_handler(move || {
            if heard.is_set() {
                end_at_once(CODE);
            }
            *heard.0.0.lock().unwrap_or_else(PoisonError::into_inner) = true;
            heard.0.1.notify_all();
        })?;
        Ok(interrupt)
    }

    /// Waits so long, or until it is time to end; whether it is.
    pub fn wait(&self, time: Duration) -> bool {
        let (is_set, changed) = &*self.0;
        let guard = is_set.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = changed.wait_timeout_while(guard, time, |is_set| !*is_set);
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }

    /// Whether it is time to end.
    pub fn is_set(&self) -> bool {
        self.wait(Duration::ZERO)
    }
}

/// What shells call ended by Ctrl-C.
const CODE: i32 = 130;

/// Ends the program with this code, with no file half-written.
pub fn end_at_once(code: i32) -> ! {
    let _nothing = store::nothing_half_written();
    std::process::exit(code)
}
