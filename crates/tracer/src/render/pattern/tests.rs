//! Patterns: how evenly their samples are spread, counted.

use super::*;

fn points(sampler: Sampler, n: u32, pixel: (u32, u32)) -> Vec<[u32; 2]> {
    let samples = Samples::new(sampler, n).unwrap();
    (0..n).map(|k| scattered(samples, pixel, k)).collect()
}

/// Whether each of the `2^across` by `2^up` rectangles that halving the pixel
/// gives holds exactly one.
fn is_one_in_each(points: &[[u32; 2]], across: u32, up: u32) -> bool {
    // A shift by all bits: there is one column, or one row.
    let cell = |x: u32, bits: u32| x.checked_shr(32 - bits).unwrap_or(0);
    let mut held = vec![0; 1 << (across + up)];
    for [x, y] in points {
        held[(cell(*x, across) << up | cell(*y, up)) as usize] += 1;
    }
    held.iter().all(|count| *count == 1)
}

#[test]
fn every_elementary_interval_holds_one_point_of_sobol() {
    for (seed, pixel) in [(0, (0, 0)), (1, (0, 0)), (0, (5, 3)), (77, (16_383, 4_095))] {
        for m in 0..=12 {
            let points = points(Sampler::Sobol { seed }, 1 << m, pixel);
            for across in 0..=m {
                assert!(is_one_in_each(&points, across, m - across), "{seed} {pixel:?} {m}");
            }
        }
        // Every block of 2^m that the sequence is cut into is spread as well.
        let points = points(Sampler::Sobol { seed }, 4_096, pixel);
        for m in [1, 3, 6] {
            for block in points.chunks(1 << m) {
                assert!((0..=m).all(|across| is_one_in_each(block, across, m - across)));
            }
        }
    }
    let unlucky = points(Sampler::Stratified { seed: 0 }, 64, (0, 0));
    assert!(!is_one_in_each(&unlucky, 6, 0), "this test can fail");
}

#[test]
fn every_cell_holds_one_stratified_sample() {
    for side in [1_u32, 2, 3, 7, 10, 64] {
        let points = points(Sampler::Stratified { seed: 5 }, side * side, (3, 4));
        let cell = |part: u32| ((u64::from(part) * u64::from(side)) >> 32) as u32;
        for (k, [x, y]) in (0..).zip(points) {
            assert_eq!((cell(x), cell(y)), (k % side, k / side), "{side}");
        }
    }
    // The ends of cells that no power of two has.
    assert_eq!(in_cell(0, 3, u32::MAX), u32::MAX / 3);
    assert_eq!(in_cell(1, 3, 0), u32::MAX / 3 + 1);
    assert_eq!(in_cell(2, 3, u32::MAX), u32::MAX);
}

/// How a bit is turned below each of the `2^depth` prefixes, by this key: 1 or -1.
fn turns(depth: u32, key: u64) -> impl Iterator<Item = i32> {
    (0..1_u32 << depth).map(move |prefix| {
        let x = prefix.reverse_bits();
        let turned = (scrambled(x, key) ^ x) >> (31 - depth) & 1;
        2 * i32::from(turned == 1) - 1
    })
}

#[test]
fn scrambling_turns_bits_by_the_higher_ones_and_as_chance_would() {
    const KEYS: i32 = 4_000;
    for depth in 0..=5 {
        let nodes = 1_usize << depth;
        let mut sums = vec![0; nodes];
        let mut agreements = vec![0; nodes * nodes];
        for k in 0..KEYS {
            let turned: Vec<_> = turns(depth, mixed(9, k as u64)).collect();
            for (a, x) in turned.iter().enumerate() {
                sums[a] += x;
                for (b, y) in turned[..a].iter().enumerate() {
                    agreements[a * nodes + b] += x * y;
                }
            }
        }
        // Five standard deviations of a fair coin.
        let most = 5.0 * f64::from(KEYS).sqrt();
        assert!(sums.iter().chain(&agreements).all(|sum| f64::from(*sum).abs() < most), "{depth}");
    }
    // What is below a bit does not move it.
    for key in [0, 1, mixed(1, 2)] {
        for low in [0, 1, 0x5555, 0xffff] {
            let x = 0xabcd_0000;
            assert_eq!(scrambled(x, key) >> 16, scrambled(x | low, key) >> 16);
        }
    }
}

#[test]
fn pixels_and_seeds_scatter_otherwise() {
    for sampler in [|seed| Sampler::Stratified { seed }, |seed| Sampler::Sobol { seed }] {
        let one = points(sampler(0), 16, (4, 5));
        assert_eq!(one, points(sampler(0), 16, (4, 5)));
        for (seed, pixel) in [(1, (4, 5)), (0, (5, 4)), (0, (4, 6)), (0, (5, 5))] {
            assert_ne!(one, points(sampler(seed), 16, pixel));
        }
    }
}

#[test]
fn the_window_is_met_where_the_offset_says() {
    let (n, extent) = (7, 3.0);
    for pixel in 0..n {
        for part in [0, 1, 0x8000_0000, u32::MAX] {
            let offset = f64::from(part) / PARTS as f64 - 0.5;
            let expected = pixel_center(pixel, n, extent) + offset * extent / f64::from(n);
            assert!((at((pixel, n), part, extent) - expected).abs() < 1e-15);
        }
        assert_eq!(at((pixel, n), 0x8000_0000, extent), pixel_center(pixel, n, extent));
    }
}
