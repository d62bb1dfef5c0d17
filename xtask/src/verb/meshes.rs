//! `meshes`: the meshes that the fixtures use, made by code.

use harness::sample_mesh::sample_meshes;
use harness::store;

use crate::{Answer, CannotAsk, Here};

/// What the help ends with.
pub(crate) const EXAMPLES: &str = "\
Examples:
  cargo xtask meshes                    writes what fixtures/ has of meshes anew";

pub(crate) fn run(here: &Here) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    for (path, bytes) in sample_meshes() {
        store::write(&suite.root().join(path), &bytes)?;
        println!("wrote {path}, {} bytes", bytes.len());
    }
    Ok(Answer::Yes)
}
