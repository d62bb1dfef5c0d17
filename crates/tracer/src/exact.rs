//! `Exact`: numbers that are never rounded, for tests that hold the tracer's
//! bounds of its own errors against the truth.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};

/// A whole number times a power of two.
#[derive(Debug, Clone)]
pub(crate) struct Exact {
    whole: BigInt,
    power: i64,
}

impl Exact {
    /// A finite number.
    pub(crate) fn of(x: f64) -> Self {
        /// The bits of a fraction, and the exponent of the least `f64`.
        const FRACTION: u32 = 52;
        const LEAST: i64 = -1074;
        assert!(x.is_finite(), "{x} is no number");
        let bits = x.to_bits();
        let exponent = (bits >> FRACTION & 0x7ff).cast_signed();
        let fraction = bits & ((1 << FRACTION) - 1);
        let whole = if exponent == 0 { fraction } else { fraction | 1 << FRACTION };
        let sign = if x < 0.0 { Sign::Minus } else { Sign::Plus };
        let whole = BigInt::from_biguint(sign, whole.into());
        Self { whole, power: LEAST + (exponent - 1).max(0) }
    }

    /// -1, 0 or 1.
    pub(crate) fn signum(&self) -> i32 {
        match self.whole.sign() {
            Sign::Minus => -1,
            Sign::NoSign => 0,
            Sign::Plus => 1,
        }
    }

    /// The number but for a part in 2^52; 0 or
    /// infinite where it leaves the range of `f64`.
    pub(crate) fn about(&self) -> f64 {
        let shift = self.whole.bits().saturating_sub(60);
        let top: i64 = (&self.whole >> shift).try_into().unwrap();
        libm::ldexp(top as f64, i32::try_from(self.power + shift.cast_signed()).unwrap())
    }

    /// The highest `f64` that is not above it.
    pub(crate) fn below(&self) -> f64 {
        let mut x = self.about().next_up().next_up();
        while Self::of(x) > *self {
            x = x.next_down();
        }
        x
    }

    /// The lowest `f64` that is not below it.
    pub(crate) fn above(&self) -> f64 {
        -(-self).below()
    }

    /// Both as whole numbers times the same power of two.
    fn aligned(&self, other: &Self) -> [BigInt; 2] {
        let power = self.power.min(other.power);
        [self, other].map(|x| &x.whole << (x.power - power))
    }
}

impl PartialEq for Exact {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Exact {}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Exact {
    fn cmp(&self, other: &Self) -> Ordering {
        let [a, b] = self.aligned(other);
        a.cmp(&b)
    }
}

impl Add for &Exact {
    type Output = Exact;
    fn add(self, other: Self) -> Exact {
        let [a, b] = self.aligned(other);
        Exact { whole: a + b, power: self.power.min(other.power) }
    }
}

impl Sub for &Exact {
    type Output = Exact;
    fn sub(self, other: Self) -> Exact {
        self + &-other
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, other: Self) -> Exact {
        Exact { whole: &self.whole * &other.whole, power: self.power + other.power }
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { whole: -&self.whole, power: self.power }
    }
}

#[test]
fn nothing_is_rounded() {
    let [one, small] = [1.0, 1e-300].map(Exact::of);
    let sum = &one + &small;
    assert!(sum > one && &sum - &one == small);
    assert_eq!([sum.below(), sum.above()], [1.0, 1.0_f64.next_up()]);
    assert_eq!([(-&sum).below(), (-&sum).above()], [(-1.0_f64).next_down(), -1.0]);
    let third = Exact::of(1.0 / 3.0);
    let off = &one - &(&third * &Exact::of(3.0));
    assert_eq!(off.about(), f64::EPSILON / 4.0);
    assert_eq!([off.signum(), (-&off).signum(), Exact::of(-0.0).signum()], [1, -1, 0]);
    let least = f64::from_bits(1);
    assert_eq!([Exact::of(least).about(), Exact::of(-least).below()], [least, -least]);
    assert_eq!(Exact::of(f64::MAX).about(), f64::MAX);
}
