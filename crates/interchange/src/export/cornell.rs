//! A scene in the XML of the course's assignments.
//!
//! Which of the three shading conventions is meant is not in such a file: it is
//! to be said besides.

use std::collections::{BTreeMap, BTreeSet};

use scene::format::{Falloff, Object, Shading, Transform, Triple};
use tracer::Projection;

use super::plain::{Lamp, Look, Placed, Plain, Solid};
use super::text::{numbers, put, spaced};
use super::{Exported, number};
use crate::Feature;

const MAIN: &str = "scene.xml";

const CAN: &[Feature] = &[
    Feature::Perspective,
    Feature::Parallel,
    Feature::Oblique,
    Feature::StretchedPixels,
    Feature::Sphere,
    Feature::Triangle,
    Feature::Box,
    Feature::Plane,
    Feature::Disk,
    Feature::Cylinder,
    Feature::Mesh,
    Feature::StretchedRound,
    Feature::Constant,
    Feature::NormalMaterial,
    Feature::Lambert,
    Feature::BlinnPhong,
    Feature::ColoredHighlight,
    Feature::ConstantPointLight,
    Feature::InverseSquarePointLight,
    Feature::Shadows,
    Feature::ShadowGap,
    Feature::Classic,
    Feature::Attenuated,
    Feature::Radiometric,
    Feature::BackSides,
    Feature::HighlightFromBehind,
    Feature::Background,
    Feature::GridSamples,
];

/// # Errors
/// What the course's files have no words for.
pub(super) fn write(plain: &Plain) -> Result<Exported, BTreeSet<Feature>> {
    plain.asks_only(CAN)?;
    let mut files = BTreeMap::new();
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Shading: {:?} -->\n<scene>\n{}",
        plain.shading,
        camera(plain)
    );
    // Its `samples` are scattered: those on a grid are pixels of a larger picture.
    let (width, height) = (plain.size.0 * plain.grid, plain.size.1 * plain.grid);
    put(&mut text, format_args!("  <image>{width} {height}</image>\n"));
    if plain.background != [0.0; 3] {
        text += &element("backColor", plain.background);
    }
    for lamp in &plain.lamps {
        text += &light(plain, lamp)?;
    }
    for object in &plain.objects {
        text += &surface(plain, object, &mut files)?;
    }
    text += "</scene>\n";
    files.insert(MAIN.to_owned(), text.into_bytes());
    let is_lit = plain.objects.iter().any(|object| object.look.is_lit());
    let convention = match plain.shading {
        Shading::Classic => Feature::Classic,
        Shading::Attenuated => Feature::Attenuated,
        Shading::Radiometric => Feature::Radiometric,
    };
    let beside = is_lit.then_some(convention).into_iter().collect();
    Ok(Exported { main: MAIN.to_owned(), files, grid: plain.grid, beside })
}

fn element(name: &str, v: Triple) -> String {
    format!("  <{name}>{}</{name}>\n", spaced(v))
}

fn value(name: &str, x: f64) -> String {
    format!("  <{name}>{}</{name}>\n", number(x))
}

/// A perspective camera has no type: the earliest years know no other.
fn camera(plain: &Plain) -> String {
    let camera = &plain.camera;
    let [u, v] = camera.axes();
    let (kind, distance) = match camera.projection() {
        Projection::Perspective { proj_distance } => ("", value("projDistance", proj_distance)),
        Projection::Parallel => (" type=\"OrthographicCamera\"", String::new()),
    };
    let inside = [
        element("viewPoint", camera.eye().to_array()),
        element("viewDir", camera.forward().to_array()),
        element("projNormal", u.cross(*v).to_array()),
        element("viewUp", v.to_array()),
        distance,
        value("viewWidth", camera.view_width()),
        value("viewHeight", camera.view_height()),
    ];
    format!("  <camera{kind}>\n{}  </camera>\n", inside.concat())
}

/// How a point light weakens is the convention's, and no light's own.
fn light(plain: &Plain, lamp: &Lamp) -> Result<String, BTreeSet<Feature>> {
    let (own, feature) = match plain.shading {
        Shading::Classic => (Falloff::Constant, Feature::InverseSquarePointLight),
        Shading::Attenuated | Shading::Radiometric => {
            (Falloff::InverseSquare, Feature::ConstantPointLight)
        }
    };
    match *lamp {
        Lamp::Point { position, intensity, falloff } if falloff == own => Ok(format!(
            "  <light>\n{}{}  </light>\n",
            element("position", position),
            element("intensity", intensity)
        )),
        Lamp::Point { .. } => Err([feature].into()),
        Lamp::Directional { .. } => Err([Feature::DirectionalLight].into()),
    }
}

fn surface(
    plain: &Plain,
    object: &Placed,
    files: &mut BTreeMap<String, Vec<u8>>,
) -> Result<String, BTreeSet<Feature>> {
    let (kind, inside) = match &object.shape {
        Object::Sphere { center, radius, .. } => {
            ("Sphere", element("center", *center) + &value("radius", *radius))
        }
        Object::Box { min, max, .. } => ("Box", element("minPt", *min) + &element("maxPt", *max)),
        Object::Triangle { a, b, c, .. } => {
            ("Triangle", element("a", *a) + &element("b", *b) + &element("c", *c))
        }
        Object::Plane { point, normal, .. } => {
            ("Plane", element("point", *point) + &element("normal", *normal))
        }
        Object::Disk { center, normal, radius, .. } => {
            let inside =
                [element("center", *center), element("normal", *normal), value("radius", *radius)];
            ("Disk", inside.concat())
        }
        Object::Cylinder { a, b, radius, .. } => ("Cylinder", cylinder(*a, *b, *radius)?),
        Object::Mesh { .. } => {
            let Solid::Triangles(triangles) = object.in_own_space().solid(plain) else {
                return Ok(String::new());
            };
            let name = format!("mesh-{}.obj", files.len());
            files.insert(name.clone(), triangles.obj(&mut 0, &mut 0).into_bytes());
            ("Mesh", format!("  <data>{name}</data>\n"))
        }
        // It has no words for them; that was asked before.
        Object::Torus { .. } | Object::Cone { .. } | Object::Group { .. } => {
            return Ok(String::new());
        }
    };
    let surface =
        format!("  <surface type=\"{kind}\">\n{}{inside}  </surface>\n", shader(&object.look));
    if object.steps.is_empty() {
        return Ok(surface);
    }
    let steps: String = object.steps.iter().map(step).collect();
    Ok(format!("  <surface type=\"Group\">\n{steps}{surface}  </surface>\n"))
}

/// The course's stand along z around their center.
fn cylinder(a: Triple, b: Triple, radius: f64) -> Result<String, BTreeSet<Feature>> {
    if (a[0], a[1]) != (b[0], b[1]) {
        return Err([Feature::Cylinder].into());
    }
    let center = [a[0], a[1], 0.5 * (a[2] + b[2])];
    let inside =
        [element("center", center), value("radius", radius), value("height", (b[2] - a[2]).abs())];
    Ok(inside.concat())
}

fn step(step: &Transform) -> String {
    let (name, v) = match *step {
        Transform::Translate(x, y, z) => ("translate", [x, y, z]),
        Transform::RotateDeg(x, y, z) => ("rotate", [x, y, z]),
        Transform::Scale(x, y, z) => ("scale", [x, y, z]),
    };
    format!("  <{name}>{}</{name}>\n", numbers(v, " "))
}

fn shader(look: &Look) -> String {
    let (kind, inside) = match look {
        Look::Constant(color) => ("Constant", element("color", *color)),
        Look::Normal(_) => ("Normal", String::new()),
        Look::Lit { diffuse, highlight: None } => ("Lambertian", element("diffuseColor", *diffuse)),
        Look::Lit { diffuse, highlight: Some((specular, exponent)) } => {
            let inside = [
                element("diffuseColor", *diffuse),
                element("specularColor", *specular),
                value("exponent", *exponent),
            ];
            ("Phong", inside.concat())
        }
        // It has no words for it; that was asked before.
        Look::Depth { .. } => return String::new(),
    };
    format!("  <shader type=\"{kind}\">\n{inside}  </shader>\n")
}
