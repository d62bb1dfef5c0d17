//! `Placed`: an object out of its groups, with its transform and its look.

use scene::SceneFile;
use scene::format::{Material, Object, Show, Texture, Transform, Triple};
use tracer::glam::{DAffine3, DMat3, DVec3};

use super::Lamp;
use super::look::{Look, Way, numbered};
use crate::Feature;

/// An object out of its groups.
#[derive(Debug, Clone)]
pub(in crate::export) struct Placed {
    /// Its shape, never a group; its material is not to be looked at.
    pub(in crate::export) shape: Object,
    /// The steps from its own space to the world's, first to last.
    pub(in crate::export) steps: Vec<Transform>,
    /// The same as one map.
    pub(in crate::export) world_from_object: DAffine3,
    pub(in crate::export) look: Look,
    /// What multiplies the look's own color from place to place.
    pub(in crate::export) texture: Option<Texture>,
    /// How it sends rays on.
    pub(in crate::export) way: Option<Way>,
    /// Whether a sample of the picture sees it from behind its normal.
    pub(in crate::export) back_is_seen: bool,
    /// Whether one sees a highlight of a light that is behind the surface, or
    /// on its back.
    pub(in crate::export) glows_from_behind: bool,
    /// Whether an eye ray starts in it and in nothing else, and it is of glass or
    /// glazed.
    pub(in crate::export) holds_eye: bool,
    /// Of a plane: how far from its point the picture or its shadows need it.
    pub(in crate::export) reach: f64,
}

impl Placed {
    /// Whether its own space is the world's.
    pub(in crate::export) fn is_in_place(&self) -> bool {
        self.world_from_object == DAffine3::IDENTITY
    }

    /// Whether it is a box without thickness, whose two sides are in one place.
    pub(in crate::export) fn is_flat_box(&self) -> bool {
        match self.shape {
            Object::Box { min, max, .. } => min.iter().zip(max).any(|(lo, hi)| *lo == hi),
            _ => false,
        }
    }

    /// The same without its transform.
    pub(in crate::export) fn in_own_space(&self) -> Self {
        Self { world_from_object: DAffine3::IDENTITY, steps: Vec::new(), ..self.clone() }
    }

    /// Turns its look into that of a picture of this kind.
    pub(super) fn be_shown(&mut self, show: Show, exposure: f64, lamps: &[Lamp], ambient: Triple) {
        /// What a mirror shows by itself, and glass.
        const NOTHING: Look = Look::Constant([0.0; 3]);
        if show != Show::Shaded {
            self.way = None;
        }
        self.look = match self.way {
            Some(way) if !way.is_lit() => NOTHING,
            _ => self.look.clone().plain(show, exposure, lamps, ambient),
        };
        let has_colors = matches!(self.look, Look::Constant(_) | Look::Lit { .. });
        if !matches!(show, Show::Shaded | Show::SurfaceColor) || !has_colors {
            self.texture = None;
        }
    }

    /// What it asks for beside its shape.
    pub(super) fn asks(&self) -> Vec<Feature> {
        let is_round = match &self.shape {
            Object::Sphere { .. }
            | Object::Disk { .. }
            | Object::Torus { .. }
            | Object::Cylinder { .. }
            | Object::Cone { .. } => true,
            Object::Mesh { flat, .. } => !flat,
            _ => false,
        };
        let mut asks = match &self.look {
            Look::Constant(_) if self.way.is_some_and(|way| !way.is_lit()) => Vec::new(),
            Look::Constant(_) => vec![Feature::Constant],
            // A color that goes from 0 to 1 in every other language.
            Look::Normal(by) if *by != 1.0 => vec![Feature::NormalMaterial, Feature::Exposure],
            Look::Normal(_) => vec![Feature::NormalMaterial],
            Look::Depth { .. } => vec![Feature::Depth],
            Look::Lit { highlight: None, .. } => vec![Feature::Lambert],
            Look::Lit { highlight: Some(([r, g, b], _)), .. } => {
                let is_colored = r != g || g != b;
                let mut asks = vec![Feature::BlinnPhong];
                asks.extend(is_colored.then_some(Feature::ColoredHighlight));
                asks
            }
        };
        asks.extend(self.way.into_iter().flat_map(Way::asks));
        asks.extend(self.texture.as_ref().map(|texture| match texture {
            Texture::Checker { .. } => Feature::CheckerTexture,
            Texture::Image { .. } => Feature::ImageTexture,
        }));
        if is_round && !is_similarity(self.world_from_object.matrix3) {
            asks.push(Feature::StretchedRound);
        }
        if self.back_is_seen && !matches!(self.look, Look::Constant(_) | Look::Depth { .. }) {
            asks.push(Feature::BackSides);
        }
        if self.glows_from_behind {
            asks.push(Feature::HighlightFromBehind);
        }
        asks
    }
}

/// Whether a map keeps all angles: circles stay circles.
pub(in crate::export) fn is_similarity(m: DMat3) -> bool {
    /// What products of rounded numbers may be off by.
    const ROUNDING: f64 = 1e-12;
    let square = m.transpose() * m;
    let scale = square.x_axis.x;
    let off = square - DMat3::from_diagonal(DVec3::splat(scale));
    let near = |v: DVec3| v.abs().max_element() <= ROUNDING * scale;
    near(off.x_axis) && near(off.y_axis) && near(off.z_axis)
}

/// All objects of a file, in the order of their numbers.
pub(super) fn all<C>(file: &SceneFile<C>) -> Vec<Placed> {
    let mut all = Vec::new();
    below(file, &file.objects, &[], None, &mut all);
    all
}

/// A file's groups are not deeper than its text may be nested, so that this
/// goes no deeper either.
fn below<C>(
    file: &SceneFile<C>,
    objects: &[Object],
    steps: &[Transform],
    inherited: Option<&Material>,
    all: &mut Vec<Placed>,
) {
    for object in objects {
        let material = object.material().or(inherited);
        if let Object::Group { transform, objects, .. } = object {
            let steps: Vec<_> = transform.iter().chain(steps).copied().collect();
            below(file, objects, &steps, material, all);
            continue;
        }
        let material = material.and_then(|material| file.resolved(material));
        let look = match file.show {
            Show::ObjectIds => numbered(all.len()),
            _ => Look::of(material, file.shading),
        };
        all.push(Placed {
            shape: object.clone(),
            world_from_object: composed(steps),
            steps: steps.to_vec(),
            look,
            texture: material.and_then(Material::texture).cloned(),
            way: material.and_then(Way::of),
            back_is_seen: false,
            glows_from_behind: false,
            holds_eye: false,
            reach: 0.0,
        });
    }
}

/// Steps, first to last, as one map.
fn composed(steps: &[Transform]) -> DAffine3 {
    let made = |step: &Transform| match *step {
        Transform::Translate(x, y, z) => tracer::Transform::translation(DVec3::new(x, y, z)),
        Transform::RotateDeg(x, y, z) => tracer::Transform::rotation_deg(DVec3::new(x, y, z)),
        Transform::Scale(x, y, z) => tracer::Transform::scale(DVec3::new(x, y, z)),
    };
    // A step that makes no sense is a problem that was told before.
    steps
        .iter()
        .filter_map(|step| made(step).ok())
        .fold(DAffine3::IDENTITY, |all, step| step.affine() * all)
}
