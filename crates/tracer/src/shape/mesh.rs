//! `Mesh`: triangles that share corners, with normals to interpolate where
//! they have them.

mod batch;
mod blocks;
mod make;
mod packet;
mod precision;
mod sight;
mod trace;
mod uvs;
mod visit;
mod winners;

use glam::DVec3;

use super::triangle::{self, Shear};
use super::{Contact, Departure, Geometry, SurfacePoint};
use crate::accel::List;
use crate::accel::wide::Wide;
use crate::fault::{Fault, seeded};
use crate::meter::{Event, Meter, Unmetered};
use crate::simd::Level;
use crate::{Aabb, Interval, Ray, UnitVec};
use blocks::{Blocks, NOBODY};

/// Normals at the corners of a mesh's triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshNormals {
    /// The normals; any length, and zero for "none here".
    pub normals: Vec<DVec3>,
    /// For each triangle, the index of the normal at each of its corners.
    pub faces: Vec<[u32; 3]>,
}

/// Texture coordinates at the corners of a mesh's triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshUvs {
    /// The pairs `(u, v)`.
    pub uvs: Vec<[f64; 2]>,
    /// For each triangle, the index of the pair at each of its corners.
    pub faces: Vec<[u32; 3]>,
}

/// A mesh of triangles. One without an area is kept among others, so that
/// numbers stay the file's, and is never hit.
///
/// A ray through an edge or a corner that triangles share hits exactly one of
/// those that cover it together: of a closed mesh every ray from inside hits
/// one, and a line crosses its surface an even number of times. At the rim of
/// an open mesh, and where a closed one turns away from the ray, a ray exactly
/// through the edge hits or misses as one right beside it does.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// The triangles that have an area.
    blocks: Blocks,
    /// For each triangle where it is among the blocks: four times its block, plus
    /// its lane; [`NOBODY`] for one without an area.
    places: Vec<u32>,
    normals: Option<MeshNormals>,
    uvs: Option<MeshUvs>,
    bounds: Aabb,
    /// The middle of the bounds, and how far they go from there along an axis at
    /// most.
    middle: DVec3,
    half: f64,
    order: Order,
    /// Whether triangles are met in `f32`, for good.
    is_fast: bool,
    /// With which instructions.
    level: Level,
}

/// In which order a ray meets a mesh's triangles.
#[derive(Debug, Clone, PartialEq)]
enum Order {
    /// In that of their numbers: the reference.
    List(List),
    /// Block by block, as there are few.
    Blocks,
    /// By the boxes of a hierarchy.
    Wide(Wide),
}

impl Mesh {
    /// The same mesh, met with these instructions.
    #[cfg(test)]
    fn at(mut self, level: crate::simd::Level) -> Self {
        self.level = level;
        self
    }

    /// How many triangles it has.
    pub fn triangle_count(&self) -> usize {
        self.places.len()
    }

    /// How many bytes it takes, normals and texture coordinates not counted: its triangles, and what
    /// finds them.
    pub fn bytes(&self) -> usize {
        let order = if let Order::Wide(wide) = &self.order { wide.bytes() } else { 0 };
        self.blocks.bytes() + size_of_val(self.places.as_slice()) + order
    }

    /// A few boxes that hold all triangles between them.
    pub(super) fn coarse_boxes(&self) -> Vec<Aabb> {
        match &self.order {
            Order::Wide(wide) => wide.coarse_boxes(),
            _ => vec![self.bounds],
        }
    }

    /// Whether a ray along `direction` that leaves `from` may meet triangle
    /// `other`. It never does the one it leaves, nor one that all of it lies in
    /// front of while the ray goes forward, or behind while it goes back: so in
    /// an edge or corner, where the ray starts on several, it meets none that
    /// its start's rounding alone puts in its way.
    fn may_meet(&self, direction: DVec3, from: Departure, other: u32, corners: [DVec3; 3]) -> bool {
        // A part that this mesh has not got is another's.
        let Some(start) = self.corners(from.part) else { return true };
        other != from.part && !triangle::is_turned_from(corners, start, direction)
    }

    /// The corners of a triangle; `None` if it has no area, or is none of this
    /// mesh.
    fn corners(&self, triangle: u32) -> Option<[DVec3; 3]> {
        let place = *self.places.get(triangle as usize)?;
        (place != NOBODY).then(|| self.blocks.triangle(place))
    }

    /// The normals of the corners, weighted as the point is; `None` where the
    /// mesh has none or they cancel out.
    fn interpolated_normal(&self, contact: &Contact) -> Option<UnitVec> {
        let MeshNormals { normals, faces } = self.normals.as_ref()?;
        if seeded(Fault::NormalsNotInterpolated) {
            return None;
        }
        let mut face = faces[contact.part as usize];
        if seeded(Fault::NormalsOfTheNextCorner) {
            face.rotate_left(1);
        }
        let corner = face.map(|i| UnitVec::new(normals[i as usize]));
        let [a, b, c] = [*corner[0]?, *corner[1]?, *corner[2]?];
        let [beta, gamma] = triangle::weights(contact);
        UnitVec::new((1.0 - beta - gamma) * a + beta * b + gamma * c)
    }
}

/// The contact of a ray with a triangle, by itself: for the few that need it,
/// whatever instructions the others are met with.
#[cold]
#[inline(never)]
fn decided(ray: &Ray, corners: [DVec3; 3], range: Interval) -> Option<Contact> {
    Shear::new(ray).decide(corners, range)
}

impl Geometry for Mesh {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Contact> {
        self.closest(ray, range, None, &Unmetered)
    }

    /// The triangle that the ray leaves is left for good, and so are those that
    /// meet it in a crease.
    fn intersect_leaving(&self, ray: &Ray, range: Interval, from: Departure) -> Option<Contact> {
        self.closest(ray, range, Some(from), &Unmetered)
    }

    fn surface(&self, _: &Ray, contact: &Contact) -> SurfacePoint {
        // A triangle that was hit has an area, and so a normal; the others are
        // for the compiler.
        let corners = self.corners(contact.part).unwrap_or_default();
        let normal = triangle::normal(corners).unwrap_or(UnitVec::Z);
        SurfacePoint {
            shading_normal: self.interpolated_normal(contact).unwrap_or(normal),
            ..triangle::surface(corners, normal, contact)
        }
    }

    fn uv(&self, contact: &Contact, _: &SurfacePoint) -> Option<[f64; 2]> {
        self.interpolated_uv(contact)
    }

    fn occludes(&self, ray: &Ray, range: Interval) -> bool {
        self.occluder(ray, range, None, None, &Unmetered).is_some()
    }

    fn occludes_leaving(&self, ray: &Ray, range: Interval, from: Departure) -> bool {
        self.occluder(ray, range, Some(from), None, &Unmetered).is_some()
    }
}

#[cfg(test)]
mod tests;
