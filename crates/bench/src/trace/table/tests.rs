//! What the tables say of known rows.

use super::*;

pub(crate) fn row(scene: &str, rays: &str, engine: &str, mrays_s: f64) -> Row {
    Row {
        scene: scene.into(),
        triangles: scene.strip_prefix("bumpy-").map_or(1, |count| count.parse().unwrap()),
        rays: rays.into(),
        query: "closest".into(),
        count: 100,
        engine: engine.into(),
        mrays_s,
        spread: [mrays_s, mrays_s],
        wrong: 0,
    }
}

#[test]
fn ratios_are_to_the_bar_of_the_same_column() {
    let mut rows = vec![
        row("a", "primary", "goldray-fast", 6.0),
        row("a", "primary", BAR, 4.0),
        row("a", "shadow", "goldray-fast", 5.0),
    ];
    rows[0].wrong = 7;
    let text = scene(&rows);
    assert!(text.contains("6.00 1.50x !7"), "{text}");
    assert!(text.contains("4.00 1.00x"), "{text}");
    let fast = text.lines().find(|line| line.starts_with("goldray-fast")).unwrap();
    assert!(fast.ends_with(" 5.00"), "no bar, no ratio: {fast}");
}

#[test]
fn means_are_over_what_both_have() {
    let rows = [
        row("a", "primary", "x", 8.0),
        row("a", "primary", BAR, 4.0),
        row("b", "primary", "x", 2.0),
        row("b", "primary", BAR, 4.0),
        row("b", "shadow", "x", 100.0),
    ];
    let mean = mean_ratio(&rows, "x", BAR, &["primary", "shadow"]).unwrap();
    assert!((mean - 1.0).abs() < 1e-12, "{mean}");
    assert_eq!(mean_ratio(&rows, "y", BAR, &["primary"]), None);
}

#[test]
fn growth_is_a_slope_of_logarithms() {
    let balls = [("bumpy-100", 4.0), ("bumpy-10000", 2.0), ("bumpy-1000000", 1.0)];
    let rows = balls.map(|(scene, speed)| row(scene, "primary", "x", speed));
    let text = growth(&rows);
    assert!(text.contains("triangles^0.151"), "half as fast at each 100 times: {text}");
    assert_eq!(growth(&rows[..2]), "");
}
