//! Rays that meet boxes in exact arithmetic: at every level none may be kept
//! out, however it is aimed.

use glam::DVec3;

use super::super::{Candidates, Gathered, Leaf, Options, Span, Visitor};
use super::*;
use crate::exact::Exact;
use crate::meter::Unmetered;
use crate::simd::{Level, Work};
use crate::{Aabb, math};

/// How many boxes a ray is aimed at, one after the other.
const BOXES: usize = 8;

/// A ray, and boxes that it meets at these `t`, exactly.
#[derive(Debug)]
struct Aimed {
    ray: Ray,
    boxes: Vec<Aabb>,
    times: Vec<f64>,
}

impl Candidates for Vec<Aabb> {
    fn count(&self) -> u32 {
        self.len() as u32
    }
    fn bounds(&self, number: u32) -> Option<Aabb> {
        Some(self[number as usize])
    }
}

/// Which leaves are seen.
struct Seen<const ANY: bool>(Vec<usize>);

impl<const ANY: bool> Visitor for Seen<ANY> {
    const ANY: bool = ANY;
    fn visit(&mut self, leaf: Leaf, _: &mut f32) -> bool {
        self.0.push(leaf.place());
        false
    }
    fn address(&self, _: Leaf) -> *const u8 {
        std::ptr::null()
    }
}

/// The boxes seen in a range.
struct See<'a>(&'a Wide, &'a Ray, Interval);

impl Work for See<'_> {
    type Output = [Vec<usize>; 2];
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [Vec<usize>; 2] {
        let Self(wide, ray, range) = self;
        let (mut nearest, mut any) = (Seen::<false>(vec![]), Seen::<true>(vec![]));
        wide.walk_ray(simd, ray, range, &Unmetered, &mut nearest);
        wide.walk_ray(simd, ray, range, &Unmetered, &mut any);
        [nearest.0, any.0]
    }
}

/// `o + t d` along an axis.
fn place(ray: &Ray, t: f64, axis: usize) -> Exact {
    let [o, d, t] = [ray.origin[axis], ray.direction[axis], t].map(Exact::of);
    &o + &(&t * &d)
}

/// A box that holds `o + t d` and hardly more along some axes, and reaches to
/// one side of it along the others.
fn around(ray: &Ray, t: f64, reach: DVec3) -> Aabb {
    let mut aabb = Aabb::EMPTY;
    for axis in 0..3 {
        let at = place(ray, t, axis);
        aabb.min[axis] = at.below() + reach[axis].min(0.0);
        aabb.max[axis] = at.above() + reach[axis].max(0.0);
    }
    aabb
}

/// Holds every level to seeing every box at its `t`.
fn check(aimed: &Aimed, rounding: f64) {
    let Aimed { ray, boxes, times } = aimed;
    let options = Options { leaf_size: 1, extra: 0.0, level: Level::best() };
    let leaf = |_, span: Span| Leaf::new(span.first, span.count);
    let gathered = Gathered::new(boxes, options);
    let (wide, leaves, items) = Wide::new(gathered, boxes, rounding, options, leaf);
    assert_eq!(leaves.len(), boxes.len());
    for (k, &t) in times.iter().enumerate() {
        let range = Interval::new(t.next_down(), t.next_up());
        for level in Level::all() {
            for seen in level.run(See(&wide, ray, range)) {
                let is_seen = seen.iter().any(|&place| items[place] as usize == k);
                assert!(is_seen, "{level:?}: box {k} of {aimed:?}");
            }
        }
    }
}

fn sign(any: &mut fastrand::Rng) -> f64 {
    if any.bool() { 1.0 } else { -1.0 }
}

/// Of any size between these powers of two.
fn sized(any: &mut fastrand::Rng, [lo, hi]: [f64; 2]) -> f64 {
    libm::exp2(lo + (hi - lo) * any.f64()) * (1.0 + any.f64()) * sign(any)
}

/// Numbers of few bits, so that `o + t d` is an `f32` itself and faces are grazed
/// to the bit. They are just above powers of two, and so are their reciprocals
/// and products: there a rounding is largest. The first box is entered through
/// one face where it is left through another, and of many directions those are
/// taken for which that is rounded apart most.
fn few_bits(any: &mut fastrand::Rng) -> Aimed {
    const TRIES: usize = 400;
    let (ahead, far) = (sign(any), [0.0, 0.5, 2.0][any.usize(0..3)]);
    let t = ahead * (1.0 + far) * (1.0 + f64::from(any.u32(1..64)) / 1024.0);
    let (mut origin, mut direction, mut reach) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO);
    for (axis, enters) in [1.0, -1.0, sign(any)].into_iter().enumerate() {
        let number = |any: &mut fastrand::Rng| 1.0 - f64::from(any.u32(0..256)) / 8192.0;
        let side = sign(any);
        let o = far * ahead * side * (1.0 + f64::from(any.u32(0..8)) / 256.0);
        // As without instructions that round a product and a sum at once.
        let late = |d: &f64| {
            let face = o + t * d;
            let apart = ROUNDINGS * UNIT_ROUNDOFF_F32 * (o.abs() + face.abs()) / d.abs();
            let [face, recip, minus] = [face, 1.0 / d, o / d + enters * apart].map(|x| x as f32);
            enters * (f64::from(face * recip - minus) - t)
        };
        let tries = (0..TRIES).map(|_| side * number(any));
        let d = tries.max_by(|a, b| late(a).total_cmp(&late(b))).unwrap();
        (origin[axis], direction[axis]) = (o, d);
        reach[axis] = d.signum() * enters / 4096.0;
    }
    let ray = Ray::new(origin, direction);
    let reaches = (0..BOXES).map(|k| if k == 0 { reach } else { reach * sign(any) });
    let boxes = reaches.map(|reach| around(&ray, t, reach)).collect();
    Aimed { ray, boxes, times: vec![t; BOXES] }
}

/// Numbers of all sizes: flat boxes, far and near origins, directions of any
/// length with components that are 0, -0, denormal or nearly nothing.
fn all_sizes(any: &mut fastrand::Rng) -> Aimed {
    let size = sized(any, [-100.0, 100.0]).abs();
    let flat = [0, 1, 2].map(|_| [1.0, 1.0, 1e-3, 1e-9, 1e-24, 0.0][any.usize(0..6)]);
    let far: f64 = [1.0, 1.0, 0.0, 1e3, 1e8, 1e9, 1e12][any.usize(0..7)];
    let lengths = [[-3.0, 3.0], [-330.0, 330.0]][any.usize(0..2)];
    let length = sized(any, lengths).abs();
    // When it passes by the middle.
    let pass = size * far.max(1.0) / length * sign(any);
    let (mut origin, mut direction) = (DVec3::ZERO, DVec3::ZERO);
    for axis in 0..3 {
        origin[axis] = size * flat[axis] * far * sized(any, [-1.0, 1.0]);
        direction[axis] = match any.u32(0..10) {
            0 => 0.0,
            1 => 1e-300 * sign(any),
            2 => f64::from_bits(any.u64(0..9)) * sign(any),
            3 => length * sized(any, [-70.0, -50.0]),
            4 => length * sign(any),
            _ => (size * flat[axis] * sized(any, [-2.0, 1.0]) - origin[axis]) / pass,
        };
    }
    let ray = Ray::new(origin, direction);
    let times: Vec<_> = (0..BOXES)
        .map(|k| pass * if k % 2 == 0 { 0.5 + any.f64() } else { sized(any, [-40.0, 0.0]) })
        .collect();
    let mut reach = |k: usize| size * flat[k] * [0.0, 0.0, 1.0][any.usize(0..3)] * sign(any);
    let boxes = times.iter().map(|&t| {
        let reach = DVec3::new(reach(0), reach(1), reach(2));
        around(&ray, t, reach)
    });
    let boxes = boxes.collect();
    Aimed { ray, boxes, times }
}

#[test]
fn no_ray_is_kept_out_of_a_box_that_it_grazes_to_the_bit() {
    let mut any = fastrand::Rng::with_seed(1);
    for _ in 0..3_000 {
        check(&few_bits(&mut any), 1.0);
    }
}

#[test]
fn no_ray_is_kept_out_of_a_box_that_it_meets_whatever_their_sizes() {
    let mut any = fastrand::Rng::with_seed(2);
    for _ in 0..3_000 {
        check(&all_sizes(&mut any), 1.0);
    }
}

#[test]
fn boxes_are_wide_enough_for_points_as_far_beside_them_as_shapes_may_say() {
    /// What shapes may be off by; see [`PADDING`].
    const OFF: f64 = 32.0 * math::UNIT_ROUNDOFF;
    let mut any = fastrand::Rng::with_seed(3);
    for round in 0..3_000 {
        let mut aimed = if round % 2 == 0 { few_bits(&mut any) } else { all_sizes(&mut any) };
        let rounding = [1.0, 1e3, 1e9][any.usize(0..3)];
        let largest = aimed.boxes.iter().map(Aabb::max_abs).fold(0.0, f64::max);
        let off = OFF * rounding * (max_abs(aimed.ray.origin) + largest);
        for aabb in &mut aimed.boxes {
            let way = DVec3::from_array([0; 3].map(|_| off * sign(&mut any)));
            *aabb = Aabb { min: aabb.min + way, max: aabb.max + way };
        }
        check(&aimed, rounding);
    }
}
