//! Rays that leave the floor of a closed room whose ceiling has a sliver in it:
//! whatever a triangle's normal is worth, they must not get out.

use tracer::glam::DVec3;
use tracer::{Group, Interval, Ray};

use super::{LEAVERS, alone_mesh, leave_for};
use crate::family::{Family, Volume};
use crate::{Case, Metric, Random, Tally};

/// Every family of slivers.
pub(super) fn families() -> Vec<Family> {
    vec![Family {
        primitive: "spawn",
        name: "slivers".to_owned(),
        kernels: LEAVERS.to_vec(),
        targets: vec![
            (Metric::Leaks, Some(0.0)),
            (Metric::SelfHits, Some(0.0)),
            (Metric::NotFinite, Some(0.0)),
        ],
        volume: Volume { quick: 50_000, full: 5_000_000 },
        generate: Box::new(generate),
        judge: Box::new(judge),
    }]
}

/// A case: the room's height and the sliver's middle and half its width; which
/// corner comes first; where on the floor the ray starts, and the point above
/// the ceiling that it leaves for; the room's place.
fn generate(random: &mut Random) -> Case {
    let height = random.decades(1e-8, 1.0);
    let middle = if random.coin() { 0.0 } else { random.between(-0.5, 0.5) };
    let half = random.decades(1e-15, 1e-2);
    let z = random.between(-0.9, 0.9);
    // Under the sliver, often exactly under its middle.
    let way = if random.coin() { 0.0 } else { random.between(-1.0, 1.0) };
    let x = middle + 0.5 * (z + 1.0) * half * way;
    let slope = if random.coin() { 0.0 } else { random.between(-0.05, 0.05) };
    let offset =
        if random.coin() { DVec3::ZERO } else { random.point() * random.decades(1.0, 1e3) };
    Case::EMPTY
        .with(height)
        .with(middle)
        .with(half)
        .with(random.below(3) as f64)
        .with_point(DVec3::new(x, 0.0, z))
        .with_point(DVec3::new(x + slope * height, height * random.between(1.5, 30.0), z))
        .with_point(offset)
}

fn judge(case: &Case, tallies: &mut [Tally]) {
    let offset = case.point(10);
    let (start, above) = (case.point(4) + offset, case.point(7) + offset);
    let Some(world) = room(case) else { return };
    // From the room's middle height straight down.
    let inside = start + DVec3::Y * (0.5 * case.number(0));
    let down = Ray::new(inside, -DVec3::Y);
    let Some(hit) = world.intersect(&down, Interval::AHEAD) else { return };
    leave_for(&hit, above, tallies, |ray, tally| {
        let next = world.intersect(ray, Interval::new(0.0, 1.0));
        if next.is_none() || !world.occludes(ray, Interval::new(0.0, 1.0)) {
            tally.count(Metric::Leaks);
        }
        // The ceiling is at two thirds of the way at most, and not at the start.
        if next.is_some_and(|hit| hit.t < 1e-3) {
            tally.count(Metric::SelfHits);
        }
    });
}

/// The room, `[-1, 1]` wide and deep, from 0 to its height.
fn room(case: &Case) -> Option<Group> {
    let [height, middle, half] = [0, 1, 2].map(|i| case.number(i));
    let offset = case.point(10);
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z) + offset;
    let vertices = vec![
        at(-1.0, 0.0, -1.0),
        at(1.0, 0.0, -1.0),
        at(1.0, 0.0, 1.0),
        at(-1.0, 0.0, 1.0),
        at(-1.0, height, -1.0),
        at(1.0, height, -1.0),
        at(1.0, height, 1.0),
        at(-1.0, height, 1.0),
        // The sliver: its tip, and its short side.
        at(middle, height, -1.0),
        at(middle - half, height, 1.0),
        at(middle + half, height, 1.0),
    ];
    let sliver = match case.number(3) as u32 {
        0 => [8, 9, 10],
        1 => [9, 10, 8],
        _ => [10, 8, 9],
    };
    let mut faces = vec![sliver];
    // Around it the ceiling, and its front and back walls, which share the
    // sliver's corners.
    faces.extend([[4, 7, 9], [4, 9, 8], [8, 10, 6], [8, 6, 5]]);
    faces.extend([[3, 2, 10], [3, 10, 9], [3, 9, 7], [2, 6, 10]]);
    faces.extend([[0, 4, 8], [0, 8, 1], [1, 8, 5]]);
    faces.extend([[0, 2, 1], [0, 3, 2], [0, 7, 4], [0, 3, 7], [1, 5, 6], [1, 6, 2]]);
    alone_mesh(vertices, faces)
}
