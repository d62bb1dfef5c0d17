//! `Features`: the filters that answer to edges and to points.
//!
//! Source: section 4.2: the first and second derivatives of a Gaussian.

use super::kernel::Kernel;

/// The width of an edge that the eye is most sensitive to, in degrees.
const W: f64 = 0.082;

/// Filters along one direction; each is blurred across it.
pub(super) struct Features {
    /// Answers to an edge, by up to 1 either way.
    pub(super) edge: Kernel,
    /// Answers to a point or a line, by up to 1 either way.
    pub(super) point: Kernel,
    /// The blur across.
    pub(super) blur: Kernel,
}

impl Features {
    /// For so many pixels per degree of view.
    pub(super) fn new(pixels_per_degree: f64) -> Self {
        let sigma = W / 2.0 * pixels_per_degree;
        let reach = libm::ceil(3.0 * sigma) as usize;
        let gaussian = |x: f64| libm::exp(-x * x / (2.0 * sigma * sigma));
        Self {
            edge: Kernel::odd(reach, |x| x * gaussian(x)),
            point: Kernel::even(reach, |x| (x * x / (sigma * sigma) - 1.0) * gaussian(x)),
            blur: Kernel::even(reach, gaussian),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The answer of `kernel` at position 0 to a line of values by position.
    fn answer(kernel: &Kernel, value: impl Fn(f64) -> f64) -> f64 {
        let reach = kernel.reach();
        let line: Vec<_> = (0..=2 * reach).map(|i| [value(i as f64 - reach as f64)]).collect();
        let mut sum = [0.0];
        kernel.weigh(reach, |i| &line[i], &mut sum);
        sum[0]
    }

    #[test]
    fn each_filter_answers_to_its_feature_and_not_to_a_flat() {
        let Features { edge, point, blur } = Features::new(67.02);
        let check = |kernel: &Kernel, value: fn(f64) -> f64, expected: f64| {
            let found = answer(kernel, value);
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        };
        check(&edge, |_| 1.0, 0.0);
        check(&point, |_| 1.0, 0.0);
        check(&blur, |_| 1.0, 1.0);
        check(&edge, |x| f64::from(u8::from(x > 0.0)), 1.0);
        check(&point, |x| x, 0.0);
        check(&point, |x| f64::from(u8::from(x.abs() <= 2.0)), -1.0);
    }
}
