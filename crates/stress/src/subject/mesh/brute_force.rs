//! The hierarchy against the list, on meshes of 20 to 200 triangles: the same
//! triangle at the same `t` to the bit, the same number of crossings, the same
//! shadows.

use std::sync::{Arc, LazyLock};

use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::shape::{Contact, Geometry, Mesh};
use tracer::{Interval, Ray};

use crate::family::{Family, Kernel, Volume};
use crate::{Case, Metric, Random};

/// Makes about that many triangles.
pub(super) type Make = fn(&mut Random, usize) -> Soup;

pub(super) const KINDS: [(&str, Make); 6] = [
    ("soup", soup),
    ("lattice", lattice),
    ("flat-squares", flat),
    ("duplicates", duplicates),
    ("beams", beams),
    ("slivers", slivers),
];

/// How many meshes of each kind there are.
pub(super) const MESHES: u64 = 32;

pub(super) fn families() -> Vec<Family> {
    KINDS.iter().map(|&(name, make)| family(name, make)).collect()
}

/// Triangles, with a corner of their own each or shared.
pub(super) struct Soup {
    vertices: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
}

/// The same triangles in a list and in a hierarchy.
pub(super) struct Pair {
    soup: Soup,
    pub(super) list: Mesh,
    pub(super) bvh: Mesh,
    scale: f64,
    offset: DVec3,
}

/// Triangles of all sizes and shapes.
fn soup(random: &mut Random, count: usize) -> Soup {
    let mut vertices = Vec::new();
    for _ in 0..count {
        let (center, size) = (random.point(), random.decades(0.01, 0.5));
        vertices
            .extend([random.point(), random.point(), random.point()].map(|p| center + size * p));
    }
    Soup { vertices, faces: own_corners(count) }
}

/// Corners at multiples of a quarter, so that many share coordinates and lie
/// in one plane.
fn lattice(random: &mut Random, count: usize) -> Soup {
    let on = |p: DVec3| (p * 4.0).round() * 0.25;
    let mut vertices = Vec::new();
    for _ in 0..count {
        let center = random.point();
        vertices
            .extend([random.point(), random.point(), random.point()].map(|p| on(center + 0.4 * p)));
    }
    Soup { vertices, faces: own_corners(count) }
}

/// Squares of eighths, each two triangles in an axis plane: their boxes have
/// no thickness, and many lie in one plane.
fn flat(random: &mut Random, count: usize) -> Soup {
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for _ in 0..count / 2 {
        let axis = random.below(3);
        let corner = (random.point() * 4.0).round() * 0.25;
        let (mut u, mut v) = (DVec3::ZERO, DVec3::ZERO);
        (u[(axis + 1) % 3], v[(axis + 2) % 3]) = (0.125, 0.125);
        let first = vertices.len() as u32;
        vertices.extend([corner, corner + u, corner + u + v, corner + v]);
        faces.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    Soup { vertices, faces }
}

/// Every triangle three times, far apart in the order: the first must win.
fn duplicates(random: &mut Random, count: usize) -> Soup {
    let Soup { vertices, faces } = soup(random, count.div_ceil(3));
    let turned = |[a, b, c]: [u32; 3]| [b, c, a];
    let other = faces.iter().rev().map(|&face| turned(face));
    let faces = faces.iter().copied().chain(other).chain(faces.iter().copied()).collect();
    Soup { vertices, faces }
}

/// What buildings are made of: beams along and across the axes, each two triangles
/// of up to 1 by 1,000, that the hierarchy cuts into parts.
fn beams(random: &mut Random, count: usize) -> Soup {
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for _ in 0..count / 2 {
        let corner = random.point();
        let axis = random.below(3);
        let mut along = random.one_of(&[0.0, 0.0, 0.3]) * random.point();
        along[axis] += random.sign();
        let across = random.decades(1e-3, 0.1) * random.across(along);
        let first = vertices.len() as u32;
        vertices.extend([corner, corner + along, corner + along + across, corner + across]);
        faces.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    Soup { vertices, faces }
}

/// Triangles that rounding leaves a width of a few last places, or none, all over
/// each other.
fn slivers(random: &mut Random, count: usize) -> Soup {
    let mut vertices = Vec::new();
    for _ in 0..count {
        let (a, b) = (random.point(), random.point());
        let c =
            a + random.between(-2.0, 2.0) * (b - a) + random.decades(1e-18, 1e-9) * random.point();
        vertices.extend([a, b, c]);
    }
    Soup { vertices, faces: own_corners(count) }
}

fn own_corners(count: usize) -> Vec<[u32; 3]> {
    (0..count as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect()
}

pub(super) fn pair(kind: &str, make: Make, number: u64) -> Option<Pair> {
    let mut random = Random::of_chunk(0, kind, number);
    let count = random.decades(20.0, 200.0) as usize;
    let scale = random.one_of(&[1.0, 1.0, 1e-6, 1e10]);
    let offset = scale * random.one_of(&[0.0, 0.0, 1.0, 1e5]) * random.point();
    let mut soup = make(&mut random, count);
    for vertex in &mut soup.vertices {
        *vertex = offset + scale * *vertex;
    }
    let mesh = |build| Mesh::new(soup.vertices.clone(), soup.faces.clone(), None, build).ok();
    Some(Pair { list: mesh(Build::List)?, bvh: mesh(Build::Bvh)?, soup, scale, offset })
}

/// A ray of any kind that stresses box tests.
pub(super) fn ray(pair: &Pair, random: &mut Random) -> Ray {
    let Pair { soup, scale, offset, .. } = pair;
    let face = soup.faces[random.below(soup.faces.len())];
    let [a, b] = [face[0], face[1 + random.below(2)]].map(|i| soup.vertices[i as usize]);
    // A corner, a point of an edge, or anywhere.
    let target = match random.below(4) {
        0 => a,
        1 => a + random.unit() * (b - a),
        2 => a + random.below(5) as f64 * 0.25 * (b - a),
        _ => *offset + *scale * random.point(),
    };
    let far = random.one_of(&[1.0, 1.0, 3.0, 1e5]);
    let way = match random.below(4) {
        0 => axis(random),
        // In an axis plane.
        1 => {
            let mut way = random.direction();
            way[random.below(3)] = 0.0;
            way
        }
        // Along an edge, and so along its triangle.
        2 if a != b => (b - a) / (b - a).length(),
        _ => random.direction(),
    };
    let length = random.one_of(&[1.0, 1e-3, 1e6]);
    Ray::new(target - way * (scale * far * random.unit()), way * (scale * length))
}

fn axis(random: &mut Random) -> DVec3 {
    let mut way = DVec3::ZERO;
    way[random.below(3)] = random.sign();
    way
}

/// Ahead, or an interval that ends at, just after or around a hit.
pub(super) fn range(pair: &Pair, ray: &Ray, random: &mut Random) -> Interval {
    let hit = pair.bvh.intersect(ray, Interval::AHEAD).map_or(1.0, |contact| contact.t);
    match random.below(8) {
        0 => Interval::AHEAD.until(hit),
        1 => Interval::AHEAD.until(hit.next_up()),
        2 => Interval::new(hit, f64::INFINITY),
        3 => Interval::new(random.unit() * hit, 3.0 * random.unit() * hit),
        _ => Interval::AHEAD,
    }
}

/// Where a case has its ray and its interval, after the number of its mesh.
const RAY: usize = 1;
const RANGE: usize = 7;

type Pairs = Arc<LazyLock<Vec<Pair>, Box<dyn FnOnce() -> Vec<Pair> + Send>>>;

fn family(name: &'static str, make: Make) -> Family {
    let all = move || (0..MESHES).filter_map(|i| pair(name, make, i)).collect();
    let makes: Pairs = Arc::new(LazyLock::new(Box::new(all)));
    let judges = Arc::clone(&makes);
    Family {
        primitive: "mesh",
        name: format!("brute-force/{name}"),
        kernels: vec![Kernel::GOLDRAY],
        targets: vec![(Metric::Disagreements, Some(0.0)), (Metric::NotFinite, Some(0.0))],
        volume: Volume { quick: 100_000, full: 25_000_000 },
        generate: Box::new(move |random| {
            let number = random.below(makes.len());
            let Some(pair) = makes.get(number) else { return Case::EMPTY };
            let ray = ray(pair, random);
            let range = range(pair, &ray, random);
            Case::EMPTY.with(number as f64).with_ray(&ray).with(range.lo).with(range.hi)
        }),
        judge: Box::new(move |case, tallies| {
            let Some(Pair { list, bvh, .. }) = judges.get(case.number(0) as usize) else { return };
            let ray = case.ray(RAY);
            let range = Interval::new(case.number(RANGE), case.number(RANGE + 1));
            let (one, other) = (list.intersect(&ray, range), bvh.intersect(&ray, range));
            // One ray in four also counts what is behind the first hit.
            let count = case.number(RAY).to_bits().count_ones() % 4 == 0;
            let agree = bits(one) == bits(other)
                && bvh.occludes(&ray, range) == one.is_some()
                && (!count || list.crossings(&ray, range) == bvh.crossings(&ray, range));
            for tally in tallies {
                tally.case();
                if !agree {
                    tally.count(Metric::Disagreements);
                }
                if other.is_some_and(|contact| !contact.t.is_finite()) {
                    tally.count(Metric::NotFinite);
                }
            }
        }),
    }
}

pub(super) fn bits(contact: Option<Contact>) -> Option<(u64, u32, [u64; 2])> {
    contact.map(|c| (c.t.to_bits(), c.part, c.barycentric.map(f64::to_bits)))
}
