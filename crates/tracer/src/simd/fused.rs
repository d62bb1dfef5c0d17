//! `fused`: formulas compiled for processors with fused multiply-add, and for others.
//!
//! Where the target's own instructions have none, as those of every x86-64, each
//! `f64::mul_add` is a call of a function. It gives the same bits: `a b + c` is
//! rounded once by either, so which of the two a formula uses changes no answer.
#![allow(unsafe_code)]

/// Something that is computed from four arguments, which go in registers.
pub(crate) trait Formula<A, B, C, D> {
    /// What comes of it.
    type Value;

    /// Computes it. It and everything that it calls for a `mul_add` must be
    /// `#[inline(always)]`: what is not is compiled for the target's own
    /// instructions. A closure that is passed on, as to `map`, is not.
    fn value(a: A, b: B, c: C, d: D) -> Self::Value;
}

/// The formula's value, by the best instructions that this processor has.
#[inline(always)]
pub(crate) fn fused<F: Formula<A, B, C, D>, A, B, C, D>(a: A, b: B, c: C, d: D) -> F::Value {
    #[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
    {
        match fma::Fma::detect() {
            Some(fma) => fma.value::<F, A, B, C, D>(a, b, c, d),
            None => fma::without::<F, A, B, C, D>(a, b, c, d),
        }
    }
    #[cfg(not(all(target_arch = "x86_64", not(target_feature = "fma"))))]
    {
        F::value(a, b, c, d)
    }
}

#[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
mod fma {
    use super::Formula;

    /// The proof that this processor has fused multiply-add: [`Fma::detect`] is
    /// the only way to one.
    #[derive(Clone, Copy)]
    pub(super) struct Fma(());

    impl Fma {
        /// The proof, if there is one: a load and a test.
        #[inline(always)]
        pub(super) fn detect() -> Option<Self> {
            is_x86_feature_detected!("fma").then_some(Self(()))
        }

        // It is the proof.
        #[allow(clippy::unused_self)]
        #[inline(always)]
        pub(super) fn value<F: Formula<A, B, C, D>, A, B, C, D>(
            self,
            a: A,
            b: B,
            c: C,
            d: D,
        ) -> F::Value {
            #[target_feature(enable = "fma")]
            fn compiled<F: Formula<A, B, C, D>, A, B, C, D>(a: A, b: B, c: C, d: D) -> F::Value {
                F::value(a, b, c, d)
            }
            // SAFETY: `self` proves that the processor has it.
            unsafe { compiled::<F, A, B, C, D>(a, b, c, d) }
        }
    }

    /// Out of the way of those who have it.
    #[cold]
    #[inline(never)]
    pub(super) fn without<F: Formula<A, B, C, D>, A, B, C, D>(a: A, b: B, c: C, d: D) -> F::Value {
        F::value(a, b, c, d)
    }
}

#[cfg(test)]
mod tests {
    use super::{Formula, fused};

    struct MulAdd;

    impl Formula<f64, f64, f64, ()> for MulAdd {
        type Value = f64;
        #[inline(always)]
        fn value(a: f64, b: f64, c: f64, (): ()) -> f64 {
            a.mul_add(b, c)
        }
    }

    #[track_caller]
    fn check(a: f64, b: f64, c: f64, expected: f64) {
        assert_eq!(fused::<MulAdd, _, _, _, _>(a, b, c, ()).to_bits(), expected.to_bits());
        #[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
        assert_eq!(
            super::fma::without::<MulAdd, _, _, _, _>(a, b, c, ()).to_bits(),
            expected.to_bits()
        );
    }

    #[test]
    fn one_rounding_with_the_instruction_and_without() {
        let x = 1.0 + f64::EPSILON;
        check(x, x, -(1.0 + 2.0 * f64::EPSILON), f64::EPSILON * f64::EPSILON);
        check(-0.0, 0.0, 0.0, 0.0);
        check(-0.0, 0.0, -0.0, -0.0);
        check(f64::MAX, 2.0, f64::NEG_INFINITY, f64::NEG_INFINITY);
        check(5e-324, 0.5, 5e-324, 5e-324 * 2.0);
    }
}
