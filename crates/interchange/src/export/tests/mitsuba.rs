//! Mitsuba's scenes, word for word.

use super::*;

#[track_caller]
fn has(fields: &str, parts: &[&str]) {
    let text = main_of(Dialect::Mitsuba, fields);
    for part in parts {
        assert_eq!(text.matches(part).count(), 1, "{part} in {text}");
    }
    assert_eq!(text.matches('<').count(), text.matches('>').count());
    assert_eq!(text.matches("<shape").count(), text.matches("</shape>").count());
}

#[track_caller]
fn has_not(fields: &str, part: &str) {
    let text = main_of(Dialect::Mitsuba, fields);
    assert!(!text.contains(part), "{part} in {text}");
}

#[test]
fn what_mitsuba_has_plugins_for_is_said_by_them() {
    let plain = format!("{LIT}, shading: Radiometric");
    has_not(&plain, "goldray_");
    has(
        &plain,
        &[
            "<integrator type=\"direct\">",
            "<emitter type=\"point\"><point name=\"position\" x=\"3\" y=\"4\" z=\"5\"/>\
             <rgb name=\"intensity\" value=\"1, 1, 1\"/></emitter>",
            "<shape type=\"sphere\"><point name=\"center\" x=\"0\" y=\"0\" z=\"0\"/>\
             <float name=\"radius\" value=\"1\"/><bsdf type=\"diffuse\">\
             <rgb name=\"reflectance\" value=\"0.2, 0.2, 0.2\"/></bsdf></shape>",
            "<boolean name=\"jitter\" value=\"false\"/>",
        ],
    );
    // No 1/pi in the convention: pi times the light.
    let attenuated = format!("{LIT}, shading: Attenuated");
    let pi = std::f64::consts::PI;
    has(&attenuated, &[&format!("<rgb name=\"intensity\" value=\"{pi}, {pi}, {pi}\"/>")]);
    has_not(&attenuated, "goldray_");
}

#[test]
fn mirrors_and_glass_send_every_ray_on() {
    let made_of =
        |material: &str| LIT.replace("radius: 1", &format!("radius: 1, material: {material}"));
    has(
        &made_of("Mirror(reflectance: (1, 0.5, 0))"),
        &[
            "<integrator type=\"goldray_direct\">",
            "<integer name=\"bounces\" value=\"5\"/>",
            "<bsdf type=\"twosided\"><bsdf type=\"conductor\">\
             <string name=\"material\" value=\"none\"/>\
             <rgb name=\"specular_reflectance\" value=\"1, 0.5, 0\"/></bsdf></bsdf>",
        ],
    );
    has(
        &made_of("Dielectric(ior: 1.5, tint: (1, 0.5, 0))"),
        &["<bsdf type=\"dielectric\"><float name=\"int_ior\" value=\"1.5\"/>\
             <float name=\"ext_ior\" value=\"1\"/>\
             <rgb name=\"specular_transmittance\" value=\"1, 0.5, 0\"/></bsdf>"],
    );
    // Its indices are relative to what is outside, as ours are, wherever a ray comes from.
    let glass = "material: Dielectric(ior: 1.5))";
    let balls = [1, 2, 6]
        .map(|radius| format!("Sphere(center: (0, 0, 0), radius: {radius}, {glass}"))
        .join(", ");
    let asked = Plain::new(&read(&format!("objects: [{balls}]")), &assets()).unwrap().asks;
    assert!(asked.contains(&Feature::NestedGlass), "{asked:?}");
    let triangle = format!("Triangle(a: (-1, -1, 4), b: (0, 1, 4), c: (1, -1, 4), {glass}");
    let behind = format!("objects: [{balls}, {triangle}]");
    let asked = Plain::new(&read(&behind), &assets()).unwrap().asks;
    assert!(asked.contains(&Feature::GlassFromBehind), "{asked:?}");
    let all = main_of(Dialect::Mitsuba, &behind);
    assert_eq!(all.matches("<float name=\"int_ior\" value=\"1.5\"/>").count(), 4, "{all}");
    has_not(LIT, "bounces");
    let mirror = made_of("Mirror(schlick: true)");
    refused(Dialect::Mitsuba, &mirror, &[Feature::Schlick]);
    let pane = "objects: [Box(min: (-1, -1, 0), max: (1, 1, 0), material: Dielectric(ior: 1.5))]";
    refused(Dialect::Mitsuba, pane, &[Feature::Box, Feature::Dielectric]);
}

#[test]
fn what_it_has_none_for_is_said_by_ours() {
    has(LIT, &["<emitter type=\"goldray_point\">"]);
    has(&format!("{LIT}, shadows: false"), &["<boolean name=\"shadows\" value=\"false\"/>"]);
    has(
        &format!("{LIT}, background: (0, 0.5, 1)"),
        &["<vector name=\"background\" x=\"0\" y=\"0.5\" z=\"1\"/>"],
    );
    has(&format!("{LIT}, show: Silhouette"), &["<emitter type=\"goldray_glow\">"]);
    has(&format!("{LIT}, show: Normals"), &["<emitter type=\"goldray_normals\">"]);
    has(
        &format!("{LIT}, show: Depth(near: 1, far: 2)"),
        &["<emitter type=\"goldray_depth\"><vector name=\"eye\" x=\"0\" y=\"0\" z=\"5\"/>\
             <float name=\"near\" value=\"1\"/><float name=\"far\" value=\"2\"/></emitter>"],
    );
    let glossy = "radius: 1, material: BlinnPhong(specular: (1, 1, 1), exponent: 2)";
    let shiny = LIT.replace("radius: 1", glossy);
    has(
        &shiny,
        &["<bsdf type=\"goldray_surface\">", "<boolean name=\"radiometric\" value=\"false\"/>"],
    );
    has(
        &format!("{shiny}, shading: Radiometric"),
        &[
            "<vector name=\"specular\" x=\"1\" y=\"1\" z=\"1\"/>",
            "<boolean name=\"radiometric\" value=\"true\"/>",
        ],
    );
    let back = "objects: [Disk(center: (0, 0, 0), normal: (0, 0, -1), radius: 1)], \
                lights: [Directional(direction: (0, 0, 1))]";
    has(back, &["<bsdf type=\"goldray_surface\">"]);
    has_not(&format!("{back}, shading: Radiometric"), "goldray_surface");
    has_not(
        &format!("{back}, background: (1, 1, 1)").replace("0, -1)", "0, 1)"),
        "goldray_surface",
    );
    let bright = LIT.replace("radius: 1", "radius: 1, material: Lambert(diffuse: (0, 2, 0))");
    has(&bright, &["<bsdf type=\"goldray_surface\">"]);
}

#[test]
fn shapes() {
    let silhouette = |objects: &str| format!("show: Silhouette, objects: [{objects}]");
    has(
        &silhouette("Cylinder(a: (0, 0, 0), b: (0, 0, 2), radius: 0.5, open: true)"),
        &["<shape type=\"cylinder\"><point name=\"p0\" x=\"0\" y=\"0\" z=\"0\"/>\
           <point name=\"p1\" x=\"0\" y=\"0\" z=\"2\"/><float name=\"radius\" value=\"0.5\"/>"],
    );
    // Disks close it, and look outwards.
    let capped =
        main_of(Dialect::Mitsuba, &silhouette("Cylinder(a: (0, 0, 0), b: (0, 0, 2), radius: 0.5)"));
    assert_eq!(capped.matches("<shape type=\"disk\">").count(), 2);
    for normal_and_center in ["0 0 -1 0 0 0 0 1\"", "0 0 1 2 0 0 0 1\""] {
        assert_eq!(capped.matches(normal_and_center).count(), 1, "{capped}");
    }
    has(
        &silhouette("Disk(center: (1, 2, 3), normal: (0, 0, 5), radius: 2)"),
        &["<matrix value=\"0 -2 0 1 2 0 0 2 0 0 1 3 0 0 0 1\"/>"],
    );
    // A box is twelve triangles; without thickness two, lit on either side.
    let flat = "objects: [Box(min: (-1, -1, 0), max: (1, 1, 0))], \
                lights: [Directional(direction: (0, 0, -1))], shading: Radiometric";
    let exported = written(Dialect::Mitsuba, flat);
    assert!(text(&exported, "triangles-0.ply").contains("element face 2\n"));
    assert!(text(&exported, "scene.xml").contains("<bsdf type=\"twosided\">"));
    let thick = written(Dialect::Mitsuba, &flat.replace("1, 1, 0)", "1, 1, 1)"));
    let ply = text(&thick, "triangles-0.ply");
    assert!(ply.contains("element vertex 8\n") && ply.contains("element face 12\n"), "{ply}");
    let mesh = written(Dialect::Mitsuba, &silhouette("Mesh(file: \"a.obj\")"));
    let ply = text(&mesh, "triangles-0.ply");
    assert!(ply.contains("\n1 1 0 0 0 1\n") && ply.ends_with("3 0 1 2\n3 3 4 5\n"), "{ply}");
    // What is mirrored is turned around, so that its normals stay outside.
    let mirrored =
        "Group(transform: [Scale(-1, 1, 1)], objects: [Mesh(file: \"a.obj\", flat: true)])";
    let ply = text(&written(Dialect::Mitsuba, &silhouette(mirrored)), "triangles-0.ply");
    assert!(ply.ends_with("3 0 2 1\n3 0 3 2\n") && ply.contains("\n-1 1 0\n"), "{ply}");
}

#[test]
fn cameras() {
    has(
        "objects: []",
        &[
            "<sensor type=\"perspective\">\n  <string name=\"fov_axis\" value=\"x\"/>\
           <float name=\"fov\" value=\"106.26020470831195\"/>",
            "<matrix value=\"-1 0 0 0 0 1 0 0 0 0 -1 5 0 0 0 1\"/>",
        ],
    );
    // The window's middle is three quarters of its height above the axis.
    has(
        "camera: Perspective(view_point: (0, 0, 0), view_dir: (0, 3, -4), proj_normal: (0, 0, 1), \
         view_width: 4, view_height: 3, proj_distance: 3.75)",
        &["<float name=\"principal_point_offset_y\" value=\"-0.75\"/>"],
    );
    // Parallel rays are sheared, and pixels may be of any shape.
    has(
        "camera: Parallel(view_point: (0, 0, 3), view_dir: (0, 3, -4), proj_normal: (0, 0, 1), \
         view_width: 2, view_height: 3)",
        &["<matrix value=\"-1 0 0 0 0 2 0.6 0 0 0 -0.8 3 0 0 0 1\"/>"],
    );
    let stretched = "camera: Perspective(view_point: (0, 0, 0))";
    refused(Dialect::Mitsuba, stretched, &[Feature::StretchedPixels]);
}
