//! What an MTL material is here.
//!
//! The models 0 to 2 are the lecture's own formulas: a color without light,
//! Lambert's law, and Blinn's form of Phong's highlight. Numbers of a model that
//! does not use them are passed over; colors are taken as linear.
//!
//! Source: "MTL material format (Lightwave, OBJ)", Alias|Wavefront, Inc., 1995,
//! section "Illumination models".

use scene::format::{Material, Triple};

use super::mtl::Definition;
use crate::import::mesh::stage::Stage;

/// The smallest exponent that there is; a highlight of it is as bright
/// everywhere, as one of 0 is.
const EVERYWHERE: f64 = 1e-60;

/// The material; what it asks for and does not get is noted.
pub(super) fn of(name: &str, written: &Definition, stage: &mut Stage) -> Material {
    let lost = &mut stage.lost;
    let mut lose = |line: Option<usize>, keyword: &str, what: &str| {
        let line = line.map_or(String::new(), |line| format!(":{line}"));
        let element = format!("{keyword} of material \"{name}\" ({}{line})", written.file);
        lost.add(Some(written.place), element, what);
    };
    let line = |keyword: &str| written.lines.get(keyword).copied();
    let is_colored = |color: Option<Triple>| color.is_some_and(|color| color != [0.0; 3]);
    let has_highlight = is_colored(written.ks);
    let illum = written.illum.unwrap_or(if has_highlight { 2 } else { 1 });
    if illum > 2 {
        lose(line("illum"), &format!("illum {illum}"), beyond(illum));
    }
    if written.d.is_some_and(|d| d < 1.0) {
        let keyword = if line("d").is_some() { "d" } else { "Tr" };
        lose(line(keyword), keyword, "it is not transparent");
    }
    if illum > 0 && is_colored(written.ka) && written.ka != written.kd {
        lose(line("Ka"), "Ka", "ambient light is reflected as by Kd");
    }
    if is_colored(written.ke) {
        lose(line("Ke"), "Ke", "it emits no light");
    }
    if written.map_kd.is_some() {
        lose(line("map_Kd"), "map_Kd", "the texture is left out, Kd stays");
    }
    for (line, keyword, what) in &written.others {
        lose(Some(*line), keyword, &format!("{what} is left out"));
    }
    if written.kd.is_none() {
        stage.chosen.push(format!("material \"{name}\" has no Kd: it is white"));
    }
    let diffuse = written.kd;
    match (illum, written.ks.filter(|_| has_highlight), written.ns) {
        (0, ..) => Material::Constant { color: diffuse.unwrap_or([1.0; 3]), texture: None },
        (1, ..) | (_, None, _) => Material::Lambert { diffuse, texture: None },
        (_, Some(specular), Some(exponent)) => Material::BlinnPhong {
            diffuse,
            specular,
            exponent: exponent.max(EVERYWHERE),
            texture: None,
        },
        (_, Some(_), None) => {
            lose(line("Ks"), "Ks", "a highlight without Ns, which says how sharp, is left out");
            Material::Lambert { diffuse, texture: None }
        }
    }
}

/// What a model does that models 0 to 2 do not.
fn beyond(illum: u32) -> &'static str {
    match illum {
        3 | 8 => "it reflects nothing",
        4 | 6 | 9 => "it reflects nothing and is not transparent",
        5 => "it reflects nothing, by Fresnel's law or else",
        7 => "it reflects nothing, by Fresnel's law or else, and is not transparent",
        10 => "it is seen, and not only its shadow",
        _ => "there is no such model: it is taken as 2",
    }
}
