//! The level of every processor: arrays, which the compiler may make vectors of.

use super::{Eight, Four, Real, Simd, Work};

/// No instructions but those of the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Portable;

/// `N` numbers of `f32`.
#[derive(Clone, Copy)]
pub(crate) struct Singles<const N: usize>([f32; N]);

/// Four numbers of `f64`.
#[derive(Clone, Copy)]
pub(crate) struct Doubles([f64; 4]);

impl Simd for Portable {
    type F8 = Singles<8>;
    type F4 = Singles<4>;
    type D4 = Doubles;

    #[inline(always)]
    fn eight(self, x: f32) -> Singles<8> {
        Singles([x; 8])
    }
    #[inline(always)]
    fn load_eight(self, x: &[f32; 8]) -> Singles<8> {
        Singles(*x)
    }
    #[inline(always)]
    fn four(self, x: f32) -> Singles<4> {
        Singles([x; 4])
    }
    #[inline(always)]
    fn load_four(self, x: &[f32; 4]) -> Singles<4> {
        Singles(*x)
    }
    #[inline(always)]
    fn narrow_four(self, x: &[f64; 4]) -> Singles<4> {
        Singles(x.map(|x| x as f32))
    }
    #[inline(always)]
    fn four_long(self, x: f64) -> Doubles {
        Doubles([x; 4])
    }
    #[inline(always)]
    fn load_four_long(self, x: &[f64; 4]) -> Doubles {
        Doubles(*x)
    }
    #[inline(always)]
    fn widen_four(self, x: &[f32; 4]) -> Doubles {
        Doubles(x.map(f64::from))
    }
    #[inline(always)]
    fn prefetch(self, _: *const u8) {}
    #[inline(never)]
    fn apart<W: Work>(self, work: W) -> W::Output {
        work.run(self)
    }
}

macro_rules! lanes {
    ($zip:ident, $bits:ident, $number:ty, $lanes:expr) => {
        /// Both, lane by lane.
        #[inline(always)]
        fn $zip(
            a: [$number; $lanes],
            b: [$number; $lanes],
            op: impl Fn($number, $number) -> $number,
        ) -> [$number; $lanes] {
            std::array::from_fn(|k| op(a[k], b[k]))
        }

        /// A bit for each lane of which the first is at most the second.
        #[inline(always)]
        fn $bits(a: [$number; $lanes], b: [$number; $lanes]) -> u32 {
            (0..$lanes).fold(0, |bits, k| bits | u32::from(a[k] <= b[k]) << k)
        }
    };
}
lanes!(zip8, at_most8, f32, 8);
lanes!(zip4, at_most4, f32, 4);
lanes!(zip4_long, at_most4_long, f64, 4);

impl Eight for Singles<8> {
    #[inline(always)]
    fn less(self, other: Self) -> Self {
        Self(zip8(self.0, other.0, |a, b| a - b))
    }
    #[inline(always)]
    fn times(self, times: Self) -> Self {
        Self(zip8(self.0, times.0, |a, b| a * b))
    }
    #[inline(always)]
    fn times_plus(self, times: Self, plus: Self) -> Self {
        Self(zip8(zip8(self.0, times.0, |a, b| a * b), plus.0, |a, b| a + b))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(zip8(self.0, other.0, |a, b| if a < b { a } else { b }))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(zip8(self.0, other.0, |a, b| if a > b { a } else { b }))
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        at_most8(self.0, other.0)
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        self.0
    }
}

macro_rules! four {
    ($name:ty, $number:ty, $zip:ident, $at_most:ident, $widen:expr) => {
        operators!(
            $name,
            |a: Self, b: Self| Self($zip(a.0, b.0, |a, b| a + b)),
            |a: Self, b: Self| Self($zip(a.0, b.0, |a, b| a - b)),
            |a: Self, b: Self| Self($zip(a.0, b.0, |a, b| a * b)),
            |a: Self, b: Self| Self($zip(a.0, b.0, |a, b| a / b)),
            |a: Self| Self(a.0.map(|a| -a))
        );

        impl Real for $name {
            #[inline(always)]
            fn fused(self, times: Self, plus: Self) -> Self {
                let (a, b, c) = (self.0, times.0, plus.0);
                Self(std::array::from_fn(|k| a[k].mul_add(b[k], c[k])))
            }
            #[inline(always)]
            fn magnitude(self) -> Self {
                Self(self.0.map(|x| x.abs()))
            }
            #[inline(always)]
            fn like(self, x: f64) -> Self {
                Self([x as $number; 4])
            }
            #[inline(always)]
            fn where_positive(self, test: Self) -> Self {
                Self($zip(self.0, test.0, |x, test| if test > 0.0 { x } else { 0.0 }))
            }
        }

        impl Four for $name {
            #[inline(always)]
            fn plus_product(self, a: Self, b: Self) -> Self {
                self + a * b
            }
            #[inline(always)]
            fn minus_product(self, a: Self, b: Self) -> Self {
                self - a * b
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self($zip(self.0, other.0, |a, b| if a < b { a } else { b }))
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self($zip(self.0, other.0, |a, b| if a > b { a } else { b }))
            }
            #[inline(always)]
            fn is_at_most(self, other: Self) -> u32 {
                $at_most(self.0, other.0)
            }
            #[inline(always)]
            fn to_array(self) -> [f64; 4] {
                self.0.map($widen)
            }
            #[inline(always)]
            fn to_singles(self) -> [f32; 4] {
                self.0.map(|x| x as f32)
            }
        }
    };
}
four!(Singles<4>, f32, zip4, at_most4, f64::from);
four!(Doubles, f64, zip4_long, at_most4_long, |x| x);
