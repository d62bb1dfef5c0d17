//! `Eye`: a picture as an observer sees it, row by row.
//!
//! All filters are separable: every row is weighed along x once, kept while a
//! filter reaches it, and then weighed along y.

use std::array;

use tracer::glam::DVec3;

use super::PIXELS_PER_DEGREE;
use super::color::{Colors, brightness};
use super::features::Features;
use super::kernel::Kernel;
use super::sensitivity::Sensitivity;
use crate::encode::EncodedImage;

/// What is seen at one pixel.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Seen {
    /// L*a*b* faded by the Hunt effect.
    pub(super) color: DVec3,
    /// How much of an edge there is, from 0 to the square root of 2.
    pub(super) edge: f64,
    /// How much of a point or line there is, from 0 to the square root of 2.
    pub(super) point: f64,
}

/// Lines of numbers, a number per pixel of a row and more where it is bordered.
type Lines<const N: usize> = [Vec<f64>; N];

/// The lines of a row of pixels: Y, Cx, Cz and brightness.
const CHANNELS: usize = 4;
/// Those weighed along x, each by a kernel of `Eye::weigh_along_x`.
const ALONG_X: usize = 7;
/// Those weighed along y, each by a kernel of `Eye::weigh_along_y`.
const ALONG_Y: usize = 8;

/// An observer of one picture.
pub(super) struct Eye<'a> {
    picture: &'a EncodedImage,
    colors: &'a Colors,
    sensitivity: Sensitivity,
    features: Features,
    /// How far any kernel reaches.
    border: usize,
    /// Row y of the picture, weighed along x, is `weighed[y % weighed.len()]`.
    weighed: Vec<Lines<ALONG_X>>,
    /// How many rows of the picture have been weighed.
    read: usize,
    /// A row of pixels, its outermost ones repeated as a border.
    bordered: Lines<CHANNELS>,
    filtered: Lines<ALONG_Y>,
    seen: Vec<Seen>,
}

impl<'a> Eye<'a> {
    /// An observer of `picture`, which has at least one pixel.
    pub(super) fn new(picture: &'a EncodedImage, colors: &'a Colors) -> Self {
        let width = picture.size().width as usize;
        let sensitivity = Sensitivity::new(PIXELS_PER_DEGREE);
        let features = Features::new(PIXELS_PER_DEGREE);
        let border = sensitivity.y.reach().max(features.edge.reach());
        Self {
            picture,
            colors,
            sensitivity,
            features,
            border,
            weighed: (0..=2 * border).map(|_| lines(width)).collect(),
            read: 0,
            bordered: lines(border + width + border),
            filtered: lines(width),
            seen: vec![Seen::default(); width],
        }
    }

    /// What is seen in row `y` of the picture. Rows are asked for one after
    /// the other from the top.
    pub(super) fn row(&mut self, y: usize) -> &[Seen] {
        let rows = self.picture.size().height as usize;
        while self.read < rows.min(y + self.border + 1) {
            self.weigh_along_x();
        }
        self.weigh_along_y(y, rows - 1);
        self.see();
        &self.seen
    }

    /// Weighs the next row of the picture.
    fn weigh_along_x(&mut self) {
        let (border, width) = (self.border, self.seen.len());
        let pixels = &self.picture.pixels()[self.read * width..][..width];
        for (i, &pixel) in pixels.iter().enumerate() {
            let opponent = self.colors.opponent(pixel);
            let [y, cx, cz] = opponent.to_array();
            for (line, value) in self.bordered.iter_mut().zip([y, cx, cz, brightness(opponent)]) {
                line[border + i] = value;
            }
        }
        for line in &mut self.bordered {
            let (first, last) = (line[border], line[border + width - 1]);
            line[..border].fill(first);
            line[border + width..].fill(last);
        }
        let Sensitivity { y, cx, cz: [cz, cz_narrow], .. } = &self.sensitivity;
        let Features { edge, point, blur } = &self.features;
        let kernels: [(usize, &Kernel); ALONG_X] =
            [(0, y), (1, cx), (2, cz), (2, cz_narrow), (3, blur), (3, edge), (3, point)];
        let slot = self.read % self.weighed.len();
        for ((channel, kernel), sum) in kernels.into_iter().zip(&mut self.weighed[slot]) {
            kernel.weigh(border, |i| &self.bordered[channel][i..i + width], sum);
        }
        self.read += 1;
    }

    /// Weighs the rows around row `y`, the outermost ones repeated as a border.
    fn weigh_along_y(&mut self, y: usize, last: usize) {
        let Sensitivity { y: lightness, cx, cz: [cz, cz_narrow], .. } = &self.sensitivity;
        let Features { edge, point, blur } = &self.features;
        // The lines of `weigh_along_x`: blurred ones are derived, derived ones blurred.
        let kernels: [(usize, &Kernel); ALONG_Y] = [
            (0, lightness),
            (1, cx),
            (2, cz),
            (3, cz_narrow),
            (5, blur),
            (4, edge),
            (6, blur),
            (4, point),
        ];
        for ((line, kernel), sum) in kernels.into_iter().zip(&mut self.filtered) {
            let row = |i: usize| (y + i).saturating_sub(self.border).min(last);
            kernel.weigh(self.border, |i| &self.weighed[row(i) % self.weighed.len()][line], sum);
        }
    }

    fn see(&mut self) {
        let [wide, narrow] = self.sensitivity.cz_weights;
        for (i, seen) in self.seen.iter_mut().enumerate() {
            let [y, cx, cz, cz_narrow, edge_x, edge_y, point_x, point_y] =
                self.filtered.each_ref().map(|line| line[i]);
            let opponent = DVec3::new(y, cx, wide * cz + narrow * cz_narrow);
            *seen = Seen {
                color: self.colors.perceived(self.colors.shown(opponent)),
                edge: (edge_x * edge_x + edge_y * edge_y).sqrt(),
                point: (point_x * point_x + point_y * point_y).sqrt(),
            };
        }
    }
}

fn lines<const N: usize>(len: usize) -> Lines<N> {
    array::from_fn(|_| vec![0.0; len])
}
