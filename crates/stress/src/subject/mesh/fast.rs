//! Closed meshes met in `f32`, shot at from inside: no ray may get out, and how
//! far off the hits are.

use std::sync::{Arc, LazyLock};

use tracer::Interval;
use tracer::accel::{Build, Coherence};
use tracer::shape::{Geometry, Mesh};

use super::{AIMS, Aim, Aimed, CORNERS, Make, RAY, SOLIDS, Target, targets};
use crate::family::{Family, Kernel, Volume};
use crate::{Case, Metric, Tally};

/// How far a hit may be from the accurate one, in sizes: the largest coordinate of
/// the ray's origin and of the mesh together. Shown, but not held, for the torus: a
/// ray aimed at where it turns away may see the part behind.
const MOST_OFF: f64 = 1e-4;

/// Solids whose triangles are not so thin that in `f32` nothing is left of them.
pub(super) fn families() -> Vec<Family> {
    let mut families = Vec::new();
    for (name, make, _) in SOLIDS {
        let solids: Solids = Arc::new(LazyLock::new(Box::new(move || solids(make))));
        for (kind, aim) in AIMS {
            let most_off = (name != "torus").then_some(MOST_OFF);
            families.push(family(format!("fast/{kind}/{name}"), &solids, aim, most_off));
        }
    }
    families
}

type Solids = Arc<LazyLock<Vec<(Target, Mesh)>, Box<dyn FnOnce() -> Vec<(Target, Mesh)> + Send>>>;

fn solids(make: Make) -> Vec<(Target, Mesh)> {
    let fast = |target: Target| {
        let solid = &target.solid;
        let (vertices, faces) = (solid.vertices.clone(), solid.faces.clone());
        let mesh = Mesh::new(vertices, faces, None, Build::Fast).ok()?;
        Some((target, mesh))
    };
    targets(&make()).into_iter().filter_map(fast).collect()
}

fn family(name: String, solids: &Solids, aim: Aim, most_off: Option<f64>) -> Family {
    let (makes, judges) = (Arc::clone(solids), Arc::clone(solids));
    Family {
        primitive: "mesh",
        name,
        kernels: vec![Kernel::GOLDRAY],
        targets: vec![
            (Metric::Leaks, Some(0.0)),
            (Metric::NotFinite, Some(0.0)),
            (Metric::PositionError, most_off),
            (Metric::WrongIdentity, None),
        ],
        volume: Volume { quick: 20_000, full: 20_000_000 },
        generate: Box::new(move |random| {
            let place = random.below(makes.len());
            let Some((target, _)) = makes.get(place) else { return Case::EMPTY };
            let Aimed { ray, at } = aim(target, random);
            let [a, b] = at.map_or([-1.0; 2], |at| at.map(f64::from));
            Case::EMPTY.with(place as f64).with_ray(&ray).with(a).with(b)
        }),
        judge: Box::new(move |case, tallies| {
            if let Some((target, mesh)) = judges.get(case.number(0) as usize) {
                for tally in tallies {
                    judge(target, mesh, case, tally);
                }
            }
        }),
    }
}

fn judge(target: &Target, mesh: &Mesh, case: &Case, tally: &mut Tally) {
    debug_assert!(case.number(CORNERS) >= -1.0);
    tally.case();
    let ray = case.ray(RAY);
    let (mut contact, mut occluded) = ([None], [false]);
    mesh.intersect_batch(&[ray], Interval::AHEAD, Coherence::Incoherent, &mut contact);
    mesh.occludes_batch(&[ray], Interval::AHEAD, Coherence::Incoherent, &mut occluded);
    let [Some(contact)] = contact else {
        tally.count(Metric::Leaks);
        return;
    };
    if !occluded[0] {
        tally.count(Metric::Leaks);
    }
    if !contact.t.is_finite() {
        tally.count(Metric::NotFinite);
    }
    let Some(accurate) = target.mesh.intersect(&ray, Interval::AHEAD) else { return };
    if contact.part != accurate.part {
        tally.count(Metric::WrongIdentity);
    }
    let largest = |p: tracer::glam::DVec3| p.abs().max_element();
    let size = largest(ray.origin) + mesh.bounds().max_abs();
    let off = (contact.t - accurate.t).abs() * largest(ray.direction);
    tally.most(Metric::PositionError, off / size);
}
