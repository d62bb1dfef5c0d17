//! `Stage`: a scene made of meshes, with a camera, lights and a size for the
//! picture where the file has none.
//!
//! What is chosen is said. The rules: the camera looks at the middle of all there
//! is from the diagonal between +x, +y and +z, with everything in view; the light
//! comes from where the camera is; the picture's longer side has 512 pixels.

use scene::format::{Camera, Light, Material, Object, Shading};
use scene::{SceneFile, Unchecked};
use tracer::Aabb;
use tracer::glam::DVec3;

use super::names::Names;
use super::part::Part;
use super::pictures::{Pictures, bare};
use super::shot::Shot;
use super::tally::Tally;
use crate::import::{Imported, Unreadable, Wishes};

/// The longer side of a picture whose size nobody says.
const SIDE: u32 = 512;

/// What a file says of a scene.
#[derive(Debug, Default)]
pub(in crate::import) struct Stage {
    /// Meshes, each with the name of its material.
    pub(in crate::import) parts: Vec<(Part, Option<String>)>,
    /// Materials by name.
    pub(in crate::import) materials: std::collections::BTreeMap<String, Material>,
    /// What they show.
    pub(in crate::import) pictures: Pictures,
    /// The camera.
    pub(in crate::import) shot: Option<Shot>,
    /// The lights.
    pub(in crate::import) lights: Vec<Light>,
    /// The formulas that its lights and materials are meant for.
    pub(in crate::import) shading: Shading,
    /// What is lost.
    pub(in crate::import) lost: Tally,
    /// What was chosen.
    pub(in crate::import) chosen: Vec<String>,
}

impl Stage {
    /// The scene; `source` is the name of the file that it comes from.
    ///
    /// # Errors
    /// No triangle at all, and meshes that are too large to be written.
    pub(in crate::import) fn imported(
        mut self,
        source: &str,
        wishes: &Wishes,
    ) -> Result<Imported, Vec<Unreadable>> {
        self.parts.retain(|(part, _)| !part.faces.is_empty());
        let corners = self.parts.iter().flat_map(|(part, _)| &part.vertices).copied();
        let bounds = Aabb::around(corners);
        if self.parts.is_empty() {
            let help = self.lost.into_lost().first().map(|lost| {
                format!("what there is cannot be shown: {}: {}", lost.element, lost.what)
            });
            let message = "expected triangles or polygons, found none".to_owned();
            return Err(vec![Unreadable { place: None, message, help }]);
        }
        let mut scene = blank()?;
        scene.image = self.image(wishes);
        scene.camera = self.camera(wishes, bounds, scene.image);
        scene.shading = wishes.shading.unwrap_or(self.shading);
        if wishes.shading.is_none() {
            self.chosen.push(format!("{:?} shading, the nearest to the format's", self.shading));
        }
        if self.lights.is_empty() {
            self.chosen.push(
                "no light is in the file: a white one shines along the camera's view, with \
                 a tenth of it from everywhere"
                    .to_owned(),
            );
            let full = match scene.shading {
                Shading::Classic | Shading::Attenuated => 1.0,
                Shading::Radiometric => std::f64::consts::PI,
            };
            self.lights = headlight(&scene.camera, full);
        }
        scene.lights = std::mem::take(&mut self.lights);
        self.strip();
        let mut names = Names::of(source);
        let mut files = self.pictures.into_map();
        for (part, material) in self.parts {
            let file = names.file(material.as_deref());
            let Some(text) = part.obj() else {
                return Err(vec![too_large(&format!("the mesh \"{file}\" would be larger"))]);
            };
            files.insert(file.clone(), text);
            let material = material.map(Material::Named);
            scene.objects.push(Object::Mesh { file, flat: false, material });
        }
        scene.materials = self.materials;
        Ok(Imported { scene, files, lost: self.lost.into_lost(), chosen: self.chosen })
    }

    /// Takes textures off what has no coordinates for them.
    fn strip(&mut self) {
        for (part, name) in &mut self.parts {
            let has_uvs = part.uv_faces.len() == part.faces.len();
            let Some(textured) = name.as_ref().filter(|_| !has_uvs) else { continue };
            let Some(bare) = self.materials.get(textured).and_then(bare) else { continue };
            let what = "faces without texture coordinates are shown without its texture";
            self.lost.add(None, format!("material \"{textured}\""), what);
            let mut plain = format!("{textured} without texture");
            while self.materials.get(&plain).is_some_and(|other| *other != bare) {
                plain.push('+');
            }
            self.materials.insert(plain.clone(), bare);
            *name = Some(plain);
        }
        // Nobody has those any more whose faces are all without.
        let is_used = |name: &String| self.parts.iter().any(|(_, of)| of.as_ref() == Some(name));
        self.materials.retain(|name, material| material.texture().is_none() || is_used(name));
    }

    fn image(&mut self, wishes: &Wishes) -> (u32, u32) {
        if let Some(size) = wishes.image {
            return size;
        }
        let aspect = self.shot.as_ref().filter(|_| wishes.camera.is_none()).and_then(Shot::aspect);
        let shorter = |share: f64| ((f64::from(SIDE) * share).round() as u32).max(1);
        let size = match aspect {
            Some(aspect) if aspect >= 1.0 => (SIDE, shorter(1.0 / aspect)),
            Some(aspect) => (shorter(aspect), SIDE),
            None => (SIDE, SIDE),
        };
        let whose = if aspect.is_some() { ", by the camera's aspect" } else { "" };
        self.chosen.push(format!("the picture has {} x {} pixels{whose}", size.0, size.1));
        size
    }

    fn camera(&mut self, wishes: &Wishes, bounds: Aabb, image: (u32, u32)) -> Camera {
        let aspect = f64::from(image.0.max(1)) / f64::from(image.1.max(1));
        if let Some(camera) = wishes.camera {
            return camera;
        }
        if let Some(shot) = &self.shot {
            return shot.camera(aspect);
        }
        self.chosen.push(
            "no camera is in the file: it looks from the diagonal between +x, +y and +z at the \
             middle of what there is, with all of it in view"
                .to_owned(),
        );
        framed(bounds, aspect)
    }
}

/// Too much to be kept.
pub(in crate::import) fn too_large(what: &str) -> Unreadable {
    Unreadable {
        place: None,
        message: format!("expected a mesh of at most {} bytes, {what}", scene::MAX_ASSET_BYTES),
        help: Some("import it in parts, or thin it out before".to_owned()),
    }
}

/// A scene with everything at its default.
fn blank() -> Result<SceneFile<Unchecked>, Vec<Unreadable>> {
    const BLANK: &str =
        "(version: 1, image: (1, 1), camera: LookAt(eye: (0, 0, 1), at: (0, 0, 0), fov_deg: 40))";
    // It is one, which every test of an importer shows.
    let message = "expected an empty scene to be one".to_owned();
    scene::parse(BLANK).ok_or_else(|| vec![Unreadable { place: None, message, help: None }])
}

/// From the diagonal, so near that the ball around the bounds just fits.
fn framed(bounds: Aabb, aspect: f64) -> Camera {
    const FOV_DEG: f64 = 40.0;
    let center = 0.5 * bounds.min + 0.5 * bounds.max;
    let radius = (0.5 * bounds.max - 0.5 * bounds.min).length();
    let narrower = libm::tan(FOV_DEG.to_radians() / 2.0) * aspect.min(1.0);
    let sine = narrower / (1.0 + narrower * narrower).sqrt();
    // Meshes without any extent are refused later, by their areas.
    let distance = if radius > 0.0 { radius / sine } else { 1.0 };
    let eye = center + DVec3::splat(distance / 3.0_f64.sqrt());
    Camera::LookAt {
        eye: eye.to_array(),
        at: center.to_array(),
        up: DVec3::Y.to_array(),
        fov_deg: FOV_DEG,
    }
}

/// Light along the view, so that nothing that is seen is dark.
fn headlight(camera: &Camera, full: f64) -> Vec<Light> {
    /// Of the light, what comes from everywhere. An ambient light is as bright in
    /// every convention.
    const AMBIENT: f64 = 0.1;
    let direction = match camera {
        Camera::Perspective { view_dir, .. } | Camera::Parallel { view_dir, .. } => *view_dir,
        Camera::LookAt { eye, at, .. } => (DVec3::from(*at) - DVec3::from(*eye)).to_array(),
    };
    vec![
        Light::Directional { direction, intensity: [full * (1.0 - AMBIENT); 3] },
        Light::Ambient { intensity: [AMBIENT; 3] },
    ]
}
