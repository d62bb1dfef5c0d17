//! A scene of goldray's in the languages of other renderers.
//!
//! What they all can show alike is exported: spheres, boxes, disks, triangles,
//! cylinders and meshes, Lambertian or shining, under point lights in
//! radiometric shading, on black, through a straight perspective camera.
//! Anything else is refused.
//!
//! These are not `interchange`'s writers, which say every scene exactly: they ask
//! Mitsuba for plugins of ours where there are two lights, and write each box as
//! a mesh of its own. Here each renderer is to be as fast as it is.

mod mitsuba;
mod povray;

pub(crate) use mitsuba::{SCENE as MITSUBA_SCENE, mitsuba};
pub(crate) use povray::povray;

use std::collections::BTreeMap;

use scene::SceneFile;
use scene::format::{Falloff, Light, Material, Object, Shading, Show};
use tracer::Camera;
use tracer::glam::DVec3;

use super::scenes::{Read, Triangles};

/// Three numbers, as files have them.
type Triple = [f64; 3];

/// What a surface does with light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Surface {
    /// Scatters this share of it.
    Lambert(Triple),
    /// Shows this color, lit or not.
    Shining(Triple),
}

/// A straight perspective camera; the axes have length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct View {
    pub(crate) eye: DVec3,
    pub(crate) forward: DVec3,
    pub(crate) right: DVec3,
    pub(crate) up: DVec3,
    /// The window's sizes at distance 1 from the eye.
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// What is exported.
#[derive(Debug)]
pub(crate) struct Model<'a> {
    pub(crate) size: (u32, u32),
    pub(crate) view: View,
    pub(crate) objects: Vec<(&'a Object, Surface)>,
    pub(crate) lights: Vec<(Triple, Triple)>,
    pub(crate) meshes: &'a BTreeMap<String, Triangles>,
}

impl<'a> Model<'a> {
    /// What of a scene is exported.
    ///
    /// # Errors
    /// Names what of it cannot be.
    pub(crate) fn new(
        Read { file, accurate, .. }: &'a Read,
        meshes: &'a BTreeMap<String, Triangles>,
    ) -> Result<Self, String> {
        let plain = file.shading == Shading::Radiometric
            && file.shadows
            && file.background == [0.0; 3]
            && file.exposure == 1.0
            && file.show == Show::Shaded;
        if !plain {
            return Err("expected a shaded scene in `Radiometric` shading with shadows, a black \
                        background and an exposure of 1"
                .into());
        }
        let objects = file
            .objects
            .iter()
            .map(|object| Ok((object, surface(file, object)?)))
            .collect::<Result<_, String>>()?;
        let lights = file.lights.iter().map(light).collect::<Result<_, String>>()?;
        let view = View::new(accurate.camera(), file.image)?;
        Ok(Self { size: file.image, view, objects, lights, meshes })
    }
}

/// The camera, and the one object of a scene that has no more.
///
/// # Errors
/// Says how many there are, or what [`Model::new`] would.
pub(crate) fn only_object(read: &Read) -> Result<(View, &Object, Surface), String> {
    match &read.file.objects[..] {
        [object] => {
            let view = View::new(read.accurate.camera(), read.file.image)?;
            Ok((view, object, surface(&read.file, object)?))
        }
        objects => Err(format!("expected one object, found {}", objects.len())),
    }
}

fn light(light: &Light) -> Result<(Triple, Triple), String> {
    match light {
        Light::Point { position, intensity, falloff: None | Some(Falloff::InverseSquare) } => {
            Ok((*position, *intensity))
        }
        other => Err(format!(
            "expected point lights that weaken with the square of the distance, found {other:?}"
        )),
    }
}

fn surface(file: &SceneFile, object: &Object) -> Result<Surface, String> {
    if let Object::Group { .. }
    | Object::Plane { .. }
    | Object::Torus { .. }
    | Object::Cone { .. } = object
    {
        return Err(format!(
            "expected spheres, boxes, disks, triangles, cylinders and meshes, found {object:?}"
        ));
    }
    let named = match object.material() {
        Some(Material::Named(name)) => file.materials.get(name),
        material => material,
    };
    match named {
        Some(Material::Lambert { diffuse: Some(diffuse), texture: None }) => {
            Ok(Surface::Lambert(*diffuse))
        }
        Some(Material::Constant { color, texture: None }) => Ok(Surface::Shining(*color)),
        other => Err(format!(
            "expected `Lambert` with a `diffuse` or `Constant`, without a texture, found {other:?}"
        )),
    }
}

impl View {
    fn new(camera: &Camera, (width, height): (u32, u32)) -> Result<Self, String> {
        /// What axes and pixels may be off by for rounding.
        const ROUNDING: f64 = 1e-9;
        let [middle, right, up] =
            [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(a, b)| camera.ray(a, b));
        let forward = middle.direction;
        let (right, up) = (right.direction - forward, up.direction - forward);
        let distance = forward.length();
        let view = Self {
            eye: middle.origin,
            forward: forward / distance,
            right,
            up,
            width: camera.view_width() / distance,
            height: camera.view_height() / distance,
        };
        let (across, down) = (view.width / f64::from(width), view.height / f64::from(height));
        // The axes of a parallel camera have no length here, as its rays do not
        // spread; those of an oblique one are not square to its direction.
        let is_straight = (right.length() - 1.0).abs() < ROUNDING
            && view.forward.dot(right).abs() < ROUNDING
            && view.forward.dot(up).abs() < ROUNDING;
        if is_straight && (across - down).abs() < ROUNDING {
            Ok(view)
        } else {
            Err("expected a straight perspective camera with square pixels".into())
        }
    }
}

#[cfg(test)]
mod tests;
