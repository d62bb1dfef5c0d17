//! `Kernel`: the weights of a filter along one direction.

use std::f64::consts::PI;

/// Weights around a center, as many before it as after it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Kernel {
    weights: Vec<f64>,
}

impl Kernel {
    /// A kernel that reaches `reach` pixels to each side, each weight a function
    /// of the distance from the center, in pixels. Weights above 0 are scaled to
    /// sum to 1, those below to sum to -1.
    pub(super) fn new(reach: usize, weight: impl Fn(f64) -> f64) -> Self {
        let distances = (0..=2 * reach).map(|i| i as f64 - reach as f64);
        let weights: Vec<_> = distances.map(weight).collect();
        let above: f64 = weights.iter().filter(|&&w| w > 0.0).sum();
        let below: f64 = weights.iter().filter(|&&w| w < 0.0).sum();
        let scale = |w: f64| if w > 0.0 { w / above } else { -w / below };
        let weights = weights.into_iter().map(|w| if w == 0.0 { 0.0 } else { scale(w) }).collect();
        Self { weights }
    }

    /// How many pixels it reaches to each side.
    pub(super) fn reach(&self) -> usize {
        self.weights.len() / 2
    }

    /// Sums the lines around a center into `sum`, each times its weight;
    /// `line(i)` is the one that is `i` after the first that `border` reaches.
    pub(super) fn weigh<'a>(
        &self,
        border: usize,
        line: impl Fn(usize) -> &'a [f64],
        sum: &mut [f64],
    ) {
        sum.fill(0.0);
        let first = border - self.reach();
        for (i, weight) in self.weights.iter().enumerate() {
            for (sum, value) in sum.iter_mut().zip(line(first + i)) {
                *sum += weight * value;
            }
        }
    }
}

/// `exp(-pi^2 x^2 / b)`, the bell of the source's equation 4, `x` in degrees.
pub(super) fn bell(x: f64, b: f64) -> f64 {
    libm::exp(-PI * PI * x * x / b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_sum_to_1_on_either_side_of_0() {
        let slope = Kernel::new(3, |x| -x);
        assert_eq!(slope.weights, [0.5, 2.0 / 6.0, 1.0 / 6.0, 0.0, -1.0 / 6.0, -2.0 / 6.0, -0.5]);
        assert_eq!(Kernel::new(1, |_| 5.0).weights, [1.0 / 3.0; 3]);
        assert_eq!(Kernel::new(0, |_| 0.1).weights, [1.0]);
    }

    #[test]
    fn a_kernel_weighs_the_middle_of_a_wider_border() {
        let lines = [[100.0], [1.0], [2.0], [4.0], [100.0]];
        let mut sum = [7.0];
        Kernel::new(1, |x| -x).weigh(2, |i| &lines[i], &mut sum);
        assert_eq!(sum, [1.0 - 4.0]);
    }
}
