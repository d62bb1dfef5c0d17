//! `Report`: what all builds found together, for people and for machines.

use std::fmt::Write as _;

use serde::{Deserialize, Serialize};

use super::{Record, Spread};
use crate::limits::Limits;

/// Everything that was measured. The JSON form of `calibrate`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The version of this form.
    pub schema: u32,
    /// What each build found alone.
    pub builds: Vec<Record>,
    /// What they found together, by fixture.
    pub fixtures: Vec<Together>,
}

/// The spread of a fixture over all builds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Together {
    /// Its name.
    pub fixture: String,
    /// Of all its pictures.
    pub spread: Spread,
    /// The loosest limits that this justifies; none for identical pictures.
    pub justified: Option<Limits>,
    /// Whether pictures that are not the same are no surprise: they have limits.
    pub may_differ: bool,
}

impl Report {
    /// The report of these builds, the first one's fixtures in its order.
    ///
    /// `between` is the spread of the pictures that the builds make in the first
    /// way, for a fixture of which they have other bits.
    ///
    /// # Errors
    /// Those of `between`.
    pub fn new(
        builds: Vec<Record>,
        between: &dyn Fn(&str) -> Result<Spread, String>,
    ) -> Result<Self, String> {
        let mut fixtures = Vec::new();
        let (first, others) = builds.split_first().ok_or("expected at least one build")?;
        for of_first in &first.fixtures {
            let name = &of_first.fixture;
            let mut spread = of_first.spread;
            for other in others {
                let found = other.fixtures.iter().find(|of| of.fixture == *name);
                let found = found.ok_or_else(|| format!("{name}: the other build left it out"))?;
                spread.join(&found.spread);
                if (&found.linear, &found.encoded) != (&of_first.linear, &of_first.encoded) {
                    spread.join(&between(name)?);
                }
            }
            let justified = spread.justified();
            let may_differ = of_first.has_limits;
            fixtures.push(Together { fixture: name.clone(), spread, justified, may_differ });
        }
        Ok(Self { schema: 1, builds, fixtures })
    }

    /// Fixtures without limits whose pictures are not all the same, to the last
    /// bit before encoding.
    pub fn surprises(&self) -> impl Iterator<Item = &Together> {
        self.fixtures.iter().filter(|f| f.spread.other_bits > 0 && !f.may_differ)
    }

    /// A line for each fixture and one for all.
    pub fn text(&self) -> String {
        let titles = ["other bits", "codes", "pixels", "ssim", "worst"];
        let mut text = format!("{:<36}", "fixture");
        for title in titles {
            let _ = write!(text, "{title:>11}");
        }
        text += "  limits that it justifies\n";
        for Together { fixture, spread, justified, .. } in &self.fixtures {
            let Spread { other_bits, max_abs, differing_pixels, ssim, ssim_worst, .. } = spread;
            let limits = justified.as_ref().map_or("none: identical".to_owned(), limits_words);
            let _ = writeln!(
                text,
                "{fixture:<36}{other_bits:>11}{max_abs:>11}{differing_pixels:>11}{ssim:>11.6}\
                 {ssim_worst:>11.6}  {limits}"
            );
        }
        for Record { build, ways, .. } in &self.builds {
            let _ = writeln!(text, "{build}: each picture made in {ways} ways");
        }
        let differing = self.fixtures.iter().filter(|f| f.spread.other_bits > 0).count();
        let _ = writeln!(text, "{} calibrated: {differing} with other bits", self.fixtures.len());
        text
    }
}

fn limits_words(limits: &Limits) -> String {
    let mut words = Vec::new();
    let mut say = |field: &str, value: Option<String>| {
        words.extend(value.map(|value| format!("{field}: {value}")));
    };
    say("ssim", limits.ssim.map(|ssim| ssim.to_string()));
    say("ssim_worst", limits.ssim_worst.map(|ssim| ssim.to_string()));
    say("flip", limits.flip.map(|flip| flip.to_string()));
    say("flip_worst", limits.flip_worst.map(|flip| flip.to_string()));
    say("max_abs", limits.max_abs.map(|codes| codes.to_string()));
    say("differing_pixels", limits.differing_pixels.map(|pixels| pixels.to_string()));
    words.join(", ")
}
