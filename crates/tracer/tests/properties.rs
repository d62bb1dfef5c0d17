//! What must hold for every shape, whatever its formula.
//!
//! To cover a new shape, add its line to `shapes`.
#![allow(clippy::unwrap_used, clippy::panic)]

mod random;

use random::{Any, there_from_here};
use tracer::accel::Build;
use tracer::glam::{DVec3, dvec3};
use tracer::shape::{
    AxisBox, Cone, Cylinder, Disk, Geometry, Mesh, Plane, Shape, Sphere, Torus, Triangle,
};
use tracer::{Group, Interval, Material, Member, Object, Ray, Transform};

/// A shape with how far a point is from it, where it is near.
struct Sample {
    name: &'static str,
    shape: Shape,
    distance: Box<dyn Fn(DVec3) -> f64>,
}

fn sample<S: Into<Shape>>(
    name: &'static str,
    shape: S,
    distance: impl Fn(DVec3) -> f64 + 'static,
) -> Sample {
    Sample { name, shape: shape.into(), distance: Box::new(distance) }
}

/// One of every shape.
fn shapes(any: &mut Any) -> Vec<Sample> {
    let (center, normal) = (any.point(), any.direction());
    let radius = 0.1 + any.0.f64();
    let [a, b, c] = [any.point(), any.point(), any.point()];
    let (min, max) = (a.min(b), a.max(b));
    let plane = |p: DVec3, n: DVec3| move |x: DVec3| (x - p).dot(n.normalize()).abs();
    let face = (b - a).cross(c - a);
    // Distances from the sides, unended, of the cylinder and the cone from `a` to `b`.
    let axis = b - a;
    let off_axis = move |x: DVec3| (x - a).cross(axis).length() / axis.length();
    let off_tube = move |x: DVec3| (off_axis(x) - radius).abs();
    let off_funnel = move |x: DVec3| {
        let height = (x - a).dot(axis) / axis.length();
        (axis.length() * off_axis(x) - radius * height).abs()
            / (axis.length_squared() + radius * radius).sqrt()
    };
    vec![
        sample("sphere", Sphere::new(center, radius).unwrap(), move |x| {
            ((x - center).length() - radius).abs()
        }),
        sample("triangle", Triangle::new(a, b, c).unwrap(), plane(a, face)),
        sample("box", AxisBox::new(min, max).unwrap(), move |x| {
            (x - min).abs().min((x - max).abs()).min_element()
        }),
        sample("plane", Plane::new(center, normal).unwrap(), plane(center, normal)),
        sample("disk", Disk::new(center, normal, radius).unwrap(), plane(center, normal)),
        sample("cylinder", Cylinder::new(a, b, radius, true).unwrap(), move |x| {
            off_tube(x).min(plane(a, axis)(x)).min(plane(b, axis)(x))
        }),
        sample("tube", Cylinder::new(a, b, radius, false).unwrap(), off_tube),
        sample("cone", Cone::new(a, b, radius, true).unwrap(), move |x| {
            off_funnel(x).min(plane(b, axis)(x))
        }),
        sample("funnel", Cone::new(a, b, radius, false).unwrap(), off_funnel),
        sample("torus", Torus::new(center, normal, 2.0 * radius, radius).unwrap(), move |x| {
            let n = normal.normalize();
            let z = (x - center).dot(n);
            let rho = ((x - center) - z * n).length();
            let e = rho - 2.0 * radius;
            ((e * e + z * z).sqrt() - radius).abs()
        }),
        // Six times the same triangle: enough for a hierarchy, still flat.
        sample(
            "mesh",
            Mesh::new(vec![a, b, c], vec![[0, 1, 2]; 6], None, Build::Bvh).unwrap(),
            plane(a, face),
        ),
    ]
}

/// Runs `property` on many rays against every shape; it returns whether the
/// ray hit, so that a property that was never put to the test is noticed.
fn for_every_shape(seed: u64, mut property: impl FnMut(&Sample, Ray, &mut Any) -> bool) {
    let mut any = Any::new(seed);
    let mut hits = std::collections::BTreeMap::new();
    for _ in 0..300 {
        for sample in shapes(&mut any) {
            for _ in 0..30 {
                let ray = any.ray();
                let hit = property(&sample, ray, &mut any);
                *hits.entry(sample.name).or_insert(0) += u32::from(hit);
            }
        }
    }
    for (name, hits) in hits {
        assert!(hits > 300, "{name}: {hits} hits are too few to say anything");
    }
}

const AHEAD: Interval = Interval::AHEAD;

#[test]
fn hits_are_on_the_surface_in_the_bounds_and_in_the_interval() {
    for_every_shape(1, |Sample { name, shape, distance }, ray, any| {
        let (lo, hi) = (any.0.f64(), 1.0 + 2.0 * any.0.f64());
        for range in [AHEAD, Interval::new(lo, hi)] {
            let Some(contact) = shape.intersect(&ray, range) else {
                continue;
            };
            assert!(range.contains(contact.t), "{name} {ray:?}");
            let surface = shape.surface(&ray, &contact);
            let off = distance(surface.point);
            assert!(off <= surface.error.max(1e-15), "{name} {ray:?}: {off} off the surface");
            let along = (ray.at(contact.t) - surface.point).length();
            assert!(along < 1e-9, "{name} {ray:?}: {along} off the ray");
            assert!(shape.bounds().contains(surface.point, 1e-12), "{name} {ray:?}");
            assert!((surface.geometric_normal.length() - 1.0).abs() < 1e-15, "{name}");
        }
        shape.intersect(&ray, AHEAD).is_some()
    });
}

#[test]
fn the_interval_is_open_and_the_hit_the_first_in_it() {
    for_every_shape(2, |Sample { name, shape, .. }, ray, _| {
        let Some(first) = shape.intersect(&ray, AHEAD) else {
            return false;
        };
        let before = shape.intersect(&ray, AHEAD.until(first.t));
        assert_eq!(before, None, "{name} {ray:?}");
        let just_after = shape.intersect(&ray, AHEAD.until(first.t.next_up()));
        assert_eq!(just_after, Some(first), "{name} {ray:?}");
        if let Some(next) = shape.intersect(&ray, Interval::new(first.t, f64::INFINITY)) {
            assert!(next.t > first.t, "{name} {ray:?}");
        }
        true
    });
}

#[test]
fn occlusion_is_a_hit() {
    for_every_shape(3, |Sample { name, shape, .. }, ray, any| {
        let range = Interval::new(0.0, 3.0 * any.0.f64());
        let hit = shape.intersect(&ray, range).is_some();
        assert_eq!(shape.occludes(&ray, range), hit, "{name} {ray:?}");
        hit
    });
}

#[test]
fn a_longer_direction_shortens_t_and_moves_nothing() {
    for_every_shape(4, |Sample { name, shape, .. }, ray, _| {
        let longer = Ray::new(ray.origin, ray.direction * 4.0);
        let (one, four) = (shape.intersect(&ray, AHEAD), shape.intersect(&longer, AHEAD));
        assert_eq!(one.map(|c| c.t), four.map(|c| 4.0 * c.t), "{name} {ray:?}");
        one.is_some()
    });
}

#[test]
fn mirrored_shapes_and_rays_have_mirrored_hits_to_the_bit() {
    let flip = |p: DVec3| dvec3(-p.x, p.y, p.z);
    let mut any = Any::new(5);
    for _ in 0..20_000 {
        let ray = any.ray();
        let flipped = Ray::new(flip(ray.origin), flip(ray.direction));
        let [a, b, c] = [any.point(), any.point(), any.point()];
        let (center, normal, radius) = (any.point(), any.direction(), any.0.f64() + 0.1);
        let (min, max) = (a.min(b), a.max(b));
        let (flipped_min, flipped_max) = (dvec3(-max.x, min.y, min.z), dvec3(-min.x, max.y, max.z));
        let cylinder = |a, b, caps| -> Shape { Cylinder::new(a, b, radius, caps).unwrap().into() };
        let cone = |a, b, caps| -> Shape { Cone::new(a, b, radius, caps).unwrap().into() };
        let pairs: [(Shape, Shape); 10] = [
            (
                Sphere::new(center, radius).unwrap().into(),
                Sphere::new(flip(center), radius).unwrap().into(),
            ),
            (
                Triangle::new(a, b, c).unwrap().into(),
                Triangle::new(flip(a), flip(b), flip(c)).unwrap().into(),
            ),
            (
                AxisBox::new(min, max).unwrap().into(),
                AxisBox::new(flipped_min, flipped_max).unwrap().into(),
            ),
            (
                Plane::new(center, normal).unwrap().into(),
                Plane::new(flip(center), flip(normal)).unwrap().into(),
            ),
            (
                Disk::new(center, normal, radius).unwrap().into(),
                Disk::new(flip(center), flip(normal), radius).unwrap().into(),
            ),
            (
                Torus::new(center, normal, 2.0 * radius, radius).unwrap().into(),
                Torus::new(flip(center), flip(normal), 2.0 * radius, radius).unwrap().into(),
            ),
            (cylinder(a, b, true), cylinder(flip(a), flip(b), true)),
            (cylinder(a, b, false), cylinder(flip(a), flip(b), false)),
            (cone(a, b, true), cone(flip(a), flip(b), true)),
            (cone(a, b, false), cone(flip(a), flip(b), false)),
        ];
        for (one, other) in pairs {
            let t = |shape: &Shape, ray| shape.intersect(ray, AHEAD).map(|c| c.t);
            assert_eq!(t(&one, &ray), t(&other, &flipped), "{one:?} {ray:?}");
        }
    }
}

/// The same ray without its knowledge of what it leaves.
fn unknowing(ray: Ray) -> Ray {
    Ray { leaving: None, ..ray }
}

/// How often a ray crosses a surface.
fn count_crossings(world: &Group, ray: Ray) -> u32 {
    let hits = std::iter::successors(world.intersect(&ray, AHEAD), |hit| {
        world.intersect(&ray, Interval::new(hit.t, f64::INFINITY))
    });
    hits.map(|_| 1).sum()
}

#[test]
fn rays_that_leave_a_surface_do_not_meet_it_again_at_once() {
    for stretch in [1.0, 100.0, 1e4, 1e-3] {
        for_every_shape(6, |Sample { name, shape, .. }, ray, any| {
            let object = Object::new(shape.clone(), Material::Normal);
            let transform =
                if stretch == 1.0 { Transform::IDENTITY } else { any.stretching(stretch) };
            let world = Group::new(transform, vec![Member::Object(object)], Build::Bvh);
            let to = |p| there_from_here(&transform, p);
            let ray = Ray::new(to(ray.origin), to(ray.origin + ray.direction) - to(ray.origin));
            let Some(hit) = world.intersect(&ray, AHEAD) else { return false };
            let is_solid = matches!(*name, "sphere" | "box" | "cylinder" | "cone");
            // From inside, these are met on the far side or not at all.
            let is_open = matches!(*name, "tube" | "funnel");
            for _ in 0..4 {
                let direction = any.direction();
                let cosine = direction.normalize().dot(*hit.geometric_normal);
                let outward = cosine >= 0.0;
                let leaving = hit.leaving(direction);
                if *name == "torus" {
                    // Out of a torus one may get in again, but then also out.
                    let crossings = count_crossings(&world, leaving);
                    assert_eq!(crossings % 2, u32::from(!outward), "{name} x {stretch}, {ray:?}");
                    continue;
                }
                let again = world.intersect(&leaving, AHEAD);
                // Every other shape is convex or flat.
                if outward || !(is_solid || is_open) {
                    let t = again.map(|h| h.t);
                    assert_eq!(t, None, "{name} x {stretch}, {ray:?} leaving along {direction}");
                    // The offset alone does it for all but the flattest rays.
                    let t = world.intersect(&unknowing(leaving), AHEAD).map(|h| h.t);
                    let flat = cosine.abs() < 1e-6;
                    assert!(flat || t.is_none(), "{name} x {stretch}, {ray:?} unknowing: {t:?}");
                } else if stretch == 1.0 && (is_solid || again.is_some()) {
                    let far = again.unwrap_or_else(|| panic!("{name} {ray:?}: no far side"));
                    let flat = cosine.abs() < 1e-6;
                    assert!(flat || (far.point - hit.point).length() > 1e-9, "{name}");
                }
            }
            true
        });
    }
}

#[test]
fn moving_shape_and_ray_together_moves_the_hit() {
    let mut flips = 0;
    for_every_shape(7, |Sample { name, shape, .. }, ray, any| {
        let turn = Transform::rotation_deg(any.point() * 180.0).unwrap();
        let scale = any.point().map(|x| x + 1.5f64.copysign(x));
        let transform = turn
            .then(Transform::scale(scale).unwrap())
            .and_then(|t| t.then(Transform::translation(any.point() * 10.0)?))
            .unwrap();
        let object = || Member::Object(Object::new(shape.clone(), Material::Normal));
        let here = Group::world(vec![object()]);
        let there = Group::new(transform, vec![object()], Build::Bvh);
        // The ray that the transform takes to this one.
        let moved_origin = there_from_here(&transform, ray.origin);
        let moved = Ray::new(
            moved_origin,
            there_from_here(&transform, ray.origin + ray.direction) - moved_origin,
        );
        let (one, other) = (here.intersect(&ray, AHEAD), there.intersect(&moved, AHEAD));
        if let (Some(one), Some(other)) = (one, other) {
            assert!((one.t - other.t).abs() <= 1e-6 * one.t.max(1e-3), "{name} {ray:?}");
            let expected = there_from_here(&transform, one.point);
            // A plane may be met far away.
            let off = (expected - other.point).length();
            assert!(off < 1e-6 * one.point.length().max(1.0), "{name} {ray:?}: {off}");
            assert!(there.bounds().contains(other.point, 1e-9), "{name} {ray:?}");
            // The normal stays across every tangent.
            let tangent = one.geometric_normal.any_orthonormal_vector();
            let moved_tangent = there_from_here(&transform, one.point + tangent) - expected;
            assert!(other.geometric_normal.dot(moved_tangent).abs() < 1e-9, "{name} {ray:?}");
        }
        // At a silhouette, rounding may decide: one in a thousand at most.
        flips += u32::from(one.is_some() != other.is_some());
        one.is_some() && other.is_some()
    });
    assert!(flips < 99, "{flips} of 99,000 rays hit only before or only after the move");
}

#[test]
fn special_numbers_never_make_a_hit_that_is_not_one() {
    let special = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        5e-324,
        f64::MIN_POSITIVE,
        f64::MAX,
        1e20,
        -1e-20,
    ];
    let mut any = Any::new(9);
    for _ in 0..3_000 {
        for Sample { name, shape, .. } in shapes(&mut any) {
            let mut ray = any.ray();
            let mut range = AHEAD;
            for _ in 0..any.0.usize(1..4) {
                let number = special[any.0.usize(0..special.len())];
                match any.0.usize(0..8) {
                    slot @ 0..3 => ray.origin[slot] = number,
                    slot @ 3..6 => ray.direction[slot - 3] = number,
                    6 => range.lo = number,
                    _ => range.hi = number,
                }
            }
            if let Some(contact) = shape.intersect(&ray, range) {
                assert!(contact.t.is_finite() && range.contains(contact.t), "{name} {ray:?}");
                let finite = ray.origin.is_finite() && ray.direction.is_finite();
                assert!(finite, "{name} hit by {ray:?}");
            }
        }
    }
}
