//! An imported scene as the text of a scene file, which is read again before
//! anybody gets it.

use std::fmt::Write as _;

use scene::format::{Material, Object, Texture};
use scene::{MAX_ASSET_BYTES, MAX_SCENE_BYTES, Unchecked, visible};

use super::{Imported, Unreadable};

impl Imported {
    /// Puts the files that the scene names into a folder beside it.
    pub fn move_files(&mut self, folder: &str) {
        fn inside(folder: &str, file: &mut String) {
            *file = format!("{folder}/{file}");
        }
        fn show(material: &mut Material, folder: &str) {
            if let Some(Some(Texture::Image { file, .. })) = material.texture_mut() {
                inside(folder, file);
            }
        }
        fn rename(objects: &mut [Object], folder: &str) {
            for object in objects {
                if let Some(material) = object.material_mut() {
                    show(material, folder);
                }
                match object {
                    Object::Mesh { file, .. } => inside(folder, file),
                    Object::Group { objects, .. } => rename(objects, folder),
                    _ => {}
                }
            }
        }
        rename(&mut self.scene.objects, folder);
        self.scene.materials.values_mut().for_each(|material| show(material, folder));
        let files = std::mem::take(&mut self.files);
        let moved = |(name, bytes)| (format!("{folder}/{name}"), bytes);
        self.files = files.into_iter().map(moved).collect();
    }

    /// The scene file's text: where it comes from, what was chosen and what is
    /// lost in comments, then the scene.
    ///
    /// # Errors
    /// Why that is no scene, or more than a scene may have: it was loaded.
    pub fn text(&self, from: &str) -> Result<String, Vec<Unreadable>> {
        let mut text = format!("// Imported from {}.\n", visible(from));
        // Writing to a String cannot fail.
        for chosen in &self.chosen {
            let _ = writeln!(text, "// Chosen: {}.", visible(chosen));
        }
        for lost in &self.lost {
            let place =
                lost.place.map_or(String::new(), |(line, column)| format!("{line}:{column}: "));
            let (element, what) = (visible(&lost.element), visible(&lost.what));
            let _ = writeln!(text, "// Lost: {place}{element}: {what}.");
        }
        let problem = |message: String, help: &str| {
            vec![Unreadable { place: None, message, help: Some(help.to_owned()) }]
        };
        let scene = scene::write(&self.scene)
            .map_err(|why| problem(format!("the scene cannot be written: {why}"), ""))?;
        text.push_str(&scene);
        if text.len() > MAX_SCENE_BYTES {
            let message = format!(
                "expected a scene file of at most {MAX_SCENE_BYTES} bytes, found that this one \
                 would have {}",
                text.len()
            );
            return Err(problem(message, "cut it into several scenes, or put objects into meshes"));
        }
        for (name, bytes) in &self.files {
            if bytes.len() as u64 > MAX_ASSET_BYTES {
                let message = format!(
                    "{}: expected a file of at most {MAX_ASSET_BYTES} bytes, found {}",
                    visible(name),
                    bytes.len()
                );
                return Err(problem(message, "cut it into several files"));
            }
        }
        scene::load::<Unchecked>(&text, &self.files, tracer::accel::Build::default()).map_err(
            |problems| {
                let unreadable = |problem: scene::Problem| Unreadable {
                    place: None,
                    message: format!("the imported scene makes no sense: {}", problem.message),
                    help: problem.help,
                };
                problems.into_iter().map(unreadable).collect::<Vec<_>>()
            },
        )?;
        Ok(text)
    }
}
