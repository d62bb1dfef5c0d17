//! `Count`: how many pixels have a color.

use serde::{Deserialize, Serialize};

use super::{At, Expect, Rendered};

/// Exactly `pixels` pixels have this 8-bit color: the area of a silhouette.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Count {
    /// The color counted.
    pub rgb: (u8, u8, u8),
    /// How many there are.
    pub pixels: u64,
}

impl Expect for Count {
    fn check(&self, picture: &Rendered) -> Result<(), String> {
        let color: [u8; 3] = self.rgb.into();
        let found = picture.encoded.pixels().iter().filter(|&&p| p == color).count() as u64;
        if found == self.pixels {
            return Ok(());
        }
        Err(format!("pixels of color {:?}: expected {}, found {found}", self.rgb, self.pixels))
    }

    fn pixels(&self) -> Vec<(&'static str, At)> {
        Vec::new()
    }
}
