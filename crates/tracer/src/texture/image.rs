//! `Image`: a picture as a texture, between whose texels colors are looked up.

use std::sync::Arc;

use crate::fault::{Fault, seeded};
use crate::refused::{not_negative, refuse_unless};
use crate::{Refused, Rgb, Size};

/// The texels of a picture, as the codes that a file stores and the linear value
/// of each code. It takes six bytes a texel, and loses nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct Texels {
    size: Size,
    codes: Vec<[u16; 3]>,
    levels: Vec<f64>,
}

impl Texels {
    /// The largest width and height.
    pub const MAX_SIDE: u32 = 16_384;

    /// The largest number of texels.
    pub const MAX_TEXELS: u64 = 1 << 24;

    /// A picture of these codes, row by row from the top, each channel of which
    /// stands for the linear value at its place among the `levels`.
    ///
    /// # Errors
    /// Refuses (as `size`) a picture without texels or with too many, (as
    /// `codes`) another number of them and codes without a level, and (as
    /// `levels`) one that is negative or not finite.
    pub fn new(size: Size, codes: Vec<[u16; 3]>, levels: Vec<f64>) -> Result<Self, Refused> {
        let Size { width, height } = size;
        let count = u64::from(width) * u64::from(height);
        let sides = 1..=Self::MAX_SIDE;
        let highest = codes.as_flattened().iter().copied().max();
        Refused::unless([
            refuse_unless(
                sides.contains(&width) && sides.contains(&height) && count <= Self::MAX_TEXELS,
                "size",
                format!(
                    "a width and height from 1 to {} and at most {} texels in all",
                    Self::MAX_SIDE,
                    Self::MAX_TEXELS
                ),
                || format!("{width} x {height}"),
            ),
            refuse_unless(codes.len() as u64 == count, "codes", format!("{count} texels"), || {
                codes.len().to_string()
            }),
            refuse_unless(
                highest.is_none_or(|code| usize::from(code) < levels.len()),
                "codes",
                format!("codes below {}", levels.len()),
                || highest.map_or("none".into(), |code| code.to_string()),
            ),
            levels.iter().find_map(|&level| not_negative("levels", level)),
        ])?;
        Ok(Self { size, codes, levels })
    }

    /// How many texels there are, to the right and up.
    pub fn size(&self) -> Size {
        self.size
    }

    /// The texel in this column and row, row 0 at the bottom.
    fn get(&self, column: usize, row: usize) -> Rgb {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let code = self.codes[(height - 1 - row) * width + column];
        Rgb::from(code.map(|code| self.levels[usize::from(code)]))
    }
}

/// What is seen between the middles of texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TexelFilter {
    /// The texel that the place is in.
    Nearest,
    /// The four around, by how near their middles are.
    #[default]
    Bilinear,
}

/// What is seen beyond the picture's borders.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Wrap {
    /// The picture again.
    #[default]
    Repeat,
    /// The texel at the border.
    Clamp,
}

/// A picture over `u` and `v` from 0 to 1: `u = 0` is its left side and `v = 0`
/// its lower one, as in OBJ files (of glTF, `v` goes down). The middle of
/// texel `i` of `n` is at `(i + 0.5) / n`.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    texels: Arc<Texels>,
    filter: TexelFilter,
    wrap: Wrap,
}

impl Image {
    /// A picture, seen like this between and beyond its texels. Textures may
    /// share one.
    pub fn new(texels: Arc<Texels>, filter: TexelFilter, wrap: Wrap) -> Self {
        Self { texels, filter, wrap }
    }

    /// The color at `(u, v)`, and the texel's number from 1, or 0 where it is mixed
    /// of several.
    pub(super) fn look_up(&self, [u, v]: [f64; 2]) -> (Rgb, u32) {
        let Size { width, height } = self.texels.size;
        let (x, y) = (u * f64::from(width), v * f64::from(height));
        let shift = if seeded(Fault::TexelHalfShift) { 0.5 } else { 0.0 };
        match self.filter {
            TexelFilter::Nearest => {
                let [x, y] = [x + shift, y + shift].map(f64::floor);
                let (column, row) = (self.index(x, width), self.index(y, height));
                let number = row * width as usize + column;
                (self.texels.get(column, row), 1 + number as u32)
            }
            TexelFilter::Bilinear => {
                let ([left, right], across) = self.pair(x - 0.5 + shift, width);
                let ([low, high], up) = self.pair(y - 0.5 + shift, height);
                let row =
                    |row| mixed(self.texels.get(left, row), self.texels.get(right, row), across);
                (mixed(row(low), row(high), up), 0)
            }
        }
    }

    /// The two texels whose middles are around `x`, which is 0 in the first one's
    /// middle, and the weight of the second.
    fn pair(&self, x: f64, count: u32) -> ([usize; 2], f64) {
        let first = x.floor();
        ([self.index(first, count), self.index(first + 1.0, count)], x - first)
    }

    /// The texel of this whole number among so many.
    fn index(&self, number: f64, count: u32) -> usize {
        let last = f64::from(count - 1);
        let wrapped = match self.wrap {
            Wrap::Repeat if seeded(Fault::WrapOffByOne) => number.rem_euclid(last.max(1.0)),
            // Exact, as both are whole.
            Wrap::Repeat => number.rem_euclid(f64::from(count)),
            Wrap::Clamp if seeded(Fault::WrapOffByOne) => number.clamp(0.0, (last - 1.0).max(0.0)),
            Wrap::Clamp => number.clamp(0.0, last),
        };
        wrapped as usize
    }
}

/// `a` and `b` by the weight of `b`.
fn mixed(a: Rgb, b: Rgb, weight: f64) -> Rgb {
    a * (1.0 - weight) + b * weight
}

#[cfg(test)]
mod tests;
