//! `Count`: how many pixels have a color.

use serde::{Deserialize, Serialize};

use super::{Expect, Rendered};

/// `pixels` pixels have this 8-bit color: the area of a silhouette.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Count {
    /// The color counted.
    pub rgb: (u8, u8, u8),
    /// How many there are.
    pub pixels: u64,
    /// How many more or fewer there may be, where chance has a part in it; less
    /// than half of them.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub within: u64,
}

// Serde passes a reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_zero(count: &u64) -> bool {
    *count == 0
}

impl Expect for Count {
    fn check(&self, picture: &Rendered) -> Result<(), String> {
        let color: [u8; 3] = self.rgb.into();
        let found = picture.encoded.pixels().iter().filter(|&&p| p == color).count() as u64;
        if found.abs_diff(self.pixels) <= self.within {
            return Ok(());
        }
        let within = match self.within {
            0 => String::new(),
            within => format!(" within {within}"),
        };
        Err(format!(
            "pixels of color {:?}: expected {}{within}, found {found}",
            self.rgb, self.pixels
        ))
    }

    fn problems(&self, _: (u32, u32)) -> Vec<(&'static str, String)> {
        // An allowance of half the pixels would accept nearly any picture.
        if self.within == 0 || self.within < self.pixels.div_ceil(2) {
            return Vec::new();
        }
        let found = self.within;
        vec![(
            "within",
            format!(
                "`within`: expected less than half of `pixels`, {}, found {found}",
                self.pixels
            ),
        )]
    }
}
