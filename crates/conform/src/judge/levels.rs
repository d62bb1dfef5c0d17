//! `Levels`: the linear values that the numbers of a picture file may stand for.
//!
//! A file tells values apart no finer than its numbers are, so each of them stands
//! for an interval: half a step to both sides of a code or of a floating point
//! number, a whole step upwards of a code that was rounded down. The largest code
//! stands for all that is brighter, the smallest for all that is darker.

use harness::picture_file::{Depth, Stored};
use tracer::{LinearImage, Rgb, Size};

use crate::adapter::{Meaning, Rounding, Rows};

/// Linear values from `low` to `high`, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Level {
    /// The least.
    pub low: f64,
    /// The most.
    pub high: f64,
}

impl Level {
    /// How far a value is from the nearest in it.
    pub fn distance(self, value: f64) -> f64 {
        (self.low - value).max(value - self.high).max(0.0)
    }

    /// The same with as much more to both sides.
    #[must_use]
    pub fn widened(self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    /// Whether a value is in both.
    pub fn meets(self, other: Self) -> bool {
        self.low <= other.high && other.low <= self.high
    }
}

/// The largest code of 8 bits. A coarser file would be right about anything.
const LEAST_CODES: u16 = 255;

/// A picture whose channels are known up to the steps of its file.
#[derive(Debug, Clone, PartialEq)]
pub struct Levels {
    size: Size,
    pixels: Vec<[Level; 3]>,
    nominal: LinearImage,
}

impl Levels {
    /// What a file's numbers stand for.
    ///
    /// # Errors
    /// A number that is infinite or none, as the rest of a sentence.
    pub fn of(stored: &Stored, meaning: Meaning) -> Result<Self, String> {
        let size = stored.size();
        let width = size.width as usize;
        let bad = stored.values().iter().position(|pixel| pixel.iter().any(|c| !c.is_finite()));
        if let Some(at) = bad {
            let count = stored.values().iter().filter(|p| p.iter().any(|c| !c.is_finite())).count();
            let pixel = stored.values()[at];
            let (x, y) = (at % width, at / width);
            return Err(format!(
                "has {count} px that are no finite numbers, the first ({x}, {y}) of the file: {pixel:?}"
            ));
        }
        if let Depth::Codes { max } = stored.depth()
            && max < LEAST_CODES
        {
            return Err(format!("has codes up to {max}, expected {LEAST_CODES} or more: 8 bits"));
        }
        let rows = stored.values().chunks_exact(width);
        let values: Vec<[f64; 3]> = match meaning.rows {
            Rows::TopFirst => rows.flatten().copied().collect(),
            Rows::BottomFirst => rows.rev().flatten().copied().collect(),
        };
        let depth = stored.depth();
        let levels = values.iter().map(|pixel| pixel.map(|c| level(c, depth, meaning)));
        let nominal = |c: f64| match depth {
            Depth::Codes { max } => meaning.transfer.linear(c / f64::from(max)),
            Depth::Half | Depth::Single => meaning.transfer.linear(c),
        };
        let pixels = values.iter().map(|pixel| Rgb::from(pixel.map(nominal))).collect();
        let nominal =
            LinearImage::from_pixels(size, pixels).ok_or("has a wrong count of pixels")?;
        Ok(Self { size, pixels: levels.collect(), nominal })
    }

    /// Width and height.
    pub fn size(&self) -> Size {
        self.size
    }

    /// What each pixel may be, row by row from the top.
    pub fn pixels(&self) -> &[[Level; 3]] {
        &self.pixels
    }

    /// The picture with each number taken as it is.
    pub fn nominal(&self) -> &LinearImage {
        &self.nominal
    }

    /// The least and the most that each number may stand for, as pictures.
    pub fn bounds(&self) -> [LinearImage; 2] {
        let of = |side: fn(&Level) -> f64| {
            let width = self.size.width as usize;
            LinearImage::from_fn(self.size, |x, y| {
                let pixel = &self.pixels[y as usize * width + x as usize];
                Rgb::from([side(&pixel[0]), side(&pixel[1]), side(&pixel[2])])
            })
        };
        [of(|level| level.low), of(|level| level.high)]
    }

    /// The picture whose pixels are the means of squares of `n` by `n` of these, of
    /// which there are so many in each direction: what samples on a grid make.
    #[must_use]
    pub fn gathered(self, n: u32) -> Self {
        if n <= 1 {
            return self;
        }
        let size = Size { width: self.size.width / n, height: self.size.height / n };
        let wide = self.size.width as usize;
        let count = f64::from(n) * f64::from(n);
        let pixels = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y)));
        let pixels = pixels.map(|(x, y)| {
            mean(n, |i, j| self.pixels[(y * n + j) as usize * wide + (x * n + i) as usize])
        });
        let pixels = pixels.collect();
        let nominal = LinearImage::from_fn(size, |x, y| {
            let mut sum = Rgb::BLACK;
            for j in 0..n {
                for i in 0..n {
                    sum += self.nominal.get(x * n + i, y * n + j).unwrap_or_default();
                }
            }
            sum * (1.0 / count)
        });
        Self { size, pixels, nominal }
    }
}

/// What one pixel of a picture may be, from the top left, as [`Levels::of`] and
/// [`Levels::gathered`] have it: for those who look at few.
pub(super) fn pixel_of(
    stored: &Stored,
    n: u32,
    meaning: Meaning,
    (x, y): (u32, u32),
) -> [Level; 3] {
    let Size { width, height } = stored.size();
    let at = |i: u32, j: u32| {
        let (column, row) = (x * n + i, y * n + j);
        let row = match meaning.rows {
            Rows::TopFirst => row,
            Rows::BottomFirst => height - 1 - row,
        };
        let pixel = stored.values()[row as usize * width as usize + column as usize];
        pixel.map(|c| level(c, stored.depth(), meaning))
    };
    if n <= 1 { at(0, 0) } else { mean(n, at) }
}

/// The mean of a square of `n` by `n` pixels.
fn mean(n: u32, at: impl Fn(u32, u32) -> [Level; 3]) -> [Level; 3] {
    let count = f64::from(n) * f64::from(n);
    let mut sum = [Level { low: 0.0, high: 0.0 }; 3];
    for j in 0..n {
        for i in 0..n {
            for (sum, level) in sum.iter_mut().zip(at(i, j)) {
                // A pixel that is clamped at black is not below it: the others
                // would be free to be anything.
                sum.low += level.low.max(0.0);
                sum.high += level.high;
            }
        }
    }
    sum.map(|sum| Level { low: sum.low / count, high: sum.high / count })
}

/// What a number may stand for.
fn level(stored: f64, depth: Depth, meaning: Meaning) -> Level {
    let linear = |c: f64| meaning.transfer.linear(c);
    match depth {
        Depth::Codes { max } => {
            let max = f64::from(max);
            let (below, above, white) = match meaning.rounding {
                Rounding::Nearest => (0.5, 0.5, max),
                Rounding::Down => (0.0, 1.0, max),
                Rounding::DownOfMore => (0.0, 1.0, max + 1.0),
            };
            let [low, high] = [stored - below, stored + above].map(|code| linear(code / white));
            Level {
                low: if stored <= 0.0 { f64::NEG_INFINITY } else { low },
                high: if stored >= max { f64::INFINITY } else { high },
            }
        }
        Depth::Single => {
            let single = stored as f32;
            let [below, above] = [single.next_down(), single.next_up()].map(f64::from);
            // Beyond the largest there is no other.
            let middle =
                |other: f64| if other.is_finite() { f64::midpoint(stored, other) } else { stored };
            Level { low: linear(middle(below)), high: linear(middle(above)) }
        }
        Depth::Half => {
            let half_step = half_step(stored);
            Level { low: linear(stored - half_step), high: linear(stored + half_step) }
        }
    }
}

/// Half the distance between two 16-bit floating point numbers around here.
///
/// Source: IEEE 754-2019, binary16: 11 bits of precision, the smallest exponent
/// being -14.
fn half_step(value: f64) -> f64 {
    /// Of the numbers below 2^-13: half of 2^-24.
    const SMALLEST: f64 = 1.0 / (1_u64 << 25) as f64;
    const SMALLEST_NORMAL: f64 = 1.0 / (1_u64 << 14) as f64;
    let mut step = SMALLEST;
    let mut power = 2.0 * SMALLEST_NORMAL;
    while power <= value.abs() && power.is_finite() {
        step *= 2.0;
        power *= 2.0;
    }
    step
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adapter::Transfer;

    #[track_caller]
    fn check(stored: f64, depth: Depth, meaning: Meaning, low: f64, high: f64) {
        let found = level(stored, depth, meaning);
        let close = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-15 * b.abs();
        assert!(close(found.low, low) && close(found.high, high), "{found:?}");
    }

    #[test]
    fn a_code_stands_for_its_step() {
        const EIGHT: Depth = Depth::Codes { max: 255 };
        let plain = Meaning::default();
        check(100.0, EIGHT, plain, 99.5 / 255.0, 100.5 / 255.0);
        check(0.0, EIGHT, plain, f64::NEG_INFINITY, 0.5 / 255.0);
        check(255.0, EIGHT, plain, 254.5 / 255.0, f64::INFINITY);
        check(7.0, Depth::Codes { max: 65_535 }, plain, 6.5 / 65_535.0, 7.5 / 65_535.0);
        let down = Meaning { rounding: Rounding::Down, ..plain };
        check(100.0, EIGHT, down, 100.0 / 255.0, 101.0 / 255.0);
        check(0.0, EIGHT, down, f64::NEG_INFINITY, 1.0 / 255.0);
        let more = Meaning { rounding: Rounding::DownOfMore, ..plain };
        check(100.0, EIGHT, more, 100.0 / 256.0, 101.0 / 256.0);
        check(255.0, EIGHT, more, 255.0 / 256.0, f64::INFINITY);
        let gamma = Meaning { transfer: Transfer::Gamma22, ..plain };
        let power = |c: f64| libm::pow(c / 255.0, 2.2);
        check(100.0, EIGHT, gamma, power(99.5), power(100.5));
    }

    #[test]
    fn a_grid_of_pixels_is_one() {
        // Codes 1 to 8 in a picture of 4 x 2: two squares.
        let file = b"P3\n4 2\n255\n1 1 1 2 2 2 3 3 3 4 4 4\n5 5 5 6 6 6 7 7 7 8 8 8\n";
        let levels = Levels::of(&Stored::read(file).unwrap(), Meaning::default()).unwrap();
        let gathered = levels.clone().gathered(2);
        assert_eq!((gathered.size().width, gathered.size().height), (2, 1));
        let means = gathered.nominal().pixels().iter().map(|pixel| 255.0 * pixel.g);
        assert!(means.zip([3.5, 5.5]).all(|(found, mean)| (found - mean).abs() < 1e-12));
        let [first, _] = gathered.pixels() else { panic!("two pixels") };
        assert!((255.0 * first[0].low - 3.0).abs() < 1e-12, "{first:?}");
        assert!((255.0 * first[2].high - 4.0).abs() < 1e-12, "{first:?}");
        assert_eq!(levels.clone().gathered(1), levels);
    }

    #[test]
    fn nothing_passes_by_saying_nothing() {
        let file = b"P3\n2 2\n255\n0 0 0 255 255 255\n255 255 255 0 0 0\n";
        let levels = Levels::of(&Stored::read(file).unwrap(), Meaning::default()).unwrap();
        let mean = levels.gathered(2).pixels()[0][0];
        assert!(mean.low > 0.49 && mean.high == f64::INFINITY, "{mean:?}");
        let coarse = Stored::read(b"P3\n1 1\n1\n0 0 0\n").unwrap();
        let why = Levels::of(&coarse, Meaning::default()).unwrap_err();
        assert_eq!(why, "has codes up to 1, expected 255 or more: 8 bits");
    }

    #[test]
    fn a_float_stands_for_what_rounds_to_it() {
        let plain = Meaning::default();
        let ulp = f64::from(f32::EPSILON);
        check(1.0, Depth::Single, plain, 1.0 - ulp / 4.0, 1.0 + ulp / 2.0);
        check(1.0, Depth::Half, plain, 1.0 - 1.0 / 2048.0, 1.0 + 1.0 / 2048.0);
        check(1.5, Depth::Half, plain, 1.5 - 1.0 / 2048.0, 1.5 + 1.0 / 2048.0);
        check(-3.0, Depth::Half, plain, -3.0 - 1.0 / 1024.0, -3.0 + 1.0 / 1024.0);
        check(65_504.0, Depth::Half, plain, 65_488.0, 65_520.0);
        let smallest = 1.0 / f64::from(1 << 24);
        check(smallest, Depth::Half, plain, smallest / 2.0, smallest * 1.5);
        let most = f64::from(f32::MAX);
        assert_eq!(level(most, Depth::Single, plain).high, most);
    }

    #[test]
    fn rows_may_be_upside_down_and_numbers_none() {
        let read = |bytes: &[u8]| Stored::read(bytes).unwrap();
        let two = read(b"P5 1 2 255 \x01\x02");
        let first = |rows| {
            let meaning = Meaning { rows, ..Meaning::default() };
            Levels::of(&two, meaning).unwrap().nominal().get(0, 0).unwrap().r * 255.0
        };
        assert_eq!([first(Rows::TopFirst), first(Rows::BottomFirst)], [1.0, 2.0]);
        let pixel = |value: f32| [b"Pf 1 1 -1.0\n", &value.to_le_bytes()[..]].concat();
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let why = Levels::of(&read(&pixel(bad)), Meaning::default()).unwrap_err();
            assert!(why.contains("has 1 px that are no finite numbers, the first (0, 0)"), "{why}");
        }
    }
}
