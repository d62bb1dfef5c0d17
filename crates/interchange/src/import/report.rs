//! `Report`: what an importer meets on its way: problems, losses and choices.
//!
//! Nothing is dropped in silence: what is beyond the limit of a list is counted
//! in its last entry.

use std::collections::BTreeMap;

use scene::{SceneFile, Unchecked};

use super::{Imported, Lost, Unreadable};

/// Line and column, both from 1.
pub(super) type Place = (usize, usize);

/// The most entries of a list: nobody reads more.
const MOST_LISTED: usize = 1_000;

/// What was met so far.
#[derive(Debug, Default)]
pub(super) struct Report {
    lost: Vec<Lost>,
    unreadable: Vec<Unreadable>,
    chosen: Vec<String>,
    lost_in_all: usize,
    unreadable_in_all: usize,
}

impl Report {
    /// Something that the file asks for and the scene does not do. Its place is
    /// only looked for where it is listed.
    pub(super) fn lost(
        &mut self,
        place: impl FnOnce() -> Place,
        element: &str,
        what: impl Into<String>,
    ) {
        self.lost_in_all += 1;
        if self.lost.len() < MOST_LISTED {
            let (element, what) = (element.to_owned(), what.into());
            self.lost.push(Lost { place: Some(place()), element, what });
        }
    }

    /// A reason why there is no scene.
    pub(super) fn unreadable(
        &mut self,
        place: impl FnOnce() -> Place,
        message: impl Into<String>,
        help: Option<&str>,
    ) {
        self.unreadable_in_all += 1;
        if self.unreadable.len() < MOST_LISTED {
            let (message, help) = (message.into(), help.map(str::to_owned));
            self.unreadable.push(Unreadable { place: Some(place()), message, help });
        }
    }

    /// Something that the whole file lacks.
    pub(super) fn missing(&mut self, message: impl Into<String>, help: &str) {
        self.unreadable_in_all += 1;
        let (message, help) = (message.into(), Some(help.to_owned()));
        self.unreadable.push(Unreadable { place: None, message, help });
    }

    /// A choice, said once however often it was made.
    pub(super) fn chose(&mut self, what: impl Into<String>) {
        let what = what.into();
        if !self.chosen.contains(&what) && self.chosen.len() < MOST_LISTED {
            self.chosen.push(what);
        }
    }

    /// The scene, if nothing stands against it.
    ///
    /// # Errors
    /// Every problem, by place.
    pub(super) fn finish(
        mut self,
        scene: SceneFile<Unchecked>,
        files: BTreeMap<String, Vec<u8>>,
    ) -> Result<Imported, Vec<Unreadable>> {
        if self.unreadable.is_empty() {
            let more = self.lost_in_all - self.lost.len();
            if more > 0 {
                let what = format!("{more} further losses are not listed");
                self.lost.push(Lost { place: None, element: "...".to_owned(), what });
            }
            return Ok(Imported { scene, files, lost: self.lost, chosen: self.chosen });
        }
        self.unreadable.sort_by_key(|problem| problem.place);
        let more = self.unreadable_in_all - self.unreadable.len();
        if more > 0 {
            let message = format!("{more} further problems are not listed");
            self.unreadable.push(Unreadable { place: None, message, help: None });
        }
        Err(self.unreadable)
    }
}
