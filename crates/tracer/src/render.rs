//! `render`: the lecture's two loops over the pixels, on all threads.

use rayon::prelude::*;

use crate::refused::refuse_unless;
use crate::{Interval, LinearImage, Refused, Rgb, Scene, Size, pixel_center};

/// A regular grid of samples in each pixel: `side` by `side`, each in the
/// middle of its cell. One sample is the lecture's pixel center.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SampleGrid {
    side: u32,
}

impl SampleGrid {
    /// One sample, in the middle of the pixel.
    pub const ONE: Self = Self { side: 1 };

    /// The most samples in a pixel.
    pub const MAX: u32 = 4_096;

    /// The grid of this many samples a pixel, a square number.
    ///
    /// # Errors
    /// Refuses (as `samples_per_pixel`) other numbers, 0, and absurdly many.
    pub fn new(samples_per_pixel: u32) -> Result<Self, Refused> {
        let side = samples_per_pixel.isqrt();
        let accepted =
            (1..=Self::MAX).contains(&samples_per_pixel) && side * side == samples_per_pixel;
        Refused::unless([refuse_unless(
            accepted,
            "samples_per_pixel",
            format!("a square number from 1 to {}, such as 1, 4, 9 or 16", Self::MAX),
            || samples_per_pixel.to_string(),
        )])?;
        Ok(Self { side })
    }

    /// How many samples a pixel has.
    pub fn samples_per_pixel(self) -> u32 {
        self.side * self.side
    }
}

/// Renders the scene. The picture's bits depend on the scene alone, not on
/// the number of threads; rows are shared out among those of rayon's current
/// pool.
pub fn render(scene: &Scene) -> LinearImage {
    let Size { width, height } = scene.size();
    let rows: Vec<Vec<Rgb>> = (0..height)
        .into_par_iter()
        .map(|y| {
            // The lecture's row 0 is the lowest, the picture's the highest.
            let j = height - 1 - y;
            (0..width).map(|i| pixel(scene, i, j)).collect()
        })
        .collect();
    LinearImage::from_fn(scene.size(), |x, y| rows[y as usize][x as usize])
}

/// The mean of the samples of pixel `(i, j)`, row 0 at the bottom.
fn pixel(scene: &Scene, i: u32, j: u32) -> Rgb {
    let Size { width, height } = scene.size();
    let SampleGrid { side } = scene.samples();
    let camera = scene.camera();
    let sum = mirrored_sum(side, |row| {
        let b = pixel_center(j * side + row, height * side, camera.view_height());
        mirrored_sum(side, |column| {
            let a = pixel_center(i * side + column, width * side, camera.view_width());
            scene.trace(&camera.ray(a, b), Interval::AHEAD)
        })
    });
    sum * (scene.exposure() / f64::from(side * side))
}

/// The sum of `term(0)` to `term(n - 1)`, taken from both ends inwards, so
/// that reversing the terms gives the same bits and a mirrored picture stays
/// an exact mirror.
fn mirrored_sum(n: u32, term: impl Fn(u32) -> Rgb) -> Rgb {
    let mut sum = Rgb::BLACK;
    for k in 0..n / 2 {
        sum += term(k) + term(n - 1 - k);
    }
    if n % 2 == 1 {
        sum += term(n / 2);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_square() {
        for (n, accepted) in [(0, false), (1, true), (2, false), (4, true), (4096, true)] {
            assert_eq!(SampleGrid::new(n).is_ok(), accepted, "{n}");
        }
        assert!(SampleGrid::new(4097).is_err() && SampleGrid::new(u32::MAX).is_err());
        assert_eq!(SampleGrid::new(9).unwrap().samples_per_pixel(), 9);
    }

    #[test]
    fn a_sum_of_reversed_terms_has_the_same_bits() {
        for n in [1_u32, 2, 3, 8, 9] {
            let term = |k: u32| Rgb::WHITE * (1.0 / f64::from(3 * k + 1));
            assert_eq!(mirrored_sum(n, term), mirrored_sum(n, |k| term(n - 1 - k)));
        }
    }
}
