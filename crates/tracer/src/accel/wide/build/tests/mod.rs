//! Properties of every tree, over kind inputs and nasty ones.

mod inputs;
mod parts;
mod rounding;

use glam::DVec3;

use self::inputs::{Input, all_inputs, cluster_row, random_boxes};
use super::grow::{self, Kind};
use super::reference::Reference;
use super::space::Space;
use super::{Box32, Branch, Candidates, Child, MAX_DEPTH, Options, Tree, WIDTH, build};
use crate::Aabb;

const OPTIONS: Options = Options { leaf_size: 4, extra: 0.0 };

impl Candidates for &[Aabb] {
    fn count(&self) -> u32 {
        self.len() as u32
    }

    fn bounds(&self, number: u32) -> Aabb {
        self[number as usize]
    }
}

fn tree_of(boxes: &[Aabb], options: Options) -> Tree {
    build(&boxes, options)
}

fn holds(outer: Box32, inner: Aabb) -> bool {
    let axis = |k: usize| {
        f64::from(outer.min[k]) <= inner.min[k] && inner.max[k] <= f64::from(outer.max[k])
    };
    (0..3).all(axis)
}

/// Walks a tree as documented and holds it to what its types promise; returns
/// its levels of branches.
#[track_caller]
fn check(tree: &Tree, boxes: &[Aabb], leaf_size: u32) -> usize {
    struct Walk<'a> {
        tree: &'a Tree,
        boxes: &'a [Aabb],
        leaf_size: u32,
        next_branch: u32,
        next_item: u32,
        times_found: Vec<u32>,
    }
    impl Walk<'_> {
        #[track_caller]
        fn branch(&mut self, index: u32, around: &mut Vec<Box32>) -> usize {
            assert_eq!(index, self.next_branch, "branches are in the order of the walk");
            self.next_branch += 1;
            let Branch { bounds, children } = self.tree.branches[index as usize];
            let used = children.iter().take_while(|&&c| c != Child::None).count();
            assert!(used > 0, "branch {index} has no child");
            let mut levels = 0;
            for (k, (&child, bounds)) in children.iter().zip(bounds).enumerate() {
                around.push(bounds);
                match child {
                    Child::None => {
                        assert!(k >= used && bounds == Box32::EMPTY, "branch {index}, child {k}");
                    }
                    Child::Branch(at) => levels = levels.max(self.branch(at, around)),
                    Child::Leaf { first, count } => self.leaf(first, count, around),
                }
                around.pop();
            }
            1 + levels
        }

        #[track_caller]
        fn leaf(&mut self, first: u32, count: u32, around: &[Box32]) {
            assert_eq!(first, self.next_item, "leaves are in the order of the walk");
            self.next_item += count;
            assert!((1..=self.leaf_size).contains(&count), "a leaf of {count}");
            for &item in &self.tree.items[first as usize..(first + count) as usize] {
                self.times_found[item as usize] += 1;
                let inner = self.boxes[item as usize];
                for outer in around {
                    assert!(holds(*outer, inner), "{outer:?} does not hold {item}: {inner:?}");
                }
            }
        }
    }
    let times_found = vec![0; boxes.len()];
    let mut walk = Walk { tree, boxes, leaf_size, next_branch: 0, next_item: 0, times_found };
    let levels = walk.branch(0, &mut Vec::new());
    assert_eq!(walk.next_branch as usize, tree.branches.len());
    assert_eq!(walk.next_item as usize, tree.items.len());
    assert!(walk.times_found.iter().all(|&n| n == 1), "each candidate is in one leaf");
    levels
}

#[test]
fn every_candidate_is_in_a_leaf_inside_of_all_boxes_above() {
    for Input { name, boxes } in all_inputs() {
        for leaf_size in [1, 2, 4, 8] {
            let tree = tree_of(&boxes, Options { leaf_size, ..OPTIONS });
            let levels = check(&tree, &boxes, leaf_size as u32);
            assert!(levels <= MAX_DEPTH, "{name}: {levels} levels");
        }
    }
}

#[test]
fn a_million_coincident_boxes_are_halved() {
    let boxes = vec![Aabb::around([DVec3::ONE, DVec3::splat(2.0)]); 1_000_000];
    // Full leaves: 250000 of them, whose binary logarithm is below 18.
    let levels = check(&tree_of(&boxes, OPTIONS), &boxes, 4);
    assert!(levels <= 18_usize.div_ceil(2), "{levels} levels");
}

#[test]
fn no_candidates_make_no_tree_and_one_makes_one_leaf() {
    assert_eq!(tree_of(&[], OPTIONS), Tree::default());
    let one = Aabb::around([DVec3::NEG_ONE, DVec3::splat(3.0)]);
    let mut branch = Branch { bounds: [Box32::EMPTY; WIDTH], children: [Child::None; WIDTH] };
    branch.bounds[0] = Box32 { min: [-1.0; 3], max: [3.0; 3] };
    branch.children[0] = Child::Leaf { first: 0, count: 1 };
    assert_eq!(tree_of(&[one], OPTIONS), Tree { branches: vec![branch], items: vec![0] });
}

#[test]
fn eight_far_clusters_are_the_eight_leaves_of_one_branch() {
    // Of three, halving by count would mix them.
    for each in [3, 4] {
        let tree = tree_of(&cluster_row(WIDTH, each as usize), OPTIONS);
        assert_eq!(tree.branches.len(), 1);
        for child in tree.branches[0].children {
            let Child::Leaf { first, count } = child else { panic!("{child:?}") };
            let clusters = tree.items[first as usize..(first + count) as usize].iter();
            let clusters: Vec<_> = clusters.map(|i| i / each).collect();
            assert_eq!(clusters, vec![clusters[0]; each as usize]);
        }
    }
}

#[test]
fn sixty_four_far_clusters_fill_nine_branches() {
    for each in [3, 4] {
        assert_eq!(tree_of(&cluster_row(WIDTH * WIDTH, each), OPTIONS).branches.len(), 1 + WIDTH);
    }
}

#[test]
fn a_leaf_has_a_candidate_once_of_which_it_has_several_parts() {
    let mut here = [7, 2, 7, 7].map(|number| Reference::new([0.0; 3], [1.0; 3], number));
    let (mut there, mut items) = (here, [0; 4]);
    let space = Space {
        here: &mut here,
        there: &mut there,
        items: &mut items,
        first: 50,
        start: 0,
        count: 4,
        level: 0,
        misses: 0,
    };
    assert!(matches!(grow::leaf(space), Kind::Leaf { first: 50, count: 2 }));
    assert_eq!(items[..2], [2, 7]);
}

#[test]
fn boxes_that_are_no_triangles_are_split_as_boxes() {
    let boxes = inputs::bars_and_cubes(3000);
    let options = Options { extra: 0.5, ..OPTIONS };
    let tree = tree_of(&boxes, options);
    assert!(tree.items.len() > boxes.len(), "nothing was split");
    parts::check_covers(&tree, boxes.len(), |number, rng| {
        let Aabb { min, max } = boxes[number as usize];
        min + (max - min) * DVec3::from_array([(); 3].map(|()| f64::from(rng.u8(0..=64)) / 64.0))
    });
}

#[test]
fn the_tree_does_not_depend_on_the_number_of_threads() {
    let boxes = random_boxes(30_000, 5);
    let tree = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| tree_of(&boxes, OPTIONS))
    };
    let one = tree(1);
    check(&one, &boxes, 4);
    assert!(one == tree(2));
    assert!(one == tree(7));
}

#[test]
fn the_tree_does_not_depend_on_the_order_of_the_candidates() {
    let boxes = random_boxes(10_000, 6);
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    fastrand::Rng::with_seed(7).shuffle(&mut order);
    let shuffled: Vec<_> = order.iter().map(|&i| boxes[i as usize]).collect();
    let (straight, mixed) = (tree_of(&boxes, OPTIONS), tree_of(&shuffled, OPTIONS));
    assert!(straight.branches == mixed.branches);
}
