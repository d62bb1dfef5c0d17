//! A scene in NFF, the Neutral File Format of the Standard Procedural Databases.
//!
//! It knows one kind of light, which does not weaken, and one look, of which
//! only the diffuse part is written: `Ks` asks for a mirror as well.

use std::collections::{BTreeMap, BTreeSet};

use scene::format::Triple;
use tracer::Projection;

use super::plain::{Lamp, Look, Plain, Solid, Triangles};
use super::text::{put, spaced};
use super::{Exported, number};
use crate::Feature;

const MAIN: &str = "scene.nff";

const CAN: &[Feature] = &[
    Feature::Perspective,
    Feature::Sphere,
    Feature::Triangle,
    Feature::Box,
    Feature::Plane,
    Feature::OpenCylinder,
    Feature::OpenCone,
    Feature::Mesh,
    Feature::Lambert,
    Feature::ConstantPointLight,
    Feature::Shadows,
    Feature::Classic,
    Feature::Background,
    Feature::GridSamples,
];

/// # Errors
/// What NFF has no words for.
pub(super) fn write(plain: &Plain) -> Result<Exported, BTreeSet<Feature>> {
    plain.asks_only(CAN)?;
    let mut text = view(plain)?;
    for lamp in &plain.lamps {
        // It has no words for others; that was asked before.
        if let Lamp::Point { position, intensity, .. } = lamp {
            put(&mut text, format_args!("l {} {}\n", spaced(*position), spaced(*intensity)));
        }
    }
    let mut fill = None;
    for object in &plain.objects {
        let Look::Lit { diffuse, .. } = object.look else { continue };
        if fill.replace(diffuse) != Some(diffuse) {
            text += &self::fill(diffuse);
        }
        text += &shape(&object.solid(plain));
    }
    let files = BTreeMap::from([(MAIN.to_owned(), text.into_bytes())]);
    let beside = [Feature::Classic].into();
    Ok(Exported { main: MAIN.to_owned(), files, grid: plain.grid, beside })
}

/// The angle goes from the middle of the top row to the middle of the bottom row:
/// a row less than the window is high.
fn view(plain: &Plain) -> Result<String, BTreeSet<Feature>> {
    let camera = &plain.camera;
    let (width, height) = (plain.size.0 * plain.grid, plain.size.1 * plain.grid);
    let Projection::Perspective { proj_distance } = camera.projection() else {
        return Err([Feature::Parallel].into());
    };
    if height < 2 {
        // A single row has no angle.
        return Err([Feature::Perspective].into());
    }
    let rows = f64::from(height);
    let half = 0.5 * camera.view_height() * ((rows - 1.0) / rows) / proj_distance;
    let [_, up] = camera.axes();
    let eye = camera.eye();
    Ok(format!(
        "b {}\nv\nfrom {}\nat {}\nup {}\nangle {}\nhither 0\nresolution {width} {height}\n",
        spaced(plain.background),
        spaced(eye.to_array()),
        spaced((eye + *camera.forward()).to_array()),
        spaced(up.to_array()),
        number(2.0 * libm::atan(half).to_degrees())
    ))
}

/// Color, Kd, Ks, Shine, T and index of refraction.
fn fill(diffuse: Triple) -> String {
    format!("f {} 1 0 1 0 1\n", spaced(diffuse))
}

fn shape(solid: &Solid) -> String {
    match solid {
        Solid::Sphere { center, radius } => {
            format!("s {} {}\n", spaced(center.to_array()), number(*radius))
        }
        Solid::Cylinder { a, b, radius, .. } => cone([a.to_array(), b.to_array()], [*radius; 2]),
        Solid::Cone { apex, base, radius, .. } => {
            cone([base.to_array(), apex.to_array()], [*radius, 0.0])
        }
        Solid::Plane { point, normal, reach } => {
            triangles(&Triangles::square(*point, *normal, *reach))
        }
        Solid::Triangles(all) => triangles(all),
        // It has no words for them; that was asked before.
        Solid::Disk { .. } | Solid::Torus { .. } => String::new(),
    }
}

fn cone([base, apex]: [Triple; 2], [below, above]: [f64; 2]) -> String {
    format!("c\n{} {}\n{} {}\n", spaced(base), number(below), spaced(apex), number(above))
}

fn triangles(all: &Triangles) -> String {
    let mut text = String::new();
    for face in &all.faces {
        text += if all.normals.is_empty() { "p 3\n" } else { "pp 3\n" };
        for &i in face {
            let at =
                |list: &[tracer::glam::DVec3]| list.get(i as usize).map(|v| spaced(v.to_array()));
            let words: Vec<_> = at(&all.corners).into_iter().chain(at(&all.normals)).collect();
            put(&mut text, format_args!("{}\n", words.join(" ")));
        }
    }
    text
}
