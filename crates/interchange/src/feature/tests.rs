//! What scenes ask for, by their files.

use super::*;

#[track_caller]
fn check(more: &str, expected: &[Feature]) {
    let text = format!("(version: 1, image: (4, 3), {more})");
    let file: SceneFile<scene::Unchecked> = scene::parse(&text).unwrap();
    assert_eq!(features(&file).into_iter().collect::<Vec<_>>(), expected, "{more}");
}

#[test]
fn a_scene_asks_for_what_its_picture_needs() {
    use Feature::*;
    let camera = "camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40)";
    let ball = "objects: [Sphere(center: (0, 0, 0), radius: 1)]";
    check(&format!("{camera}, {ball}"), &[Perspective, Sphere, Lambert, Classic]);
    check(&format!("{camera}, {ball}, show: Silhouette"), &[Perspective, Sphere, Silhouette]);
    check(
        "camera: Parallel(view_point: (0, 0, 5), proj_normal: (0, 1, 1), view_width: 4)",
        &[Parallel, Oblique, StretchedPixels],
    );
    check(
        &format!(
            "{camera}, shading: Radiometric, shadows: false, background: (1, 0, 0), \
             lights: [Point(position: (1, 1, 1)), Ambient(intensity: (1, 1, 1))], \
             materials: {{\"a\": BlinnPhong(specular: (1, 1, 1), exponent: 2)}}, \
             objects: [Group(material: Named(\"a\"), objects: [Cylinder(a: (0, 0, 0), \
             b: (0, 1, 0), radius: 1, open: true)])]"
        ),
        &[
            Perspective,
            OpenCylinder,
            Group,
            BlinnPhong,
            InverseSquarePointLight,
            AmbientLight,
            NoShadows,
            Radiometric,
            Background,
        ],
    );
}

#[test]
fn textures_count_where_they_are_seen() {
    use Feature::*;
    let scene = "camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40), \
                 materials: {\"a\": Named(\"b\"), \"b\": Constant(color: (1, 1, 1), texture: \
                 Checker(a: (1, 1, 1), b: (0, 0, 0)))}, objects: [Sphere(center: (0, 0, 0), \
                 radius: 1, material: Named(\"a\"))]";
    check(scene, &[Perspective, Sphere, Constant, CheckerTexture]);
    check(&format!("{scene}, show: Silhouette"), &[Perspective, Sphere, Silhouette]);
    let image = scene.replace("Checker(a: (1, 1, 1), b: (0, 0, 0))", "Image(file: \"a.png\")");
    check(&image, &[Perspective, Sphere, Constant, ImageTexture]);
}

#[test]
fn every_feature_has_a_name_and_a_family() {
    let names: BTreeSet<_> = Feature::ALL.iter().map(|feature| feature.name()).collect();
    assert_eq!(names.len(), Feature::ALL.len());
    assert!(Feature::ALL.iter().all(|feature| !feature.family().is_empty()));
}
