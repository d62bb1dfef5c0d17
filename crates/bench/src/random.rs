//! `Random`: seeded random numbers and points, the same on every machine.

use tracer::glam::DVec3;

/// A generator with a seed; no system function is behind any number of it.
pub(crate) struct Random(fastrand::Rng);

impl Random {
    /// The generator of this seed.
    pub(crate) fn new(seed: u64) -> Self {
        Self(fastrand::Rng::with_seed(seed))
    }

    /// A number in `[0, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0.f64()
    }

    /// A number in `[lo, hi)`.
    pub(crate) fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// A byte.
    pub(crate) fn byte(&mut self) -> u8 {
        self.0.u8(..)
    }

    /// A point of the cube of half side 1 around the origin.
    pub(crate) fn point(&mut self) -> DVec3 {
        let mut side = || self.between(-1.0, 1.0);
        DVec3::new(side(), side(), side())
    }

    /// A direction of length 1, uniform over the sphere.
    pub(crate) fn direction(&mut self) -> DVec3 {
        loop {
            // Points of the ball but near its center, whose direction rounds.
            let p = self.point();
            if (0.01..=1.0).contains(&p.length_squared()) {
                return p.normalize();
            }
        }
    }

    /// The list in random order.
    pub(crate) fn shuffled<T>(&mut self, mut list: Vec<T>) -> Vec<T> {
        self.0.shuffle(&mut list);
        list
    }
}
