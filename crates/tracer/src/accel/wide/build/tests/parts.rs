//! Trees whose leaves hold parts of triangles.

use fastrand::Rng;
use glam::{DVec3, Vec4};

use super::super::bounds::Bounds;
use super::super::clip::triangle_between;
use super::super::units::Units;
use super::inputs::slivers;
use super::{Box32, Candidates, Child, MAX_DEPTH, OPTIONS, Options, Tree, build, holds};
use crate::Aabb;

const SPLIT: Options = Options { extra: 0.3, ..OPTIONS };

impl Candidates for &[[DVec3; 3]] {
    fn count(&self) -> u32 {
        self.len() as u32
    }

    fn bounds(&self, number: u32) -> Option<Aabb> {
        Some(Aabb::around(self[number as usize]))
    }

    fn corners(&self, number: u32) -> Option<[DVec3; 3]> {
        Some(self[number as usize])
    }
}

/// The boxes around each place where a candidate is, from the root down, and
/// the levels of branches.
fn places(tree: &Tree, count: usize) -> (Vec<Vec<Vec<Box32>>>, usize) {
    let (mut places, mut levels) = (vec![Vec::new(); count], 0);
    let mut pending = vec![(0_u32, Vec::<Box32>::new())];
    while let Some((index, around)) = pending.pop() {
        let branch = tree.branches[index as usize];
        levels = levels.max(around.len() + 1);
        for (child, bounds) in branch.children.into_iter().zip(branch.bounds) {
            let around = [around.as_slice(), &[bounds]].concat();
            match child {
                Child::None => {}
                Child::Branch(at) => pending.push((at, around)),
                Child::Leaf(span) => {
                    let items = span.of(&tree.items);
                    assert!(items.is_sorted_by(|a, b| a < b), "{items:?} has one twice");
                    for &item in items {
                        places[item as usize].push(around.clone());
                    }
                }
            }
        }
    }
    (places, levels)
}

/// Holds a tree to it that each point of each candidate is found: that all
/// boxes down to one of the leaves with the candidate have the point in them.
/// `point` must be exact.
#[track_caller]
pub(super) fn check_covers(
    tree: &Tree,
    count: usize,
    mut point: impl FnMut(u32, &mut Rng) -> DVec3,
) {
    let (places, levels) = places(tree, count);
    assert!(levels <= MAX_DEPTH);
    let mut rng = Rng::with_seed(14);
    for (number, places) in places.iter().enumerate() {
        for _ in 0..100 {
            let p = point(number as u32, &mut rng);
            let has_it = |b: &Box32| holds(*b, Aabb { min: p, max: p });
            let is_found = places.iter().any(|around| around.iter().all(has_it));
            assert!(is_found, "{p} of candidate {number} is in none of {places:?}");
        }
    }
}

/// A point of a triangle, exact for corners of few bits.
fn point_of([a, b, c]: [DVec3; 3], rng: &mut Rng) -> DVec3 {
    let v = rng.u16(0..=1024);
    let w = rng.u16(0..=1024 - v);
    let [v, w] = [v, w].map(|x| f64::from(x) / 1024.0);
    a * (1.0 - v - w) + b * v + c * w
}

#[test]
fn every_point_of_a_split_triangle_is_found() {
    // Powers of two in which sizes are usual, and beyond and below f32.
    for scale in [1.0, 1.0 / 1024.0, libm::ldexp(1.0, 900), libm::ldexp(1.0, -1000)] {
        let triangles = slivers(1500, scale);
        let tree = build(&triangles.as_slice(), SPLIT);
        let (items, count) = (tree.item_count(), triangles.len());
        assert!(items > count, "nothing was split");
        assert!(items <= count + count * 3 / 10, "{items} items");
        check_covers(&tree, count, |i, rng| point_of(triangles[i as usize], rng));
    }
}

#[test]
fn the_split_tree_does_not_depend_on_the_number_of_threads() {
    let triangles = slivers(30_000, 1.0);
    let tree = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| build(&triangles.as_slice(), SPLIT))
    };
    let one = tree(1);
    assert!(one.item_count() > triangles.len(), "nothing was split");
    assert!(one == tree(2));
    assert!(one == tree(7));
}

/// What a ray costs that meets the root, in visits.
fn cost(tree: &Tree) -> f64 {
    let aabb =
        |b: Box32| Aabb { min: b.min.map(f64::from).into(), max: b.max.map(f64::from).into() };
    let places = |branch: &super::Branch| branch.children.into_iter().zip(branch.bounds);
    let used = |place: &(Child, Box32)| place.0 != Child::None;
    let all = tree.branches.iter().flat_map(places).filter(used);
    let root = tree.branches[0].bounds.into_iter().map(aabb).fold(Aabb::EMPTY, Aabb::union);
    all.map(|(_, b)| aabb(b).half_area()).sum::<f64>() / root.half_area()
}

#[test]
fn splits_pay_for_long_things_and_are_left_out_for_small_ones() {
    let long = slivers(4000, 1.0);
    let [whole, split] = [OPTIONS, SPLIT].map(|options| cost(&build(&long.as_slice(), options)));
    assert!(split < 0.9 * whole, "{split} after {whole}");
    let points: Vec<_> = long.iter().map(|t| [t[0]; 3]).collect();
    let [whole, split] = [OPTIONS, SPLIT].map(|options| build(&points.as_slice(), options));
    let leaves = |tree: &Tree| -> Vec<Vec<u32>> {
        tree.leaves.iter().map(|leaf| leaf.of(&tree.items).to_vec()).collect()
    };
    assert!(leaves(&whole) == leaves(&split));
    let boxes = |tree: &Tree| -> Vec<_> { tree.branches.iter().map(|b| b.bounds).collect() };
    assert!(boxes(&whole) == boxes(&split));
}

fn all_space() -> Bounds {
    Bounds { lo: Vec4::splat(f32::MIN), hi: Vec4::splat(f32::MAX) }
}

#[test]
fn a_triangle_is_clipped_to_what_is_between_the_planes() {
    let corners = [DVec3::ZERO, DVec3::new(8.0, 4.0, 0.0), DVec3::new(8.0, 0.0, 2.0)];
    let part = |planes| triangle_between(corners, Units::SCENE, all_space(), 0, planes);
    let middle = part([2.0, 4.0]).unwrap();
    let [lo, hi] = [middle.lo, middle.hi].map(|v| v.truncate().as_dvec3());
    let (want_lo, want_hi) = (DVec3::new(2.0, 0.0, 0.0), DVec3::new(4.0, 2.0, 1.0));
    assert!(lo.cmple(want_lo).all() && lo.abs_diff_eq(want_lo, 1e-6), "{lo}");
    assert!(hi.cmpge(want_hi).all() && hi.abs_diff_eq(want_hi, 1e-6), "{hi}");
    assert!(part([9.0, 10.0]).is_none());
    assert!(part([-3.0, -1.0]).is_none());
}

#[test]
fn no_point_between_the_planes_is_clipped_away() {
    let mut rng = Rng::with_seed(15);
    for triangle in slivers(20_000, 1.0) {
        let axis = rng.usize(0..3);
        let within = Aabb::around(triangle);
        let at = |rng: &mut Rng| (rng.f64() * 4000.0 - 2000.0) as f32;
        let (a, b) = (at(&mut rng), at(&mut rng));
        let planes = [a.min(b), a.max(b)];
        let part = triangle_between(triangle, Units::SCENE, all_space(), axis, planes);
        for _ in 0..20 {
            let p = point_of(triangle, &mut rng);
            if (f64::from(planes[0])..=f64::from(planes[1])).contains(&p[axis]) {
                let part = part.expect("a part where there is a point");
                let is_in = p.cmpge(part.lo.truncate().as_dvec3()).all()
                    && p.cmple(part.hi.truncate().as_dvec3()).all();
                assert!(is_in, "{p} of {within:?} is not in {part:?}");
            }
        }
    }
}
