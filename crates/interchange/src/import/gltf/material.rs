//! What a glTF material is here: its base color, scattered evenly, or by itself
//! where it is unlit. Where roughness is 0 the model is a mirror, in the base
//! color for a metal and over it for what is none. Colors are linear.
//!
//! Source: "glTF 2.0 Specification", The Khronos Group, 2021, appendix B.

use scene::format;

use super::document::{Material, Metal};
use crate::import::mesh::stage::Stage;

/// The index of refraction of what is no metal.
const GLAZE: f64 = 1.5;

/// The material; what it asks for and does not get is noted.
///
/// # Errors
/// A color that is none.
pub(super) fn of(
    written: &Material,
    place: &str,
    stage: &mut Stage,
) -> Result<format::Material, String> {
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
        (&written.pbr_metallic_roughness.base_color_texture, "baseColorTexture"),
        (&written.pbr_metallic_roughness.metallic_roughness_texture, "metallicRoughnessTexture"),
        (&written.normal_texture, "normalTexture"),
        (&written.occlusion_texture, "occlusionTexture"),
        (&written.emissive_texture, "emissiveTexture"),
    ] {
        // Of the unlit model the base color is all.
        if there.is_some() && (!is_unlit || keyword == "baseColorTexture") {
            lose(keyword, "the texture is left out");
        }
    }
    if written.emissive_factor != [0.0; 3] && !is_unlit {
        lose("emissiveFactor", "it emits no light");
    }
    if written.alpha_mode.as_deref().is_some_and(|mode| mode != "OPAQUE") {
        lose("alphaMode", "it is opaque");
    }
    for name in &written.extensions.others.0 {
        lose(name, "this extension is not read");
    }
    if is_unlit {
        return Ok(format::Material::Constant { color, texture: None });
    }
    match (metal, rough) {
        (1.0, 0.0) => return Ok(format::Material::Mirror { reflectance: color, schlick: true }),
        (0.0, 0.0) => {
            return Ok(format::Material::Glazed {
                texture: None,
                ior: GLAZE,
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
