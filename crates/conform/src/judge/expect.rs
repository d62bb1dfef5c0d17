//! What a fixture says of its picture on paper, asked of another renderer's.
//!
//! Each number of the picture is an interval, widened by the adapter's tolerance;
//! an expectation is broken where no values in them fulfill it. Edge pixels are
//! forgiven: what names one says nothing, and in a count they may be either.

use harness::encode::Transfer;
use harness::expectation::{Count, Expectation, Mirror, Pixel, Radiance, Ratio};
use tracer::Size;

use super::{Level, Levels, Reference};
use crate::scale::Scale;

/// The expectations that a picture breaks, in words.
pub(super) fn broken(
    reference: &Reference<'_>,
    levels: &Levels,
    scale: Scale,
    tolerance: f64,
) -> Vec<String> {
    let asked = Asked { reference, levels, scale, tolerance };
    let expectations = reference.fixture.check.expect.iter();
    expectations.filter_map(|expectation| asked.broken(expectation)).collect()
}

/// A picture that is asked.
struct Asked<'a> {
    reference: &'a Reference<'a>,
    levels: &'a Levels,
    scale: Scale,
    tolerance: f64,
}

impl Asked<'_> {
    /// What was expected and found, if it is not so.
    fn broken(&self, expectation: &Expectation) -> Option<String> {
        match expectation {
            Expectation::Pixel(pixel) => self.pixel(pixel),
            Expectation::Radiance(radiance) => self.radiance(radiance),
            Expectation::Count(count) => self.count(count),
            Expectation::Mirror(mirror) => self.mirror(*mirror),
            Expectation::Ratio(ratio) => self.ratio(ratio),
        }
    }

    fn index(&self, (x, y): (u32, u32)) -> usize {
        y as usize * self.levels.size().width as usize + x as usize
    }

    fn is_edge(&self, at: (u32, u32)) -> bool {
        self.reference.around.get(self.index(at)).is_none_or(Option::is_some)
    }

    /// What a pixel may be, with the tolerance.
    fn at(&self, at: (u32, u32)) -> [Level; 3] {
        let index = self.index(at);
        let expected = self.reference.rendered.linear.pixels()[index];
        let widened = self.tolerance * self.scale.at(expected);
        self.levels.pixels()[index].map(|level| level.widened(widened))
    }

    fn found(&self, (x, y): (u32, u32)) -> String {
        super::triple(self.levels.nominal().get(x, y).unwrap_or_default().channels())
    }

    /// The 8-bit codes that a channel may have, least and most.
    fn codes(&self, level: Level) -> (u8, u8) {
        let transfer: Transfer = self.reference.fixture.transfer;
        (transfer.code(level.low), transfer.code(level.high))
    }

    fn may_be(&self, levels: [Level; 3], rgb: [u8; 3]) -> bool {
        levels.into_iter().zip(rgb).all(|(level, code)| {
            let (least, most) = self.codes(level);
            (least..=most).contains(&code)
        })
    }

    fn pixel(&self, Pixel { at, rgb }: &Pixel) -> Option<String> {
        let is_fine = self.is_edge(*at) || self.may_be(self.at(*at), (*rgb).into());
        (!is_fine).then(|| {
            format!("pixel {at:?}: expected the 8-bit color {rgb:?}, found {}", self.found(*at))
        })
    }

    fn radiance(&self, Radiance { at, rgb, within }: &Radiance) -> Option<String> {
        let expected: [f64; 3] = (*rgb).into();
        let mut channels = self.at(*at).into_iter().zip(expected);
        let is_fine =
            self.is_edge(*at) || channels.all(|(level, c)| level.distance(c) <= within * c.abs());
        (!is_fine).then(|| {
            format!("radiance of pixel {at:?}: expected {rgb:?}, found {}", self.found(*at))
        })
    }

    fn ratio(&self, Ratio { of, to, is, within }: &Ratio) -> Option<String> {
        if self.is_edge(*of) || self.is_edge(*to) {
            return None;
        }
        let linear = &self.reference.rendered.linear;
        let [own, other] = [of, to].map(|&at| linear.pixels()[self.index(at)].channels());
        let is_black = |channel: usize| own[channel] == 0.0 && other[channel] == 0.0;
        let (left, right) = (self.at(*of), self.at(*to));
        let is_fine = (0..3).filter(|&channel| !is_black(channel)).all(|channel| {
            let Level { low, high } = right[channel];
            // Of two ends of either sign, either may be the lower one.
            let ends =
                [low, high].map(|end| [end * is * (1.0 - within), end * is * (1.0 + within)]);
            let ends = ends.as_flattened();
            let least = ends.iter().copied().fold(f64::INFINITY, f64::min);
            let most = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            left[channel].meets(Level { low: least, high: most })
        });
        (!is_fine).then(|| {
            format!(
                "ratio of pixels {of:?} to {to:?}: expected {is}, found {} to {}",
                self.found(*of),
                self.found(*to)
            )
        })
    }

    fn count(&self, Count { rgb, pixels, within }: &Count) -> Option<String> {
        let color: [u8; 3] = (*rgb).into();
        let Size { width, height } = self.levels.size();
        let (mut surely, mut perhaps) = (0_u64, 0_u64);
        for at in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let levels = self.at(at);
            let may_be = self.may_be(levels, color);
            let is_edge = self.is_edge(at);
            let is_sure = levels.iter().all(|&level| {
                let (least, most) = self.codes(level);
                least == most
            });
            surely += u64::from(may_be && is_sure && !is_edge);
            perhaps += u64::from(may_be || is_edge);
        }
        let allowed = surely.saturating_sub(*within)..=perhaps.saturating_add(*within);
        (!allowed.contains(pixels)).then(|| {
            format!("pixels of color {rgb:?}: expected {pixels}, found {surely} to {perhaps}")
        })
    }

    fn mirror(&self, way: Mirror) -> Option<String> {
        let Size { width, height } = self.levels.size();
        let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let pairs = all.map(|(x, y)| match way {
            Mirror::LeftRight => ((x, y), (width - 1 - x, y)),
            Mirror::TopBottom => ((x, y), (x, height - 1 - y)),
        });
        let is_broken = |&(one, other): &((u32, u32), (u32, u32))| {
            let mut channels = self.at(one).into_iter().zip(self.at(other));
            !self.is_edge(one) && !self.is_edge(other) && !channels.all(|(a, b)| a.meets(b))
        };
        let mut pairs = pairs;
        let (one, other) = pairs.find(is_broken)?;
        Some(format!(
            "{way:?} mirror: pixels {one:?} and {other:?}: expected the same, found {} and {}",
            self.found(one),
            self.found(other)
        ))
    }
}
