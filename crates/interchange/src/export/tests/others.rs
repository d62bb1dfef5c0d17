//! pbrt's scenes and OBJ files, word for word.

use super::*;

#[test]
fn a_scene_of_pbrt() {
    let fields = format!("{LIT}, shading: Radiometric, samples_per_pixel: 4");
    let expected = "\
Scale -1 1 1
LookAt 0 0 5  0 0 4  0 1 0
Camera \"perspective\" \"float fov\" 90 \"float screenwindow\" [WINDOW]
Film \"rgb\" \"integer xresolution\" 80 \"integer yresolution\" 60 \"string filename\" \"scene.exr\"
PixelFilter \"box\" \"float xradius\" 0.5 \"float yradius\" 0.5
Sampler \"stratified\" \"integer xsamples\" 2 \"integer ysamples\" 2 \"bool jitter\" false
Integrator \"path\" \"integer maxdepth\" 1
WorldBegin
LightSource \"point\" \"rgb I\" [1 1 1] \"point3 from\" [3 4 5]
AttributeBegin
Material \"diffuse\" \"rgb reflectance\" [0.2 0.2 0.2]
Translate 0 0 0
Shape \"sphere\" \"float radius\" 1
AttributeEnd
";
    let text = main_of(Dialect::Pbrt, &fields);
    let (before, rest) = text.split_once("screenwindow\" [").unwrap();
    let (window, after) = rest.split_once(']').unwrap();
    assert_eq!(format!("{before}screenwindow\" [WINDOW]{after}"), expected);
    let window: Vec<f64> = window.split(' ').map(|word| word.parse().unwrap()).collect();
    let near = |x: f64, y: f64| (x - y).abs() < 1e-15;
    assert!(window.iter().zip([-4.0 / 3.0, 4.0 / 3.0, -1.0, 1.0]).all(|(x, y)| near(*x, y)));
}

#[test]
fn shapes_of_pbrt() {
    let part = |objects: &str, expected: &str| {
        let text = main_of(Dialect::Pbrt, &format!("show: Silhouette, objects: [{objects}]"));
        assert!(text.contains(expected), "{text}");
        assert!(text.contains("\"integer maxdepth\" 0"));
    };
    part(
        "Cylinder(a: (1, 2, 3), b: (1, 2, 5), radius: 0.5)",
        "ConcatTransform [0 1 0 0 -1 0 0 0 0 0 1 0 1 2 3 1]\n\
         Shape \"cylinder\" \"float radius\" 0.5 \"float zmin\" 0 \"float zmax\" 2\n\
         Shape \"disk\" \"float radius\" 0.5 \"float height\" 0\n\
         Shape \"disk\" \"float radius\" 0.5 \"float height\" 2\nAttributeEnd\n",
    );
    part(
        "Plane(point: (0, 0, 0), normal: (0, 0, 1))",
        "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" true\n\
         Shape \"plymesh\" \"string filename\" \"triangles-0.ply\"\n",
    );
}

#[test]
fn what_pbrt_has_no_words_for() {
    let cannot = |fields: &str, expected: &[Feature]| refused(Dialect::Pbrt, fields, expected);
    cannot(LIT, &[Feature::ConstantPointLight]);
    let attenuated = format!("{LIT}, shading: Attenuated");
    let two = attenuated.replace("lights: [", "lights: [Point(position: (0, 9, 0)), ");
    cannot(&two, &[Feature::SeveralLights]);
    cannot(
        &format!("{attenuated}, background: (1, 0, 0)"),
        &[Feature::Lambert, Feature::Background],
    );
    let beside = "objects: [Sphere(center: (3, 0, 0), radius: 1, \
                  material: Constant(color: (1, 0, 0))), ";
    cannot(&attenuated.replace("objects: [", beside), &[Feature::Constant, Feature::Lambert]);
    let back = "objects: [Disk(center: (0, 0, 0), normal: (0, 0, -1), radius: 1)], \
                lights: [Directional(direction: (0, 0, 1))]";
    cannot(back, &[Feature::BackSides]);
    cannot(
        "camera: Parallel(view_point: (0, 0, 0), proj_normal: (0, 1, 1))",
        &[Feature::Parallel, Feature::Oblique],
    );
}

#[test]
fn an_obj_file_with_its_materials() {
    let fields = "lights: [Point(position: (3, 4, 5))], objects: [\
                  Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0)), \
                  Mesh(file: \"a.obj\", material: BlinnPhong(diffuse: (0.5, 0, 0), \
                  specular: (1, 1, 0), exponent: 9)), \
                  Triangle(a: (0, 0, 1), b: (1, 0, 1), c: (0, 1, 1))]";
    let exported = written(Dialect::Obj, fields);
    let obj = text(&exported, "scene.obj");
    assert!(obj.starts_with(
        "mtllib scene.mtl\no object0\nusemtl m0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\
         o object1\nusemtl m1\nv 0 0 0\n"
    ));
    assert!(obj.ends_with("o object2\nusemtl m0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 10 11 12\n"));
    assert!(obj.contains("f 4//1 5//2 6//3\nf 7//4 8//5 9//6\n"));
    assert_eq!(
        text(&exported, "scene.mtl"),
        "newmtl m0\nKd 1 1 1\nillum 1\nnewmtl m1\nKd 0.5 0 0\nKs 1 1 0\nNs 9\nillum 2\n"
    );
    let back = scene::read_mesh("scene.obj", obj.as_bytes()).unwrap();
    assert_eq!(back.faces.len(), 4);
    assert_eq!(
        exported.beside,
        [Feature::Perspective, Feature::ConstantPointLight, Feature::Shadows, Feature::Classic]
            .into()
    );
    refused(Dialect::Obj, LIT, &[Feature::Sphere]);
    refused(
        Dialect::Obj,
        "show: Depth(near: 1, far: 2), objects: [Disk(center: (0, 0, 0), normal: (0, 0, 1), \
         radius: 1)]",
        &[Feature::Disk, Feature::Depth],
    );
}
