//! Reflection and refraction against numbers of 60 digits, and what must hold
//! for every direction.

use glam::dvec3;

use super::*;

/// The direction that comes down on `z = 0` at this cosine with its normal.
fn down(cosine: f64) -> DVec3 {
    dvec3(((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, -cosine)
}

/// Beyond an index of `ior`: the sine and cosine of the refracted ray, and the
/// share that is reflected; `None` is all.
#[track_caller]
fn check(ior: f64, cosine: f64, expected: Option<[f64; 3]>) {
    let close = |found: f64, expected: f64| {
        assert!((found - expected).abs() <= 1e-15 * expected.abs().max(0.01), "{found} {expected}");
    };
    let found = refract(down(cosine), UnitVec::Z, ior);
    assert_eq!(found.is_some(), expected.is_some(), "{ior} {cosine}");
    if let (Some(found), Some([sine, cos_t, share])) = (found, expected) {
        close(found.cosine, cos_t);
        close(found.direction.x, sine);
        close(-found.direction.z, cos_t);
        close(fresnel(ior, cosine, found.cosine), share);
    }
}

/// Made with 60 decimal digits by way of the sines, which the formulas do not use.
#[test]
#[rustfmt::skip]
fn snells_law_and_fresnels_equations() {
    // Beyond the critical angle, at it, and along the surface.
    check(0.75, 0.5, None);
    check(0.75, 0.125, None);
    check(0.5, 0.0, None);
    check(1.0, 0.0, None);
    check(1.5, 1.0, Some([0.0, 1.0, 0.04]));
    check(1.5, 0.875, Some([0.322_748_612_183_951_4, 0.946_484_724_300_045_6, 0.041_301_410_973_430_5]));
    check(1.5, 0.125, Some([0.661_437_827_766_147_6, 0.75, 0.5]));
    check(1.5, 0.000_976_562_5, Some([0.666_666_348_775_152_1, 0.745_356_276_830_622_3, 0.994_340_937_665_372_3]));
    check(1.5, 1e-9, Some([0.666_666_666_666_666_6, 0.745_355_992_499_929_9, 0.999_999_994_186_223_3]));
    check(1.33, 0.5, Some([0.651_146_920_138_675_6, 0.758_951_703_597_743_5, 0.059_125_599_247_392_31]));
    check(2.42, 0.125, Some([0.409_982_124_648_438_64, 0.912_093_557_409_957_9, 0.524_500_458_242_600_8]));
    check(100.0, 0.5, Some([0.008_660_254_037_844_386, 0.999_962_499_296_848_6, 0.951_653_521_357_109_3]));
    check(0.75, 0.875, Some([0.645_497_224_367_902_8, 0.763_762_615_825_973_3, 0.024_646_567_869_360_143]));
    check(0.5, 0.875, Some([0.968_245_836_551_854_2, 0.25, 0.318_440_082_644_628_1]));
    // Nearly the same on both sides: the reflection is tiny, and as right.
    let (cos_t, share) = (0.875_000_026_785_709_9, 2.734_277_052_989_376e-15);
    let found = refract(down(0.875), UnitVec::Z, 1.000_000_1).unwrap();
    assert!((found.cosine - cos_t).abs() < 1e-15);
    assert!((fresnel(1.000_000_1, 0.875, found.cosine) - share).abs() < 1e-21);
}

#[test]
fn schlick_is_r0_straight_on_and_all_along_the_surface() {
    for r0 in [0.0, 0.04, 0.5, 1.0] {
        assert_eq!((schlick(r0, 1.0), schlick(r0, 0.0)), (r0, 1.0));
    }
    assert_eq!(schlick(0.0, 0.5), 1.0 / 32.0);
    let thirds = [1.0, 3.0, 1.0 / 3.0].map(straight_on);
    assert_eq!((thirds[0], thirds[1]), (0.0, 0.25));
    assert!((thirds[2] - 0.25).abs() < 1e-15);
    assert_eq!(fresnel(3.0, 1.0, 1.0), 0.25);
}

/// 2000 random meetings: a direction, and a normal on the side that it comes from.
fn meetings() -> impl Iterator<Item = (DVec3, UnitVec, f64)> {
    let mut any = fastrand::Rng::with_seed(7);
    std::iter::repeat_with(move || {
        let mut unit = || {
            let mut number = || 2.0 * any.f64() - 1.0;
            UnitVec::new(dvec3(number(), number(), number())).unwrap_or(UnitVec::Z)
        };
        let (d, n) = (unit(), unit());
        let n = if n.dot(*d) < 0.0 { n } else { -n };
        (*d, n, [0.4, 0.7, 1.0, 1.2, 1.5, 2.4][any.usize(0..6)])
    })
    .take(2000)
}

#[test]
fn reflecting_twice_changes_nothing() {
    for (d, n, _) in meetings() {
        let r = reflect(d, n);
        assert!((r.length() - 1.0).abs() < 1e-15 && (n.dot(r) + n.dot(d)).abs() < 1e-15);
        assert!((reflect(r, n) - d).length() < 2e-15, "{d} {n:?}");
    }
}

#[test]
fn light_goes_back_the_way_it_came_and_none_is_lost() {
    let mut total = 0;
    for (d, n, ior) in meetings() {
        let Some(there) = refract(d, n, ior) else {
            // Whichever is the denser side has a critical angle.
            assert!(ior < 1.0);
            total += 1;
            continue;
        };
        let t = there.direction;
        // A unit vector in the plane of d and n, on the far side.
        assert!((t.length() - 1.0).abs() < 4e-15 && n.dot(t) < 0.0);
        assert!(t.dot(n.cross(d)).abs() < 1e-15);
        assert!((n.cross(t).length() * ior - n.cross(d).length()).abs() < 1e-14);
        // From behind, through the inverse index; near the critical angle the
        // way back magnifies roundings by the quotient of the cosines.
        let cos_i = -n.dot(d);
        let back = refract(-t, -n, 1.0 / ior).unwrap();
        assert!((back.direction + d).length() * cos_i.min(there.cosine) < 1e-14, "{d} {n:?} {ior}");
        let shares = [fresnel(ior, cos_i, there.cosine), fresnel(1.0 / ior, there.cosine, cos_i)];
        assert!((shares[0] - shares[1]).abs() < 1e-13, "{shares:?}");
        assert!((0.0..=1.0).contains(&shares[0]));
        // What is transmitted, by its own formulas: R + T = 1.
        let (a, b) = (cos_i, ior * there.cosine);
        let (c, e) = (ior * cos_i, there.cosine);
        let through = 0.5 * (4.0 * a * b / ((a + b) * (a + b)) + 4.0 * c * e / ((c + e) * (c + e)));
        assert!((shares[0] + through - 1.0).abs() < 1e-14);
    }
    assert!(total > 100, "{total}");
}

#[test]
fn an_index_of_1_changes_no_bit() {
    for (d, n, _) in meetings() {
        let there = refract(d, n, 1.0).unwrap();
        assert_eq!((there.direction, there.cosine), (d, -n.dot(d)));
        assert_eq!(fresnel(1.0, -n.dot(d), there.cosine), 0.0);
    }
}
