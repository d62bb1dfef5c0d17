//! The watertight triangle against answers known on paper, the textbook forms,
//! and rays aimed at shared edges.

use glam::dvec3;

use super::*;
use crate::lecture::{triangle_inside_edges, triangle_linear_system};
use crate::shape::Geometry;

const CORNERS: [DVec3; 3] = [dvec3(0.0, 0.0, 0.0), dvec3(4.0, 0.0, 0.0), dvec3(0.0, 2.0, 0.0)];

#[track_caller]
fn check(p: [f64; 3], d: [f64; 3], range: Interval, expected: Option<f64>) {
    let [a, b, c] = CORNERS;
    let ray = Ray::new(DVec3::from_array(p), DVec3::from_array(d));
    for corners in [[a, b, c], [b, c, a], [c, b, a]] {
        let [a, b, c] = corners;
        let triangle = Triangle::new(a, b, c).unwrap();
        assert_eq!(triangle.intersect(&ray, range).map(|c| c.t), expected, "{corners:?}");
    }
}

const AHEAD: Interval = Interval::AHEAD;

#[test]
fn ugly_rays_miss() {
    let nan = f64::NAN;
    check([nan, 0.5, 8.0], [0.0, 0.0, -2.0], AHEAD, None);
    check([1.0, 0.5, 8.0], [nan, 0.0, -2.0], AHEAD, None);
    check([1.0, 0.5, 8.0], [0.0, 0.0, nan], AHEAD, None);
    check([1.0, 0.5, f64::INFINITY], [0.0, 0.0, -2.0], AHEAD, None);
    check([1.0, 0.5, 8.0], [0.0, 0.0, 0.0], AHEAD, None);
}

#[test]
fn inside_outside_edges_corners_and_both_sides() {
    let d = [0.0, 0.0, -2.0];
    check([1.0, 0.5, 8.0], d, AHEAD, Some(4.0));
    check([1.0, 0.5, -8.0], [0.0, 0.0, 2.0], AHEAD, Some(4.0));
    check([3.0, 1.0, 8.0], d, AHEAD, None);
    check([-0.5, 1.0, 8.0], d, AHEAD, None);
    check([1.0, -0.5, 8.0], d, AHEAD, None);
    check([2.0, 1.0, 8.0], d, AHEAD, Some(4.0));
    check([0.0, 1.0, 8.0], d, AHEAD, Some(4.0));
    check([4.0, 0.0, 8.0], d, AHEAD, Some(4.0));
    check([5.0, 0.5, 8.0], [-1.0, 0.0, -2.0], AHEAD, Some(4.0));
    check([1.0, 8.5, 8.0], [0.0, -8.0, -8.0], AHEAD, Some(1.0));
}

#[test]
fn behind_out_of_range_and_parallel() {
    let d = [0.0, 0.0, -2.0];
    check([1.0, 0.5, -8.0], d, AHEAD, None);
    check([1.0, 0.5, 8.0], d, Interval::new(0.0, 4.0), None);
    check([1.0, 0.5, 8.0], d, Interval::new(4.0, 9.0), None);
    check([-1.0, 0.5, 0.0], [1.0, 0.0, 0.0], AHEAD, None);
    check([-1.0, 0.5, 1.0], [1.0, 0.0, 0.0], AHEAD, None);
}

#[test]
fn weights_and_normal() {
    let [a, b, c] = CORNERS;
    let triangle = Triangle::new(a, b, c).unwrap();
    let ray = Ray::new(dvec3(1.0, 0.5, 8.0), dvec3(0.0, 0.0, -2.0));
    let contact = triangle.intersect(&ray, AHEAD).unwrap();
    assert_eq!(contact.barycentric, [0.25, 0.25]);
    let surface = triangle.surface(&ray, &contact);
    assert_eq!(surface.point, dvec3(1.0, 0.5, 0.0));
    assert_eq!(surface.geometric_normal, UnitVec::Z);
    let back = Triangle::new(a, c, b).unwrap();
    let surface = back.surface(&ray, &back.intersect(&ray, AHEAD).unwrap());
    assert_eq!(*surface.geometric_normal, -DVec3::Z, "the winding says where the front is");
}

#[test]
fn agrees_with_both_textbook_forms_away_from_edges() {
    let mut rng = fastrand::Rng::with_seed(7);
    let mut any = || dvec3(rng.f64(), rng.f64(), rng.f64()) * 2.0 - 1.0;
    let mut hits = 0;
    for _ in 0..20_000 {
        let (a, b, c) = (any(), any(), any());
        let Ok(triangle) = Triangle::new(a, b, c) else {
            continue;
        };
        let origin = 3.0 * any();
        let target = (a + b + c) / 3.0 + any();
        let ray = Ray::new(origin, target - origin);
        let ours = triangle.intersect(&ray, AHEAD).map(|c| c.t);
        let edges = triangle_inside_edges([a, b, c], &ray, AHEAD);
        let system = triangle_linear_system([a, b, c], &ray, AHEAD).map(|(t, ..)| t);
        assert_eq!(ours.is_some(), edges.is_some(), "{ray:?}");
        assert_eq!(ours.is_some(), system.is_some(), "{ray:?}");
        if let (Some(t), Some(edges), Some(system)) = (ours, edges, system) {
            hits += 1;
            assert!((t - edges).abs() < 1e-9 * t.max(1.0), "{t} {edges}");
            assert!((t - system).abs() < 1e-9 * t.max(1.0), "{t} {system}");
        }
    }
    assert!(hits > 1_000, "{hits} hits are too few to say anything");
}

#[test]
fn t_keeps_its_digits_where_the_weights_lose_theirs() {
    // A plane so flat to the ray that the areas cancel to a 2^-40 of their
    // products: z = 2^-40 x from x = 1, met at x = 3/2.
    let flat = f64::from(2.0_f32.powi(-40));
    let third = 1.0 / 3.0;
    let corner = |x: f64, y: f64| dvec3(x, y, flat * x);
    let triangle = [corner(1.0, -third), corner(2.0, -third), corner(1.75, 2.0 * third)];
    let ray = Ray::new(dvec3(0.0, 0.0, 1.5 * flat), dvec3(3.0, 0.0, 0.0));
    let t = Shear::new(&ray).intersect(triangle, AHEAD).unwrap().t;
    assert_eq!(t, 0.5, "off by {:e}", t - 0.5);
}

#[test]
fn t_is_right_to_sixteen_last_places_near_the_worst_that_is_not_computed_again() {
    // Found by search: 16.8 last places off in plain arithmetic.
    let f = |bits: [u64; 3]| DVec3::from_array(bits.map(f64::from_bits));
    let origin = f([0xbfdf_ec0a_fab9_8523, 0xbfcf_127a_82e6_521e, 0xbfc5_a8f8_b773_1816]);
    let direction = f([0x3f78_1c0d_05f4_2b8a, 0x3fd9_4472_3ee7_ff86, 0x3fd4_626b_54c9_0928]);
    let a = f([0xbfd4_a537_32ca_ad15, 0xbfec_74e8_5841_0900, 0xbfd6_2939_48f5_53fb]);
    let b = f([0xbfe2_7ec2_cd92_1e07, 0x3f9c_d035_261d_587b, 0xbfa4_2f2e_d27e_0b00]);
    let c = f([0x3fea_8924_f30e_47f6, 0x3fe8_6e47_edcc_d3ec, 0x3fdf_8acc_fcae_1da7]);
    let ray = Ray::new(origin, direction);
    let t = Shear::new(&ray).intersect([a, b, c], AHEAD).unwrap().t;
    let exact = 0.240_307_008_796_008_44;
    assert!((t - exact).abs() <= 16.0 * 2.8e-17, "{t} {:e}", t - exact);
}

#[test]
fn t_keeps_its_digits_at_every_size() {
    // Next to an edge, where the areas are of very different sizes.
    for exponent in [-250, -260, -264, -265, -266, -270, -300, 200] {
        let size = libm::exp2(f64::from(exponent));
        let corners = [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 1.0)];
        let ray = Ray::new(dvec3(0.5, 1e-6, 1.0 / 64.0) * size, dvec3(0.0, 0.0, -1.0));
        let t = Shear::new(&ray).intersect(corners.map(|p| p * size), AHEAD).unwrap().t;
        let exact = (1.0 / 64.0 - 1e-6) * size;
        assert!((t - exact).abs() <= 1e-15 * exact, "2^{exponent}: {t:e} {exact:e}");
    }
}

#[test]
fn no_ray_passes_between_two_triangles_where_the_textbook_leaks() {
    let mut rng = fastrand::Rng::with_seed(11);
    let mut any = || dvec3(rng.f64(), rng.f64(), rng.f64()) * 2.0 - 1.0;
    let (mut leaks, mut textbook_leaks) = (0, 0);
    for _ in 0..50_000 {
        // The edge from p to q, with one triangle on each side of it as seen
        // from the origin of the ray.
        let (p, q, s, origin) = (any(), any(), any(), 4.0 * any());
        let middle = 0.5 * (p + q);
        let (left, right) = (middle + s, middle - s);
        let on_edge = p + (q - p) * rng_between(&mut any);
        let ray = Ray::new(origin, on_edge - origin);
        let range = Interval::AHEAD;
        let shear = Shear::new(&ray);
        let hit = |c| shear.intersect(c, range).is_some();
        leaks += u32::from(!hit([p, q, left]) && !hit([q, p, right]));
        let hit = |c| triangle_linear_system(c, &ray, range).is_some();
        textbook_leaks += u32::from(!hit([p, q, left]) && !hit([q, p, right]));
    }
    assert_eq!(leaks, 0);
    assert!(textbook_leaks > 0, "the rays are not aimed well enough to tell");
}

/// A number between 0.1 and 0.9.
fn rng_between(any: &mut impl FnMut() -> DVec3) -> f64 {
    0.5 + 0.4 * any().x
}

#[test]
fn a_triangle_as_thin_as_can_be_has_its_normal() {
    // The plain cross product of these edges is zero.
    let e = f64::from(2.0_f32.powi(-27));
    let (b, c) = (dvec3(1.0 + e, 0.0, 1.0), dvec3(1.0 + 2.0 * e, 0.0, 1.0 + e));
    assert_eq!(b.cross(c), DVec3::ZERO);
    let triangle = Triangle::new(DVec3::ZERO, b, c).unwrap();
    assert_eq!(triangle.normal.abs(), DVec3::Y);
}

#[test]
fn corners_on_a_line_are_refused_and_never_hit() {
    let refused = Triangle::new(DVec3::ZERO, DVec3::X, 2.0 * DVec3::X).unwrap_err();
    assert_eq!(refused.refusals()[0].field, "c");
    let ray = Ray::new(dvec3(0.5, 0.0, 3.0), dvec3(0.0, 0.0, -1.0));
    let line = [DVec3::ZERO, DVec3::X, 2.0 * DVec3::X];
    assert_eq!(Shear::new(&ray).intersect(line, AHEAD), None);
}

#[test]
fn whether_there_is_a_normal_is_known_before_it_is() {
    let mut any = fastrand::Rng::with_seed(31);
    let (mut with, mut without) = (0, 0);
    for case in 0..100_000 {
        // Whole numbers of few bits, so that many lie on a line, at scales at
        // which products are usual, underflow and overflow.
        let scale = libm::ldexp(1.0, [0, -40, -540, -1060, 190, 1000][case % 6]);
        let mut whole = || DVec3::from_array([(); 3].map(|()| f64::from(any.i8(-3..=3))));
        let (a, way, other) = (whole(), whole(), whole());
        // Three of four are next to a line, or on it.
        let nudge = [0.0, f64::EPSILON, 1e-9, 1.0][case / 6 % 4];
        let corners = [a, a + way, a - 2.0 * way + nudge * other].map(|p| p * scale);
        let expected = normal(corners).is_some();
        assert_eq!(has_normal(corners), expected, "{corners:?}");
        *(if expected { &mut with } else { &mut without }) += 1;
    }
    assert!(with > 10_000 && without > 10_000, "{with} with, {without} without");
}
