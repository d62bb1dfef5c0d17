//! How much of a pixel a thing covers, by formulas: the truth that sampled
//! silhouettes are held to.
//!
//! Lengths are in pixels, `x` to the right and `y` up; a pixel is the unit
//! square with a given lower left corner. Everything is in `f64` and right to a
//! few roundings of the thing's size; pictures that are held to it are never
//! better than 1e-9.

use std::f64::consts::PI;

/// A point of the picture's plane.
pub type Point = [f64; 2];

/// The part of the unit square with this lower left corner that lies in a disk:
/// of a ball under a parallel camera, or of a disk that faces it. From 0 to 1.
///
/// The area of a disk below and left of a point, added and subtracted at the
/// square's corners.
pub fn disk(center: Point, radius: f64, corner: Point) -> f64 {
    let [x0, y0] = [0, 1].map(|k| (corner[k] - center[k]) / radius);
    let [x1, y1] = [0, 1].map(|k| (corner[k] + 1.0 - center[k]) / radius);
    let area = (quadrant(x1, y1) - quadrant(x0, y1)) - (quadrant(x1, y0) - quadrant(x0, y0));
    (area * radius * radius).clamp(0.0, 1.0)
}

/// The area of the part of the unit disk where the coordinates are below `x`
/// and `y`.
fn quadrant(x: f64, y: f64) -> f64 {
    if x <= -1.0 || y <= -1.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return left_of(y.min(1.0));
    }
    if y >= 1.0 {
        return left_of(x);
    }
    if x * x + y * y >= 1.0 {
        // The corner is outside: caps do not meet, or one lies in the other.
        return match (x > 0.0, y > 0.0) {
            (true, true) => left_of(x) + left_of(y) - PI,
            (true, false) => left_of(y),
            (false, true) => left_of(x),
            (false, false) => 0.0,
        };
    }
    // Inside: the columns from the left end of the chord at height y, or from
    // the left end of the disk, whichever the half is.
    let half_chord = (1.0 - y * y).sqrt();
    // Columns up to x, between the circle below and y above.
    let capped = |a: f64, b: f64| y * (b - a) + rise(b) - rise(a);
    let whole = |a: f64, b: f64| 2.0 * (rise(b) - rise(a));
    if y > 0.0 { whole(-1.0, -half_chord) + capped(-half_chord, x) } else { capped(-half_chord, x) }
}

/// The area of the unit disk left of `x`, from -1 to 1.
fn left_of(x: f64) -> f64 {
    2.0 * (rise(x) - rise(-1.0))
}

/// An antiderivative of `sqrt(1 - x^2)`, from -1 to 1.
fn rise(x: f64) -> f64 {
    0.5 * (x * (1.0 - x * x).max(0.0).sqrt() + libm::asin(x))
}

/// The part of the unit square with this lower left corner that lies in a
/// polygon, whose corners are given in order, either way around: of a triangle
/// or of a box's face. The polygon may be of any form that does not cross
/// itself. From 0 to 1.
///
/// Cut at the square's four sides, one after the other.
///
/// Source: Sutherland and Hodgman, "Reentrant polygon clipping", 1974; the area by
/// the shoelace formula.
pub fn polygon(corners: &[Point], corner: Point) -> f64 {
    // Distances from the pixel's own corner, so that no digits are lost.
    let mut points: Vec<Point> =
        corners.iter().map(|[x, y]| [x - corner[0], y - corner[1]]).collect();
    for axis in [0, 1] {
        points = kept(&points, |p| p[axis]);
        points = kept(&points, |p| 1.0 - p[axis]);
    }
    let next = points.iter().cycle().skip(1);
    let twice: f64 = points.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
    (0.5 * twice.abs()).clamp(0.0, 1.0)
}

/// The part of a polygon where `inside` is not below 0.
fn kept(points: &[Point], inside: impl Fn(Point) -> f64) -> Vec<Point> {
    let mut kept = Vec::with_capacity(points.len() + 1);
    for (k, &here) in points.iter().enumerate() {
        let before = points[(k + points.len() - 1) % points.len()];
        let (d, e) = (inside(before), inside(here));
        if (d < 0.0) != (e < 0.0) {
            let t = d / (d - e);
            kept.push([0, 1].map(|axis| before[axis] + t * (here[axis] - before[axis])));
        }
        if e >= 0.0 {
            kept.push(here);
        }
    }
    kept
}

/// The part of the unit square with this lower left corner that lies in an
/// upright rectangle: of a box seen along an axis.
pub fn rectangle(min: Point, max: Point, corner: Point) -> f64 {
    let [width, height] = [0, 1].map(|k| {
        let (lo, hi) = (min[k].max(corner[k]), max[k].min(corner[k] + 1.0));
        (hi - lo).max(0.0)
    });
    width * height
}

/// The part of the unit square with this lower left corner that lies on the
/// fields of a checkerboard: squares of this width, from the origin on, of which
/// every other one counts, the one right and up of the origin first.
pub fn checker(width: f64, corner: Point) -> f64 {
    // Along each axis: how much lies on even fields, and how much on odd ones.
    let [[even_x, odd_x], [even_y, odd_y]] = corner.map(|from| {
        let mut parts = [0.0; 2];
        let (first, last) = ((from / width).floor(), ((from + 1.0) / width).floor());
        let mut field = first;
        while field <= last {
            let (lo, hi) = ((field * width).max(from), ((field + 1.0) * width).min(from + 1.0));
            parts[usize::from(field.rem_euclid(2.0) == 1.0)] += (hi - lo).max(0.0);
            field += 1.0;
        }
        parts
    });
    even_x * even_y + odd_x * odd_y
}

/// What a pixel shows of an upright rectangle through a filter `f(x) f(y)`: the
/// integral of that, by Simpson's rule. `density` is `f`, smooth between the
/// `breaks`, of which the first and last are where it ends; `middle` is the
/// pixel's.
pub fn filtered_rectangle(
    density: &dyn Fn(f64) -> f64,
    breaks: &[f64],
    (min, max): (Point, Point),
    middle: Point,
) -> f64 {
    let [width, height] = [0, 1].map(|k| {
        let pieces = breaks.windows(2).map(|piece| {
            let (lo, hi) = ((min[k] - middle[k]).max(piece[0]), (max[k] - middle[k]).min(piece[1]));
            if lo < hi { simpson(density, lo, hi) } else { 0.0 }
        });
        pieces.sum::<f64>()
    });
    width * height
}

/// The integral of a smooth function, right to far below 1e-9 for those here.
fn simpson(f: &dyn Fn(f64) -> f64, lo: f64, hi: f64) -> f64 {
    const PIECES: u32 = 64;
    let step = (hi - lo) / f64::from(PIECES);
    let at = |k: f64| f(lo + k * step);
    let piece = |k: u32| {
        let k = f64::from(k);
        at(k) + 4.0 * at(k + 0.5) + at(k + 1.0)
    };
    (0..PIECES).map(piece).sum::<f64>() * step / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By counting a million points.
    fn counted(is_in: impl Fn(f64, f64) -> bool, [x0, y0]: Point) -> f64 {
        const SIDE: u32 = 1_000;
        let at = |k: u32| (f64::from(k) + 0.5) / f64::from(SIDE);
        let row = |j: u32| (0..SIDE).filter(|&i| is_in(x0 + at(i), y0 + at(j))).count() as f64;
        (0..SIDE).map(row).sum::<f64>() / f64::from(SIDE * SIDE)
    }

    #[test]
    fn a_disk_is_cut_as_counting_says() {
        for radius in [0.1, 0.4, 0.6, 0.7, 0.72, 1.0, 3.3] {
            for corner in [[0.0, 0.0], [-0.5, -0.5], [-0.3, 0.1], [-0.9, -0.9], [2.1, -3.0]] {
                let exact = disk([0.05, -0.02], radius, corner);
                let is_in = |x: f64, y: f64| {
                    (x - 0.05) * (x - 0.05) + (y + 0.02) * (y + 0.02) < radius * radius
                };
                let about = counted(is_in, corner);
                assert!((exact - about).abs() < 2e-4, "{radius} {corner:?}: {exact} {about}");
            }
        }
    }

    #[test]
    fn the_pixels_of_a_disk_add_up_to_its_area() {
        for (center, radius) in [([0.3, -0.7], 9.37), ([0.0, 0.0], 5.0), ([0.5, 0.5], 0.25)] {
            let pixels = (-20..20).flat_map(|j| (-20..20).map(move |i| [i, j]));
            let area: f64 = pixels.map(|pixel| disk(center, radius, pixel.map(f64::from))).sum();
            let exact = PI * radius * radius;
            assert!((area / exact - 1.0).abs() < 1e-12, "{area} {exact}");
        }
        // A quarter of it, in whole numbers.
        assert!((disk([0.0, 0.0], 1.0, [0.0, 0.0]) - PI / 4.0).abs() < 1e-15);
        assert!(1.0 - disk([0.0, 0.0], 2.0, [-0.5, -0.5]) < 1e-15);
        assert_eq!(disk([0.0, 0.0], 2.0, [2.0, 0.0]), 0.0);
    }

    #[test]
    fn polygons_are_cut_as_by_hand() {
        let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(polygon(&triangle, [0.0, 0.0]), 1.0);
        assert_eq!(polygon(&triangle, [1.0, 0.0]), 0.5);
        assert_eq!(polygon(&triangle, [1.0, 1.0]), 0.0);
        assert_eq!(polygon(&triangle, [-0.5, -0.5]), 0.25);
        let backwards: Vec<_> = triangle.into_iter().rev().collect();
        assert_eq!(polygon(&backwards, [1.0, 0.0]), 0.5);
        // An L, which is not convex: three of four quarters.
        let l = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.5, 0.5], [0.5, 1.0], [0.0, 1.0]];
        assert_eq!(polygon(&l, [0.0, 0.0]), 0.75);
        assert_eq!(polygon(&[], [0.0, 0.0]), 0.0);
    }

    #[test]
    fn rectangles_and_checkers_are_cut_as_counting_says() {
        assert_eq!(rectangle([0.25, -9.0], [0.75, 0.5], [0.0, 0.0]), 0.25);
        assert_eq!(rectangle([0.25, -9.0], [0.75, 0.5], [1.0, 0.0]), 0.0);
        for width in [0.3, 0.7, 1.0, 2.5] {
            for corner in [[0.0, 0.0], [-0.35, 1.2], [7.9, -3.3]] {
                let is_in = |x: f64, y: f64| {
                    ((x / width).floor() + (y / width).floor()).rem_euclid(2.0) == 0.0
                };
                let (exact, about) = (checker(width, corner), counted(is_in, corner));
                assert!((exact - about).abs() < 3e-3, "{width} {corner:?}: {exact} {about}");
            }
        }
        assert_eq!(checker(1.0, [0.0, 0.0]), 1.0);
        assert_eq!(checker(1.0, [1.0, 0.0]), 0.0);
        assert_eq!(checker(0.5, [3.0, 4.0]), 0.5);
    }

    #[test]
    fn a_filter_that_is_the_pixel_shows_the_pixel() {
        let ones = |_: f64| 1.0;
        let corners = ([0.25, -9.0], [0.75, 0.5]);
        let found = filtered_rectangle(&ones, &[-0.5, 0.5], corners, [0.5, 0.5]);
        assert!((found - 0.25).abs() < 1e-15);
        // Half of a tent lies on each side of its middle.
        let tent = |x: f64| 1.0 - x.abs();
        let right = ([0.5, -9.0], [9.0, 9.0]);
        let found = filtered_rectangle(&tent, &[-1.0, 0.0, 1.0], right, [0.5, 0.5]);
        assert!((found - 0.5).abs() < 1e-15);
    }
}
