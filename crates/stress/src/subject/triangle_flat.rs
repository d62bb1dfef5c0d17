//! What is asked of triangles without an area: nothing may hit them.
//!
//! They are kept only among others, so each stands in a mesh with a triangle
//! that is far away. A case is the three corners and a ray: fifteen numbers.

use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::shape::{Geometry, Mesh};
use tracer::{Interval, Ray};

use super::closest::Answer;
use super::triangle::corners;
use crate::family::{Family, Kernel, Volume};
use crate::{Case, Metric, Random};

/// Every family of flat triangles.
pub(super) fn families() -> Vec<Family> {
    let answers: [Answer; 3] = [
        (Kernel::GOLDRAY, goldray),
        (Kernel::textbook("inside-edges-f64"), super::triangle::inside_edges),
        (Kernel::textbook("linear-system-f64"), super::triangle::linear_system),
    ];
    let family = Family {
        primitive: "triangle",
        name: "degenerate".to_owned(),
        kernels: answers.iter().map(|(kernel, _)| *kernel).collect(),
        targets: vec![(Metric::FalseHits, Some(0.0)), (Metric::NotFinite, Some(0.0))],
        volume: Volume { quick: 100_000, full: 20_000_000 },
        generate: Box::new(generate),
        judge: Box::new(move |case, tallies| {
            for ((_, answer), tally) in answers.iter().zip(tallies) {
                tally.case();
                match answer(case) {
                    None => {}
                    Some(t) if t.is_finite() => tally.count(Metric::FalseHits),
                    Some(_) => tally.count(Metric::NotFinite),
                }
            }
        }),
    };
    vec![family]
}

/// Corners of a good triangle that no ray of a case meets.
const ELSEWHERE: [DVec3; 3] =
    [DVec3::new(0.0, 0.0, 1e9), DVec3::new(1.0, 0.0, 1e9), DVec3::new(0.0, 1.0, 1e9)];

fn goldray(case: &Case) -> Option<f64> {
    let vertices = corners(case).into_iter().chain(ELSEWHERE).collect();
    let mesh = Mesh::new(vertices, vec![[0, 1, 2], [3, 4, 5]], None, Build::default()).ok()?;
    let contact = mesh.intersect(&case.ray(9), Interval::AHEAD)?;
    // Numbered as given, the other one is the second.
    (contact.part == 0).then_some(contact.t)
}

/// Whole numbers up to here make exactly collinear corners.
const MOST: usize = 1000;

fn generate(random: &mut Random) -> Case {
    let whole = |random: &mut Random| random.below(2 * MOST + 1) as f64 - MOST as f64;
    let point = |random: &mut Random| DVec3::new(whole(random), whole(random), whole(random));
    let scale = libm::exp2(random.below(80) as f64 - 40.0);
    let (a, step) = (point(random), point(random));
    let corners = match random.below(4) {
        // Collinear.
        0 => [a, a + step * whole(random), a + step * whole(random)],
        // All one point.
        1 => [a; 3],
        // Two corners of three.
        2 => [a, a, a + step],
        _ => [a, a + step, a],
    };
    // At a corner, or between two, along the line or from anywhere.
    let target = match random.below(3) {
        0 => corners[random.below(3)],
        1 => corners[0].midpoint(corners[2]),
        _ => corners[0] + (corners[1] - corners[0]) * random.between(-0.5, 1.5),
    };
    let direction = match random.below(4) {
        0 => step,
        1 => random.direction(),
        _ => point(random),
    };
    let origin = target - direction * (1.0 + random.below(8) as f64);
    let case =
        corners.into_iter().fold(Case::EMPTY, |case, corner| case.with_point(corner * scale));
    case.with_ray(&Ray::new(origin * scale, direction))
}
