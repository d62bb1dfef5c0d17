//! A scene in goldray's own format: as RON, and as JSON of the same structure.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use scene::{Assets, SceneFile};
use tracer::accel::Build;

use super::Exported;

/// As a RON file.
///
/// # Errors
/// The problems of a scene that makes no sense.
pub(super) fn ron(scene: &SceneFile, assets: &dyn Assets) -> Result<Exported, String> {
    with_files("scene.ron", scene, assets, &|scene| scene::write(scene))
}

/// As a JSON file, by `docs/schemas/scene.schema.json`.
///
/// # Errors
/// As [`ron`].
pub(super) fn json(scene: &SceneFile, assets: &dyn Assets) -> Result<Exported, String> {
    with_files("scene.json", scene, assets, &|scene| {
        let text = serde_json::to_string_pretty(scene).map_err(|error| error.to_string())?;
        Ok(text + "\n")
    })
}

/// The scene, and the files that it names.
fn with_files(
    main: &str,
    scene: &SceneFile,
    assets: &dyn Assets,
    write: &dyn Fn(&SceneFile) -> Result<String, String>,
) -> Result<Exported, String> {
    // What it takes to make the scene is what its files name: meshes, textures.
    let assets = Keeping { inner: assets, kept: RefCell::default() };
    scene::recompile(scene, &assets, Build::Bvh).map_err(|problems| problems.join("; "))?;
    let mut files = assets.kept.into_inner();
    files.insert(main.to_owned(), write(scene)?.into_bytes());
    Ok(Exported { main: main.to_owned(), files, grid: 1, beside: BTreeSet::new() })
}

/// Gives files, and keeps what it gave.
struct Keeping<'a> {
    inner: &'a dyn Assets,
    kept: RefCell<BTreeMap<String, Vec<u8>>>,
}

impl Assets for Keeping<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let bytes = self.inner.read(path)?;
        self.kept.borrow_mut().insert(path.to_owned(), bytes.clone());
        Ok(bytes)
    }
}
