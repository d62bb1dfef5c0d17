//! What must hold for every shape, whatever its formula.
//!
//! To cover a new shape, add its line to `shapes`.
#![allow(clippy::unwrap_used, clippy::panic)]

use tracer::accel::Build;
use tracer::glam::{DVec3, dvec3};
use tracer::shape::{AxisBox, Disk, Geometry, Mesh, Plane, Shape, Sphere, Triangle};
use tracer::{Group, Interval, Material, Member, Object, Ray, Transform};

/// Random numbers with a fixed seed.
struct Any(fastrand::Rng);

impl Any {
    fn new(seed: u64) -> Self {
        Self(fastrand::Rng::with_seed(seed))
    }

    /// From -1 to 1.
    fn number(&mut self) -> f64 {
        2.0 * self.0.f64() - 1.0
    }

    /// In the cube from -1 to 1.
    fn point(&mut self) -> DVec3 {
        dvec3(self.number(), self.number(), self.number())
    }

    /// Not shorter than 0.1.
    fn direction(&mut self) -> DVec3 {
        std::iter::repeat_with(|| self.point()).find(|d| d.length() > 0.1).unwrap()
    }

    /// From outside or inside the cube, aimed near it; directions of many
    /// lengths.
    fn ray(&mut self) -> Ray {
        let origin = self.point() * 3.0;
        let length = [1e-3, 0.3, 1.0, 40.0][self.0.usize(0..4)];
        Ray::new(origin, (self.point() - origin) * length)
    }
}

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
        sample(
            "mesh",
            Mesh::new(vec![a, b, c], vec![[0, 1, 2]], None, Build::Bvh).unwrap(),
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
        let pairs: [(Shape, Shape); 5] = [
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
        ];
        for (one, other) in pairs {
            let t = |shape: &Shape, ray| shape.intersect(ray, AHEAD).map(|c| c.t);
            assert_eq!(t(&one, &ray), t(&other, &flipped), "{one:?} {ray:?}");
        }
    }
}

#[test]
fn rays_that_leave_a_surface_do_not_meet_it_again_at_once() {
    for_every_shape(6, |Sample { name, shape, .. }, ray, any| {
        let object = Object::new(shape.clone(), Material::Normal);
        let world = Group::world(vec![Member::Object(object)]);
        let Some(hit) = world.intersect(&ray, AHEAD) else {
            return false;
        };
        for _ in 0..4 {
            let direction = any.direction();
            let outward = direction.dot(*hit.geometric_normal) >= 0.0;
            let again = world.intersect(&hit.leaving(direction), AHEAD);
            let closed = matches!(shape, Shape::Sphere(_) | Shape::AxisBox(_));
            if outward || !closed {
                // Every shape here is convex or flat.
                assert_eq!(again.map(|h| h.t), None, "{name} {ray:?} leaving along {direction}");
            } else {
                let far = again.unwrap_or_else(|| panic!("{name} {ray:?}: no far side"));
                let chord = (far.point - hit.point).length();
                assert!(chord > 1e-9 || direction.dot(*hit.geometric_normal).abs() < 1e-6);
            }
        }
        true
    });
}

#[test]
fn moving_shape_and_ray_together_moves_the_hit() {
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
            assert!((expected - other.point).length() < 1e-6, "{name} {ray:?}");
            assert!(there.bounds().contains(other.point, 1e-9), "{name} {ray:?}");
            // The normal stays across every tangent.
            let tangent = one.geometric_normal.any_orthonormal_vector();
            let moved_tangent = there_from_here(&transform, one.point + tangent) - expected;
            assert!(other.geometric_normal.dot(moved_tangent).abs() < 1e-9, "{name} {ray:?}");
        }
        one.is_some() && other.is_some()
    });
}

/// A point through the transform, by way of a hit.
fn there_from_here(transform: &Transform, point: DVec3) -> DVec3 {
    let plane = Plane::new(point, DVec3::Z).unwrap();
    let ray = Ray::new(point + DVec3::Z, -DVec3::Z);
    let object = Object::new(plane.into(), Material::Normal);
    let hit = Group::world(vec![Member::Object(object)]).intersect(&ray, AHEAD).unwrap();
    transform.parent_from_object(tracer::Hit { point, ..hit }).point
}

#[test]
fn the_hierarchy_gives_the_answers_of_the_list() {
    let mut any = Any::new(8);
    let mut hits = 0;
    for round in 0..60 {
        // Few and many, spread out and on one spot, with planes among them,
        // and with copies, whose ties the first must win.
        let spread = [1.0, 0.05, 0.0][round % 3];
        let mut members = Vec::new();
        for _ in 0..[3, 20, 150][round / 3 % 3] {
            let center = any.point() * spread;
            let shape: Shape = match any.0.u8(0..20) {
                0 => Plane::new(center, any.direction()).unwrap().into(),
                1..5 => Disk::new(center, any.direction(), 0.2).unwrap().into(),
                5..10 => AxisBox::new(center - 0.05, center + 0.05).unwrap().into(),
                10..15 => {
                    let corner = |p: DVec3| center + 0.2 * p;
                    let (a, b, c) = (any.point(), any.point(), any.point());
                    Triangle::new(corner(a), corner(b), corner(c)).unwrap().into()
                }
                _ => Sphere::new(center, 0.1).unwrap().into(),
            };
            for _ in 0..any.0.u8(1..3) {
                members.push(Member::Object(Object::new(shape.clone(), Material::Normal)));
            }
        }
        let scene = |build| {
            let group = Group::new(Transform::IDENTITY, members.clone(), build);
            numbered(group)
        };
        let (list, bvh) = (scene(Build::List), scene(Build::Bvh));
        for _ in 0..2_000 {
            let mut ray = any.ray();
            if any.0.bool() {
                // Axis-parallel rays have infinite reciprocals.
                let axis = any.0.usize(0..3);
                ray.direction = DVec3::ZERO;
                ray.direction[axis] = any.number();
            }
            let range = Interval::new(0.0, [f64::INFINITY, 1.0, 0.3][any.0.usize(0..3)]);
            let (one, other) = (list.intersect(&ray, range), bvh.intersect(&ray, range));
            assert_eq!(one, other, "{ray:?}");
            assert_eq!(list.occludes(&ray, range), bvh.occludes(&ray, range), "{ray:?}");
            hits += u32::from(one.is_some());
        }
    }
    assert!(hits > 10_000, "{hits} hits are too few to say anything");
}

/// The group with its objects numbered, as a scene numbers them.
fn numbered(group: Group) -> Group {
    let camera = tracer::Camera::look_at(DVec3::Z, DVec3::ZERO, DVec3::Y, 40.0, 1.0).unwrap();
    let parts = tracer::SceneParts {
        camera,
        size: tracer::Size { width: 1, height: 1 },
        samples: tracer::SampleGrid::ONE,
        world: group,
        lights: Vec::new(),
        convention: tracer::Convention::Classic,
        shadows: true,
        background: tracer::Rgb::BLACK,
        exposure: 1.0,
        show: tracer::Show::Shaded,
    };
    tracer::Scene::new(parts).unwrap().world().clone()
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
