//! Looks as textures. They come after a shape's matrix and so are in the
//! world's space.

use scene::format::{Shading, Triple};
use tracer::Projection;

use super::pigment::Paint;
use super::triple;
use crate::export::number;
use crate::export::plain::{Look, Placed, Plain, Way};
use crate::export::text::scaled;

/// The layers of the front, those of the back if it is seen and another, and what
/// is inside.
pub(super) fn texture(plain: &Plain, object: &Placed, paint: &Paint) -> String {
    let mut text = layers(plain, object, paint, false).join("\n  ");
    let has_sides = matches!(object.look, Look::Normal(_) | Look::Lit { .. })
        || matches!(object.way, Some(Way::Glaze { .. }));
    if object.back_is_seen && has_sides {
        for layer in layers(plain, object, paint, true) {
            text += "\n  interior_";
            text += &layer;
        }
    }
    match object.way.and_then(Way::index) {
        Some(ior) => format!("{text}\n  interior {{ ior {} }}", number(ior)),
        None => text,
    }
}

/// Whether a look has a highlight.
pub(super) fn has_highlight(look: &Look) -> bool {
    matches!(look, Look::Lit { highlight: Some(_), .. })
}

/// Whether a highlight is of the light's color.
pub(super) fn has_gray_highlight(look: &Look) -> bool {
    matches!(look, Look::Lit { highlight: Some(([r, g, b], _)), .. } if r == g && g == b)
}

/// Whether light would go through.
pub(super) fn is_clear(object: &Placed) -> bool {
    object.way.is_some_and(Way::is_clear)
}

/// The layers of one side, undermost first.
fn layers(plain: &Plain, object: &Placed, paint: &Paint, is_back: bool) -> Vec<String> {
    /// By Fresnel's equations, for the index of what is inside.
    const FRESNEL: &str = "rgb 0, rgb 1 fresnel on";
    let through = |pigment: &str, reflection: &str| {
        // What is reflected does not go through.
        let finish = format!("reflection {{ {reflection} }} conserve_energy");
        format!("texture {{ pigment {{ {pigment} }} finish {{ {finish} }} }}")
    };
    match object.way {
        None => own(plain, object, paint, is_back, 0.0),
        Some(Way::Mirror { reflectance, schlick }) => {
            let finish = format!("reflection {{ {} }}", grown(reflectance, schlick));
            vec![format!("texture {{ pigment {{ rgb 0 }} finish {{ {finish} }} }}")]
        }
        Some(Way::Glass { tint: [r, g, b], .. }) => {
            let filter = super::numbers([r, g, b, 1.0], ",");
            vec![through(&format!("rgbf <{filter}>"), FRESNEL)]
        }
        Some(Way::Glaze { ior, schlick }) => {
            let mut layers = own(plain, object, paint, is_back, 0.0);
            let straight_on = ((ior - 1.0) / (ior + 1.0)).powi(2);
            let growing = grown([straight_on; 3], true);
            if !is_back {
                layers.push(through("rgbf 1", if schlick { &growing } else { FRESNEL }));
            }
            layers
        }
        Some(Way::Sum { reflect, transmit, schlick, .. }) => {
            let mut layers = if is_clear(object) {
                let [r, g, b] = scaled(transmit, 2.0);
                let filter = super::numbers([r, g, b, 1.0], ",");
                let mut layers = vec![format!("texture {{ pigment {{ rgbf <{filter}> }} }}")];
                layers.extend(own(plain, object, paint, is_back, 0.5));
                layers
            } else {
                own(plain, object, paint, is_back, 0.0)
            };
            if reflect != [0.0; 3] || schlick {
                let finish = format!("reflection {{ {} }}", grown(reflect, schlick));
                layers.push(format!("texture {{ pigment {{ rgbf 1 }} finish {{ {finish} }} }}"));
            }
            layers
        }
    }
}

/// A share of what is reflected, by Schlick's law if it grows.
fn grown(share: Triple, schlick: bool) -> String {
    let more = if schlick { ", rgb 1 falloff 5" } else { "" };
    format!("rgb {}{more}", triple(share))
}

/// The layers of what a side shows by itself, undermost first, of which this share
/// lets through what is under it, and the rest is as bright as all of it.
fn own(plain: &Plain, object: &Placed, paint: &Paint, is_back: bool, clear: f64) -> Vec<String> {
    let bright = (1.0 - clear).recip();
    match &object.look {
        Look::Constant(color) => {
            let finish = format!("emission {}", number(bright));
            vec![paint.layer(*color, clear, &finish)]
        }
        Look::Depth { near, far } => vec![unlit(&depth(plain, *near, *far))],
        // The normal is turned towards the viewer before it is asked for.
        Look::Normal(by) => vec![unlit(&normals(*by, is_back))],
        Look::Lit { diffuse, highlight } => {
            let share = match (is_back, plain.shading) {
                (false, _) => number(bright),
                // Its backs are dark.
                (true, Shading::Radiometric) => "0".to_owned(),
                // Lit by what is on the other side: the normal is not turned.
                (true, Shading::Classic | Shading::Attenuated) => format!("0, {}", number(bright)),
            };
            let ambient = scaled(plain.ambient, bright);
            let lit = |more: &str| {
                let finish = format!("diffuse {share}{more}{}", emission(ambient));
                paint.layer(*diffuse, clear, &finish)
            };
            match highlight {
                None => vec![lit("")],
                // There is one, and it is not seen: that was asked before.
                Some(_) if is_back => vec![lit("")],
                Some((specular, exponent)) if has_gray_highlight(&object.look) => {
                    let (strength, roughness) = (number(specular[0]), number(exponent.recip()));
                    vec![lit(&format!(" specular {strength} roughness {roughness}"))]
                }
                Some(highlight) => shiny(paint, *diffuse, *highlight, plain.ambient),
            }
        }
    }
}

fn unlit(pigment: &str) -> String {
    format!("texture {{ {pigment} finish {{ emission 1 }} }}")
}

/// The share of the ambient light that a surface gives back is its pigment's.
fn emission(ambient: Triple) -> String {
    if ambient == [0.0; 3] { String::new() } else { format!(" emission rgb {}", triple(ambient)) }
}

/// A highlight is of the light's color. One that has a color of its own is a
/// layer of its own, seen through a layer that filters and one that scatters:
/// the last lets half of it through, and is half opaque.
fn shiny(
    paint: &Paint,
    diffuse: Triple,
    (specular, exponent): (Triple, f64),
    ambient: Triple,
) -> Vec<String> {
    let [r, g, b] = specular;
    let most = r.max(g).max(b);
    let [r, g, b] = scaled(specular, most.recip());
    let filter = super::numbers([r, g, b, 1.0], ",");
    let (strength, roughness) = (number(2.0 * most), number(exponent.recip()));
    vec![
        format!(
            "texture {{ pigment {{ rgb 0 }} finish {{ specular {strength} roughness {roughness} }} }}"
        ),
        format!("texture {{ pigment {{ rgbf <{filter}> }} }}"),
        paint.layer(diffuse, 0.5, &format!("diffuse 2{}", emission(scaled(ambient, 2.0)))),
    ]
}

/// `(n + 1) / 2` in each channel, times a number. The value of a slope is an
/// angle, of which the wave is the sine; see `docs/adapters.md`.
fn normals(by: f64, is_back: bool) -> String {
    let axis = |axis: [f64; 3], color: Triple| {
        // The wave is followed where it falls, for numbers from 0 to 1.
        let direction = if is_back { axis } else { scaled(axis, -1.0) };
        format!(
            "[1 slope {} sine_wave frequency 0.5 phase 0.25 color_map {{ [0 rgb 0] [1 rgb {}] }}]",
            triple(direction),
            // The mean of three.
            triple(scaled(color, 3.0 * by))
        )
    };
    let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let all = units.map(|unit| axis(unit, unit)).join(" ");
    format!("pigment {{ average pigment_map {{ {all} }} }}")
}

/// A function of the place: white at `near`, black at `far`.
fn depth(plain: &Plain, near: f64, far: f64) -> String {
    let camera = &plain.camera;
    let e = camera.eye();
    let terms = |weights: [f64; 3]| {
        let all = ["x", "y", "z"].iter().zip(weights).zip(e.to_array());
        all.map(|((name, weight), from)| {
            format!("({})*({name}-({}))", number(weight), number(from))
        })
        .collect::<Vec<_>>()
        .join("+")
    };
    let distance = match camera.projection() {
        Projection::Perspective { .. } => {
            let square = |name, from| format!("pow({name}-({}),2)", number(from));
            let all = [square("x", e.x), square("y", e.y), square("z", e.z)];
            format!("sqrt({})", all.join("+"))
        }
        // From the window, whose normal the view's direction may not be.
        Projection::Parallel => {
            let [right, up] = camera.axes();
            let normal = right.cross(*up);
            terms((normal / normal.dot(*camera.forward())).to_array())
        }
    };
    let (far, range) = (number(far), number(far - near));
    format!(
        "pigment {{ function {{ min(1,max(0,({far}-({distance}))/{range})) }} \
         color_map {{ [0 rgb 0] [1 rgb 1] }} }}"
    )
}
