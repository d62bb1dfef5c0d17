//! `Assets`: where a scene's meshes and textures come from.
//!
//! A scene names files relative to its own folder. Which names are allowed is
//! decided here, once; opening them is the caller's.

use std::collections::BTreeMap;

/// The largest scene file that is read, in bytes.
pub const MAX_SCENE_BYTES: usize = 4 << 20;

/// The largest mesh or texture file that is read, in bytes.
pub const MAX_ASSET_BYTES: u64 = 256 << 20;

/// Gives the bytes of the files that a scene names.
pub trait Assets {
    /// The bytes of the file at `path`, which [`check_path`] has accepted:
    /// relative to the scene's folder, `/` between its parts.
    ///
    /// # Errors
    /// Why it cannot be had, as the end of a sentence that starts with the
    /// file's name: "does not exist".
    fn read(&self, path: &str) -> Result<Vec<u8>, String>;
}

/// No files at all: for scenes without meshes and textures.
#[derive(Debug, Clone, Copy)]
pub struct NoAssets;

impl Assets for NoAssets {
    fn read(&self, _: &str) -> Result<Vec<u8>, String> {
        Err("cannot be read: no files are at hand here".to_owned())
    }
}

/// Files in memory, by path.
impl Assets for BTreeMap<String, Vec<u8>> {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.get(path).cloned().ok_or_else(|| "does not exist".to_owned())
    }
}

/// Whether a scene may name this path.
///
/// # Errors
/// What is expected instead: absolute paths, `..`, backslashes and empty parts
/// are refused, so that no scene reaches outside its own folder.
pub fn check_path(path: &str) -> Result<(), &'static str> {
    let expected =
        "a path inside the scene's own folder: relative, with `/` between its parts and no `..`";
    let is_plain = |part: &str| !matches!(part, "" | "." | "..");
    let plain =
        path.split('/').all(is_plain) && !path.contains(['\\', '\0', ':']) && path.len() <= 1_000;
    if plain { Ok(()) } else { Err(expected) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_inside() {
        for path in ["a.obj", "meshes/a.obj", "a..b.obj", "...obj", "a b.ply"] {
            assert!(check_path(path).is_ok(), "{path}");
        }
        for path in [
            "",
            "/etc/passwd",
            "../a.obj",
            "a/../../b.obj",
            "./a.obj",
            "a//b.obj",
            "a/",
            "..",
            "C:\\a.obj",
            "c:/a.obj",
            "a\\b.obj",
            "a\0.obj",
        ] {
            assert!(check_path(path).is_err(), "{path}");
        }
    }
}
