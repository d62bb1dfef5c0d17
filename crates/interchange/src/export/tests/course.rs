//! The course's XML and NFF, word for word.

use super::*;

#[test]
fn a_scene_of_the_course() {
    let fields = "camera: Perspective(view_point: (1, 2, 3), view_width: 4, view_height: 3), \
                  background: (0, 0, 0.5), lights: [Point(position: (3, 4, 5))], objects: [\
                  Sphere(center: (0, 0, 0), radius: 1, material: BlinnPhong(\
                  diffuse: (1, 0, 0), specular: (0, 1, 0), exponent: 20)), \
                  Group(transform: [RotateDeg(0, 90, 0), Translate(1, 0, 0)], objects: [\
                  Mesh(file: \"a.obj\", flat: true)])]";
    let exported = written(Dialect::CornellXml, fields);
    let expected = "\
<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<!-- Shading: Classic -->
<scene>
  <camera>
  <viewPoint>1 2 3</viewPoint>
  <viewDir>0 0 -1</viewDir>
  <projNormal>0 0 1</projNormal>
  <viewUp>0 1 0</viewUp>
  <projDistance>1</projDistance>
  <viewWidth>4</viewWidth>
  <viewHeight>3</viewHeight>
  </camera>
  <image>80 60</image>
  <backColor>0 0 0.5</backColor>
  <light>
  <position>3 4 5</position>
  <intensity>1 1 1</intensity>
  </light>
  <surface type=\"Sphere\">
  <shader type=\"Phong\">
  <diffuseColor>1 0 0</diffuseColor>
  <specularColor>0 1 0</specularColor>
  <exponent>20</exponent>
  </shader>
  <center>0 0 0</center>
  <radius>1</radius>
  </surface>
  <surface type=\"Group\">
  <rotate>0 90 0</rotate>
  <translate>1 0 0</translate>
  <surface type=\"Mesh\">
  <shader type=\"Lambertian\">
  <diffuseColor>1 1 1</diffuseColor>
  </shader>
  <data>mesh-0.obj</data>
  </surface>
  </surface>
</scene>
";
    assert_eq!(text(&exported, "scene.xml"), expected);
    let mesh = text(&exported, "mesh-0.obj");
    assert_eq!(mesh, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    let back = scene::read_mesh("mesh-0.obj", mesh.as_bytes()).unwrap();
    assert_eq!(back.faces, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(exported.beside, [Feature::Classic].into());
}

#[test]
fn what_the_course_has_no_words_for() {
    let cannot =
        |fields: &str, expected: &[Feature]| refused(Dialect::CornellXml, fields, expected);
    cannot(
        &LIT.replace("(3, 4, 5)", "(3, 4, 5), falloff: InverseSquare"),
        &[Feature::InverseSquarePointLight],
    );
    let attenuated = LIT.replace("(3, 4, 5)", "(3, 4, 5), falloff: Constant");
    cannot(&format!("{attenuated}, shading: Attenuated"), &[Feature::ConstantPointLight]);
    cannot(&format!("{LIT}, shadows: false"), &[Feature::NoShadows]);
    cannot(
        "show: Silhouette, objects: [Cylinder(a: (0, 0, 0), b: (1, 0, 0), radius: 1)]",
        &[Feature::Cylinder],
    );
    let along_z = "show: Silhouette, objects: [Cylinder(a: (1, 2, 5), b: (1, 2, 3), radius: 1)]";
    let text = main_of(Dialect::CornellXml, along_z);
    assert!(text.contains("  <center>1 2 4</center>\n  <radius>1</radius>\n  <height>2</height>"));
}

#[test]
fn a_scene_of_the_neutral_file_format() {
    let fields = "background: (0, 0, 0.5), \
         lights: [Point(position: (3, 4, 5), intensity: (1, 2, 3))], \
         materials: {\"red\": Lambert(diffuse: (1, 0, 0))}, objects: [\
         Sphere(center: (0, 0, 0), radius: 1, material: Named(\"red\")), \
         Cone(apex: (0, 1, 0), base: (0, 0, 0), radius: 2, open: true, material: Named(\"red\")), \
         Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0)), Mesh(file: \"a.obj\")]";
    let exported = written(Dialect::Nff, fields);
    let text = text(&exported, "scene.nff");
    // 90 degrees across 60 rows of pixels are less from the first middle to the last.
    let expected = "\
b 0 0 0.5
v
from 0 0 5
at 0 0 4
up 0 1 0
angle ANGLE
hither 0
resolution 80 60
l 3 4 5 1 2 3
f 1 0 0 1 0 1 0 1
s 0 0 0 1
c
0 0 0 2
0 1 0 0
f 1 1 1 1 0 1 0 1
p 3
0 0 0
1 0 0
0 1 0
pp 3
0 0 0 0 0 1
1 0 0 0 0 1
1 1 0 0 0 1
pp 3
0 0 0 0 0 1
1 1 0 0 0 1
0 1 0 0 0 1
";
    let (before, rest) = text.split_once("angle ").unwrap();
    let (angle, after) = rest.split_once('\n').unwrap();
    assert_eq!(format!("{before}angle ANGLE\n{after}"), expected);
    let half = 0.5 * angle.parse::<f64>().unwrap().to_radians();
    assert!((half.tan() - 59.0 / 60.0).abs() < 1e-15, "{angle}");
    assert_eq!(exported.beside, [Feature::Classic].into());
}

#[test]
fn what_the_neutral_file_format_has_no_words_for() {
    let glossy = "radius: 1, material: BlinnPhong(specular: (1, 1, 1), exponent: 2)";
    refused(Dialect::Nff, &LIT.replace("radius: 1", glossy), &[Feature::BlinnPhong]);
    refused(
        Dialect::Nff,
        &format!("{LIT}, shading: Radiometric, shadows: false"),
        &[Feature::InverseSquarePointLight, Feature::NoShadows, Feature::Radiometric],
    );
    refused(
        Dialect::Nff,
        &format!("{LIT}, camera: Parallel(view_point: (0, 0, 9), view_width: 4, view_height: 3)"),
        &[Feature::Parallel],
    );
}
