//! `Ratio`: how many times brighter one pixel is than another.

use serde::{Deserialize, Serialize};

use super::{At, Expect, Rendered, few_roundings, is_close, tolerance_problem};

/// In every channel that is not black in both, the linear pixel at `of` is
/// `is` times the one at `to`: an inverse square, a cosine, a pair that must be
/// alike (`is: 1`).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ratio {
    /// The pixel compared.
    pub of: At,
    /// The pixel it is compared to.
    pub to: At,
    /// How many times brighter.
    pub is: f64,
    /// How far the ratio may be off, relative to it.
    #[serde(default = "few_roundings")]
    pub within: f64,
}

impl Expect for Ratio {
    fn check(&self, picture: &Rendered) -> Result<(), String> {
        let of = picture.linear_at(self.of)?.channels();
        let to = picture.linear_at(self.to)?.channels();
        let pairs: Vec<_> = of.into_iter().zip(to).filter(|&pair| pair != (0.0, 0.0)).collect();
        let close = !pairs.is_empty()
            && pairs.iter().all(|(of, to)| is_close(of / to, self.is, self.within));
        if close {
            return Ok(());
        }
        Err(format!(
            "ratio of pixels {:?} to {:?}: expected {} within {}, found {of:?} to {to:?}",
            self.of, self.to, self.is, self.within
        ))
    }

    fn pixels(&self) -> Vec<(&'static str, At)> {
        vec![("of", self.of), ("to", self.to)]
    }

    fn problems(&self, _: (u32, u32)) -> Vec<(&'static str, String)> {
        let mut problems = tolerance_problem(self.within);
        if !(self.is.is_finite() && self.is > 0.0) {
            problems.push(("is", format!("`is`: expected a number above 0, found {}", self.is)));
        }
        if self.of == self.to {
            problems.push(("to", "`to`: expected another pixel than `of`".to_owned()));
        }
        problems
    }
}
