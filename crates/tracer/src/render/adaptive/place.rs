//! `Place`: a part of a pixel, and where in it its sample is.

use crate::Scene;

/// Where a cell is: how often the pixel was halved, the column and the row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) level: u32,
    pub(super) x: u32,
    pub(super) y: u32,
}

/// Odd numbers that spread the bits of small ones, for each axis its own: with
/// one for both, samples would stay on the diagonals of their cells.
const SPREAD: [u32; 2] = [0x9e37_79b9, 0x85eb_ca6b];

impl Place {
    /// All of the pixel.
    pub(super) const PIXEL: Self = Self { level: 0, x: 0, y: 0 };

    /// All cells of one size, by rows from the lower left.
    pub(super) fn all(level: u32) -> impl Iterator<Item = Self> {
        let side = 0..1 << level;
        side.clone().flat_map(move |y| side.clone().map(move |x| Self { level, x, y }))
    }

    /// A quarter: 0 to 3 are lower left, lower right, upper left, upper right.
    pub(super) fn quarter(self, part: u32) -> Self {
        let Self { level, x, y } = self;
        Self { level: level + 1, x: 2 * x + part % 2, y: 2 * y + part / 2 }
    }

    /// How many cells of this size are side by side in a pixel.
    pub(super) fn count(self) -> u32 {
        1 << self.level
    }

    /// Its part of the pixel.
    pub(super) fn area(self) -> f64 {
        1.0 / f64::from(self.count() * self.count())
    }

    /// Where it begins and ends to the right and up of the pixel's middle, in
    /// pixels.
    pub(super) fn sides(self) -> ([f64; 2], [f64; 2]) {
        let size = 1.0 / f64::from(self.count());
        let sides = |cell: u32| [cell, cell + 1].map(|k| f64::from(k) * size - 0.5);
        (sides(self.x), sides(self.y))
    }

    /// The cell so many to the right and up, if that is in the pixel.
    pub(super) fn beside(self, (right, up): (i32, i32)) -> Option<Self> {
        let inside = |k: &u32| *k < self.count();
        let x = self.x.checked_add_signed(right).filter(inside)?;
        let y = self.y.checked_add_signed(up).filter(inside)?;
        Some(Self { x, y, ..self })
    }

    /// The ways from it to the pixels beside its own that it touches.
    pub(super) fn ways_out(self) -> impl Iterator<Item = (i32, i32)> {
        let last = self.count() - 1;
        let ends = move |k: u32| (-i32::from(k == 0))..=i32::from(k == last);
        let ways = ends(self.x).flat_map(move |right| ends(self.y).map(move |up| (right, up)));
        ways.filter(|way| *way != (0, 0))
    }

    /// The point of the window that its sample is at, in this pixel.
    pub(super) fn window(self, scene: &Scene, (i, j): (u32, u32)) -> [f64; 2] {
        let Self { level, x, y } = self;
        let (size, camera) = (scene.size(), scene.camera());
        let right = in_cell(level, x, y, SPREAD[0]);
        let up = in_cell(level, y, x, SPREAD[1]);
        [
            window_coordinate((i, size.width), (level, x, right), camera.view_width()),
            window_coordinate((j, size.height), (level, y, up), camera.view_height()),
        ]
    }
}

/// Where on the window, from its middle, a sample is: in one of `n` pixels, one
/// of its `2^level` cells, and so many parts of `2^(level + 1)` into that.
/// Like [`crate::pixel_center`], with an exact negative on the other side.
fn window_coordinate(
    (pixel, n): (u32, u32),
    (level, cell, part): (u32, u32, u32),
    extent: f64,
) -> f64 {
    let (cells, parts) = (1_i64 << level, 2_i64 << level);
    let all = i64::from(n) * cells * parts;
    let here = (i64::from(pixel) * cells + i64::from(cell)) * parts + i64::from(part);
    extent * (2 * here - all) as f64 / (2 * all) as f64
}

/// How many parts of `2^(level + 1)` into its cell a sample is along one axis,
/// if the cell is number `along` of that axis and `across` of the other.
///
/// Along a row or column of a pixel's cells every such place in a half comes
/// once: the radical inverse of the place from the pixel's middle, its bits
/// turned in another way for each row. Mirrored cells have mirrored samples.
///
/// Source: for the radical inverse turned by a bit-wise exclusive or, Kollig and
/// Keller, "Efficient Multidimensional Sampling", 2002.
fn in_cell(level: u32, along: u32, across: u32, spread: u32) -> u32 {
    let (cells, parts) = (1_u32 << level, 2_u32 << level);
    let half = cells / 2;
    if half == 0 {
        return parts / 2;
    }
    let from_middle = |k: u32| if k < half { half - 1 - k } else { k - half };
    // As many bits as it takes to number half of the cells.
    let bits = level - 1;
    let reversed = |k: u32| k.reverse_bits().checked_shr(32 - bits).unwrap_or(0);
    let turn = from_middle(along).wrapping_mul(spread).checked_shr(32 - bits).unwrap_or(0);
    // Of 2^level places for a sample in half of the parts, the middle one.
    let part = 4 * reversed(from_middle(across) ^ turn) + 2;
    if along < half { part } else { parts - part }
}
