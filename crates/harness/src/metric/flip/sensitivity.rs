//! `Sensitivity`: what the eye resolves, as a blur of each opponent color.
//!
//! Source: section 4.1.1 and table 1, whose Gaussians have the symbols a and b.

use std::f64::consts::PI;

use super::kernel::{Kernel, bell};

/// The Gaussians of Y, Cx and Cz; the last is a sum of two, each with its `a`.
const B_Y: f64 = 0.0047;
const B_CX: f64 = 0.0053;
const A_CZ: [f64; 2] = [34.1, 13.5];
const B_CZ: [f64; 2] = [0.04, 0.025];

/// The blurs of the three opponent colors.
pub(super) struct Sensitivity {
    pub(super) y: Kernel,
    pub(super) cx: Kernel,
    /// Cz is blurred by either of two kernels, and they are added with weights.
    pub(super) cz: [Kernel; 2],
    pub(super) cz_weights: [f64; 2],
}

impl Sensitivity {
    /// For so many pixels per degree of view.
    pub(super) fn new(pixels_per_degree: f64) -> Self {
        // Three standard deviations of the widest Gaussian, in pixels.
        let widest = (B_CZ[0] / (2.0 * PI * PI)).sqrt();
        let reach = libm::ceil(3.0 * widest * pixels_per_degree) as usize;
        let kernel = |b: f64| Kernel::even(reach, |pixels| bell(pixels / pixels_per_degree, b));
        // What the window cuts off a Gaussian is no part of its share.
        let volume = |a: f64, b: f64| {
            let distances = (0..=2 * reach).map(|i| (i as f64 - reach as f64) / pixels_per_degree);
            let line: f64 = distances.map(|x| bell(x, b)).sum();
            a * (PI / b).sqrt() * line * line
        };
        let volumes = [volume(A_CZ[0], B_CZ[0]), volume(A_CZ[1], B_CZ[1])];
        let total = volumes[0] + volumes[1];
        Self {
            y: kernel(B_Y),
            cx: kernel(B_CX),
            cz: B_CZ.map(kernel),
            cz_weights: volumes.map(|volume| volume / total),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_grows_with_the_pixels_per_degree() {
        let reach = |pixels_per_degree| Sensitivity::new(pixels_per_degree).y.reach();
        assert_eq!([1.0, 30.0, 67.02, 100.0].map(reach), [1, 5, 10, 14]);
    }

    #[test]
    fn the_two_gaussians_of_cz_are_one_filter() {
        let weights = Sensitivity::new(67.02).cz_weights;
        assert!((weights[0] + weights[1] - 1.0).abs() < 1e-15, "{weights:?}");
        // By the integrals over the plane, without the window: a b^(1/2) each.
        let integral = [A_CZ[0] * B_CZ[0].sqrt(), A_CZ[1] * B_CZ[1].sqrt()];
        let expected = integral[0] / (integral[0] + integral[1]);
        assert!((weights[0] - expected).abs() < 1e-2, "{weights:?} {expected}");
    }
}
