//! What is asked of the plane: from far away, with oblique normals of any
//! length, and grazing.

use tracer::glam::DVec3;
use tracer::shape::{Geometry, Plane};
use tracer::{Interval, Ray};

use super::closest::{Answer, Inputs, Subject, special};
use crate::family::{Family, Kernel, Volume};
use crate::random::{f32_of, f32_point};
use crate::{Case, Random, truth};

const VOLUME: Volume = Volume { quick: 300_000, full: 20_000_000 };
const DOUBLE: Inputs = Inputs::Double { condition_error: 4.0 };
const SINGLE: Inputs = Inputs::Single { ulp32: 0.5 };

/// Every family of the plane.
pub(super) fn families() -> Vec<Family> {
    let answers: Vec<Answer> =
        vec![(Kernel::GOLDRAY, goldray), (Kernel::textbook("textbook-f64"), textbook)];
    let subject = Subject { primitive: "plane", truth: truth::plane, answers: answers.clone() };
    let special_volume = Volume { quick: 100_000, full: 10_000_000 };
    vec![
        subject.family("random", DOUBLE, VOLUME, random_one),
        subject.family("random-f32", SINGLE, VOLUME, |random| single(&random_one(random))),
        subject.family("far", DOUBLE, VOLUME, far),
        subject.family("far-f32", SINGLE, VOLUME, |random| single(&far(random))),
        subject.family("grazing", DOUBLE, VOLUME, grazing),
        subject.family("grazing-f32", SINGLE, VOLUME, |random| single(&grazing(random))),
        special("plane", answers, 6, special_volume, random_one),
    ]
}

fn goldray(case: &Case) -> Option<f64> {
    let plane = Plane::new(case.point(0), case.point(3)).ok()?;
    plane.intersect(&case.ray(6), Interval::AHEAD).map(|contact| contact.t)
}

/// `t = (a - p).n / d.n` as it stands.
fn textbook(case: &Case) -> Option<f64> {
    let (point, n, ray) = (case.point(0), case.point(3), case.ray(6));
    let t = (point - ray.origin).dot(n) / ray.direction.dot(n);
    Interval::AHEAD.contains(t).then_some(t)
}

fn case_of(point: DVec3, normal: DVec3, origin: DVec3, direction: DVec3) -> Case {
    Case::EMPTY.with_point(point).with_point(normal).with_ray(&Ray::new(origin, direction))
}

/// The case with every number rounded to `f32`.
pub(super) fn single(case: &Case) -> Case {
    case.numbers().iter().fold(Case::EMPTY, |single, &x| single.with(f32_of(x)))
}

/// An oblique unit normal, and a way that does not graze its plane.
pub(super) fn normal_and_way(random: &mut Random) -> (DVec3, DVec3) {
    let normal = random.direction();
    loop {
        let way = random.direction();
        if way.dot(normal).abs() > 0.05 {
            return (normal, way);
        }
    }
}

/// 1, and now and then -1: for a hit that is behind the ray's origin.
pub(super) fn ahead(random: &mut Random) -> f64 {
    if random.below(8) == 0 { -1.0 } else { 1.0 }
}

fn random_one(random: &mut Random) -> Case {
    let (normal, way) = normal_and_way(random);
    let point = random.point() * random.decades(1e-3, 1e3);
    let target = point + random.across(normal) * random.decades(1e-3, 1e3);
    let origin = target - way * (random.decades(1e-3, 1e3) * ahead(random));
    let (long, length) = (random.decades(1e-10, 1e10), random.decades(1e-10, 1e10));
    case_of(point, normal * long, origin, way * length)
}

/// From up to 1e8 sizes: of the plane's point and the hit's distance from it.
fn far(random: &mut Random) -> Case {
    let (normal, way) = normal_and_way(random);
    let point = random.point();
    let target = point + random.across(normal) * random.unit();
    let origin = target - way * (random.decades(1.0, 1e8) * ahead(random));
    case_of(point, normal * random.decades(1e-3, 1e3), origin, way * random.decades(1e-3, 1e3))
}

/// How flat a ray comes: the sine of its angle to the plane.
pub(super) const FLATTEST: (f64, f64) = (1e-9, 1e-3);

/// A plane with its normal and a ray that meets it at `target` at a small
/// angle. Half of them lie along two axes but for a part of the angle, so that
/// `f32` numbers hold it.
pub(super) fn grazing_at(
    random: &mut Random,
    target: DVec3,
    distance: f64,
) -> (DVec3, DVec3, DVec3) {
    let angle = random.decades(FLATTEST.0, FLATTEST.1) * random.sign();
    if random.coin() {
        let normal = random.direction();
        let direction = random.across(normal) + normal * angle;
        return (normal, target - direction * distance, direction);
    }
    let axis = random.below(3);
    let (mut normal, mut direction) = (random.point() * (0.1 * angle), random.direction());
    normal[axis] = 1.0;
    direction[axis] = angle;
    let direction = f32_point(direction);
    let back = libm::exp2(libm::log2(distance.abs()).round()).copysign(distance);
    (normal, target - direction * back, direction)
}

fn grazing(random: &mut Random) -> Case {
    let distance = random.decades(0.1, 10.0) * ahead(random);
    let axis_target = random.coin();
    let target = if axis_target { DVec3::ZERO } else { random.point() };
    let (normal, origin, direction) = grazing_at(random, target, distance);
    let point = target + random.across(normal) * random.unit();
    let (long, length) = (random.decades(1e-3, 1e3), random.decades(1e-3, 1e3));
    case_of(point, normal * long, origin, direction * length)
}
