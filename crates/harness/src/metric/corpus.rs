//! A corpus: pairs of pictures with one kind of damage each, and how every metric rates it.
//!
//! The pictures are drawn by formulas, so that anyone can ask another program
//! about them. Each case states the ratings it must get; a test holds them.

mod blind_spots;
mod cases;
mod document;
mod files;
mod patterns;
mod rating;
#[cfg(test)]
mod tests;

use super::{METRICS, compare};
use crate::encode::EncodedImage;

pub use document::document;
pub use rating::{Rating, SCALES, Scale};

/// Two pictures and what metrics make of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What is done to the golden.
    pub name: &'static str,
    /// The accepted picture, or why it is none.
    pub golden: Result<EncodedImage, String>,
    /// The damaged one, or why it is none.
    pub actual: Result<EncodedImage, String>,
    /// What [`Case::outcome`] must say.
    pub expected: &'static str,
}

impl Case {
    /// The rating of every metric, in the order of [`METRICS`].
    ///
    /// # Errors
    /// Why there is no comparison: one of the two is no picture, they have no
    /// pixel, or their sizes differ.
    pub fn ratings(&self) -> Result<Vec<Rating>, String> {
        let (golden, actual) = (self.golden.as_ref()?, self.actual.as_ref()?);
        if golden.size() != actual.size() {
            return Err("sizes differ".to_owned());
        }
        let comparison = compare(golden, actual).ok_or("there is no pixel")?;
        let scales = METRICS.iter().zip(SCALES);
        Ok(scales.map(|(metric, scale)| scale.rate(metric, &comparison)).collect())
    }

    /// The ratings in words, with a space between; or why there are none.
    pub fn outcome(&self) -> String {
        let words =
            |ratings: Vec<Rating>| ratings.into_iter().map(Rating::word).collect::<Vec<_>>();
        self.ratings().map_or_else(|why| why, |ratings| words(ratings).join(" "))
    }
}

/// Every case: identical pictures first, pairs that are not compared last.
pub fn corpus() -> Vec<Case> {
    cases::cases()
}
