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
    /// How many pages are being sent.
    sending: usize,
    /// Whether there ever was a tab: a page that was only fetched has nobody before
    /// it.
    had_tabs: bool,
    /// From when on a place without tabs is left.
    left_from: Option<Instant>,
}

impl Open {
    /// Whether there were tabs, and none is open or on its way.
    fn is_empty(&self) -> bool {
        self.had_tabs && self.streams.is_empty() && self.sending == 0
    }

    /// Is not left for at least so long.
    fn stay(&mut self, time: Duration) {
        let until = Instant::now() + time;
        self.left_from = Some(self.left_from.map_or(until, |from| from.max(until)));
    }
}

/// A page, for as long as it is being sent.
pub(super) struct Sending<'a>(&'a Tabs);

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
        open.is_empty() && open.left_from.is_none_or(|from| Instant::now() >= from)
    }

    /// A tab has opened its stream.
    pub(super) fn open(&self) -> Tab<'_> {
        let (sender, events) = channel();
        let mut open = self.lock();
        open.next += 1;
        let number = open.next;
        open.streams.insert(number, sender);
        // Another one may still be expected.
        open.had_tabs = true;
        Tab { tabs: self, number, events }
    }

    /// A page is being sent, and its tab is to be expected after that.
    pub(super) fn send(&self) -> Sending<'_> {
        self.lock().sending += 1;
        Sending(self)
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

impl Drop for Sending<'_> {
    fn drop(&mut self) {
        let mut open = self.0.lock();
        open.sending -= 1;
        open.stay(SHOWN_WITHIN);
    }
}

impl Drop for Tab<'_> {
    fn drop(&mut self) {
        let mut open = self.tabs.lock();
        open.streams.remove(&self.number);
        open.stay(GONE_AFTER);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How long a place is not left yet, in seconds; `None` if tabs are open or
    /// never were.
    fn seconds(tabs: &Tabs) -> Option<u64> {
        let open = tabs.lock();
        let from = open.left_from.filter(|_| open.is_empty())?;
        Some(from.saturating_duration_since(Instant::now()).as_secs_f64().round() as u64)
    }

    #[test]
    fn a_place_is_left_a_while_after_its_last_tab() {
        let tabs = Tabs::default();
        assert!(seconds(&tabs).is_none() && !tabs.have_left(), "nobody was here");
        let (a, b) = (tabs.open(), tabs.open());
        drop(a);
        assert_eq!(seconds(&tabs), None);
        tabs.tell("x");
        assert_eq!(b.events.try_iter().map(|e| e.to_string()).collect::<Vec<_>>(), ["x"]);
        drop(b);
        assert_eq!(seconds(&tabs), Some(GONE_AFTER.as_secs()));
        // Loaded anew.
        let sending = tabs.send();
        assert_eq!(seconds(&tabs), None, "it is on its way");
        drop(sending);
        assert_eq!(seconds(&tabs), Some(SHOWN_WITHIN.as_secs()));
        let again = tabs.open();
        assert_eq!(seconds(&tabs), None);
        drop(tabs.send());
        drop(again);
        assert_eq!(seconds(&tabs), Some(SHOWN_WITHIN.as_secs()), "another one is on its way");
        assert!(!tabs.have_left());
    }

    #[test]
    fn a_page_that_was_only_fetched_has_nobody_before_it() {
        let tabs = Tabs::default();
        drop(tabs.send());
        assert!(seconds(&tabs).is_none() && !tabs.have_left());
        drop(tabs.open());
        assert_eq!(seconds(&tabs), Some(SHOWN_WITHIN.as_secs()), "that one, or another");
    }
}
