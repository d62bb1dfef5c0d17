//! `Sense`: whether a part of a scene makes sense, asked while its place in the
//! foreign file is still known.

use scene::format::{Material, Object};
use scene::{NoAssets, SceneFile, Unchecked};
use tracer::accel::Build;

/// A scene with nothing in it, into which parts are put.
#[derive(Debug, Clone)]
pub(super) struct Sense {
    blank: SceneFile<Unchecked>,
}

impl Sense {
    /// `None` only where the text below were no scene, which a test rules out.
    pub(super) fn new() -> Option<Self> {
        const BLANK: &str = "(version: 1, image: (1, 1), camera: LookAt(eye: (0, 0, 1), at: (0, 0, 0), fov_deg: 90))";
        scene::parse(BLANK).map(|blank| Self { blank })
    }

    /// A scene with everything at its default.
    pub(super) fn blank(&self) -> SceneFile<Unchecked> {
        self.blank.clone()
    }

    /// What makes no sense in a scene with this change.
    pub(super) fn of(&self, change: impl FnOnce(&mut SceneFile<Unchecked>)) -> Vec<String> {
        let mut file = self.blank();
        change(&mut file);
        scene::recompile(&file, &NoAssets, Build::default()).err().unwrap_or_default()
    }

    /// What makes no sense in an object's own numbers.
    pub(super) fn of_object(&self, object: &Object) -> Vec<String> {
        self.of(|file| {
            let mut object = object.clone();
            *object.material_mut() = None;
            file.objects = vec![object];
        })
    }

    /// What makes no sense in a material.
    pub(super) fn of_material(&self, material: &Material) -> Vec<String> {
        self.of(|file| _ = file.materials.insert(String::new(), material.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_blank_scene_is_one_and_parts_are_judged() {
        let sense = Sense::new().unwrap();
        assert_eq!(sense.of(|_| ()), [""; 0]);
        let ball = |radius| Object::Sphere { center: [0.0; 3], radius, material: None };
        assert_eq!(sense.of_object(&ball(1.0)), [""; 0]);
        assert!(sense.of_object(&ball(-1.0))[0].contains("`radius`"));
        let wrong = Material::Constant { color: [-1.0, 0.0, 0.0], texture: None };
        assert!(sense.of_material(&wrong)[0].contains("`color`"));
    }
}
