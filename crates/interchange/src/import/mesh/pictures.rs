//! `Pictures`: the PNG files that materials show, each judged once.

use std::collections::BTreeMap;

use scene::format::{Material, Object, TexelEncoding, TexelFilter, Texture, Wrap};

use crate::import::files::Files;
use crate::import::sense::Sense;

/// What every PNG file begins with.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Why a picture is not shown, as the end of a sentence about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::import) enum Unseen {
    /// It is what is not done here: a loss.
    Unknown(String),
    /// It is missing or damaged: there is no scene.
    Broken(String),
}

/// What becomes of a picture's alpha.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::import) enum Alpha {
    /// One below 1 asks for what is not done here.
    Counts,
    /// The format says that it does not count: it is taken off.
    Ignored,
}

/// Pictures by what their file calls them.
#[derive(Debug, Default)]
pub(in crate::import) struct Pictures {
    files: Files,
    known: BTreeMap<(String, Alpha), Result<String, Unseen>>,
}

impl Pictures {
    /// All files, by the names that textures have for them.
    pub(in crate::import) fn into_map(self) -> BTreeMap<String, Vec<u8>> {
        self.files.into_map()
    }

    /// The name of a picture. `read` gives a name to have it under and its bytes,
    /// and is not asked again for the same `key` and `alpha`.
    ///
    /// # Errors
    /// See [`Unseen`].
    pub(in crate::import) fn name(
        &mut self,
        (key, alpha): (&str, Alpha),
        read: impl FnOnce() -> Result<(String, Vec<u8>), String>,
    ) -> Result<String, Unseen> {
        let key = (key.to_owned(), alpha);
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let judged =
            read().map_err(Unseen::Broken).and_then(|(name, bytes)| self.keep(name, bytes, alpha));
        self.known.insert(key, judged.clone());
        judged
    }

    /// What a file is is told by its bytes: many have the wrong ending.
    fn keep(&mut self, mut name: String, bytes: Vec<u8>, alpha: Alpha) -> Result<String, Unseen> {
        if !bytes.starts_with(PNG) && !scene::is_texture(&name) {
            return Err(Unseen::Unknown("is no PNG file, the only pictures that are read".into()));
        }
        if !scene::is_texture(&name) {
            name += ".png";
        }
        // What is wrong with a file that is none is told below.
        let bytes = match alpha {
            Alpha::Ignored => scene::without_alpha(&bytes).ok().flatten().unwrap_or(bytes),
            Alpha::Counts => bytes,
        };
        match judge(&name, &bytes) {
            None => Ok(self.files.add(&name, bytes)),
            Some(why) if why.contains("is not a readable PNG file") => Err(Unseen::Broken(why)),
            // An alpha channel, several pictures in one, a size beyond all limits.
            Some(why) => Err(Unseen::Unknown(why)),
        }
    }
}

/// What is wrong with a picture, as the end of a sentence that begins with it.
fn judge(name: &str, bytes: &[u8]) -> Option<String> {
    let mut scene = Sense::new()?.blank();
    let texture = Some(image(name.to_owned(), Wrap::Repeat, TexelFilter::Nearest));
    let material = Some(Material::Constant { color: [1.0; 3], texture });
    scene.objects = vec![Object::Plane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], material }];
    let assets = BTreeMap::from([(name.to_owned(), bytes.to_vec())]);
    let judged = scene::recompile(&scene, &assets, tracer::accel::Build::default());
    let why = judged.err()?.into_iter().next()?;
    let named = format!("texture \"{name}\" ");
    Some(why.split_once(&named).map_or(why.clone(), |(_, why)| why.to_owned()))
}

/// A picture over the coordinates from 0 to 1, as most programs store them.
pub(in crate::import) fn image(file: String, wrap: Wrap, filter: TexelFilter) -> Texture {
    let (scale, offset) = ([1.0; 2], [0.0; 2]);
    Texture::Image { file, filter, wrap, encoding: TexelEncoding::Srgb, scale, offset }
}

/// The material without its texture, in the color that this multiplies; `None`
/// where it has none.
pub(in crate::import) fn bare(material: &Material) -> Option<Material> {
    material.texture()?;
    let mut bare = material.clone();
    *bare.texture_mut()? = None;
    if let Material::Lambert { diffuse, .. }
    | Material::BlinnPhong { diffuse, .. }
    | Material::Whitted { diffuse, .. }
    | Material::Glazed { diffuse, .. } = &mut bare
    {
        // Which is not the default of every convention.
        diffuse.get_or_insert([1.0; 3]);
    }
    Some(bare)
}
