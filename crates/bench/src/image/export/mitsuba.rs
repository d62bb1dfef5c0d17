//! A scene in the XML of Mitsuba 3, with meshes in files beside it.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use scene::format::Object;
use tracer::glam::DVec3;

use super::{Model, Surface, Triple};
use crate::image::scenes::Triangles;

/// The name of the scene's own file, and all files with their bytes.
pub(crate) const SCENE: &str = "scene.xml";

/// The files of a scene, [`SCENE`] among them.
///
/// Boxes and triangles of the same surface are one mesh, which is how Mitsuba
/// is at its fastest. No surface is made two-sided: as in radiometric shading,
/// its backs are dark. The sampler's name is the parameter `sampler`, and that
/// of samples taken at once is `pass`.
pub(crate) fn mitsuba(model: &Model<'_>) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut flat: Vec<(Surface, Triangles)> = Vec::new();
    let mut text = head(model);
    for &(object, surface) in &model.objects {
        let mut own = |add: &dyn Fn(&mut Triangles)| {
            let k = flat.iter().position(|(other, _)| *other == surface).unwrap_or_else(|| {
                flat.push((surface, Triangles::default()));
                flat.len() - 1
            });
            add(&mut flat[k].1);
        };
        match object {
            Object::Box { min, max, .. } => own(&|mesh| mesh.add_box(*min, *max)),
            Object::Triangle { a, b, c, .. } => own(&|mesh| mesh.add(&[*a, *b, *c])),
            Object::Sphere { center, radius, .. } => {
                let numbers = point("center", *center) + &float("radius", *radius);
                text += &shape("sphere", &numbers, surface);
            }
            Object::Disk { center, normal, radius, .. } => {
                text += &disk(*center, DVec3::from(*normal), *radius, surface);
            }
            Object::Cylinder { a, b, radius, open, .. } => {
                let numbers = point("p0", *a) + &point("p1", *b) + &float("radius", *radius);
                text += &shape("cylinder", &numbers, surface);
                if !open {
                    let along = DVec3::from(*b) - DVec3::from(*a);
                    text += &disk(*a, -along, *radius, surface);
                    text += &disk(*b, along, *radius, surface);
                }
            }
            Object::Mesh { file, flat, .. } => {
                if let Some(triangles) = model.meshes.get(file) {
                    files.insert(file.clone(), triangles.ply());
                    text += &mesh(file, *flat, surface);
                }
            }
            // `Model` has none of them.
            Object::Plane { .. }
            | Object::Torus { .. }
            | Object::Cone { .. }
            | Object::Group { .. } => {}
        }
    }
    for (k, (surface, triangles)) in flat.iter().enumerate() {
        let file = format!("flat-{k}.ply");
        text += &mesh(&file, true, *surface);
        files.insert(file, triangles.ply());
    }
    text += "</scene>\n";
    files.insert(SCENE.to_owned(), text.into_bytes());
    files
}

fn head(model: &Model<'_>) -> String {
    let (view, (width, height)) = (&model.view, model.size);
    let fov_deg = 2.0 * libm::atan(0.5 * view.width).to_degrees();
    let list = |v: DVec3| format!("{}, {}, {}", v.x, v.y, v.z);
    let mut text = format!(
        r#"<scene version="3.0.0">
<default name="sampler" value="independent"/>
<default name="pass" value="1"/>
<integrator type="direct">
  <integer name="emitter_samples" value="1"/>
  <integer name="bsdf_samples" value="0"/>
  <integer name="samples_per_pass" value="$pass"/>
</integrator>
<sensor type="perspective">
  <string name="fov_axis" value="x"/>
  <float name="fov" value="{fov_deg}"/>
  <transform name="to_world">
    <lookat origin="{}" target="{}" up="{}"/>
  </transform>
  <sampler type="$sampler"/>
  <film type="hdrfilm">
    <integer name="width" value="{width}"/>
    <integer name="height" value="{height}"/>
    <string name="pixel_format" value="rgb"/>
    <string name="component_format" value="float32"/>
    <rfilter type="box"/>
  </film>
</sensor>
"#,
        list(view.eye),
        list(view.eye + view.forward),
        list(view.up)
    );
    for &(position, intensity) in &model.lights {
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "<emitter type=\"point\">{}{}</emitter>",
            point("position", position),
            rgb("intensity", intensity)
        );
    }
    text
}

fn float(name: &str, x: f64) -> String {
    format!("<float name=\"{name}\" value=\"{x}\"/>")
}

fn point(name: &str, [x, y, z]: Triple) -> String {
    format!("<point name=\"{name}\" x=\"{x}\" y=\"{y}\" z=\"{z}\"/>")
}

fn rgb(name: &str, [r, g, b]: Triple) -> String {
    format!("<rgb name=\"{name}\" value=\"{r}, {g}, {b}\"/>")
}

fn shape(kind: &str, inside: &str, surface: Surface) -> String {
    let look = match surface {
        Surface::Lambert(diffuse) => {
            format!("<bsdf type=\"diffuse\">{}</bsdf>", rgb("reflectance", diffuse))
        }
        Surface::Shining(color) => {
            format!("<emitter type=\"area\">{}</emitter>", rgb("radiance", color))
        }
    };
    format!("<shape type=\"{kind}\">{inside}{look}</shape>\n")
}

/// Mitsuba's disk has a radius of 1 around the origin and looks along z.
fn disk(center: Triple, normal: DVec3, radius: f64, surface: Surface) -> String {
    let (center, up) = (DVec3::from(center), normal.any_orthogonal_vector());
    let list = |v: DVec3| format!("{}, {}, {}", v.x, v.y, v.z);
    let inside = format!(
        "<transform name=\"to_world\"><scale value=\"{radius}\"/><lookat origin=\"{}\" \
         target=\"{}\" up=\"{}\"/></transform>",
        list(center),
        list(center + normal.normalize()),
        list(up)
    );
    shape("disk", &inside, surface)
}

fn mesh(file: &str, flat: bool, surface: Surface) -> String {
    let inside = format!(
        "<string name=\"filename\" value=\"{file}\"/><boolean name=\"face_normals\" \
         value=\"{flat}\"/>"
    );
    shape("ply", &inside, surface)
}
