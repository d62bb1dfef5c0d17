//! What is asked of the box: rays through corners and edges, along faces, and
//! flat boxes, of which no exact hit may be lost.

use tracer::glam::DVec3;
use tracer::lecture::ray_box;
use tracer::shape::{AxisBox, Geometry};
use tracer::{Interval, Ray};

use super::closest::{Inputs, Subject, special};
use crate::family::{Family, Kernel, Volume};
use crate::random::f32_of;
use crate::{Case, Random, truth};

const VOLUME: Volume = Volume { quick: 250_000, full: 20_000_000 };
/// The slab test is the inner loop of everything, and its failures are rare.
const AIMED: Volume = Volume { quick: 1_000_000, full: 1_000_000_000 };
const DOUBLE: Inputs = Inputs::Double { condition_error: 4.0 };

/// Every family of the box.
pub(super) fn families() -> Vec<Family> {
    let subject = Subject {
        primitive: "box",
        truth: truth::axis_box,
        answers: vec![(Kernel::GOLDRAY, goldray), (Kernel::textbook("slabs-f64"), slabs)],
    };
    let special_volume = Volume { quick: 100_000, full: 10_000_000 };
    let solid = boxed;
    vec![
        subject.family("aimed", DOUBLE, AIMED, |random| {
            let aim = Aim { flat: random.coin(), world: random.below(4) == 0, far: None };
            aimed(random, &aim)
        }),
        subject.family("corner-aimed", DOUBLE, VOLUME, |random| {
            aimed(random, &Aim { flat: false, world: false, far: None })
        }),
        subject.family("flat", DOUBLE, VOLUME, |random| {
            aimed(random, &Aim { flat: true, world: false, far: None })
        }),
        subject.family("flat-1e4", DOUBLE, VOLUME, |random| {
            aimed(random, &Aim { flat: true, world: false, far: Some(14) })
        }),
        subject.family("world-1e6", DOUBLE, VOLUME, |random| {
            aimed(random, &Aim { flat: false, world: true, far: None })
        }),
        subject.family("on-face", DOUBLE, VOLUME, move |random| {
            let corners = solid(random);
            on_face(random, corners, 0.0)
        }),
        subject.family("on-face-minus-0", DOUBLE, VOLUME, move |random| {
            let corners = solid(random);
            on_face(random, corners, -0.0)
        }),
        subject.family("denormal", DOUBLE, VOLUME, move |random| {
            let corners = solid(random);
            denormal(random, corners)
        }),
        subject
            .family("rounded-aim", DOUBLE, VOLUME, move |random| {
                let corners = solid(random);
                rounded_aim(random, corners)
            })
            // Each is aimed at an edge but for the rounding of its direction.
            .with_ties(50_000.0),
        subject.family("random", DOUBLE, VOLUME, |random| anywhere(random, false)),
        subject.family("random-f32", Inputs::Single { ulp32: 0.5 }, VOLUME, |random| {
            let case = anywhere(random, false);
            case.numbers().iter().fold(Case::EMPTY, |single, &x| single.with(f32_of(x)))
        }),
        subject.family("inside", DOUBLE, VOLUME, |random| anywhere(random, true)),
        special("box", subject.answers, RAY, special_volume, |random| anywhere(random, false)),
    ]
}

/// Where a case's ray starts: behind two corners.
const RAY: usize = 6;

fn goldray(case: &Case) -> Option<f64> {
    let solid = AxisBox::new(case.point(0), case.point(3)).ok()?;
    solid.intersect(&case.ray(RAY), Interval::AHEAD).map(|contact| contact.t)
}

fn slabs(case: &Case) -> Option<f64> {
    let (enter, leave) = ray_box(case.point(0), case.point(3), &case.ray(RAY))?;
    [enter, leave].into_iter().find(|&t| Interval::AHEAD.contains(t))
}

/// The lowest and the highest corner.
type Corners = [DVec3; 2];

fn case_of([min, max]: Corners, origin: DVec3, direction: DVec3) -> Case {
    Case::EMPTY.with_point(min).with_point(max).with_ray(&Ray::new(origin, direction))
}

/// A whole number from 1 to `most`.
fn count(random: &mut Random, most: usize) -> f64 {
    1.0 + random.below(most) as f64
}

/// A box of whole numbers of up to ten bits.
fn boxed(random: &mut Random) -> Corners {
    const MOST: usize = 1000;
    let mut corner = |sign: f64| {
        let mut whole = || count(random, MOST) * sign;
        DVec3::new(whole(), whole(), whole())
    };
    [corner(-1.0), corner(1.0)]
}

/// A whole number below `n`.
fn below(random: &mut Random, n: usize) -> i64 {
    i64::try_from(random.below(n)).unwrap_or(0)
}

/// Which boxes to aim at.
struct Aim {
    /// Without thickness along one axis.
    flat: bool,
    /// As far from the world's origin as 2^20 times its size.
    world: bool,
    /// From how many powers of two of its size.
    far: Option<u32>,
}

/// A ray that meets an edge or a corner exactly. Its way from the origin to
/// the box, `t d`, has up to 60 bits in each axis: the lower ones are the
/// box's, the upper ones the ray's origin's, so that no `f64` holds their
/// difference and quotients that are equal come out different.
fn aimed(random: &mut Random, aim: &Aim) -> Case {
    /// Bits of `t` and of each component of the direction.
    const BITS: usize = 30;
    let bits = |random: &mut Random| {
        let bits = 1 + random.below(BITS);
        1 + below(random, (1 << bits) - 1)
    };
    let t = bits(random);
    let speeds = [(); 3].map(|()| bits(random));
    let longest = speeds.into_iter().max().unwrap_or(1) * t;
    let distance_bits = i64::BITS - longest.leading_zeros();
    // The box's: from so few that its differences are exact, to so many that
    // the ray starts beside it.
    let own = distance_bits.saturating_sub(aim.far.unwrap_or(random.below(30) as u32));
    let own = own.clamp(8, if aim.world { 30 } else { 50 });
    let size = 1_i64 << own;
    let through = random.coin().then(|| random.below(3));
    let flat = aim.flat.then(|| random.below(3));
    let (mut corners, mut ray) = ([DVec3::ZERO; 2], Ray::new(DVec3::ZERO, DVec3::ZERO));
    for axis in 0..3 {
        let speed = if random.coin() { speeds[axis] } else { -speeds[axis] };
        let side = (speed * t).rem_euclid(size) - size / 2;
        let start = side - speed * t;
        let offset = if aim.world { (below(random, 1 << 21) - (1 << 20)) * size } else { 0 };
        let [below, above] = [(); 2].map(|()| below(random, size as usize) + 1);
        let (below, above) = match (flat == Some(axis), through == Some(axis), below % 2 == 0) {
            (true, _, _) => (0, 0),
            (_, true, _) => (below, above),
            (_, _, true) => (below, 0),
            (_, _, false) => (0, above),
        };
        corners[0][axis] = (offset + side - below) as f64;
        corners[1][axis] = (offset + side + above) as f64;
        ray.origin[axis] = (offset + start) as f64;
        ray.direction[axis] = speed as f64;
    }
    let [scale, length] = [(); 2].map(|()| libm::exp2(random.below(60) as f64 - 30.0));
    case_of(corners.map(|corner| corner * scale), ray.origin * scale, ray.direction * length)
}

/// A corner, or a whole point on an edge.
fn on_edge(random: &mut Random, corners: Corners) -> DVec3 {
    let mut pick = |axis: usize| corners[random.below(2)][axis];
    let mut target = DVec3::new(pick(0), pick(1), pick(2));
    if random.coin() {
        let axis = random.below(3);
        let length = (corners[1] - corners[0])[axis];
        target[axis] = corners[0][axis] + random.below(length as usize + 1) as f64;
    }
    target
}

/// Numbers up to here have eight digits of their own: a third of an `f32`'s
/// numerators with as many denominators.
const SLOPES: usize = 1 << 10;

fn slope(random: &mut Random) -> DVec3 {
    let mut whole = || count(random, SLOPES) * random.sign();
    DVec3::new(whole(), whole(), whole())
}

/// A ray along an axis within a face, or along an edge.
fn on_face(random: &mut Random, corners: Corners, zero: f64) -> Case {
    let axis = random.below(3);
    let mut origin = on_edge(random, corners);
    let (mut direction, sign) = (DVec3::splat(zero), random.sign());
    // A third whose component is the other zero.
    direction[(axis + 1) % 3] = random.one_of(&[zero, zero, -zero]);
    direction[axis] = sign * count(random, SLOPES);
    let start = if sign > 0.0 { corners[0][axis] } else { corners[1][axis] };
    origin[axis] = start - sign * count(random, SLOPES);
    case_of(corners, origin, direction)
}

/// A ray in or off a face's plane with a direction that leaves it so slowly
/// that the quotients overflow.
fn denormal(random: &mut Random, corners: Corners) -> Case {
    let target = on_edge(random, corners);
    let mut direction = slope(random);
    let axis = random.below(3);
    direction[axis] = 0.0;
    let origin = target - direction * count(random, SLOPES);
    direction[axis] = f64::from_bits(random.below(1 << 20) as u64 + 1) * random.sign();
    case_of(corners, origin, direction)
}

/// At an edge or a corner with numbers that are rounded, and a little past it:
/// an exact hit only by chance.
fn rounded_aim(random: &mut Random, corners: Corners) -> Case {
    let target = on_edge(random, corners);
    let shift = random.point();
    let (direction, distance) = (random.direction(), random.decades(1.0, 1e6));
    // Past it by some roundings or by many.
    let past = random.point() * (distance * f64::EPSILON * random.decades(1.0, 1e6));
    let origin = target + shift + past - direction * distance;
    let direction = direction * random.decades(1e-3, 1e3);
    case_of(corners.map(|corner| corner + shift), origin, direction)
}

fn anywhere(random: &mut Random, inside: bool) -> Case {
    let (a, b) = (random.point(), random.point());
    let corners @ [min, max] = [a.min(b), a.max(b)];
    let within = |random: &mut Random, reach: f64| {
        let s = (random.point() * reach + 1.0) * 0.5;
        min + (max - min) * s
    };
    let target = within(random, 1.2);
    let way = random.direction();
    let origin = if inside { within(random, 1.0) } else { target - way * random.decades(1.0, 1e4) };
    case_of(corners, origin, way * random.decades(1e-10, 1e10))
}
