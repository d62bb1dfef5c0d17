//! `Limits`: how far a picture may be from its golden and still match.

#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};

use crate::metric::Comparison;

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
        let worst_ssim = limits.ssim_worst.or(limits.ssim);
        let worst_flip = limits.flip_worst.or(limits.flip);
        [
            below("mean SSIM", c.ssim_mean, limits.ssim),
            below("worst window's SSIM", c.ssim_min, worst_ssim),
            above("mean FLIP", c.flip_mean, limits.flip),
            above("worst pixel's FLIP", c.flip_max, worst_flip),
            above_count("largest difference", c.max_abs.into(), limits.max_abs.map(u64::from)),
            above_count("count of differing pixels", c.differing_pixels, limits.differing_pixels),
        ]
        .into_iter()
        .flatten()
        .collect()
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

// Positive tests: a NaN keeps no limit.

fn below(name: &str, found: f64, limit: Option<f64>) -> Option<String> {
    let limit = limit.filter(|&limit| !(found >= limit))?;
    Some(format!("{name} {found:.6} is below its limit {limit}"))
}

fn above(name: &str, found: f64, limit: Option<f64>) -> Option<String> {
    let limit = limit.filter(|&limit| !(found <= limit))?;
    Some(format!("{name} {found:.6} is above its limit {limit}"))
}

fn above_count(name: &str, found: u64, limit: Option<u64>) -> Option<String> {
    let limit = limit.filter(|&limit| found > limit)?;
    Some(format!("{name} {found} is above its limit {limit}"))
}
