//! What a glTF material is here: its base color, scattered evenly, or by itself
//! where it is unlit. Where roughness is 0 the model is a mirror, in the base
//! color for a metal and over it for what is none. Colors are linear.
//!
//! Source: "glTF 2.0 Specification", The Khronos Group, 2021, appendix B.

use scene::format;

use super::buffer::Buffers;
use super::document::{Document, Extensions, Material, Metal};
use super::texture;
use crate::import::mesh::pictures::Alpha;
use crate::import::mesh::stage::Stage;

/// The index of refraction of what is no metal, and does not say.
const GLAZE: f64 = 1.5;

/// Those that a scene may have.
const IORS: std::ops::RangeInclusive<f64> = 0.01..=100.0;

/// The material; what it asks for and does not get is noted.
///
/// # Errors
/// A color that is none, and a texture that is missing or damaged.
pub(super) fn of(
    written: &Material,
    place: &str,
    (document, buffers): (&Document, &mut Buffers<'_>),
    stage: &mut Stage,
) -> Result<format::Material, String> {
    let mut material = plain(written, place, stage)?;
    if let Some(info) = &written.pbr_metallic_roughness.base_color_texture {
        let place = format!("{place}: baseColorTexture");
        if let Some(slot) = material.texture_mut() {
            let alpha = if is_opaque(written) { Alpha::Ignored } else { Alpha::Counts };
            *slot = texture::of((info, alpha), &place, (document, buffers), stage)?;
        } else {
            stage.lost.add(None, place, "the texture is left out");
        }
    }
    Ok(material)
}

/// Whether alpha is to be ignored, that of the texture and of the base color: the
/// mode of what names none.
fn is_opaque(written: &Material) -> bool {
    written.alpha_mode.as_deref().is_none_or(|mode| mode == "OPAQUE")
}

/// The material without its texture.
fn plain(written: &Material, place: &str, stage: &mut Stage) -> Result<format::Material, String> {
    let Metal { base_color_factor, metallic_factor, roughness_factor, .. } =
        &written.pbr_metallic_roughness;
    let [r, g, b, _] = base_color_factor.unwrap_or([1.0; 4]);
    let color = [r, g, b];
    if !color.iter().all(|x| (0.0..=1.0).contains(x)) {
        return Err(format!("expected a baseColorFactor of numbers from 0 to 1, found {color:?}"));
    }
    let (metal, rough) = (metallic_factor.unwrap_or(1.0), roughness_factor.unwrap_or(1.0));
    let is_unlit = written.extensions.unlit.is_some();
    let mut lose = |keyword: &str, what: &str| {
        stage.lost.add(None, format!("{place}: {keyword}"), what);
    };
    for (there, keyword) in [
        (&written.pbr_metallic_roughness.metallic_roughness_texture, "metallicRoughnessTexture"),
        (&written.normal_texture, "normalTexture"),
        (&written.occlusion_texture, "occlusionTexture"),
        (&written.emissive_texture, "emissiveTexture"),
    ] {
        // Of the unlit model the base color is all.
        if there.is_some() && !is_unlit {
            lose(keyword, "the texture is left out");
        }
    }
    if written.emissive_factor != [0.0; 3] && !is_unlit {
        lose("emissiveFactor", "it emits no light");
    }
    if !is_opaque(written) {
        lose("alphaMode", "it is opaque");
    }
    for name in &written.extensions.others.0 {
        lose(name, "this extension is not read");
    }
    if is_unlit {
        return Ok(format::Material::Constant { color, texture: None });
    }
    let glass = &written.extensions;
    let through = glass.transmission.as_ref().map_or(0.0, |glass| glass.transmission_factor);
    let ior = glass.ior.as_ref().and_then(|glass| glass.ior).unwrap_or(GLAZE);
    if through != 0.0 {
        if is_clear(glass, metal, rough) && IORS.contains(&ior) {
            return Ok(format::Material::Dielectric { ior, tint: color, schlick: true });
        }
        let what = "it is opaque: only what has no metal, no roughness, all of its light going \
                    through and a volume without attenuation is glass";
        lose("KHR_materials_transmission", what);
    } else if glass.volume.as_ref().is_some_and(|volume| volume.thickness_factor != 0.0) {
        lose("KHR_materials_volume", "it is opaque");
    }
    let is_glazed = (metal, rough) == (0.0, 0.0) && IORS.contains(&ior);
    if glass.ior.is_some() && ior != GLAZE && !is_glazed {
        lose("KHR_materials_ior", "it is left out");
    }
    match (metal, rough) {
        (1.0, 0.0) => return Ok(format::Material::Mirror { reflectance: color, schlick: true }),
        (0.0, 0.0) => {
            return Ok(format::Material::Glazed {
                texture: None,
                ior: if is_glazed { ior } else { GLAZE },
                schlick: true,
                diffuse: Some(color),
                specular: [0.0; 3],
                exponent: 1.0,
            });
        }
        (0.0, 1.0) => {
            let what = "materials without metal and fully rough scatter their base color evenly, \
                        without the four parts in a hundred that glTF's model reflects";
            if !stage.chosen.iter().any(|said| said == what) {
                stage.chosen.push(what.to_owned());
            }
        }
        _ => {
            let factors = format!("metallic {metal} and roughness {rough}");
            let what = format!("{factors} are left out: it scatters its base color evenly");
            lose("pbrMetallicRoughness", &what);
        }
    }
    Ok(format::Material::Lambert { diffuse: Some(color), texture: None })
}

/// Whether a surface is the border of clear glass: without a volume it would be a
/// sheet of no thickness, which refracts nothing.
fn is_clear(written: &Extensions, metal: f64, rough: f64) -> bool {
    let is_whole = written.transmission.as_ref().is_some_and(|glass| {
        glass.transmission_factor == 1.0 && glass.transmission_texture.is_none()
    });
    let is_filled = written.volume.as_ref().is_some_and(|volume| {
        let is_clear = volume.attenuation_distance.is_none();
        volume.thickness_factor > 0.0 && volume.thickness_texture.is_none() && is_clear
    });
    is_whole && is_filled && metal == 0.0 && rough == 0.0
}
