//! What is asked of a sphere's hit: its point and its normal.

use tracer::glam::DVec3;
use tracer::lecture::sphere_algebraic;
use tracer::shape::{Contact, Geometry, Sphere};
use tracer::{Interval, Ray, UnitVec};

use super::sphere::{aimed, over_disc};
use crate::family::{Family, Kernel, Volume};
use crate::number::{Dd, Number, V3};
use crate::truth::{UNIT_ROUNDOFF, distance};
use crate::{Case, Metric, Random, Tally, truth};

const VOLUME: Volume = Volume { quick: 250_000, full: 20_000_000 };

/// Point and normal of hits that do not graze, from near and from far.
pub(super) fn families() -> Vec<Family> {
    vec![family("normals", (1.0, 10.0)), family("normals-far", (10.0, 1e8))]
}

/// The widest impact, in radii: a third of a right angle or more is left
/// between the ray and the surface.
const REACH: f64 = 0.85;

fn family(name: &str, (least, most): (f64, f64)) -> Family {
    let generate = move |random: &mut Random| {
        let radius = random.decades(1e-3, 1e3);
        let center = random.point() * (10.0 * radius);
        let impact = over_disc(random, radius, REACH);
        let distance = radius * random.decades(least, most);
        aimed(random, center, radius, distance, impact)
    };
    Family {
        primitive: "sphere",
        name: name.to_owned(),
        kernels: vec![Kernel::GOLDRAY, Kernel::textbook("at-t-of-algebraic")],
        targets: vec![
            (Metric::FalseMisses, Some(0.0)),
            (Metric::NormalError, Some(3.0)),
            (Metric::PositionError, Some(3.0)),
        ],
        volume: VOLUME,
        generate: Box::new(generate),
        judge: Box::new(|case, tallies| {
            for (answer, tally) in [goldray, textbook].iter().zip(tallies) {
                judge(case, answer(case), tally);
            }
        }),
    }
}

/// A hit: its `t`, its point and its normal.
type Hit = (f64, DVec3, DVec3);

fn goldray(case: &Case) -> Option<Hit> {
    let (sphere, ray) = (Sphere::new(case.point(0), case.number(3)).ok()?, case.ray(4));
    let contact: Contact = sphere.intersect(&ray, Interval::AHEAD)?;
    let surface = sphere.surface(&ray, &contact);
    Some((contact.t, surface.point, *surface.shading_normal))
}

fn textbook(case: &Case) -> Option<Hit> {
    let (center, ray): (DVec3, Ray) = (case.point(0), case.ray(4));
    let t = sphere_algebraic(center, case.number(3), &ray, Interval::AHEAD)?;
    let point = ray.at(t);
    Some((t, point, *UnitVec::new(point - center)?))
}

fn judge(case: &Case, hit: Option<Hit>, tally: &mut Tally) {
    tally.case();
    let Some((t, point, normal)) = hit else {
        if truth::sphere(case).t.is_some() {
            tally.count(Metric::FalseMisses);
        }
        return;
    };
    // Where there is no exact hit the families of the hit itself complain.
    let Some(outward) = truth::sphere_point(case, t) else { return };
    // The angle between two vectors, by its sine: it is small.
    let seen = V3::<Dd>::of(normal);
    let sine = outward.cross(&seen).length() / (outward.length() * seen.length());
    tally.most(Metric::NormalError, sine.to_f64() / UNIT_ROUNDOFF);
    let center = case.point(0);
    let exact = outward + V3::of(center);
    let off = |x: f64, exact: Dd| distance(x, (exact.hi(), exact.lo()));
    let off = DVec3::new(off(point.x, exact.x), off(point.y, exact.y), off(point.z, exact.z));
    let size = case.number(3) + center.length();
    tally.most(Metric::PositionError, off.length() / (UNIT_ROUNDOFF * size));
}
