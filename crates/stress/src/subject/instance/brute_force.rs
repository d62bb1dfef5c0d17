//! Groups of shapes and of groups, in hierarchies and in lists: the same hit
//! to the bit.

use std::sync::{Arc, LazyLock};

use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::shape::{AxisBox, Cone, Cylinder, Disk, Mesh, Plane, Shape, Sphere, Torus, Triangle};
use tracer::{Group, Hit, Interval, Material, Member, Object, Ray, Transform};

use super::super::chain::{Chain, Limits, seed};
use crate::family::{Family, Kernel, Volume};
use crate::meshes::Solid;
use crate::{Case, Metric, Random};

/// How many scenes there are.
const SCENES: u64 = 48;

/// Chains that leave the objects about where the others are.
const NEAR: Limits = Limits { scale: 30.0, translation: 1.5, sizes: 1e3 };

/// The same members in lists and in hierarchies.
struct Pair {
    list: Group,
    bvh: Group,
    /// Corners of the objects, in the world: where boxes are touched.
    corners: Vec<DVec3>,
}

/// A shape about the origin with points of its surface that its box touches.
fn shape(random: &mut Random) -> Option<(Shape, Vec<DVec3>)> {
    let r = random.decades(0.03, 0.3);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    Some(match random.below(15) {
        0..3 => (Sphere::new(DVec3::ZERO, r).ok()?.into(), axes.map(|axis| r * axis).to_vec()),
        3..6 => {
            let mut half = DVec3::splat(r);
            // One in three is flat.
            if random.below(3) == 0 {
                half[random.below(3)] = 0.0;
            }
            let corners = [half, -half, half * DVec3::new(1.0, -1.0, 1.0)];
            (AxisBox::new(-half, half).ok()?.into(), corners.to_vec())
        }
        6..9 => {
            let [a, b, c] = [random.point(), random.point(), random.point()].map(|p| r * p);
            (Triangle::new(a, b, c).ok()?.into(), vec![a, b, c])
        }
        9 => {
            let any = random.direction();
            let n = random.one_of(&[DVec3::X, DVec3::Y, DVec3::Z, any]);
            (Disk::new(DVec3::ZERO, n, r).ok()?.into(), vec![DVec3::ZERO])
        }
        10 => {
            let ball = Solid::icosphere(0);
            let vertices: Vec<_> = ball.vertices.iter().map(|&p| r * p).collect();
            (Mesh::new(vertices.clone(), ball.faces, None, Build::Bvh).ok()?.into(), vertices)
        }
        11 => {
            let (axis, caps) = (r * random.direction(), random.coin());
            let tube = Cylinder::new(-axis, axis, 0.5 * r, caps).ok()?;
            (tube.into(), vec![axis, axis + 0.5 * r * random.across(axis)])
        }
        12 => {
            let (axis, caps) = (r * random.direction(), random.coin());
            let cone = Cone::new(-axis, axis, 0.5 * r, caps).ok()?;
            (cone.into(), vec![-axis, axis + 0.5 * r * random.across(axis)])
        }
        13 => {
            let axis = random.direction();
            let ring = Torus::new(DVec3::ZERO, axis, r, random.between(0.05, 1.0) * r).ok()?;
            (ring.into(), vec![DVec3::ZERO, r * random.across(axis)])
        }
        _ => (Plane::new(-DVec3::ONE, random.direction()).ok()?.into(), vec![DVec3::ONE]),
    })
}

fn pair(number: u64) -> Option<Pair> {
    let mut random = Random::of_chunk(0, "groups", number);
    let count = random.decades(5.0, 100.0) as usize;
    // A few copies of the same, whose ties the first must win.
    let kinds = (0..count.div_ceil(2)).map(|_| {
        let (shape, corners) = shape(&mut random)?;
        let nested = match (random.below(4), seed(&mut random)) {
            (0, seed) => Some(Chain::of_seed(seed, NEAR)),
            (1, seed) => Some(Chain::stretched(seed)),
            _ => None,
        };
        Some((shape, corners, nested, random.point()))
    });
    let kinds: Option<Vec<_>> = kinds.collect();
    let kinds = kinds?;
    let order: Vec<usize> = (0..count).map(|_| random.below(kinds.len())).collect();
    let world = |build| {
        let member = |&i: &usize| {
            let (shape, _, nested, place) = &kinds[i];
            let inner = match nested {
                Some(chain) => Member::Group(chain.group(shape.clone())?),
                None => Member::Object(Object::new(shape.clone(), Material::Normal)),
            };
            let place = Transform::translation(*place).ok()?;
            Some(Member::Group(Group::new(place, vec![inner], build)))
        };
        let members: Option<Vec<_>> = order.iter().map(member).collect();
        Some(Group::new(Transform::IDENTITY, members?, build))
    };
    let corners = kinds.iter().flat_map(|(_, corners, nested, place)| {
        let map = nested.as_ref().map(Chain::product).unwrap_or_default();
        corners.iter().map(move |&p| map.transform_point3(p) + *place)
    });
    Some(Pair { list: world(Build::List)?, bvh: world(Build::Bvh)?, corners: corners.collect() })
}

/// A ray at or past a corner, or anywhere.
fn ray(pair: &Pair, random: &mut Random) -> Ray {
    let mut target = match random.below(3) {
        0 => random.point(),
        _ => pair.corners[random.below(pair.corners.len())],
    };
    let mut way = random.direction();
    match random.below(3) {
        0 => {}
        1 => {
            let axis = random.below(3);
            way = DVec3::ZERO;
            way[axis] = random.sign();
        }
        _ => {
            let axis = random.below(3);
            way[axis] = 0.0;
            target[axis] += random.one_of(&[0.0, 1e-16, -1e-16, 1e-14, -1e-14]);
        }
    }
    let distance = random.one_of(&[1.0, 3.0, 1e3, 1e5]) * random.unit();
    Ray::new(target - way * distance, way * random.decades(0.1, 10.0))
}

type Pairs = Arc<LazyLock<Vec<Pair>, fn() -> Vec<Pair>>>;

/// The family.
pub(super) fn family() -> Family {
    let makes: Pairs = Arc::new(LazyLock::new(|| (0..SCENES).filter_map(pair).collect()));
    let judges = Arc::clone(&makes);
    Family {
        primitive: "instance",
        name: "brute-force".to_owned(),
        kernels: vec![Kernel::GOLDRAY],
        targets: vec![(Metric::Disagreements, Some(0.0)), (Metric::NotFinite, Some(0.0))],
        volume: Volume { quick: 150_000, full: 20_000_000 },
        generate: Box::new(move |random| {
            let number = random.below(makes.len());
            let Some(pair) = makes.get(number) else { return Case::EMPTY };
            let ray = ray(pair, random);
            let hi = random.one_of(&[f64::INFINITY, f64::INFINITY, 1.0, 0.3]);
            Case::EMPTY.with(number as f64).with_ray(&ray).with(0.0).with(hi)
        }),
        judge: Box::new(move |case, tallies| {
            let Some(Pair { list, bvh, .. }) = judges.get(case.number(0) as usize) else { return };
            let (ray, range) = (case.ray(1), Interval::new(case.number(7), case.number(8)));
            let (one, other) = (list.intersect(&ray, range), bvh.intersect(&ray, range));
            let agree =
                is_same(one.as_ref(), other.as_ref()) && bvh.occludes(&ray, range) == one.is_some();
            for tally in tallies {
                tally.case();
                if !agree {
                    tally.count(Metric::Disagreements);
                }
                if other.is_some_and(|hit| !(hit.t.is_finite() && hit.point.is_finite())) {
                    tally.count(Metric::NotFinite);
                }
            }
        }),
    }
}

/// The same object and part at the same `t` to the bit.
fn is_same(one: Option<&Hit>, other: Option<&Hit>) -> bool {
    let of =
        |hit: &Hit| (hit.t.to_bits(), hit.object, hit.part, hit.point.to_array().map(f64::to_bits));
    one.map(of) == other.map(of)
}
