//! `Radiance`: the linear value of one pixel.

use serde::{Deserialize, Serialize};

use super::{At, Expect, Rendered, few_roundings, is_close, tolerance_problem};

/// The pixel at `at` has this linear value, exposure applied.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Radiance {
    /// Which pixel.
    pub at: At,
    /// Its value.
    pub rgb: (f64, f64, f64),
    /// How far each channel may be off, relative to it.
    #[serde(default = "few_roundings")]
    pub within: f64,
}

impl Expect for Radiance {
    fn check(&self, picture: &Rendered) -> Result<(), String> {
        let (x, y) = self.at;
        let found = picture.linear_at(self.at)?.channels();
        let expected: [f64; 3] = self.rgb.into();
        let close = found.iter().zip(expected).all(|(&f, e)| is_close(f, e, self.within));
        if close {
            return Ok(());
        }
        Err(format!(
            "radiance of pixel ({x}, {y}): expected {expected:?} within {}, found {found:?}",
            self.within
        ))
    }

    fn pixels(&self) -> Vec<(&'static str, At)> {
        vec![("at", self.at)]
    }

    fn problems(&self, _: (u32, u32)) -> Vec<(&'static str, String)> {
        let mut problems = tolerance_problem(self.within);
        let (r, g, b) = self.rgb;
        if ![r, g, b].iter().all(|c| c.is_finite()) {
            problems.push(("rgb", format!("`rgb`: expected finite numbers, found {:?}", self.rgb)));
        }
        problems
    }
}
