//! Tests: answers known by hand, that both numbers tell the same, and that the
//! condition is how far `t` moves.

use std::collections::BTreeMap;

use super::*;
use crate::number::{Big, Dd};
use crate::random::Random;
use crate::{Case, subject};

/// A formula by either number.
type Formula = fn(&Case) -> Truth;

/// Of each primitive: the exact answer in volume, and by the arbiter alone.
fn formulas() -> BTreeMap<&'static str, (Formula, Formula)> {
    let all: [(&str, (Formula, Formula)); 4] = [
        ("sphere", (|c| sphere::first_hit::<Dd>(c).0, |c| sphere::first_hit::<Big>(c).0)),
        (
            "triangle",
            (|c| triangle::first_hit::<Dd>(c, false).0, |c| triangle::first_hit::<Big>(c, false).0),
        ),
        ("plane", (|c| plane::first_hit::<Dd>(c).0, |c| plane::first_hit::<Big>(c).0)),
        ("disk", (|c| disk::first_hit::<Dd>(c).0, |c| disk::first_hit::<Big>(c).0)),
    ];
    all.into_iter().collect()
}

#[track_caller]
fn check(formula: Formula, numbers: &[f64], expected: Option<f64>) {
    let truth = formula(&Case::of(numbers).unwrap());
    assert!(!truth.tie, "a tie");
    assert_eq!(truth.t, expected.map(|t| (t, 0.0)));
}

#[test]
fn answers_known_by_hand() {
    let of_ray = |shape: &[f64], ray: [f64; 6]| [shape, &ray].concat();
    let ball = |ray| of_ray(&[1.0, 0.0, 0.0, 2.0], ray);
    check(super::sphere, &ball([1.0, 0.0, 5.0, 0.0, 0.0, -0.5]), Some(6.0));
    check(super::sphere, &ball([1.0, 0.0, 0.0, 0.0, 0.0, -0.5]), Some(4.0));
    check(super::sphere, &ball([1.0, 0.0, -5.0, 0.0, 0.0, -0.5]), None);
    check(super::sphere, &ball([4.0, 0.0, 5.0, 0.0, 0.0, -0.5]), None);
    let corners = |ray| of_ray(&[0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 4.0, 0.0], ray);
    check(super::triangle, &corners([1.0, 1.0, 8.0, 0.0, 0.0, -2.0]), Some(4.0));
    check(super::triangle, &corners([3.0, 3.0, 8.0, 0.0, 0.0, -2.0]), None);
    check(triangle_on_lattice, &corners([2.0, 2.0, 8.0, 0.0, 0.0, -2.0]), Some(4.0));
    check(triangle_on_lattice, &corners([4.0, 0.0, 8.0, 0.0, 0.0, -2.0]), Some(4.0));
    check(triangle_on_lattice, &corners([4.0, 1.0, 8.0, 0.0, 0.0, -2.0]), None);
    check(triangle_on_lattice, &corners([1.0, 1.0, 0.0, 1.0, 0.0, 0.0]), None);
    let cube = |ray| of_ray(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], ray);
    check(super::axis_box, &cube([-1.0, -1.0, -1.0, 0.5, 0.5, 0.5]), Some(2.0));
    check(super::axis_box, &cube([-1.0, 1.0, 0.0, 1.0, -0.0, 0.0]), Some(1.0));
    check(super::axis_box, &cube([0.5, 0.5, 0.5, 1.0, 0.0, 0.0]), Some(0.5));
    // Through the corner at (1, 1) only, and beside it.
    check(super::axis_box, &cube([0.0, 2.0, 0.5, 1.0, -1.0, 0.0]), Some(1.0));
    check(super::axis_box, &cube([0.0, 2.25, 0.5, 1.0, -1.0, 0.0]), None);
    let level = |ray| of_ray(&[5.0, 1.0, 0.0, 0.0, 3.0, 0.0], ray);
    check(super::plane, &level([0.0, 3.0, 0.0, 7.0, -0.5, 0.0]), Some(4.0));
    check(super::plane, &level([0.0, 3.0, 0.0, 7.0, 0.5, 0.0]), None);
    let round = |ray| of_ray(&[5.0, 1.0, 0.0, 0.0, 3.0, 0.0, 2.0], ray);
    check(super::disk, &round([6.5, 3.0, 0.0, 0.0, -0.5, 0.0]), Some(4.0));
    check(super::disk, &round([7.5, 3.0, 0.0, 0.0, -0.5, 0.0]), None);
}

#[test]
fn exactly_tangent_and_on_an_edge_are_ties() {
    let tangent = [0.0, 0.0, 0.0, 2.0, 2.0, 0.0, 5.0, 0.0, 0.0, -1.0];
    assert!(super::sphere(&Case::of(&tangent).unwrap()).tie);
    let mut edge = vec![0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 4.0, 0.0];
    edge.extend([2.0, 2.0, 8.0, 0.0, 0.0, -2.0]);
    assert!(super::triangle(&Case::of(&edge).unwrap()).tie);
}

#[test]
fn a_box_has_no_ties_but_misses_by_a_rounding() {
    // Past the corner by the last place of one coordinate.
    let past = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 2.0_f64.next_up(), 0.5, 1.0, -1.0, 0.0];
    assert!(super::axis_box(&Case::of(&past).unwrap()).tie);
    let inside = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 2.0_f64.next_down(), 0.5, 1.0, -1.0, 0.0];
    assert!(super::axis_box(&Case::of(&inside).unwrap()).t.is_some());
}

/// Cases of the families whose inputs have `f64` digits of their own.
fn cases(count: u64) -> impl Iterator<Item = (&'static str, Case)> {
    let of_other_questions = ["special-values", "normals", "normals-far", "degenerate"];
    subject::all()
        .into_iter()
        .filter(move |family| !of_other_questions.contains(&family.name.as_str()))
        .flat_map(move |family| {
            let mut random = Random::of_chunk(3, &family.label(), 0);
            (0..count).map(move |_| (family.primitive, (family.generate)(&mut random)))
        })
}

#[test]
fn the_fast_number_and_the_arbiter_agree() {
    let formulas = formulas();
    let mut hits = 0;
    for (primitive, case) in cases(300) {
        let Some((fast, slow)) = formulas.get(primitive) else { continue };
        let (fast, slow) = (fast(&case), slow(&case));
        assert_eq!(fast.tie, slow.tie, "{primitive} {case:?}");
        assert_eq!(fast.t.is_some(), slow.t.is_some(), "{primitive} {case:?}");
        let (Some(fast), Some((hi, lo))) = (fast.t, slow.t) else { continue };
        hits += 1;
        // A millionth of what a rounding of the inputs does.
        let allowed = 1e-6 * UNIT_ROUNDOFF * slow.condition.max(hi.abs());
        assert!(((fast.0 - hi) + (fast.1 - lo)).abs() <= allowed, "{primitive} {case:?}");
    }
    assert!(hits > 1000, "{hits}");
}

#[test]
fn the_condition_is_how_far_the_hit_moves() {
    /// Far above rounding, and far below what is not linear.
    const PART: f64 = 1.0 / (1_u64 << 40) as f64;
    let formulas: [(&str, Formula, &[usize]); 4] = [
        ("sphere", super::sphere, &[0, 4, 7]),
        ("triangle", super::triangle, &[0, 3, 6, 9, 12]),
        ("plane", super::plane, &[0, 3, 6, 9]),
        ("disk", super::disk, &[0, 3, 7, 10]),
    ];
    let mut random = Random::of_chunk(5, "condition", 0);
    let mut closest = BTreeMap::new();
    for (primitive, case) in cases(3000) {
        let Some((_, formula, vectors)) = formulas.iter().find(|f| f.0 == primitive) else {
            continue;
        };
        let truth = formula(&case);
        let Some((t, rest)) = truth.t else { continue };
        // Only where a change of this size is a small one: for a sphere, of
        // the chord.
        let size = match primitive {
            "sphere" => 0.1 * case.number(3) / case.ray(4).direction.length(),
            _ => t,
        };
        if !(truth.condition * PART < 1e-5 * size.min(t)) {
            continue;
        }
        // Off a surface's start, the nearer root may come and go.
        let height = (case.point(4) - case.point(0)).length() - case.number(3);
        if primitive == "sphere" && height.abs() < 0.1 * case.number(3) {
            continue;
        }
        let mut numbers = case.numbers().to_vec();
        for &at in *vectors {
            let moved = case.point(at) + random.direction() * (PART * case.point(at).length());
            numbers[at..at + 3].copy_from_slice(&moved.to_array());
        }
        let moved = formula(&Case::of(&numbers).unwrap());
        let Some((t_moved, rest_moved)) = moved.t else { continue };
        let ratio = ((t_moved - t) + (rest_moved - rest)).abs() / (PART * truth.condition);
        assert!(ratio < 1.05, "{primitive} {ratio} {case:?}");
        let most: &mut f64 = closest.entry(primitive).or_default();
        *most = most.max(ratio);
    }
    // The bound is nearly reached, so it is no wider than it must be.
    for (primitive, most) in closest {
        assert!(most > 0.5, "{primitive} {most}");
    }
}
