//! `Tabs`: the pages that are open, each by the stream of events that it reads.

use std::collections::BTreeMap;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// How long after the last tab was closed it is sure that none comes back: one
/// that is loaded anew closes its stream first.
const GONE_AFTER: Duration = Duration::from_secs(2);

/// How long a page may take from being sent to being shown and opening its
/// stream.
const SHOWN_WITHIN: Duration = Duration::from_secs(10);

/// Which tabs there are.
#[derive(Debug, Default)]
pub struct Tabs(Mutex<Open>);

#[derive(Debug, Default)]
struct Open {
    streams: BTreeMap<u64, Sender<Arc<str>>>,
    next: u64,
    /// From when on a place without tabs is left; `None` before there were any.
    left_from: Option<Instant>,
}

/// A tab, for as long as its stream is open.
pub(super) struct Tab<'a> {
    tabs: &'a Tabs,
    number: u64,
    /// What is to be sent to it.
    pub(super) events: Receiver<Arc<str>>,
}

impl Tabs {
    /// Whether there were tabs, and all of them are closed for good.
    pub fn have_left(&self) -> bool {
        let open = self.lock();
        open.streams.is_empty() && open.left_from.is_some_and(|from| Instant::now() >= from)
    }

    /// A tab has opened its stream.
    pub(super) fn open(&self) -> Tab<'_> {
        let (sender, events) = channel();
        let mut open = self.lock();
        open.next += 1;
        let number = open.next;
        open.streams.insert(number, sender);
        // The one that was expected.
        open.left_from = None;
        Tab { tabs: self, number, events }
    }

    /// A page was sent, and its tab is to be expected.
    pub(super) fn expect(&self) {
        self.lock().left_from = Some(Instant::now() + SHOWN_WITHIN);
    }

    /// Sends this to every tab.
    pub(super) fn tell(&self, event: &str) {
        let event: Arc<str> = event.into();
        for stream in self.lock().streams.values() {
            // A tab that is being closed hears nothing more.
            let _ = stream.send(Arc::clone(&event));
        }
    }

    /// Nothing here is half-done while it is locked.
    fn lock(&self) -> MutexGuard<'_, Open> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Tab<'_> {
    fn drop(&mut self) {
        let mut open = self.tabs.lock();
        open.streams.remove(&self.number);
        let gone = Instant::now() + GONE_AFTER;
        // A page that was sent in between is still to be expected.
        open.left_from = Some(open.left_from.map_or(gone, |from| from.max(gone)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How long a place is not left yet, in seconds; `None` if tabs are open or
    /// never were.
    fn seconds(tabs: &Tabs) -> Option<u64> {
        let open = tabs.lock();
        let from = open.left_from.filter(|_| open.streams.is_empty())?;
        Some(from.saturating_duration_since(Instant::now()).as_secs_f64().round() as u64)
    }

    #[test]
    fn a_place_is_left_a_while_after_its_last_tab() {
        let tabs = Tabs::default();
        assert!(seconds(&tabs).is_none() && !tabs.have_left(), "nobody was here");
        tabs.expect();
        assert_eq!(seconds(&tabs), Some(SHOWN_WITHIN.as_secs()));
        let (a, b) = (tabs.open(), tabs.open());
        drop(a);
        assert_eq!(seconds(&tabs), None);
        tabs.tell("x");
        assert_eq!(b.events.try_iter().map(|e| e.to_string()).collect::<Vec<_>>(), ["x"]);
        drop(b);
        assert_eq!(seconds(&tabs), Some(GONE_AFTER.as_secs()));
        // Loaded anew.
        tabs.expect();
        let again = tabs.open();
        assert_eq!(seconds(&tabs), None);
        tabs.expect();
        drop(again);
        assert_eq!(seconds(&tabs), Some(SHOWN_WITHIN.as_secs()), "another one is on its way");
        assert!(!tabs.have_left());
    }
}
