//! `Limits`: how far a picture may be from its golden and still match.

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
    #[serde(default)]
    pub ssim: Option<f64>,
    /// The lowest SSIM accepted of the worst window, where it may be lower
    /// than that of the mean.
    #[serde(default)]
    pub ssim_worst: Option<f64>,
    /// The largest difference accepted in any channel of any pixel, of 255.
    #[serde(default)]
    pub max_abs: Option<u8>,
    /// The most pixels that may differ at all.
    #[serde(default)]
    pub differing_pixels: Option<u64>,
    /// Why the picture may differ.
    pub reason: String,
}

impl Limits {
    /// What is wrong with these limits for a picture of so many pixels, by
    /// field; nothing for good ones.
    pub(crate) fn problems(&self, pixels: u64) -> Vec<(&'static str, String)> {
        let mut problems = Vec::new();
        let ssims = [("ssim", self.ssim), ("ssim_worst", self.ssim_worst)];
        for (field, ssim) in ssims {
            if let Some(ssim) = ssim.filter(|s| !(0.0 < *s && *s < 1.0)) {
                problems.push((
                    field,
                    format!(
                        "`{field}`: expected a number above 0 and below 1 (leave the limit out for \
                         identical pictures), found {ssim}"
                    ),
                ));
            }
        }
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
        if let (Some(mean), Some(worst)) = (self.ssim, self.ssim_worst)
            && worst > mean
        {
            problems.push((
                "ssim_worst",
                format!("`ssim_worst`: expected at most `ssim`, {mean}, found {worst}"),
            ));
        }
        if self.ssim_worst.is_some() && self.ssim.is_none() {
            problems
                .push(("ssim_worst", "`ssim_worst` needs `ssim`, the limit of the mean".into()));
        }
        let none = self.ssim.is_none() && self.max_abs.is_none() && self.differing_pixels.is_none();
        if none {
            problems.push((
                "reason",
                "limits without a limit: expected `ssim`, `max_abs` or `differing_pixels`".into(),
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
        let mut broken = Vec::new();
        // Positive tests: a NaN keeps no limit.
        let mut at_least = |name: &str, found: f64, limit: Option<f64>| {
            if let Some(limit) = limit
                && !(found >= limit)
            {
                broken.push(format!("{name} {found:.6} is below its limit {limit}"));
            }
        };
        at_least("mean SSIM", c.ssim_mean, limits.ssim);
        at_least("worst window's SSIM", c.ssim_min, limits.ssim_worst.or(limits.ssim));
        let mut at_most = |name: &str, found: u64, limit: Option<u64>| {
            if let Some(limit) = limit
                && found > limit
            {
                broken.push(format!("{name} {found} is above its limit {limit}"));
            }
        };
        at_most("largest difference", c.max_abs.into(), limits.max_abs.map(u64::from));
        at_most("count of differing pixels", c.differing_pixels, limits.differing_pixels);
        broken
    }
}

#[cfg(test)]
mod tests {
    use tracer::Size;

    use super::*;
    use crate::encode::EncodedImage;
    use crate::metric::compare;

    fn limits() -> Limits {
        Limits { reason: "a test".into(), ..Limits::default() }
    }

    /// A gray 32 x 32 picture, and one with `count` pixels lighter by `by`.
    fn comparison(count: usize, by: u8) -> Comparison {
        let size = Size { width: 32, height: 32 };
        let picture = |count: usize| {
            let bytes = (0..32 * 32).flat_map(|i| [if i < count { 100 + by } else { 100 }; 3]);
            EncodedImage::from_bytes(size, bytes.collect()).unwrap()
        };
        compare(&picture(0), &picture(count)).unwrap()
    }

    #[test]
    fn without_limits_only_identical_pictures_match() {
        assert_eq!(Limits::broken_by(None, &comparison(0, 9)), [""; 0]);
        assert_eq!(Limits::broken_by(None, &comparison(1, 1)).len(), 1);
    }

    #[test]
    fn each_stated_limit_holds_and_no_other() {
        let two_by_three = comparison(2, 3);
        let broken = |limits: Limits| Limits::broken_by(Some(&limits), &two_by_three).len();
        assert_eq!(broken(Limits { max_abs: Some(3), ..limits() }), 0);
        assert_eq!(broken(Limits { max_abs: Some(2), ..limits() }), 1);
        assert_eq!(broken(Limits { differing_pixels: Some(2), ..limits() }), 0);
        assert_eq!(broken(Limits { differing_pixels: Some(1), max_abs: Some(2), ..limits() }), 2);
    }

    #[test]
    fn a_good_mean_does_not_hide_a_bad_window() {
        let blot = comparison(1, 155);
        assert!(blot.ssim_mean > 0.9 && blot.ssim_min < 0.5, "{blot:?}");
        let broken = |limits| Limits::broken_by(Some(&limits), &blot);
        let mean_only = Limits { ssim: Some(0.9), ssim_worst: Some(1e-9), ..limits() };
        assert_eq!(broken(mean_only), [""; 0]);
        let both = broken(Limits { ssim: Some(0.9), ..limits() });
        assert!(both[0].starts_with("worst window's SSIM"), "{both:?}");
    }

    #[test]
    fn a_nan_keeps_no_limit() {
        let nan = Comparison { ssim_mean: f64::NAN, ssim_min: f64::NAN, ..comparison(1, 1) };
        let limits = Limits { ssim: Some(0.5), ..limits() };
        assert_eq!(Limits::broken_by(Some(&limits), &nan).len(), 2);
    }

    #[test]
    fn limits_that_say_nothing_are_problems() {
        let fields = |limits: Limits| limits.problems(1024).iter().map(|p| p.0).collect::<Vec<_>>();
        assert_eq!(fields(Limits { ssim: Some(0.99), ..limits() }), [""; 0]);
        let equal = Limits { ssim: Some(0.9), ssim_worst: Some(0.9), ..limits() };
        assert_eq!(fields(equal), [""; 0]);
        for ssim in [-1.0, 0.0, 1.0, 1.5] {
            assert_eq!(fields(Limits { ssim: Some(ssim), ..limits() }), ["ssim"], "{ssim}");
        }
        for never in [0, 255] {
            assert_eq!(fields(Limits { max_abs: Some(never), ..limits() }), ["max_abs"]);
        }
        for never in [0, 1024, 9999] {
            let limits = Limits { differing_pixels: Some(never), ..limits() };
            assert_eq!(fields(limits), ["differing_pixels"]);
        }
        assert_eq!(fields(limits()), ["reason"]);
        assert_eq!(fields(Limits { max_abs: Some(1), reason: " ".into(), ..limits() }), ["reason"]);
        assert_eq!(fields(Limits { ssim: Some(1.0), ..limits() }), ["ssim"]);
        assert_eq!(fields(Limits { ssim: Some(f64::NAN), ..limits() }), ["ssim"]);
        let worst_alone = Limits { ssim_worst: Some(0.5), max_abs: Some(1), ..limits() };
        assert_eq!(fields(worst_alone), ["ssim_worst"]);
        let upside_down = Limits { ssim: Some(0.5), ssim_worst: Some(0.9), ..limits() };
        assert_eq!(fields(upside_down), ["ssim_worst"]);
    }
}
