//! `Matrix`: every fault against every fixture, summed up fault by fault.

use tracer::fault::Fault;

use super::trial::{Evidence, Fate, Trial};

/// All faults that were tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    /// One for each fault.
    pub rows: Vec<Row>,
}

/// One fault, with what each fixture says of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The fault.
    pub fault: Fault,
    /// A trial for each fixture.
    pub trials: Vec<Trial>,
}

/// What becomes of a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// A fixture noticed.
    Killed,
    /// It was made, and no fixture noticed.
    Survived,
    /// No fixture needs the place where it would be made.
    NotApplied,
    /// Wherever it was made there was no picture, or the renderer broke down.
    Crashed,
}

impl Status {
    /// Its name.
    pub fn id(self) -> &'static str {
        match self {
            Self::Killed => "killed",
            Self::Survived => "survived",
            Self::NotApplied => "not_applied",
            Self::Crashed => "crashed",
        }
    }
}

impl Row {
    /// Those that failed, with why.
    pub fn kills(&self) -> impl Iterator<Item = (&str, &Evidence)> {
        self.trials.iter().filter_map(|trial| match &trial.fate {
            // One that does not need the place of the fault has not noticed it.
            Fate::Killed(evidence) if trial.reached => Some((trial.fixture.as_str(), evidence)),
            _ => None,
        })
    }

    /// How many fixtures need the place of the fault.
    pub fn reached(&self) -> usize {
        self.trials.iter().filter(|trial| trial.reached).count()
    }

    /// How many fixtures had no picture or broke the renderer down.
    pub fn without_picture(&self) -> usize {
        let is_broken = |trial: &&Trial| matches!(trial.fate, Fate::Refused(_) | Fate::Crashed(_));
        self.trials.iter().filter(is_broken).count()
    }

    /// What became of the fault.
    pub fn status(&self) -> Status {
        if self.kills().next().is_some() {
            Status::Killed
        } else if self.without_picture() > 0 {
            Status::Crashed
        } else if self.reached() > 0 {
            Status::Survived
        } else {
            Status::NotApplied
        }
    }

    /// The fixture whose picture is farthest from its golden, and the one whose
    /// is nearest: by how many pixels differ, then by how much.
    pub fn strongest_and_weakest(&self) -> Option<[(&str, &Evidence); 2]> {
        let strength = |(_, e): &(&str, &Evidence)| (e.differing_pixels, e.max_abs);
        let strongest = self.kills().max_by_key(strength)?;
        let weakest = self.kills().min_by_key(strength)?;
        Some([strongest, weakest])
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A fixture of this name that differs in so many pixels, none for a match.
    pub(in super::super) fn trial(fixture: &str, pixels: u64, on_paper: u32) -> Trial {
        let evidence = Evidence {
            golden: pixels > 0,
            on_paper,
            differing_pixels: pixels,
            ..Evidence::default()
        };
        let is_killed = pixels > 0 || on_paper > 0;
        let fate = if is_killed { Fate::Killed(evidence) } else { Fate::Survived };
        Trial { fixture: fixture.to_owned(), reached: true, fate }
    }

    #[track_caller]
    fn check(trials: Vec<Trial>, expected: Status) {
        assert_eq!(Row { fault: Fault::GammaTwice, trials }.status(), expected);
    }

    #[test]
    fn a_fault_is_killed_survives_is_not_applied_or_crashes() {
        let unreached = Trial { reached: false, ..trial("a", 0, 0) };
        let refused = Trial { fate: Fate::Refused("why".into()), ..trial("a", 0, 0) };
        check(vec![], Status::NotApplied);
        check(vec![unreached.clone(), unreached.clone()], Status::NotApplied);
        check(vec![unreached.clone(), trial("b", 0, 0)], Status::Survived);
        check(vec![trial("b", 0, 0), trial("c", 1, 0)], Status::Killed);
        check(vec![trial("b", 0, 1)], Status::Killed);
        check(vec![refused.clone(), trial("b", 0, 0)], Status::Crashed);
        check(vec![refused, trial("b", 3, 0)], Status::Killed);
        check(vec![Trial { reached: false, ..trial("b", 3, 1) }], Status::NotApplied);
    }

    #[test]
    fn evidence_is_ordered_by_pixels() {
        let trials = vec![trial("a", 5, 0), trial("b", 0, 1), trial("c", 9, 0), trial("d", 0, 0)];
        let row = Row { fault: Fault::GammaTwice, trials };
        let names = row.strongest_and_weakest().unwrap().map(|(name, _)| name);
        assert_eq!(names, ["c", "b"]);
    }
}
