//! A scene in goldray's own format: as RON, and as JSON of the same structure.

use std::collections::{BTreeMap, BTreeSet};

use scene::format::Object;
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
    scene::recompile(scene, assets, Build::Bvh).map_err(|problems| problems.join("; "))?;
    let mut files = BTreeMap::new();
    named_files(&scene.objects, assets, &mut files)?;
    files.insert(main.to_owned(), write(scene)?.into_bytes());
    Ok(Exported { main: main.to_owned(), files, grid: 1, beside: BTreeSet::new() })
}

fn named_files(
    objects: &[Object],
    assets: &dyn Assets,
    files: &mut BTreeMap<String, Vec<u8>>,
) -> Result<(), String> {
    for object in objects {
        match object {
            Object::Group { objects, .. } => named_files(objects, assets, files)?,
            Object::Mesh { file, .. } if !files.contains_key(file) => {
                let bytes = assets.read(file).map_err(|why| format!("mesh \"{file}\" {why}"))?;
                files.insert(file.clone(), bytes);
            }
            _ => {}
        }
    }
    Ok(())
}
