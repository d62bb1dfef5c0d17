//! Scenes made plain.

use super::*;
use crate::export::plain::{Lamp, Look};

#[track_caller]
fn plain(fields: &str) -> Plain {
    Plain::new(&read(fields), &assets()).unwrap()
}

#[track_caller]
fn looks(fields: &str, expected: &[Look]) {
    let looks: Vec<_> = plain(fields).objects.into_iter().map(|object| object.look).collect();
    assert_eq!(looks, expected, "{fields}");
}

const BALL: &str = "objects: [Sphere(center: (0, 0, 0), radius: 1)]";

fn lambert(share: f64) -> Look {
    Look::Lit { diffuse: [share; 3], highlight: None }
}

#[test]
fn materials_are_looked_up_inherited_and_filled_in() {
    let light = "lights: [Point(position: (9, 9, 9))]";
    looks(&format!("{BALL}, {light}"), &[lambert(1.0)]);
    looks(&format!("{BALL}, {light}, shading: Radiometric"), &[lambert(0.2)]);
    looks(
        &format!(
            "{light}, materials: {{\"a\": Named(\"b\"), \"b\": Normal}}, objects: [\
             Group(material: Named(\"a\"), objects: [Sphere(center: (0, 0, 0), radius: 1), \
             Box(min: (0, 0, 0), max: (1, 1, 1), material: Constant(color: (1, 2, 3)))])]"
        ),
        &[Look::Normal(1.0), Look::Constant([1.0, 2.0, 3.0])],
    );
    looks(
        &format!(
            "{light}, objects: [Sphere(center: (0, 0, 0), radius: 1, \
             material: BlinnPhong(specular: (0, 0, 0), exponent: 2))]"
        ),
        &[lambert(1.0)],
    );
}

#[test]
fn pictures_of_something_else_are_colors() {
    let id = |k| Look::Constant(tracer::id_color(k).channels());
    looks(&format!("{BALL}, show: Silhouette, exposure: 3"), &[Look::Constant([1.0; 3])]);
    looks(
        &format!("{BALL}, show: SurfaceColor, shading: Radiometric"),
        &[Look::Constant([0.2; 3])],
    );
    looks(&format!("{BALL}, show: Normals, exposure: 2"), &[Look::Normal(1.0)]);
    looks(&format!("{BALL}, show: Depth(near: 1, far: 3)"), &[Look::Depth { near: 1.0, far: 3.0 }]);
    let two = "Sphere(center: (0, 0, 0), radius: 1), Sphere(center: (0, 0, 0), radius: 2)";
    let objects = format!("objects: [Group(objects: [{two}]), {two}], show: ObjectIds");
    looks(&objects, &[id(0), id(1), id(2), id(3)]);
}

#[test]
fn exposure_is_in_lights_colors_and_background() {
    let scene = plain(&format!(
        "{BALL}, exposure: 2, background: (1, 0, 0), lights: [\
         Point(position: (0, 0, 9), intensity: (1, 2, 3)), Point(position: (1, 1, 1), \
         intensity: (0, 0, 0)), Ambient(intensity: (1, 0, 0)), Ambient(intensity: (1, 1, 0))]"
    ));
    assert_eq!(scene.background, [2.0, 0.0, 0.0]);
    assert_eq!(scene.ambient, [4.0, 2.0, 0.0]);
    let [Lamp::Point { intensity, .. }] = scene.lamps[..] else { panic!("{:?}", scene.lamps) };
    assert_eq!(intensity, [2.0, 4.0, 6.0]);
    let only_ambient = "lights: [Ambient(intensity: (0.5, 1, 2))], exposure: 2";
    looks(&format!("{BALL}, {only_ambient}"), &[Look::Constant([1.0, 2.0, 4.0])]);
    let normal = "objects: [Sphere(center: (0, 0, 0), radius: 1, material: Normal)], exposure: 2";
    looks(normal, &[Look::Normal(2.0)]);
}

#[track_caller]
fn asks(fields: &str, expected: Feature, is_asked: bool) {
    assert_eq!(plain(fields).asks.contains(&expected), is_asked, "{expected} of {fields}");
}

#[test]
fn what_the_samples_see_is_asked_for() {
    let light = |z| format!("lights: [Point(position: (0, 0, {z}))]");
    let disk = |z| format!("objects: [Disk(center: (0, 0, 0), normal: (0, 0, {z}), radius: 1)]");
    asks(&format!("{}, {}", disk(1), light(9)), Feature::BackSides, false);
    asks(&format!("{}, {}", disk(-1), light(9)), Feature::BackSides, true);
    let shiny = |fields: &str| {
        fields.replace(
            "radius: 1",
            "radius: 1, material: BlinnPhong(specular: (1, 1, 1), exponent: 1)",
        )
    };
    // A light beside the disk and a little behind it: the half vector is in front.
    let low = "lights: [Point(position: (9, 0, -1))]";
    let behind = Feature::HighlightFromBehind;
    asks(&format!("{}, {low}", shiny(&disk(1))), behind, true);
    asks(&format!("{}, {low}, shading: Radiometric", shiny(&disk(1))), behind, false);
    asks(&format!("{}, {low}", disk(1)), behind, false);
    // A ball hides the light from its own far side.
    asks(&format!("{}, {low}", shiny(BALL)), behind, false);
    asks(&format!("{}, {low}, shadows: false", shiny(BALL)), behind, true);
}

#[test]
fn what_is_seen_in_mirrors_counts() {
    // The disk turns its back to the mirror behind it, and its front to the eye,
    // which looks aslant.
    let behind = "Plane(point: (0, 0, -2), normal: (0, 0, 1)";
    let fields = |material: &str| {
        format!(
            "camera: Parallel(view_point: (0, 3, 3), view_dir: (0, -1, -1), view_width: 8, \
             view_height: 6), lights: [Point(position: (0, 0, 9))], objects: [\
             Disk(center: (0, 0, 0), normal: (0, 0, 1), radius: 1), {behind}, material: {material})]"
        )
    };
    asks(&fields("Lambert()"), Feature::BackSides, false);
    asks(&fields("Mirror()"), Feature::BackSides, true);
    asks(&format!("{}, bounces: 0", fields("Mirror()")), Feature::BackSides, false);
    asks(&fields("Mirror(reflectance: (0, 0, 0))"), Feature::BackSides, false);
    // A picture of surfaces' own colors sends no rays on.
    let own = format!("{}, show: SurfaceColor", fields("Mirror(reflectance: (1, 0, 0))"));
    asks(&own, Feature::Mirror, false);
    looks(&own, &[Look::Constant([1.0; 3]), Look::Constant([1.0, 0.0, 0.0])]);
    // In glass from the other side: through a ball without refraction.
    let glass = fields("Dielectric(ior: 1)");
    asks(&glass, Feature::BackSides, false);
    asks(&glass, Feature::Dielectric, true);
}

/// Two balls, one in the other, of these materials.
fn one_in_another(outer: &str, inner: &str) -> String {
    format!(
        "objects: [Sphere(center: (0, 0, 0), radius: 2, material: {outer}), \
         Sphere(center: (0, 0, 0), radius: 1, material: {inner})], \
         lights: [Point(position: (0, 9, 9))]"
    )
}

#[test]
fn glass_in_glass_is_asked_for_where_rays_meet_it() {
    let nested = |outer: &str, inner: &str, is_asked| {
        asks(&one_in_another(outer, inner), Feature::NestedGlass, is_asked);
    };
    let glass = "Dielectric(ior: 1.5)";
    let sum = "Whitted(transmit: (0.5, 0.5, 0.5), ior: 1.5)";
    nested(glass, glass, true);
    nested(sum, glass, true);
    nested(glass, sum, true);
    nested(glass, "Glazed(ior: 1.5)", true);
    // What these show does not depend on what is around them.
    nested(glass, "Glazed(ior: 1.5, schlick: true)", false);
    nested(glass, "Whitted(reflect: (0.5, 0.5, 0.5))", false);
    nested(glass, "Mirror()", false);
    // An index counts from what is around, and from 1 as if nothing were.
    nested(glass, "Dielectric(ior: 1)", true);
    nested("Dielectric(ior: 1)", glass, false);
    // These let nothing in.
    nested("Glazed(ior: 1.5)", glass, false);
    nested("Whitted(ior: 1.5)", glass, false);
    let nested = one_in_another(glass, glass);
    asks(&format!("{nested}, bounces: 1"), Feature::NestedGlass, false);
    // One behind the other: the first was left before.
    let apart = nested.replace("(0, 0, 0), radius: 1", "(0, 0, -4), radius: 1");
    asks(&apart, Feature::NestedGlass, false);
    // The eye is in what the first plane glazes, and so are the balls.
    let one = apart.replacen(
        "Sphere",
        "Plane(point: (0, -3, 0), normal: (0, N, 0), material: \
                                        Glazed(ior: 1.5)), Sphere",
        1,
    );
    asks(&one.replace('N', "1"), Feature::NestedGlass, false);
    asks(&one.replace('N', "-1"), Feature::NestedGlass, true);
}

#[test]
fn glass_that_was_not_entered_is_asked_for_where_it_is_left() {
    let behind = |object: &str, is_asked| {
        let material = "material: Dielectric(ior: 1.5)";
        let objects = format!("objects: [{}]", object.replace("glass", material));
        asks(&objects, Feature::GlassFromBehind, is_asked);
    };
    behind("Triangle(a: (-1, -1, 0), b: (1, -1, 0), c: (0, 1, 0), glass)", false);
    behind("Triangle(a: (-1, -1, 0), b: (0, 1, 0), c: (1, -1, 0), glass)", true);
    behind("Sphere(center: (0, 0, 0), radius: 1, glass)", false);
    // A disk has no inside, be the eye far from it or near.
    behind("Disk(center: (0, 0, 0), normal: (0, 0, -1), radius: 1, glass)", true);
    behind("Disk(center: (0, 0, 4.5), normal: (0, 0, -1), radius: 1, glass)", true);
    // The eye is in it, or behind it, and in nothing else.
    let around = |more: &str| {
        [
            "Sphere(center: (0, 0, 4), radius: 2, glass)",
            "Box(min: (-1, -1, 4), max: (1, 1, 6), glass)",
            "Plane(point: (0, 0, 0), normal: (0, 0.1, -1), glass)",
            "Cylinder(a: (0, 0, 4), b: (0, 0, 6), radius: 1, glass)",
            "Cone(apex: (0, 0, 8), base: (0, 0, 4), radius: 2, glass)",
            "Torus(center: (3, 0, 5), axis: (0, 1, 0), major_radius: 3, minor_radius: 1, glass)",
            "Group(transform: [Scale(2, 1, 1), Translate(0, 0, 4)], objects: [\
             Sphere(center: (0, 0, 0), radius: 2, glass)])",
        ]
        .map(|object| format!("{object}, {more}"))
    };
    for object in around("") {
        behind(object.trim_end_matches(", "), false);
    }
    let parallel = "camera: Parallel(view_point: (0, 0, 5), view_width: 8, view_height: 6)";
    let ball = "objects: [Sphere(center: (0, 0, 4), radius: 2, material: Dielectric(ior: 1.5))]";
    asks(&format!("{ball}, {parallel}"), Feature::GlassFromBehind, true);
    for object in around("Plane(point: (0, 0, 9), normal: (0, 0, 1))") {
        behind(&object, true);
    }
}

#[test]
fn total_reflection_is_asked_for_of_sums() {
    let total = |material: &str, is_asked| {
        let ball = format!("radius: 1, material: {material}");
        asks(&LIT.replace("radius: 1", &ball), Feature::TotalReflection, is_asked);
    };
    total("Whitted(transmit: (0.5, 0.5, 0.5), ior: 0.6)", true);
    total("Whitted(transmit: (0.5, 0.5, 0.5), reflect: (0.2, 0.2, 0.2), ior: 0.6)", true);
    total("Whitted(transmit: (0.5, 0.5, 0.5), reflect: (0.2, 0.2, 0.2), ior: 1.5)", false);
    total("Whitted(reflect: (0.2, 0.2, 0.2), ior: 0.6)", false);
    total("Dielectric(ior: 0.6)", false);
}

#[test]
fn the_gap_before_shadows_is_asked_for_where_it_is_seen() {
    let near = |z| {
        format!(
            "shading: Radiometric, lights: [Directional(direction: (1, 0, -1))], objects: [\
             Plane(point: (0, 0, 0), normal: (0, 0, 1)), \
             Disk(center: (-2, 0, {z}), normal: (0, 0, 1), radius: 1)]"
        )
    };
    asks(&near(0.0005), Feature::ShadowGap, false);
    let seen = "camera: Parallel(view_point: (0, 0, 0.01), view_width: 0.008, view_height: 0.006)";
    let small = near(0.0005).replace("(-2, 0, 0.0005)", "(-0.001, 0, 0.0005)");
    let small = small.replace("radius: 1", "radius: 0.0007");
    asks(&format!("{seen}, {small}"), Feature::ShadowGap, true);
    asks(&format!("{seen}, {small}, shadows: false"), Feature::ShadowGap, false);
    let classic = small.replace("shading: Radiometric, ", "");
    asks(&format!("{seen}, {classic}"), Feature::ShadowGap, false);
}

#[test]
fn a_plane_reaches_as_far_as_it_is_seen_or_shades() {
    let floor = "objects: [Plane(point: (0, 0, 0), normal: (0, 0, 2))]";
    let reach = |fields: &str| plain(fields).objects[0].reach;
    // The window is 10 high and 40/3 wide at the plane; pixel centers end before.
    let corner = 5.0 * (59.0_f64 / 60.0).hypot(4.0 / 3.0 * 79.0 / 80.0);
    assert!((reach(floor) - corner).abs() < 1e-9);
    let wall = "objects: [Plane(point: (0, 0, -1), normal: (0, 1, 0)), \
                Disk(center: (0, 1, 0), normal: (0, 0, 1), radius: 1)]";
    let below = "lights: [Point(position: (0, -50, 0))]";
    assert!(reach(&format!("{wall}, {below}")) > 0.9);
}

#[test]
fn round_shapes_may_be_moved_and_turned_and_not_stretched() {
    let in_group = |steps: &str, object: &str| {
        format!("show: Silhouette, objects: [Group(transform: [{steps}], objects: [{object}])]")
    };
    let ball = "Sphere(center: (0, 0, 0), radius: 1)";
    let stretched = Feature::StretchedRound;
    let turned = "RotateDeg(10, 20, 30), Scale(2, -2, 2), Translate(1, 2, 3), Scale(0.1, 0.1, 0.1)";
    asks(&in_group(turned, ball), stretched, false);
    asks(&in_group("Scale(1, 1.001, 1)", ball), stretched, true);
    asks(&in_group("Scale(1, 3, 1)", "Box(min: (0, 0, 0), max: (1, 1, 1))"), stretched, false);
    asks(&in_group("Scale(1, 3, 1)", "Mesh(file: \"a.obj\", flat: true)"), stretched, false);
    asks(&in_group("Scale(1, 3, 1)", "Mesh(file: \"a.obj\")"), stretched, true);
    // Group by group, and each from inside out.
    let nested = "objects: [Group(transform: [Translate(1, 0, 0), Scale(2, 2, 2)], objects: [Group(\
                  transform: [RotateDeg(0, 0, 90)], objects: [Sphere(center: (1, 0, 0), \
                  radius: 1)])])]";
    let object = &plain(nested).objects[0];
    let p = object.world_from_object.transform_point3(tracer::glam::DVec3::X);
    assert_eq!(p.to_array(), [2.0, 2.0, 0.0]);
    assert_eq!(object.steps.len(), 3);
}

/// What a scene asks for by its features that only its picture knows, and groups.
#[track_caller]
fn all_of(fields: &str, expected: &[Feature]) {
    let all = crate::export::asks(&read(fields), &assets()).unwrap();
    let found = all.into_iter().filter(|one| one.is_seen() || *one == Feature::Group);
    assert_eq!(found.collect::<Vec<_>>(), expected, "{fields}");
}

#[test]
fn a_scene_asks_for_what_its_file_says_and_what_its_picture_shows() {
    use Feature::*;
    let light = |intensity: &str| format!("Point(position: (0, 0, 9), intensity: {intensity})");
    let white = light("(1, 1, 1)");
    let lit = |object: &str, lights: &str| format!("lights: [{lights}], objects: [{object}]");
    let ball = "Sphere(center: (0, 0, 0), radius: 1)";
    all_of(&lit(ball, &white), &[]);
    all_of(&lit(ball, &format!("{white}, {white}")), &[SeveralLights]);
    // What does not shine, or comes from everywhere, needs no loop over lights; nor does
    // what shows no light.
    all_of(&lit(ball, &format!("{white}, {}", light("(0, 0, 0)"))), &[]);
    all_of(&lit(ball, &format!("{white}, Ambient(intensity: (1, 1, 1))")), &[]);
    all_of(&format!("show: Normals, {}", lit(ball, &format!("{white}, {white}"))), &[]);
    let plain = ball.replace("radius: 1", "radius: 1, material: Constant(color: (1, 1, 1))");
    all_of(&lit(&plain, &format!("{white}, {white}")), &[]);
    // Groups are opened for writers, and are asked for all the same.
    let stretched = format!("Group(transform: [Scale(1, 2, 1)], objects: [{ball}])");
    all_of(&lit(&stretched, &white), &[Group, StretchedRound]);
    let back = "Disk(center: (0, 0, 0), normal: (0, 0, -1), radius: 1, \
                material: BlinnPhong(specular: (1, 0, 0), exponent: 1))";
    all_of(&lit(back, &white), &[ColoredHighlight, BackSides]);
    let glass = |radius: f64, material: &str| {
        format!("Sphere(center: (0, 0, 0), radius: {radius}, material: {material})")
    };
    let outer = glass(2.0, "Dielectric(ior: 1.5)");
    let nested = format!("{outer}, {}", glass(1.0, "Dielectric(ior: 1.2)"));
    all_of(&format!("objects: [{outer}]"), &[]);
    all_of(&format!("objects: [{nested}]"), &[NestedGlass]);
    let back = "Disk(center: (0, 0, 0), normal: (0, 0, -1), radius: 1, \
                material: Dielectric(ior: 1.5))";
    all_of(&format!("objects: [{back}]"), &[GlassFromBehind]);
    let sum = glass(2.0, "Whitted(transmit: (1, 1, 1), ior: 0.7)");
    all_of(&format!("objects: [{sum}]"), &[TotalReflection]);
}
