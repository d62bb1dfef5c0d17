//! `Rating`: how much damage a metric sees, on a scale of four words.

use super::super::{Comparison, Direction, Metric};

/// What a metric makes of a pair of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rating {
    /// The pictures are identical, and it says so.
    Same,
    /// The pictures differ, and a tight limit lets them pass.
    Blind,
    /// It sees the damage: neither of its neighbors.
    Small,
    /// It sees damage that not even a loose limit lets pass.
    Large,
    /// It has no value.
    None,
}

impl Rating {
    /// The name of the variant.
    pub fn word(self) -> &'static str {
        match self {
            Self::Same => "Same",
            Self::Blind => "Blind",
            Self::Small => "Small",
            Self::Large => "Large",
            Self::None => "None",
        }
    }
}

/// The values of a metric between which damage is small.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// The name of the metric.
    pub metric: &'static str,
    /// A limit that lets hardly anything pass: to what passes it the metric is
    /// blind.
    pub tight: f64,
    /// A limit that lets much pass: what does not is large.
    pub loose: f64,
}

/// The scale of every metric, in the order of [`METRICS`](super::super::METRICS).
///
/// A tight limit lets one code or one pixel go, or a hundredth of a score. A
/// loose one lets through what a glance at both pictures finds.
pub const SCALES: [Scale; 12] = [
    Scale { metric: "max_abs", tight: 1.0, loose: 32.0 },
    // A tenth of the 64 x 64 pixels that most pictures of the corpus have.
    Scale { metric: "differing_pixels", tight: 1.0, loose: 410.0 },
    Scale { metric: "ssim_min", tight: 0.99, loose: 0.5 },
    Scale { metric: "ssim_mean", tight: 0.99, loose: 0.9 },
    Scale { metric: "ssim_uniform_min", tight: 0.99, loose: 0.5 },
    Scale { metric: "ssim_uniform_mean", tight: 0.99, loose: 0.9 },
    Scale { metric: "flip_max", tight: 0.01, loose: 0.5 },
    Scale { metric: "flip_mean", tight: 0.01, loose: 0.1 },
    Scale { metric: "rmse", tight: 1.0, loose: 8.0 },
    // Those of rmse in decibels.
    Scale { metric: "psnr_db", tight: 48.13, loose: 30.06 },
    Scale { metric: "image_compare_mssim", tight: 0.99, loose: 0.9 },
    Scale { metric: "image_compare_hybrid", tight: 0.99, loose: 0.9 },
];

impl Scale {
    /// How the metric of this scale rates a comparison.
    pub(super) fn rate(&self, metric: &Metric, comparison: &Comparison) -> Rating {
        if comparison.is_identical() {
            return Rating::Same;
        }
        let Some(value) = (metric.value)(comparison) else { return Rating::None };
        let passes = |limit: f64| match metric.direction {
            Direction::HigherIsBetter => value >= limit,
            Direction::LowerIsBetter => value <= limit,
        };
        match (passes(self.tight), passes(self.loose)) {
            (true, _) => Rating::Blind,
            (false, true) => Rating::Small,
            (false, false) => Rating::Large,
        }
    }
}
