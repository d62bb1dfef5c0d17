//! `meshes`: the meshes that the fixtures use, made by code.

use harness::sample_mesh::sample_meshes;
use harness::store;
use harness::suite::Suite;

use crate::{Answer, CannotAsk};

pub(crate) fn run(suite: &Suite) -> Result<Answer, CannotAsk> {
    for (path, bytes) in sample_meshes() {
        store::write(&suite.root().join(path), &bytes)?;
        println!("wrote {path}, {} bytes", bytes.len());
    }
    Ok(Answer::Yes)
}
