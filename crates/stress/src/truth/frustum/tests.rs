//! Frusta against answers known on paper, dense sampling and more digits.

use tracer::glam::dvec3;

use super::*;
use crate::Random;
use crate::number::V3;
use crate::truth::cone::cone;
use crate::truth::cylinder::cylinder;

fn random_body(random: &mut Random, caps: bool) -> Frustum {
    let a = random.point() * 3.0;
    let b = a + random.direction() * random.between(0.5, 4.0);
    let radius = random.between(0.2, 2.0);
    if random.coin() { cylinder(a, b, radius, caps) } else { cone(a, b, radius, caps) }
}

fn random_ray(random: &mut Random, body: &Frustum) -> Ray {
    let target = body.a + (body.b - body.a) * random.between(-0.2, 1.2) + random.point() * 0.5;
    let distance = random.one_of(&[0.0, 0.3, 3.0, 20.0]);
    let way = random.direction();
    Ray::new(target - way * distance, way * 1.5)
}

/// Whether a point of the ray is in the body, by definition.
fn inside<N: Number>(body: &Frustum, ray: &Ray, t: &N) -> (bool, bool) {
    let p = V3::<N>::difference(ray.origin, body.a) + V3::of(ray.direction).scale(t);
    let w = V3::<N>::difference(body.b, body.a);
    let s = p.dot(&w) / w.length_squared();
    let across = p.length_squared() - s.square() * w.length_squared();
    let taper = N::difference(body.radius_b, body.radius_a);
    let radius = N::of(body.radius_a) + taper * s.clone();
    // One nappe only.
    let in_side = across <= radius.square() && radius >= N::zero();
    (in_side, s >= N::zero() && s <= N::one())
}

/// The first change from in to out or back on a fine grid, bisected.
fn brute_force(body: &Frustum, ray: &Ray) -> Option<f64> {
    const STEPS: u32 = 3000;
    let state = |t: &Big| {
        let (side, between) = inside(body, ray, t);
        // The open side is crossed where `in_side` changes between the ends.
        if body.caps { side && between } else { side }
    };
    let coarse = |t: f64| {
        let (side, between) = inside(body, ray, &Dd::of(t));
        if body.caps { side && between } else { side }
    };
    let step = 30.0 / f64::from(STEPS);
    let mut last = coarse(0.0);
    for k in 1..=STEPS {
        let (from, to) = (f64::from(k - 1) * step, f64::from(k) * step);
        if coarse(to) == last {
            continue;
        }
        let (mut lo, mut hi) = (Big::of(from), Big::of(to));
        for _ in 0..120 {
            let middle = (lo.clone() + hi.clone()) * Big::of(0.5);
            if state(&middle) == last { lo = middle } else { hi = middle }
        }
        let (_, between) = inside(body, ray, &lo);
        if body.caps || between {
            return Some(lo.to_f64());
        }
        last = !last;
    }
    None
}

#[test]
fn as_found_by_looking_everywhere() {
    let mut random = Random::of_chunk(1, "frustum", 0);
    let (mut hits, mut misses) = (0, 0);
    for k in 0..400 {
        let body = random_body(&mut random, k % 2 == 0);
        let ray = random_ray(&mut random, &body);
        let truth = body.first_hit(&ray).truth;
        let found = brute_force(&body, &ray);
        assert!(!truth.tie, "{body:?} {ray:?}");
        match (truth.t, found) {
            (Some((t, _)), Some(found)) => {
                assert!((t - found).abs() < 1e-14 * (1.0 + t), "{body:?} {ray:?}: {t} {found}");
                hits += 1;
            }
            (None, None) => misses += 1,
            // A chord shorter than the grid.
            (Some((t, _)), None)
                if body
                    .first_hit(&Ray::new(ray.at(t), ray.direction))
                    .truth
                    .t
                    .is_none_or(|(chord, _)| chord < 0.02) => {}
            other => panic!("{body:?} {ray:?}: {other:?}"),
        }
    }
    assert!(hits > 100 && misses > 50, "{hits} {misses}");
}

#[test]
fn a_cylinder_and_a_cone_by_hand() {
    let (a, b) = (DVec3::ZERO, dvec3(0.0, 0.0, 4.0));
    let check = |body: Frustum, p: [f64; 3], d: [f64; 3], t: Option<f64>, part: Option<u32>| {
        let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
        let hit = body.first_hit(&ray);
        assert!(!hit.truth.tie, "{ray:?}");
        assert_eq!((hit.truth.t.map(|(hi, _)| hi), hit.part), (t, part), "{body:?} {ray:?}");
    };
    let (solid, tube) = (cylinder(a, b, 2.0, true), cylinder(a, b, 2.0, false));
    check(solid, [5.0, 0.0, 1.0], [-1.0, 0.0, 0.0], Some(3.0), Some(0));
    check(solid, [0.0, 1.0, 7.0], [0.0, 0.0, -2.0], Some(1.5), Some(2));
    check(solid, [0.0, 1.0, -7.0], [0.0, 0.0, 1.0], Some(7.0), Some(1));
    check(solid, [0.0, 1.0, 3.0], [0.0, 0.0, 1.0], Some(1.0), Some(2));
    check(solid, [3.0, 0.0, 7.0], [0.0, 0.0, -1.0], None, None);
    check(tube, [0.0, 1.0, 7.0], [0.0, 0.0, -2.0], None, None);
    check(tube, [3.0, 0.0, -2.0], [-1.0, 0.0, 1.0], Some(5.0), Some(0));
    let (solid, funnel) = (cone(a, b, 2.0, true), cone(a, b, 2.0, false));
    check(solid, [5.0, 0.0, 2.0], [-1.0, 0.0, 0.0], Some(4.0), Some(0));
    check(solid, [0.5, 0.0, 9.0], [0.0, 0.0, -1.0], Some(5.0), Some(2));
    check(funnel, [0.5, 0.0, 9.0], [0.0, 0.0, -1.0], Some(8.0), Some(0));
    // The other nappe is no part of it.
    check(solid, [5.0, 0.0, -2.0], [-1.0, 0.0, 0.0], None, None);
    check(solid, [0.0, 0.0, -3.0], [0.0, 0.0, 1.0], Some(3.0), Some(0));
}

#[test]
fn double_double_agrees_with_512_bits_in_every_family() {
    for family in crate::subject::all() {
        if !["cylinder", "cone"].contains(&family.primitive) || family.name == "special-values" {
            continue;
        }
        let mut random = Random::of_chunk(2, &family.label(), 0);
        for _ in 0..60 {
            let case = (family.generate)(&mut random);
            let make = if family.primitive == "cone" { cone } else { cylinder };
            let body = make(case.point(0), case.point(3), case.number(6), case.number(7) > 0.0);
            let ray = case.ray(8);
            let exact = body.first_hit_in::<Big>(&ray).unwrap();
            let fast = body.first_hit(&ray);
            assert_eq!((fast.truth.tie, fast.part), (exact.truth.tie, exact.part), "{case:?}");
            assert_eq!(fast.truth.t.is_some(), exact.truth.t.is_some(), "{case:?}");
            if let (Some((t, rest)), Some((u, more))) = (fast.truth.t, exact.truth.t) {
                let off = ((t - u) + (rest - more)).abs();
                // Far below the 2^-53 that a kernel is measured by.
                let allowed = libm::ldexp(exact.truth.condition.max(u.abs()), -70);
                assert!(off <= allowed, "{} {case:?}: {off:e}", family.label());
            }
        }
    }
}

#[test]
fn the_condition_is_what_small_changes_do() {
    let mut random = Random::of_chunk(3, "condition", 0);
    let (mut most, mut hits) = (0.0_f64, 0);
    while hits < 300 {
        let caps = random.coin();
        let body = random_body(&mut random, caps);
        let ray = random_ray(&mut random, &body);
        let truth = body.first_hit(&ray);
        let (Some((t, rest)), Some(part)) = (truth.truth.t, truth.part) else { continue };
        for _ in 0..20 {
            // So small that the second order is far below the first.
            let small = libm::ldexp(1.0, -40);
            let mut moved = |v: DVec3| v + random.direction() * (v.length() * small);
            let near = Frustum { a: moved(body.a), b: moved(body.b), ..body };
            let near_ray = Ray::new(moved(ray.origin), moved(ray.direction));
            let scale = 1.0 + random.sign() * small;
            let near = Frustum {
                radius_a: body.radius_a * scale,
                radius_b: body.radius_b * scale,
                ..near
            };
            let Some(found) = near.first_hit_in::<Dd>(&near_ray) else { continue };
            let Some((u, more)) = found.truth.t.filter(|_| found.part == Some(part)) else {
                continue;
            };
            most = most.max(((u - t) + (more - rest)).abs() / (small * truth.truth.condition));
        }
        hits += 1;
    }
    assert!((0.5..1.01).contains(&most), "{most}");
}
