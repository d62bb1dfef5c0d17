//! `Spread`: how far pictures are apart that should be the same, and the limits
//! that this justifies.

use serde::{Deserialize, Serialize};

use crate::expectation::Rendered;
use crate::limits::Limits;
use crate::metric::{Comparison, compare};

/// How many times its spread a limit may be: the next processor or compiler may
/// be off as far again to the other side.
pub const MARGIN: f64 = 2.0;

/// An SSIM is rounded down to whole parts of this: more digits are not worth
/// writing into a fixture.
const DIGITS: f64 = 1e6;

/// The furthest that any picture was from the first.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// How many pictures have other bits before encoding.
    pub other_bits: u64,
    /// The largest difference of a code.
    pub max_abs: u8,
    /// The most pixels that differ.
    pub differing_pixels: u64,
    /// The lowest mean SSIM.
    pub ssim: f64,
    /// The lowest SSIM of a window.
    pub ssim_worst: f64,
    /// The highest mean FLIP.
    pub flip: f64,
    /// The highest FLIP of a pixel.
    pub flip_worst: f64,
}

impl Default for Spread {
    /// Of pictures that are all the same.
    fn default() -> Self {
        Self {
            other_bits: 0,
            max_abs: 0,
            differing_pixels: 0,
            ssim: 1.0,
            ssim_worst: 1.0,
            flip: 0.0,
            flip_worst: 0.0,
        }
    }
}

impl Spread {
    /// Whether all encoded pictures are the same, so that no limit is justified.
    pub fn is_none(&self) -> bool {
        self.differing_pixels == 0
    }

    /// Takes in that one picture has other bits than another.
    pub fn widen(&mut self, reference: &Rendered, other: &Rendered) {
        let found = Self::of(compare(&reference.encoded, &other.encoded).as_ref());
        self.join(&Self { other_bits: 1, ..found });
    }

    /// That of two encoded pictures. Where they cannot be compared, being of
    /// other sizes, they are as far apart as can be.
    pub fn of(comparison: Option<&Comparison>) -> Self {
        let apart = Self {
            other_bits: 0,
            max_abs: u8::MAX,
            differing_pixels: u64::MAX,
            ssim: -1.0,
            ssim_worst: -1.0,
            flip: 1.0,
            flip_worst: 1.0,
        };
        comparison.map_or(apart, |c| Self {
            max_abs: c.max_abs,
            differing_pixels: c.differing_pixels,
            ssim: c.ssim_mean,
            ssim_worst: c.ssim_min,
            flip: c.flip_mean,
            flip_worst: c.flip_max,
            ..apart
        })
    }

    /// Takes in another spread.
    pub fn join(&mut self, other: &Self) {
        self.other_bits += other.other_bits;
        self.max_abs = self.max_abs.max(other.max_abs);
        self.differing_pixels = self.differing_pixels.max(other.differing_pixels);
        self.ssim = self.ssim.min(other.ssim);
        self.ssim_worst = self.ssim_worst.min(other.ssim_worst);
        self.flip = self.flip.max(other.flip);
        self.flip_worst = self.flip_worst.max(other.flip_worst);
    }

    /// The loosest limits that it justifies, [`MARGIN`] included; `None` where a
    /// fixture has no reason to differ at all. One that would let everything
    /// pass is left out: pictures that far apart are not the same.
    pub fn justified(&self) -> Option<Limits> {
        let widened = |ssim: f64| {
            let limit = 1.0 - MARGIN * (1.0 - ssim);
            Some((limit * DIGITS).floor() / DIGITS).filter(|limit| 0.0 < *limit)
        };
        let raised =
            |flip: f64| Some((MARGIN * flip * DIGITS).ceil() / DIGITS).filter(|limit| *limit < 1.0);
        let codes = MARGIN * f64::from(self.max_abs);
        (!self.is_none()).then(|| Limits {
            ssim: widened(self.ssim),
            ssim_worst: widened(self.ssim_worst),
            flip: raised(self.flip),
            flip_worst: raised(self.flip_worst),
            max_abs: (codes < f64::from(u8::MAX)).then_some(codes as u8),
            differing_pixels: Some((MARGIN * self.differing_pixels as f64) as u64),
            reason: "calibrated".to_owned(),
        })
    }

    /// Which of the limits are looser than justified: the field, what it may be
    /// and what it is.
    pub fn looser(&self, limits: &Limits) -> Vec<(&'static str, String, String)> {
        let justified = self.justified();
        let mut looser = Vec::new();
        let mut hold = |field, stated: Option<f64>, may_be: Option<f64>, higher_is_looser: bool| {
            let Some(stated) = stated else { return };
            let keeps = match may_be {
                Some(may_be) if higher_is_looser => stated <= may_be,
                Some(may_be) => stated >= may_be,
                None => false,
            };
            if !keeps {
                let may_be = may_be.map_or("none".to_owned(), |may_be| may_be.to_string());
                looser.push((field, may_be, stated.to_string()));
            }
        };
        let of = |get: fn(&Limits) -> Option<f64>| justified.as_ref().and_then(get);
        hold(
            "ssim",
            limits.ssim,
            of(|l| if l.ssim < l.ssim_worst { l.ssim } else { l.ssim_worst }),
            false,
        );
        hold("ssim_worst", limits.ssim_worst, of(|l| l.ssim_worst), false);
        // A limit of the mean also holds for the worst, where that has none.
        hold(
            "flip",
            limits.flip,
            of(|l| if l.flip > l.flip_worst { l.flip } else { l.flip_worst }),
            true,
        );
        hold("flip_worst", limits.flip_worst, of(|l| l.flip_worst), true);
        let max_abs = |l: &Limits| l.max_abs.map(f64::from);
        hold("max_abs", max_abs(limits), of(max_abs), true);
        let pixels = |l: &Limits| l.differing_pixels.map(|pixels| pixels as f64);
        hold("differing_pixels", pixels(limits), of(pixels), true);
        looser
    }
}
