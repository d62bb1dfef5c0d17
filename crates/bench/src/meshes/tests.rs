//! What the generated meshes promise, and which names there are.

use std::collections::BTreeMap;

use super::*;

#[test]
fn the_hall_is_large_and_has_thin_triangles() {
    let hall = architecture::hall();
    assert!(hall.faces.len() >= 250_000, "{}", hall.faces.len());
    assert!(hall.vertices.iter().flatten().all(|x| x.is_finite()));
    let thinness = |face: &[u32; 3]| {
        let p = face.map(|i| hall.vertices[i as usize]);
        let length = |a: [f32; 3], b: [f32; 3]| {
            (0..3).map(|i| f64::from(a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
        };
        let sides = [length(p[0], p[1]), length(p[1], p[2]), length(p[2], p[0])];
        sides.iter().copied().fold(0.0, f64::max) / sides.iter().copied().fold(f64::MAX, f64::min)
    };
    let thin = hall.faces.iter().filter(|face| thinness(face) > 100.0).count();
    assert!(thin > 1000, "{thin}");
    assert_eq!(hall, architecture::hall(), "made twice, it is the same");
}

#[test]
fn bumpy_balls_are_closed_and_of_the_size_asked_for() {
    for wanted in [8, 100, 1000, 10_000, 100_000] {
        let ball = round::bumpy(wanted);
        let count = ball.faces.len() as u32;
        assert!(
            count <= wanted && (wanted < 100 || 4 * count >= 3 * wanted),
            "{count} of {wanted}"
        );
        // Every edge is gone along once in each direction.
        let mut edges = BTreeMap::new();
        for &[a, b, c] in &ball.faces {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry((from, to)).or_insert(0) += 1;
            }
        }
        let is_closed = |(&(from, to), &times)| times == 1 && edges.contains_key(&(to, from));
        assert!(edges.iter().all(is_closed), "{wanted}");
        assert!(ball.vertices.iter().all(|v| v.iter().map(|x| x * x).sum::<f32>() > 0.5));
    }
}

#[test]
fn a_wrong_name_is_answered_with_the_right_ones() {
    for wrong in ["dragon", "bumpy-", "bumpy-3", "bumpy-x", ""] {
        let why = named(wrong).unwrap_err();
        assert!(why.starts_with("--scenes: expected one of dragon-11k"), "{why}");
        assert!(why.ends_with(&format!("found `{wrong}`")), "{why}");
    }
    assert!(named("bumpy-100").unwrap().unwrap().is_closed);
}
