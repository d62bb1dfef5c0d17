//! Texture coordinates against exact formulas, and textures in groups.
#![allow(clippy::unwrap_used, clippy::panic)]

mod random;

use std::sync::Arc;

use num_bigint::BigInt;
use random::{Any, there_from_here};
use tracer::accel::Build;
use tracer::glam::{DVec3, dvec3};
use tracer::shape::{Contact, Geometry, Plane, Shape, Sphere, SurfacePoint};
use tracer::texture::{Checker, Pattern};
use tracer::{Group, Interval, Material, Member, Object, Ray, Rgb, Texture, UnitVec};

/// Binary digits behind the point of [`Fixed`].
const DIGITS: u32 = 256;

/// Two to this power.
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(u64::try_from(1023 + n).unwrap() << 52)
}

/// A number as a whole multiple of `2^-DIGITS`.
type Fixed = BigInt;

/// The number itself: one of size 1 or less, and no smaller than 2^-200.
fn fixed(x: f64) -> Fixed {
    let scaled = x * power_of_two(200);
    assert!(scaled == scaled.trunc(), "{x}");
    // The mantissa by itself, as the whole is too large for an integer type.
    let (mut mantissa, mut shift) = (scaled, 0);
    while mantissa.abs() >= power_of_two(62) {
        mantissa /= 2.0;
        shift += 1;
    }
    (BigInt::from(mantissa as i64) << shift) << (DIGITS - 200)
}

fn product(a: &Fixed, b: &Fixed) -> Fixed {
    (a * b) >> DIGITS
}

fn quotient(a: &Fixed, b: &Fixed) -> Fixed {
    (a << DIGITS) / b
}

fn length(a: &Fixed, b: &Fixed) -> Fixed {
    (a * a + b * b).sqrt()
}

/// `atan2(y, x)` for a positive `x`, halved until its series is short.
fn atan(y: &Fixed, x: &Fixed) -> Fixed {
    const HALVED: u32 = 8;
    let (mut x, mut y) = (x.clone(), y.clone());
    for _ in 0..HALVED {
        // tan(a / 2) = sin(a) / (1 + cos(a)).
        let r = length(&x, &y);
        (x, y) = (quotient(&(&r + &x), &r), quotient(&y, &r));
    }
    let z = quotient(&y, &x);
    let square = product(&z, &z);
    let (mut sum, mut power) = (z.clone(), z);
    for n in 1..40_i64 {
        power = -product(&power, &square);
        sum += &power / (2 * n + 1);
    }
    sum << HALVED
}

fn pi() -> Fixed {
    let one = Fixed::from(1) << DIGITS;
    atan(&one, &one) * 4
}

/// `atan2(y, x)`.
fn atan2(y: &Fixed, x: &Fixed) -> Fixed {
    let zero = Fixed::from(0);
    if *x > zero {
        atan(y, x)
    } else if *x == zero {
        if *y < zero { -pi() / 2 } else { pi() / 2 }
    } else if *y < zero {
        atan(&-y, &-x) - pi()
    } else {
        pi() - atan(y, &-x)
    }
}

/// How far a number is from an exact one, around a circle of length 1.
fn off(found: f64, exact: &Fixed) -> f64 {
    let one = Fixed::from(1) << DIGITS;
    let half = &one / 2;
    let mut off = (fixed(found) - exact) % &one;
    if off > half {
        off -= &one;
    } else if off < -&half {
        off += &one;
    }
    // To 2^-80, which is enough digits.
    let off = off >> (DIGITS - 80);
    i128::try_from(off).unwrap() as f64 / power_of_two(80)
}

fn ball() -> Shape {
    Sphere::new(DVec3::ZERO, 1.0).unwrap().into()
}

/// The texture coordinates of a ball where it has this normal.
fn uv_at(n: UnitVec) -> [f64; 2] {
    let point = SurfacePoint { point: *n, error: 0.0, geometric_normal: n, shading_normal: n };
    ball().uv(&Contact::at(1.0), &point).unwrap()
}

/// Normals everywhere, many of them beside the poles, the seam and the axes.
fn normals() -> impl Iterator<Item = UnitVec> {
    let mut any = Any::new(11);
    (0..4_000).filter_map(move |k| {
        let mut n = any.direction();
        for axis in 0..3 {
            let small = power_of_two(-any.0.i32(1..60));
            match (k >> (2 * axis)) % 4 {
                0 => n[axis] *= small,
                1 => n[axis] = (n[axis] * small * power_of_two(60)).trunc() * power_of_two(-60),
                _ => {}
            }
        }
        UnitVec::new(n)
    })
}

#[test]
fn a_ball_has_longitude_and_latitude() {
    const BOUND: f64 = 3e-16;
    let (pi, half) = (pi(), (Fixed::from(1) << DIGITS) / 2);
    let mut worst = [0.0_f64; 2];
    for n in normals() {
        let [u, v] = uv_at(n);
        assert!((0.0..1.0).contains(&u) && (0.0..=1.0).contains(&v), "{n:?}: {u}, {v}");
        if n.x == 0.0 && n.z == 0.0 {
            continue;
        }
        let [x, y, z] = n.to_array().map(fixed);
        let exact_u = &half + quotient(&atan2(&x, &z), &(&pi * 2));
        let exact_v = &half + quotient(&atan2(&y, &length(&x, &z)), &pi);
        worst[0] = worst[0].max(off(u, &exact_u).abs());
        worst[1] = worst[1].max(off(v, &exact_v).abs());
    }
    assert!(worst.into_iter().all(|off| off < BOUND && off > 1e-17), "{worst:?}");
}

#[test]
fn poles_and_seam_have_coordinates() {
    #[track_caller]
    fn check(n: [f64; 3], expected: [f64; 2]) {
        let found = uv_at(UnitVec::new(DVec3::from_array(n)).unwrap());
        assert_eq!(found, expected, "{n:?}");
    }
    check([0.0, 1.0, 0.0], [0.5, 1.0]);
    check([-0.0, 1.0, -0.0], [0.5, 1.0]);
    check([0.0, -1.0, -0.0], [0.5, 0.0]);
    check([0.0, 0.0, 1.0], [0.5, 0.5]);
    check([1.0, 0.0, 0.0], [0.75, 0.5]);
    check([-1.0, 0.0, 0.0], [0.25, 0.5]);
    // Both sides of the seam.
    check([0.0, 0.0, -1.0], [0.0, 0.5]);
    check([-0.0, 0.0, -1.0], [0.0, 0.5]);
    check([5e-324, 0.0, -1.0], [0.0, 0.5]);
    check([-5e-324, 0.0, -1.0], [0.0, 0.5]);
    check([0.0, 1.0, 1.0], [0.5, 0.75]);
}

#[test]
fn coordinates_move_little_where_the_normal_does() {
    let mut any = Any::new(12);
    for n in normals() {
        const STEP: f64 = 1e-7;
        let near = UnitVec::new(*n + any.direction().normalize() * STEP).unwrap();
        let ([u, v], [s, t]) = (uv_at(n), uv_at(near));
        let across = (n.x * n.x + n.z * n.z).sqrt();
        let apart = (u - s).abs().min(1.0 - (u - s).abs());
        assert!((v - t).abs() < STEP, "{n:?}");
        // Around a pole, the same step goes farther around.
        assert!(across < 4.0 * STEP || apart * across < STEP, "{n:?} {near:?}");
    }
}

#[test]
fn a_plane_has_lengths_along_two_directions() {
    #[track_caller]
    fn check(normal: [f64; 3], u: [f64; 3], v: [f64; 3]) {
        let origin = dvec3(3.0, -5.0, 7.0);
        let plane = Plane::new(origin, DVec3::from_array(normal)).unwrap();
        for (along, expected) in [(u, [1.0, 0.0]), (v, [0.0, 1.0])] {
            let n = UnitVec::new(DVec3::from_array(normal)).unwrap();
            let point = origin + 2.0 * DVec3::from_array(along);
            let surface =
                SurfacePoint { point, error: 0.0, geometric_normal: n, shading_normal: n };
            let uv = Shape::from(plane).uv(&Contact::at(1.0), &surface).unwrap();
            assert_eq!(uv, expected.map(|x| 2.0 * x), "{normal:?}");
        }
    }
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let minus = |a: [f64; 3]| a.map(|c| -c);
    check([0.0, 3.0, 0.0], x, minus(z));
    check([0.0, -3.0, 0.0], x, z);
    check([0.0, 0.0, 2.0], x, y);
    check([0.0, 0.0, -2.0], minus(x), y);
    check([0.5, 0.0, 0.0], minus(z), y);
    check([-0.5, 0.0, 0.0], z, y);
}

#[test]
fn directions_of_a_plane_are_a_frame_of_unit_lengths() {
    let mut any = Any::new(13);
    for _ in 0..3_000 {
        let (origin, normal) = (any.point(), any.direction());
        let plane = Shape::from(Plane::new(origin, normal).unwrap());
        let n = UnitVec::new(normal).unwrap();
        let uv = |point: DVec3| {
            let surface =
                SurfacePoint { point, error: 0.0, geometric_normal: n, shading_normal: n };
            plane.uv(&Contact::at(1.0), &surface).unwrap()
        };
        let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| uv(origin + axis));
        let [u, v] = [0, 1].map(|i| DVec3::from_array(axes.map(|uv| uv[i])));
        let is = |found: f64, expected: f64| (found - expected).abs() < 1e-13;
        assert!(is(u.length(), 1.0) && is(v.length(), 1.0) && is(u.dot(v), 0.0), "{normal}");
        assert!((u.cross(v) - *n).length() < 1e-13, "{normal}");
        let is_floor = n.y.abs() > n.x.abs().max(n.z.abs());
        // On a floor v has no x; on a wall u has no y, and v leads up.
        assert!(if is_floor { u.x > 0.7 && is(v.x, 0.0) } else { is(u.y, 0.0) && v.y > 0.0 });
    }
}

#[test]
fn a_group_moves_a_texture_with_its_object() {
    let colors = [Rgb::new(1.0, 0.5, 0.25), Rgb::new(0.0, 0.25, 1.0)];
    let checker = Pattern::Checker(Checker::new(colors).unwrap());
    let texture = Arc::new(Texture::new(checker, [8.0, 4.0], [0.1, 0.2]).unwrap());
    let tint = Rgb::new(0.5, 1.0, 2.0);
    let shapes: [Shape; 2] =
        [ball(), Plane::new(dvec3(0.1, 0.2, -0.3), dvec3(0.1, 1.0, 0.4)).unwrap().into()];
    let mut any = Any::new(14);
    let mut seen = [0; 2];
    for shape in shapes {
        for _ in 0..2_000 {
            let object = || {
                let material = Material::Constant(tint);
                let object = Object::textured(shape.clone(), material, Arc::clone(&texture));
                Member::Object(object.unwrap())
            };
            let transform = any.stretching(3.0);
            let here = Group::world(vec![object()]);
            let there = Group::new(transform, vec![object()], Build::Bvh);
            let ray = any.ray();
            let to = |p| there_from_here(&transform, p);
            let moved = Ray::new(to(ray.origin), to(ray.origin + ray.direction) - to(ray.origin));
            let hit = here.intersect(&ray, Interval::AHEAD);
            let Some((hit, other)) = hit.zip(there.intersect(&moved, Interval::AHEAD)) else {
                continue;
            };
            let expected = colors.map(|color| Material::Constant(color * tint));
            let which = expected.iter().position(|&color| color == hit.material).unwrap();
            seen[which] += 1;
            // Off the edges, which rounding may move a place across.
            let Some(contact) = shape.intersect(&ray, Interval::AHEAD) else { continue };
            let [u, v] = shape.uv(&contact, &shape.surface(&ray, &contact)).unwrap();
            let near = |x: f64| (x - x.round()).abs() < 1e-6;
            if !(near(8.0 * u + 0.1) || near(4.0 * v + 0.2)) {
                assert_eq!(other.material, hit.material, "{ray:?}");
            }
        }
    }
    assert!(seen.into_iter().all(|count| count > 300), "{seen:?}");
}

#[test]
fn what_has_no_coordinates_or_no_color_takes_no_texture() {
    let checker = Pattern::Checker(Checker::new([Rgb::WHITE, Rgb::BLACK]).unwrap());
    let texture = Arc::new(Texture::new(checker, [1.0, 1.0], [0.0, 0.0]).unwrap());
    let disk = tracer::shape::Disk::new(DVec3::ZERO, DVec3::Z, 1.0).unwrap();
    let refused = |shape: Shape, material| {
        Object::textured(shape, material, Arc::clone(&texture)).unwrap_err().to_string()
    };
    let white = Material::Constant(Rgb::WHITE);
    assert_eq!(
        refused(disk.into(), white),
        "`texture`: expected a sphere, a plane or a mesh with texture coordinates under it, \
         found disk"
    );
    assert_eq!(
        refused(ball(), Material::Normal),
        "`texture`: expected a material with a color under it, found `Normal`"
    );
}
