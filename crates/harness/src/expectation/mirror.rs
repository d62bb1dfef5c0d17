//! `Mirror`: the picture is its own mirror image.

use serde::{Deserialize, Serialize};

use super::{Expect, Rendered};

/// Every linear pixel has the very bits of its mirror image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Mirror {
    /// Left is right.
    LeftRight,
    /// Top is bottom.
    TopBottom,
}

impl Expect for Mirror {
    fn check(&self, picture: &Rendered) -> Result<(), String> {
        let size = picture.linear.size();
        for y in 0..size.height {
            for x in 0..size.width {
                let (mx, my) = match self {
                    Self::LeftRight => (size.width - 1 - x, y),
                    Self::TopBottom => (x, size.height - 1 - y),
                };
                let (one, other) = (picture.linear_at((x, y))?, picture.linear_at((mx, my))?);
                let bits = |c: tracer::Rgb| c.channels().map(f64::to_bits);
                if bits(one) != bits(other) {
                    return Err(format!(
                        "{self:?} mirror: pixels ({x}, {y}) and ({mx}, {my}): expected equal \
                         bits, found {:?} and {:?}",
                        one.channels(),
                        other.channels()
                    ));
                }
            }
        }
        Ok(())
    }

    fn problems(&self, (width, height): (u32, u32)) -> Vec<(&'static str, String)> {
        let (pixels, way) = match self {
            Self::LeftRight => (width, "wide"),
            Self::TopBottom => (height, "high"),
        };
        if pixels > 1 {
            return Vec::new();
        }
        let message = format!("`{self:?}`: expected a picture more than one pixel {way}");
        vec![("", message)]
    }
}
