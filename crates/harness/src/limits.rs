//! `Limits`: how far a picture may be from its golden and still match.

#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};

use crate::metric::Direction::{HigherIsBetter, LowerIsBetter};
use crate::metric::{Comparison, Direction, METRICS};

/// The limits of a fixture. One that says none has the tightest: identical
/// bytes, which is an SSIM of 1 in every window.
///
/// What is stated holds; what is not stated does not decide, so each fixture
/// that loosens says by which metric, and why.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// The lowest SSIM accepted, below 1: of the mean **and** of the worst
    /// window, so that damage to a corner is not averaged away.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ssim: Option<f64>,
    /// The lowest SSIM accepted of the worst window, where it may be lower
    /// than that of the mean.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ssim_worst: Option<f64>,
    /// The highest FLIP accepted, above 0: of the mean **and** of the worst pixel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flip: Option<f64>,
    /// The highest FLIP accepted of the worst pixel, where it may be higher than
    /// that of the mean.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flip_worst: Option<f64>,
    /// The largest difference accepted in any channel of any pixel, of 255.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_abs: Option<u8>,
    /// The most pixels that may differ at all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub differing_pixels: Option<u64>,
    /// Why the picture may differ.
    pub reason: String,
}

impl Limits {
    /// What is wrong with these limits for a picture of so many pixels, by
    /// field; nothing for good ones.
    pub(crate) fn problems(&self, pixels: u64) -> Vec<(&'static str, String)> {
        let mut problems = Vec::new();
        // A worst window has a lower SSIM than the mean, a worst pixel a higher FLIP.
        problems.extend(share_problems(
            ["ssim", "ssim_worst"],
            [self.ssim, self.ssim_worst],
            "at most",
            f64::le,
        ));
        problems.extend(share_problems(
            ["flip", "flip_worst"],
            [self.flip, self.flip_worst],
            "at least",
            f64::ge,
        ));
        // Limits that no picture can break are none.
        if let Some(max_abs @ (0 | u8::MAX)) = self.max_abs {
            problems.push((
                "max_abs",
                format!("`max_abs`: expected a number from 1 to 254, found {max_abs}"),
            ));
        }
        if let Some(differing) = self.differing_pixels.filter(|d| !(1..pixels.max(2)).contains(d)) {
            problems.push((
                "differing_pixels",
                format!(
                    "`differing_pixels`: expected a number from 1 to below the picture's {pixels} \
                     pixels, found {differing}"
                ),
            ));
        }
        let shares = self.ssim.is_some() || self.flip.is_some();
        if !shares && self.max_abs.is_none() && self.differing_pixels.is_none() {
            problems.push((
                "reason",
                "limits without a limit: expected `ssim`, `flip`, `max_abs` or `differing_pixels`"
                    .into(),
            ));
        }
        if self.reason.trim().is_empty() {
            problems.push(("reason", "`reason`: expected why this picture may differ".into()));
        }
        problems
    }

    /// The limits that the comparison breaks, in words; none for a match.
    pub(crate) fn broken_by(limits: Option<&Self>, c: &Comparison) -> Vec<String> {
        if c.is_identical() {
            return Vec::new();
        }
        let Some(limits) = limits else {
            return vec!["expected identical pictures".to_owned()];
        };
        limits.bounds().into_iter().filter(|bound| !bound.holds(c)).map(|b| b.words(c)).collect()
    }

    /// What each stated limit asks of which metric.
    pub(crate) fn bounds(&self) -> Vec<Bound> {
        type Stated<T> = (&'static str, Option<T>);
        let bound = |(limit, accepted): Stated<f64>, metric, name, direction| {
            Some(Bound { limit, metric, name, direction, accepted: accepted? })
        };
        let counted = |(limit, accepted): Stated<u64>| (limit, accepted.map(|count| count as f64));
        let ssim = ("ssim", self.ssim);
        let flip = ("flip", self.flip);
        let ssim_worst = self.ssim_worst.map_or(ssim, |own| ("ssim_worst", Some(own)));
        let flip_worst = self.flip_worst.map_or(flip, |own| ("flip_worst", Some(own)));
        let max_abs = counted(("max_abs", self.max_abs.map(u64::from)));
        let differing = counted(("differing_pixels", self.differing_pixels));
        [
            bound(ssim, "ssim_mean", "mean SSIM", HigherIsBetter),
            bound(ssim_worst, "ssim_min", "worst window's SSIM", HigherIsBetter),
            bound(flip, "flip_mean", "mean FLIP", LowerIsBetter),
            bound(flip_worst, "flip_max", "worst pixel's FLIP", LowerIsBetter),
            bound(max_abs, "max_abs", "largest difference", LowerIsBetter),
            bound(differing, "differing_pixels", "count of differing pixels", LowerIsBetter),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// What a limit asks of a metric.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bound {
    /// The field of [`Limits`].
    pub(crate) limit: &'static str,
    /// The name of the metric in [`METRICS`].
    pub(crate) metric: &'static str,
    /// The metric in words.
    name: &'static str,
    /// Which way along the number line is accepted.
    pub(crate) direction: Direction,
    /// The last number that is accepted.
    pub(crate) accepted: f64,
}

impl Bound {
    /// The metric's number; NaN where the comparison has none.
    pub(crate) fn found(&self, c: &Comparison) -> f64 {
        let metric = METRICS.iter().find(|metric| metric.name == self.metric);
        metric.and_then(|metric| (metric.value)(c)).unwrap_or(f64::NAN)
    }

    /// Whether the limit is kept. A NaN keeps none.
    pub(crate) fn holds(&self, c: &Comparison) -> bool {
        match self.direction {
            HigherIsBetter => self.found(c) >= self.accepted,
            LowerIsBetter => self.found(c) <= self.accepted,
        }
    }

    fn words(&self, c: &Comparison) -> String {
        let Self { name, accepted, .. } = self;
        let side = if self.direction == HigherIsBetter { "below" } else { "above" };
        let found = self.found(c);
        // Counts are whole numbers, shares are told by six digits.
        let is_count = matches!(self.metric, "max_abs" | "differing_pixels");
        let found = if is_count { found.to_string() } else { format!("{found:.6}") };
        format!("{name} {found} is {side} its limit {accepted}")
    }
}

/// What is wrong with a limit of the mean and the one that loosens it for the
/// worst place, both above 0 and below 1, the latter `bound` the former.
fn share_problems(
    [field, worst_field]: [&'static str; 2],
    limits: [Option<f64>; 2],
    bound: &str,
    is_bound: fn(&f64, &f64) -> bool,
) -> Vec<(&'static str, String)> {
    let mut problems = Vec::new();
    for (field, limit) in [field, worst_field].into_iter().zip(limits) {
        if let Some(limit) = limit.filter(|s| !(0.0 < *s && *s < 1.0)) {
            problems.push((
                field,
                format!(
                    "`{field}`: expected a number above 0 and below 1 (leave the limit out for \
                     identical pictures), found {limit}"
                ),
            ));
        }
    }
    let text = match limits {
        [Some(mean), Some(worst)] if !is_bound(&worst, &mean) => {
            format!("`{worst_field}`: expected {bound} `{field}`, {mean}, found {worst}")
        }
        [None, Some(_)] => format!("`{worst_field}` needs `{field}`, the limit of the mean"),
        _ => return problems,
    };
    problems.push((worst_field, text));
    problems
}
