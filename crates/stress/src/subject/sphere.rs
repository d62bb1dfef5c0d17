//! What is asked of the sphere: from every distance, from inside, from its own
//! surface, of every size and place, and grazing.

use tracer::glam::DVec3;
use tracer::lecture::{sphere_algebraic, sphere_geometric};
use tracer::shape::{Geometry, Sphere};
use tracer::{Interval, Ray};

use super::closest::{Answer, Inputs, Subject, special, towards};
use super::plane::ahead;
use super::sphere_surface;
use crate::family::{Family, Kernel, Volume};
use crate::kernel::of_case::AtSphere;
use crate::kernel::{self, Range};
use crate::random::{f32_of, f32_point};
use crate::{Case, Metric, Random, truth};

const VOLUME: Volume = Volume { quick: 250_000, full: 100_000_000 };
const SINGLE: Inputs = Inputs::Single { ulp32: 0.5 };
const SINGLE_GRAZING: Inputs = Inputs::Single { ulp32: 0.6 };
const DOUBLE: Inputs = Inputs::Double { condition_error: 4.0 };
/// Held beside the condition: the sphere's `t` is right to a few last places
/// however badly it is conditioned, as its inputs are not rounded on the way.
const ULP64: f64 = 16.0;

/// Every family of the sphere.
pub(super) fn families() -> Vec<Family> {
    let mut answers: Vec<Answer> = vec![
        (Kernel::GOLDRAY, goldray),
        (Kernel::textbook("algebraic-f64"), |case| by(case, sphere_algebraic)),
        (Kernel::textbook("geometric-f64"), |case| by(case, sphere_geometric)),
    ];
    let of = |answers: &[Answer]| Subject {
        primitive: "sphere",
        truth: truth::sphere,
        answers: answers.to_vec(),
    };
    let double = of(&answers);
    answers.extend([
        (Kernel::textbook("algebraic-f32"), algebraic_f32 as fn(&Case) -> _),
        (Kernel::textbook("geometric-f32"), geometric_f32),
    ]);
    let single = of(&answers);
    let special_volume = Volume { quick: 100_000, full: 10_000_000 };
    let double = |name, generate: fn(&mut Random) -> Case| {
        double.family(name, DOUBLE, VOLUME, generate).held_to(Metric::Ulp64, ULP64)
    };
    let mut families = vec![
        single.family("far-f32", SINGLE, VOLUME, far_f32),
        single.family("grazing-f32", SINGLE_GRAZING, VOLUME, grazing_f32),
        double("far", far),
        double("grazing", grazing),
        double("inside", inside),
        double("near-surface", near_surface),
        double("sizes", sizes),
        double("world-1e5", world),
        special("sphere", answers, RAY, special_volume, |random| {
            aimed(random, DVec3::ZERO, 1.0, 3.0, 0.5)
        }),
    ];
    families.extend(sphere_surface::families());
    families
}

/// Where a case's ray starts: behind the center and the radius.
const RAY: usize = 4;

/// The case of a sphere and a ray.
pub(super) fn case_of(center: DVec3, radius: f64, origin: DVec3, direction: DVec3) -> Case {
    Case::EMPTY.with_point(center).with(radius).with_ray(&Ray::new(origin, direction))
}

/// A ray from `distance`, with a length of a few decades, that passes the
/// center at distance `impact` but for rounding.
pub(super) fn aimed(
    random: &mut Random,
    center: DVec3,
    radius: f64,
    distance: f64,
    impact: f64,
) -> Case {
    let way = random.direction();
    let target = center + random.across(way) * impact;
    let (origin, direction) =
        towards(target, way, distance * ahead(random), random.decades(1e-2, 1e2));
    case_of(center, radius, origin, direction)
}

/// Uniform over a disc somewhat wider than the sphere.
pub(super) fn over_disc(random: &mut Random, radius: f64, reach: f64) -> f64 {
    radius * reach * random.unit().sqrt()
}

/// The widest impact, in radii, of families with hits and misses.
const REACH: f64 = 1.1;

fn algebraic_f32(case: &Case) -> Option<f64> {
    let at = AtSphere::<f32>::new(case);
    kernel::sphere::algebraic(&at.sphere, &at.ray, Range::AHEAD).map(f64::from)
}

fn geometric_f32(case: &Case) -> Option<f64> {
    let at = AtSphere::<f32>::new(case);
    kernel::sphere::geometric(&at.sphere, &at.ray, Range::AHEAD).map(f64::from)
}

fn goldray(case: &Case) -> Option<f64> {
    let sphere = Sphere::new(case.point(0), case.number(3)).ok()?;
    sphere.intersect(&case.ray(RAY), Interval::AHEAD).map(|contact| contact.t)
}

fn by(case: &Case, formula: fn(DVec3, f64, &Ray, Interval) -> Option<f64>) -> Option<f64> {
    formula(case.point(0), case.number(3), &case.ray(RAY), Interval::AHEAD)
}

/// A ray of `f32` numbers through the origin of the world but for nothing: its
/// start is its direction times a power of two. So it can pass a small sphere
/// there from as far away as `f32` reaches.
fn through_zero(distance: f64, direction: DVec3) -> (DVec3, DVec3) {
    let direction = f32_point(direction);
    let power = libm::exp2(libm::log2(distance / direction.length()).round());
    (direction * -power, direction)
}

fn far_f32(random: &mut Random) -> Case {
    let radius = f32_of(random.decades(0.1, 10.0));
    let impact = over_disc(random, radius, REACH);
    if random.coin() {
        let way = random.direction() * random.decades(0.1, 10.0);
        let (origin, direction) = through_zero(radius * random.decades(1.0, 1e8), way);
        let along = direction * (random.between(-0.5, 0.5) * radius / direction.length());
        let center = random.across(direction) * impact + along;
        return case_of(f32_point(center), radius, origin, direction);
    }
    // Beyond this the rounded ray rarely meets the sphere.
    let distance = radius * random.decades(1.0, 1e5);
    let center = random.point() * (3.0 * radius);
    single(&aimed(random, center, radius, distance, impact))
}

/// The case with every number rounded to `f32`.
fn single(case: &Case) -> Case {
    case.numbers().iter().fold(Case::EMPTY, |single, &x| single.with(f32_of(x)))
}

/// `1 - b/r` of a ray that passes the center at `b`, of either sign.
fn graze(random: &mut Random, least: f64) -> f64 {
    random.decades(least, 0.1) * random.sign()
}

/// The closest grazing of all.
const CLOSEST_GRAZE: f64 = 1e-12;

/// What rounding the ray's origin leaves of a grazing, per radius of its
/// distance.
const ROUNDED: f64 = 1e-14;

fn grazing_f32(random: &mut Random) -> Case {
    let radius = f32_of(random.decades(0.1, 10.0));
    let distance = random.decades(1.0, 1e8);
    let graze = graze(random, CLOSEST_GRAZE.max(ROUNDED * distance));
    if random.coin() {
        let way = random.direction() * random.decades(0.1, 10.0);
        let (origin, direction) = through_zero(radius * distance, way);
        let center = random.across(direction) * (radius * (1.0 - graze));
        return case_of(f32_point(center), radius, origin, direction);
    }
    // Along an axis: with most of the impact in one coordinate, the other one
    // tells distances from the center apart that are far closer than an f32.
    let (axis, swap, flip) = (random.below(3), random.coin(), random.sign());
    let impact = radius * (1.0 - graze);
    let most = f32_of(impact * (1.0 - random.decades(1e-7, 1e-2)));
    let rest = f32_of((impact * impact - most * most).max(0.0).sqrt()) * random.sign();
    let (u, v) = if swap { (most, rest) } else { (rest, most) };
    let mut center = DVec3::ZERO;
    center[(axis + 1) % 3] = u;
    center[(axis + 2) % 3] = v;
    let way = DVec3::AXES[axis] * (flip * random.decades(0.1, 10.0));
    let (origin, direction) = through_zero(radius * distance, way);
    case_of(center, radius, origin, direction)
}

fn far(random: &mut Random) -> Case {
    let radius = random.decades(0.1, 10.0);
    let center = random.point() * (3.0 * radius);
    let (impact, distance) = (over_disc(random, radius, REACH), radius * random.decades(1.0, 1e8));
    aimed(random, center, radius, distance, impact)
}

fn grazing(random: &mut Random) -> Case {
    let radius = random.decades(0.1, 10.0);
    let center = random.point() * radius;
    let distance = random.decades(1.0, 1e6);
    let impact = radius * (1.0 - graze(random, CLOSEST_GRAZE.max(ROUNDED * distance)));
    aimed(random, center, radius, radius * distance, impact)
}

fn inside(random: &mut Random) -> Case {
    let radius = random.decades(0.1, 10.0);
    let center = random.point() * (3.0 * radius);
    let depth = radius * (1.0 - random.decades(1e-6, 1.0));
    let origin = center + random.direction() * depth;
    case_of(center, radius, origin, random.direction() * random.decades(1e-10, 1e10))
}

fn near_surface(random: &mut Random) -> Case {
    let radius = random.decades(0.1, 10.0);
    let center = random.point() * radius;
    let gap = random.decades(1e-13, 1e-2) * random.sign();
    let origin = center + random.direction() * (radius * (1.0 + gap));
    case_of(center, radius, origin, random.direction() * random.decades(1e-2, 1e2))
}

fn sizes(random: &mut Random) -> Case {
    let radius = random.decades(1e-6, 1e12);
    let center = random.point() * (3.0 * radius);
    let way = random.direction();
    let target = center + random.across(way) * over_disc(random, radius, REACH);
    let (distance, length) = (radius * random.decades(1.0, 1e2), random.decades(1e-10, 1e10));
    let (origin, direction) = towards(target, way, distance, length);
    case_of(center, radius, origin, direction)
}

fn world(random: &mut Random) -> Case {
    let radius = random.decades(0.1, 10.0);
    let center = random.direction() * (radius * random.decades(1.0, 1e5));
    let (impact, distance) = (over_disc(random, radius, REACH), radius * random.decades(1.0, 1e2));
    aimed(random, center, radius, distance, impact)
}
