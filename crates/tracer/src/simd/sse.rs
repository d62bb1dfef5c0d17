//! SSE2, two vectors of four or of two for each: what every x86-64 has.
#![allow(unsafe_code)]

use std::arch::x86_64::{
    __m128, __m128d, _MM_HINT_T0, _mm_add_pd, _mm_add_ps, _mm_and_pd, _mm_and_ps, _mm_andnot_pd,
    _mm_andnot_ps, _mm_cmpgt_pd, _mm_cmpgt_ps, _mm_cmple_pd, _mm_cmple_ps, _mm_cvtpd_ps,
    _mm_cvtps_pd, _mm_div_pd, _mm_div_ps, _mm_loadu_pd, _mm_loadu_ps, _mm_max_pd, _mm_max_ps,
    _mm_min_pd, _mm_min_ps, _mm_movehl_ps, _mm_movelh_ps, _mm_movemask_pd, _mm_movemask_ps,
    _mm_mul_pd, _mm_mul_ps, _mm_prefetch, _mm_set1_pd, _mm_set1_ps, _mm_setzero_pd, _mm_setzero_ps,
    _mm_storeu_pd, _mm_storeu_ps, _mm_sub_pd, _mm_sub_ps, _mm_xor_pd, _mm_xor_ps,
};

use super::{Eight, Four, LINE, LINES, Real, Simd, Work};

/// SSE2 belongs to x86-64 itself, for which this file is compiled: so every
/// `unsafe` block below may use it, and says what else it needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Sse(());

impl Sse {
    /// Every x86-64 has it.
    pub(super) const EVERYWHERE: Self = Self(());
}

/// Eight `f32`.
#[derive(Clone, Copy)]
pub(crate) struct Singles8([__m128; 2]);

/// Four `f32`.
#[derive(Clone, Copy)]
pub(crate) struct Singles4(__m128);

/// Four `f64`.
#[derive(Clone, Copy)]
pub(crate) struct Doubles4([__m128d; 2]);

impl Simd for Sse {
    type F8 = Singles8;
    type F4 = Singles4;
    type D4 = Doubles4;

    #[inline(always)]
    fn eight(self, x: f32) -> Singles8 {
        // SAFETY: SSE2.
        Singles8([unsafe { _mm_set1_ps(x) }; 2])
    }
    #[inline(always)]
    fn load_eight(self, x: &[f32; 8]) -> Singles8 {
        // SAFETY: SSE2; eight numbers are there to read, at any alignment.
        Singles8(unsafe { [_mm_loadu_ps(x.as_ptr()), _mm_loadu_ps(x[4..].as_ptr())] })
    }
    #[inline(always)]
    fn four(self, x: f32) -> Singles4 {
        // SAFETY: SSE2.
        Singles4(unsafe { _mm_set1_ps(x) })
    }
    #[inline(always)]
    fn load_four(self, x: &[f32; 4]) -> Singles4 {
        // SAFETY: SSE2; four numbers are there to read, at any alignment.
        Singles4(unsafe { _mm_loadu_ps(x.as_ptr()) })
    }
    #[inline(always)]
    fn narrow_four(self, x: &[f64; 4]) -> Singles4 {
        narrowed(self.load_four_long(x))
    }
    #[inline(always)]
    fn four_long(self, x: f64) -> Doubles4 {
        // SAFETY: SSE2.
        Doubles4([unsafe { _mm_set1_pd(x) }; 2])
    }
    #[inline(always)]
    fn load_four_long(self, x: &[f64; 4]) -> Doubles4 {
        // SAFETY: SSE2; four numbers are there to read, at any alignment.
        Doubles4(unsafe { [_mm_loadu_pd(x.as_ptr()), _mm_loadu_pd(x[2..].as_ptr())] })
    }
    #[inline(always)]
    fn widen_four(self, x: &[f32; 4]) -> Doubles4 {
        widened(self.load_four(x))
    }
    #[inline(always)]
    fn prefetch(self, from: *const u8) {
        for line in 0..LINES {
            let at = from.wrapping_add(LINE * line).cast();
            // SAFETY: SSE2; a hint, which reads nothing.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(at) };
        }
    }
    #[inline(never)]
    fn apart<W: Work>(self, work: W) -> W::Output {
        work.run(self)
    }
}

#[inline(always)]
fn widened(Singles4(x): Singles4) -> Doubles4 {
    // SAFETY: SSE2.
    Doubles4(unsafe { [_mm_cvtps_pd(x), _mm_cvtps_pd(_mm_movehl_ps(x, x))] })
}

#[inline(always)]
fn narrowed(Doubles4([low, high]): Doubles4) -> Singles4 {
    // SAFETY: SSE2.
    Singles4(unsafe { _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high)) })
}

impl Eight for Singles8 {
    #[inline(always)]
    fn less(self, other: Self) -> Self {
        // SAFETY: SSE2.
        Self([0, 1].map(|k| unsafe { _mm_sub_ps(self.0[k], other.0[k]) }))
    }
    #[inline(always)]
    fn times(self, times: Self) -> Self {
        // SAFETY: SSE2.
        Self([0, 1].map(|k| unsafe { _mm_mul_ps(self.0[k], times.0[k]) }))
    }
    #[inline(always)]
    fn times_plus(self, times: Self, plus: Self) -> Self {
        // SAFETY: SSE2.
        Self([0, 1].map(|k| unsafe { _mm_add_ps(_mm_mul_ps(self.0[k], times.0[k]), plus.0[k]) }))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: SSE2.
        Self([0, 1].map(|k| unsafe { _mm_min_ps(self.0[k], other.0[k]) }))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: SSE2.
        Self([0, 1].map(|k| unsafe { _mm_max_ps(self.0[k], other.0[k]) }))
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        // SAFETY: SSE2.
        let [low, high] =
            [0, 1].map(|k| unsafe { _mm_movemask_ps(_mm_cmple_ps(self.0[k], other.0[k])) as u32 });
        low | high << 4
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        let mut array = [0.0; 8];
        let (low, high) = array.split_at_mut(4);
        // SAFETY: SSE2; four numbers fit into each half, at any alignment.
        unsafe {
            _mm_storeu_ps(low.as_mut_ptr(), self.0[0]);
            _mm_storeu_ps(high.as_mut_ptr(), self.0[1]);
        }
        array
    }
}

operators!(
    Singles4,
    // SAFETY: SSE2, in all of these.
    |a: Self, b: Self| Self(unsafe { _mm_add_ps(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm_sub_ps(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm_mul_ps(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm_div_ps(a.0, b.0) }),
    |a: Self| Self(unsafe { _mm_xor_ps(a.0, _mm_set1_ps(-0.0)) })
);

impl Real for Singles4 {
    #[inline(always)]
    fn fused(self, times: Self, plus: Self) -> Self {
        let (a, b, c) = (self.to_singles(), times.to_singles(), plus.to_singles());
        Sse::EVERYWHERE.load_four(&fused_singles(&a, &b, &c))
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        // SAFETY: SSE2.
        Self(unsafe { _mm_andnot_ps(_mm_set1_ps(-0.0), self.0) })
    }
    #[inline(always)]
    fn like(self, x: f64) -> Self {
        // SAFETY: SSE2.
        Self(unsafe { _mm_set1_ps(x as f32) })
    }
    #[inline(always)]
    fn where_positive(self, test: Self) -> Self {
        // SAFETY: SSE2.
        Self(unsafe { _mm_and_ps(_mm_cmpgt_ps(test.0, _mm_setzero_ps()), self.0) })
    }
}

impl Four for Singles4 {
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
        // SAFETY: SSE2.
        Self(unsafe { _mm_min_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: SSE2.
        Self(unsafe { _mm_max_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        // SAFETY: SSE2.
        unsafe { _mm_movemask_ps(_mm_cmple_ps(self.0, other.0)) as u32 }
    }
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        widened(self).to_array()
    }
    #[inline(always)]
    fn to_singles(self) -> [f32; 4] {
        let mut array = [0.0; 4];
        // SAFETY: SSE2; four numbers fit, at any alignment.
        unsafe { _mm_storeu_ps(array.as_mut_ptr(), self.0) };
        array
    }
}

operators!(
    Doubles4,
    // SAFETY: SSE2, in all of these.
    |a: Self, b: Self| Self([0, 1].map(|k| unsafe { _mm_add_pd(a.0[k], b.0[k]) })),
    |a: Self, b: Self| Self([0, 1].map(|k| unsafe { _mm_sub_pd(a.0[k], b.0[k]) })),
    |a: Self, b: Self| Self([0, 1].map(|k| unsafe { _mm_mul_pd(a.0[k], b.0[k]) })),
    |a: Self, b: Self| Self([0, 1].map(|k| unsafe { _mm_div_pd(a.0[k], b.0[k]) })),
    |a: Self| Self(a.0.map(|a| unsafe { _mm_xor_pd(a, _mm_set1_pd(-0.0)) }))
);

impl Real for Doubles4 {
    #[inline(always)]
    fn fused(self, times: Self, plus: Self) -> Self {
        let (a, b, c) = (self.to_array(), times.to_array(), plus.to_array());
        Sse::EVERYWHERE.load_four_long(&fused_doubles(&a, &b, &c))
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        // SAFETY: SSE2.
        Self(self.0.map(|x| unsafe { _mm_andnot_pd(_mm_set1_pd(-0.0), x) }))
    }
    #[inline(always)]
    fn like(self, x: f64) -> Self {
        // SAFETY: SSE2.
        Self([unsafe { _mm_set1_pd(x) }; 2])
    }
    #[inline(always)]
    fn where_positive(self, test: Self) -> Self {
        // SAFETY: SSE2.
        Self(
            [0, 1].map(|k| unsafe {
                _mm_and_pd(_mm_cmpgt_pd(test.0[k], _mm_setzero_pd()), self.0[k])
            }),
        )
    }
}

impl Four for Doubles4 {
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
        // SAFETY: SSE2.
        Self([0, 1].map(|k| unsafe { _mm_min_pd(self.0[k], other.0[k]) }))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: SSE2.
        Self([0, 1].map(|k| unsafe { _mm_max_pd(self.0[k], other.0[k]) }))
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        // SAFETY: SSE2.
        let [low, high] =
            [0, 1].map(|k| unsafe { _mm_movemask_pd(_mm_cmple_pd(self.0[k], other.0[k])) as u32 });
        low | high << 2
    }
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        let mut array = [0.0; 4];
        let (low, high) = array.split_at_mut(2);
        // SAFETY: SSE2; two numbers fit into each half, at any alignment.
        unsafe {
            _mm_storeu_pd(low.as_mut_ptr(), self.0[0]);
            _mm_storeu_pd(high.as_mut_ptr(), self.0[1]);
        }
        array
    }
    #[inline(always)]
    fn to_singles(self) -> [f32; 4] {
        narrowed(self).to_singles()
    }
}

/// `a b + c` of four, rounded once. Each is a call of a function here, which is
/// not repeated wherever a formula needs one: there are hundreds.
#[inline(never)]
fn fused_singles(a: &[f32; 4], b: &[f32; 4], c: &[f32; 4]) -> [f32; 4] {
    std::array::from_fn(|k| a[k].mul_add(b[k], c[k]))
}

/// [`fused_singles`] of numbers twice as long.
#[inline(never)]
fn fused_doubles(a: &[f64; 4], b: &[f64; 4], c: &[f64; 4]) -> [f64; 4] {
    std::array::from_fn(|k| a[k].mul_add(b[k], c[k]))
}
