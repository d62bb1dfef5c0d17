//! What is known of a picture on paper, checked beside its golden.
//!
//! A golden says that nothing changed; an expectation says that it is right.
//! Pixels are counted as in the picture: `x` from the left, `y` from the top,
//! both from 0.
//!
//! To add one: write its file, add its line to `expectations!` below.

mod count;
mod mirror;
mod pixel;
mod radiance;
mod ratio;

pub use count::Count;
pub use mirror::Mirror;
pub use pixel::Pixel;
pub use radiance::Radiance;
pub use ratio::Ratio;

use serde::{Deserialize, Serialize};
use tracer::{LinearImage, Rgb};

use crate::encode::EncodedImage;

/// Column and row of a pixel.
pub type At = (u32, u32);

/// A rendered picture, before and after encoding.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendered {
    /// Linear radiance.
    pub linear: LinearImage,
    /// What is compared with the golden.
    pub encoded: EncodedImage,
}

impl Rendered {
    /// The linear pixel.
    ///
    /// # Errors
    /// Where it is outside the picture.
    fn linear_at(&self, (x, y): At) -> Result<Rgb, String> {
        self.linear.get(x, y).ok_or_else(|| format!("pixel ({x}, {y}) is outside the picture"))
    }
}

/// What every expectation can say.
trait Expect {
    /// Whether the picture is as expected.
    ///
    /// # Errors
    /// What was expected and what was found.
    fn check(&self, picture: &Rendered) -> Result<(), String>;

    /// The pixels it names, by field.
    fn pixels(&self) -> Vec<(&'static str, At)> {
        Vec::new()
    }

    /// What makes no sense in it for a picture of this size, by field.
    fn problems(&self, image: (u32, u32)) -> Vec<(&'static str, String)> {
        let _ = image;
        Vec::new()
    }
}

/// Makes the enum of all expectations and its dispatch from one list.
macro_rules! expectations {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// Any expectation.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields)]
        pub enum Expectation {
            $($(#[$doc])* $name($name),)*
        }

        impl Expectation {
            fn inner(&self) -> &dyn Expect {
                match self { $(Self::$name(inner) => inner,)* }
            }

            /// Its name in a fixture.
            pub fn name(&self) -> &'static str {
                match self { $(Self::$name(_) => stringify!($name),)* }
            }
        }
    };
}

expectations! {
    /// A pixel's 8-bit color.
    Pixel,
    /// A pixel's linear value.
    Radiance,
    /// How many pixels have an 8-bit color.
    Count,
    /// The picture is its own mirror image.
    Mirror,
    /// How many times brighter one pixel is than another.
    Ratio,
}

impl Expectation {
    /// Whether the picture is as expected.
    ///
    /// # Errors
    /// What was expected and what was found, in one sentence.
    pub fn check(&self, picture: &Rendered) -> Result<(), String> {
        self.inner().check(picture)
    }

    /// What makes no sense in it for a picture of this size, by field.
    pub(crate) fn problems(&self, (width, height): (u32, u32)) -> Vec<(&'static str, String)> {
        let outside = |(field, (x, y)): (&'static str, At)| {
            (x >= width || y >= height).then(|| {
                let message = format!(
                    "`{field}`: expected a pixel of the picture, which is {width} x {height}, \
                     found ({x}, {y})"
                );
                (field, message)
            })
        };
        let mut problems = self.inner().problems((width, height));
        problems.extend(self.inner().pixels().into_iter().filter_map(outside));
        problems
    }
}

/// Whether `found` is within `within` of `expected`, relative to it; of 0 only a
/// few roundings of white are. NaN never is.
fn is_close(found: f64, expected: f64, within: f64) -> bool {
    if expected == 0.0 {
        return found.abs() <= within.min(few_roundings());
    }
    (found - expected).abs() <= within * expected.abs()
}

/// A relative tolerance that a fixture may leave out: a few roundings.
fn few_roundings() -> f64 {
    1e-12
}

/// A problem unless the tolerance is a small number.
fn tolerance_problem(within: f64) -> Vec<(&'static str, String)> {
    /// A tenth is far more than any rounding; an expectation that allows more
    /// is none.
    const LOOSEST: f64 = 0.1;
    if (0.0..=LOOSEST).contains(&within) {
        Vec::new()
    } else {
        vec![("within", format!("`within`: expected a number from 0 to {LOOSEST}, found {within}"))]
    }
}

#[cfg(test)]
mod tests;
