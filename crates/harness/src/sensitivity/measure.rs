//! The search for the smallest strength of a defect that is caught.

use rayon::prelude::*;

use super::visible::{Miss, Visible, missed};
use super::{DEFECTS, Defect, Place, Strengths};
use crate::case::Case;
use crate::encode::EncodedImage;
use crate::judge::is_caught;
use crate::limits::Limits;

/// What a fixture's limits make of every defect.
#[derive(Debug, Clone)]
pub struct Row {
    /// The fixture's name.
    pub fixture: String,
    /// One for each of [`DEFECTS`].
    pub cells: Vec<Cell>,
}

/// What a fixture's limits make of one defect.
#[derive(Debug, Clone)]
pub struct Cell {
    /// The defect.
    pub defect: &'static Defect,
    /// The smallest of it that is caught.
    pub smallest: Smallest,
    /// The strength that is smallest over the one that people see: above 1,
    /// something may be seen that is not caught. Infinite where it is never
    /// caught; `None` where it has no effect.
    pub times_visible: Option<f64>,
    /// One that people see and that is not caught.
    pub missed: Option<Miss>,
}

/// The smallest strength that is caught, wherever the defect is.
///
/// Damage need not grow with the strength: a stripe moved by its period is
/// itself again. So this is the strength from which on all that were tried are
/// caught, at every place that was tried where they change anything.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Smallest {
    /// No strength changes the picture, as where one of a single color is
    /// blurred.
    NoEffect,
    /// It is caught from this strength on.
    Caught {
        /// The strength, in the defect's unit.
        strength: f64,
        /// Where it is caught last.
        place: Place,
    },
    /// The strongest is not caught.
    Never {
        /// Where it is not.
        place: Place,
    },
}

/// Measures every case; `on_each` hears of each as it is done, from any thread.
pub fn of_cases(cases: &[Case], visible: &Visible, on_each: &(dyn Fn(&str) + Sync)) -> Vec<Row> {
    let row = |case: &Case| {
        let limits = case.fixture.check.limits.as_ref();
        let cell = |defect| cell(defect, limits, &case.golden.picture, visible);
        let row = Row { fixture: case.name.clone(), cells: DEFECTS.iter().map(cell).collect() };
        on_each(&case.name);
        row
    };
    cases.par_iter().map(row).collect()
}

fn cell(
    defect: &'static Defect,
    limits: Option<&Limits>,
    golden: &EncodedImage,
    visible: &Visible,
) -> Cell {
    let smallest = Search { defect, limits, golden, places: (defect.places)(golden) }.smallest();
    let times_visible = match smallest {
        Smallest::NoEffect => None,
        Smallest::Caught { strength, .. } => Some(strength / visible.strength(defect)),
        Smallest::Never { .. } => Some(f64::INFINITY),
    };
    Cell { defect, smallest, times_visible, missed: missed(defect, limits, golden, visible) }
}

/// From one strength that is tried to the next: half an octave.
const STEP: f64 = std::f64::consts::SQRT_2;

/// How often the step to the smallest strength is halved, where not only whole
/// numbers count: down to 4.4 %.
const HALVINGS: u32 = 3;

impl Strengths {
    /// Those that are tried first, from the least to the most.
    fn steps(&self) -> Vec<f64> {
        let rounded = |strength: f64| if self.whole { strength.round() } else { strength };
        let all = std::iter::successors(Some(self.least), |strength| Some(strength * STEP));
        let mut steps: Vec<_> = all.take_while(|s| *s < self.most).map(rounded).collect();
        steps.push(self.most);
        steps.dedup();
        steps
    }

    /// One between the two; `None` where they are close enough. Geometric, as
    /// the steps are, where not only whole numbers count.
    fn between(&self, low: f64, high: f64, halvings: u32) -> Option<f64> {
        if self.whole {
            Some(f64::midpoint(low, high).floor()).filter(|middle| low < *middle)
        } else {
            (halvings < HALVINGS).then(|| (low * high).sqrt())
        }
    }
}

/// One defect in one golden.
struct Search<'a> {
    defect: &'a Defect,
    limits: Option<&'a Limits>,
    golden: &'a EncodedImage,
    places: Vec<Place>,
}

/// What comes of one strength.
#[derive(Clone, Copy)]
enum Answer {
    NoEffect,
    /// It is, everywhere; here first.
    Caught(Place),
    /// It is not, here first.
    Missed(Place),
}

impl Search<'_> {
    /// From the strongest down to the first that is missed, then between that
    /// and the one before.
    fn smallest(&self) -> Smallest {
        let steps = self.defect.strengths.steps();
        if self.limits.is_none() {
            return self.smallest_effect(&steps);
        }
        let (mut smallest, mut below) = (Smallest::NoEffect, None);
        for strength in steps.into_iter().rev() {
            match (self.ask(strength), smallest) {
                (Answer::Caught(place), _) => {
                    (smallest, below) = (Smallest::Caught { strength, place }, None);
                }
                (Answer::Missed(place), Smallest::NoEffect) => return Smallest::Never { place },
                (Answer::Missed(place), Smallest::Caught { strength: high, .. }) => {
                    smallest = Smallest::Caught { strength: high, place };
                    below = below.or(Some(strength));
                    break;
                }
                (Answer::NoEffect, _) => below = below.or(Some(strength)),
                (Answer::Missed(_), Smallest::Never { .. }) => break,
            }
        }
        match (smallest, below) {
            (Smallest::Caught { strength, place }, Some(low)) => self.closer(low, strength, place),
            (smallest, _) => smallest,
        }
    }

    /// The same where whatever changes a byte is caught: then it is the weakest
    /// that has an effect, which is sooner found from below.
    fn smallest_effect(&self, steps: &[f64]) -> Smallest {
        let mut low = None;
        for &strength in steps {
            match (self.ask(strength), low) {
                (Answer::Caught(place) | Answer::Missed(place), None) => {
                    return Smallest::Caught { strength, place };
                }
                (Answer::Caught(place) | Answer::Missed(place), Some(low)) => {
                    return self.closer(low, strength, place);
                }
                (Answer::NoEffect, _) => low = Some(strength),
            }
        }
        Smallest::NoEffect
    }

    /// The smallest between a strength that is not caught and one that is.
    fn closer(&self, mut low: f64, mut strength: f64, mut place: Place) -> Smallest {
        for halvings in 0.. {
            let Some(middle) = self.defect.strengths.between(low, strength, halvings) else {
                break;
            };
            match self.ask(middle) {
                Answer::Caught(_) => strength = middle,
                Answer::Missed(missed) => (low, place) = (middle, missed),
                Answer::NoEffect => low = middle,
            }
        }
        Smallest::Caught { strength, place }
    }

    fn ask(&self, strength: f64) -> Answer {
        let at = |&place: &Place| {
            let damaged = (self.defect.inject)(self.golden, place, strength);
            if damaged == *self.golden {
                Answer::NoEffect
            } else if is_caught(self.limits, self.golden, &damaged) {
                Answer::Caught(place)
            } else {
                Answer::Missed(place)
            }
        };
        let answers: Vec<_> = self.places.par_iter().map(at).collect();
        let first = |is: fn(&Answer) -> bool| answers.iter().copied().find(is);
        first(|answer| matches!(answer, Answer::Missed(_)))
            .or_else(|| first(|answer| matches!(answer, Answer::Caught(_))))
            .unwrap_or(Answer::NoEffect)
    }
}

#[cfg(test)]
mod tests;
