//! A scene in the language of pbrt-v4.
//!
//! Written by pbrt's own documentation and never run: `docs/adapters.md` says
//! what that means.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

use scene::format::{Shading, Triple};
use tracer::Projection;
use tracer::glam::DVec3;

use super::plain::{Lamp, Look, Plain, Solid, Triangles};
use super::text::{numbers, put, scaled, spaced, vector};
use super::{Exported, number};
use crate::Feature;

const MAIN: &str = "scene.pbrt";

/// A disk has no side of its own here: its normal is turned to where light and
/// eye are, as that of every surface.
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
    Feature::Mesh,
    Feature::Constant,
    Feature::Lambert,
    Feature::InverseSquarePointLight,
    Feature::DirectionalLight,
    Feature::Shadows,
    Feature::Classic,
    Feature::Attenuated,
    Feature::Radiometric,
    Feature::Background,
    Feature::GridSamples,
];

/// # Errors
/// What pbrt has no words for. What shines in it shines on everything, and of
/// several lights one is asked, by chance.
pub(super) fn write(plain: &Plain) -> Result<Exported, BTreeSet<Feature>> {
    plain.asks_only(CAN)?;
    together(plain)?;
    let is_lit = plain.objects.iter().any(|object| object.look.is_lit());
    let mut text = head(plain, is_lit);
    for lamp in &plain.lamps {
        text += &light(plain, lamp);
    }
    if plain.background != [0.0; 3] {
        put(&mut text, format_args!("LightSource \"infinite\" {}\n", rgb("L", plain.background)));
    }
    let mut files = BTreeMap::new();
    for object in &plain.objects {
        let look = match object.look {
            Look::Constant(color) => format!(
                "Material \"diffuse\" {}\nAreaLightSource \"diffuse\" {} \"bool twosided\" true\n",
                rgb("reflectance", [0.0; 3]),
                rgb("L", color)
            ),
            Look::Lit { diffuse, .. } => {
                format!("Material \"diffuse\" {}\n", rgb("reflectance", diffuse))
            }
            // It has no words for them; that was asked before.
            Look::Normal(_) | Look::Depth { .. } => continue,
        };
        let shape = shape(&object.solid(plain), &mut files);
        put(&mut text, format_args!("AttributeBegin\n{look}{shape}AttributeEnd\n"));
    }
    files.insert(MAIN.to_owned(), text.into_bytes());
    Ok(Exported { main: MAIN.to_owned(), files, grid: 1, beside: BTreeSet::new() })
}

/// # Errors
/// Features that it has words for, but not together.
fn together(plain: &Plain) -> Result<(), BTreeSet<Feature>> {
    let asks = |feature| plain.asks.contains(&feature);
    let lit_beside = [Feature::Constant, Feature::Background];
    let shine = lit_beside.into_iter().filter(|&feature| asks(feature));
    let mut cannot = BTreeSet::new();
    if asks(Feature::Lambert) {
        cannot.extend(shine);
        if !cannot.is_empty() {
            cannot.insert(Feature::Lambert);
        }
        if plain.lamps.len() > 1 {
            cannot.insert(Feature::SeveralLights);
        }
        let is_bright = |look: &Look| match look {
            Look::Lit { diffuse, .. } => diffuse.iter().any(|&share| share > 1.0),
            _ => false,
        };
        if plain.objects.iter().any(|object| is_bright(&object.look)) {
            cannot.insert(Feature::Lambert);
        }
    }
    if asks(Feature::Oblique) && asks(Feature::Parallel) {
        cannot.extend([Feature::Oblique, Feature::Parallel]);
    }
    if cannot.is_empty() { Ok(()) } else { Err(cannot) }
}

/// pbrt is left-handed, hence the mirror. With a field of view of 90 degrees its
/// screen window is the window at the distance 1.
fn head(plain: &Plain, is_lit: bool) -> String {
    let camera = &plain.camera;
    let [u, v] = camera.axes();
    let ahead = v.cross(*u);
    let eye = camera.eye();
    let half = [0.5 * camera.view_width(), 0.5 * camera.view_height()];
    let (kind, [right, up], distance) = match camera.projection() {
        Projection::Perspective { proj_distance } => {
            let middle = *camera.forward() * proj_distance;
            let beside = [middle.dot(*u), middle.dot(*v)];
            ("\"perspective\" \"float fov\" 90", beside, middle.dot(ahead))
        }
        Projection::Parallel => ("\"orthographic\"", [0.0; 2], 1.0),
    };
    let window = [right - half[0], right + half[0], up - half[1], up + half[1]];
    let (width, height) = plain.size;
    let depth = u8::from(is_lit);
    let side = plain.grid;
    format!(
        "Scale -1 1 1\nLookAt {}  {}  {}\nCamera {kind} \"float screenwindow\" [{}]\n\
         Film \"rgb\" \"integer xresolution\" {width} \"integer yresolution\" {height} \
         \"string filename\" \"scene.exr\"\n\
         PixelFilter \"box\" \"float xradius\" 0.5 \"float yradius\" 0.5\n\
         Sampler \"stratified\" \"integer xsamples\" {side} \"integer ysamples\" {side} \
         \"bool jitter\" false\n\
         Integrator \"path\" \"integer maxdepth\" {depth}\nWorldBegin\n",
        spaced(eye.to_array()),
        spaced((eye + ahead).to_array()),
        spaced(v.to_array()),
        numbers(window.map(|x| x / distance), " ")
    )
}

fn rgb(name: &str, color: Triple) -> String {
    format!("\"rgb {name}\" [{}]", spaced(color))
}

fn light(plain: &Plain, lamp: &Lamp) -> String {
    // Its surfaces have the factor 1/pi.
    let all = if plain.shading == Shading::Radiometric { 1.0 } else { PI };
    match *lamp {
        Lamp::Point { position, intensity, .. } => format!(
            "LightSource \"point\" {} \"point3 from\" [{}]\n",
            rgb("I", scaled(intensity, all)),
            spaced(position)
        ),
        Lamp::Directional { direction, intensity } => format!(
            "LightSource \"distant\" {} \"point3 from\" [0 0 0] \"point3 to\" [{}]\n",
            rgb("L", scaled(intensity, all)),
            spaced(vector(direction).normalize_or_zero().to_array())
        ),
    }
}

fn shape(solid: &Solid, files: &mut BTreeMap<String, Vec<u8>>) -> String {
    let radius_of = |r: f64| format!("\"float radius\" {}", number(r));
    match solid {
        Solid::Sphere { center, radius } => {
            format!(
                "Translate {}\nShape \"sphere\" {}\n",
                spaced(center.to_array()),
                radius_of(*radius)
            )
        }
        Solid::Disk { center, normal, radius } => {
            place(*center, *normal) + &format!("Shape \"disk\" {}\n", radius_of(*radius))
        }
        Solid::Cylinder { a, b, radius, open } => {
            let (radius, length) = (radius_of(*radius), number(a.distance(*b)));
            let mut text = place(*a, *b - *a);
            put(
                &mut text,
                format_args!(
                    "Shape \"cylinder\" {radius} \"float zmin\" 0 \"float zmax\" {length}\n"
                ),
            );
            if !open {
                put(&mut text, format_args!("Shape \"disk\" {radius} \"float height\" 0\n"));
                put(&mut text, format_args!("Shape \"disk\" {radius} \"float height\" {length}\n"));
            }
            text
        }
        Solid::Plane { point, normal, reach } => {
            triangles(&Triangles::square(*point, *normal, *reach), files)
        }
        Solid::Triangles(all) => triangles(all, files),
        // It has no words for them; that was asked before.
        Solid::Torus { .. } | Solid::Cone { .. } => String::new(),
    }
}

/// From the z axis at the origin to `z` at `center`.
fn place(center: DVec3, z: DVec3) -> String {
    let z = z.normalize_or_zero();
    let x = z.any_orthonormal_vector();
    let columns = [(x, 0), (z.cross(x), 0), (z, 0), (center, 1)];
    let columns = columns.map(|(v, w)| format!("{} {w}", spaced(v.to_array())));
    format!("ConcatTransform [{}]\n", columns.join(" "))
}

fn triangles(all: &Triangles, files: &mut BTreeMap<String, Vec<u8>>) -> String {
    let name = format!("triangles-{}.ply", files.len());
    files.insert(name.clone(), all.ply());
    format!("Shape \"plymesh\" \"string filename\" \"{name}\"\n")
}
