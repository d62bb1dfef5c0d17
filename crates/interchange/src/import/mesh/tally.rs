//! `Tally`: what was lost, the same thing only once: where first, and how often.

use std::collections::BTreeMap;

use super::words::Place;
use crate::import::Lost;

/// The most things that are listed: nobody reads more.
const MOST_LISTED: usize = 1_000;

/// What was lost so far.
#[derive(Debug, Clone, Default)]
pub(in crate::import) struct Tally {
    entries: Vec<(Lost, usize)>,
    numbers: BTreeMap<(String, String), usize>,
    unlisted: usize,
}

impl Tally {
    /// Something that the file asks for and the scene does not do; see [`Lost`].
    pub(in crate::import) fn add(
        &mut self,
        place: Option<Place>,
        element: impl Into<String>,
        what: impl Into<String>,
    ) {
        let key = (element.into(), what.into());
        if let Some(&number) = self.numbers.get(&key) {
            self.entries[number].1 += 1;
        } else if self.entries.len() < MOST_LISTED {
            let (element, what) = key.clone();
            self.numbers.insert(key, self.entries.len());
            self.entries.push((Lost { place, element, what }, 1));
        } else {
            self.unlisted += 1;
        }
    }

    /// All of it, in the order in which it was met.
    pub(in crate::import) fn into_lost(self) -> Vec<Lost> {
        let told = |(mut lost, times): (Lost, usize)| {
            if times > 1 {
                lost.what = format!("{} ({times} times)", lost.what);
            }
            lost
        };
        let mut all: Vec<_> = self.entries.into_iter().map(told).collect();
        if self.unlisted > 0 {
            let element = "further elements".to_owned();
            let what = format!("{} more losses are not listed", self.unlisted);
            all.push(Lost { place: None, element, what });
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_thing_is_told_once_and_counted() {
        let mut tally = Tally::default();
        tally.add(Some((2, 1)), "l", "lines are left out");
        tally.add(Some((3, 1)), "p", "points are left out");
        tally.add(Some((4, 1)), "l", "lines are left out");
        let lost = tally.into_lost();
        assert_eq!(lost.len(), 2);
        assert_eq!(lost[0].place, Some((2, 1)));
        assert_eq!(lost[0].what, "lines are left out (2 times)");
        assert_eq!(lost[1].what, "points are left out");
    }

    #[test]
    fn a_list_has_an_end_that_says_so() {
        let mut tally = Tally::default();
        for i in 0..=MOST_LISTED + 1 {
            tally.add(None, i.to_string(), "x");
        }
        let lost = tally.into_lost();
        assert_eq!(lost.len(), MOST_LISTED + 1);
        assert_eq!(lost[MOST_LISTED].what, "2 more losses are not listed");
    }
}
