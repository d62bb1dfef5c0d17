//! `Object`: a shape with what it is made of.

use std::sync::Arc;

use crate::meter::Meter;
use crate::refused::refuse_unless;
use crate::shape::{Contact, Departure, Geometry, Shape, SurfacePoint};
use crate::{Hit, Interval, Material, ObjectId, Ray, Refused, Texture};

/// A shape with what it is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    shape: Shape,
    material: Material,
    /// Multiplies the material's color.
    texture: Option<Arc<Texture>>,
    id: ObjectId,
}

impl Object {
    /// An object; its number is given by the outermost group around it.
    pub fn new(shape: Shape, material: Material) -> Self {
        Self { shape, material, texture: None, id: ObjectId::default() }
    }

    /// An object whose material's color is multiplied by that of a texture.
    ///
    /// # Errors
    /// Refuses (as `texture`) shapes without texture coordinates, and the material
    /// `Normal`, which has no color.
    pub fn textured(
        shape: Shape,
        material: Material,
        texture: Arc<Texture>,
    ) -> Result<Self, Refused> {
        Refused::unless([
            refuse_unless(
                shape.has_uv(),
                "texture",
                "a sphere, a plane or a mesh with texture coordinates under it",
                || shape.words().to_owned(),
            ),
            refuse_unless(
                material != Material::Normal,
                "texture",
                "a material with a color under it",
                || "`Normal`".to_owned(),
            ),
        ])?;
        Ok(Self { texture: Some(texture), ..Self::new(shape, material) })
    }

    /// Gives it its number in the outermost group.
    pub(crate) fn set_number(&mut self, number: u32) {
        self.id = ObjectId(number);
    }

    pub(crate) fn shape(&self) -> &Shape {
        &self.shape
    }

    pub(crate) fn material(&self) -> &Material {
        &self.material
    }

    /// The `t` of the closest hit inside `range`, which is put where the best one so
    /// far is; see [`crate::Group`].
    pub(crate) fn meet(
        &self,
        ray: &Ray,
        range: Interval,
        meter: &impl Meter,
        hit: &mut Option<Hit>,
    ) -> Option<f64> {
        let contact = self.shape.meet(ray, range, self.departure(ray), meter)?;
        let surface = self.shape.surface(ray, &contact);
        let (material, texel) = match &self.texture {
            None => (self.material, 0),
            Some(texture) => self.textured_at(texture, &contact, &surface),
        };
        *hit = Some(Hit {
            t: contact.t,
            point: surface.point,
            point_error: surface.error,
            geometric_normal: surface.geometric_normal,
            shading_normal: surface.shading_normal,
            material,
            texel,
            object: self.id,
            part: contact.part,
        });
        Some(contact.t)
    }

    /// The material at a contact, and the part of the texture. Apart from its caller, as most objects have no
    /// texture.
    #[cold]
    #[inline(never)]
    fn textured_at(
        &self,
        texture: &Texture,
        contact: &Contact,
        surface: &SurfacePoint,
    ) -> (Material, u32) {
        let Some(uv) = self.shape.uv(contact, surface) else { return (self.material, 0) };
        let (color, texel) = texture.look_up(uv);
        (self.material.tinted(color), texel)
    }

    /// A part of it that is in the ray's way, or if it is the one called `only`.
    pub(crate) fn occluder(
        &self,
        ray: &Ray,
        range: Interval,
        only: Option<u32>,
        meter: &impl Meter,
    ) -> Option<u32> {
        self.shape.occluder(ray, range, self.departure(ray), only, meter)
    }

    /// From where the ray leaves this object, if it does.
    fn departure(&self, ray: &Ray) -> Option<Departure> {
        ray.leaving.filter(|(object, _)| *object == self.id).map(|(_, from)| from)
    }
}
