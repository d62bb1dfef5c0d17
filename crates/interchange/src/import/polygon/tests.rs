//! Polygons of all kinds: what is cut covers the polygon, once.

use tracer::glam::{DVec2, DVec3};

use super::{MOST_CORNERS, NotCut, cut};

/// In the plane z = 0.
fn flat(corners: &[(f64, f64)]) -> Vec<DVec3> {
    corners.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect()
}

fn doubled_area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (a, b, c) = (a.truncate(), b.truncate(), c.truncate());
    (b - a).perp_dot(c - a)
}

/// How often triangles cover a point.
fn covered(corners: &[DVec3], triangles: &[[usize; 3]], p: DVec2) -> usize {
    let inside = |t: &&[usize; 3]| {
        let [a, b, c] = t.map(|i| corners[i].truncate());
        [(a, b), (b, c), (c, a)].iter().all(|(a, b)| (*b - *a).perp_dot(p - *a) > 0.0)
    };
    triangles.iter().filter(inside).count()
}

/// Whether the polygon winds around a point.
fn is_inside(corners: &[DVec3], p: DVec2) -> bool {
    let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
    let crossed = pairs.filter(|(a, b)| {
        let (a, b) = (a.truncate(), b.truncate());
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

/// Cuts it, and looks at points all over it.
#[track_caller]
fn check(corners: &[(f64, f64)]) -> Vec<[usize; 3]> {
    let corners = flat(corners);
    let triangles = cut(&corners).unwrap();
    let total: f64 =
        triangles.iter().map(|&[a, b, c]| doubled_area(corners[a], corners[b], corners[c])).sum();
    let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
    let expected: f64 = pairs.map(|(a, b)| a.truncate().perp_dot(b.truncate())).sum();
    assert!((total - expected).abs() <= 1e-12 * expected.abs(), "{total} of {expected}");
    let low = corners.iter().copied().fold(DVec3::INFINITY, DVec3::min).truncate();
    let high = corners.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max).truncate();
    for i in 0..40 {
        for j in 0..40 {
            // Off the lines that the corners of these tests are on.
            let share = DVec2::new(f64::from(i) + 0.4871, f64::from(j) + 0.5313) / 40.0;
            let p = low + (high - low) * share;
            let expected = usize::from(is_inside(&corners, p));
            assert_eq!(covered(&corners, &triangles, p), expected, "{p}");
        }
    }
    triangles
}

#[track_caller]
fn refuses(corners: &[(f64, f64)], expected: NotCut) {
    assert_eq!(cut(&flat(corners)).unwrap_err(), expected);
}

#[test]
fn what_covers_nothing_or_crosses_itself_is_refused() {
    refuses(&[], NotCut::NoArea);
    refuses(&[(0.0, 0.0)], NotCut::NoArea);
    refuses(&[(1.0, 1.0); 5], NotCut::NoArea);
    refuses(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], NotCut::NoArea);
    refuses(&[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0), (1.0, 0.0)], NotCut::NoArea);
    // A bow tie with one wing larger; a pentagram.
    refuses(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 3.0)], NotCut::Crosses(0, 2));
    let star = [0.0_f64, 144.0, 288.0, 72.0, 216.0].map(|deg| {
        let angle = deg.to_radians();
        (angle.cos(), angle.sin())
    });
    assert!(matches!(cut(&flat(&star)), Err(NotCut::Crosses(..))));
    assert_eq!(cut(&[DVec3::NAN; 4]), Err(NotCut::NoArea));
    assert_eq!(cut(&[DVec3::INFINITY, DVec3::X, DVec3::Y]), Err(NotCut::NoArea));
    assert_eq!(cut(&vec![DVec3::X; MOST_CORNERS + 1]), Err(NotCut::Tangled));
}

#[test]
fn convex_polygons_are_fans() {
    assert_eq!(check(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]), [[0, 1, 2]]);
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    assert_eq!(check(&square), [[0, 1, 2], [0, 2, 3]]);
    // A corner in the middle of an edge, and one that stands twice.
    check(&[(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 1.0), (0.0, 1.0)]);
}

#[test]
fn triangles_turn_as_the_polygon_does() {
    let square = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let turned = |to: fn(DVec3) -> DVec3| square.iter().map(|&c| to(c)).collect::<Vec<_>>();
    for corners in [
        turned(|c| c),
        turned(|c| DVec3::new(c.y, c.x, 3.0)),
        turned(|c| DVec3::new(7.0, c.x, c.y)),
        turned(|c| DVec3::new(7.0, c.y, c.x)),
        turned(|c| DVec3::new(c.x, -2.0, c.y)),
        turned(|c| DVec3::new(c.y, -2.0, c.x) * 1e100),
    ] {
        let normal = |[a, b, c]: [usize; 3]| {
            let [a, b, c] = [a, b, c].map(|i| corners[i]);
            (b - a).normalize().cross((c - a).normalize())
        };
        let whole = normal([0, 1, 3]);
        for triangle in cut(&corners).unwrap() {
            assert!(normal(triangle).dot(whole) > 0.5, "{corners:?}");
        }
    }
}

#[test]
fn concave_polygons_are_covered_once() {
    // An arrow, a comb, a spiral.
    check(&[(0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (0.0, 4.0)]);
    let mut comb = vec![(20.0, 0.0), (20.0, -1.0), (0.0, -1.0), (0.0, 0.0)];
    comb.extend((0..20).flat_map(|i| {
        let x = f64::from(i);
        [(x + 0.1, 5.0 + x * 0.1), (x + 0.9, 0.1)]
    }));
    comb.reverse();
    check(&comb);
    let arm = |i: i32, r: f64| {
        let angle = f64::from(i) * 0.3;
        let r = r + f64::from(i) * 0.1;
        (r * angle.cos(), r * angle.sin())
    };
    let mut spiral: Vec<_> = (0..60).map(|i| arm(i, 2.0)).collect();
    spiral.extend((0..60).rev().map(|i| arm(i, 1.0)));
    check(&spiral);
}

#[test]
fn a_hole_tied_to_the_outside_is_a_hole() {
    let ring = [
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 4.0),
        (0.0, 4.0),
        (0.0, 0.0),
        (1.0, 1.0),
        (1.0, 3.0),
        (3.0, 3.0),
        (3.0, 1.0),
        (1.0, 1.0),
    ];
    check(&ring);
}

#[test]
fn thousands_of_corners_take_a_moment() {
    let gear: Vec<_> = (0..4_000)
        .map(|i| {
            let angle = f64::from(i) * std::f64::consts::TAU / 4_000.0;
            let r = if i / 2 % 2 == 0 { 1.0 } else { 0.9 };
            (r * angle.cos(), r * angle.sin())
        })
        .collect();
    assert_eq!(check(&gear).len(), 3_998);
}
