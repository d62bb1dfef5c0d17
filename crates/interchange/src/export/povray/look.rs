//! Looks as textures. They come after a shape's matrix and so are in the
//! world's space.

use scene::format::{Shading, Triple};
use tracer::Projection;

use super::triple;
use crate::export::number;
use crate::export::plain::{Look, Placed, Plain};
use crate::export::text::scaled;

/// The texture, and that of the back if it is seen.
pub(super) fn texture(plain: &Plain, object: &Placed) -> String {
    match &object.look {
        Look::Constant(color) => unlit(&rgb(*color)),
        Look::Depth { near, far } => unlit(&depth(plain, *near, *far)),
        Look::Normal(by) => {
            let front = unlit(&normals(*by, false));
            // The normal is turned towards the viewer before it is asked for.
            let back = unlit(&normals(*by, true));
            if object.back_is_seen { with_back(&front, &back) } else { front }
        }
        Look::Lit { diffuse, highlight } => {
            let lit = |share: &str| {
                let finish = format!("diffuse {share}{}", emission(plain.ambient));
                format!("texture {{ {} finish {{ {finish} }} }}", rgb(*diffuse))
            };
            let front = match highlight {
                None => lit("1"),
                Some(highlight) => shiny(*diffuse, *highlight, plain.ambient),
            };
            if !object.back_is_seen {
                return front;
            }
            let back = match plain.shading {
                // Its backs are dark.
                Shading::Radiometric => lit("0"),
                // Lit by what is on the other side: the normal is not turned.
                Shading::Classic | Shading::Attenuated => lit("0, 1"),
            };
            with_back(&front, &back)
        }
    }
}

/// Whether a look has a highlight.
pub(super) fn has_highlight(look: &Look) -> bool {
    matches!(look, Look::Lit { highlight: Some(_), .. })
}

fn rgb(color: Triple) -> String {
    format!("pigment {{ rgb {} }}", triple(color))
}

fn unlit(pigment: &str) -> String {
    format!("texture {{ {pigment} finish {{ emission 1 }} }}")
}

fn with_back(front: &str, back: &str) -> String {
    let back = back.replace("texture {", "interior_texture {");
    format!("{front}\n  {back}")
}

/// The share of the ambient light that a surface gives back is its pigment's.
fn emission(ambient: Triple) -> String {
    if ambient == [0.0; 3] { String::new() } else { format!(" emission rgb {}", triple(ambient)) }
}

/// A highlight is of the light's color. One that has a color of its own is a
/// layer of its own, seen through a layer that filters and one that scatters:
/// the last lets half of it through, and is half opaque.
fn shiny(diffuse: Triple, (specular, exponent): (Triple, f64), ambient: Triple) -> String {
    let roughness = number(exponent.recip());
    let [r, g, b] = specular;
    if r == g && g == b {
        let strength = number(r);
        let finish = format!("diffuse 1 specular {strength} roughness {roughness}");
        return format!(
            "texture {{ {} finish {{ {finish}{} }} }}",
            rgb(diffuse),
            emission(ambient)
        );
    }
    let most = r.max(g).max(b);
    let [r, g, b] = scaled(specular, most.recip());
    let filter = super::numbers([r, g, b, 1.0], ",");
    let [r, g, b] = diffuse;
    let half = super::numbers([r, g, b, 0.5], ",");
    format!(
        "texture {{ pigment {{ rgb 0 }} finish {{ specular {} roughness {roughness} }} }}\n  \
         texture {{ pigment {{ rgbf <{filter}> }} }}\n  \
         texture {{ pigment {{ rgbt <{half}> }} finish {{ diffuse 2{} }} }}",
        number(2.0 * most),
        emission(scaled(ambient, 2.0))
    )
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
