//! What is asked of the disk: from far away, with oblique normals of any
//! length, grazing, and near its rim.

use tracer::glam::DVec3;
use tracer::shape::{Disk, Geometry};
use tracer::{Interval, Ray};

use super::closest::{Answer, Inputs, Subject, special};
use super::plane::{ahead, grazing_at, normal_and_way, single};
use crate::family::{Family, Kernel, Volume};
use crate::{Case, Random, truth};

const VOLUME: Volume = Volume { quick: 250_000, full: 20_000_000 };
const DOUBLE: Inputs = Inputs::Double { condition_error: 4.0 };
const SINGLE: Inputs = Inputs::Single { ulp32: 0.5 };

/// Every family of the disk.
pub(super) fn families() -> Vec<Family> {
    let answers: Vec<Answer> =
        vec![(Kernel::GOLDRAY, goldray), (Kernel::textbook("textbook-f64"), textbook)];
    let subject = Subject { primitive: "disk", truth: truth::disk, answers: answers.clone() };
    let special_volume = Volume { quick: 100_000, full: 10_000_000 };
    let near = |random: &mut Random| aimed(random, (1.0, 10.0), 0.5, 1.2);
    let far = |random: &mut Random| aimed(random, (1.0, 1e8), 0.5, 1.2);
    vec![
        subject.family("random", DOUBLE, VOLUME, near),
        subject.family("random-f32", SINGLE, VOLUME, move |random| single(&near(random))),
        subject.family("far", DOUBLE, VOLUME, far),
        subject.family("far-f32", SINGLE, VOLUME, far_f32),
        subject.family("grazing", DOUBLE, VOLUME, grazing),
        subject.family("grazing-f32", SINGLE, VOLUME, |random| single(&grazing(random))),
        subject.family("rim", DOUBLE, VOLUME, rim),
        subject.family("rim-f32", SINGLE, VOLUME, |random| single(&rim(random))),
        special("disk", answers, 7, special_volume, near),
    ]
}

fn goldray(case: &Case) -> Option<f64> {
    let disk = Disk::new(case.point(0), case.point(3), case.number(6)).ok()?;
    disk.intersect(&case.ray(7), Interval::AHEAD).map(|contact| contact.t)
}

/// The plane's `t`, and the point's distance from the center.
fn textbook(case: &Case) -> Option<f64> {
    let (center, n, radius, ray) = (case.point(0), case.point(3), case.number(6), case.ray(7));
    let t = (center - ray.origin).dot(n) / ray.direction.dot(n);
    let is_inside = (ray.at(t) - center).length() <= radius;
    (is_inside && Interval::AHEAD.contains(t)).then_some(t)
}

fn case_of(center: DVec3, normal: DVec3, radius: f64, origin: DVec3, direction: DVec3) -> Case {
    let disk = Case::EMPTY.with_point(center).with_point(normal).with(radius);
    disk.with_ray(&Ray::new(origin, direction))
}

/// A disk, met between these parts of its radius from these many radii away.
fn aimed(random: &mut Random, (near, far): (f64, f64), least: f64, most: f64) -> Case {
    let (normal, way) = normal_and_way(random);
    let radius = random.decades(1e-3, 1e3);
    let center = random.point() * (3.0 * radius);
    let from_center = random.across(normal) * (radius * random.between(least, most));
    let origin = center + from_center - way * (radius * random.decades(near, far) * ahead(random));
    let (long, length) = (random.decades(1e-10, 1e10), random.decades(1e-10, 1e10));
    case_of(center, normal * long, radius, origin, way * length)
}

/// A ray of `f32` numbers through the origin of the world, which is near
/// the disk: its start is its direction times a power of two.
fn far_f32(random: &mut Random) -> Case {
    let (normal, way) = normal_and_way(random);
    let radius = random.decades(1e-3, 1e3);
    // Off the world's origin by a part of its size, so that `t` is not always
    // a power of two.
    let center = random.across(normal) * (radius * random.between(0.0, 1.2))
        + way * (radius * random.between(-0.5, 0.5));
    let wanted = radius * random.decades(1.0, 1e8);
    let disk = single(&case_of(center, normal, radius, DVec3::ZERO, way));
    let direction = disk.ray(7).direction;
    let back = libm::exp2(libm::log2(wanted).round());
    case_of(
        disk.point(0),
        disk.point(3),
        disk.number(6),
        direction * (-back * ahead(random)),
        direction,
    )
}

fn grazing(random: &mut Random) -> Case {
    let radius = random.decades(0.1, 10.0);
    let distance = radius * random.decades(1.0, 10.0) * ahead(random);
    let target = if random.coin() { DVec3::ZERO } else { random.point() };
    let (normal, origin, direction) = grazing_at(random, target, distance);
    let center = target + random.across(normal) * (radius * random.between(0.0, 1.2));
    case_of(center, normal * random.decades(1e-3, 1e3), radius, origin, direction)
}

/// At a part of 1e-13 to 1e-1 inside or outside the rim.
fn rim(random: &mut Random) -> Case {
    let inside = 1.0 - random.decades(1e-13, 0.1) * random.sign();
    aimed(random, (1.0, 10.0), inside, inside)
}
