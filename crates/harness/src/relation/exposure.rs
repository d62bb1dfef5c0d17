//! `Exposure`: more exposure makes all brighter alike.

use scene::format::Show;
use serde::{Deserialize, Serialize};
use tracer::LinearImage;

use super::alike::few_roundings;
use super::{
    Alike, Broken, Problem, Relate, Today, problem_if, problem_of_error, problem_of_factor, shown,
};
use crate::check::File;

/// Every pixel is `by` times as bright when the exposure is, the background
/// included. A power of two changes no digit, so then it is to the bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exposure {
    /// How many times brighter.
    pub by: f64,
    /// How far each channel may be off, relative to the brightest of the
    /// picture; nothing by a power of two.
    #[serde(default = "few_roundings")]
    pub within: f64,
}

impl Relate for Exposure {
    fn words(&self) -> String {
        format!("Exposure(by: {})", shown(self.by))
    }

    fn alike(&self) -> Alike {
        let within = if is_power_of_two(self.by) { 0.0 } else { self.within };
        Alike { within, edge_pixels: 0 }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let mut problems = problem_of_factor(self.by);
        problems.extend(problem_if(
            file.show != Show::Shaded || file.exposure == 0.0,
            "expected a shaded picture with an exposure above 0, as no other is exposed",
        ));
        problems.extend(problem_of_error(file));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let file = &today.fixture.file;
        let exposed = File { exposure: self.by * file.exposure, ..file.clone() };
        let found = today.fixture.render_related(&exposed)?;
        let pixels = today.picture.pixels().iter().map(|&pixel| pixel * self.by).collect();
        let expected = LinearImage::from_pixels(today.picture.size(), pixels);
        self.alike().compare(expected.as_ref().unwrap_or(today.picture), &found)
    }
}

fn is_power_of_two(x: f64) -> bool {
    /// What a normal number has behind its first binary digit.
    const FRACTION: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
    x.is_normal() && x.to_bits() & FRACTION == 0
}
