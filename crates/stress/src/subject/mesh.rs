//! Closed meshes shot at from inside, through the hierarchy: exactly at edges,
//! at corners, and along the lattice that makes exact hits of both abound.
//!
//! A ray from inside a sphere-like solid that is seen whole from there crosses
//! it once: no hit is a leak, and a second one a double hit. Where rounding
//! has folded the solid, or it is a torus, a ray crosses it an odd number of
//! times: none is a leak, and any other even number a double hit.

use std::sync::{Arc, LazyLock};

use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::shape::{Contact, Geometry, Mesh};
use tracer::{Interval, Ray};

use crate::family::{Family, Kernel, Volume};
use crate::meshes::{Place, Solid};
use crate::random::f32_point;
use crate::{Case, Metric, Random, Tally};

mod batches;
mod brute_force;
mod fast;
mod textbook;

/// Every family of meshes.
pub(super) fn families() -> Vec<Family> {
    let mut families = Vec::new();
    for (name, make, volume) in SOLIDS {
        let targets: Targets = Arc::new(LazyLock::new(Box::new(move || targets(&make()))));
        for (kind, aim) in AIMS {
            families.push(family(format!("{kind}/{name}"), volume, &targets, aim));
        }
    }
    families.extend(brute_force::families());
    families.extend(batches::families());
    families.extend(fast::families());
    families
}

type Targets = Arc<LazyLock<Vec<Target>, Box<dyn FnOnce() -> Vec<Target> + Send>>>;

type Make = fn() -> Solid;

/// The solids, and how many rays of each kind: together 1e9, fewer where the
/// hierarchy is deep and many triangles meet.
const SOLIDS: [(&str, Make, Volume); 6] = [
    ("noisy-sphere", Solid::noisy_sphere, Volume { quick: 100_000, full: 200_000_000 }),
    ("fine-sphere", Solid::fine_sphere, Volume { quick: 50_000, full: 20_000_000 }),
    ("needle-poles", Solid::needle_poles, Volume { quick: 40_000, full: 20_000_000 }),
    ("lattice-cube", Solid::lattice_cube, Volume { quick: 100_000, full: 200_000_000 }),
    ("icosphere", || Solid::icosphere(2), Volume { quick: 100_000, full: 480_000_000 }),
    ("torus", Solid::torus, Volume { quick: 100_000, full: 80_000_000 }),
];

type Aim = fn(&Target, &mut Random) -> Aimed;
const AIMS: [(&str, Aim); 3] = [("edge", at_edge), ("vertex", at_vertex), ("lattice", on_lattice)];

/// Where the solids stand. The second offset is that of Embree's watertight
/// test: rounding folds the solids there, and the third keeps them as they
/// are, with more digits than an `f32` has.
const PLACES: [Place; 5] = [
    Place { scale: 1.0, offset: DVec3::ZERO, single: true },
    Place { scale: 1.0, offset: DVec3::new(148_376.0, 1234.0, -223_423.0), single: true },
    Place { scale: 1.0, offset: DVec3::new(1e5, -1e5, 1e5), single: false },
    Place { scale: 1e-6, offset: DVec3::ZERO, single: true },
    Place { scale: 1e10, offset: DVec3::ZERO, single: true },
];

/// A solid at one of the places.
struct Target {
    solid: Solid,
    mesh: Mesh,
    rings: Vec<Vec<u32>>,
    /// Whether a ray from inside crosses it once, rather than any odd number
    /// of times.
    once: bool,
}

fn targets(solid: &Solid) -> Vec<Target> {
    let target = |&place: &Place| {
        let solid = solid.placed(place);
        let mesh = Mesh::new(solid.vertices.clone(), solid.faces.clone(), None, Build::Bvh).ok()?;
        let (rings, once) = (solid.rings(), solid.is_star_shaped());
        Some(Target { solid, mesh, rings, once })
    };
    PLACES.iter().filter_map(target).collect()
}

/// A ray, and the corners that it is aimed at: the two of an edge or one
/// twice. `None` if it is aimed at nothing.
struct Aimed {
    ray: Ray,
    at: Option<[u32; 2]>,
}

impl Aimed {
    /// At a point between two corners, which is at `t = 1`.
    fn between(target: &Target, origin: DVec3, [a, b]: [u32; 2], share: f64) -> Self {
        let [p, q] = [a, b].map(|i| target.solid.vertices[i as usize]);
        let ray = Ray::new(origin, p + share * (q - p) - origin);
        Self { ray, at: Some([a, b]) }
    }
}

impl Target {
    fn origin(&self, random: &mut Random) -> DVec3 {
        let (middle, half) = self.solid.starts[random.below(self.solid.starts.len())];
        middle + half * random.point()
    }

    /// A point of the lattice of 9 by 9 by 9 in one of the cubes inside.
    fn lattice_origin(&self, random: &mut Random) -> DVec3 {
        let (middle, half) = self.solid.starts[random.below(self.solid.starts.len())];
        let mut step = || random.below(9) as f64 * 0.25 - 1.0;
        f32_point(middle + half * DVec3::new(step(), step(), step()))
    }

    fn edge(&self, random: &mut Random) -> [u32; 2] {
        let face = self.solid.faces[random.below(self.solid.faces.len())];
        let k = random.below(3);
        [face[k], face[(k + 1) % 3]]
    }
}

fn at_edge(target: &Target, random: &mut Random) -> Aimed {
    let (origin, edge) = (target.origin(random), target.edge(random));
    Aimed::between(target, origin, edge, random.unit())
}

fn at_vertex(target: &Target, random: &mut Random) -> Aimed {
    let origin = target.origin(random);
    let corner = random.below(target.solid.vertices.len()) as u32;
    Aimed::between(target, origin, [corner; 2], 0.0)
}

/// From the lattice: at the quarters of edges, along axes and diagonals, and
/// in an axis plane through a corner.
fn on_lattice(target: &Target, random: &mut Random) -> Aimed {
    let mut origin = target.lattice_origin(random);
    let step = |random: &mut Random| random.below(7) as f64 - 3.0;
    match random.below(4) {
        0 | 1 => {
            let edge = target.edge(random);
            Aimed::between(target, origin, edge, random.below(5) as f64 * 0.25)
        }
        2 => {
            let axis = random.below(3);
            let corner = random.below(target.solid.vertices.len()) as u32;
            let at = target.solid.vertices[corner as usize];
            // Only where the ray still starts inside.
            let inside = |&(p, half): &(DVec3, f64)| {
                let mut moved = origin;
                moved[axis] = at[axis];
                (moved - p).abs().max_element() <= half
            };
            if target.solid.starts.iter().any(inside) {
                origin[axis] = at[axis];
            }
            Aimed::between(target, origin, [corner; 2], 0.0)
        }
        _ => {
            let mut direction = DVec3::ZERO;
            while direction == DVec3::ZERO {
                direction = DVec3::new(step(random), step(random), step(random));
                // Half of the time along an axis.
                if random.coin() {
                    let axis = random.below(3);
                    (direction[(axis + 1) % 3], direction[(axis + 2) % 3]) = (0.0, 0.0);
                }
            }
            Aimed { ray: Ray::new(origin, direction), at: None }
        }
    }
}

/// Where a case has its numbers: the place, the ray, and the aimed corners
/// or two numbers below zero.
const RAY: usize = 1;
const CORNERS: usize = 7;

fn family(name: String, volume: Volume, targets: &Targets, aim: Aim) -> Family {
    let textbook = textbook::ALL.iter().map(|(kernel, _)| *kernel);
    let (makes, judges) = (Arc::clone(targets), Arc::clone(targets));
    Family {
        primitive: "mesh",
        name,
        kernels: std::iter::once(Kernel::GOLDRAY).chain(textbook).collect(),
        targets: [Metric::Leaks, Metric::DoubleHits, Metric::WrongIdentity, Metric::NotFinite]
            .map(|metric| (metric, Some(0.0)))
            .to_vec(),
        volume,
        generate: Box::new(move |random| {
            let place = random.below(makes.len());
            let Some(target) = makes.get(place) else { return Case::EMPTY };
            let Aimed { ray, at } = aim(target, random);
            let [a, b] = at.map_or([-1.0; 2], |at| at.map(f64::from));
            Case::EMPTY.with(place as f64).with_ray(&ray).with(a).with(b)
        }),
        judge: Box::new(move |case, tallies| {
            if let Some(target) = judges.get(case.number(0) as usize) {
                judge(target, case, tallies);
            }
        }),
    }
}

fn judge(target: &Target, case: &Case, tallies: &mut [Tally]) {
    let Some((ours, textbook)) = tallies.split_first_mut() else { return };
    let ray = case.ray(RAY);
    let corners = [case.number(CORNERS), case.number(CORNERS + 1)];
    let at = (corners[0] >= 0.0).then(|| corners.map(|i| i as usize));
    let crossings = target.mesh.crossings(&ray, Interval::AHEAD) as usize;
    ours.case();
    // The closest hit walks the same boxes in another order: for some is enough.
    if !one_in(CLOSEST, case) {
        count(crossings > 0, crossings, target.once, ours);
        return;
    }
    let contact = target.mesh.intersect(&ray, Interval::AHEAD);
    count(contact.is_some(), crossings, target.once, ours);
    if let Some(contact) = contact {
        if !contact.t.is_finite() {
            ours.count(Metric::NotFinite);
        }
        if target.once && at.is_some() && !is_aimed(&contact) {
            ours.count(Metric::WrongIdentity);
        }
    }
    if !is_sampled(case, target) {
        return;
    }
    let near = near(target, at, contact.as_ref());
    for ((_, test), tally) in textbook::ALL.iter().zip(textbook) {
        tally.case();
        let hits = textbook::hits(&target.solid, &near, &ray, *test);
        count(hits > 0, hits, target.once, tally);
    }
}

/// Whether the hit is where the ray was aimed, at `t = 1`: an error of a
/// millionth is far above all rounding and far below the other side.
fn is_aimed(contact: &Contact) -> bool {
    (contact.t - 1.0).abs() < 1e-6
}

fn count(hit: bool, crossings: usize, once: bool, tally: &mut Tally) {
    if !hit || crossings == 0 {
        tally.count(Metric::Leaks);
    } else if (once && crossings > 1) || crossings.is_multiple_of(2) {
        tally.count(Metric::DoubleHits);
    }
}

/// The triangles around what the ray was aimed at, or else around what it hit.
fn near(target: &Target, at: Option<[usize; 2]>, contact: Option<&Contact>) -> Vec<u32> {
    let corners = match (at, contact) {
        (Some(at), _) => at.to_vec(),
        (None, Some(hit)) => target.solid.faces[hit.part as usize].map(|i| i as usize).to_vec(),
        (None, None) => Vec::new(),
    };
    let mut near: Vec<u32> =
        corners.iter().filter_map(|&i| target.rings.get(i)).flatten().copied().collect();
    near.sort_unstable();
    near.dedup();
    near
}

/// Two to this power is how many cases there are to one whose closest hit is
/// asked for as well.
const CLOSEST: u32 = 2;

/// Whether the textbook kernels are asked too: they have no accelerator, so
/// this is one case in 64, and one in 512 of large meshes.
fn is_sampled(case: &Case, target: &Target) -> bool {
    const LARGE: usize = 10_000;
    one_in(if target.solid.faces.len() > LARGE { 9 } else { 6 }, case)
}

/// True for one case in `2^bits`, and for fewer bits wherever it is for more.
fn one_in(bits: u32, case: &Case) -> bool {
    /// FNV-1a's prime.
    const PRIME: u64 = 0x0100_0000_01b3;
    let stir = |h: u64, x: &f64| (h ^ x.to_bits() ^ x.to_bits() >> 32).wrapping_mul(PRIME);
    let hash = case.numbers().iter().fold(0, stir);
    hash >> (64 - bits) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_law_that_a_solid_is_held_to_is_what_exact_predicates_say() {
        for (name, make, _) in SOLIDS {
            let targets = targets(&make());
            assert_eq!(targets.len(), PLACES.len());
            let once: Vec<bool> = targets.iter().map(|target| target.once).collect();
            let folded = matches!(name, "fine-sphere" | "needle-poles");
            let expected =
                if name == "torus" { [false; 5] } else { [true, !folded, true, true, true] };
            assert_eq!(once, expected, "{name}");
        }
    }
}
