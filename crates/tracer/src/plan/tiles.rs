//! `Tiles`: which squares of the picture may show which members of the scene.

use crate::camera::Seen;
use crate::fault::{Fault, seeded};
use crate::{Camera, Size};

/// Width and height of a tile in pixels; those at the right and at the top may
/// be smaller.
pub(super) const SIDE: u32 = 8;

/// Members of the scene's outermost group: a bit for each, the last one for all
/// from there on.
pub(super) type Members = u64;

/// The bit of a member.
pub(super) fn bit_of(member: usize) -> Members {
    if member < Members::BITS as usize - 1 { 1 << member } else { REST }
}

/// The bit of all members that have none of their own.
pub(super) const REST: Members = 1 << (Members::BITS - 1);

/// For each tile who may be seen in it; row 0 is the lowest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tiles {
    columns: u32,
    rows: u32,
    /// Those that are seen in every tile, and so need not be marked in each.
    everywhere: Members,
    seen: Vec<Members>,
}

impl Tiles {
    /// Every tile shows these.
    pub(super) fn all(size: Size, seen: Members) -> Self {
        let (columns, rows) = (size.width.div_ceil(SIDE), size.height.div_ceil(SIDE));
        Self { columns, rows, everywhere: seen, seen: vec![0; columns as usize * rows as usize] }
    }

    /// Marks where a member is seen.
    pub(super) fn mark(&mut self, camera: &Camera, size: Size, member: Members, seen: Seen) {
        /// In pixels, for what is seen on the border of one.
        const MARGIN: f64 = 0.01;
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        if self.everywhere & member != 0 {
            return;
        }
        match seen {
            Seen::Nowhere => {}
            Seen::Everywhere => self.everywhere |= member,
            Seen::Between { a, b } => {
                let tiles = |[lo, hi]: [f64; 2], extent: f64, pixels: f64, count: u32| {
                    let tile = |x: f64| (x / extent + 0.5) * pixels;
                    let side = f64::from(SIDE);
                    let first = ((tile(lo) - MARGIN) / side).floor().max(0.0);
                    let last = ((tile(hi) + MARGIN) / side).floor().min(f64::from(count) - 1.0);
                    // Beyond the picture there is none: the casts saturate.
                    if first <= last { first as u32..last as u32 + 1 } else { 0..0 }
                };
                let mut columns = tiles(a, camera.view_width(), width, self.columns);
                if seeded(Fault::TileLost) {
                    columns.end = columns.end.saturating_sub(1);
                }
                for row in tiles(b, camera.view_height(), height, self.rows) {
                    for column in columns.clone() {
                        self.seen[(row * self.columns + column) as usize] |= member;
                    }
                }
            }
            Seen::HalfPlane([c, x, y]) => {
                let at = |tile: u32, pixels: f64, extent: f64| {
                    (f64::from(tile * SIDE) / pixels - 0.5) * extent
                };
                for row in 0..self.rows {
                    for column in 0..self.columns {
                        // A linear function is highest at a corner.
                        let is_seen = [0, 1].iter().any(|right| {
                            [0, 1].iter().any(|up| {
                                let a = at(column + right, width, camera.view_width());
                                let b = at(row + up, height, camera.view_height());
                                c + a * x + b * y > 0.0
                            })
                        });
                        if is_seen {
                            self.seen[(row * self.columns + column) as usize] |= member;
                        }
                    }
                }
            }
        }
    }

    /// Who may be seen in pixel `(i, j)`, row 0 at the bottom.
    pub(super) fn seen_in(&self, i: u32, j: u32) -> Members {
        self.everywhere | self.seen[(j / SIDE * self.columns + i / SIDE) as usize]
    }

    /// How many show anything, and how many there are.
    pub(super) fn counts(&self) -> (usize, usize) {
        let seen = self.seen.iter().filter(|seen| **seen | self.everywhere != 0);
        (seen.count(), self.seen.len())
    }
}
