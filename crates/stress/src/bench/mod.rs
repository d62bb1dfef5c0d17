//! The bench of run time against error: every kernel and precision on the same
//! rays.
//!
//! What a number means:
//!
//! - Inputs are numbers of `f32`, so no precision loses anything on the way
//!   in, and the exact answer is that of the numbers as they are.
//! - An error is `|t - exact| / |exact|`. A `t` rounded correctly to `f64` is
//!   off by up to 1.1e-16, one rounded to `f32` by up to 6e-8.
//! - A case is misclassified if a kernel hits what is missed or misses what is
//!   hit. Ties count for neither.
//! - A ray leaks if it starts inside a closed mesh and no triangle is hit.
//! - A time is that of one ray against one primitive, called through the
//!   kernel's public function and out of line, on one thread, with the cases in
//!   the cache. What a method makes for a ray (the shear of Woop's method and
//!   of goldray's, a unit direction) is made for each test; in a mesh a ray's
//!   shear is made once for all triangles, so there both are faster than here.
//!
//! The default build for x86-64 has no instruction for `mul_add`, which then is
//! a call of a function with the same bits: goldray's triangle and
//! double-double pay for that. [`features`] says what the build has.

mod contest;
mod family;
mod measure;
mod mesh;
mod plot;
mod table;

use serde::Serialize;

pub use measure::Effort;
pub use plot::svg;
pub use table::text;

/// The name of the kernels that render.
const OURS: &str = "goldray";

/// Times that are within this factor are equal.
const SAME_TIME: f64 = 1.05;

/// What one kernel did on one family.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The primitive's name.
    pub primitive: &'static str,
    /// The family's name among the primitive's.
    pub family: &'static str,
    /// The method's name and its precision.
    pub kernel: &'static str,
    /// Nanoseconds per test.
    pub ns: f64,
    /// The median relative error of `t`; NaN, which is null in JSON, if the
    /// kernel has no hit right. So are the two below.
    pub error_p50: f64,
    /// What 99.9 % of the errors do not exceed.
    #[serde(rename = "error_p99.9")]
    pub error_p999: f64,
    /// The largest error.
    pub error_max: f64,
    /// Wrong hits and misses per million cases.
    pub misclassified_ppm: f64,
    /// Leaks per million rays aimed at seams of a mesh; 0 for families without.
    pub leaks_ppm: f64,
    /// Whether no other kernel of the family is better, as `mark_frontier`
    /// says.
    pub frontier: bool,
}

impl Row {
    /// Its error: larger is worse, and no right hit at all is worst.
    fn error(&self) -> f64 {
        if self.error_p999.is_nan() { f64::INFINITY } else { self.error_p999 }
    }

    /// Whether it is at most as slow as the other and has at most its error,
    /// and is better in one of them.
    fn beats(&self, other: &Self) -> bool {
        let (mine, its) = (self.error(), other.error());
        let as_fast = self.ns <= other.ns * SAME_TIME;
        as_fast && mine <= its && (mine < its || self.ns * SAME_TIME < other.ns)
    }

    /// Whether it takes a miss for a hit, a hit for a miss, or leaks.
    fn is_unsound(&self) -> bool {
        self.misclassified_ppm > 0.0 || self.leaks_ppm > 0.0
    }
}

/// What is written for machines.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// The version of this form.
    pub schema: u32,
    /// What the build has: [`features`].
    pub features: Vec<&'static str>,
    /// Family by family.
    pub rows: Vec<Row>,
}

/// The labels of all families, `primitive/family`.
pub fn labels() -> Vec<String> {
    family::all().iter().map(family::Family::label).collect()
}

/// Measures the families that `is_chosen` by their label, telling `begin` each
/// label before its turn. Takes a few seconds for each family.
pub fn run(
    is_chosen: impl Fn(&str) -> bool,
    effort: &Effort,
    mut begin: impl FnMut(&str),
) -> Report {
    let mut rows = Vec::new();
    for family in family::all() {
        if is_chosen(&family.label()) {
            begin(&family.label());
            let mut of_family = measure::rows(&family, effort);
            mark_frontier(&mut of_family);
            rows.extend(of_family);
        }
    }
    Report { schema: 1, features: features(), rows }
}

/// Marks the rows of one family that take no hit for a miss or a miss for a
/// hit, do not leak, and are not beaten by another such: none is at most as
/// slow and has at most the error, and is better in one. Times within 5 % are
/// equal.
fn mark_frontier(rows: &mut [Row]) {
    let on: Vec<_> = rows
        .iter()
        .map(|row| {
            let beaten = || rows.iter().any(|other| !other.is_unsound() && other.beats(row));
            !row.is_unsound() && !beaten()
        })
        .collect();
    for (row, on) in rows.iter_mut().zip(on) {
        row.frontier = on;
    }
}

/// What decides how fast this build is: the processor features it was built
/// with, and whether it was optimized.
pub fn features() -> Vec<&'static str> {
    let all = [
        (cfg!(target_arch = "x86_64"), "x86-64"),
        (cfg!(target_arch = "aarch64"), "aarch64"),
        (cfg!(target_feature = "sse4.1"), "sse4.1"),
        (cfg!(target_feature = "avx2"), "avx2"),
        // Always there on aarch64, where it has no name of its own.
        (cfg!(any(target_feature = "fma", target_arch = "aarch64")), "fma"),
        (cfg!(target_feature = "avx512f"), "avx512f"),
        (cfg!(debug_assertions), "not-optimized"),
    ];
    all.into_iter().filter_map(|(has, name)| has.then_some(name)).collect()
}

#[cfg(test)]
mod tests;
