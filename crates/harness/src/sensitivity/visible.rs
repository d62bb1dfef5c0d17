//! `Visible`: from which strength on people see a defect, and the search for one
//! that they see and a fixture's limits do not.

use rayon::prelude::*;

use super::{DEFECTS, Defect, Place};
use crate::encode::EncodedImage;
use crate::judge::is_caught;
use crate::limits::Limits;
use crate::metric::{Pair, difference};

/// What people see: each defect from a strength of its own on, where it changes
/// some code by enough.
#[derive(Debug, Clone, PartialEq)]
pub struct Visible {
    /// One for each of [`DEFECTS`].
    strengths: Vec<f64>,
    /// The largest difference of the picture from its golden, in codes, below
    /// which nothing is seen whatever was done.
    change: u8,
}

impl Default for Visible {
    fn default() -> Self {
        /// A step of 1 code between areas is at the edge of what is seen, and
        /// most defects are not between areas.
        const CHANGE: u8 = 4;
        Self { strengths: DEFECTS.iter().map(|defect| defect.visible).collect(), change: CHANGE }
    }
}

/// The name of the least change in flags.
const CHANGE: &str = "change";

impl Visible {
    /// From this strength on the defect is seen.
    pub fn strength(&self, defect: &Defect) -> f64 {
        let known = DEFECTS.iter().position(|other| other.name == defect.name);
        known.map_or(defect.visible, |i| self.strengths[i])
    }

    /// The largest difference of a picture, in codes, from which on it is seen.
    pub fn change(&self) -> u8 {
        self.change
    }

    /// What the texts say, such as `gain=1` or `change=8`; of two about the same
    /// the last.
    ///
    /// # Errors
    /// What was expected in place of one of them, for people.
    pub fn from_texts(texts: &[String]) -> Result<Self, String> {
        let mut visible = Self::default();
        for text in texts {
            visible.set(text)?;
        }
        Ok(visible)
    }

    fn set(&mut self, text: &str) -> Result<(), String> {
        let (name, number) = text.split_once('=').unwrap_or((text, ""));
        if name == CHANGE {
            self.change = number.parse().ok().filter(|change| *change > 0).ok_or_else(|| {
                format!("expected {CHANGE}= and a number from 1 to 255, found \"{text}\"")
            })?;
            return Ok(());
        }
        let Some(i) = DEFECTS.iter().position(|defect| defect.name == name) else {
            let names: Vec<_> = DEFECTS.iter().map(|defect| defect.name).collect();
            let names = names.join(", ");
            return Err(format!("expected {names} or {CHANGE}, then =, found \"{text}\""));
        };
        let most = DEFECTS[i].strengths.most;
        let strength = number.parse().ok().filter(|s| 0.0 < *s && *s <= most);
        self.strengths[i] = strength.ok_or_else(|| {
            format!("expected {name}= and a number above 0, at most {most}, found \"{text}\"")
        })?;
        Ok(())
    }
}

/// A defect that people see and limits let pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Miss {
    /// Its strength.
    pub strength: f64,
    /// Where it is.
    pub place: Place,
    /// The largest difference that it makes, in codes.
    pub change: u8,
}

/// Times the strength that is seen: what is tried, and the strongest there is.
const TIMES: [f64; 3] = [1.0, 2.0, 4.0];

/// The weakest defect of this kind that is seen and not caught; `None` where
/// all that were tried are caught.
pub fn missed(
    defect: &Defect,
    limits: Option<&Limits>,
    golden: &EncodedImage,
    visible: &Visible,
) -> Option<Miss> {
    // Held to be identical: whatever changes a byte is caught.
    limits?;
    let places = (defect.places)(golden);
    let seen = visible.strength(defect);
    let most = defect.strengths.most;
    let weaker = TIMES.map(|times| times * seen);
    let tried = weaker.into_iter().filter(|strength| *strength < most).chain([most]);
    let at = |strength: f64, place: Place| {
        let damaged = (defect.inject)(golden, place, strength);
        let change = difference(&Pair::new(golden, &damaged)?).max_abs;
        let is_missed = visible.change <= change && !is_caught(limits, golden, &damaged);
        is_missed.then_some(Miss { strength, place, change })
    };
    tried
        .map(|strength| if defect.strengths.whole { strength.ceil() } else { strength })
        .find_map(|s| places.par_iter().find_map_first(|&place| at(s, place)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: Result<(), &str>) {
        match (Visible::default().set(text), expected) {
            (Ok(()), Ok(())) => {}
            (Err(found), Err(part)) => assert!(found.contains(part), "{found}"),
            (found, _) => assert_eq!(found, Ok(()), "{text}"),
        }
    }

    #[test]
    fn flags_are_understood_or_refused() {
        for text in ["", "gain", "gain=", "gain=0", "gain=-1", "gain=nan", "gain=101", "gain=1%"] {
            check(text, Err(&format!("found \"{text}\"")));
        }
        check("gian=1", Err("expected blob-1, blob-2,"));
        for text in ["change=0", "change=256", "change=1.5"] {
            check(text, Err("from 1 to 255"));
        }
        check("gain=1", Ok(()));
        check("blob-2=8", Ok(()));
        check("change=1", Ok(()));
    }

    #[test]
    fn the_last_of_two_holds() {
        let texts = ["gain=1", "change=9", "gain=3.5"].map(str::to_owned);
        let visible = Visible::from_texts(&texts).unwrap();
        let gain = DEFECTS.iter().find(|defect| defect.name == "gain").unwrap();
        assert_eq!((visible.strength(gain), visible.change), (3.5, 9));
    }
}
