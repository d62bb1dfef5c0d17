//! A scene in the language of POV-Ray 3.7.
//!
//! The picture is to be made with `-A` (a sample in the middle of each pixel),
//! `+FN16 File_Gamma=1.0` (linear, 16 bits). `docs/adapters.md` has the
//! conventions and how they were measured.

mod look;
mod pigment;
mod shape;

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

use scene::format::{Falloff, Shading, Triple};
use tracer::Projection;
use tracer::glam::DVec3;

use super::plain::{Lamp, Plain, Way};
use super::text::{numbers, put, scaled, vector};
use super::{Exported, number};
use crate::Feature;

/// The name of the scene's file.
const MAIN: &str = "scene.pov";

/// Point lights weaken as `2 / (1 + (r / f)^2)`, which is `2 f^2 / r^2` but for
/// a part `(f / r)^2` of it: with `f` this small, far below 32 bits.
const FADE_DISTANCE: f64 = 1e-6;

/// How far away a light without end is put. Its rays are parallel all the same;
/// what is behind it casts no shadow.
const FAR: f64 = 1e6;

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
    Feature::OpenCylinder,
    Feature::Cone,
    Feature::OpenCone,
    Feature::Torus,
    Feature::Mesh,
    Feature::StretchedRound,
    Feature::Constant,
    Feature::NormalMaterial,
    Feature::Lambert,
    Feature::BlinnPhong,
    Feature::ColoredHighlight,
    Feature::Mirror,
    Feature::Dielectric,
    Feature::Whitted,
    Feature::Glazed,
    Feature::Schlick,
    Feature::CheckerTexture,
    Feature::ImageTexture,
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
    Feature::Depth,
    Feature::Background,
    Feature::Exposure,
    Feature::GridSamples,
];

/// # Errors
/// What POV-Ray has no words for. Its highlights are never times the cosine; its
/// glass has Fresnel's equations.
pub(super) fn write(plain: &Plain) -> Result<Exported, BTreeSet<Feature>> {
    plain.asks_only(CAN)?;
    let has_highlights = plain.asks.contains(&Feature::BlinnPhong);
    if has_highlights && plain.shading == Shading::Radiometric {
        return Err([Feature::BlinnPhong, Feature::Radiometric].into());
    }
    // What is lit is lit by lamps.
    let has_shadows = plain.shadows && plain.objects.iter().any(|object| object.look.is_lit());
    let mut files = BTreeMap::new();
    let mut text = head(plain);
    for lamp in &plain.lamps {
        text += &light(plain, lamp);
    }
    for (number, object) in plain.objects.iter().enumerate() {
        if matches!(object.way, Some(Way::Glass { schlick: true, .. })) {
            return Err([Feature::Dielectric, Feature::Schlick].into());
        }
        // Below 1 it is the angle inside that counts, and POV-Ray takes the one outside.
        if matches!(object.way, Some(Way::Glaze { ior, schlick: true }) if ior < 1.0) {
            return Err([Feature::Glazed, Feature::Schlick].into());
        }
        if look::is_clear(object)
            && look::has_highlight(&object.look)
            && !look::has_gray_highlight(&object.look)
        {
            return Err([Feature::Whitted, Feature::ColoredHighlight].into());
        }
        let paint = pigment::Paint::of(plain, object, number, &mut files);
        text += &paint.declared;
        let shape = shape::shape(plain, object) + &shape::matrix(object);
        let look = look::texture(plain, object, &paint);
        let is_clear = look::is_clear(object);
        let no_shadow = if plain.shadows && !is_clear { "" } else { " no_shadow" };
        put(&mut text, format_args!("{shape}\n  {look}{no_shadow}\n}}\n"));
        if is_clear && has_shadows {
            // Where light would shine through, another one stands that only casts a shadow.
            // The eye must not be in it as well, or it is in two objects.
            let inverse = if object.holds_eye { " inverse" } else { "" };
            put(
                &mut text,
                format_args!("{shape}\n  {BLACK} no_image no_reflection{inverse}\n}}\n"),
            );
        }
    }
    files.insert(MAIN.to_owned(), text.into_bytes());
    Ok(Exported { main: MAIN.to_owned(), files, grid: plain.grid, beside: BTreeSet::new() })
}

/// What shows nothing.
const BLACK: &str = "texture { pigment { rgb 0 } }";

fn head(plain: &Plain) -> String {
    let camera = &plain.camera;
    let [right, up] = camera.axes();
    let (kind, distance) = match camera.projection() {
        Projection::Perspective { proj_distance } => ("", proj_distance),
        Projection::Parallel => (" orthographic", 1.0),
    };
    let background = if plain.background == [0.0; 3] {
        String::new()
    } else {
        format!("background {{ rgb {} }}\n", triple(plain.background))
    };
    let sends = plain.objects.iter().any(|object| object.way.is_some());
    // The eye ray is the first; and none is dropped for being dark.
    let levels = if sends { format!("{} adc_bailout 0", plain.bounces + 1) } else { "1".into() };
    format!(
        "#version 3.7;\n\
         global_settings {{ assumed_gamma 1 ambient_light 1 max_trace_level {levels} }}\n\
         #default {{ finish {{ ambient 0 diffuse 0 }} }}\n\
         camera {{{kind}\n  location {}\n  direction {}\n  right {}\n  up {}\n}}\n{background}",
        point(camera.eye()),
        point(*camera.forward() * distance),
        point(*right * camera.view_width()),
        point(*up * camera.view_height()),
    )
}

fn light(plain: &Plain, lamp: &Lamp) -> String {
    // Of `diffuse 1` all light goes everywhere, without 1/pi.
    let all = if plain.shading == Shading::Radiometric { PI.recip() } else { 1.0 };
    match *lamp {
        Lamp::Point { position, intensity, falloff } => {
            let (by, fade) = match falloff {
                Falloff::Constant => (1.0, String::new()),
                Falloff::InverseSquare => (
                    1.0 / (2.0 * FADE_DISTANCE * FADE_DISTANCE),
                    format!(" fade_distance {} fade_power 2", number(FADE_DISTANCE)),
                ),
            };
            let color = triple(scaled(intensity, all * by));
            format!("light_source {{ {} rgb {color}{fade} }}\n", triple(position))
        }
        Lamp::Directional { direction, intensity } => {
            let from = vector(direction).normalize_or_zero() * -FAR;
            let color = triple(scaled(intensity, all));
            format!("light_source {{ {} rgb {color} parallel point_at 0 }}\n", point(from))
        }
    }
}

fn triple(v: Triple) -> String {
    format!("<{}>", numbers(v, ","))
}

fn point(v: DVec3) -> String {
    triple(v.to_array())
}
