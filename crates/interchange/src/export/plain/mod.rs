//! `Plain`: a scene made ready to be written in another language.
//!
//! Everything that other languages have no word for and that can be said
//! otherwise without any loss is said otherwise here, once:
//! - groups are opened: each object has its own transform;
//! - materials are looked up, inherited and filled in with their defaults;
//! - silhouettes, surface colors and numbers of objects are colors without light;
//! - the exposure is in the lights, the unlit colors and the background;
//! - black lights and black highlights are left out, ambient lights are one;
//!   what no other light reaches is a color without light.

mod look;
mod place;
mod seen;
mod solid;
mod within;

pub(super) use look::{Look, Way};
pub(super) use place::Placed;
pub(super) use solid::{Solid, Triangles, half_of_plane};

use std::collections::{BTreeMap, BTreeSet};

use scene::format::{Falloff, Light, Sampler, Shading, Show, Texture, Triple};
use scene::{Assets, MeshData, SceneFile};
use tracer::Camera;
use tracer::accel::Build;

use super::text::{scaled, vector};
use crate::Feature;

/// A light that has a place or a direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lamp {
    Point { position: Triple, intensity: Triple, falloff: Falloff },
    Directional { direction: Triple, intensity: Triple },
}

/// A texture's file.
#[derive(Debug)]
pub(super) struct Picture {
    /// PNG of three channels that says nothing of its own colors: programs read gray,
    /// palettes and gamma in ways of their own.
    pub(super) png: Vec<u8>,
    /// Its width and height.
    pub(super) size: [u32; 2],
}

/// A scene as writers need it.
#[derive(Debug)]
pub(super) struct Plain {
    pub(super) size: (u32, u32),
    /// Samples in each row and column of a pixel.
    pub(super) grid: u32,
    pub(super) camera: Camera,
    pub(super) objects: Vec<Placed>,
    pub(super) lamps: Vec<Lamp>,
    /// The sum of all ambient lights.
    pub(super) ambient: Triple,
    pub(super) background: Triple,
    pub(super) shading: Shading,
    pub(super) shadows: bool,
    /// Whether a sample of the picture shows the gap that the convention leaves
    /// before shadows.
    pub(super) needs_gap: bool,
    /// What rays ask for that go through glass.
    pub(super) of_glass: BTreeSet<Feature>,
    /// Mesh files by name; those without normals, or shaded flat, keep them all the same.
    pub(super) meshes: BTreeMap<String, MeshData>,
    /// Texture files by name.
    pub(super) textures: BTreeMap<String, Picture>,
    /// How many times a ray is sent on.
    pub(super) bounces: u32,
    /// What it asks of a renderer, as it is here.
    pub(super) asks: BTreeSet<Feature>,
}

impl Plain {
    /// # Errors
    /// The problems of a scene that makes no sense, or of a mesh.
    pub(super) fn new<C>(file: &SceneFile<C>, assets: &dyn Assets) -> Result<Self, String> {
        let scene = scene::recompile(file, assets, Build::Bvh).map_err(|all| all.join("; "))?;
        let exposure = scene.exposure();
        let (lamps, ambient) = lights(file, exposure);
        let mut objects = place::all(file);
        for object in &mut objects {
            object.be_shown(file.show, exposure, &lamps, ambient);
        }
        let (mut meshes, mut textures) = (BTreeMap::new(), BTreeMap::new());
        for object in &objects {
            if let scene::format::Object::Mesh { file, .. } = &object.shape {
                let mesh = assets.read(file).and_then(|bytes| scene::read_mesh(file, &bytes));
                meshes.insert(file.clone(), mesh.map_err(|why| format!("mesh \"{file}\" {why}"))?);
            }
            if let Some(Texture::Image { file, .. }) = &object.texture {
                let picture = assets.read(file).and_then(|bytes| scene::as_rgb(&bytes));
                let (png, size) = picture.map_err(|why| format!("texture \"{file}\" {why}"))?;
                textures.insert(file.clone(), Picture { png, size });
            }
        }
        let background = scaled(file.background, exposure);
        let mut plain = Self {
            size: file.image,
            grid: grid(file),
            camera: *scene.camera(),
            objects,
            lamps,
            ambient,
            background,
            shading: file.shading,
            shadows: file.shadows,
            needs_gap: false,
            of_glass: BTreeSet::new(),
            meshes,
            textures,
            bounces: file.bounces,
            asks: BTreeSet::new(),
        };
        seen::note(&mut plain, &scene);
        plain.asks = plain.asks(file);
        Ok(plain)
    }

    /// Whether more than one light with a place or a direction shines on something. It is
    /// not among what is asked, as most languages have words for any number.
    pub(super) fn has_several_lights(&self) -> bool {
        self.lamps.len() > 1 && self.objects.iter().any(|object| object.look.is_lit())
    }

    /// What is asked for beyond `can`.
    ///
    /// # Errors
    /// That, if there is any.
    pub(super) fn asks_only(&self, can: &[Feature]) -> Result<(), BTreeSet<Feature>> {
        let cannot: BTreeSet<_> =
            self.asks.iter().copied().filter(|feature| !can.contains(feature)).collect();
        if cannot.is_empty() { Ok(()) } else { Err(cannot) }
    }

    /// The features of the file, with those of materials, textures, lights and
    /// pictures as they are after all that was said otherwise.
    fn asks<C>(&self, file: &SceneFile<C>) -> BTreeSet<Feature> {
        let kept = |feature: &Feature| {
            matches!(feature.family(), "cameras" | "shapes" | "samples")
                && *feature != Feature::Group
        };
        let mut asks: BTreeSet<_> =
            crate::feature::features(file).into_iter().filter(kept).collect();
        for object in &self.objects {
            asks.extend(object.asks());
        }
        asks.extend(&self.of_glass);
        if self.background != [0.0; 3] {
            asks.insert(Feature::Background);
        }
        if !self.objects.iter().any(|object| object.look.is_lit()) {
            return asks;
        }
        asks.insert(match self.shading {
            Shading::Classic => Feature::Classic,
            Shading::Attenuated => Feature::Attenuated,
            Shading::Radiometric => Feature::Radiometric,
        });
        asks.extend(self.lamps.iter().map(|lamp| match lamp {
            Lamp::Point { falloff: Falloff::Constant, .. } => Feature::ConstantPointLight,
            Lamp::Point { falloff: Falloff::InverseSquare, .. } => Feature::InverseSquarePointLight,
            Lamp::Directional { .. } => Feature::DirectionalLight,
        }));
        if self.ambient != [0.0; 3] {
            asks.insert(Feature::AmbientLight);
        }
        if self.needs_gap {
            asks.insert(Feature::ShadowGap);
        }
        asks.insert(if self.shadows { Feature::Shadows } else { Feature::NoShadows });
        asks
    }
}

/// Lights that shine, and the sum of those from everywhere; none where the
/// picture shows no light.
fn lights<C>(file: &SceneFile<C>, exposure: f64) -> (Vec<Lamp>, Triple) {
    let default = match file.shading {
        Shading::Classic => Falloff::Constant,
        Shading::Attenuated | Shading::Radiometric => Falloff::InverseSquare,
    };
    let (mut lamps, mut ambient) = (Vec::new(), [0.0; 3]);
    let lights = file.lights.iter().filter(|_| file.show == Show::Shaded);
    for light in lights {
        let (Light::Point { intensity, .. }
        | Light::Directional { intensity, .. }
        | Light::Ambient { intensity }) = light;
        let intensity = scaled(*intensity, exposure);
        if intensity == [0.0; 3] {
            continue;
        }
        match *light {
            Light::Point { position, falloff, .. } => {
                let falloff = falloff.unwrap_or(default);
                lamps.push(Lamp::Point { position, intensity, falloff });
            }
            Light::Directional { direction, .. } => {
                lamps.push(Lamp::Directional { direction, intensity });
            }
            Light::Ambient { .. } => ambient = (vector(ambient) + vector(intensity)).to_array(),
        }
    }
    (lamps, ambient)
}

/// The side of the square of samples in a pixel; 1 where they are no square.
fn grid<C>(file: &SceneFile<C>) -> u32 {
    if file.sampler == Sampler::Grid { file.samples_per_pixel.isqrt().max(1) } else { 1 }
}
