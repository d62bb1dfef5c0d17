//! What an MTL material is here.
//!
//! The models 0 to 2 are the lecture's own formulas: a color without light,
//! Lambert's law, and Blinn's form of Phong's highlight; 3 and 6 are Whitted's
//! sum. Numbers of a model that does not use them are passed over; colors are
//! taken as linear.
//!
//! Source: "MTL material format (Lightwave, OBJ)", Alias|Wavefront, Inc., 1995,
//! section "Illumination models".

use scene::Assets;
use scene::format::{Material, TexelEncoding, TexelFilter, Texture, Triple, Wrap};

use super::map::Map;
use super::mtl::Definition;
use crate::import::Unreadable;
use crate::import::files::fetch;
use crate::import::mesh::pictures::{Alpha, Unseen};
use crate::import::mesh::stage::Stage;
use crate::import::mesh::unreadable;

/// The smallest exponent that there is; a highlight of it is as bright
/// everywhere, as one of 0 is.
const EVERYWHERE: f64 = 1e-60;

/// The material; what it asks for and does not get is noted.
///
/// # Errors
/// A texture's file that is missing or damaged.
pub(super) fn of(
    name: &str,
    written: &Definition,
    assets: &dyn Assets,
    stage: &mut Stage,
) -> Result<Material, Unreadable> {
    let mut material = lit(name, written, stage);
    if let Some(map) = &written.map_kd {
        let texture = texture(name, written, map, assets, stage)?;
        if let Some(slot) = material.texture_mut() {
            *slot = texture;
        }
    }
    Ok(material)
}

/// The texture of its diffuse color; `None` for one that is lost.
fn texture(
    name: &str,
    written: &Definition,
    map: &Map,
    assets: &dyn Assets,
    stage: &mut Stage,
) -> Result<Option<Texture>, Unreadable> {
    let line = written.lines.get("map_Kd").copied().unwrap_or_default();
    let of = format!("of material \"{name}\" ({}:{line})", written.file);
    for (option, what) in &map.lost {
        let element = format!("map_Kd {option} {of}");
        stage.lost.add(Some(written.place), element, format!("{what} is left out"));
    }
    // Beside the library, as its own name is beside the OBJ file.
    let folder = written.file.rsplit_once('/').map_or(String::new(), |(f, _)| format!("{f}/"));
    let path = format!("{folder}{}", map.file);
    match stage.pictures.name((&path, Alpha::Counts), || fetch(&path, assets)) {
        Ok(file) => {
            let wrap = if map.is_clamped { Wrap::Clamp } else { Wrap::Repeat };
            let once = if map.is_clamped { ", and with -clamp its border goes on" } else { "" };
            let said = format!(
                "textures multiply Kd, are stored by the sRGB curve and smoothed; -s multiplies \
                 their coordinates and -o is added to that{once}"
            );
            if !stage.chosen.contains(&said) {
                stage.chosen.push(said);
            }
            let (scale, offset) = (map.scale, map.offset);
            let (filter, encoding) = (TexelFilter::Bilinear, TexelEncoding::Srgb);
            Ok(Some(Texture::Image { file, filter, wrap, encoding, scale, offset }))
        }
        Err(Unseen::Unknown(why)) => {
            let what = format!("the texture is left out, Kd stays: \"{}\" {why}", map.file);
            stage.lost.add(Some(written.place), format!("map_Kd {of}"), what);
            Ok(None)
        }
        Err(Unseen::Broken(why)) => {
            let message = format!("map_Kd {of}: the texture \"{}\" {why}", map.file);
            let help = "put a PNG file there, beside the library, or remove this line";
            Err(Unreadable { help: Some(help.to_owned()), ..unreadable(written.place, message) })
        }
    }
}

/// The material without its texture.
fn lit(name: &str, written: &Definition, stage: &mut Stage) -> Material {
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
    let lack = lacks(illum);
    if !lack.is_empty() {
        lose(line("illum"), &format!("illum {illum}"), lack);
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
    for (line, keyword, what) in &written.others {
        lose(Some(*line), keyword, &format!("{what} is left out"));
    }
    if written.kd.is_none() {
        stage.chosen.push(format!("material \"{name}\" has no Kd: it is white"));
    }
    let diffuse = written.kd;
    if illum == 0 {
        return Material::Constant { color: diffuse.unwrap_or([1.0; 3]), texture: None };
    }
    let ks = written.ks.filter(|_| has_highlight && illum > 1);
    if ks.is_some() && written.ns.is_none() {
        lose(line("Ks"), "Ks", "a highlight without Ns, which says how sharp, is left out");
    }
    let exponent = written.ns.map(|ns| ns.max(EVERYWHERE));
    let highlight = ks.zip(exponent);
    let (reflects, refracts) = (matches!(illum, 3..=7), matches!(illum, 6 | 7));
    if reflects && (ks.is_some() || refracts) {
        let reflect = ks.unwrap_or_default();
        let through = written.tf.unwrap_or([1.0; 3]);
        let transmit =
            if refracts { [0, 1, 2].map(|k| (1.0 - reflect[k]) * through[k]) } else { [0.0; 3] };
        let is_share = |x: &f64| (0.0..=1.0).contains(x);
        if reflect.iter().chain(&transmit).all(is_share) {
            let (specular, exponent) = highlight.unwrap_or(([0.0; 3], 1.0));
            let ior = if refracts { written.ni.unwrap_or(1.0) } else { 1.0 };
            let schlick = matches!(illum, 5 | 7);
            return Material::Whitted {
                diffuse,
                specular,
                exponent,
                reflect,
                transmit,
                ior,
                schlick,
                texture: None,
            };
        }
        let what = "it reflects and refracts nothing: its shares are more than 1";
        lose(line("illum"), &format!("illum {illum}"), what);
    }
    match highlight {
        Some((specular, exponent)) => {
            Material::BlinnPhong { diffuse, specular, exponent, texture: None }
        }
        None => Material::Lambert { diffuse, texture: None },
    }
}

/// What a model does that is not done here.
pub(super) fn lacks(illum: u32) -> &'static str {
    match illum {
        0..=3 | 6 => "",
        4 => "it is not transparent: the model refracts nothing",
        5 => "Fresnel's law is left out of its highlights, and Schlick's stands in for it",
        7 => {
            "Fresnel's law is left out of its highlights and of what goes through, and Schlick's \
              stands in for it"
        }
        8 => "it reflects nothing: the model sends no rays",
        9 => "it reflects nothing and is not transparent: the model sends no rays",
        10 => "it is seen, and not only its shadow",
        _ => "there is no such model: it is taken as 2",
    }
}
