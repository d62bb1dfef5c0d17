//! Rounding outwards, over every kind of number.

use fastrand::Rng;
use glam::Vec4;

use super::super::bounds::Bounds;
use super::super::units::Units;
use super::{DVec3, holds};
use crate::Aabb;

/// Any finite number, and often one around which something changes.
fn number(rng: &mut Rng) -> f64 {
    let edges = [
        0.0,
        f64::MIN_POSITIVE,
        f64::from_bits(1),
        f64::MAX,
        f32::MAX.into(),
        f32::MIN_POSITIVE.into(),
        f32::from_bits(1).into(),
        1.0,
    ];
    let any = match rng.u8(0..4) {
        0 => rng.choice(edges).unwrap(),
        1 => rng.choice(edges).unwrap().next_down(),
        2 => rng.f64(),
        _ => f64::from_bits(rng.u64(..)),
    };
    let any = if any.is_finite() { any } else { 3.0 };
    if rng.bool() { -any } else { any }
}

#[test]
fn boxes_are_rounded_outwards_in_any_units() {
    let mut rng = Rng::with_seed(3);
    for case in 0..200_000 {
        let corners = [(); 2].map(|()| DVec3::from_array([(); 3].map(|()| number(&mut rng))));
        let inner = Aabb::around(corners);
        let units = if case % 2 == 0 { Units::of(1.0) } else { Units::of(inner.max_abs()) };
        let lane = |x: DVec3, round: fn(Units, f64) -> f32| {
            let [x, y, z] = x.to_array().map(|x| round(units, x));
            Vec4::new(x, y, z, 1.0)
        };
        let bounds =
            Bounds { lo: lane(inner.min, Units::below), hi: lane(inner.max, Units::above) };
        let outer = units.scene_box(bounds);
        assert!(holds(outer, inner), "{units:?}: {outer:?} does not hold {inner:?}");
        let signs = [outer.min, outer.max].concat().into_iter().filter(|x| *x == 0.0);
        assert!(signs.clone().all(f32::is_sign_positive), "{outer:?}");
    }
}

#[test]
fn rounding_goes_to_the_next_number_and_no_farther() {
    let units = Units::of(1.0);
    let mut rng = Rng::with_seed(4);
    for _ in 0..200_000 {
        let x = number(&mut rng);
        let (below, above) = (units.below(x), units.above(x));
        assert!(f64::from(below) <= x && x < f64::from(below.next_up()), "{x:e}");
        assert!(f64::from(above) >= x && x > f64::from(above.next_down()), "{x:e}");
    }
}
