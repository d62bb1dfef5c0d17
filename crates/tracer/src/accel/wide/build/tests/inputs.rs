//! Boxes to build trees of.

use fastrand::Rng;
use glam::DVec3;

use crate::Aabb;

pub(super) struct Input {
    pub name: &'static str,
    pub boxes: Vec<Aabb>,
}

fn point(rng: &mut Rng) -> DVec3 {
    DVec3::from_array([(); 3].map(|()| rng.f64() * 2.0 - 1.0))
}

/// Boxes of many sizes in a cube.
pub(super) fn random_boxes(count: usize, seed: u64) -> Vec<Aabb> {
    let mut rng = Rng::with_seed(seed);
    let one = |_| {
        let (at, size) = (point(&mut rng), 1.0 / f64::from(1 << rng.i32(1..12)));
        Aabb::around([at, at + size * point(&mut rng)])
    };
    (0..count).map(one).collect()
}

/// Clusters of so many boxes each, far apart along a line.
pub(super) fn cluster_row(clusters: usize, each: usize) -> Vec<Aabb> {
    let one = |i: usize| {
        let at = DVec3::X * (1000 * (i / each)) as f64 + DVec3::Y * (i % each) as f64;
        Aabb::around([at, at + DVec3::ONE])
    };
    (0..clusters * each).map(one).collect()
}

/// Cubes, and among them long bars along each axis.
pub(super) fn bars_and_cubes(count: usize) -> Vec<Aabb> {
    let mut rng = Rng::with_seed(12);
    let one = |i: usize| {
        let min = [(); 3].map(|()| f64::from(rng.u8(0..250)));
        let mut max = min.map(|x| x + 1.0);
        if i.is_multiple_of(10) {
            max[i % 3] = min[i % 3] + 128.0;
        }
        Aabb { min: min.into(), max: max.into() }
    };
    (0..count).map(one).collect()
}

/// Long thin triangles across a cube, whose corners are whole numbers of up to
/// 12 bits times `scale`, a power of two.
pub(super) fn slivers(count: usize, scale: f64) -> Vec<[DVec3; 3]> {
    let mut rng = Rng::with_seed(13);
    let mut whole = |from: f64, to: u16| from + f64::from(rng.u16(0..to));
    let one = |i: usize| {
        // Most are small, as in a mesh of something with long beams.
        let length = if i.is_multiple_of(4) { 3000 } else { 40 };
        let a = [(); 3].map(|()| whole(-1500.0, 3000));
        let b = a.map(|x| whole(x - f64::from(length / 2), length));
        let c = b.map(|x| whole(x, 20));
        [a, b, c].map(|p| DVec3::from_array(p) * scale)
    };
    (0..count).map(one).collect()
}

fn scaled(boxes: &[Aabb], by: f64) -> Vec<Aabb> {
    boxes.iter().map(|b| Aabb { min: by * b.min, max: by * b.max }).collect()
}

/// Points on each axis, of which each is 40 times closer to the origin than the
/// one before: no cut takes away more than one.
fn peeled() -> Vec<Aabb> {
    let distances = (0..25).map(|i| (0..i).fold(1.0, |x: f64, _| x / 40.0));
    let on_axes = |x| DVec3::AXES.map(|axis| Aabb::around([x * axis]));
    distances.flat_map(on_axes).collect()
}

/// Boxes of which each is twice as large and twice as far as the one before.
fn exponential(count: i32, lowest: i32) -> Vec<Aabb> {
    let one = |i| {
        let size = DVec3::splat(libm::ldexp(1.0, lowest + i));
        Aabb::around([size, 1.5 * size])
    };
    (0..count).map(one).collect()
}

pub(super) fn all_inputs() -> Vec<Input> {
    let mut rng = Rng::with_seed(11);
    let random = random_boxes(3000, 1);
    let tiny: Vec<_> = scaled(&random, 1e-9);
    let giant = Aabb::around([DVec3::splat(-1e6), DVec3::splat(1e6)]);
    let mut giant_and_tiny = tiny.clone();
    giant_and_tiny.push(giant);
    let nested = (1..1000).map(|i| scaled(&[giant], f64::from(i))[0]).collect();
    let points = (0..1000).map(|_| Aabb::around([point(&mut rng)])).collect();
    let far = random.iter().map(|b| {
        let far = DVec3::splat(1e7);
        Aabb { min: b.min + far, max: b.max + far }
    });
    let mut ends_of_f64 = scaled(&random, f64::MAX);
    ends_of_f64.extend(scaled(&random, f64::MIN_POSITIVE));
    let flat = (0..40).flat_map(|x| (0..40).map(move |y| (f64::from(x), f64::from(y))));
    let flat = flat
        .map(|(x, y)| Aabb { min: DVec3::new(x, y, 0.0), max: DVec3::new(x + 1.0, y + 1.0, 0.0) });
    let few = |n: usize| Input { name: "few", boxes: random_boxes(n, n as u64) };
    let mut all: Vec<_> = (1..40).map(few).collect();
    let input = |name, boxes| Input { name, boxes };
    all.extend([
        input("random", random.clone()),
        input("flat", flat.collect()),
        input("points", points),
        input("one place", vec![giant; 1000]),
        input("all at the origin", vec![Aabb::around([DVec3::ZERO]); 100]),
        input("nested", nested),
        input("giant and tiny", giant_and_tiny),
        input("far from the origin", far.collect()),
        input("exponential", exponential(2000, -1000)),
        input("exponential, subnormal", exponential(1000, -1074)),
        input("peeled", peeled()),
        input("beyond f32", scaled(&random, 1e200)),
        input("below f32", scaled(&random, 1e-200)),
        input("ends of f32", scaled(&random, f64::from(f32::MAX))),
        input("ends of f64", ends_of_f64),
        input("subnormal", scaled(&random, 1e-312)),
        input("tiny", tiny),
    ]);
    all
}
