//! `Place`: where an imported scene and its files are written, whole or not at
//! all, and never outside the scene's folder.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

use harness::called::command;
use harness::store;

use crate::{CannotAsk, Here};

/// The scene file, and where its files are put.
#[derive(Debug)]
pub(super) struct Place {
    ron: PathBuf,
    /// From the scene's folder to that of its files, `/` between parts.
    assets: Option<String>,
}

impl Place {
    /// A scene file with its files in `assets`, or beside it.
    ///
    /// # Errors
    /// That folder is neither the scene's nor below it.
    pub(super) fn new(ron: PathBuf, assets: Option<&Path>) -> Result<Self, CannotAsk> {
        let Some(folder) = assets else { return Ok(Self { ron, assets: None }) };
        let wrong = || {
            let what =
                "--assets: expected the folder of the scene file or one below it, without ..";
            CannotAsk::file(folder, what)
        };
        let home = std::path::absolute(&ron)?;
        let inside = std::path::absolute(folder)?;
        let home = home.parent().unwrap_or(Path::new("."));
        let inside = inside.strip_prefix(home).map_err(|_| wrong())?;
        let part = |part: Component<'_>| match part {
            Component::Normal(name) => name.to_str().map(str::to_owned),
            _ => None,
        };
        let parts: Option<Vec<String>> = inside.components().map(part).collect();
        let parts = parts.ok_or_else(wrong)?;
        Ok(Self { ron, assets: (!parts.is_empty()).then(|| parts.join("/")) })
    }

    /// The scene file.
    pub(super) fn ron(&self) -> &Path {
        &self.ron
    }

    /// Where its files are put, if not beside it.
    pub(super) fn assets(&self) -> Option<&str> {
        self.assets.as_deref()
    }

    /// Writes the scene and its files. Files that are there and the same stay.
    ///
    /// # Errors
    /// A file that is there and differs, unless `force` and it is none of `ours`,
    /// which this command has written; a place outside the
    /// scene's folder or among the suite's own files; and whatever keeps a file
    /// from being written. Everything is then as it was.
    pub(super) fn write(
        &self,
        here: &Here,
        text: &str,
        files: &BTreeMap<String, Vec<u8>>,
        (force, ours): (bool, &mut BTreeSet<PathBuf>),
    ) -> Result<(), CannotAsk> {
        let folder = self.ron.parent().unwrap_or(Path::new("."));
        let beside = files.iter().map(|(name, bytes)| (folder.join(name), bytes.as_slice()));
        let scene = std::iter::once((self.ron.clone(), text.as_bytes()));
        let (mut to_write, mut named) = (Vec::new(), Vec::new());
        for (path, bytes) in beside.chain(scene) {
            here.may_write(&path).map_err(|why| with_a_way_on(here, &path, why))?;
            if !store::is_inside(&path, Path::new(".").join(folder).as_path()) {
                let what = "a link leads out of the scene's folder: remove it";
                return Err(CannotAsk::file(&path, what));
            }
            let force = force && !ours.contains(&path);
            // One byte more than ours is enough to differ.
            let before = match store::read(&path, bytes.len() as u64) {
                Ok(before) => before,
                Err(_) if force => store::read(&path, u64::MAX - 1)?,
                Err(_) => return Err(in_the_way(&path)),
            };
            match &before {
                Some(before) if before == bytes => {}
                Some(_) if !force => return Err(in_the_way(&path)),
                _ => to_write.push((path.clone(), bytes, before)),
            }
            named.push(path);
        }
        for (i, (path, bytes, _)) in to_write.iter().enumerate() {
            if let Err(why) = here.write(path, bytes) {
                for (path, _, before) in &to_write[..i] {
                    // What cannot be undone is named by the error's own file.
                    let _ = match before {
                        Some(before) => store::write(path, before),
                        None => store::remove(path),
                    };
                }
                return Err(why);
            }
        }
        ours.extend(named);
        Ok(())
    }
}

/// What to do about a place that the suite keeps for itself.
fn with_a_way_on(here: &Here, path: &Path, CannotAsk(why): CannotAsk) -> CannotAsk {
    let is_fixture = |root: &Path| store::is_inside(path, &root.join("fixtures"));
    if here.suite().is_ok_and(|suite| is_fixture(suite.root())) {
        return CannotAsk(format!(
            "{why}: write it elsewhere and look at it, then copy it there with the files that it \
             names, and `{} bless` it",
            command()
        ));
    }
    CannotAsk(format!("{why}: write it elsewhere"))
}

fn in_the_way(path: &Path) -> CannotAsk {
    CannotAsk::file(path, "is there already and is not the same: --force writes over it")
}
