//! How far [`Dd`] and [`Big`] agree on where rays meet spheres: what entitles
//! the fast number to answer for the slow one.
//!
//! The textbook quadratic is evaluated in both, on purpose with all its
//! cancellations: the records go where those are worst.

use std::cmp::Ordering;
use std::fmt;

use tracer::glam::DVec3;

use super::{Big, Dd, Number, V3};

/// A ray and a sphere, each component an exact number. Asked where
/// `|origin + t direction - center| = radius`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaySphere {
    /// The ray's origin.
    pub origin: DVec3,
    /// The ray's direction, of any length above 0.
    pub direction: DVec3,
    /// The sphere's center.
    pub center: DVec3,
    /// The sphere's radius.
    pub radius: f64,
}

/// The outcome of comparing [`Dd`] with [`Big`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Agreement {
    /// The records compared.
    pub records: u64,
    /// Those where both numbers find two distinct roots.
    pub hits: u64,
    /// Over all roots, the largest `|t_Dd - t_Big| / |t_Big|`. It contains the
    /// records' conditioning: 1e-12 from tangency, or a root a millionth of
    /// the way to the center, costs digits in any fixed precision.
    pub max_relative_difference: f64,
    /// The same, each difference divided not by the root but by what a
    /// relative error of 1 in every operation could do to it. A few `u^2`,
    /// with `u^2 = 2^-106 = 1.2e-32`, whatever the record.
    pub max_conditioned_difference: f64,
    /// Records whose discriminant is above, at or below zero in one number but
    /// not in the other, or not finite in either.
    pub sign_disagreements: u64,
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "oracle validated on {} records: max relative difference {:.1e} ({:.1e} of the \
             condition), sign disagreements {}",
            self.records,
            self.max_relative_difference,
            self.max_conditioned_difference,
            self.sign_disagreements
        )
    }
}

/// The quadratic `a t^2 + 2 b t + c = 0` of a record.
struct Quadratic<N> {
    a: N,
    b: N,
    /// `b^2 - a c`.
    discriminant: N,
    /// `b^2 + a (f.f + r^2)`: the sum of the magnitudes that cancel in the
    /// discriminant.
    magnitude: N,
}

impl<N: Number> Quadratic<N> {
    fn of(record: &RaySphere) -> Self {
        let d = V3::<N>::of(record.direction);
        let f = V3::difference(record.origin, record.center);
        let r2 = N::of(record.radius).square();
        let a = d.length_squared();
        let b = f.dot(&d);
        let f2 = f.length_squared();
        let discriminant = b.square() - a.clone() * (f2.clone() - r2.clone());
        let magnitude = b.square() + a.clone() * (f2 + r2);
        Self { a, b, discriminant, magnitude }
    }

    /// Both roots, near first; not finite without a root.
    fn roots(&self) -> [N; 2] {
        let root = self.discriminant.clone().sqrt();
        [-self.b.clone() - root.clone(), -self.b.clone() + root].map(|t| t / self.a.clone())
    }

    /// How far an error of 1 in every operation, relative to what goes in,
    /// moves a root: through the discriminant's root, and through the sum.
    fn condition(&self) -> N {
        let root = self.discriminant.clone().sqrt();
        let through_discriminant = self.magnitude.clone() / (N::of(2.0) * root.clone());
        (through_discriminant + self.b.clone().abs() + root) / self.a.clone()
    }
}

/// Compares [`Dd`] with [`Big`] on the given records.
pub fn compare(records: impl IntoIterator<Item = RaySphere>) -> Agreement {
    let mut agreement = Agreement::default();
    for record in records {
        agreement.records += 1;
        let fast = Quadratic::<Dd>::of(&record);
        let slow = Quadratic::<Big>::of(&record);
        let sign = slow.discriminant.sign();
        let finite = fast.discriminant.is_finite() && slow.discriminant.is_finite();
        if !finite || fast.discriminant.sign() != sign {
            agreement.sign_disagreements += 1;
            continue;
        }
        // A double root needs no square root's derivative; it is `-b/a`.
        if sign != Ordering::Greater {
            continue;
        }
        agreement.hits += 1;
        let condition = slow.condition();
        for (fast, slow) in fast.roots().into_iter().zip(slow.roots()) {
            let difference = (Big::from(fast) - slow.clone()).abs();
            let conditioned = (difference.clone() / condition.clone()).to_f64();
            agreement.max_conditioned_difference =
                larger(agreement.max_conditioned_difference, conditioned);
            // A root at exactly zero has no relative error.
            if slow.sign() != Ordering::Equal {
                let relative = (difference / slow.abs()).to_f64();
                agreement.max_relative_difference =
                    larger(agreement.max_relative_difference, relative);
            }
        }
    }
    agreement
}

/// The larger, where a NaN is largest: it must not pass for agreement.
fn larger(so_far: f64, value: f64) -> f64 {
    if so_far.is_nan() || value <= so_far { so_far } else { value }
}

/// Compares [`Dd`] with [`Big`] on `records` records, the same for the same
/// `seed` on every system: in turn ordinary, far, grazing from either side,
/// from inside, with single-precision inputs, and exactly tangent.
pub fn validate(records: u64, seed: u64) -> Agreement {
    let mut random = SplitMix64(seed);
    compare((0..records).map(|k| match k % 6 {
        0 => aimed(&mut random, (0.0, 3.0), 1.2),
        1 => aimed(&mut random, (3.0, 8.0), 1.2),
        2 => grazing(&mut random),
        3 => aimed(&mut random, (-6.0, 0.0), 1.2),
        4 => single_precision(aimed(&mut random, (0.0, 6.0), 1.2)),
        _ => tangent(&mut random),
    }))
}

/// A ray from `10^decades` radii away, aimed to pass the center at up to
/// `reach` radii; sphere and ray of any size from 1e-3 to 1e3.
fn aimed(random: &mut SplitMix64, decades: (f64, f64), reach: f64) -> RaySphere {
    let radius = random.power_of_ten(-3.0, 3.0);
    let center = random.direction() * (radius * random.power_of_ten(-2.0, 2.0));
    let distance = radius * random.power_of_ten(decades.0, decades.1);
    let origin = center + random.direction() * distance;
    let target = center + random.direction() * (radius * random.within(0.0, reach));
    let direction = (target - origin).normalize() * random.power_of_ten(-3.0, 3.0);
    RaySphere { origin, direction, center, radius }
}

/// A ray that passes the center at `radius (1 +- 10^-12 ... 10^-1)`, as far as
/// `f64` inputs can say it.
fn grazing(random: &mut SplitMix64) -> RaySphere {
    let record = aimed(random, (0.5, 4.0), 1.0);
    let along = (record.center - record.origin).normalize();
    let across = along.cross(random.direction()).normalize();
    let excess = random.power_of_ten(-12.0, -1.0);
    let side = if random.next().is_multiple_of(2) { excess } else { -excess };
    // The point of closest approach lies across the direction, not the axis.
    let distance = record.origin.distance(record.center);
    let sine = record.radius * (1.0 + side) / distance;
    let cosine = ((1.0 - sine) * (1.0 + sine)).max(0.0).sqrt();
    RaySphere { direction: along * cosine + across * sine, ..record }
}

/// The record with every component rounded to single precision.
fn single_precision(record: RaySphere) -> RaySphere {
    RaySphere {
        origin: record.origin.as_vec3().as_dvec3(),
        direction: record.direction.as_vec3().as_dvec3(),
        center: record.center.as_vec3().as_dvec3(),
        radius: f64::from(record.radius as f32),
    }
}

/// A ray that touches its sphere exactly: integer coordinates of 20 bits, the
/// direction along an axis.
fn tangent(random: &mut SplitMix64) -> RaySphere {
    let mut integer = || (random.next() >> 44) as f64 + 1.0;
    let (center, radius) = (DVec3::new(integer(), integer(), integer()), integer());
    let origin = center + DVec3::new(-integer(), radius, 0.0);
    RaySphere { origin, direction: DVec3::X * integer(), center, radius }
}

/// A generator with the same numbers on every system and in every version.
///
/// Source: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number
/// Generators", 2014.
struct SplitMix64(u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `[lo, hi)`.
    fn within(&mut self, lo: f64, hi: f64) -> f64 {
        // The 53 bits of an `f64`, as a fraction.
        let unit = (self.next() >> 11) as f64 * (f64::EPSILON / 2.0);
        lo + (hi - lo) * unit
    }

    /// Between `10^lo` and `10^hi`, every decade alike. The powers of ten
    /// between whole ones are bent to straight lines, which needs no library.
    fn power_of_ten(&mut self, lo: f64, hi: f64) -> f64 {
        let exponent = self.within(lo, hi);
        let whole = exponent.floor();
        let mut power = 1.0;
        for _ in 0..whole.abs() as u32 {
            power *= 10.0;
        }
        let power = if whole < 0.0 { 1.0 / power } else { power };
        power * (1.0 + 9.0 * (exponent - whole))
    }

    /// A direction of length 1, uniform on the sphere.
    fn direction(&mut self) -> DVec3 {
        loop {
            let v =
                DVec3::new(self.within(-1.0, 1.0), self.within(-1.0, 1.0), self.within(-1.0, 1.0));
            // Inside the ball, and not so near its center that digits are lost.
            if (0.01..=1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}
