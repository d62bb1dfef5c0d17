//! What works on whole pictures: metrics, encoding, PNG.

use harness::encode::{Transfer, encode};
use harness::golden;
use harness::metric::{Pair, compare, difference, flip, image_compare, rmse, ssim, ssim_uniform};

use super::Throughput;
use crate::inputs;
use crate::measure::{Effort, Pass, in_turns};

/// A side of the pictures, in pixels.
const SIDE: u32 = 512;

const EFFORT: Effort = Effort { rounds: 7, turn: 0.02 };

/// Pixels of a million.
const MILLION: f64 = 1e6;

/// Each on one thread, in turns.
pub(super) fn measure() -> Result<Vec<Throughput>, String> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.map_err(|error| error.to_string())?;
    pool.install(|| of_side(SIDE, EFFORT))
}

fn of_side(side: u32, effort: Effort) -> Result<Vec<Throughput>, String> {
    let [golden, actual] = inputs::unlike_pictures(side, side);
    let same = golden.clone();
    let linear = inputs::linear_picture(side, side);
    let png = golden::to_png(&golden, None)?;
    let pair = Pair::new(&golden, &actual).ok_or("the generated pictures have no pixels")?;
    let compared = |a, b| compare(a, b).map_or(0.0, |found| found.rmse + 1.0);
    let encoded =
        |transfer| encode(&linear, transfer).map_or(0.0, |picture| f64::from(picture.bytes()[0]));
    let mut contestants: Vec<(&str, Pass<'_>)> = vec![
        ("compare, identical", Box::new(|| compared(&golden, &same))),
        ("compare, every metric", Box::new(|| compared(&golden, &actual))),
        ("difference", Box::new(|| f64::from(difference(&pair).max_abs))),
        ("ssim", Box::new(|| ssim(&pair).mean)),
        ("ssim, uniform window", Box::new(|| ssim_uniform(&pair).mean)),
        ("flip", Box::new(|| flip(&pair).mean)),
        ("rmse, psnr", Box::new(|| rmse(&pair).rmse)),
        ("image-compare's two", Box::new(|| image_compare(&pair).mssim.unwrap_or_default())),
        ("encode, gamma 2.2", Box::new(|| encoded(Transfer::Gamma22))),
        ("encode, sRGB", Box::new(|| encoded(Transfer::Srgb))),
        (
            "decode PNG",
            Box::new(|| {
                let found = golden::from_png(&png);
                found.map_or(0.0, |golden| f64::from(golden.picture.bytes()[1]))
            }),
        ),
        (
            "write PNG",
            Box::new(|| golden::to_png(&golden, None).map_or(0.0, |png| png.len() as f64)),
        ),
    ];
    let names: Vec<_> = contestants.iter().map(|(name, _)| (*name).to_owned()).collect();
    let mut passes: Vec<_> = contestants.drain(..).map(|(_, pass)| pass).collect();
    let times = in_turns(&mut passes, effort);
    let mpix = f64::from(side) * f64::from(side) / MILLION;
    let row = |(name, time): (String, crate::measure::Spread)| Throughput {
        name,
        mpix_s: time.rate(mpix),
    };
    Ok(names.into_iter().zip(times).map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_works_on_pictures_is_timed() {
        let rows = of_side(48, Effort { rounds: 3, turn: 0.0 }).unwrap();
        assert_eq!(rows.len(), 12);
        assert!(rows.iter().all(|row| row.mpix_s.median > 0.0), "{rows:?}");
        let of = |name: &str| rows.iter().find(|row| row.name == name).unwrap().mpix_s.median;
        assert!(of("compare, identical") > of("compare, every metric"));
    }
}
