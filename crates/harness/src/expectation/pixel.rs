//! `Pixel`: the 8-bit color of one pixel.

use serde::{Deserialize, Serialize};

use super::{At, Expect, Rendered};

/// The pixel at `at` has exactly this 8-bit color.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pixel {
    /// Which pixel.
    pub at: At,
    /// Its color.
    pub rgb: (u8, u8, u8),
}

impl Expect for Pixel {
    fn check(&self, picture: &Rendered) -> Result<(), String> {
        let (x, y) = self.at;
        let found = picture.encoded.get(x, y).map(<(u8, u8, u8)>::from);
        if found == Some(self.rgb) {
            return Ok(());
        }
        let found = found.map_or("nothing there".to_owned(), |rgb| format!("{rgb:?}"));
        Err(format!("pixel ({x}, {y}): expected {:?}, found {found}", self.rgb))
    }

    fn pixels(&self) -> Vec<(&'static str, At)> {
        vec![("at", self.at)]
    }
}
