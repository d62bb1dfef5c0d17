//! A scene in the language of POV-Ray 3.7.

use std::fmt::Write as _;

use scene::format::Object;
use tracer::glam::DVec3;

use super::{Model, Surface, Triple, View};

/// POV-Ray's lights weaken as `2 / (1 + (r / f)^2)`: as `1 / r^2` to this part
/// of the light at a distance of 1, with `f` this small.
const FADE_DISTANCE: f64 = 1e-3;

/// The text of the file.
pub(crate) fn povray(model: &Model<'_>) -> String {
    let Model { view: View { eye, forward, right, up, width, height }, .. } = model;
    let mut text = format!(
        "#version 3.7;\n\
         global_settings {{ assumed_gamma 1 ambient_light 0 max_trace_level 1 }}\n\
         #default {{ finish {{ ambient 0 diffuse 1 }} }}\n\
         camera {{ location {} direction {} right {} up {} }}\n",
        vector(*eye),
        vector(*forward),
        vector(*right * *width),
        vector(*up * *height)
    );
    for &(position, intensity) in &model.lights {
        // Of `diffuse 1` all light is scattered to everywhere, without 1/pi.
        let scale = 1.0 / (std::f64::consts::PI * 2.0 * FADE_DISTANCE * FADE_DISTANCE);
        put(
            &mut text,
            format_args!(
                "light_source {{ {} rgb {} fade_distance {FADE_DISTANCE} fade_power 2 }}",
                triple(position),
                triple(intensity.map(|x| x * scale))
            ),
        );
    }
    for (object, surface) in &model.objects {
        text.push_str(&shape(model, object));
        put(&mut text, format_args!("{} }}", look(*surface)));
    }
    text
}

fn put(text: &mut String, line: std::fmt::Arguments<'_>) {
    // Writing into a string does not fail.
    let _ = writeln!(text, "{line}");
}

fn triple([x, y, z]: Triple) -> String {
    format!("<{x},{y},{z}>")
}

fn vector(v: DVec3) -> String {
    triple(v.to_array())
}

fn look(surface: Surface) -> String {
    match surface {
        Surface::Lambert(diffuse) => format!("pigment {{ rgb {} }}", triple(diffuse)),
        Surface::Shining(color) => {
            format!("pigment {{ rgb {} }} finish {{ diffuse 0 emission 1 }}", triple(color))
        }
    }
}

/// All of a shape but its look and the closing brace.
fn shape(model: &Model<'_>, object: &Object) -> String {
    match object {
        Object::Sphere { center, radius, .. } => format!("sphere {{ {},{radius} ", triple(*center)),
        Object::Box { min, max, .. } => format!("box {{ {},{} ", triple(*min), triple(*max)),
        Object::Disk { center, normal, radius, .. } => {
            format!("disc {{ {},{},{radius} ", triple(*center), triple(*normal))
        }
        Object::Triangle { a, b, c, .. } => {
            format!("triangle {{ {},{},{} ", triple(*a), triple(*b), triple(*c))
        }
        Object::Cylinder { a, b, radius, open, .. } => {
            let open = if *open { "open " } else { "" };
            format!("cylinder {{ {},{},{radius} {open}", triple(*a), triple(*b))
        }
        Object::Mesh { file, flat, .. } => mesh(model, file, *flat),
        // `Model` has none of them.
        Object::Plane { .. }
        | Object::Torus { .. }
        | Object::Cone { .. }
        | Object::Group { .. } => String::new(),
    }
}

fn mesh(model: &Model<'_>, file: &str, flat: bool) -> String {
    let Some(triangles) = model.meshes.get(file) else { return String::new() };
    let list = |name: &str, numbers: &mut dyn Iterator<Item = [String; 3]>, count: usize| {
        let all: Vec<_> = numbers.map(|[a, b, c]| format!("<{a},{b},{c}>")).collect();
        format!("  {name} {{ {count}, {} }}\n", all.join(","))
    };
    let floats = |all: &[[f32; 3]], name| {
        list(name, &mut all.iter().map(|v| v.map(|x| x.to_string())), all.len())
    };
    let mut text = "mesh2 {\n".to_owned();
    text += &floats(&triangles.vertices, "vertex_vectors");
    if !flat && !triangles.normals.is_empty() {
        text += &floats(&triangles.normals, "normal_vectors");
    }
    let faces = &triangles.faces;
    text += &list(
        "face_indices",
        &mut faces.iter().map(|face| face.map(|i| i.to_string())),
        faces.len(),
    );
    text
}
