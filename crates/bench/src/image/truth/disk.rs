//! How much of each pixel a disk covers that faces the camera: a formula.

use scene::format::Object;
use tracer::glam::DVec3;
use tracer::{LinearImage, Size};

use crate::image::export::{Surface, View, only_object};
use crate::image::scenes::Read;

/// The picture of a scene that is one shining disk, square to the view.
///
/// # Errors
/// Refuses other scenes.
pub(crate) fn disk(read: &Read) -> Result<LinearImage, String> {
    /// What the disk's axis may be off by for rounding.
    const ROUNDING: f64 = 1e-12;
    let (view, object, surface) = only_object(read)?;
    let (Object::Disk { center, normal, radius, .. }, Surface::Shining(color)) = (object, surface)
    else {
        return Err("expected one disk that shines".into());
    };
    let View { eye, forward, right, up, width, height } = view;
    if DVec3::from(*normal).normalize().cross(forward).length() > ROUNDING {
        return Err("expected a disk that faces the camera".into());
    }
    let size = Size { width: read.file.image.0, height: read.file.image.1 };
    let towards = DVec3::from(*center) - eye;
    // Pixels for each unit at the disk's distance; they are square.
    let scale = f64::from(size.width) / (width * towards.dot(forward));
    let x = f64::from(size.width) / 2.0 + scale * towards.dot(right);
    let y = f64::from(size.height) / 2.0 - scale * towards.dot(up);
    debug_assert!((width / height - f64::from(size.width) / f64::from(size.height)).abs() < 1e-9);
    Ok(LinearImage::from_fn(size, |column, row| {
        let (left, top) = (f64::from(column) - x, f64::from(row) - y);
        tracer::Rgb::from(color) * covered((left, top), (left + 1.0, top + 1.0), scale * radius)
    }))
}

/// The area of a rectangle that is within `r` of the origin.
fn covered(lo: (f64, f64), hi: (f64, f64), r: f64) -> f64 {
    corner(hi.0, hi.1, r) - corner(lo.0, hi.1, r) - corner(hi.0, lo.1, r) + corner(lo.0, lo.1, r)
}

/// That of the rectangle between the origin and this corner, negative where one
/// of its sides is.
fn corner(x: f64, y: f64, r: f64) -> f64 {
    let sign = x.signum() * y.signum();
    let (x, y) = (x.abs().min(r), y.abs().min(r));
    // Up to here the circle is above the rectangle.
    let below = (r * r - y * y).sqrt().min(x);
    sign * (below * y + under_arc(x, r) - under_arc(below, r))
}

/// The area under the circle's upper half from 0 to `x`.
fn under_arc(x: f64, r: f64) -> f64 {
    0.5 * (x * (r * r - x * x).max(0.0).sqrt() + r * r * libm::asin((x / r).min(1.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_of_parts_of_a_circle() {
        const PI: f64 = std::f64::consts::PI;
        let check = |lo, hi, r, expected: f64| {
            let found = covered(lo, hi, r);
            assert!((found - expected).abs() < 1e-12, "{found}");
        };
        check((-2.0, -2.0), (2.0, 2.0), 1.0, PI);
        check((0.0, -2.0), (2.0, 2.0), 1.0, PI / 2.0);
        check((-0.5, -0.5), (0.5, 0.5), 1.0, 1.0);
        check((1.0, 1.0), (2.0, 2.0), 1.0, 0.0);
        // Half of the disk less the square in it, and one of the four caps.
        let side = 0.5_f64.sqrt();
        check((side, -2.0), (2.0, 2.0), 1.0, (PI - 2.0) / 4.0);
    }
}
