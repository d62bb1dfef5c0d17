//! Tori against answers known on paper, dense sampling and more digits.

use std::cmp::Ordering;

use tracer::glam::dvec3;

use super::*;
use crate::Random;
use crate::number::Big;

/// The signed distance of the ray's point at `t`, by definition.
fn distance<N: Number>(torus: &Torus, ray: &Ray, t: &N) -> N {
    let p = V3::<N>::difference(ray.origin, torus.center) + V3::of(ray.direction).scale(t);
    let n = V3::<N>::of(torus.axis);
    let height = p.dot(&n) / n.length();
    let across = p.cross(&n).length() / n.length();
    let out = across - N::of(torus.major_radius);
    (out.square() + height.square()).sqrt() - N::of(torus.minor_radius)
}

fn random_torus(random: &mut Random) -> Torus {
    let major_radius = random.between(0.5, 2.0);
    let minor_radius = major_radius * random.one_of(&[0.05, 0.3, 0.7, 0.99, 1.0]);
    let (center, axis) = (random.point(), random.direction() * 3.0);
    Torus { center, axis, major_radius, minor_radius }
}

fn random_ray(random: &mut Random, torus: &Torus) -> Ray {
    let target = torus.center + random.point() * (torus.major_radius * 0.8);
    let away = random.one_of(&[0.0, 1.0, 5.0]);
    // Often in the plane of the circle, where four hits are.
    let across = random.across(torus.axis);
    let way = if random.coin() { across } else { random.direction() };
    Ray::new(target - way * away, way * 0.7)
}

#[test]
fn as_found_by_looking_everywhere() {
    const STEPS: u32 = 2000;
    let mut random = Random::of_chunk(1, "torus", 0);
    let mut by_count = [0; 5];
    for _ in 0..200 {
        let torus = random_torus(&mut random);
        let ray = random_ray(&mut random, &torus);
        let truth = torus.hits(&ray);
        let mut found = Vec::new();
        let step = 20.0 / f64::from(STEPS);
        let sign = |t: f64| distance(&torus, &ray, &Dd::of(t)).sign();
        for k in 0..STEPS {
            let (from, to) = (f64::from(k) * step, f64::from(k + 1) * step);
            let below = sign(from);
            if below == sign(to) {
                continue;
            }
            let (mut lo, mut hi) = (Big::of(from), Big::of(to));
            for _ in 0..80 {
                let middle = (lo.clone() + hi.clone()) * Big::of(0.5);
                let here = distance(&torus, &ray, &middle).sign();
                if here == below { lo = middle } else { hi = middle }
            }
            found.push(lo.to_f64());
        }
        // A dip between two points of the grid is seen by the oracle alone.
        let close = truth.roots.windows(2).any(|pair| pair[1].0 - pair[0].0 < 2.0 * step);
        if close && found.len() < truth.roots.len() {
            continue;
        }
        assert_eq!(truth.roots.len(), found.len(), "{torus:?} {ray:?} {truth:?} {found:?}");
        assert!(!truth.tie);
        by_count[found.len()] += 1;
        for ((t, _), found) in truth.roots.iter().zip(found) {
            assert!((t - found).abs() < 1e-14 * (1.0 + t), "{torus:?} {ray:?} {t} {found}");
        }
    }
    assert!(by_count.iter().all(|&count| count > 0), "{by_count:?}");
}

#[test]
fn along_the_axes_by_hand() {
    let torus = Torus {
        center: dvec3(1.0, 0.0, 0.0),
        axis: DVec3::Z,
        major_radius: 4.0,
        minor_radius: 1.0,
    };
    let roots = |p: [f64; 3], d: [f64; 3]| -> Vec<f64> {
        let truth = torus.hits(&Ray::new(DVec3::from_array(p), DVec3::from_array(d)));
        assert!(!truth.tie);
        truth.roots.iter().map(|(hi, _)| *hi).collect()
    };
    assert_eq!(roots([-9.0, 0.0, 0.0], [2.0, 0.0, 0.0]), [2.5, 3.5, 6.5, 7.5]);
    assert_eq!(roots([1.0, 0.0, 0.0], [0.0, 0.5, 0.0]), [6.0, 10.0]);
    assert_eq!(roots([1.0, 4.0, 0.0], [0.0, 0.0, 1.0]), [1.0]);
    assert_eq!(roots([1.0, 0.0, 9.0], [0.0, 0.0, -1.0]), []);
    // The rate is the cosine to the normal over the major radius.
    let truth = torus.hits(&Ray::new(dvec3(-9.0, 0.0, 0.0), dvec3(2.0, 0.0, 0.0)));
    assert!((truth.rate - 0.5).abs() < 1e-15, "{}", truth.rate);
    // On top, exactly: too close to call.
    assert!(torus.hits(&Ray::new(dvec3(-9.0, 4.0, 1.0), DVec3::X)).tie);
    assert!(torus.hits(&Ray::new(dvec3(1.0, 4.0, 1.0), DVec3::Z)).tie);
}

#[test]
fn double_double_agrees_with_512_bits_in_every_family() {
    for family in crate::subject::all() {
        if family.primitive != "torus" || family.name == "special-values" {
            continue;
        }
        let mut random = Random::of_chunk(2, &family.label(), 0);
        for _ in 0..12 {
            let case = (family.generate)(&mut random);
            let torus = Torus {
                center: case.point(0),
                axis: case.point(3),
                major_radius: case.number(6),
                minor_radius: case.number(7),
            };
            let ray = case.ray(8);
            // Half the bits: a double root has no more.
            let (fast, exact) = (torus.hits(&ray), torus.hits_in::<Big>(&ray, 1e-60));
            assert_eq!(fast.tie, exact.tie, "{case:?}");
            if fast.tie {
                continue;
            }
            assert_eq!(fast.roots.len(), exact.roots.len(), "{case:?}");
            for (k, ((t, rest), (u, more))) in fast.roots.iter().zip(&exact.roots).enumerate() {
                let off = ((t - u) + (rest - more)).abs() * exact.rate.max(1e-9);
                // The first is measured to 1e-14, beyond the rounding of `t`.
                let allowed = if k == 0 { 1e-18 } else { 1e-12 } + u.abs() * exact.rate * 1e-26;
                assert!(off <= allowed, "{} {case:?}: {off:e}", family.label());
            }
        }
    }
}

#[test]
fn no_numbers_are_ties_and_far_lines_are_misses() {
    let torus = Torus { center: DVec3::ZERO, axis: DVec3::Z, major_radius: 1.0, minor_radius: 0.5 };
    let nan = torus.hits(&Ray::new(DVec3::NAN, DVec3::X));
    assert!(nan.tie && nan.roots.is_empty());
    let past = torus.hits(&Ray::new(dvec3(-1e6, 9.0, 0.0), DVec3::X));
    assert!(!past.tie && past.roots.is_empty());
    assert_eq!(Dd::of(0.0).sign(), Ordering::Equal);
}
