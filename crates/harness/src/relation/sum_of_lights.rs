//! `SumOfLights`: all lights together give what each gives alone, added up.

use scene::format::{Light, Show};
use serde::{Deserialize, Serialize};
use tracer::{LinearImage, Rgb};

use super::alike::few_roundings;
use super::{Alike, Broken, Problem, Relate, Today, problem_if, problem_of_error};
use crate::check::File;

/// The picture without lights, and what each light alone adds to it, make the
/// picture: `p = p0 + (p1 - p0) + (p2 - p0) + ...`. What no light changes, the
/// background and unlit materials, is in `p0` and counts once.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SumOfLights {
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl Relate for SumOfLights {
    fn words(&self) -> String {
        "SumOfLights()".to_owned()
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let mut problems = problem_if(
            file.lights.len() < 2,
            &format!("expected two lights or more, found {}", file.lights.len()),
        );
        problems.extend(problem_if(
            file.show != Show::Shaded,
            "expected a shaded picture, as others do not show light",
        ));
        problems.extend(problem_of_error(file));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let file = &today.fixture.file;
        let lit_by =
            |lights: Vec<Light>| today.fixture.render_related(&File { lights, ..file.clone() });
        let unlit = lit_by(Vec::new())?;
        let mut sum: Vec<Rgb> = unlit.pixels().to_vec();
        for light in &file.lights {
            let lit = lit_by(vec![*light])?;
            for ((sum, &lit), &unlit) in sum.iter_mut().zip(lit.pixels()).zip(unlit.pixels()) {
                *sum += lit + unlit * -1.0;
            }
        }
        let sum = LinearImage::from_pixels(unlit.size(), sum);
        self.alike().compare(&sum.unwrap_or(unlit), today.picture)
    }
}
