//! `Case`: the numbers of one question to the tracer, such as a sphere and a
//! ray, as plain `f64`s that can be kept and asked again.

use tracer::Ray;
use tracer::glam::DVec3;

/// The most numbers of a case.
const ROOM: usize = 32;

/// Up to 32 numbers in an order that the family knows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    numbers: [f64; ROOM],
    len: usize,
}

impl Case {
    /// A case without numbers, to be filled by [`Case::with`] and the like.
    pub const EMPTY: Self = Self { numbers: [0.0; ROOM], len: 0 };

    /// The case of these numbers; `None` if they are too many.
    pub fn of(numbers: &[f64]) -> Option<Self> {
        (numbers.len() <= ROOM).then(|| numbers.iter().fold(Self::EMPTY, |c, &x| c.with(x)))
    }

    /// The case with one more number; one too many is left out.
    #[must_use]
    pub fn with(mut self, number: f64) -> Self {
        if let Some(slot) = self.numbers.get_mut(self.len) {
            *slot = number;
            self.len += 1;
        }
        self
    }

    /// The case with three more numbers.
    #[must_use]
    pub fn with_point(self, p: DVec3) -> Self {
        self.with(p.x).with(p.y).with(p.z)
    }

    /// The case with a ray's six numbers, origin first.
    #[must_use]
    pub fn with_ray(self, ray: &Ray) -> Self {
        self.with_point(ray.origin).with_point(ray.direction)
    }

    /// All numbers.
    pub fn numbers(&self) -> &[f64] {
        &self.numbers[..self.len]
    }

    /// Number `i`; 0 where there is none.
    pub fn number(&self, i: usize) -> f64 {
        self.numbers().get(i).copied().unwrap_or(0.0)
    }

    /// The point whose first coordinate is number `i`.
    pub fn point(&self, i: usize) -> DVec3 {
        DVec3::new(self.number(i), self.number(i + 1), self.number(i + 2))
    }

    /// The ray whose first number is number `i`.
    pub fn ray(&self, i: usize) -> Ray {
        Ray::new(self.point(i), self.point(i + 3))
    }
}
