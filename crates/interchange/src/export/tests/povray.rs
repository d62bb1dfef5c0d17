//! POV-Ray's scenes, word for word.

use super::*;

fn lines(fields: &str, starts: &str) -> Vec<String> {
    let text = main_of(Dialect::PovRay, fields);
    text.lines().filter(|line| line.trim().starts_with(starts)).map(str::to_owned).collect()
}

#[track_caller]
fn check(fields: &str, starts: &str, expected: &[&str]) {
    assert_eq!(lines(fields, starts), expected, "{fields}");
}

/// One object, and the start of what is written for it.
#[track_caller]
fn shape(object: &str, expected: &str) {
    let text = main_of(Dialect::PovRay, &format!("show: Silhouette, objects: [{object}]"));
    let body = text.split_once("\n}\n").unwrap().1;
    let body = body.split_once("\n  texture").unwrap().0;
    assert_eq!(body, expected, "{object}");
}

#[test]
fn shapes() {
    shape("Sphere(center: (1, 2, 3), radius: 0.5)", "sphere { <1,2,3>, 0.5");
    shape("Box(min: (0, 0, 0), max: (1, 1, 1e-7))", "box { <0,0,0>, <1,1,1e-7>");
    shape(
        "Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0))",
        "triangle { <0,0,0>, <0,1,0>, <1,0,0>",
    );
    shape("Plane(point: (1, 2, 3), normal: (0, 2, 0))", "plane { <0,1,0>, 0 translate <1,2,3>");
    shape("Disk(center: (0, 1, 0), normal: (0, 0, 3), radius: 2)", "disc { <0,1,0>, <0,0,1>, 2");
    shape("Cylinder(a: (0, 0, 0), b: (0, 1, 0), radius: 2)", "cylinder { <0,0,0>, <0,1,0>, 2");
    shape(
        "Cone(apex: (0, 1, 0), base: (0, 0, 0), radius: 2, open: true)",
        "cone { <0,0,0>, 2, <0,1,0>, 0 open",
    );
    shape(
        "Torus(center: (0, 1, 0), axis: (0, 9, 0), major_radius: 2, minor_radius: 1)",
        "torus { 2, 1 translate <0,1,0>",
    );
    shape(
        "Torus(center: (0, 1, 0), axis: (0, 0, 1), major_radius: 2, minor_radius: 1)",
        "torus { 2, 1 matrix <0,1,0,0,0,1,1,0,0,0,1,0>",
    );
    shape(
        "Group(transform: [Scale(1, 2, 3), Translate(4, 5, 6)], objects: [\
         Sphere(center: (0, 0, 0), radius: 1)])",
        "sphere { <0,0,0>, 1\n  matrix <1,0,0,0,2,0,0,0,3,4,5,6>",
    );
    // The second triangle lacks a normal and is flat, with corners of its own.
    shape(
        "Mesh(file: \"a.obj\")",
        "mesh2 {\n  vertex_vectors { 6, <0,0,0>,<1,0,0>,<1,1,0>,<0,0,0>,<1,1,0>,<0,1,0> }\
         \n  normal_vectors { 6, <0,0,1>,<0,0,1>,<0,0,1>,<0,0,1>,<0,0,1>,<0,0,1> }\
         \n  face_indices { 2, <0,2,1>,<3,5,4> }",
    );
    shape(
        "Mesh(file: \"a.obj\", flat: true)",
        "mesh2 {\n  vertex_vectors { 4, <0,0,0>,<1,0,0>,<1,1,0>,<0,1,0> }\
         \n  face_indices { 2, <0,2,1>,<0,3,2> }",
    );
}

#[test]
fn cameras() {
    let at = |camera: &str| {
        let text = main_of(Dialect::PovRay, &format!("camera: {camera}"));
        let start = text.find("camera {").unwrap();
        text[start..].replace("\n ", "").trim_end().to_owned()
    };
    assert_eq!(
        at("Perspective(view_point: (1, 2, 3), view_width: 4, view_height: 5, proj_distance: 6)"),
        "camera { location <1,2,3> direction <0,0,-6> right <4,0,0> up <0,5,0>\n}"
    );
    assert_eq!(
        at("Parallel(view_point: (0, 0, 3), view_dir: (0, 3, -4), proj_normal: (0, 0, 1))"),
        "camera { orthographic location <0,0,3> direction <0,0.6,-0.8> right <1,0,0> up <0,1,0>\n}"
    );
}

#[test]
fn lights_are_in_the_units_of_the_convention() {
    let lit = |more: &str| LIT.replace("(3, 4, 5)", &format!("(3, 4, 5), {more}"));
    let light = "light_source";
    check(&lit("intensity: (1, 2, 3)"), light, &["light_source { <3,4,5> rgb <1,2,3> }"]);
    let faded = "light_source { <3,4,5> rgb <500000000000,500000000000,500000000000> \
                 fade_distance 1e-6 fade_power 2 }";
    check(&format!("{LIT}, shading: Attenuated"), light, &[faded]);
    check(&lit("falloff: InverseSquare"), light, &[faded]);
    let by_pi = faded.replace("500000000000", "159154943091.89536");
    check(&format!("{LIT}, shading: Radiometric"), light, &[&by_pi]);
    check(
        "objects: [Sphere(center: (0, 0, 0), radius: 1)], \
         lights: [Directional(direction: (0, -2, 0)), Ambient(intensity: (1, 1, 1))]",
        light,
        &["light_source { <0,1000000,0> rgb <1,1,1> parallel point_at 0 }"],
    );
}

#[test]
fn looks() {
    let look = |fields: &str, expected: &str| check(fields, "texture", &[expected]);
    let made_of =
        |material: &str| LIT.replace("radius: 1", &format!("radius: 1, material: {material}"));
    look(LIT, "  texture { pigment { rgb <1,1,1> } finish { diffuse 1 } }");
    look(
        &format!("{LIT}, shadows: false"),
        "  texture { pigment { rgb <1,1,1> } finish { diffuse 1 } } no_shadow",
    );
    look(
        &made_of("Constant(color: (1, 2, 3))"),
        "  texture { pigment { rgb <1,2,3> } finish { emission 1 } }",
    );
    look(
        &made_of("BlinnPhong(diffuse: (1, 0, 0), specular: (0.5, 0.5, 0.5), exponent: 4)"),
        "  texture { pigment { rgb <1,0,0> } finish { diffuse 1 specular 0.5 roughness 0.25 } }",
    );
    check(
        &made_of("BlinnPhong(diffuse: (1, 0, 0), specular: (0.5, 0.25, 0), exponent: 4)"),
        "texture",
        &[
            "  texture { pigment { rgb 0 } finish { specular 1 roughness 0.25 } }",
            "  texture { pigment { rgbf <1,0.5,0,1> } }",
            "  texture { pigment { rgbt <1,0,0,0.5> } finish { diffuse 2 } }",
        ],
    );
    let with_ambient = LIT.replace("))]", ")), Ambient(intensity: (0.5, 0.5, 1))]");
    look(
        &with_ambient,
        "  texture { pigment { rgb <1,1,1> } finish { diffuse 1 emission rgb <0.5,0.5,1> } }",
    );
    let normals = lines(&format!("{LIT}, show: Normals"), "texture").concat();
    for part in ["slope <-1,0,0>", "slope <0,-1,0>", "slope <0,0,-1>", "[1 rgb <0,3,0>]"] {
        assert!(normals.contains(part), "{normals}");
    }
    look(
        &format!("{LIT}, show: Depth(near: 1, far: 3)"),
        "  texture { pigment { function { min(1,max(0,(3-(sqrt(pow(x-(0),2)+pow(y-(0),2)+\
         pow(z-(5),2))))/2)) } color_map { [0 rgb 0] [1 rgb 1] } } finish { emission 1 } }",
    );
}

#[test]
fn backs_are_written_where_they_are_seen() {
    let disk = "objects: [Disk(center: (0, 0, 0), normal: (0, 0, -1), radius: 1)], \
                lights: [Point(position: (0, 0, -4))]";
    check(
        disk,
        "interior_texture",
        &["  interior_texture { pigment { rgb <1,1,1> } finish { diffuse 0, 1 } }"],
    );
    check(
        &format!("{disk}, shading: Radiometric"),
        "interior_texture",
        &["  interior_texture { pigment { rgb <0.2,0.2,0.2> } finish { diffuse 0 } }"],
    );
    check(&disk.replace("0, -1)", "0, 1)"), "interior_texture", &[]);
}

#[test]
fn mirrors_and_glass() {
    let look = |material: &str, expected: &[&str]| {
        let made_of = format!("radius: 1, material: {material}");
        check(&LIT.replace("radius: 1", &made_of), "texture", expected);
    };
    look(
        "Mirror(reflectance: (0.5, 0.25, 1))",
        &["  texture { pigment { rgb 0 } finish { reflection { rgb <0.5,0.25,1> } } }"],
    );
    look(
        "Mirror(reflectance: (0.5, 0.25, 1), schlick: true)",
        &[
            "  texture { pigment { rgb 0 } finish { reflection { rgb <0.5,0.25,1>, rgb 1 falloff 5 } } }",
        ],
    );
    let fresnel = "finish { reflection { rgb 0, rgb 1 fresnel on } conserve_energy } }";
    look(
        "Dielectric(ior: 1.5, tint: (1, 0.5, 1))",
        &[&format!("  texture {{ pigment {{ rgbf <1,0.5,1,1> }} {fresnel}")],
    );
    let lit = "  texture { pigment { rgb <1,1,1> } finish { diffuse 1 } }";
    look("Glazed(ior: 1.5)", &[lit, &format!("  texture {{ pigment {{ rgbf 1 }} {fresnel}")]);
    look(
        "Glazed(ior: 3, schlick: true)",
        &[
            lit,
            "  texture { pigment { rgbf 1 } finish { reflection { rgb <0.25,0.25,0.25>, rgb 1 \
             falloff 5 } conserve_energy } }",
        ],
    );
    let reflecting = "  texture { pigment { rgbf 1 } finish { reflection { rgb <0.5,0.5,0.5> } } }";
    look("Whitted(reflect: (0.5, 0.5, 0.5))", &[lit, reflecting]);
    // By Schlick's law nothing straight on is all of it along the surface.
    let growing =
        "  texture { pigment { rgbf 1 } finish { reflection { rgb <0,0,0>, rgb 1 falloff 5 } } }";
    look("Whitted(schlick: true)", &[lit, growing]);
    look(
        "Whitted(reflect: (0.5, 0.5, 0.5), transmit: (0.25, 0, 0), ior: 1.5)",
        &[
            "  texture { pigment { rgbf <0.5,0,0,1> } }",
            "  texture { pigment { rgbt <1,1,1,0.5> } finish { diffuse 2 } }",
            reflecting,
            "  texture { pigment { rgb 0 } } no_image no_reflection",
        ],
    );
    let glass = LIT.replace("radius: 1", "radius: 1, material: Dielectric(ior: 1.5)");
    check(&glass, "interior", &["  interior { ior 1.5 } no_shadow"]);
    check(&format!("{glass}, shadows: false"), "interior", &["  interior { ior 1.5 } no_shadow"]);
    // Another one that casts shadows stands where there are any.
    let twin = "  texture { pigment { rgb 0 } } no_image no_reflection";
    let floor =
        glass.replace("objects: [", "objects: [Plane(point: (0, -1, 0), normal: (0, 1, 0)), ");
    check(&floor, "texture { pigment { rgb 0 }", &[twin]);
    check(&floor.replace("Point(position: (3, 4, 5))", ""), "texture { pigment { rgb 0 }", &[]);
    check(&format!("{floor}, shadows: false"), "texture { pigment { rgb 0 }", &[]);
    // The eye is in the glass alone.
    let around = floor.replace("center: (0, 0, 0)", "center: (0, 0, 5)");
    check(&around, "texture { pigment { rgb 0 }", &[&format!("{twin} inverse")]);
    let levels = |fields: &str| lines(fields, "global_settings").concat();
    assert!(levels(LIT).ends_with("max_trace_level 1 }"));
    assert!(levels(&glass).ends_with("max_trace_level 6 adc_bailout 0 }"));
    assert!(levels(&format!("{glass}, bounces: 2")).ends_with("max_trace_level 3 adc_bailout 0 }"));
}

#[test]
fn textures() {
    let made_of = |shape: &str, material: &str| {
        format!("objects: [{}]", shape.replace("material", &format!("material: {material}")))
    };
    let constant = |texture: &str| format!("Constant(color: (1, 2, 3), texture: {texture})");
    let wall = "Plane(point: (1, 2, 3), normal: (0, 0, 1), material)";
    let checker = "Checker(a: (1, 1, 1), b: (0, 0, 1), scale: (2, 1), offset: (0, 0.5))";
    let u = "((2)*((1)*(x-(1))+(0)*(y-(2))+(0)*(z-(3)))+(0))";
    let v = "((1)*((0)*(x-(1))+(1)*(y-(2))+(0)*(z-(3)))+(0.5))";
    check(
        &made_of(wall, &constant(checker)),
        "texture",
        &[&format!(
            "  texture {{ pigment {{ function {{ 0.25+0.5*abs(mod(floor({u})+floor({v}),2)) }} \
             color_map {{ [0.5 rgb <1,2,3>] [0.5 rgb <0,0,3>] }} }} finish {{ emission 1 }} }}"
        )],
    );
    let ball = "Sphere(center: (1, 0, 0), radius: 2, material)";
    let in_group = made_of(
        &format!("Group(transform: [Translate(4, 5, 6)], objects: [{ball}])"),
        &constant(checker),
    );
    let text = lines(&in_group, "texture").concat();
    assert!(text.contains("0.5+atan2((x-(1)),(z-(0)))/6.283185307179586"), "{text}");
    let placed = "[0.5 rgb <0,0,3>] } matrix <1,0,0,0,1,0,0,0,1,4,5,6> }";
    assert!(text.contains(placed), "{text}");
    // What shows no texture asks for none.
    for show in ["Silhouette", "Normals", "ObjectIds"] {
        let text = main_of(Dialect::PovRay, &format!("{in_group}, show: {show}"));
        assert!(!text.contains("function { 0.25"), "{text}");
    }
    let text = main_of(Dialect::PovRay, &format!("{in_group}, show: SurfaceColor"));
    assert!(text.contains("function { 0.25"), "{text}");
}

#[test]
fn a_textured_mesh_may_have_layers() {
    let quad = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    let assets = BTreeMap::from([("a.obj".to_owned(), quad.into())]);
    let fields = "objects: [Mesh(file: \"a.obj\", material: Whitted(reflect: (0.5, 0.5, 0.5), \
                  texture: Checker(a: (1, 1, 1), b: (0, 0, 1))))], lights: [Point(position: (0, \
                  0, 4))]";
    let exported = export(Dialect::PovRay, &read(fields), &assets).unwrap();
    let text = text(&exported, &exported.main);
    let layers: Vec<_> = text.lines().filter(|line| line.starts_with("  texture")).collect();
    assert_eq!(
        layers,
        [
            "  texture { pigment { uv_mapping function { \
             0.25+0.5*abs(mod(floor(((1)*(x)+(0)))+floor(((1)*(y)+(0))),2)) } color_map { \
             [0.5 rgb <1,1,1>] [0.5 rgb <0,0,1>] } } finish { diffuse 1 } }",
            "  texture { pigment { rgbf 1 } finish { reflection { rgb <0.5,0.5,0.5> } } }",
        ]
    );
}

#[test]
fn pictures_are_written_beside() {
    let fields = "objects: [Plane(point: (0, 0, 0), normal: (0, 0, 1), material: Lambert(texture: \
                  Image(file: \"a.png\", wrap: Clamp, filter: Nearest, encoding: Linear)))], \
                  lights: [Point(position: (0, 0, 4))]";
    let assets = BTreeMap::from([("a.png".to_owned(), png_with_gamma())]);
    let exported = export(Dialect::PovRay, &read(fields), &assets).unwrap();
    let text = text(&exported, &exported.main);
    let declared = "#declare Texture0 = function { pigment { image_map { png \"texture-0.png\" \
                    gamma 1.0 } } }";
    assert!(text.contains(declared), "{text}");
    // Of a picture two wide and one high: to the middles of its outer texels.
    for part in ["min(0.75,max(0.25,", "min(0.5,max(0.5,", "[1 rgb <6,0,0>]", "diffuse 1"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let written = &exported.files["texture-0.png"];
    let read = |bytes: &[u8]| {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut codes = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut codes).unwrap();
        (bytes.windows(4).any(|name| name == b"gAMA"), codes)
    };
    assert_eq!(read(&png_with_gamma()), (true, vec![1, 2, 3, 4, 5, 6]));
    assert_eq!(read(written), (false, vec![1, 2, 3, 4, 5, 6]));
}

/// Two pixels that say of themselves how bright they are.
fn png_with_gamma() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_source_gamma(png::ScaledFloat::new(0.75));
    encoder.write_header().unwrap().write_image_data(&[1, 2, 3, 4, 5, 6]).unwrap();
    bytes
}

#[test]
fn what_it_cannot_say_is_refused() {
    let glossy = "radius: 1, material: BlinnPhong(specular: (1, 1, 1), exponent: 2)";
    let radiometric = format!("{}, shading: Radiometric", LIT.replace("radius: 1", glossy));
    refused(Dialect::PovRay, &radiometric, &[Feature::BlinnPhong, Feature::Radiometric]);
    let back = "objects: [Disk(center: (0, 0, 0), normal: (0, 0, -1), radius: 1)], \
                lights: [Point(position: (0, 0, -6))]";
    let back = back.replace("radius: 1", glossy);
    refused(Dialect::PovRay, &back, &[Feature::HighlightFromBehind]);
    let glass = "radius: 1, material: Dielectric(ior: 1.5, schlick: true)";
    let glass = LIT.replace("radius: 1", glass);
    refused(Dialect::PovRay, &glass, &[Feature::Dielectric, Feature::Schlick]);
    let thin = "radius: 1, material: Glazed(ior: 0.7, schlick: true)";
    let thin = LIT.replace("radius: 1", thin);
    refused(Dialect::PovRay, &thin, &[Feature::Glazed, Feature::Schlick]);
    let colored =
        "radius: 1, material: Whitted(specular: (1, 0, 0), exponent: 1e3, transmit: (1, 1, 1))";
    let colored = LIT.replace("radius: 1", colored);
    refused(Dialect::PovRay, &colored, &[Feature::Whitted, Feature::ColoredHighlight]);
    let around = "objects: [Sphere(center: (0, 0, 0), radius: 2, material: OUTER), \
                  Sphere(center: (0, 0, 0), radius: 1, material: Dielectric(ior: 1.5))]";
    let nested = around.replace("OUTER", "Dielectric(ior: 1.2)");
    refused(Dialect::PovRay, &nested, &[Feature::NestedGlass]);
    let total =
        LIT.replace("radius: 1", "radius: 1, material: Whitted(transmit: (1, 1, 1), ior: 0.6)");
    refused(Dialect::PovRay, &total, &[Feature::TotalReflection]);
    let triangle = "objects: [Triangle(a: (-1, -1, 0), b: (0, 1, 0), c: (1, -1, 0), material: \
                    Dielectric(ior: 1.5))]";
    refused(Dialect::PovRay, triangle, &[Feature::GlassFromBehind]);
    let low = "objects: [Disk(center: (0, 0, 0), normal: (0, 0, 1), radius: 1)], \
               lights: [Point(position: (9, 0, -1))]";
    refused(Dialect::PovRay, &low.replace("radius: 1", glossy), &[Feature::HighlightFromBehind]);
}

#[test]
fn samples_on_a_grid_are_a_larger_picture() {
    assert_eq!(written(Dialect::PovRay, "samples_per_pixel: 9").grid, 3);
    assert_eq!(written(Dialect::PovRay, "objects: []").grid, 1);
}
