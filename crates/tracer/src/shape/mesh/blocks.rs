//! `Blocks`: a mesh's triangles, four to a block, as a leaf of its hierarchy
//! holds them against a ray.

use glam::DVec3;
use rayon::prelude::*;

use super::precision::Precision;
use crate::accel::wide::Span;
use crate::simd::Simd;

/// How many triangles a block has room for.
pub(super) const LANES: usize = 4;

/// The number of a lane without a triangle.
pub(super) const NOBODY: u32 = u32::MAX;

/// Blocks are made by this many at a time.
const CHUNK: usize = 256;

/// Where a mesh's triangles are.
#[derive(Clone, Copy)]
pub(super) struct Corners<'a> {
    pub(super) vertices: &'a [DVec3],
    pub(super) faces: &'a [[u32; 3]],
}

impl Corners<'_> {
    /// The corners of one.
    #[inline(always)]
    pub(super) fn of(self, number: u32) -> [DVec3; 3] {
        let [a, b, c] = self.faces[number as usize];
        [self.vertices[a as usize], self.vertices[b as usize], self.vertices[c as usize]]
    }
}

/// Up to four triangles, side by side.
#[derive(Debug, Clone, PartialEq)]
#[repr(align(32))]
pub(super) struct Block<T> {
    /// For each corner and axis the coordinates; infinite, which no ray meets,
    /// where there is no triangle.
    pub(super) corners: [[[T; LANES]; 3]; 3],
    /// The triangles' numbers in the mesh.
    pub(super) numbers: [u32; LANES],
}

/// A number that corners are stored as.
pub(super) trait Number: Copy + Into<f64> + Send {
    /// Stands for no triangle.
    const NOWHERE: Self;
    /// The number, rounded.
    fn rounded(x: f64) -> Self;
    /// Four of them, ready to compute with.
    fn load<S: Simd, P: Precision>(simd: S, four: &[Self; LANES]) -> P::Lanes<S>;
}

impl Number for f32 {
    const NOWHERE: Self = Self::INFINITY;
    fn rounded(x: f64) -> Self {
        x as Self
    }
    #[inline(always)]
    fn load<S: Simd, P: Precision>(simd: S, four: &[Self; LANES]) -> P::Lanes<S> {
        P::singles(simd, four)
    }
}

impl Number for f64 {
    const NOWHERE: Self = Self::INFINITY;
    fn rounded(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn load<S: Simd, P: Precision>(simd: S, four: &[Self; LANES]) -> P::Lanes<S> {
        P::doubles(simd, four)
    }
}

impl<T: Number> Block<T> {
    /// The triangles of these numbers.
    fn new(numbers: &[u32], corners: Corners<'_>) -> Self {
        let mut block = Self { corners: [[[T::NOWHERE; LANES]; 3]; 3], numbers: [NOBODY; LANES] };
        for (lane, &number) in numbers.iter().enumerate().take(LANES) {
            block.numbers[lane] = number;
            let [a, b, c] = corners.of(number);
            for (stored, corner) in block.corners.iter_mut().zip([a, b, c]) {
                stored[0][lane] = T::rounded(corner.x);
                stored[1][lane] = T::rounded(corner.y);
                stored[2][lane] = T::rounded(corner.z);
            }
        }
        block
    }

    /// The corners of the triangle in a lane.
    #[inline(always)]
    pub(super) fn triangle(&self, lane: usize) -> [DVec3; 3] {
        let [a, b, c] = &self.corners;
        [corner(a, lane), corner(b, lane), corner(c, lane)]
    }

    /// How many triangles there are.
    #[inline(always)]
    pub(super) fn count(&self) -> usize {
        self.numbers.iter().filter(|&&number| number != NOBODY).count()
    }
}

/// The corner in a lane.
#[inline(always)]
fn corner<T: Number>([x, y, z]: &[[T; LANES]; 3], lane: usize) -> DVec3 {
    let lane = lane % LANES;
    DVec3::new(x[lane].into(), y[lane].into(), z[lane].into())
}

/// All triangles of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Blocks {
    /// Every coordinate is a number of `f32`, or was rounded to one.
    Single(Vec<Block<f32>>),
    /// Some need `f64`.
    Double(Vec<Block<f64>>),
}

impl Blocks {
    /// A block for each of these leaves, stored in `f32` or not.
    pub(super) fn new(
        leaves: &[Span],
        items: &[u32],
        corners: Corners<'_>,
        are_single: bool,
    ) -> Self {
        fn all<T: Number>(leaves: &[Span], items: &[u32], corners: Corners<'_>) -> Vec<Block<T>> {
            let leaves = leaves.par_iter().with_min_len(CHUNK);
            leaves.map(|leaf| Block::new(leaf.of(items), corners)).collect()
        }
        if are_single {
            Self::Single(all(leaves, items, corners))
        } else {
            Self::Double(all(leaves, items, corners))
        }
    }

    /// How many blocks there are.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Single(blocks) => blocks.len(),
            Self::Double(blocks) => blocks.len(),
        }
    }

    /// The numbers of a block's triangles.
    pub(super) fn numbers(&self, block: usize) -> [u32; LANES] {
        match self {
            Self::Single(blocks) => blocks[block].numbers,
            Self::Double(blocks) => blocks[block].numbers,
        }
    }

    /// The corners of the triangle at a place: four times its block, plus its
    /// lane.
    pub(super) fn triangle(&self, place: u32) -> [DVec3; 3] {
        let (block, lane) = (place as usize / LANES, place as usize % LANES);
        match self {
            Self::Single(blocks) => blocks[block].triangle(lane),
            Self::Double(blocks) => blocks[block].triangle(lane),
        }
    }

    /// How many bytes they take.
    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::Single(blocks) => size_of_val(blocks.as_slice()),
            Self::Double(blocks) => size_of_val(blocks.as_slice()),
        }
    }
}
