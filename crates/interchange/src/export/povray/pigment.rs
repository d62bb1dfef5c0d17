//! `Paint`: the color of a surface as a pigment, with its texture.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use scene::format::{Object, TexelEncoding, TexelFilter, Texture, Triple, Wrap};
use tracer::shape;

use super::triple;
use crate::export::number;
use crate::export::plain::{Placed, Plain};
use crate::export::text::{numbers, times, vector};

/// How an object is colored from place to place.
pub(super) struct Paint {
    /// What has to stand before the object.
    pub(super) declared: String,
    pattern: Pattern,
    /// What comes before a pigment, and at its end: where its coordinates are.
    place: (&'static str, String),
}

enum Pattern {
    /// The same everywhere.
    Plain,
    /// The first color where this function is below a half, and the second.
    Checker { function: String, colors: [Triple; 2] },
    /// Half of each channel, as functions.
    Image([String; 3]),
}

impl Paint {
    /// That of an object with this number; the files that it needs are added.
    pub(super) fn of(
        plain: &Plain,
        object: &Placed,
        number: usize,
        files: &mut BTreeMap<String, Vec<u8>>,
    ) -> Self {
        let mut paint =
            Self { declared: String::new(), pattern: Pattern::Plain, place: ("", String::new()) };
        let Some(texture) = &object.texture else { return paint };
        let Some(uv) = coordinates(object) else { return paint };
        paint.place = match object.shape {
            Object::Mesh { .. } => ("uv_mapping ", String::new()),
            _ => ("", super::shape::matrix(object).trim_start().to_owned()),
        };
        match texture {
            Texture::Checker { a, b, scale, offset } => {
                let [u, v] = laid(&uv, *scale, *offset);
                // Whole numbers are the ends of waves, where colors would be the first.
                let function = format!("0.25+0.5*abs(mod(floor({u})+floor({v}),2))");
                paint.pattern = Pattern::Checker { function, colors: [*a, *b] };
            }
            Texture::Image { file, filter, wrap, encoding, scale, offset } => {
                let Some(picture) = plain.textures.get(file) else { return paint };
                let name = format!("texture-{number}.png");
                let gamma = match encoding {
                    TexelEncoding::Srgb => "srgb",
                    TexelEncoding::Gamma22 => "2.2",
                    TexelEncoding::Linear => "1.0",
                };
                let filter = match filter {
                    TexelFilter::Nearest => "",
                    TexelFilter::Bilinear => " interpolate 2",
                };
                paint.declared = format!(
                    "#declare Texture{number} = function {{ pigment {{ image_map {{ \
                     png \"{name}\" gamma {gamma}{filter} }} }} }}\n"
                );
                let [u, v] = laid(&uv, *scale, *offset);
                let [u, v] = match wrap {
                    Wrap::Repeat => [u, v],
                    // From the middle of the first texel to that of the last.
                    Wrap::Clamp => {
                        let [width, height] = picture.size;
                        let within = |x: &str, count: u32| {
                            let half = 0.5 / f64::from(count);
                            let (low, high) = (self::number(half), self::number(1.0 - half));
                            format!("min({high},max({low},{x}))")
                        };
                        [within(&u, width), within(&v, height)]
                    }
                };
                let channel = |name: &str| format!("0.5*Texture{number}({u},{v},0).{name}");
                paint.pattern = Pattern::Image(["red", "green", "blue"].map(channel));
                files.insert(name, picture.png.clone());
            }
        }
        paint
    }

    /// A layer of this color, times the texture's, with this finish; it lets so
    /// large a share through of what is under it.
    pub(super) fn layer(&self, color: Triple, clear: f64, finish: &str) -> String {
        let rgb = |color: Triple| match clear {
            0.0 => format!("rgb {}", triple(color)),
            _ => format!("rgbt <{},{}>", numbers(color, ","), number(clear)),
        };
        let pigment = match &self.pattern {
            Pattern::Plain => rgb(color),
            Pattern::Checker { function, colors } => {
                let [a, b] = colors.map(|of| rgb(times(color, of)));
                format!("function {{ {function} }} color_map {{ [0.5 {a}] [0.5 {b}] }}")
            }
            Pattern::Image(channels) => {
                let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                let channel = |(function, unit): (&String, Triple)| {
                    // Half of it is there, and of three the mean.
                    let full = times(color, unit.map(|x| 6.0 * x));
                    let [none, full] = [rgb([0.0; 3]), rgb(full)];
                    format!("[1 function {{ {function} }} color_map {{ [0 {none}] [1 {full}] }}]")
                };
                let all: Vec<_> = channels.iter().zip(units).map(channel).collect();
                format!("average pigment_map {{ {} }}", all.join(" "))
            }
        };
        let (before, after) = &self.place;
        let after = if after.is_empty() { String::new() } else { format!(" {after}") };
        // Not before the pigment, where no other layer could be above or below.
        format!("texture {{ pigment {{ {before}{pigment}{after} }} finish {{ {finish} }} }}")
    }
}

/// A texture's coordinates, scaled and moved.
fn laid(uv: &[String; 2], scale: [f64; 2], offset: [f64; 2]) -> [String; 2] {
    std::array::from_fn(|k| format!("(({})*({})+({}))", number(scale[k]), uv[k], number(offset[k])))
}

/// Where a point of an object's own space is in its texture; of a mesh it is the
/// point itself. None for shapes that have no texture.
fn coordinates(object: &Placed) -> Option<[String; 2]> {
    let from = |[x, y, z]: Triple| {
        [("x", x), ("y", y), ("z", z)].map(|(name, from)| format!("({name}-({}))", number(from)))
    };
    match &object.shape {
        Object::Sphere { center, .. } => {
            let [x, y, z] = from(*center);
            let longitude = format!("atan2({x},{z})/{}", number(TAU));
            let latitude = format!("atan2({y},sqrt({x}*{x}+{z}*{z}))/{}", number(PI));
            Some([format!("0.5+{longitude}"), format!("0.5+{latitude}")])
        }
        Object::Plane { point, normal, .. } => {
            let plane = shape::Plane::new(vector(*point), vector(*normal)).ok()?;
            let [x, y, z] = from(*point);
            Some(plane.tangents().map(|t| {
                let [a, b, c] = t.to_array().map(number);
                format!("({a})*{x}+({b})*{y}+({c})*{z}")
            }))
        }
        Object::Mesh { .. } => Some(["x".to_owned(), "y".to_owned()]),
        _ => None,
    }
}
