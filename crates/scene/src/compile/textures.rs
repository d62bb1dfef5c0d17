//! Textures, each file of which is read once.

use std::collections::BTreeMap;
use std::sync::Arc;

use tracer::texture::{Checker, Image, Pattern, TexelFilter, Texels, Wrap};
use tracer::{Rgb, Texture};

use super::{Findings, Path};
use crate::format::{self, TexelEncoding};
use crate::{Assets, check_path, texture};

/// The largest number of texels of all pictures of a scene.
const MAX_TEXELS: u64 = 1 << 26;

/// The pictures that a scene names.
pub(super) struct Textures<'a> {
    assets: &'a dyn Assets,
    /// `None` for one with a finding.
    pictures: BTreeMap<(String, TexelEncoding), Option<Arc<Texels>>>,
    texels: u64,
}

impl<'a> Textures<'a> {
    pub(super) fn new(assets: &'a dyn Assets) -> Self {
        Self { assets, pictures: BTreeMap::new(), texels: 0 }
    }

    /// The texture; `None` with a finding.
    pub(super) fn make(
        &mut self,
        written: &format::Texture,
        path: &Path,
        findings: &mut Findings,
    ) -> Option<Arc<Texture>> {
        let (pattern, scale, offset) = match written {
            format::Texture::Checker { a, b, scale, offset } => {
                let made = Checker::new([Rgb::from(*a), Rgb::from(*b)]);
                (findings.accept(path, made).map(Pattern::Checker), scale, offset)
            }
            format::Texture::Image { file, filter, wrap, encoding, scale, offset } => {
                let filter = match filter {
                    format::TexelFilter::Nearest => TexelFilter::Nearest,
                    format::TexelFilter::Bilinear => TexelFilter::Bilinear,
                };
                let wrap = match wrap {
                    format::Wrap::Repeat => Wrap::Repeat,
                    format::Wrap::Clamp => Wrap::Clamp,
                };
                let texels = self.picture(file, *encoding, &path.field("file"), findings);
                let image = texels.map(|texels| Image::new(texels, filter, wrap));
                (image.map(Pattern::Image), scale, offset)
            }
        };
        // The layout is judged although the pattern may be wrong.
        let stand_in = || Checker::new([Rgb::BLACK; 2]).ok().map(Pattern::Checker);
        let is_good = pattern.is_some();
        let made = Texture::new(pattern.or_else(stand_in)?, *scale, *offset);
        findings.accept(path, made).filter(|_| is_good).map(Arc::new)
    }

    /// The texels of a file; of one with a finding that is told where it is first
    /// named.
    fn picture(
        &mut self,
        file: &str,
        encoding: TexelEncoding,
        path: &Path,
        findings: &mut Findings,
    ) -> Option<Arc<Texels>> {
        let key = (file.to_owned(), encoding);
        if let Some(known) = self.pictures.get(&key) {
            return known.clone();
        }
        let read = self.read(file, encoding).map(Arc::new);
        let read = read.map_err(|message| findings.add(path, message)).ok();
        self.pictures.insert(key, read.clone());
        read
    }

    fn read(&mut self, file: &str, encoding: TexelEncoding) -> Result<Texels, String> {
        check_path(file).map_err(|expected| format!("expected {expected}, found \"{file}\""))?;
        let named = |why| format!("texture \"{file}\" {why}");
        texture::check_ending(file).map_err(named)?;
        let bytes = self.assets.read(file).map_err(named)?;
        let texels = texture::read(&bytes, encoding).map_err(named)?;
        let size = texels.size();
        self.texels += u64::from(size.width) * u64::from(size.height);
        if self.texels > MAX_TEXELS {
            return Err(named(format!(
                "is one too many: expected at most {MAX_TEXELS} texels in all textures of a scene, \
                 found {}",
                self.texels
            )));
        }
        Ok(texels)
    }
}
