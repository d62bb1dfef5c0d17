//! Properties of every tree, over kind inputs and nasty ones.

mod inputs;
mod parts;
mod rounding;

use glam::DVec3;

use self::inputs::{Input, all_inputs, cluster_row, random_boxes};
use super::grow::{self, Kind};
use super::reference::Reference;
use super::space::Space;
use super::{Box32, Branch, Candidates, Child, Gathered, MAX_DEPTH, Options, Span, Tree, WIDTH};
use crate::Aabb;
use crate::simd::Level;

const OPTIONS: Options = Options { leaf_size: 4, extra: 0.0, level: Level::Portable };

impl Candidates for &[Aabb] {
    fn count(&self) -> u32 {
        self.len() as u32
    }

    fn bounds(&self, number: u32) -> Option<Aabb> {
        Some(self[number as usize])
    }
}

/// The tree in the scene's own lengths, built with the best instructions.
fn build(candidates: &impl Candidates, options: Options) -> Tree {
    let options = Options { level: Level::best(), ..options };
    super::build(Gathered::scaled(candidates, options, 1.0), candidates, options)
}

impl Tree {
    /// How many candidates are in leaves, one in several for each of them.
    fn item_count(&self) -> usize {
        self.leaves.iter().map(|leaf| leaf.count as usize).sum()
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
        next_leaf: u32,
        times_found: Vec<u32>,
    }
    impl Walk<'_> {
        #[track_caller]
        fn branch(&mut self, index: u32, around: &mut Vec<Box32>) -> usize {
            assert_eq!(index, self.next_branch, "branches are in the order of the walk");
            self.next_branch += 1;
            let Branch { bounds, children, first_leaf } = self.tree.branches[index as usize];
            assert_eq!(first_leaf, self.next_leaf, "leaves are numbered branch by branch");
            let is_leaf = |child: &&Child| matches!(child, Child::Leaf(_));
            let its_leaves = self.tree.leaves[first_leaf as usize..].iter();
            for (child, leaf) in children.iter().filter(is_leaf).zip(its_leaves) {
                assert_eq!(*child, Child::Leaf(*leaf));
                self.next_leaf += 1;
            }
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
                    Child::Leaf(span) => self.leaf(span, around),
                }
                around.pop();
            }
            1 + levels
        }

        #[track_caller]
        fn leaf(&mut self, span: Span, around: &[Box32]) {
            let Span { first, count } = span;
            assert_eq!(first, self.next_item, "leaves are in the order of the walk");
            self.next_item += count;
            assert!((1..=self.leaf_size).contains(&count), "a leaf of {count}");
            for &item in span.of(&self.tree.items) {
                self.times_found[item as usize] += 1;
                let inner = self.boxes[item as usize];
                for outer in around {
                    assert!(holds(*outer, inner), "{outer:?} does not hold {item}: {inner:?}");
                }
            }
        }
    }
    let times_found = vec![0; boxes.len()];
    let (next_branch, next_item, next_leaf) = (0, 0, 0);
    let mut walk = Walk { tree, boxes, leaf_size, next_branch, next_item, next_leaf, times_found };
    let levels = walk.branch(0, &mut Vec::new());
    assert_eq!(walk.next_branch as usize, tree.branches.len());
    assert_eq!(walk.next_item as usize, tree.items.len());
    assert_eq!(walk.next_leaf as usize, tree.leaves.len());
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
    let (bounds, children) = ([Box32::EMPTY; WIDTH], [Child::None; WIDTH]);
    let mut branch = Branch { bounds, children, first_leaf: 0 };
    branch.bounds[0] = Box32 { min: [-1.0; 3], max: [3.0; 3] };
    let leaf = Span { first: 0, count: 1 };
    branch.children[0] = Child::Leaf(leaf);
    let tree = Tree { branches: vec![branch], leaves: vec![leaf], items: vec![0] };
    assert_eq!(tree_of(&[one], OPTIONS), tree);
}

#[test]
fn eight_far_clusters_are_the_eight_leaves_of_one_branch() {
    // Of three, halving by count would mix them.
    for each in [3, 4] {
        let tree = tree_of(&cluster_row(WIDTH, each as usize), OPTIONS);
        assert_eq!(tree.branches.len(), 1);
        for child in tree.branches[0].children {
            let Child::Leaf(span) = child else { panic!("{child:?}") };
            let clusters = span.of(&tree.items).iter();
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
    assert!(matches!(grow::leaf(space), Kind::Leaf(Span { first: 50, count: 2 })));
    assert_eq!(items[..2], [2, 7]);
}

#[test]
fn boxes_that_are_no_triangles_are_split_as_boxes() {
    let boxes = inputs::bars_and_cubes(3000);
    let options = Options { extra: 0.5, ..OPTIONS };
    let tree = tree_of(&boxes, options);
    assert!(tree.item_count() > boxes.len(), "nothing was split");
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

/// Boxes of which those of some numbers are not there.
struct Sparse<'a>(&'a [Aabb], fn(u32) -> bool);

impl Candidates for Sparse<'_> {
    fn count(&self) -> u32 {
        self.0.len() as u32
    }
    fn bounds(&self, number: u32) -> Option<Aabb> {
        self.1(number).then(|| self.0[number as usize])
    }
}

#[test]
fn candidates_that_are_not_there_are_passed_over() {
    // More than are looked at together, and a run of those that is empty.
    let boxes = random_boxes(20_000, 8);
    let cases: [fn(u32) -> bool; 4] =
        [|i| i % 3 != 0, |i| !(3000..13_000).contains(&i), |i| i == 19_999, |_| false];
    for is_there in cases {
        let sparse = Sparse(&boxes, is_there);
        let numbers: Vec<u32> = (0..boxes.len() as u32).filter(|&i| is_there(i)).collect();
        let gathered = Gathered::scaled(&sparse, OPTIONS, 1.0);
        assert_eq!(gathered.numbers(), numbers);
        let dense: Vec<_> = numbers.iter().map(|&i| boxes[i as usize]).collect();
        assert_eq!(gathered.bounds, dense.iter().copied().fold(Aabb::EMPTY, Aabb::union));
        let (tree, expected) = (build(&sparse, OPTIONS), tree_of(&dense, OPTIONS));
        assert!(tree.branches == expected.branches && tree.leaves == expected.leaves);
        let found: Vec<u32> = expected.items.iter().map(|&i| numbers[i as usize]).collect();
        assert!(tree.items == found);
    }
}

#[test]
fn a_far_vertex_of_no_triangle_changes_nothing() {
    struct Far<'a>(&'a [Aabb]);
    impl Candidates for Far<'_> {
        fn count(&self) -> u32 {
            self.0.count()
        }
        fn bounds(&self, number: u32) -> Option<Aabb> {
            self.0.bounds(number)
        }
        fn largest(&self) -> f64 {
            1e30
        }
    }
    let boxes = random_boxes(100, 9);
    let near = Gathered::new(&boxes.as_slice(), OPTIONS);
    let far = Gathered::new(&Far(&boxes), OPTIONS);
    assert_eq!((near.scale, near.bounds), (far.scale, far.bounds));
}
