//! Edge functions and `t` of blocks against exact arithmetic, and against the
//! formulas that have the last word.

use glam::dvec3;

use super::super::super::triangle::Shear;
use super::super::blocks::{LANES, NOBODY};
use super::super::precision::Accurate;
use super::*;
use crate::Interval;
use crate::exact::Exact;
use crate::simd::{Level, Work};

/// Of the doubt, how many roundings each side may take: those that look, and
/// those that decide.
const LOOK: f64 = 72.0;
const DECIDE: f64 = 48.0;

/// A look at four triangles.
struct Look<'a> {
    ray: &'a Ray,
    block: &'a Block<f64>,
    middle: DVec3,
    half: f64,
}

/// For each lane the edge functions, whether it is met, whether for sure, `t` and
/// where that is.
struct Looked {
    edges: [[f64; 4]; 3],
    met: u32,
    sure: u32,
    t: [f64; 4],
    lo: [f64; 4],
    hi: [f64; 4],
}

impl Work for Look<'_> {
    type Output = Looked;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Looked {
        let sighted = Sighted::<Accurate>::new(self.ray, self.middle, self.half);
        let sight = Sight::new(simd, &sighted);
        let (_, edges) = sight.edges(&self.block.corners);
        let edges = edges.map(Four::to_array);
        let seen = sight.look(self.block, (f64::NEG_INFINITY, f64::INFINITY));
        let [lo, hi] = seen.range();
        Looked { edges, met: seen.met, sure: seen.sure, t: seen.t(), lo, hi }
    }
}

/// The exact edge functions, times the square of the direction's longest
/// component, and `t` as a quotient.
struct Truth {
    edges: [Exact; 3],
    t: [Exact; 2],
}

fn truth(ray: &Ray, corners: [DVec3; 3]) -> Truth {
    let direction = ray.direction.to_array();
    let [kx, ky, kz] = Axis::from_longest(&direction);
    let [dx, dy, dz] = [kx, ky, kz].map(|k| Exact::of(*k.of(&direction)));
    let [a, b, c] = corners.map(|corner| {
        let (corner, origin) = (corner.to_array(), ray.origin.to_array());
        let seen = |k: Axis| &Exact::of(*k.of(&corner)) - &Exact::of(*k.of(&origin));
        let (x, y, z) = (seen(kx), seen(ky), seen(kz));
        [&(&x * &dz) - &(&dx * &z), &(&y * &dz) - &(&dy * &z), z]
    });
    let edge = |p: &[Exact; 3], q: &[Exact; 3]| &(&p[0] * &q[1]) - &(&p[1] * &q[0]);
    let edges @ [u, v, w] = &[edge(&c, &b), edge(&a, &c), edge(&b, &a)];
    let depths = &(&(u * &a[2]) + &(v * &b[2])) + &(w * &c[2]);
    let sum = &(u + v) + w;
    Truth { edges: edges.clone(), t: [depths, &sum * &dz] }
}

/// Needles, plump and tiny triangles, far from the origin or not, and a ray at
/// them, their edges or corners.
fn case(any: &mut fastrand::Rng) -> (Ray, [[DVec3; 3]; LANES]) {
    fn point(any: &mut fastrand::Rng) -> DVec3 {
        dvec3(any.f64(), any.f64(), any.f64()) * 2.0 - 1.0
    }
    let size = libm::exp2(f64::from(any.i32(-90..90)));
    let offset = point(any) * [0.0, 1.0, 1e3, 1e7][any.usize(0..4)];
    let triangles = [0; LANES].map(|_| {
        let (a, b) = (point(any), point(any));
        let width = libm::exp2(-55.0 * any.f64() * any.f64());
        let c = a + 2.0 * any.f64() * (b - a) + width * point(any);
        let small = [1.0, 1.0, 1e-4, 1e-9][any.usize(0..4)];
        [a, b, c].map(|p| (offset + small * p) * size)
    });
    let [a, b, c] = triangles[any.usize(0..LANES)];
    let share = any.f64() * [0.0, 1.0, 1.0][any.usize(0..3)];
    let target =
        a + share * (b - a) + any.f64() * (1.0 - share) * (c - a) * [0.0, 1.0][any.usize(0..2)];
    let far = [1.0, 3.0, 1e4][any.usize(0..3)];
    let origin = size * (offset + far * point(any));
    let mut direction = match any.u32(0..4) {
        // In the plane of one.
        0 if a != b => b - a + 1e-9 * (c - a),
        _ => target - origin,
    };
    direction *= libm::exp2(f64::from(any.i32(-200..200)));
    (Ray::new(origin, direction), triangles)
}

#[test]
fn edge_functions_and_t_are_within_their_bounds_and_those_are_not_far_away() {
    let mut any = fastrand::Rng::with_seed(5);
    let (mut look, mut decide, mut wrong, mut surely) = (0.0_f64, 0.0_f64, 0.0_f64, 0);
    for _ in 0..6_000 {
        let (ray, triangles) = case(&mut any);
        let mut block = Block { corners: [[[0.0; LANES]; 3]; 3], numbers: [NOBODY; LANES] };
        for (lane, corners) in triangles.iter().enumerate() {
            for (stored, corner) in block.corners.iter_mut().zip(corners) {
                for axis in 0..3 {
                    stored[axis][lane] = corner[axis];
                }
            }
        }
        let bounds = crate::Aabb::around(triangles.into_iter().flatten());
        let middle = bounds.center();
        let half = max_abs(bounds.max - middle).max(max_abs(middle - bounds.min));
        let farthest = max_abs(ray.origin - middle) + half;
        let longest = max_abs(ray.direction);
        let truths = triangles.map(|corners| truth(&ray, corners));
        let looks = Level::all()
            .into_iter()
            .map(|level| level.run(Look { ray: &ray, block: &block, middle, half }));
        let looks: Vec<_> = looks.collect();
        let shear = Shear::new(&ray);
        let (line, scale) = shear.line();
        for (lane, (&corners, truth)) in triangles.iter().zip(&truths).enumerate() {
            // In roundings of the square of the distance.
            let off = |edge: f64, truth: &Exact, unit: f64| {
                let unit = Exact::of(unit);
                let (got, unit) = (Exact::of(edge), &unit * &unit);
                let square = farthest * farthest * UNIT_ROUNDOFF;
                (&(&got * &unit) - truth).about().abs() / unit.about() / square
            };
            let edges = line.edges(shear.turned(corners));
            for (edge, truth) in [edges.u, edges.v, edges.w].into_iter().zip(&truth.edges) {
                decide =
                    decide.max(off(edge, truth, 1.0 / scale) / (longest * scale * longest * scale));
            }
            let contact = shear.decide(corners, Interval::new(f64::NEG_INFINITY, f64::INFINITY));
            for looked in &looks {
                for (edge, truth) in looked.edges.iter().zip(&truth.edges) {
                    look = look.max(off(edge[lane], truth, longest));
                }
                let [is_met, is_sure] = [looked.met, looked.sure].map(|bits| bits >> lane & 1 == 1);
                assert!(is_met || contact.is_none(), "{ray:?} {corners:?}");
                if !is_sure {
                    continue;
                }
                surely += 1;
                let [depths, sum] = &truth.t;
                let past = |t: f64| (depths - &(&Exact::of(t) * sum)).signum() * sum.signum();
                let (lo, hi) = (looked.lo[lane], looked.hi[lane]);
                assert!(past(lo) >= 0 && past(hi) <= 0, "{lo} {hi}: {ray:?} {corners:?}");
                let t = contact.map(|contact| contact.t);
                assert!(
                    t.is_some_and(|t| lo <= t && t <= hi),
                    "{lo} {hi} {t:?}: {ray:?} {corners:?}"
                );
                let off = depths - &(&Exact::of(looked.t[lane]) * sum);
                wrong = wrong.max((off.about() / sum.about()).abs() / (0.5 * (hi - lo)));
            }
        }
    }
    // Seen are 6, 6 and a 4,500th of the bounds: far less would say that nothing was
    // asked.
    assert!((LOOK / 24.0..LOOK).contains(&look), "{look}");
    assert!((DECIDE / 24.0..DECIDE).contains(&decide), "{decide}");
    assert!((1e-4..1.0).contains(&wrong), "{wrong}");
    assert!(surely > 2_000, "{surely}");
}
