//! `meshes`: the meshes and textures that the fixtures use, made by code.

use harness::sample_mesh::sample_meshes;
use harness::sample_texture::sample_textures;
use harness::store;

use crate::{Answer, CannotAsk, Here};

/// What the help ends with.
pub(crate) const EXAMPLES: &str = "\
Examples:
  cargo xtask meshes                    writes what fixtures/ has of meshes and textures anew";

pub(crate) fn run(here: &Here) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    let textures = sample_textures().map_err(CannotAsk)?;
    for (path, bytes) in sample_meshes().into_iter().chain(textures) {
        store::write(&suite.root().join(path), &bytes)?;
        println!("wrote {path}, {} bytes", bytes.len());
    }
    Ok(Answer::Yes)
}
