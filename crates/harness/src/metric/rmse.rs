//! Root mean square error: how far apart, seen as the energy of the difference.
//!
//! The peak signal-to-noise ratio is the same number on a logarithmic scale.

use super::{Direction, Metric, Pair};

pub(super) const RMSE: Metric = Metric {
    name: "rmse",
    measures: "the root of the mean squared difference over all channels",
    range: "0 to 255",
    unit: "codes",
    direction: Direction::LowerIsBetter,
    blind_spot: "damage to few pixels of a large picture; where it is, and its shape",
    limit: None,
    value: |comparison| Some(comparison.rmse),
};

pub(super) const PSNR: Metric = Metric {
    name: "psnr_db",
    measures: "the energy of a full-scale signal over that of the difference",
    range: "none for identical pictures, else from 0 up",
    unit: "dB",
    direction: Direction::HigherIsBetter,
    blind_spot: "what rmse is blind to",
    limit: None,
    value: |comparison| comparison.psnr_db,
};

/// The energy of the difference of two pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rmse {
    /// Root of the mean squared difference over all channels of all pixels, in
    /// codes from 0 to 255. The mean is of whole numbers summed exactly.
    pub rmse: f64,
    /// `20 log10(255 / rmse)` in decibels; `None` for identical pictures,
    /// where it has no finite value.
    pub psnr_db: Option<f64>,
}

/// The energy of the difference. Swapping the pictures changes nothing.
pub fn rmse(pair: &Pair<'_>) -> Rmse {
    let squares: u64 = pair.pixels().map(|(a, b)| u64::from(squared(a, b))).sum();
    let mean = squares as f64 / pair.golden().bytes().len() as f64;
    let peak = f64::from(u8::MAX);
    Rmse {
        rmse: mean.sqrt(),
        psnr_db: (0 < squares).then(|| 10.0 * libm::log10(peak * peak / mean)),
    }
}

fn squared(a: [u8; 3], b: [u8; 3]) -> u32 {
    let [r, g, b] = [0, 1, 2].map(|c| u32::from(a[c].abs_diff(b[c])).pow(2));
    r + g + b
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::encode::EncodedImage;
    use tracer::Size;

    #[track_caller]
    fn check(golden: &[u8], actual: &[u8], expected: f64, psnr_db: Option<f64>) {
        let size = Size { width: golden.len() as u32 / 3, height: 1 };
        let image = |bytes: &[u8]| EncodedImage::from_bytes(size, bytes.to_vec()).unwrap();
        let (golden, actual) = (image(golden), image(actual));
        let found = rmse(&Pair::new(&golden, &actual).unwrap());
        assert_eq!(found, rmse(&Pair::new(&actual, &golden).unwrap()));
        assert_eq!(found.rmse, expected);
        let round = |db: f64| (db * 1e4).round();
        assert_eq!(found.psnr_db.map(round), psnr_db.map(round));
    }

    #[test]
    fn known_values() {
        check(&[0; 3], &[255; 3], 255.0, Some(0.0));
        check(&[5; 6], &[5; 6], 0.0, None);
        // One channel of three off by 3: sqrt(9 / 3).
        check(&[10, 10, 10], &[10, 13, 10], 3.0_f64.sqrt(), Some(43.3596));
        // One code everywhere: 20 log10(255).
        check(&[10; 9], &[11; 9], 1.0, Some(48.1308));
    }
}
