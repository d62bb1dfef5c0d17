//! `Narrow`: things that may pass between the middles of pixels.

use std::collections::BTreeMap;

use crate::camera::Seen;
use crate::{Scene, Size};

/// An upright rectangle in the picture, in pixels from its lower left corner,
/// outside of which a thing is not seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounds {
    x: [f64; 2],
    y: [f64; 2],
}

impl Bounds {
    /// In pixels, for what ends on the border of one: bounds are rounded, in
    /// mirrored pictures in another way.
    const MARGIN: f64 = 0.01;

    /// How wide it is where it is narrowest.
    fn width(&self) -> f64 {
        let [width, height] = [self.x, self.y].map(|[lo, hi]| hi - lo);
        width.min(height)
    }

    /// What of it is in pixel `(i, j)`: how wide that is where it is narrowest,
    /// and its area.
    pub(super) fn part_in(&self, (i, j): (u32, u32)) -> (f64, f64) {
        let part = |[lo, hi]: [f64; 2], pixel: u32| {
            let pixel = f64::from(pixel);
            (hi.min(pixel + 1.0) - lo.max(pixel)).max(0.0)
        };
        let (width, height) = (part(self.x, i), part(self.y, j));
        (width.min(height), width * height)
    }

    /// Whether it reaches into this part of pixel `(i, j)`, given by its sides
    /// from the pixel's middle.
    pub(super) fn reaches(&self, (i, j): (u32, u32), sides: ([f64; 2], [f64; 2])) -> bool {
        let meets = |[lo, hi]: [f64; 2], pixel: u32, [from, to]: [f64; 2]| {
            let middle = f64::from(pixel) + 0.5;
            lo - Self::MARGIN < middle + to && middle + from < hi + Self::MARGIN
        };
        meets(self.x, i, sides.0) && meets(self.y, j, sides.1)
    }
}

/// Where things are that are narrower than a pixel, left to right or top to
/// bottom. Those that are so on a slant only are found where a middle sees them.
pub(super) struct Narrow {
    /// By row and column.
    pixels: BTreeMap<(u32, u32), Vec<Bounds>>,
}

impl Narrow {
    /// Those of this scene that may cover more of a pixel than `least`.
    pub(super) fn of(scene: &Scene, least: f64) -> Self {
        let (Size { width, height }, camera) = (scene.size(), scene.camera());
        let mut narrow = Self { pixels: BTreeMap::new() };
        scene.world().visit(&mut |_, _, boxes, _| {
            for seen in boxes.iter().map(|b| camera.sees_box(b)) {
                let Seen::Between { a, b } = seen else { continue };
                let pixels = |[lo, hi]: [f64; 2], extent: f64, count: u32| {
                    [lo, hi].map(|x| (x / extent + 0.5) * f64::from(count))
                };
                let x = pixels(a, camera.view_width(), width);
                let y = pixels(b, camera.view_height(), height);
                narrow.mark(Bounds { x, y }, least, scene.size());
            }
        });
        narrow
    }

    fn mark(&mut self, bounds: Bounds, least: f64, Size { width, height }: Size) {
        let Bounds { x, y } = bounds;
        let area = (x[1] - x[0]).min(1.0) * (y[1] - y[0]).min(1.0);
        if bounds.width() >= 1.0 || area < least {
            return;
        }
        let range = |[lo, hi]: [f64; 2], count: u32| {
            // Beyond the picture there is none: the casts saturate.
            let first = (lo - Bounds::MARGIN).floor().max(0.0);
            let end = (hi + Bounds::MARGIN).ceil().min(f64::from(count));
            if first < end { first as u32..end as u32 } else { 0..0 }
        };
        for j in range(y, height) {
            for i in range(x, width) {
                self.pixels.entry((j, i)).or_default().push(bounds);
            }
        }
    }

    /// What may be in pixel `(i, j)`.
    pub(super) fn seen_in(&self, (i, j): (u32, u32)) -> &[Bounds] {
        self.pixels.get(&(j, i)).map_or(&[], Vec::as_slice)
    }
}
