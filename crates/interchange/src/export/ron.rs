//! goldray's own format: the scene as it is, with the files that it names.

use std::collections::BTreeMap;

use scene::format::Object;
use scene::{Assets, SceneFile, Unchecked};

use super::{Exported, NotWritten};

/// The scene's text beside its files.
///
/// # Errors
/// A scene that cannot be written, and a file that cannot be had.
pub(super) fn write(
    scene: &SceneFile<Unchecked>,
    assets: &dyn Assets,
) -> Result<Exported, NotWritten> {
    const MAIN: &str = "scene.ron";
    let text = scene::write(scene).map_err(NotWritten::Bad)?;
    let mut files = BTreeMap::new();
    named(&scene.objects, assets, &mut files)?;
    files.insert(MAIN.to_owned(), text.into_bytes());
    Ok(Exported { main: MAIN.to_owned(), files, grid: 1 })
}

fn named(
    objects: &[Object],
    assets: &dyn Assets,
    files: &mut BTreeMap<String, Vec<u8>>,
) -> Result<(), NotWritten> {
    for object in objects {
        match object {
            Object::Group { objects, .. } => named(objects, assets, files)?,
            Object::Mesh { file, .. } if !files.contains_key(file) => {
                let bytes = assets.read(file);
                let bytes = bytes.map_err(|why| NotWritten::Bad(format!("\"{file}\" {why}")))?;
                files.insert(file.clone(), bytes);
            }
            _ => {}
        }
    }
    Ok(())
}
