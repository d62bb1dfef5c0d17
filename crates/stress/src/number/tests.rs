//! Tests: exactness, the published bounds of every operation, cancellation,
//! and what lies at and beyond the edges of `f64`.

use super::*;
use tracer::glam::DVec3;

/// `2^-106`: the square of the unit roundoff, in which errors are counted.
const U2: f64 = f64::EPSILON * f64::EPSILON / 4.0;

/// Random expressions compared per test.
const RECORDS: u32 = 100_000;

/// `2^k`, for a normal number.
fn power_of_two(k: i64) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

/// A number of either sign with 53 random bits and an exponent within
/// `+- exponent`.
fn random(rng: &mut fastrand::Rng, exponent: i64) -> f64 {
    let magnitude = (1.0 + rng.f64()) * power_of_two(rng.i64(-exponent..=exponent));
    if rng.bool() { magnitude } else { -magnitude }
}

fn random_dd(rng: &mut fastrand::Rng, exponent: i64) -> Dd {
    let hi = random(rng, exponent);
    Dd::sum(hi, hi * (f64::EPSILON / 2.0) * (rng.f64() - 0.5))
}

/// `|x - exact|` as an `f64`.
fn error(x: Dd, exact: &Big) -> f64 {
    (Big::from(x) - exact.clone()).abs().to_f64()
}

/// `|x - exact| / |exact|` in units of `u^2`.
fn relative(x: Dd, exact: &Big) -> f64 {
    if exact.sign() == Ordering::Equal {
        return if x.sign() == Ordering::Equal { 0.0 } else { f64::INFINITY };
    }
    ((Big::from(x) - exact.clone()).abs() / exact.clone().abs()).to_f64() / U2
}

#[test]
fn conversion_is_exact_both_ways() {
    let mut rng = fastrand::Rng::with_seed(1);
    let edges = [0.0, -0.0, f64::MAX, f64::MIN, f64::MIN_POSITIVE, f64::from_bits(1), 0.1];
    let any = std::iter::repeat_with(|| f64::from_bits(rng.u64(..))).take(20_000);
    for x in edges.into_iter().chain(any).filter(|x| x.is_finite()) {
        assert_eq!(Dd::of(x).to_f64(), x);
        assert_eq!(Big::of(x).to_f64(), x);
        assert_eq!(Dd::of(x).sign(), x.partial_cmp(&0.0).unwrap());
        assert_eq!(Big::of(x).sign(), x.partial_cmp(&0.0).unwrap());
        assert_eq!(Big::of(-x), -Big::of(x));
    }
}

#[test]
fn sums_and_products_of_doubles_are_exact() {
    let mut rng = fastrand::Rng::with_seed(2);
    for _ in 0..RECORDS {
        let (a, b) = (random(&mut rng, 150), random(&mut rng, 150));
        assert_eq!(Big::from(Dd::sum(a, b)), Big::of(a) + Big::of(b));
        assert_eq!(Big::from(Dd::difference(a, b)), Big::difference(a, b));
        assert_eq!(Big::from(Dd::product(a, b)), Big::of(a) * Big::of(b));
        assert_eq!(Dd::of(a) + Dd::of(b), Dd::sum(a, b));
        assert_eq!(Dd::of(a) * Dd::of(b), Dd::product(a, b));
        assert_eq!(Dd::of(a).square(), Dd::product(a, a));
    }
}

#[test]
fn every_operation_keeps_its_published_bound() {
    let mut rng = fastrand::Rng::with_seed(3);
    let mut worst = [0.0_f64; 5];
    for k in 0..RECORDS {
        // Every second pair nearly cancels.
        let a = random_dd(&mut rng, 60);
        let b = if k % 2 == 0 {
            random_dd(&mut rng, 60)
        } else {
            -a * Dd::sum(1.0, random(&mut rng, 50) * power_of_two(-53))
        };
        let (x, y) = (Big::from(a), Big::from(b));
        let errors = [
            relative(a + b, &(x.clone() + y.clone())),
            relative(a - b, &(x.clone() - y.clone())),
            relative(a * b, &(x.clone() * y.clone())),
            relative(a / b, &(x.clone() / y)),
            relative(a.abs().sqrt(), &x.abs().sqrt()),
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error);
        }
    }
    for (worst, bound) in worst.into_iter().zip([3.000_001, 3.000_001, 5.0, 15.000_001, 3.125]) {
        assert!(worst <= bound, "{worst} u^2 above {bound} u^2");
    }
}

#[test]
fn identities_hold() {
    let mut rng = fastrand::Rng::with_seed(4);
    for _ in 0..RECORDS {
        let (a, b) = (random_dd(&mut rng, 60), random_dd(&mut rng, 60));
        assert_eq!(a + b, b + a);
        assert_eq!(a * b, b * a);
        assert_eq!(a - a, Dd::zero());
        assert_eq!(a / a, Dd::one());
        assert_eq!(a * Dd::one(), a);
        assert_eq!(a / Dd::one(), a);
        assert_eq!(a + Dd::zero(), a);
        assert_eq!(-(-a), a);
        assert_eq!((a - b).sign(), a.partial_cmp(&b).unwrap());
        assert_eq!(a.max(b) + a.min(b), a + b);
        assert_eq!(a.square(), a * a);
        let x = random(&mut rng, 60);
        assert_eq!(Dd::of(x).square().sqrt(), Dd::of(x.abs()));
        assert_eq!(Big::of(x).square().sqrt(), Big::of(x.abs()));
        // The parts stay the nearest double and its rest.
        for y in [a + b, a * b, a / b, a.abs().sqrt()] {
            assert_eq!(y.hi() + y.lo(), y.hi());
        }
    }
}

/// The value of an expression that cancels, and the magnitude its operations
/// may leave an error in proportion to.
fn cancelling<N: Number>(kind: u32, [a, b, c, d]: [f64; 4]) -> (N, N) {
    let [x, y, z, w] = [a, b, c, d].map(N::of);
    match kind {
        // Exact products: only the difference is rounded, so no condition.
        0 => {
            let value = x * y - z * w;
            (value.clone(), value.abs())
        }
        1 => {
            let length = (x.square() + y.square()).sqrt();
            (length.clone() - x.clone(), length + x.abs())
        }
        2 => {
            let value = (x.clone() + y) - x;
            (value.clone(), value.abs())
        }
        3 => {
            let there_and_back = x.clone() / y.clone() / z.clone() / w.clone() * w * z * y;
            (there_and_back - x.clone(), x.abs())
        }
        4 => {
            let (b2, ac) = (x.square(), y * (z.square() - w.square()));
            let size = b2.clone() + ac.clone().abs();
            (b2 - ac, size)
        }
        _ => {
            let (sum, difference) = (x.clone() + y.clone(), x.clone() - y.clone());
            let size = x.square() + y.square();
            (sum * difference - (x.square() - y.square()), size)
        }
    }
}

#[test]
fn what_cancels_agrees_with_512_bits() {
    let mut rng = fastrand::Rng::with_seed(5);
    let mut worst = [0.0_f64; 6];
    for k in 0..RECORDS {
        let kind = k % 6;
        let near =
            |x: f64, rng: &mut fastrand::Rng| x * (1.0 + random(rng, 52) * power_of_two(-53));
        let (a, b) = (random(&mut rng, 20), random(&mut rng, 20));
        let inputs = match kind {
            0 => [a, b, near(a, &mut rng), near(b, &mut rng)],
            1 => [a.abs(), a * 1e-6 * rng.f64(), 0.0, 0.0],
            4 => {
                // A sphere met near its rim: b^2 is about a (f^2 - r^2).
                let (f, r) = (a.abs() + b.abs(), b.abs());
                let length = (f * f - r * r).sqrt();
                [near(length, &mut rng), 1.0, f, r]
            }
            _ => [a, b, random(&mut rng, 20), random(&mut rng, 20)],
        };
        let (fast, _) = cancelling::<Dd>(kind, inputs);
        let (exact, size) = cancelling::<Big>(kind, inputs);
        let error = error(fast, &exact) / (size.to_f64() * U2);
        // 0/0 where nothing is left to be wrong about.
        if size.sign() == Ordering::Equal {
            assert_eq!(fast, Dd::zero());
            continue;
        }
        worst[kind as usize] = worst[kind as usize].max(error);
    }
    // Six divisions and products of at most 15 and 5 u^2 are the longest chain.
    for (worst, bound) in worst.into_iter().zip([3.1, 9.0, 3.1, 61.0, 12.0, 24.0]) {
        assert!(worst <= bound, "{worst} u^2 above {bound} u^2");
        assert!(worst * U2 <= 1e-30);
    }
}

#[test]
fn random_programs_stay_within_their_running_error() {
    const STEPS: usize = 12;
    let mut rng = fastrand::Rng::with_seed(6);
    let mut worst = 0.0_f64;
    for _ in 0..20_000 {
        // Value in both numbers, and a bound of the first one's error.
        let mut line: Vec<(Dd, Big, f64)> =
            (0..4).map(|_| random(&mut rng, 8)).map(|x| (Dd::of(x), Big::of(x), 0.0)).collect();
        for _ in 0..STEPS {
            let (a, x, ea) = line[rng.usize(..line.len())].clone();
            let (b, y, eb) = line[rng.usize(..line.len())].clone();
            let (am, bm) = (a.to_f64().abs(), b.to_f64().abs());
            let next = match rng.u32(0..5) {
                0 => (a + b, x + y, ea + eb + 3.1 * U2 * (a + b).to_f64().abs()),
                1 => (a - b, x - y, ea + eb + 3.1 * U2 * (a - b).to_f64().abs()),
                2 => (a * b, x * y, am * eb + bm * ea + 2.0 * ea * eb + 5.1 * U2 * am * bm),
                3 if bm > 1e6 * eb => {
                    let q = am / bm;
                    (a / b, x / y, (ea + q * eb) / bm * (1.0 + 1e-5) + 15.1 * U2 * q)
                }
                4 if am > 1e6 * ea => {
                    let root = am.sqrt();
                    (a.abs().sqrt(), x.abs().sqrt(), ea / root + 3.2 * U2 * root)
                }
                _ => continue,
            };
            // Stay where the bounds hold: far from the ends of the exponent.
            if (1e-60..1e60).contains(&next.0.to_f64().abs()) {
                line.push(next);
            }
        }
        for (a, x, bound) in line.into_iter().filter(|l| l.2 > 0.0) {
            worst = worst.max(error(a, &x) / bound);
        }
    }
    assert!(worst <= 1.0, "{worst}");
}

#[test]
fn the_arbiter_rounds_once_to_512_bits() {
    let two = Big::of(2.0);
    let unit = Big::of(power_of_two(-512));
    // 1 + 2^-512 is a tie to even; 1 + 3 2^-512 the tie that goes up.
    assert_eq!(Big::one() + unit.clone(), Big::one());
    assert_eq!(Big::one() + unit.clone() + Big::zero(), Big::one() - unit.clone() * Big::zero(),);
    assert!(Big::one() + two.clone() * unit.clone() > Big::one());
    assert!(Big::one() - unit.clone() < Big::one());
    let root = two.clone().sqrt();
    assert!((root.square() - two.clone()).abs() <= Big::of(4.0) * unit.clone());
    let third = Big::one() / Big::of(3.0);
    assert!((third * Big::of(3.0) - Big::one()).abs() <= unit);
}

#[test]
fn zero_tiny_and_huge() {
    assert_eq!(Dd::zero().sqrt(), Dd::zero());
    assert_eq!(Big::zero().sqrt(), Big::zero());
    assert_eq!(Big::of(-0.0), Big::zero());
    assert_eq!((-Big::zero()).sqrt().sign(), Ordering::Equal);
    let tiny = f64::from_bits(1);
    assert_eq!(Dd::of(tiny).sign(), Ordering::Greater);
    assert_eq!((-Big::of(tiny)).sign(), Ordering::Less);
    // The sign of a sum survives where its first part cancels.
    assert_eq!((Dd::sum(1.0, -1e-300) - Dd::one()).sign(), Ordering::Less);
    assert_eq!((Dd::sum(1.0, tiny) - Dd::one()).sign(), Ordering::Greater);
    // Underflow: the fast number forgets, the arbiter does not.
    assert_eq!(Dd::of(tiny).square().sign(), Ordering::Equal);
    assert_eq!(Big::of(tiny).square().sign(), Ordering::Greater);
    assert_eq!(Big::of(tiny).square().to_f64(), 0.0);
    assert_eq!(Big::of(tiny).square().sqrt(), Big::of(tiny));
    // Below 2^-968 a product keeps its first part only.
    let small = (1.0 + f64::EPSILON) * power_of_two(-510);
    assert!(error(Dd::product(small, small), &Big::of(small).square()) <= tiny);
    // Overflow: likewise.
    let huge = f64::MAX;
    assert!(!Dd::of(huge).square().is_finite() && !(Dd::of(huge) + Dd::of(huge)).is_finite());
    assert!(Big::of(huge).square().is_finite());
    assert_eq!(Big::of(huge).square().sqrt(), Big::of(huge));
    assert_eq!(Big::of(huge).square().to_f64(), f64::INFINITY);
}

#[test]
fn what_is_no_number_is_never_accepted() {
    fn check<N: Number>() {
        let made = [
            N::of(f64::NAN),
            N::of(f64::INFINITY) * N::one(),
            N::of(f64::NEG_INFINITY) + N::one(),
            N::one() / N::zero(),
            N::zero() / N::zero(),
            N::of(-1.0).sqrt(),
            N::one() / (N::one() / N::zero()),
        ];
        for x in made {
            assert!(!x.is_finite(), "{x:?}");
            assert_eq!(x.sign(), Ordering::Less, "{x:?}");
            assert!(!(x >= N::zero()) && !(x <= N::zero()) && x != x.clone(), "{x:?}");
            assert!(x.to_f64().is_nan());
            for y in [x.clone() + N::one(), -x.clone(), N::zero() * x.clone(), x.square()] {
                assert!(!y.is_finite(), "{x:?} to {y:?}");
            }
            assert!(!x.clone().sqrt().is_finite() && !x.abs().is_finite());
        }
        assert!(!N::of(f64::INFINITY).is_finite());
    }
    check::<Dd>();
    check::<Big>();
}

#[test]
fn vectors_follow_their_algebra() {
    fn check<N: Number>() {
        let mut rng = fastrand::Rng::with_seed(7);
        for _ in 0..1_000 {
            let [a, b] = [0, 1].map(|_| DVec3::from_array([0; 3].map(|_| random(&mut rng, 10))));
            let (u, v) = (V3::<N>::of(a), V3::<N>::of(b));
            assert_eq!(u.to_f64(), a);
            assert_eq!(V3::<N>::difference(a, b), u.clone() - v.clone());
            assert_eq!(u.dot(&v), v.dot(&u));
            assert_eq!(u.dot(&u), u.length_squared());
            assert_eq!(u.cross(&v), -v.cross(&u));
            assert_eq!(u.cross(&u), V3::of(DVec3::ZERO));
            assert_eq!(u.clone() + v.clone() - v.clone(), u);
            assert_eq!(u.scale(&N::of(2.0)), u.clone() + u.clone());
            // Across both, to a few units of the lesser precision.
            let rest = u.cross(&v).dot(&u).abs();
            assert!(rest <= N::of(32.0 * U2) * u.length_squared() * v.length());
        }
        assert_eq!(V3::<N>::of(DVec3::new(2.0, 3.0, 6.0)).length(), N::of(7.0));
    }
    check::<Dd>();
    check::<Big>();
}

#[test]
fn the_two_numbers_agree_on_spheres() {
    let agreement = agreement::validate(60_000, 1);
    assert_eq!(agreement.records, 60_000);
    assert!(agreement.hits > 20_000, "{agreement:?}");
    assert_eq!(agreement.sign_disagreements, 0, "{agreement:?}");
    assert!(agreement.max_conditioned_difference <= 1e-30, "{agreement:?}");
    assert_eq!(agreement, agreement::validate(60_000, 1));
}

#[test]
fn a_disagreement_is_counted() {
    // 1e200^4 is beyond the fast number.
    let far = DVec3::X * 1e200;
    let record = RaySphere { origin: -far, direction: far, center: DVec3::ZERO, radius: 1.0 };
    assert_eq!(agreement::compare([record]).sign_disagreements, 1);
}
