//! The kernels of the bench, each put behind the same two questions: what is
//! the answer to this case, and how long do many of them take?
//!
//! A kernel is called through its public function, from a loop of its own, and
//! never inlined into it: ours are marked so, the tracer's are in another
//! crate. What a method makes once for a primitive is made beforehand; what it
//! makes for a ray is part of each call, as a lone primitive makes it.

use tracer::shape::{Geometry, Sphere, Triangle};
use tracer::{Interval, lecture};

use super::family::Primitive;
use crate::Case;
use crate::kernel::of_case::{AtSphere, AtTriangle};
use crate::kernel::triangle::Affine;
use crate::kernel::{Range, Real, sphere, triangle};

/// A kernel among others.
pub(super) struct Entrant {
    /// Its name: the method, then the precision.
    pub(super) name: &'static str,
    kernel: Box<dyn Kernel>,
}

impl Entrant {
    /// Its answer; `None` is a miss, and what the kernel refuses.
    pub(super) fn answer(&self, case: &Case) -> Option<f64> {
        self.kernel.answer(case)
    }

    /// Readies these cases for [`Entrant::pass`]. Returns how many it took.
    pub(super) fn load(&mut self, cases: &[Case]) -> usize {
        self.kernel.load(cases)
    }

    /// Answers every case loaded; the sum of all `t`, so that none is left out.
    pub(super) fn pass(&self) -> f64 {
        self.kernel.pass()
    }
}

trait Kernel {
    fn answer(&self, case: &Case) -> Option<f64>;
    fn load(&mut self, cases: &[Case]) -> usize;
    fn pass(&self) -> f64;
}

/// A kernel with what it is ready to be asked.
struct Ready<P, F> {
    /// Makes what the kernel takes from the case's numbers.
    prepare: fn(&Case) -> Option<P>,
    /// Calls the kernel.
    test: F,
    loaded: Vec<P>,
}

impl<P, F: Fn(&P) -> Option<f64>> Kernel for Ready<P, F> {
    fn answer(&self, case: &Case) -> Option<f64> {
        (self.prepare)(case).as_ref().and_then(&self.test)
    }

    fn load(&mut self, cases: &[Case]) -> usize {
        self.loaded = cases.iter().filter_map(self.prepare).collect();
        self.loaded.len()
    }

    fn pass(&self) -> f64 {
        let mut sum = 0.0;
        // One pass knows nothing of the one before.
        for prepared in std::hint::black_box(&*self.loaded) {
            if let Some(t) = (self.test)(prepared) {
                sum += t;
            }
        }
        sum
    }
}

fn entrant<P: 'static>(
    name: &'static str,
    prepare: fn(&Case) -> Option<P>,
    test: impl Fn(&P) -> Option<f64> + 'static,
) -> Entrant {
    Entrant { name, kernel: Box::new(Ready { prepare, test, loaded: Vec::new() }) }
}

/// Everyone who answers for this primitive.
pub(super) fn entrants(primitive: Primitive) -> Vec<Entrant> {
    match primitive {
        Primitive::Sphere => spheres(),
        Primitive::Triangle => triangles(),
    }
}

/// An entrant whose kernel takes a sphere's numbers and a ray.
macro_rules! at_sphere {
    ($name:literal, $real:ident, $kernel:path) => {
        entrant(
            $name,
            |case| Some(AtSphere::<$real>::new(case)),
            |at| $kernel(&at.sphere, &at.ray, Range::AHEAD).map(Into::into),
        )
    };
}

/// An entrant whose kernel takes a triangle's corners and a ray.
macro_rules! at_triangle {
    ($name:literal, $real:ident, $kernel:path) => {
        entrant(
            $name,
            |case| Some(AtTriangle::<$real>::new(case)),
            |at| $kernel(&at.corners, &at.ray, Range::AHEAD).map(Into::into),
        )
    };
}

fn spheres() -> Vec<Entrant> {
    let numbers = |case: &Case| Some(((case.point(0), case.number(3)), case.ray(4)));
    vec![
        at_sphere!("algebraic-f32", f32, sphere::algebraic),
        entrant("algebraic-f64", numbers, |((center, radius), ray)| {
            lecture::sphere_algebraic(*center, *radius, ray, Interval::AHEAD)
        }),
        at_sphere!("geometric-f32", f32, sphere::geometric),
        entrant("geometric-f64", numbers, |((center, radius), ray)| {
            lecture::sphere_geometric(*center, *radius, ray, Interval::AHEAD)
        }),
        at_sphere!("rtg7-f32", f32, sphere::remainder),
        at_sphere!("rtg7-f64", f64, sphere::remainder),
        entrant(
            super::OURS,
            |case| Some((Sphere::new(case.point(0), case.number(3)).ok()?, case.ray(4))),
            |(sphere, ray)| Some(sphere.intersect(ray, Interval::AHEAD)?.t),
        ),
        at_sphere!("double-double", f64, sphere::double_double),
    ]
}

fn triangles() -> Vec<Entrant> {
    let numbers = |case: &Case| Some(([0, 3, 6].map(|first| case.point(first)), case.ray(9)));
    vec![
        at_triangle!("inside-edges-f32", f32, triangle::inside_edges),
        entrant("inside-edges-f64", numbers, |(corners, ray)| {
            lecture::triangle_inside_edges(*corners, ray, Interval::AHEAD)
        }),
        at_triangle!("linear-system-f32", f32, triangle::linear_system),
        entrant("linear-system-f64", numbers, |(corners, ray)| {
            Some(lecture::triangle_linear_system(*corners, ray, Interval::AHEAD)?.0)
        }),
        at_triangle!("moeller-trumbore-f32", f32, triangle::moeller_trumbore),
        at_triangle!("moeller-trumbore-f64", f64, triangle::moeller_trumbore),
        baldwin_weber::<f32>("baldwin-weber-f32"),
        baldwin_weber::<f64>("baldwin-weber-f64"),
        at_triangle!("woop-f32", f32, triangle::woop),
        entrant(
            super::OURS,
            |case| {
                let [a, b, c] = [0, 3, 6].map(|first| case.point(first));
                Some((Triangle::new(a, b, c).ok()?, case.ray(9)))
            },
            |(triangle, ray)| Some(triangle.intersect(ray, Interval::AHEAD)?.t),
        ),
        at_triangle!("double-double", f64, triangle::double_double),
    ]
}

/// The method whose map is made once for a triangle.
fn baldwin_weber<R: Real + Into<f64> + 'static>(name: &'static str) -> Entrant {
    let prepare = |case: &Case| {
        let AtTriangle { corners, ray } = AtTriangle::<R>::new(case);
        Some((Affine::new(&corners), ray))
    };
    entrant(name, prepare, |(map, ray)| {
        triangle::baldwin_weber(map, ray, Range::AHEAD).map(Into::into)
    })
}
