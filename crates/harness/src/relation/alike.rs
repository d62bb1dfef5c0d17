//! `Alike`: how alike two linear pictures must be.

use tracer::{LinearImage, Rgb, Size};

use super::{Broken, Problem};

/// The largest `within`: far above what roundings add up to, far below what is
/// seen.
pub const LOOSEST: f64 = 1e-6;

/// The largest `edge_pixels`, as a part of the picture's pixels: a relation that
/// allows more could lose an object.
pub const MOST_EDGES: f64 = 1.0 / 200.0;

/// How alike the pictures must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Alike {
    /// How far each channel may be off, relative to itself or to the brightest of
    /// the picture, up to white; 0 means the very same bits.
    pub(super) within: f64,
    /// How many pixels may be off by more: samples beside a silhouette that
    /// rounding moves to its other side.
    pub(super) edge_pixels: u32,
}

/// A `within` that a fixture may leave out: a few roundings.
pub(super) fn few_roundings() -> f64 {
    1e-12
}

impl Alike {
    /// In every bit.
    pub(super) const BITS: Self = Self { within: 0.0, edge_pixels: 0 };

    /// What would make a relation say nothing, for a picture of this size.
    pub(super) fn problems(self, (width, height): (u32, u32)) -> Vec<Problem> {
        let Self { within, edge_pixels } = self;
        let pixels = u64::from(width) * u64::from(height);
        let most = (MOST_EDGES * pixels as f64).floor();
        let mut problems = Vec::new();
        if !(0.0..=LOOSEST).contains(&within) {
            let message =
                format!("`within`: expected a number from 0 to {LOOSEST}, found {within}");
            problems.push((Some("within"), message));
        }
        if f64::from(edge_pixels) > most {
            let message = format!(
                "`edge_pixels`: expected at most {most} of the picture's {pixels} pixels, found \
                 {edge_pixels}"
            );
            problems.push((Some("edge_pixels"), message));
        }
        problems
    }

    /// Whether the pictures are so alike. One of a single color says nothing,
    /// as it is like its own shifts, turns and parts.
    ///
    /// # Errors
    /// The first pixel that is off, and how many are.
    pub(super) fn compare(self, expected: &LinearImage, found: &LinearImage) -> Result<(), Broken> {
        let Size { width, height } = expected.size();
        if found.size() != expected.size() {
            let Size { width: w, height: h } = found.size();
            let why = format!("expected a picture of {width} x {height}, found {w} x {h}");
            return Err(Broken::Differs(why));
        }
        let scale = brightest(expected).min(WHITE);
        let pairs = expected.pixels().iter().zip(found.pixels()).enumerate();
        let off: Vec<_> =
            pairs.filter(|(_, (a, b))| !is_close(**a, **b, (self.within, scale))).collect();
        let Some(&(first, (a, b))) = off.first().filter(|_| off.len() > self.edge_pixels as usize)
        else {
            says_something(expected)?;
            return self.leaves_something(expected);
        };
        let (x, y) = (first % width as usize, first / width as usize);
        let may = match self.edge_pixels {
            0 => String::new(),
            n => format!(", {n} may"),
        };
        Err(Broken::Differs(format!(
            "pixel ({x}, {y}): expected {:?}, found {:?}; {} of {} pixels differ{may}",
            a.channels(),
            b.channels(),
            off.len(),
            expected.pixels().len()
        )))
    }
}

impl Alike {
    /// Nothing where the picture shows far more than the pixels that may be off.
    ///
    /// # Errors
    /// That it does not.
    fn leaves_something(self, picture: &LinearImage) -> Result<(), Broken> {
        /// How many pixels must show something for each that may be off.
        const TIMES: usize = 10;
        let least = TIMES * self.edge_pixels as usize;
        if least == 0 {
            return Ok(());
        }
        let mut colors: Vec<_> =
            picture.pixels().iter().map(|pixel| pixel.channels().map(f64::to_bits)).collect();
        colors.sort_unstable();
        let commonest = colors.chunk_by(|a, b| a == b).map(<[_]>::len).max().unwrap_or(0);
        let shown = colors.len() - commonest;
        if shown >= least {
            return Ok(());
        }
        Err(Broken::Undecided(format!(
            "expected {least} pixels or more that are not of the commonest color, as {} may be \
             off, found {shown}",
            self.edge_pixels
        )))
    }
}

/// What is shown as white: brighter pixels do not make darker ones matter less.
const WHITE: f64 = 1.0;

/// Nothing where the picture has two colors or more.
///
/// # Errors
/// That it has not.
fn says_something(picture: &LinearImage) -> Result<(), Broken> {
    let mut pairs = picture.pixels().windows(2);
    if pairs.any(|pair| pair[0] != pair[1]) {
        return Ok(());
    }
    Err(Broken::Undecided("expected two colors or more to compare, found one".to_owned()))
}

/// Whether every channel has the same bits, or is no farther off than `within`
/// of itself, or of `scale` if that is more, if it may be. A NaN is close to its
/// own bits only.
fn is_close(a: Rgb, b: Rgb, (within, scale): (f64, f64)) -> bool {
    let is_near = |a: f64, b: f64| (a - b).abs() <= within * scale.max(a.abs());
    let mut channels = a.channels().into_iter().zip(b.channels());
    channels.all(|(a, b)| a.to_bits() == b.to_bits() || (within > 0.0 && is_near(a, b)))
}

/// The largest size of any channel.
fn brightest(picture: &LinearImage) -> f64 {
    let channels = picture.pixels().iter().flat_map(|pixel| pixel.channels());
    channels.fold(0.0, |most, channel| channel.abs().max(most))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Size = Size { width: 20, height: 10 };

    /// A gray picture whose last ten pixels are black and whose first `off` are lighter
    /// by `by`.
    fn picture(off: usize, by: f64) -> LinearImage {
        let value = |i: usize| if i < off { 0.5 + by } else { 0.5 };
        let mut pixels: Vec<_> = (0..200).map(|i| Rgb::WHITE * value(i)).collect();
        pixels[190..].fill(Rgb::BLACK);
        LinearImage::from_pixels(SIZE, pixels).unwrap()
    }

    #[track_caller]
    fn check(alike: (f64, u32), off: (usize, f64), expected: Result<(), &str>) {
        let alike = Alike { within: alike.0, edge_pixels: alike.1 };
        let found = alike.compare(&picture(0, 0.0), &picture(off.0, off.1));
        assert_eq!(found.map_err(|broken| broken.to_string()), expected.map_err(str::to_owned));
    }

    #[test]
    fn pixels_are_off_by_no_more_than_is_said() {
        check((0.0, 0), (0, 0.0), Ok(()));
        let one = "pixel (0, 0): expected [0.5, 0.5, 0.5], found [0.75, 0.75, 0.75]; 1 of 200 \
                   pixels differ";
        check((0.0, 0), (1, 0.25), Err(one));
        check(
            (0.0, 0),
            (1, f64::EPSILON),
            Err("pixel (0, 0): expected [0.5, 0.5, 0.5], found [0.5000000000000002, \
             0.5000000000000002, 0.5000000000000002]; 1 of 200 pixels differ"),
        );
        // Relative to 0.5.
        check((1e-6, 0), (199, 0.4e-6), Ok(()));
        assert!(
            Alike { within: 1e-6, edge_pixels: 0 }
                .compare(&picture(0, 0.0), &picture(1, 0.6e-6))
                .is_err()
        );
        check((1e-6, 1), (1, 0.25), Ok(()));
        let two = "pixel (0, 0): expected [0.5, 0.5, 0.5], found [0.75, 0.75, 0.75]; 2 of 200 \
                   pixels differ, 1 may";
        check((1e-6, 1), (2, 0.25), Err(two));
        assert!(
            Alike { within: 1e-6, edge_pixels: 0 }
                .compare(&picture(0, 0.0), &picture(1, f64::NAN))
                .is_err()
        );
    }

    #[test]
    fn what_is_brighter_than_white_lets_nothing_else_be_off() {
        let lit = |glare: f64, value: f64| {
            LinearImage::from_fn(SIZE, |x, _| Rgb::WHITE * if x == 0 { glare } else { value })
        };
        let compare = |glare: f64, value: f64| {
            Alike { within: 1e-6, edge_pixels: 0 }.compare(&lit(glare, 0.5), &lit(glare, value))
        };
        assert_eq!(compare(1e13, 0.5), Ok(()));
        assert!(compare(1e13, 0.500_002).is_err());
        assert!(compare(0.5, 0.500_002).is_err());
        // The bright one itself is held to its own size.
        let alike = Alike { within: 1e-6, edge_pixels: 0 };
        assert_eq!(alike.compare(&lit(1e13, 0.5), &lit(1e13 + 1e6, 0.5)), Ok(()));
        assert!(alike.compare(&lit(1e13, 0.5), &lit(1e13 + 1e8, 0.5)).is_err());
    }

    #[test]
    fn what_is_shown_is_more_than_what_may_be_off() {
        let ball = |pixels: u32| {
            LinearImage::from_fn(SIZE, |x, y| {
                Rgb::WHITE * f64::from(u8::from(y == 0 && x < pixels))
            })
        };
        let compare = |pixels: u32, edge_pixels: u32| {
            Alike { within: 1e-6, edge_pixels }.compare(&ball(pixels), &ball(pixels))
        };
        assert_eq!(compare(1, 0), Ok(()));
        assert_eq!(compare(10, 1), Ok(()));
        assert!(!compare(9, 1).unwrap_err().differs());
    }

    #[test]
    fn the_place_is_counted_from_the_upper_left() {
        let spot = LinearImage::from_fn(SIZE, |x, y| {
            let value = if (x, y) == (7, 3) { 1.0 } else { 0.5 };
            if (x, y) == (19, 9) { Rgb::BLACK } else { Rgb::WHITE * value }
        });
        let said = Alike::BITS.compare(&picture(0, 0.0), &spot).unwrap_err().to_string();
        assert!(said.starts_with("pixel (7, 3): expected [0.5, "), "{said}");
        let other = LinearImage::from_fn(Size { width: 10, height: 20 }, |_, _| Rgb::BLACK);
        let said = Alike::BITS.compare(&other, &spot).unwrap_err();
        let size = "expected a picture of 10 x 20, found 20 x 10".to_owned();
        assert_eq!(said, Broken::Differs(size));
        let flat = LinearImage::from_fn(SIZE, |_, _| Rgb::WHITE);
        let said = Alike::BITS.compare(&flat, &flat).unwrap_err();
        let color = "expected two colors or more to compare, found one".to_owned();
        assert_eq!(said, Broken::Undecided(color));
    }

    #[test]
    fn what_would_allow_everything_is_a_problem() {
        let fields = |within, edge_pixels| {
            let problems = Alike { within, edge_pixels }.problems((40, 10));
            problems.into_iter().filter_map(|p| p.0).collect::<Vec<_>>()
        };
        assert_eq!(fields(LOOSEST, 2), [""; 0]);
        assert_eq!(fields(0.0, 0), [""; 0]);
        assert_eq!(fields(1e-5, 3), ["within", "edge_pixels"]);
        for never in [-1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(fields(never, 0), ["within"]);
        }
    }
}
