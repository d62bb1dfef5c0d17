//! What is asked of the triangle: of every shape, size and place, grazing, and
//! exactly at its edges and corners. Those without an area are in
//! [`super::triangle_flat`].

use tracer::glam::DVec3;
use tracer::lecture::{triangle_inside_edges, triangle_linear_system};
use tracer::shape::{Geometry, Triangle};
use tracer::{Interval, Ray};

use super::closest::{Answer, Inputs, Subject, special};
use super::plane::ahead;
use super::triangle_flat;
use crate::family::{Family, Kernel, Volume};
use crate::kernel::of_case::AtTriangle;
use crate::kernel::{self, Range};
use crate::random::{f32_of, f32_point};
use crate::truth::{self, Truth};
use crate::{Case, Metric, Random};

const VOLUME: Volume = Volume { quick: 200_000, full: 100_000_000 };
const DOUBLE: Inputs = Inputs::Double { condition_error: 4.0 };
/// Held beside the condition: the inputs are not rounded on the way, so `t` is
/// right to a few last places however badly it is conditioned.
const ULP64: f64 = 16.0;

/// Makes the cases of a family.
type Generator = fn(&mut Random) -> Case;

/// Every family of the triangle.
pub(super) fn families() -> Vec<Family> {
    let mut answers: Vec<Answer> = vec![
        (Kernel::GOLDRAY, goldray),
        (Kernel::textbook("inside-edges-f64"), inside_edges),
        (Kernel::textbook("linear-system-f64"), linear_system),
    ];
    let of = |truth: fn(&Case) -> Truth, answers: &[Answer]| Subject {
        primitive: "triangle",
        truth,
        answers: answers.to_vec(),
    };
    let (double, exact) = (of(truth::triangle, &answers), of(truth::triangle_on_lattice, &answers));
    answers.extend([
        (Kernel::textbook("inside-edges-f32"), inside_edges_f32 as fn(&Case) -> _),
        (Kernel::textbook("linear-system-f32"), linear_system_f32),
    ]);
    let single = of(truth::triangle, &answers);
    let mut families = Vec::new();
    // What is asked, and how near to a half of an `f32`'s unit its answer is.
    let kinds: [(&str, f64, Generator); 8] = [
        ("regular", 0.5, |random| ordinary(random, Place::UNIT, (1.0, 10.0))),
        ("needle", 0.6, needle),
        ("grazing", 0.6, grazing),
        ("far", 0.5, far),
        ("world", 0.5, |random| {
            let offset = random.direction() * random.one_of(&[1e4, 1e6]);
            ordinary(random, Place { offset, scale: 1.0 }, (1.0, 10.0))
        }),
        ("tiny-1e-13", 0.5, |random| ordinary(random, Place::of_scale(1e-13), (1.0, 10.0))),
        ("huge-1e12", 0.5, |random| ordinary(random, Place::of_scale(1e12), (1.0, 10.0))),
        ("mixed-scale", 0.6, mixed_scale),
    ];
    for (name, ulp32, generate) in kinds {
        let family = double.family(name, DOUBLE, VOLUME, move |random| {
            let case = generate(random);
            // Half of those made along the axes for the sake of `f32`.
            let is_along_axes = matches!(name, "needle" | "grazing" | "far");
            if is_along_axes && random.coin() { rotated(random, &case) } else { case }
        });
        // Coordinates of all sizes have more digits than twice those of an `f64`
        // when they meet: one case in 1e8 is a thousand last places off.
        families.push(match name {
            "mixed-scale" => family,
            _ => family.held_to(Metric::Ulp64, ULP64),
        });
        let inputs = Inputs::Single { ulp32 };
        families.push(single.family(format!("{name}-f32"), inputs, VOLUME, move |random| {
            rounded(&generate(random))
        }));
    }
    families.push(exact.family("lattice", DOUBLE, VOLUME, |random| lattice(random, true)));
    // Slopes that are no binary fractions.
    families.push(exact.family("lattice-slopes", DOUBLE, VOLUME, |random| lattice(random, false)));
    let special_volume = Volume { quick: 100_000, full: 10_000_000 };
    families.push(special("triangle", answers, RAY, special_volume, |random| {
        ordinary(random, Place::UNIT, (1.0, 10.0))
    }));
    families.extend(triangle_flat::families());
    families
}

/// Where a case's ray starts: behind three corners.
const RAY: usize = 9;

pub(super) fn corners(case: &Case) -> [DVec3; 3] {
    [case.point(0), case.point(3), case.point(6)]
}

fn goldray(case: &Case) -> Option<f64> {
    let [a, b, c] = corners(case);
    let triangle = Triangle::new(a, b, c).ok()?;
    triangle.intersect(&case.ray(RAY), Interval::AHEAD).map(|contact| contact.t)
}

pub(super) fn inside_edges(case: &Case) -> Option<f64> {
    triangle_inside_edges(corners(case), &case.ray(RAY), Interval::AHEAD)
}

pub(super) fn linear_system(case: &Case) -> Option<f64> {
    triangle_linear_system(corners(case), &case.ray(RAY), Interval::AHEAD).map(|(t, ..)| t)
}

fn inside_edges_f32(case: &Case) -> Option<f64> {
    let at = AtTriangle::<f32>::new(case);
    kernel::triangle::inside_edges(&at.corners, &at.ray, Range::AHEAD).map(f64::from)
}

fn linear_system_f32(case: &Case) -> Option<f64> {
    let at = AtTriangle::<f32>::new(case);
    kernel::triangle::linear_system(&at.corners, &at.ray, Range::AHEAD).map(f64::from)
}

fn case_of(corners: [DVec3; 3], origin: DVec3, direction: DVec3) -> Case {
    let case = corners.into_iter().fold(Case::EMPTY, Case::with_point);
    case.with_ray(&Ray::new(origin, direction))
}

/// The case with every number rounded to `f32`.
fn rounded(case: &Case) -> Case {
    case.numbers().iter().fold(Case::EMPTY, |single, &x| single.with(f32_of(x)))
}

/// The case turned about the world's origin, any way.
fn rotated(random: &mut Random, case: &Case) -> Case {
    let x = random.direction();
    let y = random.across(x);
    let z = x.cross(y);
    let turn = |p: DVec3| x * p.x + y * p.y + z * p.z;
    case_of(corners(case).map(turn), turn(case.point(RAY)), turn(case.point(RAY + 3)))
}

/// Where the unit cube is moved to.
#[derive(Clone, Copy)]
struct Place {
    offset: DVec3,
    scale: f64,
}

impl Place {
    const UNIT: Self = Self::of_scale(1.0);

    const fn of_scale(scale: f64) -> Self {
        Self { offset: DVec3::ZERO, scale }
    }
}

/// Three corners in the cube from -1 to 1 that are no needle.
fn plump(random: &mut Random) -> [DVec3; 3] {
    loop {
        let [a, b, c] = [random.point(), random.point(), random.point()];
        let longest = (b - a).length_squared().max((c - a).length_squared());
        let longest = longest.max((c - b).length_squared());
        if (b - a).cross(c - a).length() > 0.2 * longest {
            return [a, b, c];
        }
    }
}

/// A point of the plane in and around the triangle.
fn around(random: &mut Random, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let (beta, gamma) = (random.between(-0.25, 1.25), random.between(-0.25, 1.25));
    // Folded so that half of the points are inside.
    let (beta, gamma) = if beta + gamma > 1.25 { (1.0 - beta, 1.0 - gamma) } else { (beta, gamma) };
    a + beta * (b - a) + gamma * (c - a)
}

/// A plump triangle, met from anywhere in front of or behind it.
fn ordinary(random: &mut Random, place: Place, (least, most): (f64, f64)) -> Case {
    let corners = plump(random);
    let target = around(random, corners);
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
    let way = loop {
        let way = random.direction();
        // Other rays graze.
        if way.dot(normal).abs() > 0.05 {
            break way;
        }
    };
    let origin = target - way * (random.decades(least, most) * ahead(random));
    let moved = |p: DVec3| place.offset + p * place.scale;
    case_of(corners.map(moved), moved(origin), way * random.decades(1e-2, 1e2))
}

/// A power of two near `x`.
fn power_of_two(x: f64) -> f64 {
    libm::exp2(libm::log2(x).round())
}

/// The vector with its coordinates moved on by `turn` axes.
fn turned(v: DVec3, turn: usize) -> DVec3 {
    DVec3::new(v[turn % 3], v[(turn + 1) % 3], v[(turn + 2) % 3])
}

/// A ray of `f32` numbers through the origin of the world, to which the
/// triangle is moved: its start is its direction times a power of two.
fn through_zero(random: &mut Random, distance: f64) -> (DVec3, DVec3) {
    let direction = f32_point(random.direction() * random.decades(1e-2, 1e2));
    let back = power_of_two(distance / direction.length()) * ahead(random);
    (direction * -back, direction)
}

fn far(random: &mut Random) -> Case {
    let corners = plump(random);
    let target = around(random, corners);
    let distance = random.one_of(&[1e3, 1e6]);
    let (origin, direction) = through_zero(random, distance);
    // Along the ray, so that `t` is not always a power of two.
    let along = direction * (random.between(-0.5, 0.5) / direction.length());
    case_of(corners.map(|corner| corner - target + along), origin, direction)
}

/// A triangle along an axis, as wide across as a part of its length, and a ray
/// through the axis: numbers that `f32` holds however thin it is.
fn needle(random: &mut Random) -> Case {
    let width = random.one_of(&[1e-3, 1e-6, 1e-9]);
    let (turn, along) = (random.below(3), DVec3::new(1.0, width, width));
    let corners = plump(random).map(|corner| corner * along);
    let target = around(random, corners);
    let across = DVec3::new(0.0, target.y, target.z);
    let distance = random.decades(1.0, 10.0);
    let (start, direction) = through_zero(random, distance);
    let origin = start + DVec3::new(target.x, 0.0, 0.0);
    // Along the ray, so that `t` is not always a power of two.
    let across = across - direction * (width * random.between(-10.0, 10.0) / direction.length());
    case_of(
        corners.map(|corner| turned(corner - across, turn)),
        turned(origin, turn),
        turned(direction, turn),
    )
}

/// A triangle in a plane but for a part of the angle at which the ray comes.
fn grazing(random: &mut Random) -> Case {
    let angle = random.one_of(&[1e-3, 1e-6, 1e-9]);
    let turn = random.below(3);
    let flatness = DVec3::new(1.0, 1.0, 0.1 * angle);
    let corners = plump_flat(random).map(|corner| corner * flatness);
    let target = around(random, corners);
    let turned_by = random.between(0.0, std::f64::consts::TAU);
    let (sin, cos) = libm::sincos(turned_by);
    let length = random.decades(1e-2, 1e2);
    let slope = angle * random.sign() * random.between(0.5, 1.0);
    let direction = f32_point(DVec3::new(cos, sin, slope) * length);
    let back = power_of_two(random.decades(1.0, 10.0) / length) * ahead(random);
    let origin = DVec3::new(target.x, target.y, 0.0) - direction * back;
    let down = DVec3::new(0.0, 0.0, target.z);
    case_of(
        corners.map(|corner| turned(corner - down, turn)),
        turned(origin, turn),
        turned(direction, turn),
    )
}

/// As [`plump`], seen along z.
fn plump_flat(random: &mut Random) -> [DVec3; 3] {
    loop {
        let corners @ [a, b, c] = plump(random);
        if (b - a).cross(c - a).z.abs() > 0.2 {
            return corners;
        }
    }
}

/// Coordinates of all sizes from 1e-4 to 1e4 or from 1e-8 to 1e8 in one case.
///
/// Source: the random numbers `pExp` of pbrt's tests of reintersection.
fn mixed_scale(random: &mut Random) -> Case {
    let most = random.one_of(&[1e4, 1e8]);
    let number = |random: &mut Random| random.decades(1.0 / most, most) * random.sign();
    let point = |random: &mut Random| DVec3::new(number(random), number(random), number(random));
    let corners = [point(random), point(random), point(random)];
    let target = around(random, corners);
    let origin = point(random);
    case_of(corners, origin, (target - origin) * random.decades(1e-2, 1e2))
}

/// Whole numbers, and a ray that meets the triangle exactly at a corner, on an
/// edge, or at a point inside. With `exact`, the direction's longest component
/// is a power of two, so that its slopes are exact too.
fn lattice(random: &mut Random, exact: bool) -> Case {
    /// Coordinates up to here, which leave room for all products.
    const MOST: usize = 64;
    let whole = |random: &mut Random| random.below(2 * MOST + 1) as f64 - MOST as f64;
    let point = |random: &mut Random| DVec3::new(whole(random), whole(random), whole(random));
    let (corners, direction) = loop {
        let corners @ [a, b, c] = [point(random), point(random), point(random)];
        let mut direction = point(random);
        if exact {
            direction[random.below(3)] = MOST as f64 * random.sign();
        }
        // A triangle, and a ray across it.
        if (b - a).cross(c - a).dot(direction) != 0.0 {
            break (corners.map(|corner| corner * 4.0), direction);
        }
    };
    // Quarters of edges, halves of them from the middle of another: whole
    // numbers, as the corners are multiples of four.
    let quarters = random.one_of(&[(0, 0), (1, 0), (2, 0), (3, 0), (2, 2), (1, 1), (1, 3), (3, 3)]);
    let first = random.below(3);
    let [a, b, c] = [first, first + 1, first + 2].map(|k| corners[k % 3]);
    let (beta, gamma) = (f64::from(quarters.0) / 4.0, f64::from(quarters.1) / 4.0);
    let target = a + beta * (b - a) + gamma * (c - a);
    let steps = 1.0 + random.below(8) as f64;
    // Some of them from behind, which is a miss.
    let steps = if random.below(8) == 0 { -steps } else { steps };
    case_of(corners, target - direction * steps, direction)
}
