//! A scene in the XML of Mitsuba 3, with its triangles in files beside it.
//!
//! What Mitsuba has its own plugins for is said by them. What it has none for
//! (the course's shading, lights that do not weaken, unlit colors) is said by
//! plugins of ours, `goldray_*`, which `adapters/mitsuba/render.py` brings: then
//! the shading is ours, and the rays, shapes, cameras and shadows are Mitsuba's.

mod camera;
mod look;
mod shape;
mod xml;

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

use scene::format::{Falloff, Shading, Triple};

use super::Exported;
use super::plain::{Lamp, Look, Plain, Way};
use super::text::{scaled, spaced, vector};
use crate::Feature;
use xml::{boolean, color, integer, vector3};

/// The name of the scene's file.
const MAIN: &str = "scene.xml";

const CAN: &[Feature] = &[
    Feature::Perspective,
    Feature::Parallel,
    Feature::Oblique,
    Feature::Sphere,
    Feature::Triangle,
    Feature::Box,
    Feature::Plane,
    Feature::Disk,
    Feature::Cylinder,
    Feature::OpenCylinder,
    Feature::Mesh,
    Feature::Constant,
    Feature::NormalMaterial,
    Feature::Lambert,
    Feature::BlinnPhong,
    Feature::ColoredHighlight,
    Feature::Mirror,
    Feature::Dielectric,
    Feature::NestedGlass,
    Feature::GlassFromBehind,
    Feature::ConstantPointLight,
    Feature::InverseSquarePointLight,
    Feature::DirectionalLight,
    Feature::AmbientLight,
    Feature::Shadows,
    Feature::NoShadows,
    Feature::Classic,
    Feature::Attenuated,
    Feature::Radiometric,
    Feature::BackSides,
    Feature::HighlightFromBehind,
    Feature::Depth,
    Feature::Background,
    Feature::Exposure,
    Feature::GridSamples,
];

/// # Errors
/// What Mitsuba has no words for, with our plugins or without.
pub(super) fn write(plain: &Plain) -> Result<Exported, BTreeSet<Feature>> {
    let mut can = CAN.to_vec();
    if plain.asks.contains(&Feature::Parallel) {
        can.push(Feature::StretchedPixels);
    }
    plain.asks_only(&can)?;
    let mut files = BTreeMap::new();
    let mut text =
        format!("<scene version=\"3.0.0\">\n{}{}", integrator(plain), camera::sensor(plain));
    for lamp in &plain.lamps {
        text += &emitter(plain, lamp);
    }
    for object in &plain.objects {
        if object.is_flat_box() && matches!(object.look, Look::Normal(_)) {
            // Of its two sides in one place either may be met.
            return Err([Feature::Box, Feature::NormalMaterial].into());
        }
        if object.is_flat_box() && matches!(object.way, Some(Way::Glass { .. })) {
            // The one would be met, and the other not.
            return Err([Feature::Box, Feature::Dielectric].into());
        }
        let look = look::look(plain, object);
        text += &shape::shape(&object.solid(plain), &look, &mut files);
    }
    text += "</scene>\n";
    files.insert(MAIN.to_owned(), text.into_bytes());
    Ok(Exported { main: MAIN.to_owned(), files, grid: plain.grid, beside: BTreeSet::new() })
}

/// Mitsuba's own integrator asks one light for each sample, by chance: with more
/// than one, or with surfaces that glow, ours asks all of them. It also follows all
/// rays that are sent on.
fn integrator(plain: &Plain) -> String {
    let glows = plain.objects.iter().any(|object| look::glows(plain, object));
    let is_plain =
        plain.shadows && plain.background == [0.0; 3] && plain.lamps.len() == 1 && !glows;
    if is_plain {
        return "<integrator type=\"direct\">\n  <integer name=\"emitter_samples\" value=\"1\"/>\n  \
                <integer name=\"bsdf_samples\" value=\"0\"/>\n</integrator>\n"
            .to_owned();
    }
    let sends = plain.objects.iter().any(|object| object.way.is_some());
    let bounces = if sends { integer("bounces", plain.bounces) } else { String::new() };
    format!(
        "<integrator type=\"goldray_direct\">{}{}{bounces}</integrator>\n",
        boolean("shadows", plain.shadows),
        vector3("background", plain.background)
    )
}

fn emitter(plain: &Plain, lamp: &Lamp) -> String {
    // Mitsuba's surfaces have the factor 1/pi.
    let all = if plain.shading == Shading::Radiometric { 1.0 } else { PI };
    let line =
        |kind: &str, inside: String| format!("<emitter type=\"{kind}\">{inside}</emitter>\n");
    match *lamp {
        Lamp::Point { position, intensity, falloff: Falloff::InverseSquare } => line(
            "point",
            xml::point("position", position) + &color("intensity", scaled(intensity, all)),
        ),
        Lamp::Point { position, intensity, falloff: Falloff::Constant } => line(
            "goldray_point",
            vector3("position", position) + &vector3("intensity", scaled(intensity, all)),
        ),
        Lamp::Directional { direction, intensity } => line(
            "directional",
            vector3("direction", unit(direction)) + &color("irradiance", scaled(intensity, all)),
        ),
    }
}

fn unit(v: Triple) -> Triple {
    vector(v).normalize_or_zero().to_array()
}

/// A matrix by its columns, as Mitsuba reads it: by rows.
fn matrix(columns: [[f64; 3]; 4]) -> String {
    let row = |k: usize| spaced([columns[0][k], columns[1][k], columns[2][k]]);
    let rows = [0, 1, 2].map(|k| format!("{} {}", row(k), super::number(columns[3][k])));
    format!("<matrix value=\"{} 0 0 0 1\"/>", rows.join(" "))
}
