//! The families of the bench: kinds of sphere and triangle cases whose numbers
//! are all of `f32`, so that every precision is asked the same question.

use tracer::glam::DVec3;

use super::mesh::Mesh;
use crate::random::{f32_of, f32_point};
use crate::truth::{self, Truth};
use crate::{Case, Random};

/// What the rays are aimed at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Primitive {
    /// A case has the center, the radius and the ray: 3, 1 and 6 numbers.
    Sphere,
    /// A case has three corners and the ray: 9 and 6 numbers.
    Triangle,
}

impl Primitive {
    /// Its name in filters and tables.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Triangle => "triangle",
        }
    }

    /// The exact answer to one of its cases.
    pub(super) fn truth(self, case: &Case) -> Truth {
        match self {
            Self::Sphere => truth::sphere(case),
            Self::Triangle => truth::triangle(case),
        }
    }
}

/// One kind of case.
#[derive(Debug, Clone, Copy)]
pub(super) struct Family {
    /// What is hit.
    pub(super) primitive: Primitive,
    /// Its name among the primitive's.
    pub(super) name: &'static str,
    source: Source,
}

/// Where cases come from.
#[derive(Debug, Clone, Copy)]
enum Source {
    /// Each on its own.
    Single(fn(&mut Random) -> Case),
    /// Rays at the seams of a closed mesh, each against all triangles around
    /// what it is aimed at.
    Seams,
}

impl Family {
    /// What filters match.
    pub(super) fn label(&self) -> String {
        format!("{}/{}", self.primitive.name(), self.name)
    }

    /// Whether the rays are aimed at the seams of a closed mesh.
    pub(super) fn is_at_seams(&self) -> bool {
        matches!(self.source, Source::Seams)
    }

    /// This many cases, always the same.
    pub(super) fn cases(&self, count: usize) -> Vec<Case> {
        let mut random = Random::of_chunk(0, &self.label(), 0);
        match self.source {
            Source::Single(generate) => (0..count).map(|_| generate(&mut random)).collect(),
            Source::Seams => {
                let mesh = Mesh::new();
                let mut cases = Vec::with_capacity(count);
                while cases.len() < count {
                    cases.extend(mesh.around(&mesh.aim(&mut random)));
                }
                cases.truncate(count);
                cases
            }
        }
    }
}

/// Every family, in the order of the table.
pub(super) fn all() -> Vec<Family> {
    use Primitive::{Sphere, Triangle};
    let family = |primitive, name, generate: fn(&mut Random) -> Case| Family {
        primitive,
        name,
        source: Source::Single(generate),
    };
    vec![
        family(Sphere, "near", |random| sphere_from(random, 10.0)),
        family(Sphere, "far-1e4", |random| sphere_from(random, 1e4)),
        family(Sphere, "far-1e8", |random| sphere_from(random, 1e8)),
        family(Sphere, "grazing", sphere_grazing),
        family(Sphere, "near-surface", sphere_near_surface),
        family(Triangle, "regular", |random| triangle_at(random, regular, DVec3::ZERO, 5.0)),
        family(Triangle, "needle-1e-6", |random| triangle_at(random, needle, DVec3::ZERO, 5.0)),
        family(Triangle, "grazing-1e-6", triangle_grazing),
        family(Triangle, "far-1e6", |random| triangle_at(random, regular, DVec3::ZERO, 1e6)),
        family(Triangle, "world+1e6", |random| {
            let place = f32_point(random.direction() * 1e6);
            triangle_at(random, regular, place, 5.0)
        }),
        family(Triangle, "mixed-scale", |random| {
            triangle_at(random, mixed_scale, DVec3::ZERO, 5.0)
        }),
        Family { primitive: Triangle, name: "mesh-edge", source: Source::Seams },
    ]
}

/// How far beside a sphere, in radii, rays pass at most.
const WIDEST_MISS: f64 = 1.1;

/// The lengths of directions.
fn any_length(random: &mut Random) -> f64 {
    random.between(0.5, 2.0)
}

fn sphere_case(center: DVec3, radius: f64, origin: DVec3, direction: DVec3) -> Case {
    let case = Case::EMPTY.with_point(center).with(radius);
    case.with_point(origin).with_point(direction)
}

/// A ray from `distance` radii away, uniform over a disk somewhat wider than
/// the sphere.
fn sphere_from(random: &mut Random, distance: f64) -> Case {
    let beside = WIDEST_MISS * random.unit().sqrt();
    sphere_beside(random, distance, beside)
}

/// A ray that passes the center at `beside` radii. From far away a direction
/// of `f32` cannot aim that well, so the origin, which has small coordinates,
/// makes up for the rounding of the direction and of the center.
fn sphere_beside(random: &mut Random, distance: f64, beside: f64) -> Case {
    let radius = f32_of(random.between(0.5, 2.0));
    let way = random.direction();
    let direction = f32_point(way * any_length(random));
    let center = f32_point(random.point() * 3.0 + way * (distance * radius));
    let steps = distance * radius / direction.length();
    let side = random.across(direction) * (beside * radius);
    let origin = f32_point(center - direction * steps + side);
    sphere_case(center, radius, origin, direction)
}

/// A ray that nearly touches: outside or inside by 1e-7 to 1e-1 radii.
fn sphere_grazing(random: &mut Random) -> Case {
    let beside = 1.0 + random.sign() * random.decades(1e-7, 1e-1);
    let distance = random.decades(2.0, 10.0);
    sphere_beside(random, distance, beside)
}

/// An origin 1e-6 to 1e-2 radii above or below the surface, and a ray any way
/// that leads to it.
fn sphere_near_surface(random: &mut Random) -> Case {
    let radius = f32_of(random.between(0.5, 2.0));
    let center = f32_point(random.point() * 3.0);
    let up = random.direction();
    let side = random.sign();
    let height = 1.0 + side * random.decades(1e-6, 1e-2);
    let origin = f32_point(center + up * (height * radius));
    let away = random.direction();
    let toward = if away.dot(up) * side > 0.0 { -away } else { away };
    let direction = f32_point(toward * any_length(random));
    sphere_case(center, radius, origin, direction)
}

fn triangle_case(corners: [DVec3; 3], origin: DVec3, direction: DVec3) -> Case {
    let case = corners.into_iter().fold(Case::EMPTY, Case::with_point);
    case.with_point(origin).with_point(direction)
}

/// Corners at `place`, of `f32`, with an area.
fn corners_at(
    random: &mut Random,
    shape: fn(&mut Random) -> [DVec3; 3],
    place: DVec3,
) -> [DVec3; 3] {
    loop {
        let [a, b, c] = shape(random).map(|corner| f32_point(place + corner));
        let area = (b - a).cross(c - a).length();
        // In `f64`, where the rounding of these corners is exact to 1e-16.
        if area > 1e-12 * (b - a).length() * (c - a).length() {
            return [a, b, c];
        }
    }
}

/// Three points in a cube, not thin.
fn regular(random: &mut Random) -> [DVec3; 3] {
    /// The least height of a triangle of size 1.
    const HEIGHT: f64 = 0.2;
    loop {
        let [a, b, c] = [random.point(), random.point(), random.point()];
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        if (b - a).cross(c - a).length() > HEIGHT * longest * longest {
            return [a, b, c];
        }
    }
}

/// A million times as long as it is wide, the narrow side anywhere.
fn needle(random: &mut Random) -> [DVec3; 3] {
    const WIDTH: f64 = 1e-6;
    let a = random.point();
    let along = random.direction();
    let side = random.across(along);
    let share = random.unit();
    let mut corners = [a, a + along, a + along * share + side * WIDTH];
    corners.rotate_left(random.below(3));
    corners
}

/// Each corner at another of eight decades from the origin.
fn mixed_scale(random: &mut Random) -> [DVec3; 3] {
    [(); 3].map(|()| random.point() * random.decades(1e-4, 1e4))
}

/// Weights of the second and third corner: inside for about half.
fn weights(random: &mut Random) -> (f64, f64) {
    /// How far outside of the triangle, in its own size, rays go.
    const OUTSIDE: f64 = 0.2;
    (random.between(-OUTSIDE, 1.0), random.between(-OUTSIDE, 1.0))
}

/// A ray from `distance` sizes away at the plane of a triangle, inside for
/// about half.
fn triangle_at(
    random: &mut Random,
    shape: fn(&mut Random) -> [DVec3; 3],
    place: DVec3,
    distance: f64,
) -> Case {
    let corners = corners_at(random, shape, place);
    let [a, b, c] = corners;
    let (beta, gamma) = weights(random);
    let target = a + (b - a) * beta + (c - a) * gamma;
    let size = (b - a).length().max((c - a).length());
    let origin = f32_point(target - random.direction() * (distance * size));
    let direction = (target - origin).normalize() * any_length(random);
    triangle_case(corners, origin, f32_point(direction))
}

/// A ray at 1e-6 radians to the plane.
fn triangle_grazing(random: &mut Random) -> Case {
    const ANGLE: f64 = 1e-6;
    let corners = corners_at(random, regular, DVec3::ZERO);
    let [a, b, c] = corners;
    let n = (b - a).cross(c - a).normalize();
    let (beta, gamma) = weights(random);
    let target = a + (b - a) * beta + (c - a) * gamma;
    let rise = n * (random.sign() * ANGLE);
    let origin = f32_point(target - (random.across(n) + rise) * random.between(1.0, 5.0));
    let direction = (target - origin).normalize() * any_length(random);
    triangle_case(corners, origin, f32_point(direction))
}
