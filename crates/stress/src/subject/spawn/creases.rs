//! Rays that leave a point in a concave edge or corner of a mesh, exactly there
//! but for rounding: they start on two surfaces at once, and must meet neither.
//!
//! The mesh is a tetrahedron, each side of four triangles, seen from inside:
//! from a point of its surface to one well inside nothing is in the way.

use std::ops::Range;

use tracer::glam::DVec3;
use tracer::{Group, Interval, Ray};

use super::{LEAVERS, alone_mesh, leave_for};
use crate::family::{Family, Volume};
use crate::{Case, Metric, Random, Tally};

const VOLUME: Volume = Volume { quick: 50_000, full: 5_000_000 };

/// Every family of creases.
pub(super) fn families() -> Vec<Family> {
    vec![
        family("creases", Place { offset: 0.0, sizes: (0.1, 10.0), flatness: 1.0 }),
        family("creases-world-1e4", Place { offset: 1e4, sizes: (1.0, 1.0), flatness: 1.0 }),
        family("creases-acute", Place { offset: 1.0, sizes: (1e-4, 1e6), flatness: 1e-3 }),
    ]
}

/// Where a tetrahedron is and how it is made.
#[derive(Clone, Copy)]
struct Place {
    /// From the origin, in sizes.
    offset: f64,
    sizes: (f64, f64),
    /// How high it is, across.
    flatness: f64,
}

/// Where a case has what follows the four corners: the weights of the point to
/// look from, those of the point on an edge to look at, and those of the point
/// to leave for.
const FROM: usize = 12;
const AT: usize = FROM + 4;
const TO: usize = AT + 4;

fn family(name: &str, place: Place) -> Family {
    Family {
        primitive: "spawn",
        name: name.to_owned(),
        kernels: LEAVERS.to_vec(),
        targets: vec![
            (Metric::SelfHits, Some(0.0)),
            (Metric::Leaks, Some(0.0)),
            (Metric::NotFinite, Some(0.0)),
        ],
        volume: VOLUME,
        generate: Box::new(move |random| generate(place, random)),
        judge: Box::new(judge),
    }
}

fn generate(place: Place, random: &mut Random) -> Case {
    let size = random.decades(place.sizes.0, place.sizes.1);
    let offset = random.direction() * (size * place.offset);
    let (up, flatness) = (random.direction(), place.flatness);
    let corners = plump(random).map(|p| {
        let p = p - up * (p.dot(up) * (1.0 - flatness));
        offset + p * size
    });
    let mut case = corners.into_iter().fold(Case::EMPTY, Case::with_point);
    let (from, at, to) = (within(random), on_edge(random), within(random));
    for weight in [from, at, to].as_flattened() {
        case = case.with(*weight);
    }
    case
}

/// The corners of a tetrahedron that is not flat.
fn plump(random: &mut Random) -> [DVec3; 4] {
    loop {
        let corners @ [a, b, c, d] = [(); 4].map(|()| random.point());
        if (b - a).cross(c - a).dot(d - a).abs() > 0.5 {
            return corners;
        }
    }
}

/// The weights of a point well inside.
fn within(random: &mut Random) -> [f64; 4] {
    let weights = [(); 4].map(|()| random.between(0.2, 1.0));
    weights.map(|weight| weight / weights.iter().sum::<f64>())
}

/// The weights of a point of an edge, often one of its ends or its middle,
/// where triangles meet.
fn on_edge(random: &mut Random) -> [f64; 4] {
    let i = random.below(4);
    let j = (i + 1 + random.below(3)) % 4;
    let any = random.unit();
    let share = random.one_of(&[0.0, 0.5, 0.25, any, any]);
    let mut weights = [0.0; 4];
    (weights[i], weights[j]) = (share, 1.0 - share);
    weights
}

fn judge(case: &Case, tallies: &mut [Tally]) {
    let corners = [0, 3, 6, 9].map(|i| case.point(i));
    let point = |weights: Range<usize>| {
        weights.zip(corners).map(|(i, corner)| case.number(i) * corner).sum::<DVec3>()
    };
    let (from, at, to) = (point(FROM..AT), point(AT..TO), point(TO..TO + 4));
    let Some(world) = tetrahedron(corners) else { return };
    let Some(hit) = world.intersect(&Ray::new(from, at - from), Interval::AHEAD) else {
        // That a ray from inside is never lost is asked of `mesh/*`.
        return;
    };
    leave_for(&hit, to, tallies, |ray, tally| {
        let next = world.intersect(ray, Interval::AHEAD);
        if next.is_none() {
            tally.count(Metric::Leaks);
        }
        let is_early = next.is_some_and(|hit| hit.t <= 1.0);
        if is_early || world.occludes(ray, Interval::new(0.0, 1.0)) {
            tally.count(Metric::SelfHits);
        }
    });
}

/// The tetrahedron alone in a world, its sides cut in four at the middles of
/// the edges.
fn tetrahedron(corners: [DVec3; 4]) -> Option<Group> {
    let mut vertices = corners.to_vec();
    let mut middles = [[0; 4]; 4];
    for (i, j) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
        middles[i][j] = vertices.len() as u32;
        middles[j][i] = middles[i][j];
        vertices.push(0.5 * (corners[i] + corners[j]));
    }
    let sides: [[usize; 3]; 4] = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    let quarters = sides.into_iter().flat_map(|[i, j, k]| {
        let (ij, jk, ki) = (middles[i][j], middles[j][k], middles[k][i]);
        let [i, j, k] = [i, j, k].map(|corner| corner as u32);
        [[i, ij, ki], [j, jk, ij], [k, ki, jk], [ij, jk, ki]]
    });
    alone_mesh(vertices, quarters.collect())
}
