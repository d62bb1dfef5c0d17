//! `Kernel`: the weights of a filter along one direction.

use std::f64::consts::PI;

/// Weights around a center, as many before it as after it: either the same ones,
/// or their negatives.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Kernel {
    /// The weights from the center onwards.
    half: Vec<f64>,
    is_odd: bool,
}

impl Kernel {
    /// A kernel that reaches `reach` pixels to each side and has the same weights
    /// on both, each a function of the distance from the center, in pixels.
    /// Weights above 0 are scaled to sum to 1, those below to sum to -1.
    pub(super) fn even(reach: usize, weight: impl Fn(f64) -> f64) -> Self {
        let half: Vec<_> = (0..=reach).map(|i| weight(i as f64)).collect();
        let sum_of = |is_meant: fn(&f64) -> bool| {
            let outer: f64 = half[1..].iter().copied().filter(is_meant).sum();
            2.0 * outer + half[..1].iter().copied().filter(is_meant).sum::<f64>()
        };
        let (above, below) = (sum_of(|&w| w > 0.0), sum_of(|&w| w < 0.0));
        let scale = |&w: &f64| if w < 0.0 { -w / below } else { w / above };
        Self { half: half.iter().map(scale).collect(), is_odd: false }
    }

    /// A kernel that has the negatives of its weights before the center. It is
    /// scaled as an even one; its weights all have one sign.
    pub(super) fn odd(reach: usize, weight: impl Fn(f64) -> f64) -> Self {
        let half: Vec<_> = (0..=reach).map(|i| weight(i as f64)).collect();
        let sum: f64 = half.iter().sum();
        Self { half: half.iter().map(|w| w / sum).collect(), is_odd: true }
    }

    /// How many pixels it reaches to each side.
    pub(super) fn reach(&self) -> usize {
        self.half.len() - 1
    }

    /// Sums the lines around a center into `sum`, each times its weight; `center`
    /// is the number of the line there. Lines at the same distance are added
    /// first: it saves multiplications, and a mirrored picture gives the mirrored
    /// bits.
    pub(super) fn weigh<'a>(
        &self,
        center: usize,
        line: impl Fn(usize) -> &'a [f64],
        sum: &mut [f64],
    ) {
        for (sum, value) in sum.iter_mut().zip(line(center)) {
            *sum = self.half[0] * value;
        }
        for (distance, &weight) in self.half.iter().enumerate().skip(1) {
            let (before, after) = (line(center - distance), line(center + distance));
            if self.is_odd {
                add(sum, before, after, |before, after| weight * (after - before));
            } else {
                add(sum, before, after, |before, after| weight * (after + before));
            }
        }
    }
}

fn add(sum: &mut [f64], before: &[f64], after: &[f64], term: impl Fn(f64, f64) -> f64) {
    for (sum, (&before, &after)) in sum.iter_mut().zip(before.iter().zip(after)) {
        *sum += term(before, after);
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
        assert_eq!(Kernel::odd(3, |x| x).half, [0.0, 1.0 / 6.0, 2.0 / 6.0, 0.5]);
        assert_eq!(Kernel::even(1, |_| 5.0).half, [1.0 / 3.0; 2]);
        assert_eq!(Kernel::even(2, |x| x - 1.0).half, [-1.0, 0.0, 0.5]);
        assert_eq!(Kernel::even(0, |_| 0.1).half, [1.0]);
    }

    #[test]
    fn a_kernel_weighs_the_middle_of_a_wider_border() {
        #[track_caller]
        fn check(kernel: &Kernel, expected: f64) {
            let lines = [[100.0], [1.0], [2.0], [4.0], [100.0]];
            let mut sum = [7.0];
            kernel.weigh(2, |i| &lines[i], &mut sum);
            assert_eq!(sum, [expected]);
        }
        check(&Kernel::odd(1, |x| x), 4.0 - 1.0);
        check(&Kernel::even(1, |x| 2.0 - x), 0.25 + 0.5 * 2.0 + 0.25 * 4.0);
        check(&Kernel::even(0, |_| 1.0), 2.0);
    }
}
