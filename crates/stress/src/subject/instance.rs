//! Objects inside up to four transforms, met where the exact product of the
//! matrices puts them; and groups of them in a hierarchy, against the list.

use tracer::glam::{DMat4, DVec3};
use tracer::shape::{AxisBox, Geometry, Shape, Sphere, Triangle};
use tracer::{Interval, Ray};

use self::truth::{CORNERS, Meeting};
use super::chain::{Chain, Exact, Limits, seed};
use crate::family::{Family, Kernel, Volume};
use crate::number::{Dd, Number, V3};
use crate::truth::UNIT_ROUNDOFF;
use crate::{Case, Metric, Random, Tally};

mod brute_force;
mod truth;

/// Every family of instances.
pub(super) fn families() -> Vec<Family> {
    let mut families: Vec<_> = KINDS.iter().map(|kind| family(*kind)).collect();
    families.push(brute_force::family());
    families
}

/// Scales of 1e-6 to 1e6 and translations of up to 1e8, but no object so far
/// from the origin that its coordinates leave it only a few digits.
const LIMITS: Limits = Limits { scale: 1e6, translation: 1e8, sizes: 1e9 };

/// How many times more than one rounding of its inputs may decide a tie.
const TIE: f64 = 8.0;

/// The most that a world point is off by the rounding of its own coordinates
/// and of what they are sums of, over 2^-53 of the largest: one for each
/// product and sum of each of four transforms.
const PLACES: f64 = 32.0;

/// A shape with its exact formula.
type Kind = (&'static str, fn() -> Option<Shape>, fn(&truth::Ray) -> Meeting);

const KINDS: [Kind; 3] = [
    ("sphere", || Some(Sphere::new(DVec3::ZERO, 1.0).ok()?.into()), truth::Ray::sphere),
    ("box", || Some(AxisBox::new(-DVec3::ONE, DVec3::ONE).ok()?.into()), truth::Ray::axis_box),
    (
        "triangle",
        || Some(Triangle::new(CORNERS[0], CORNERS[1], CORNERS[2]).ok()?.into()),
        truth::Ray::triangle,
    ),
];

/// A ray from 1 to 100 sizes away towards the object or past it.
fn ray(chain: &Chain, random: &mut Random) -> Ray {
    let map = chain.product();
    let target = 1.25 * random.point();
    let origin = target + random.direction() * random.decades(1.0, 100.0);
    let (target, origin) = (map.transform_point3(target), map.transform_point3(origin));
    Ray::new(origin, (target - origin) * random.decades(0.1, 10.0))
}

fn family((name, shape, meeting): Kind) -> Family {
    Family {
        primitive: "instance",
        name: name.to_owned(),
        kernels: vec![
            Kernel::GOLDRAY,
            Kernel::textbook("inverse-4x4-f64"),
            Kernel::textbook("inverse-4x4-f32"),
        ],
        targets: vec![
            (Metric::FalseMisses, Some(0.0)),
            (Metric::FalseHits, Some(0.0)),
            (Metric::NotFinite, Some(0.0)),
            (Metric::PositionError, Some(1e-13)),
        ],
        volume: Volume { quick: 100_000, full: 33_333_334 },
        generate: Box::new(|random| {
            let seed = seed(random);
            let ray = ray(&Chain::of_seed(seed, LIMITS), random);
            Case::EMPTY.with(seed).with_ray(&ray)
        }),
        judge: Box::new(move |case, tallies| {
            let (chain, ray) = (Chain::of_seed(case.number(0), LIMITS), case.ray(1));
            let Some(shape) = shape() else { return };
            let Some(group) = chain.group(shape.clone()) else { return };
            let exact = chain.exact();
            let origin = exact.object_point(&V3::of(ray.origin));
            let inner = truth::Ray {
                rounding: TIE * exact.rounding(ray.origin, origin.to_f64().length()),
                origin,
                direction: exact.object_vector(&V3::of(ray.direction)),
            };
            let meeting = meeting(&inner);
            let ours = group.intersect(&ray, Interval::AHEAD).map(|hit| (hit.t, hit.point));
            let inverse = chain.product();
            let answers = [
                ours,
                by_inverse_f64(&inverse.into(), &shape, &ray),
                by_inverse_f32(&inverse.into(), &shape, &ray),
            ];
            for (answer, tally) in answers.into_iter().zip(tallies) {
                judge(&meeting, &inner, &exact, answer, tally);
            }
        }),
    }
}

fn judge(
    meeting: &Meeting,
    inner: &truth::Ray,
    exact: &Exact,
    answer: Option<(f64, DVec3)>,
    tally: &mut Tally,
) {
    if answer.is_some_and(|(t, point)| !(t.is_finite() && point.is_finite())) {
        tally.case();
        tally.count(Metric::NotFinite);
        return;
    }
    match (meeting, answer) {
        (Meeting::Tie, _) => tally.tie(),
        (Meeting::Miss, None) => tally.case(),
        (Meeting::Miss, Some(_)) => {
            tally.case();
            tally.count(Metric::FalseHits);
        }
        (Meeting::Hit(..), None) => {
            tally.case();
            tally.count(Metric::FalseMisses);
        }
        (Meeting::Hit(t, cosine), Some((found, point))) => {
            tally.case();
            let expected = exact.world_point(&(inner.origin + inner.direction.scale(t)));
            let error = (V3::<Dd>::of(point) - expected).to_f64().length();
            // A grazing ray meets the surface that much less surely, and the
            // farther it comes from the less: both are the ray's own doing.
            let sure = cosine / inner.origin.to_f64().length().max(1.0);
            let places = PLACES * UNIT_ROUNDOFF * (exact.reach + point.length());
            tally.most(Metric::PositionError, (error * sure - places).max(0.0) / exact.stretch);
            // Along the ray the world's coordinates are not in between: what
            // they lose on the way in is all the tracer's own.
            let along = distance(found, *t) * inner.direction.length().to_f64();
            let places = PLACES * exact.inner_rounding();
            tally.most(Metric::PositionError, (along * sure - places).max(0.0));
        }
    }
}

/// `|x - exact|`.
fn distance(x: f64, exact: Dd) -> f64 {
    (Dd::of(x) - exact).to_f64().abs()
}

/// The ray goes in by one inverse of the whole matrix, its translation a
/// column like the others.
fn by_inverse_f64(map: &DMat4, shape: &Shape, ray: &Ray) -> Option<(f64, DVec3)> {
    let inverse = map.inverse();
    let inner =
        Ray::new(inverse.transform_point3(ray.origin), inverse.transform_vector3(ray.direction));
    let contact = shape.intersect(&inner, Interval::AHEAD)?;
    Some((contact.t, map.transform_point3(shape.surface(&inner, &contact).point)))
}

/// The same, the matrices in `f32`; the shape itself is met in `f64`.
fn by_inverse_f32(map: &DMat4, shape: &Shape, ray: &Ray) -> Option<(f64, DVec3)> {
    let map = map.as_mat4();
    let inverse = map.inverse();
    let inner = Ray::new(
        inverse.transform_point3(ray.origin.as_vec3()).as_dvec3(),
        inverse.transform_vector3(ray.direction.as_vec3()).as_dvec3(),
    );
    let contact = shape.intersect(&inner, Interval::AHEAD)?;
    let point = shape.surface(&inner, &contact).point;
    Some((contact.t, map.transform_point3(point.as_vec3()).as_dvec3()))
}
