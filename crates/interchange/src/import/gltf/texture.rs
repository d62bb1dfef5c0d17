//! Textures of a glTF file: a picture in a view, in the document or in a file
//! beside it, and the sampler that says how it is seen.

use scene::format::{TexelFilter, Texture, Wrap};

use super::buffer::{Buffers, none};
use super::document::{Document, Sampler, TextureInfo};
use crate::import::mesh::pictures::{Alpha, Unseen, image};
use crate::import::mesh::stage::Stage;

/// The texture that a material names at `place`, whose alpha counts or not;
/// `None` for one that is lost.
///
/// # Errors
/// What leads nowhere, and pictures that are missing or damaged.
pub(super) fn of(
    (info, alpha): (&TextureInfo, Alpha),
    place: &str,
    (document, buffers): (&Document, &mut Buffers<'_>),
    stage: &mut Stage,
) -> Result<Option<Texture>, String> {
    let textures = &document.textures;
    let texture =
        textures.get(info.index).ok_or_else(|| none("textures", textures.len(), info.index))?;
    let within = |why: String| format!("textures[{}]: {why}", info.index);
    let mut lose = |what: &str| stage.lost.add(None, place, what);
    for name in info.extensions.others.0.iter().chain(&texture.extensions.others.0) {
        lose(&format!("the extension {name} is not read"));
    }
    if info.tex_coord != 0 {
        lose("the texture is left out, as it has coordinates of its own");
        return Ok(None);
    }
    let Some(source) = texture.source else {
        lose("the texture is left out, as it has no picture that is read");
        return Ok(None);
    };
    let samplers = &document.samplers;
    let sampler = match texture.sampler {
        None => &Sampler::default(),
        Some(number) => {
            let found = samplers.get(number);
            found.ok_or_else(|| within(none("samplers", samplers.len(), number)))?
        }
    };
    let (wrap, filter) = seen(sampler, &mut lose).map_err(within)?;
    let images = &document.images;
    let picture = images.get(source).ok_or_else(|| within(none("images", images.len(), source)))?;
    let read = || {
        buffers.picture(picture).map(|(file, bytes)| {
            let name = file.unwrap_or_else(|| {
                let is_png = picture.mime_type.as_deref() == Some("image/png");
                format!("image-{source}{}", if is_png { ".png" } else { "" })
            });
            (name, bytes)
        })
    };
    match stage.pictures.name((&format!("images[{source}]"), alpha), read) {
        Ok(file) => {
            let said = "textures are not averaged where they look small: of their filters that for \
                        magnification counts";
            if !stage.chosen.iter().any(|other| other == said) {
                stage.chosen.push(said.to_owned());
            }
            Ok(Some(image(file, wrap, filter)))
        }
        Err(Unseen::Unknown(why)) => {
            let what = format!("the texture is left out: images[{source}] {why}");
            stage.lost.add(None, place, what);
            Ok(None)
        }
        Err(Unseen::Broken(why)) => Err(format!("images[{source}] {why}")),
    }
}

/// What a sampler says; the defaults are those of the specification, and
/// smoothing where it has none.
fn seen(sampler: &Sampler, lose: &mut impl FnMut(&str)) -> Result<(Wrap, TexelFilter), String> {
    const CLAMP_TO_EDGE: u32 = 33_071;
    const MIRRORED_REPEAT: u32 = 33_648;
    const REPEAT: u32 = 10_497;
    let [u, v] = [sampler.wrap_s, sampler.wrap_t].map(|wrap| wrap.unwrap_or(REPEAT));
    if let Some(bad) =
        [u, v].iter().find(|w| !matches!(**w, CLAMP_TO_EDGE | MIRRORED_REPEAT | REPEAT))
    {
        return Err(format!(
            "expected a wrap of {REPEAT}, {CLAMP_TO_EDGE} or {MIRRORED_REPEAT}, found {bad}"
        ));
    }
    let wrap = if (u, v) == (CLAMP_TO_EDGE, CLAMP_TO_EDGE) { Wrap::Clamp } else { Wrap::Repeat };
    if u == MIRRORED_REPEAT || v == MIRRORED_REPEAT {
        lose("the texture is repeated, and not mirrored by turns");
    } else if u != v {
        lose("the texture is repeated both ways, and not one way alone");
    }
    let filter = match sampler.mag_filter {
        Some(9_728) => TexelFilter::Nearest,
        None | Some(9_729) => TexelFilter::Bilinear,
        Some(bad) => return Err(format!("expected a magFilter of 9728 or 9729, found {bad}")),
    };
    Ok((wrap, filter))
}
