//! What the course's elements mean, and what of them is lost.

use scene::NoAssets;
use scene::format::{Camera, Light, Material, Object, Shading, Transform};

use super::{BALL, loses, read, with};
use crate::import::{Source, Wishes, import};

#[test]
fn what_is_not_known_is_lost_by_name_and_place() {
    loses("<samples>8</samples>", &["6:1: samples: is not known inside scene and is left out"]);
    loses("<cylinder/>\n <fog>1</fog>", &["6:1: cylinder", "7:2: fog"]);
    loses("<exposure unit=\"ev\">2</exposure>", &["exposure: the attribute unit=\"ev\""]);
    loses("<exposure>2<b/></exposure>", &["6:12: b: is not known inside exposure"]);
    loses("<exposure>2</exposure><exposure>3</exposure>", &["6:1: exposure: stands twice"]);
    loses("stray", &["scene: the text \"stray\" between elements is left out"]);
    loses("<surface type=\"Torus\"/>", &["surface: the type torus is not known"]);
    loses("<surface type=\"Sphere\" castsShadow=\"no\"/>", &["the attribute castsShadow=\"no\""]);
    let twice = "<surface type=\"Sphere\"><radius>1</radius><radius>2</radius></surface>";
    let imported = loses(twice, &["6:24: radius: stands twice"]);
    assert!(matches!(imported.scene.objects[1], Object::Sphere { radius: 2.0, .. }));
    loses("<light type=\"AmbientLight\"/>", &["light: only point lights are known"]);
    loses("<light><shadows>no</shadows></light>", &["shadows: is not known inside light"]);
    loses("<shader type=\"Normal\"/>", &["shader: has no name"]);
    loses(
        "<shader name=\"a\" type=\"CookTorrance\"/>",
        &["shader: the type CookTorrance is not known"],
    );
    let again = "<shader name=\"a\" type=\"Normal\"/>".repeat(2);
    loses(&again, &["\"a\" is the name of a shader before it"]);
    let woven = "<shader name=\"a\" type=\"Phong\"><texture type=\"RepeatTexture\"/></shader>";
    loses(woven, &["texture: is not known inside shader"]);
    loses("<x:light xmlns:x=\"urn:x\"/>", &["light: is not known inside scene"]);
    let imported = with(&"<a/>".repeat(1_500)).unwrap();
    assert_eq!(imported.lost.len(), 1_001);
    assert_eq!(imported.lost[1_000].what, "500 further losses are not listed");
}

#[test]
fn names_are_read_in_any_case() {
    let text = r#"<Scene><CAMERA TYPE="orthographiccamera"><viewpoint>0 0 5</viewpoint>
        <VIEWWIDTH>4</VIEWWIDTH></CAMERA><Image>4 3</Image><SHADER NAME="a" Type="LAMBERTIAN"/>
        <surface type="box"><minpt>-1 -1 -1</minpt><MaxPt>1 1 1</MaxPt><Shader Ref="a"/></surface>
        </Scene>"#;
    let imported = read(text).unwrap();
    assert_eq!(imported.lost, []);
    let Camera::Parallel { view_width, .. } = imported.scene.camera else { panic!("parallel") };
    assert_eq!(view_width, 4.0);
    let material = Some(Material::Named("a".to_owned()));
    let found = &imported.scene.objects[..];
    assert_eq!(found, [Object::Box { min: [-1.0; 3], max: [1.0; 3], material }]);
}

#[test]
fn defaults_are_those_of_the_classic_files() {
    let scene = with("<light/>").unwrap().scene;
    let expected = Camera::Perspective {
        view_point: [0.0, 0.0, 5.0],
        view_dir: [0.0, 0.0, -1.0],
        view_up: [0.0, 1.0, 0.0],
        proj_normal: None,
        view_width: 1.0,
        view_height: 1.0,
        proj_distance: 1.0,
    };
    assert_eq!(scene.camera, expected);
    assert_eq!(scene.image, (4, 3));
    assert_eq!(scene.objects, [Object::Sphere { center: [0.0; 3], radius: 1.0, material: None }]);
    let light = Light::Point { position: [0.0; 3], intensity: [1.0; 3], falloff: None };
    assert_eq!(scene.lights, [light]);
    assert_eq!((scene.exposure, scene.background), (1.0, [0.0; 3]));
}

#[test]
fn cameras_keep_every_field() {
    let fields = "<viewPoint>1 2 3</viewPoint><viewDir>0 0 -2</viewDir><viewUp>0 3 0</viewUp>\
                  <projNormal>0 1 4</projNormal><viewWidth>5</viewWidth><viewHeight>6</viewHeight>";
    let camera = |kind: &str, more: &str| {
        let camera = format!("<camera{kind}>{fields}{more}</camera>");
        let old = "<camera><viewPoint>0 0 5</viewPoint></camera>";
        assert!(BALL.contains(old));
        let imported = read(BALL.replace(old, &camera)).unwrap();
        assert_eq!(imported.lost, []);
        imported.scene.camera
    };
    let (view_point, view_dir, view_up) = ([1.0, 2.0, 3.0], [0.0, 0.0, -2.0], [0.0, 3.0, 0.0]);
    let (proj_normal, view_width, view_height) = (Some([0.0, 1.0, 4.0]), 5.0, 6.0);
    let perspective = Camera::Perspective {
        view_point,
        view_dir,
        view_up,
        proj_normal,
        view_width,
        view_height,
        proj_distance: 7.0,
    };
    assert_eq!(camera("", "<projDistance>7</projDistance>"), perspective);
    let parallel =
        Camera::Parallel { view_point, view_dir, view_up, proj_normal, view_width, view_height };
    assert_eq!(camera(" type=\"OrthographicCamera\"", ""), parallel);
}

#[test]
fn the_convention_is_asked_for_or_guessed_and_said() {
    #[track_caller]
    fn check(text: &str, expected: Shading, said: &str) {
        let imported = read(text).unwrap();
        assert_eq!(imported.scene.shading, expected);
        assert!(imported.chosen[0].contains(said), "{:?}", imported.chosen);
    }
    let typed = BALL.replace("<camera>", "<camera type=\"PerspectiveCamera\">");
    let more = |more: &str| BALL.replace("</scene>", &format!("{more}</scene>"));
    check(BALL, Shading::Classic, "its camera has no type");
    check(&typed, Shading::Radiometric, "its camera has a type");
    check(&more("<exposure>2</exposure>"), Shading::Radiometric, "the element exposure");
    check(&more("<backColor>0 0 0</backColor>"), Shading::Radiometric, "the element backcolor");
    check(&more("<surface type=\"Group\"/>"), Shading::Attenuated, "the type group");
    let old = BALL.replace("<camera>", "<camera type=\"ParallelCamera\">");
    check(&old, Shading::Classic, "Classic shading");
    let wishes = Wishes { shading: Some(Shading::Attenuated), ..Wishes::default() };
    let source = Source { name: "a.XML", bytes: typed.as_bytes() };
    let asked = import(source, &wishes, &NoAssets).unwrap();
    assert_eq!(asked.scene.shading, Shading::Attenuated);
    assert_eq!(asked.chosen, ["Attenuated shading, as was asked"]);
}

#[test]
fn shaders_become_materials() {
    #[track_caller]
    fn check(shader: &str, expected: &Material) {
        let imported = with(&format!("<surface type=\"Sphere\">{shader}</surface>")).unwrap();
        assert_eq!(imported.lost, []);
        assert_eq!(imported.scene.objects[1].material(), Some(expected), "{shader}");
    }
    let color = [0.2, 0.5, 1.0];
    check("<shader type=\"Lambertian\"/>", &Material::Lambert { diffuse: None, texture: None });
    check(
        "<shader type=\"Lambertian\"><diffuseColor>.2 .5 1</diffuseColor></shader>",
        &Material::Lambert { diffuse: Some(color), texture: None },
    );
    check(
        "<shader type=\"Phong\"/>",
        &Material::BlinnPhong { diffuse: None, specular: [1.0; 3], exponent: 1.0, texture: None },
    );
    check(
        "<shader type=\"Phong\"><diffuseColor>.2f .5D 1.</diffuseColor>\
         <specularColor>0 <!-- red --> 0 1</specularColor><exponent>5e1</exponent></shader>",
        &Material::BlinnPhong {
            diffuse: Some(color),
            specular: [0.0, 0.0, 1.0],
            exponent: 50.0,
            texture: None,
        },
    );
    check(
        "<shader type=\"Constant\"><color>.2 .5 1</color></shader>",
        &Material::Constant { color, texture: None },
    );
    for kind in ["Normal", "RGBNormals", "ShowNormal"] {
        check(&format!("<shader type=\"{kind}\"></shader>"), &Material::Normal);
    }
    // The later years' Phong is white where it does not say, unlike Lambert.
    let later = with("<exposure>1</exposure><shader name=\"a\" type=\"Phong\"/>").unwrap();
    let white = Material::BlinnPhong {
        diffuse: Some([1.0; 3]),
        specular: [1.0; 3],
        exponent: 1.0,
        texture: None,
    };
    assert_eq!(later.scene.materials["a"], white);
    let after = "<surface type=\"Box\"><shader ref=\"a\"/><maxPt>1 1 1</maxPt></surface>\
                 <shader name=\"a\" type=\"Normal\"/>";
    assert_eq!(with(after).unwrap().lost, [], "a shader after its surface");
    let problems = with(&after.replace("ref=\"a\"", "ref=\"A\"")).unwrap_err();
    assert_eq!(problems[0].message, "shader: no shader of the scene is named \"A\"");
}

#[test]
fn surfaces_become_objects() {
    #[track_caller]
    fn check(surface: &str, expected: &Object) {
        let imported = with(surface).unwrap();
        assert_eq!(imported.lost, []);
        assert_eq!(imported.scene.objects[1], *expected, "{surface}");
        imported.text("a.xml").unwrap();
    }
    let (o, x, y, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let triangle = Object::Triangle { a: o, b: x, c: y, material: None };
    check("<surface type='Triangle'><a>0 0 0</a><b>1 0 0</b><c>0 1 0</c></surface>", &triangle);
    check(
        "<surface type='Triangle'><v0>0 0 0</v0><v1>1 0 0</v1><v2>0 1 0</v2></surface>",
        &triangle,
    );
    let plane = Object::Plane { point: x, normal: y, material: None };
    check("<surface type='Plane'><point>1 0 0</point><normal>0 1 0</normal></surface>", &plane);
    let disk = Object::Disk { center: x, normal: y, radius: 2.0, material: None };
    check(
        "<surface type='Disk'><center>1 0 0</center><normal>0 1 0</normal><radius>2</radius>\
         </surface>",
        &disk,
    );
    let (a, b) = ([1.0, 0.0, -2.0], [1.0, 0.0, 2.0]);
    check(
        "<surface type='Cylinder'><center>1 0 0</center><height>4</height></surface>",
        &Object::Cylinder { a, b, radius: 1.0, open: false, material: None },
    );
    let ball = |center| Object::Sphere { center, radius: 1.0, material: None };
    let inner = Object::Group {
        transform: vec![Transform::Scale(1.0, 2.0, 3.0)],
        objects: vec![ball(z)],
        material: None,
    };
    check(
        "<surface type='Group'><shader type='Normal'/><translate>1 2 3</translate>\
         <surface type='Sphere'/><rotate>10 20 30</rotate><surface type='Group'>\
         <scale>1 2 3</scale><surface type='Sphere'><center>0 0 1</center></surface></surface>\
         <translate>0 0 1</translate></surface>",
        &Object::Group {
            transform: vec![
                Transform::Translate(1.0, 2.0, 3.0),
                Transform::RotateDeg(10.0, 20.0, 30.0),
                Transform::Translate(0.0, 0.0, 1.0),
            ],
            objects: vec![ball(o), inner],
            material: Some(Material::Normal),
        },
    );
}

#[test]
fn wishes_stand_in_for_what_the_file_lacks() {
    let camera = Wishes::camera("LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40)").unwrap();
    let wishes = Wishes { camera: Some(camera), image: Some((8, 6)), shading: None };
    let source = Source { name: "a.xml", bytes: b"<scene/>" };
    let imported = import(source, &wishes, &NoAssets).unwrap();
    assert_eq!((imported.scene.camera, imported.scene.image), (camera, (8, 6)));
    let said = imported.chosen.join("; ");
    assert!(said.contains("8 x 6 pixels, as was asked; the camera that was asked for"), "{said}");
}
