//! Vectors of a few numbers for the hierarchy's hot loops: the one module with
//! `unsafe` in it.
//!
//! What is computed here decides only what need not be looked at: its results
//! may differ by a rounding from one [`Level`] to another, and whoever uses them
//! allows for that. No level changes an answer.
//!
//! Everything is `#[inline(always)]`, so that it is compiled into a function of
//! [`Level::run`] that has the instructions.

/// The operators of four numbers, from functions of two.
macro_rules! operators {
    ($name:ty, $plus:expr, $minus:expr, $times:expr, $over:expr, $negative:expr) => {
        operators!(one $name, Add, add, $plus);
        operators!(one $name, Sub, sub, $minus);
        operators!(one $name, Mul, mul, $times);
        operators!(one $name, Div, div, $over);
        impl std::ops::Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                $negative(self)
            }
        }
    };
    (one $name:ty, $operator:ident, $function:ident, $does:expr) => {
        impl std::ops::$operator for $name {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                $does(self, other)
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
mod avx2;
mod axis;
mod fused;
mod instructions;
#[cfg(any(test, debug_assertions, not(target_arch = "x86_64")))]
mod portable;
#[cfg(target_arch = "x86_64")]
mod sse;
mod stack;

use crate::math::Real;

pub(crate) use axis::{Axis, Side};
pub(crate) use fused::{Formula, fused};
pub use instructions::Instructions;
pub(crate) use stack::{Room, Stack};

/// Bytes in a line of the cache, and how many lines are worth fetching early.
const LINE: usize = 64;
const LINES: usize = 4;

/// A set of instructions that this processor has.
pub(crate) trait Simd: Copy {
    /// Eight `f32`.
    type F8: Eight;
    /// Four `f32`.
    type F4: Four;
    /// Four `f64`.
    type D4: Four;

    /// Eight times `x`.
    fn eight(self, x: f32) -> Self::F8;
    /// Eight numbers.
    fn load_eight(self, x: &[f32; 8]) -> Self::F8;
    /// Four times `x`.
    fn four(self, x: f32) -> Self::F4;
    /// Four numbers.
    fn load_four(self, x: &[f32; 4]) -> Self::F4;
    /// Four numbers, each rounded.
    fn narrow_four(self, x: &[f64; 4]) -> Self::F4;
    /// Four times `x`.
    fn four_long(self, x: f64) -> Self::D4;
    /// Four numbers.
    fn load_four_long(self, x: &[f64; 4]) -> Self::D4;
    /// Four numbers, exactly.
    fn widen_four(self, x: &[f32; 4]) -> Self::D4;
    /// Says that the few lines of the cache from here on will be read soon; they
    /// need not be there.
    fn prefetch(self, from: *const u8);
    /// Does the work with these instructions, in a function of its own: for what
    /// is long and asked from many places, each of which would be a copy.
    fn apart<W: Work>(self, work: W) -> W::Output;
}

/// Eight numbers of `f32`.
pub(crate) trait Eight: Copy {
    /// `self - other`.
    fn less(self, other: Self) -> Self;
    /// `self times`.
    fn times(self, times: Self) -> Self;
    /// `self times + plus`, rounded once or twice.
    fn times_plus(self, times: Self, plus: Self) -> Self;
    /// The lower of each; `other`'s where one is a NaN.
    fn min(self, other: Self) -> Self;
    /// The higher of each; `other`'s where one is a NaN.
    fn max(self, other: Self) -> Self;
    /// A bit for each that is at most the other's; not for a NaN.
    fn is_at_most(self, other: Self) -> u32;
    /// The numbers.
    fn to_array(self) -> [f32; 8];
}

/// Four numbers. The operators round each once.
pub(crate) trait Four: Real {
    /// `self + a b`, rounded once or twice.
    fn plus_product(self, a: Self, b: Self) -> Self;
    /// `self - a b`, rounded once or twice.
    fn minus_product(self, a: Self, b: Self) -> Self;
    /// The lower of each; `other`'s where one is a NaN.
    fn min(self, other: Self) -> Self;
    /// The higher of each; `other`'s where one is a NaN.
    fn max(self, other: Self) -> Self;
    /// A bit for each that is at most the other's; not for a NaN.
    fn is_at_most(self, other: Self) -> u32;
    /// The numbers.
    fn to_array(self) -> [f64; 4];
    /// The numbers, rounded.
    fn to_singles(self) -> [f32; 4];
}

/// Does the work with the instructions that every processor of the target has:
/// for what nobody waits for, so that it is compiled for these alone.
#[inline]
pub(crate) fn run_plainly<W: Work>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    {
        work.run(sse::Sse::EVERYWHERE)
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        work.run(portable::Portable)
    }
}

/// Work that is compiled for every level; `run` must be `#[inline(always)]`.
pub(crate) trait Work {
    /// What comes of it.
    type Output;
    /// Does it.
    fn run<S: Simd>(self, simd: S) -> Self::Output;
}

/// Which instructions are used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Level {
    /// Those that every processor of the target has: for targets without a level
    /// of their own, for tests, and for debug builds, where `calibrate` asks for
    /// it; elsewhere it would be compiled for nobody.
    #[cfg(any(test, debug_assertions, not(target_arch = "x86_64")))]
    Portable,
    /// SSE2, which every x86-64 has.
    #[cfg(target_arch = "x86_64")]
    Sse(sse::Sse),
    /// AVX2, FMA and BMI.
    #[cfg(target_arch = "x86_64")]
    Avx2(avx2::Avx2),
}

impl Level {
    /// The best that this processor has.
    pub(crate) fn best() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            avx2::Avx2::detect().map_or(Self::Sse(sse::Sse::EVERYWHERE), Self::Avx2)
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            Self::Portable
        }
    }

    /// All that this processor has and that are compiled, the best last.
    pub(crate) fn all() -> Vec<Self> {
        let mut all = Vec::new();
        #[cfg(any(test, debug_assertions, not(target_arch = "x86_64")))]
        all.push(Self::Portable);
        #[cfg(target_arch = "x86_64")]
        {
            all.push(Self::Sse(sse::Sse::EVERYWHERE));
            all.extend(avx2::Avx2::detect().map(Self::Avx2));
        }
        all
    }

    /// Does the work with these instructions.
    #[inline]
    pub(crate) fn run<W: Work>(self, work: W) -> W::Output {
        match self {
            #[cfg(any(test, debug_assertions, not(target_arch = "x86_64")))]
            Self::Portable => work.run(portable::Portable),
            #[cfg(target_arch = "x86_64")]
            Self::Sse(sse) => work.run(sse),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(avx2) => avx2.run(work),
        }
    }
}

#[cfg(test)]
mod tests;
