//! `Spot`: where in the picture a sample is, on the grid or scattered.
//!
//! What is scattered follows from the pixel and the seed alone, by hashing: not
//! from a thread, nor from what another pixel drew.

use super::samples::{Sampler, Samples};
use crate::fault::{Fault, seeded};
use crate::{Scene, Size, pixel_center};

/// Where a sample is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    /// The point of the view window that its ray goes through.
    pub(super) window: [f64; 2],
    /// How far right and up of its pixel's middle it is, in pixels.
    pub(super) offset: [f64; 2],
}

/// Parts of a pixel's width that scattered samples are told apart by: 2^32.
const PARTS: i64 = 1 << 32;

/// Where sample `k` of pixel `(i, j)` is, row 0 at the bottom. On a grid,
/// samples follow each other by rows, and mirrored ones are at exact negatives.
pub(super) fn spot(scene: &Scene, (i, j): (u32, u32), k: u32) -> Spot {
    let (Size { width, height }, camera) = (scene.size(), scene.camera());
    let extent = [camera.view_width(), camera.view_height()];
    let samples = scene.samples();
    if samples.sampler() == Sampler::Grid {
        let side = samples.side();
        let (column, row) = (k % side, k / side);
        return Spot {
            window: [
                pixel_center(i * side + column, width * side, extent[0]),
                pixel_center(j * side + row, height * side, extent[1]),
            ],
            offset: [column, row].map(|cell| pixel_center(cell, side, 1.0)),
        };
    }
    let [x, y] = scattered(samples, (i, j), k);
    Spot {
        window: [at((i, width), x, extent[0]), at((j, height), y, extent[1])],
        offset: [x, y].map(|part| (i64::from(part) - PARTS / 2) as f64 / PARTS as f64),
    }
}

/// Where on the window, from its middle, a part of one of `n` pixels begins.
/// Every number but the last is exact.
fn at((pixel, n): (u32, u32), part: u32, extent: f64) -> f64 {
    let all = i64::from(n) * PARTS;
    let here = i64::from(pixel) * PARTS + i64::from(part);
    extent * (2 * here - all) as f64 / (2 * all) as f64
}

/// Sample `k` of a pixel, in [`PARTS`] from its lower left corner.
fn scattered(samples: Samples, at: (u32, u32), k: u32) -> [u32; 2] {
    let (i, j) = if seeded(Fault::ScatteredAlike) { (0, 0) } else { at };
    let keys = |seed: u32| mixed(u64::from(i) << 32 | u64::from(j), mixed(0, seed.into()));
    match samples.sampler() {
        Sampler::Grid => [0, 0],
        Sampler::Stratified { seed } => {
            let drawn = mixed(keys(seed), k.into());
            let (side, cells) = (samples.side(), [k % samples.side(), k / samples.side()]);
            [in_cell(cells[0], side, drawn as u32), in_cell(cells[1], side, (drawn >> 32) as u32)]
        }
        Sampler::Sobol { seed } => {
            let [x, y] = sobol(k);
            let key = keys(seed);
            [scrambled(x, mixed(key, 0)), scrambled(y, mixed(key, 1))]
        }
    }
}

/// A part of cell number `cell` of `side`, by a number that was drawn.
fn in_cell(cell: u32, side: u32, drawn: u32) -> u32 {
    let first = |cell: u32| (u64::from(cell) << 32).div_ceil(side.into());
    let (lo, hi) = (first(cell), first(cell + 1));
    // Below `hi`, which is 2^32 at most.
    (lo + (((hi - lo) * u64::from(drawn)) >> 32)) as u32
}

/// Point `k` of Sobol's sequence in two dimensions, in [`PARTS`].
///
/// Source: Sobol', "On the distribution of points in a cube and the approximate
/// evaluation of integrals", 1967. The first dimension is the radical inverse;
/// the direction numbers of the second follow from the polynomial `x + 1`, each
/// from the one before by `v ^ (v >> 1)`.
fn sobol(k: u32) -> [u32; 2] {
    let mut direction = 1_u32 << (u32::BITS - 1);
    let (mut second, mut left) = (0, k);
    while left != 0 {
        if left & 1 == 1 {
            second ^= direction;
        }
        direction ^= direction >> 1;
        left >>= 1;
    }
    [k.reverse_bits(), second]
}

/// Owen's scrambling of one coordinate: each bit is turned or not depending on
/// all higher ones, which moves the halves, quarters and so on of the unit
/// interval among themselves, so that points keep how evenly they are spread.
///
/// Read from the lowest bit up, that is what sums, products by odd numbers and
/// additions of even multiples do; the tests measure that every turn is as
/// likely as not and that no two agree more than chance has it.
///
/// Source: Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995; that
/// arithmetic can do it: Laine and Karras, "Stratified sampling for stochastic
/// transparency", 2011, and Burley, "Practical hash-based Owen scrambling", 2020.
fn scrambled(x: u32, key: u64) -> u32 {
    /// The golden ratio's digits, made even, and others without a pattern.
    const EVEN: [u32; 2] = [0x9e37_79b8, 0x85eb_ca6a];
    let mut bits = x.reverse_bits();
    for (half, even) in [key as u32, (key >> 32) as u32].into_iter().zip(EVEN) {
        bits = bits.wrapping_add(half);
        bits ^= bits.wrapping_mul(even);
        bits = bits.wrapping_mul(half.rotate_left(16) | 1);
    }
    bits.reverse_bits()
}

/// A number that depends on every bit of both.
///
/// Source: Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", 2014: the state's step and the finalizer of `SplitMix`.
fn mixed(state: u64, number: u64) -> u64 {
    const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut z = state.wrapping_add((number.wrapping_add(1)).wrapping_mul(STEP));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests;
