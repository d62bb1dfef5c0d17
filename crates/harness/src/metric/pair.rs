//! `Pair`: a golden and an actual picture that can be compared.
//!
//! It is the one place that asks whether the sizes agree, so that no metric
//! has to.

use tracer::Size;

use crate::encode::EncodedImage;

/// Two pictures of one size, with at least one pixel each.
#[derive(Debug, Clone, Copy)]
pub struct Pair<'a> {
    golden: &'a EncodedImage,
    actual: &'a EncodedImage,
}

impl<'a> Pair<'a> {
    /// The two pictures together; `None` where their sizes differ or they have
    /// no pixel.
    pub fn new(golden: &'a EncodedImage, actual: &'a EncodedImage) -> Option<Self> {
        (golden.size() == actual.size() && !golden.bytes().is_empty())
            .then_some(Self { golden, actual })
    }

    /// Width and height of both, each at least 1.
    pub fn size(&self) -> Size {
        self.golden.size()
    }

    /// The accepted picture.
    pub fn golden(&self) -> &'a EncodedImage {
        self.golden
    }

    /// Today's picture.
    pub fn actual(&self) -> &'a EncodedImage {
        self.actual
    }

    /// Whether every byte of the two is the same.
    pub fn is_identical(&self) -> bool {
        self.golden == self.actual
    }

    /// Pixels of the golden with those of the actual, row by row from the top.
    pub fn pixels(&self) -> impl Iterator<Item = ([u8; 3], [u8; 3])> + use<'a> {
        self.golden.pixels().iter().copied().zip(self.actual.pixels().iter().copied())
    }
}
