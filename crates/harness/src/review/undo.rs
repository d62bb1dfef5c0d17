//! Taking decisions back.

use super::{Accepted, Decision, Review};
use crate::hash::content_hash;
use crate::store;

impl Review {
    /// Takes decisions back: of an acceptance, the golden that there was comes
    /// back, if the one that was accepted is still there. What was not taken
    /// back and why, a sentence each.
    pub fn undo(&mut self, names: &[String]) -> Vec<String> {
        let undo = |name: &String| {
            let why = self.take_back(name).err()?;
            Some(format!("{name} is not taken back: {why}"))
        };
        names.iter().filter_map(undo).collect()
    }

    /// Whether there is something to take back for this name.
    pub fn can_undo(&self, name: &str) -> bool {
        self.decided.contains_key(name) || self.accepted.contains_key(name)
    }

    /// Takes the last decision about this name back. A rejection of another
    /// picture than the one that was accepted before leaves that acceptance.
    pub(super) fn take_back(&mut self, name: &str) -> Result<(), String> {
        if self.decision(name) != Some(Decision::Rejected) {
            self.restore(name)?;
        }
        self.decided.remove(name);
        Ok(())
    }

    /// Gives the golden of this name the bytes from before it was accepted.
    fn restore(&mut self, name: &str) -> Result<(), String> {
        let neither = || "it was neither accepted nor rejected".to_owned();
        let Accepted { before, after } = self.accepted.get(name).ok_or_else(neither)?;
        if !self.is_as_accepted(name)? {
            let why = "its golden is no longer what was accepted, and stays as it is; \
                       review it again";
            return Err(why.to_owned());
        }
        let path = self.suite.golden_path(name);
        let back = match before {
            None => store::remove(&path),
            Some(bytes) if after.is_none() => store::write_new(&path, bytes),
            Some(bytes) => store::write(&path, bytes),
        };
        back.map_err(|error| error.to_string())?;
        // What was accepted in an earlier review was judged by that golden in this
        // one: what follows from the one before is for the next one to say.
        let hash = before.as_ref().map(content_hash);
        if self.steps.get(name).is_some_and(|step| step.before == hash) {
            self.written.insert(name.to_owned(), hash);
        } else {
            self.written.remove(name);
        }
        self.accepted.remove(name);
        Ok(())
    }
}
