//! The kinds of damage that a golden is given, each a family of one number: its
//! strength.
//!
//! To add one: write its file, add its line to [`DEFECTS`].

mod blob;
mod blur;
mod gain;
mod hue;
mod noise;
mod row;
mod shift;

use std::fmt;

use crate::encode::EncodedImage;

/// A kind of damage.
#[derive(Debug, Clone, Copy)]
pub struct Defect {
    /// The name used in flags and reports.
    pub name: &'static str,
    /// What is done to the picture.
    pub does: &'static str,
    /// The unit of its strength.
    pub unit: &'static str,
    /// The strengths that are tried.
    pub strengths: Strengths,
    /// The strength from which on people see it, unless a command says another.
    pub visible: f64,
    /// Where it may be put in a picture, at least one place.
    pub places: fn(&EncodedImage) -> Vec<Place>,
    /// The picture with the defect; of the same size.
    pub inject: fn(&EncodedImage, Place, f64) -> EncodedImage,
}

/// From the weakest strength to the strongest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strengths {
    /// The weakest that is tried, above 0.
    pub least: f64,
    /// The strongest that is tried.
    pub most: f64,
    /// Whether only whole numbers mean anything.
    pub whole: bool,
}

/// Where a defect is put.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Everywhere.
    Whole,
    /// In this row, from the top.
    Row(u32),
    /// With its upper left corner at this column and row.
    At(u32, u32),
}

/// Every kind of defect, in the order of a report.
pub const DEFECTS: &[Defect] = &[
    blob::ONE,
    blob::TWO,
    blob::FOUR,
    row::ROW,
    shift::ACROSS,
    shift::DOWN,
    gain::GAIN,
    hue::HUE,
    blur::BLUR,
    noise::NOISE,
];

/// The one place of a defect that is everywhere.
fn everywhere(_: &EncodedImage) -> Vec<Place> {
    vec![Place::Whole]
}

/// A code from 0 to 255: the nearest one, halves away from 0.
fn code(value: f64) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

/// The pixel at these coordinates, taken to the nearest one inside.
fn clamped(picture: &EncodedImage, x: i64, y: i64) -> [u8; 3] {
    let inside = |at: i64, count: u32| at.clamp(0, i64::from(count).max(1) - 1) as u32;
    let size = picture.size();
    picture.get(inside(x, size.width), inside(y, size.height)).unwrap_or_default()
}

/// What is so many pixels back, mixed of the two neighbors where that is between
/// them.
fn between(by: f64, back: impl Fn(i64) -> [u8; 3]) -> [u8; 3] {
    let whole = by.floor();
    let part = by - whole;
    let near = back(whole as i64);
    if part == 0.0 {
        return near;
    }
    let far = back(whole as i64 + 1);
    let mixed = |c: usize| f64::from(near[c]) + part * (f64::from(far[c]) - f64::from(near[c]));
    [0, 1, 2].map(|c| code(mixed(c)))
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole => write!(f, "everywhere"),
            Self::Row(y) => write!(f, "in row {y}"),
            Self::At(x, y) => write!(f, "at ({x}, {y})"),
        }
    }
}

#[cfg(test)]
mod tests;
