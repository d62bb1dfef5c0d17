//! `Refused`: why a constructor did not take its numbers, all reasons at once.
//!
//! The checks of this file are the only place that says which numbers the
//! tracer accepts; a scene file's errors are these, with a line and column.

use std::fmt;

use glam::DVec3;

/// The largest coordinate or length accepted. Fourth powers of it, which the
/// formulas form, stay finite.
pub(crate) const MAX_LENGTH: f64 = 1e60;

/// The smallest length accepted where zero makes no sense: fourth powers of
/// it stay normal numbers.
pub(crate) const MIN_LENGTH: f64 = 1e-60;

/// The largest channel of a color, intensity or factor accepted.
const MAX_RADIANCE: f64 = 1e60;

/// One argument that a constructor did not take.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The argument's name, as in the constructor's documentation.
    pub field: &'static str,
    /// What would have been taken, as the end of "expected ...".
    pub expected: String,
    /// What was given.
    pub found: String,
}

/// Everything a constructor found wrong with its arguments; never empty.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused(Vec<Refusal>);

impl Refused {
    /// `Ok` where no check found anything.
    ///
    /// # Errors
    /// All that the checks found.
    pub fn unless<const N: usize>(checks: [Option<Refusal>; N]) -> Result<(), Self> {
        let refusals: Vec<_> = checks.into_iter().flatten().collect();
        if refusals.is_empty() { Ok(()) } else { Err(Self(refusals)) }
    }

    /// The reasons, in the order of the arguments.
    pub fn refusals(&self) -> &[Refusal] {
        &self.0
    }
}

impl From<Refusal> for Refused {
    fn from(refusal: Refusal) -> Self {
        Self(vec![refusal])
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, Refusal { field, expected, found }) in self.0.iter().enumerate() {
            let comma = if i == 0 { "" } else { "; " };
            write!(f, "{comma}`{field}`: expected {expected}, found {found}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Refused {}

/// Whether a number may be a coordinate.
fn is_coordinate(x: f64) -> bool {
    x.abs() <= MAX_LENGTH
}

/// A refusal unless `accepted`.
pub(crate) fn refuse_unless(
    accepted: bool,
    field: &'static str,
    expected: impl Into<String>,
    found: impl FnOnce() -> String,
) -> Option<Refusal> {
    (!accepted).then(|| Refusal { field, expected: expected.into(), found: found() })
}

/// How a vector is written in a message.
pub(crate) fn show(v: DVec3) -> String {
    format!("({}, {}, {})", number(v.x), number(v.y), number(v.z))
}

/// How a number is written in a message: one too long to read, by its power of
/// ten.
pub(crate) fn number(x: f64) -> String {
    let is_short = x == 0.0 || !x.is_finite() || (1e-6..1e15).contains(&x.abs());
    if is_short { x.to_string() } else { format!("{x:e}") }
}

/// A point: three finite coordinates.
pub(crate) fn point(field: &'static str, p: DVec3) -> Option<Refusal> {
    let accepted = p.to_array().into_iter().all(is_coordinate);
    (!accepted).then(|| Refusal {
        field,
        expected: format!("three finite numbers of at most {MAX_LENGTH:e}"),
        found: show(p),
    })
}

/// A direction: finite and not zero.
pub(crate) fn direction(field: &'static str, d: DVec3) -> Option<Refusal> {
    let length = max_abs_of(d);
    let accepted = d.is_finite() && (MIN_LENGTH..=MAX_LENGTH).contains(&length);
    (!accepted).then(|| Refusal {
        field,
        expected: format!(
            "a direction, three numbers of at most {MAX_LENGTH:e} that are not all zero"
        ),
        found: show(d),
    })
}

/// A length above zero.
pub(crate) fn length(field: &'static str, x: f64) -> Option<Refusal> {
    let accepted = (MIN_LENGTH..=MAX_LENGTH).contains(&x);
    (!accepted).then(|| Refusal {
        field,
        expected: format!("a finite number above 0 (from {MIN_LENGTH:e} to {MAX_LENGTH:e})"),
        found: number(x),
    })
}

/// A number of zero or more.
pub(crate) fn not_negative(field: &'static str, x: f64) -> Option<Refusal> {
    refuse_unless(
        (0.0..=MAX_RADIANCE).contains(&x),
        field,
        format!("a number from 0 to {MAX_RADIANCE:e}"),
        || number(x),
    )
}

/// A color, an intensity or a reflectance: three finite numbers, none negative.
pub(crate) fn color(field: &'static str, c: crate::Rgb) -> Option<Refusal> {
    refuse_unless(
        c.channels().into_iter().all(|x| (0.0..=MAX_RADIANCE).contains(&x)),
        field,
        format!("three numbers from 0 to {MAX_RADIANCE:e}"),
        || show(DVec3::from_array(c.channels())),
    )
}

/// A share of light in each channel, none above 1.
pub(crate) fn share(field: &'static str, c: crate::Rgb) -> Option<Refusal> {
    refuse_unless(
        c.channels().into_iter().all(|x| (0.0..=1.0).contains(&x)),
        field,
        "three numbers from 0 to 1",
        || show(DVec3::from_array(c.channels())),
    )
}

/// An index of refraction, relative to what is around.
pub(crate) fn index(field: &'static str, ior: f64) -> Option<Refusal> {
    /// Far beyond what there is, and far from where squares lose bits.
    const INDICES: std::ops::RangeInclusive<f64> = 0.01..=100.0;
    let (least, most) = (INDICES.start(), INDICES.end());
    refuse_unless(
        INDICES.contains(&ior),
        field,
        format!("a number from {least} to {most}, such as 1.5"),
        || number(ior),
    )
}

/// The largest absolute component; NaN where any is.
fn max_abs_of(v: DVec3) -> f64 {
    if v.is_nan() { f64::NAN } else { crate::math::max_abs(v) }
}
