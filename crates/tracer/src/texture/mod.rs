//! `Texture`: the color of a surface from place to place, by texture
//! coordinates `(u, v)`.
//!
//! It promises a color of finite channels, none negative, for any finite `u`
//! and `v`, with the same bits everywhere.
//!
//! What `u` and `v` are is the shape's to say ([`crate::shape::Geometry::uv`]).
//! They are of the object's own space: what a group does to the object moves its
//! texture along.

mod checker;
mod image;

pub use checker::Checker;
pub use image::{Image, TexelFilter, Texels, Wrap};

use crate::fault::{Fault, seeded};
use crate::refused::{MAX_LENGTH, MIN_LENGTH, refuse_unless};
use crate::{Refused, Rgb};

/// A pattern laid onto texture coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    pattern: Pattern,
    scale: [f64; 2],
    offset: [f64; 2],
}

/// What a texture shows.
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// Two colors by turns.
    Checker(Checker),
    /// A picture.
    Image(Image),
}

impl Texture {
    /// The pattern at `(scale[0] u + offset[0], scale[1] v + offset[1])`. A larger
    /// scale makes it smaller; a negative one mirrors it: `[1, -1]` with
    /// the offset `[0, 1]` turns an image upside down.
    ///
    /// # Errors
    /// Refuses (as `scale`) factors that are zero or not finite, and (as `offset`)
    /// numbers that are not finite.
    pub fn new(pattern: Pattern, scale: [f64; 2], offset: [f64; 2]) -> Result<Self, Refused> {
        let is_factor = |x: &f64| (MIN_LENGTH..=MAX_LENGTH).contains(&x.abs());
        Refused::unless([
            refuse_unless(
                scale.iter().all(is_factor),
                "scale",
                "two finite numbers, neither of them 0",
                || format!("{scale:?}"),
            ),
            refuse_unless(
                offset.iter().all(|x| x.abs() <= MAX_LENGTH),
                "offset",
                format!("two finite numbers of at most {MAX_LENGTH:e}"),
                || format!("{offset:?}"),
            ),
        ])?;
        Ok(Self { pattern, scale, offset })
    }

    /// The color at these texture coordinates.
    pub fn color(&self, uv: [f64; 2]) -> Rgb {
        self.look_up(uv).0
    }

    /// The color at these texture coordinates, and which part of the pattern has
    /// it, if colors change at once from part to part; else 0.
    pub(crate) fn look_up(&self, [u, v]: [f64; 2]) -> (Rgb, u32) {
        let u = if seeded(Fault::TextureUMirrored) { 1.0 - u } else { u };
        let v = if seeded(Fault::TextureVFlipped) { 1.0 - v } else { v };
        let place = [self.scale[0] * u + self.offset[0], self.scale[1] * v + self.offset[1]];
        match &self.pattern {
            Pattern::Checker(checker) => checker.look_up(place),
            Pattern::Image(image) => image.look_up(place),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLORS: [Rgb; 2] = [Rgb::WHITE, Rgb::BLACK];

    fn checker(scale: [f64; 2], offset: [f64; 2]) -> Result<Texture, Refused> {
        Texture::new(Pattern::Checker(Checker::new(COLORS)?), scale, offset)
    }

    #[track_caller]
    fn check(scale: [f64; 2], offset: [f64; 2], uv: [f64; 2], expected: Rgb) {
        assert_eq!(checker(scale, offset).unwrap().color(uv), expected);
    }

    #[test]
    fn coordinates_are_scaled_then_moved() {
        check([2.0, 1.0], [0.0, 0.0], [0.6, 0.5], Rgb::BLACK);
        check([2.0, 1.0], [1.0, 0.0], [0.6, 0.5], Rgb::WHITE);
        check([1.0, 3.0], [0.0, 0.0], [0.5, 0.4], Rgb::BLACK);
        check([1.0, -1.0], [0.0, 1.0], [0.5, 0.4], Rgb::WHITE);
        check([1.0, -1.0], [0.0, 0.0], [0.5, 0.4], Rgb::BLACK);
    }

    #[test]
    fn absurd_places_have_a_color() {
        check([1e60, 1e60], [1e60, -1e60], [1e60, -1e60], Rgb::WHITE);
        check([1e-60, 1.0], [0.0, 0.0], [-5e-324, 0.0], Rgb::WHITE);
    }

    #[test]
    fn bad_layouts_are_refused() {
        for (scale, offset, expected) in [
            ([0.0, 1.0], [0.0, 0.0], 1),
            ([1.0, f64::NAN], [0.0, f64::INFINITY], 2),
            ([1.0, -1e-61], [0.0, 0.0], 1),
            ([1.0, 1.0], [-1e61, 0.0], 1),
        ] {
            let refused = checker(scale, offset).unwrap_err();
            assert_eq!(refused.refusals().len(), expected, "{refused}");
        }
    }
}
