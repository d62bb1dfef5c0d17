//! Looks: how a surface scatters light, and what it shows by itself.

use std::f64::consts::PI;

use scene::format::{Shading, Triple};
use tracer::Projection;

use super::xml::{boolean, color, float, string, vector3};
use crate::export::plain::{Look, Placed, Plain, Way};
use crate::export::text::{scaled, times};

/// What is inside of a shape beside its numbers.
pub(super) fn look(plain: &Plain, object: &Placed) -> String {
    match object.way {
        Some(Way::Mirror { reflectance, .. }) => return mirror(reflectance),
        Some(Way::Glass { ior, tint, .. }) => return glass(ior, tint),
        // It has no words for these; that was asked before.
        Some(Way::Sum { .. } | Way::Glaze { .. }) | None => {}
    }
    match &object.look {
        Look::Constant(rgb) => DARK.to_owned() + &glow(*rgb),
        Look::Normal(by) => DARK.to_owned() + &emitter("goldray_normals", &float("scale", *by)),
        Look::Depth { near, far } => DARK.to_owned() + &depth(plain, *near, *far),
        Look::Lit { diffuse, highlight } => {
            let mut surface = surface(plain, object, *diffuse, *highlight);
            if object.is_flat_box() {
                // Whichever of its sides is met, it is the one that is seen.
                surface = format!("<bsdf type=\"twosided\">{surface}</bsdf>");
            }
            let ambient = times(*diffuse, plain.ambient);
            if ambient == [0.0; 3] { surface } else { surface + &glow(ambient) }
        }
    }
}

/// Whether a surface shows something of its own.
pub(super) fn glows(plain: &Plain, object: &Placed) -> bool {
    match &object.look {
        Look::Lit { diffuse, .. } => times(*diffuse, plain.ambient) != [0.0; 3],
        _ => true,
    }
}

/// What scatters nothing.
const DARK: &str = "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0, 0, 0\"/></bsdf>";

/// From both sides.
fn mirror(reflectance: Triple) -> String {
    format!(
        "<bsdf type=\"twosided\"><bsdf type=\"conductor\">{}{}</bsdf></bsdf>",
        string("material", "none"),
        color("specular_reflectance", reflectance)
    )
}

fn glass(ior: f64, tint: Triple) -> String {
    format!(
        "<bsdf type=\"dielectric\">{}{}{}</bsdf>",
        float("int_ior", ior),
        float("ext_ior", 1.0),
        color("specular_transmittance", tint)
    )
}

/// Mitsuba's own emitters of shapes shine from the front only, and on others.
fn glow(rgb: Triple) -> String {
    emitter("goldray_glow", &vector3("radiance", rgb))
}

fn emitter(kind: &str, inside: &str) -> String {
    format!("<emitter type=\"{kind}\">{inside}</emitter>")
}

fn surface(
    plain: &Plain,
    object: &Placed,
    diffuse: Triple,
    highlight: Option<(Triple, f64)>,
) -> String {
    let is_radiometric = plain.shading == Shading::Radiometric;
    // Mitsuba's own is dark on its back, and takes no share above 1.
    let is_plain = highlight.is_none()
        && (is_radiometric || !object.back_is_seen)
        && diffuse.iter().all(|&share| share <= 1.0);
    if is_plain {
        return format!("<bsdf type=\"diffuse\">{}</bsdf>", color("reflectance", diffuse));
    }
    let (specular, exponent) = highlight.unwrap_or(([0.0; 3], 1.0));
    // Lights are pi times as bright where the convention has no 1/pi.
    let specular = if is_radiometric { specular } else { scaled(specular, PI.recip()) };
    format!(
        "<bsdf type=\"goldray_surface\">{}{}{}{}</bsdf>",
        vector3("diffuse", diffuse),
        vector3("specular", specular),
        float("exponent", exponent),
        boolean("radiometric", is_radiometric)
    )
}

/// The distance from the eye, or along the view's direction from the window.
fn depth(plain: &Plain, near: f64, far: f64) -> String {
    let camera = &plain.camera;
    let [right, up] = camera.axes();
    let normal = right.cross(*up);
    let along = match camera.projection() {
        Projection::Perspective { .. } => String::new(),
        Projection::Parallel => {
            vector3("along", (normal / normal.dot(*camera.forward())).to_array())
        }
    };
    let inside = vector3("eye", camera.eye().to_array())
        + &float("near", near)
        + &float("far", far)
        + &along;
    emitter("goldray_depth", &inside)
}
