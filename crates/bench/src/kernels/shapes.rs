//! Every shape's test, for rays that hit it, pass it and leave it.

use tracer::glam::DVec3;
use tracer::shape::{
    AxisBox, Cone, Cylinder, Departure, Disk, Geometry, Plane, Sphere, Torus, Triangle,
};
use tracer::{Interval, Ray, Refused};

use super::{CASES, Kernel};
use crate::random::Random;

/// From where rays start that do not leave the shape, in its own size.
const FAR: f64 = 5.0;

/// Rays are aimed at a cube of this half side, which a shape of size 1 fills to
/// about a half: so those that miss pass close by.
const AIM: f64 = 1.2;

/// All shapes but meshes, which `bench trace` measures.
pub(super) fn all() -> Result<Vec<Kernel>, String> {
    let mut all = Vec::new();
    all.extend(of_shape("sphere", |random| {
        Sphere::new(random.point() * 0.3, random.between(0.5, 1.0))
    })?);
    all.extend(of_shape("triangle", |random| {
        Triangle::new(random.direction(), random.direction(), random.direction())
    })?);
    all.extend(of_shape("box", |random| {
        let half = DVec3::ONE * 0.3 + random.point().abs() * 0.6;
        let middle = random.point() * 0.3;
        AxisBox::new(middle - half, middle + half)
    })?);
    all.extend(of_shape("plane", |random| Plane::new(random.point() * 0.5, random.direction()))?);
    all.extend(of_shape("disk", |random| {
        Disk::new(random.point() * 0.3, random.direction(), random.between(0.5, 1.0))
    })?);
    all.extend(of_shape("cylinder", |random| {
        let axis = random.direction() * 0.8;
        Cylinder::new(-axis, axis, random.between(0.3, 0.7), true)
    })?);
    all.extend(of_shape("cone", |random| {
        let axis = random.direction() * 0.8;
        Cone::new(axis, -axis, random.between(0.4, 0.8), true)
    })?);
    all.extend(of_shape("torus", |random| {
        let [ring, tube] = [random.between(0.5, 0.8), random.between(0.15, 0.35)];
        Torus::new(random.point() * 0.2, random.direction(), ring, tube)
    })?);
    Ok(all)
}

/// One shape of its kind, and a ray.
type Case<G> = (G, Ray);

/// Those that hit and those that miss.
type Sorted<G> = (Vec<Case<G>>, Vec<Case<G>>);

/// A ray that leaves the shape, and from where on it.
type Leaving<G> = (G, Ray, Departure);

/// The four kernels of a kind of shape.
fn of_shape<G: Geometry + Clone + 'static>(
    group: &'static str,
    make: impl Fn(&mut Random) -> Result<G, Refused>,
) -> Result<Vec<Kernel>, String> {
    let (hits, misses) = cases(group, make)?;
    let leaving: Vec<_> = hits.iter().filter_map(leave).collect();
    let half = CASES / 2;
    let both = [&hits[..half], &misses[..half]].concat();
    let mixed = Random::new(5).shuffled(both);
    let tests = leaving.len();
    let from = Kernel {
        group,
        name: "leaving",
        tests,
        pass: Box::new(move || {
            let t = |(shape, ray, from): &Leaving<G>| {
                shape.intersect_leaving(ray, Interval::AHEAD, *from).map_or(0.0, |c| c.t)
            };
            leaving.iter().map(t).sum()
        }),
    };
    let kernel = |name, cases| closest(group, name, cases);
    Ok(vec![kernel("hit", hits), kernel("miss", misses), kernel("hit or miss", mixed), from])
}

fn closest<G: Geometry + 'static>(
    group: &'static str,
    name: &'static str,
    cases: Vec<Case<G>>,
) -> Kernel {
    let tests = cases.len();
    let t = |(shape, ray): &Case<G>| shape.intersect(ray, Interval::AHEAD).map_or(0.0, |c| c.t);
    Kernel { group, name, tests, pass: Box::new(move || cases.iter().map(t).sum()) }
}

/// As many cases as are wanted of hits and of misses.
fn cases<G: Geometry + Clone>(
    group: &str,
    make: impl Fn(&mut Random) -> Result<G, Refused>,
) -> Result<Sorted<G>, String> {
    /// A plane is missed by few of the rays that start away from it.
    const ATTEMPTS: usize = 400 * CASES;
    let mut random = Random::new(4);
    let (mut hits, mut misses) = (Vec::new(), Vec::new());
    for _ in 0..ATTEMPTS {
        let shape = make(&mut random).map_err(|refused| format!("{group}: {refused}"))?;
        let origin = random.direction() * FAR;
        let target = random.point() * AIM;
        let ray = Ray::new(origin, (target - origin) * random.between(0.2, 2.0));
        let kind = match shape.intersect(&ray, Interval::AHEAD) {
            Some(_) => &mut hits,
            None => &mut misses,
        };
        if kind.len() < CASES {
            kind.push((shape, ray));
        }
        if hits.len() == CASES && misses.len() == CASES {
            return Ok((hits, misses));
        }
    }
    let (hits, misses) = (hits.len(), misses.len());
    Err(format!("{group}: expected {CASES} hits and misses, found {hits} and {misses}"))
}

/// A ray from where this one hits, to any side, as the tracer lets it leave.
fn leave<G: Geometry + Clone>((shape, ray): &Case<G>) -> Option<Leaving<G>> {
    let contact = shape.intersect(ray, Interval::AHEAD)?;
    let surface = shape.surface(ray, &contact);
    let normal = *surface.geometric_normal;
    // Any direction that does not repeat: the way that the ray came, turned.
    let direction = DVec3::new(ray.direction.z, ray.direction.x, ray.direction.y);
    let outward = normal.dot(direction) >= 0.0;
    let side = if outward { 1.0 } else { -1.0 };
    let origin = surface.point + normal * (side * 2.0 * surface.error);
    let from = Departure { part: contact.part, outward };
    Some((shape.clone(), Ray::new(origin, direction), from))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hits_hit_misses_miss_and_leaving_rays_go_to_both_sides() {
        let make = |random: &mut Random| Sphere::new(DVec3::ZERO, random.between(0.5, 1.0));
        let (hits, misses) = cases("sphere", make).unwrap();
        let is_hit = |(shape, ray): &Case<Sphere>| shape.intersect(ray, Interval::AHEAD).is_some();
        assert!(hits.iter().all(is_hit) && !misses.iter().any(is_hit));
        let outward = hits.iter().filter_map(leave).filter(|(_, _, from)| from.outward).count();
        assert!(outward > CASES / 10 && outward < CASES * 9 / 10, "{outward}");
    }
}
