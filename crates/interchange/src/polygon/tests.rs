//! Polygons of every kind, and random ones.

use super::*;

/// Points of the plane put into a slanted plane of space.
fn in_space(points: &[[f64; 2]], axis: usize) -> Vec<DVec3> {
    let place = |&[x, y]: &[f64; 2]| {
        let mut p = [0.0; 3];
        (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (x + 2.0 * y, x, y);
        DVec3::from_array(p)
    };
    points.iter().map(place).collect()
}

fn area(points: &[[f64; 2]], corners: &[usize]) -> f64 {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let n = corners.len();
    (0..n).map(|i| cross(points[corners[i]], points[corners[(i + 1) % n]])).sum::<f64>() / 2.0
}

/// Cut both ways around and from all sides, it has so many triangles, which have its area.
#[track_caller]
fn check(points: &[[f64; 2]], count: usize) {
    let all: Vec<usize> = (0..points.len()).collect();
    let whole = area(points, &all);
    for axis in 0..3 {
        for first in 0..points.len() {
            let mut turned = points.to_vec();
            turned.rotate_left(first);
            let triangles = Cutter::default().cut(&in_space(&turned, axis)).unwrap();
            assert_eq!(triangles.len(), count, "{turned:?} along {axis}: {triangles:?}");
            let areas: Vec<f64> = triangles.iter().map(|t| area(&turned, t)).collect();
            assert!(areas.iter().all(|a| a * whole > 0.0), "{turned:?}: {areas:?}");
            let sum: f64 = areas.iter().sum();
            assert!((sum - whole).abs() <= 1e-9 * whole.abs(), "{turned:?}: {sum}, not {whole}");
        }
    }
    if whole > 0.0 {
        let back: Vec<_> = points.iter().rev().copied().collect();
        check(&back, count);
    }
}

#[track_caller]
fn check_problem(points: &[[f64; 2]], expected: Problem) {
    for axis in 0..3 {
        assert_eq!(Cutter::default().cut(&in_space(points, axis)), Err(expected), "{points:?}");
    }
}

#[test]
fn polygons_of_every_kind_are_cut() {
    check(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 2);
    // An arrowhead.
    check(&[[0.0, 0.0], [4.0, 4.0], [0.0, 1.0], [-4.0, 4.0]], 2);
    // Corners in the middle of edges are used, so that neighbors fit.
    check(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]], 4);
    check(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]], 2);
    // Repetitions are not.
    check(&[[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]], 2);
    // A comb.
    check(
        &[
            [0.0, 0.0],
            [6.0, 0.0],
            [6.0, 3.0],
            [5.0, 1.0],
            [4.0, 3.0],
            [3.0, 1.0],
            [2.0, 3.0],
            [1.0, 1.0],
            [0.0, 3.0],
        ],
        7,
    );
    // A square with a square hole, by a bridge: there, around, and back again.
    check(
        &[
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [0.0, 9.0],
            [0.0, 0.0],
            [3.0, 3.0],
            [3.0, 6.0],
            [6.0, 6.0],
            [6.0, 3.0],
            [3.0, 3.0],
        ],
        8,
    );
    // One corner a single bit inside.
    let inside = 1.0_f64.next_down();
    check(&[[0.0, 0.0], [2.0, 0.0], [inside, inside], [0.0, 2.0]], 2);
}

#[test]
fn what_cannot_be_cut_is_a_problem() {
    check_problem(&[], Problem::NoArea);
    check_problem(&[[0.0, 0.0], [1.0, 0.0]], Problem::NoArea);
    check_problem(&[[0.0, 0.0]; 5], Problem::NoArea);
    check_problem(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]], Problem::NoArea);
    check_problem(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [1.0, 0.0]], Problem::NoArea);
    // There and back again, around a corner.
    check_problem(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 0.0]], Problem::NoArea);
    check_problem(&[[0.0, 0.0], [3.0, 3.0], [3.0, 0.0], [0.0, 2.0]], Problem::Crossing(0, 2));
    // Numbered as they are written; of repetitions the first.
    let twice = [[0.0, 0.0], [0.0, 0.0], [3.0, 3.0], [3.0, 0.0], [3.0, 0.0], [0.0, 2.0]];
    check_problem(&twice, Problem::Crossing(0, 3));
    // A star of five points drawn in one line winds around its middle twice.
    let star = [[0.0, 3.0], [2.0, -3.0], [-3.0, 1.0], [3.0, 1.0], [-2.0, -3.0]];
    check_problem(&star, Problem::Crossing(0, 2));
    // Two triangles that meet in a corner, around opposite ways.
    let eight = [[0.0, 0.0], [3.0, -1.0], [3.0, 1.0], [0.0, 0.0], [-2.0, -1.0], [-2.0, 1.0]];
    check_problem(&eight, Problem::Tangled);
}

#[test]
fn halves_that_cancel_are_no_polygon_without_area() {
    let bow = [[-1.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]];
    check_problem(&bow, Problem::Crossing(0, 2));
    // Where the halves meet in corners no edges go through each other.
    let eight = [[0.0, 0.0], [3.0, -1.0], [3.0, 1.0], [0.0, 0.0], [-3.0, -1.0], [-3.0, 1.0]];
    check_problem(&eight, Problem::Tangled);
    // What a file's rounding leaves of the normal, or of being flat, is no way to look.
    let mut rng = fastrand::Rng::with_seed(5);
    for i in 0..300 {
        let (sin, cos) = libm::sincos(f64::from(i) * 0.3);
        let place = |[x, y]: [f64; 2]| {
            let mut p = [x, y * cos, y * sin];
            p.rotate_left(i as usize % 3);
            DVec3::from_array(p.map(|x| f64::from((x + 3e-7 * rng.f64()) as f32)))
        };
        let corners: Vec<_> = bow.into_iter().map(place).collect();
        assert_eq!(Cutter::default().cut(&corners), Err(Problem::Crossing(0, 2)), "{corners:?}");
    }
}

#[test]
fn many_corners_on_one_line_take_no_work() {
    let mut rng = fastrand::Rng::with_seed(6);
    let line: Vec<_> = (0..20_000).map(|_| [rng.u32(..).into(); 2]).collect();
    assert_eq!(Cutter::spent().cut(&in_space(&line, 0)), Err(Problem::NoArea));
}

#[test]
fn a_way_there_and_back_is_left_out() {
    let spike = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [7.0, 7.0], [4.0, 4.0], [0.0, 4.0]];
    let triangles = Cutter::default().cut(&in_space(&spike, 0)).unwrap();
    let sum: f64 = triangles.iter().map(|t| area(&spike, t)).sum();
    assert_eq!(sum, 16.0, "{triangles:?}");
}

#[test]
fn random_star_shaped_polygons_are_covered() {
    let mut rng = fastrand::Rng::with_seed(7);
    for _ in 0..300 {
        let n = rng.usize(4..40);
        let point = |i: usize, r: f64| {
            let (sin, cos) = libm::sincos(i as f64 * std::f64::consts::TAU / n as f64);
            [r * cos, r * sin]
        };
        let points: Vec<_> = (0..n).map(|i| point(i, 0.05 + rng.f64())).collect();
        let triangles = Cutter::default().cut(&in_space(&points, 1)).unwrap();
        assert_eq!(triangles.len(), n - 2, "{points:?}");
        let all: Vec<usize> = (0..n).collect();
        let sum: f64 = triangles.iter().map(|t| area(&points, t)).sum();
        assert!((sum - area(&points, &all)).abs() < 1e-9, "{points:?}");
    }
}

#[test]
fn random_corners_never_panic_or_hang() {
    let mut rng = fastrand::Rng::with_seed(8);
    for _ in 0..3_000 {
        let n = rng.usize(0..12);
        let points: Vec<_> = (0..n).map(|_| [rng.u8(0..4), rng.u8(0..4)].map(f64::from)).collect();
        if let Ok(triangles) = Cutter::default().cut(&in_space(&points, 2)) {
            let all: Vec<usize> = (0..n).collect();
            let sum: f64 = triangles.iter().map(|t| area(&points, t)).sum();
            assert_eq!(sum, area(&points, &all), "{points:?}: {triangles:?}");
        }
    }
}

#[test]
fn work_has_an_end() {
    // Long teeth at an angle: every edge is in the boxes of all others.
    let teeth = teeth(1_000, 300.0);
    let alone = looks(&teeth);
    assert!(alone > LOOKS * teeth.len() as u64, "{alone} looks");
    let beyond = alone - LOOKS * teeth.len() as u64;
    let mut cutter = Cutter { own: 0, shared: 3 * beyond };
    let cuts = (0..100).take_while(|_| cutter.cut(&teeth).is_ok()).count();
    assert_eq!(cuts, 3);
    assert_eq!(cutter.cut(&teeth), Err(Problem::TooMuchWork));
    // What takes no more than its own is cut all the same.
    let arrow = in_space(&[[0.0, 0.0], [4.0, 4.0], [0.0, 1.0], [-4.0, 4.0]], 0);
    assert!(cutter.cut(&arrow).is_ok());
}

#[test]
fn the_first_crossing_is_that_of_all_pairs() {
    let mut rng = fastrand::Rng::with_seed(9);
    let mut found = [0; 2];
    for _ in 0..2_000 {
        let n = rng.usize(4..24);
        let is_coarse = rng.bool();
        let mut number = || if is_coarse { rng.u8(0..7).into() } else { rng.f64() };
        let points: Vec<Point> = (0..n).map(|_| [number(), number()]).collect();
        let side = |i: usize, j: usize| turn(points[i], points[(i + 1) % n], points[j % n]);
        let opposite = |x: Ordering, y: Ordering| x.is_ne() && x == y.reverse();
        let cut = |i: usize, j: usize| {
            opposite(side(i, j), side(i, j + 1)) && opposite(side(j, i), side(j, i + 1))
        };
        let all = (0..n).flat_map(|i| (i + 2..n).map(move |j| (i, j)));
        let expected = all.clone().find(|&(i, j)| cut(i, j));
        assert_eq!(Cutter::default().crossing(&points), Ok(expected), "{points:?}");
        found[usize::from(expected.is_some())] += 1;
    }
    assert!(found[0] > 20 && found[1] > 20, "{found:?}");
}

/// So many teeth of this length on a line, all leaning alike.
fn teeth(n: usize, length: f64) -> Vec<DVec3> {
    let (sin, cos) = libm::sincos(1.1);
    let tip = |i: usize, r: f64| [i as f64 + r * cos, r * sin];
    let mut points: Vec<_> =
        (0..2 * n).map(|i| tip(i, if i % 2 == 1 { length } else { 0.0 })).collect();
    points.extend([[2.0 * n as f64, -1.0], [0.0, -1.0]]);
    in_space(&points, 2)
}

/// How much it is to cut a polygon.
fn looks(corners: &[DVec3]) -> u64 {
    const ALL: u64 = 1 << 40;
    let mut cutter = Cutter { own: 0, shared: ALL };
    cutter.cut(corners).unwrap();
    let own = LOOKS * corners.len() as u64;
    own - cutter.own + ALL - cutter.shared
}

#[test]
fn borders_that_are_drawn_take_little_work() {
    let circle = |n: usize, radius: &dyn Fn(usize) -> f64| -> Vec<DVec3> {
        let point = |i: usize| {
            let (sin, cos) = libm::sincos(i as f64 * std::f64::consts::TAU / n as f64);
            [radius(i) * cos, radius(i) * sin]
        };
        in_space(&(0..n).map(point).collect::<Vec<_>>(), 2)
    };
    let spiral = |n: usize| {
        let arm = |i: usize, r: f64| {
            let (sin, cos) = libm::sincos(i as f64 * 0.05);
            let r = r + i as f64 * 0.01;
            [r * cos, r * sin]
        };
        let out = (0..n / 2).map(|i| arm(i, 2.0));
        in_space(&out.chain((0..n / 2).rev().map(|i| arm(i, 1.5))).collect::<Vec<_>>(), 2)
    };
    let mut rng = fastrand::Rng::with_seed(4);
    let noise: Vec<f64> = (0..20_000).map(|_| 0.5 + rng.f64()).collect();
    let n = 19_998;
    for (name, border, most) in [
        ("gear", circle(n, &|i| if i / 2 % 2 == 0 { 1.0 } else { 0.9 }), LOOKS),
        ("noise", circle(n, &|i| noise[i]), LOOKS),
        ("star", circle(n, &|i| if i % 2 == 0 { 1.0 } else { 0.01 }), 800),
        ("spiral", spiral(n), 1_000),
    ] {
        let looks = looks(&border) / n as u64;
        assert!(looks <= most, "{name}: {looks} looks for each corner");
    }
}

/// Whether the polygon winds around a point.
fn is_inside(points: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    let crossed = pairs.filter(|(a, b)| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

/// Points all over it are covered once inside, and not at all outside.
#[track_caller]
fn check_covered(points: &[[f64; 2]]) {
    let triangles = Cutter::default().cut(&in_space(points, 2)).unwrap();
    let extent = |k: usize| {
        let all = points.iter().map(|p| p[k]);
        (all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max))
    };
    let covers = |triangle: &[usize; 3], [x, y]: [f64; 2]| {
        let [a, b, c] = triangle.map(|i| points[i]);
        let sides = [(a, b), (b, c), (c, a)]
            .map(|(a, b)| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]));
        sides.iter().all(|&side| side > 0.0)
    };
    for i in 0..1_600 {
        // Off the lines that the corners of these tests are on.
        let share = [f64::from(i % 40) + 0.4871, f64::from(i / 40) + 0.5313];
        let p = [0, 1].map(|k| {
            let (low, high) = extent(k);
            low + (high - low) * share[k] / 40.0
        });
        let times = triangles.iter().filter(|triangle| covers(triangle, p)).count();
        assert_eq!(times, usize::from(is_inside(points, p)), "{p:?}");
    }
}

#[test]
fn points_are_covered_once() {
    let arm = |i: i32, r: f64| {
        let (sin, cos) = libm::sincos(f64::from(i) * 0.3);
        let r = r + f64::from(i) * 0.1;
        [r * cos, r * sin]
    };
    let mut spiral: Vec<_> = (0..60).map(|i| arm(i, 2.0)).collect();
    spiral.extend((0..60).rev().map(|i| arm(i, 1.0)));
    check_covered(&spiral);
    let mut comb = vec![[20.0, 0.0], [20.0, -1.0], [0.0, -1.0], [0.0, 0.0]];
    comb.extend((0..20).map(f64::from).flat_map(|x| [[x + 0.1, 5.0 + x * 0.1], [x + 0.9, 0.1]]));
    comb.reverse();
    check_covered(&comb);
    let teeth = (0..2_000).map(|i| {
        let (sin, cos) = libm::sincos(f64::from(i) * std::f64::consts::TAU / 2_000.0);
        let r = if i / 2 % 2 == 0 { 1.0 } else { 0.9 };
        [r * cos, r * sin]
    });
    check_covered(&teeth.collect::<Vec<_>>());
}

#[test]
fn triangles_turn_as_the_polygon_does() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y];
    let turns: [fn(DVec3) -> DVec3; 6] = [
        |c| c,
        |c| DVec3::new(c.y, c.x, 3.0),
        |c| DVec3::new(7.0, c.x, c.y),
        |c| DVec3::new(7.0, c.y, c.x),
        |c| DVec3::new(c.x, -2.0, c.y),
        |c| DVec3::new(c.y, -2.0, c.x) * 1e100,
    ];
    for turn in turns {
        let corners = square.map(turn);
        let normal = |[a, b, c]: [usize; 3]| {
            let [a, b, c] = [a, b, c].map(|i| corners[i]);
            (b - a).normalize().cross((c - a).normalize())
        };
        let whole = normal([0, 1, 3]);
        for triangle in Cutter::default().cut(&corners).unwrap() {
            assert!(normal(triangle).dot(whole) > 0.5, "{corners:?}");
        }
    }
}

#[test]
fn what_covers_something() {
    let on = |points: [[f64; 2]; 3]| in_space(&points, 1).try_into().unwrap();
    assert!(!has_area(&on([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]])));
    assert!(!has_area(&[DVec3::NAN; 3]) && !has_area(&[DVec3::ONE; 3]));
    assert!(has_area(&on([[0.0, 0.0], [1.0, 1.0_f64.next_down()], [2.0, 2.0]])));
    assert!(has_area(&[DVec3::ZERO, DVec3::X * 1e100, DVec3::Y * 1e-100]));
}

#[test]
fn how_far_off_its_plane() {
    let flat = in_space(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 1);
    assert!(off_plane(&flat) < 1e-15);
    let bent = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.5), DVec3::Y];
    assert!(off_plane(&bent) > 0.1);
    assert_eq!(off_plane(&[]), 0.0);
    assert_eq!(off_plane(&[DVec3::ONE; 4]), 0.0);
}
