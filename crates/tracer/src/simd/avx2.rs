//! AVX2, FMA and BMI: what x86-64 processors have since about 2013.
#![allow(unsafe_code)]

use std::arch::x86_64::{
    __m128, __m256, __m256d, _CMP_GT_OQ, _CMP_LE_OQ, _MM_HINT_T0, _mm_add_ps, _mm_and_ps,
    _mm_andnot_ps, _mm_cmpgt_ps, _mm_cmple_ps, _mm_div_ps, _mm_fmadd_ps, _mm_fnmadd_ps,
    _mm_loadu_ps, _mm_max_ps, _mm_min_ps, _mm_movemask_ps, _mm_mul_ps, _mm_prefetch, _mm_set1_ps,
    _mm_setzero_ps, _mm_storeu_ps, _mm_sub_ps, _mm_xor_ps, _mm256_add_pd, _mm256_and_pd,
    _mm256_andnot_pd, _mm256_cmp_pd, _mm256_cmp_ps, _mm256_cvtpd_ps, _mm256_cvtps_pd,
    _mm256_div_pd, _mm256_fmadd_pd, _mm256_fmadd_ps, _mm256_fnmadd_pd, _mm256_loadu_pd,
    _mm256_loadu_ps, _mm256_max_pd, _mm256_max_ps, _mm256_min_pd, _mm256_min_ps,
    _mm256_movemask_pd, _mm256_movemask_ps, _mm256_mul_pd, _mm256_mul_ps, _mm256_set1_pd,
    _mm256_set1_ps, _mm256_setzero_pd, _mm256_storeu_pd, _mm256_storeu_ps, _mm256_sub_pd,
    _mm256_sub_ps, _mm256_xor_pd,
};

use super::{Eight, Four, LINE, LINES, Real, Simd, Work};

/// The proof that this processor has AVX2, FMA and BMI: [`Avx2::detect`] is the
/// only way to one, and every vector below is made from one or from others of
/// its kind. So all functions of this file may use these instructions: each
/// `unsafe` block calls one that has no other condition, or says which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Avx2(());

impl Avx2 {
    /// The proof, if there is one.
    pub(crate) fn detect() -> Option<Self> {
        let has_all = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("lzcnt")
            && is_x86_feature_detected!("popcnt");
        has_all.then_some(Self(()))
    }

    /// Does the work in a function that is compiled for these instructions.
    #[inline]
    pub(super) fn run<W: Work>(self, work: W) -> W::Output {
        #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
        fn compiled<W: Work>(work: W, avx2: Avx2) -> W::Output {
            work.run(avx2)
        }
        // SAFETY: `self` proves that the processor has them.
        unsafe { compiled(work, self) }
    }
}

/// Eight `f32`.
#[derive(Clone, Copy)]
pub(crate) struct Singles8(__m256);

/// Four `f32`.
#[derive(Clone, Copy)]
pub(crate) struct Singles4(__m128);

/// Four `f64`.
#[derive(Clone, Copy)]
pub(crate) struct Doubles4(__m256d);

impl Simd for Avx2 {
    type F8 = Singles8;
    type F4 = Singles4;
    type D4 = Doubles4;

    #[inline(always)]
    fn eight(self, x: f32) -> Singles8 {
        // SAFETY: `self`.
        Singles8(unsafe { _mm256_set1_ps(x) })
    }
    #[inline(always)]
    fn load_eight(self, x: &[f32; 8]) -> Singles8 {
        // SAFETY: `self`; eight numbers are there to read, at any alignment.
        Singles8(unsafe { _mm256_loadu_ps(x.as_ptr()) })
    }
    #[inline(always)]
    fn four(self, x: f32) -> Singles4 {
        // SAFETY: `self`.
        Singles4(unsafe { _mm_set1_ps(x) })
    }
    #[inline(always)]
    fn load_four(self, x: &[f32; 4]) -> Singles4 {
        // SAFETY: `self`; four numbers are there to read, at any alignment.
        Singles4(unsafe { _mm_loadu_ps(x.as_ptr()) })
    }
    #[inline(always)]
    fn narrow_four(self, x: &[f64; 4]) -> Singles4 {
        // SAFETY: `self`; four numbers are there to read, at any alignment.
        Singles4(unsafe { _mm256_cvtpd_ps(_mm256_loadu_pd(x.as_ptr())) })
    }
    #[inline(always)]
    fn four_long(self, x: f64) -> Doubles4 {
        // SAFETY: `self`.
        Doubles4(unsafe { _mm256_set1_pd(x) })
    }
    #[inline(always)]
    fn load_four_long(self, x: &[f64; 4]) -> Doubles4 {
        // SAFETY: `self`; four numbers are there to read, at any alignment.
        Doubles4(unsafe { _mm256_loadu_pd(x.as_ptr()) })
    }
    #[inline(always)]
    fn widen_four(self, x: &[f32; 4]) -> Doubles4 {
        // SAFETY: `self`; four numbers are there to read, at any alignment.
        Doubles4(unsafe { _mm256_cvtps_pd(_mm_loadu_ps(x.as_ptr())) })
    }
    #[inline(always)]
    fn prefetch(self, from: *const u8) {
        for line in 0..LINES {
            let at = from.wrapping_add(LINE * line).cast();
            // SAFETY: `self`; a hint, which reads nothing.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(at) };
        }
    }
    #[inline(always)]
    fn apart<W: Work>(self, work: W) -> W::Output {
        #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
        #[inline(never)]
        fn compiled<W: Work>(work: W, avx2: Avx2) -> W::Output {
            work.run(avx2)
        }
        // SAFETY: `self` proves that the processor has them.
        unsafe { compiled(work, self) }
    }
}

impl Eight for Singles8 {
    #[inline(always)]
    fn less(self, other: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_sub_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn times(self, times: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_mul_ps(self.0, times.0) })
    }
    #[inline(always)]
    fn times_plus(self, times: Self, plus: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_fmadd_ps(self.0, times.0, plus.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_min_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_max_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        // SAFETY: the type.
        unsafe { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(self.0, other.0)) as u32 }
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        let mut array = [0.0; 8];
        // SAFETY: the type; eight numbers fit, at any alignment.
        unsafe { _mm256_storeu_ps(array.as_mut_ptr(), self.0) };
        array
    }
}

operators!(
    Singles4,
    // SAFETY: the type, in all of these.
    |a: Self, b: Self| Self(unsafe { _mm_add_ps(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm_sub_ps(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm_mul_ps(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm_div_ps(a.0, b.0) }),
    |a: Self| Self(unsafe { _mm_xor_ps(a.0, _mm_set1_ps(-0.0)) })
);

impl Real for Singles4 {
    #[inline(always)]
    fn fused(self, times: Self, plus: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_fmadd_ps(self.0, times.0, plus.0) })
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_andnot_ps(_mm_set1_ps(-0.0), self.0) })
    }
    #[inline(always)]
    fn like(self, x: f64) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_set1_ps(x as f32) })
    }
    #[inline(always)]
    fn where_positive(self, test: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_and_ps(_mm_cmpgt_ps(test.0, _mm_setzero_ps()), self.0) })
    }
}

impl Four for Singles4 {
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_fmadd_ps(a.0, b.0, self.0) })
    }
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_fnmadd_ps(a.0, b.0, self.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_min_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm_max_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        // SAFETY: the type.
        unsafe { _mm_movemask_ps(_mm_cmple_ps(self.0, other.0)) as u32 }
    }
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        // SAFETY: the type.
        Doubles4(unsafe { _mm256_cvtps_pd(self.0) }).to_array()
    }
    #[inline(always)]
    fn to_singles(self) -> [f32; 4] {
        let mut array = [0.0; 4];
        // SAFETY: the type; four numbers fit, at any alignment.
        unsafe { _mm_storeu_ps(array.as_mut_ptr(), self.0) };
        array
    }
}

operators!(
    Doubles4,
    // SAFETY: the type, in all of these.
    |a: Self, b: Self| Self(unsafe { _mm256_add_pd(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm256_sub_pd(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm256_mul_pd(a.0, b.0) }),
    |a: Self, b: Self| Self(unsafe { _mm256_div_pd(a.0, b.0) }),
    |a: Self| Self(unsafe { _mm256_xor_pd(a.0, _mm256_set1_pd(-0.0)) })
);

impl Real for Doubles4 {
    #[inline(always)]
    fn fused(self, times: Self, plus: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_fmadd_pd(self.0, times.0, plus.0) })
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn like(self, x: f64) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_set1_pd(x) })
    }
    #[inline(always)]
    fn where_positive(self, test: Self) -> Self {
        // SAFETY: the type.
        let is_positive = unsafe { _mm256_cmp_pd::<_CMP_GT_OQ>(test.0, _mm256_setzero_pd()) };
        // SAFETY: the type.
        Self(unsafe { _mm256_and_pd(is_positive, self.0) })
    }
}

impl Four for Doubles4 {
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_fmadd_pd(a.0, b.0, self.0) })
    }
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_fnmadd_pd(a.0, b.0, self.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_min_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: the type.
        Self(unsafe { _mm256_max_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        // SAFETY: the type.
        unsafe { _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0)) as u32 }
    }
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        let mut array = [0.0; 4];
        // SAFETY: the type; four numbers fit, at any alignment.
        unsafe { _mm256_storeu_pd(array.as_mut_ptr(), self.0) };
        array
    }
    #[inline(always)]
    fn to_singles(self) -> [f32; 4] {
        // SAFETY: the type.
        Singles4(unsafe { _mm256_cvtpd_ps(self.0) }).to_singles()
    }
}
