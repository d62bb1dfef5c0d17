//! `asks`: what the picture of a fixture asks of a renderer.

use std::collections::BTreeSet;

use harness::fixture::{Build, Fixture};
use interchange::Feature;
use interchange::export;
use interchange::feature::features;
use tracer::{LinearImage, render};

/// What a fixture's picture asks for. Shadows, or that there are none, only where that
/// is seen: a lone ball is the same picture either way, and says nothing of a renderer
/// that has forgotten them.
pub fn asks(fixture: &Fixture, picture: &LinearImage) -> BTreeSet<Feature> {
    let mut file = fixture.scene_file();
    // A fixture's scene makes sense, and its files are there.
    let mut found = export::asks(&file, fixture.assets()).unwrap_or_else(|_| features(&file));
    let of_shadows = [Feature::Shadows, Feature::NoShadows];
    if of_shadows.iter().any(|feature| found.contains(feature)) {
        file.shadows = !file.shadows;
        let other = scene::recompile(&file, fixture.assets(), Build::default());
        if other.is_ok_and(|scene| render(&scene) == *picture) {
            found.retain(|feature| !of_shadows.contains(feature));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(objects: &str, shadows: bool, expected: &[Feature]) {
        let text = format!(
            "(version: 1, image: (32, 24), shadows: {shadows}, objects: [{objects}],
            camera: LookAt(eye: (0, 0, 9), at: (0, 0, 0), fov_deg: 40),
            lights: [Point(position: (0, 5, 5))])"
        );
        let files = std::collections::BTreeMap::new();
        let fixture = Fixture::read("a", &text, &files, Build::default()).unwrap();
        let found = asks(&fixture, &fixture.render_linear());
        let found: Vec<_> =
            found.into_iter().filter(|feature| feature.name().ends_with("Shadows")).collect();
        assert_eq!(found, expected, "{objects}");
    }

    #[test]
    fn what_only_the_picture_knows_is_asked_for_and_can_be_unsupported() {
        let text = "(version: 1, image: (32, 24), objects: [Disk(center: (0, 0, 0),
            normal: (0, 0, -1), radius: 1)],
            camera: LookAt(eye: (0, 0, 9), at: (0, 0, 0), fov_deg: 40),
            lights: [Point(position: (0, 5, 5)), Point(position: (0, 5, -5))])";
        let files = std::collections::BTreeMap::new();
        let fixture = Fixture::read("a", text, &files, Build::default()).unwrap();
        let found = asks(&fixture, &fixture.render_linear());
        assert!(found.is_superset(&[Feature::SeveralLights, Feature::BackSides].into()));
        let adapter = "(name: \"x\", command: [\"x\", \"{scene}\"], scene: Json, \
                       unsupported: {SeveralLights: \"one is enough\"})";
        let adapter = crate::adapter::Adapter::read("a.ron", adapter).unwrap();
        let why = crate::run::ruled_out(&adapter, &fixture, &found);
        assert_eq!(why, ["its adapter says that it has no SeveralLights: one is enough"]);
    }

    #[test]
    fn shadows_are_asked_for_where_they_are_seen() {
        const BALL: &str = "Sphere(center: (0, 0, 0), radius: 1)";
        let on_floor = format!("{BALL}, Plane(point: (0, -1, 0), normal: (0, 1, 0))");
        check(BALL, true, &[]);
        check(BALL, false, &[]);
        check(&on_floor, true, &[Feature::Shadows]);
        check(&on_floor, false, &[Feature::NoShadows]);
    }
}
