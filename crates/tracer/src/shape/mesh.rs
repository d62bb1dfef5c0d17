//! `Mesh`: triangles that share corners, with normals to interpolate where
//! they have them.

use glam::DVec3;

use super::triangle::{self, Shear};
use super::{Contact, Departure, Geometry, SurfacePoint};
use crate::accel::{Accelerator, Build, Coherence};
use crate::meter::{Event, Meter, Unmetered};
use crate::refused::{point, refuse_unless};
use crate::{Aabb, Interval, Ray, Refused, UnitVec};

/// Normals at the corners of a mesh's triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshNormals {
    /// The normals; any length, and zero for "none here".
    pub normals: Vec<DVec3>,
    /// For each triangle, the index of the normal at each of its corners.
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
    vertices: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
    normals: Option<MeshNormals>,
    bounds: Aabb,
    accelerator: Accelerator,
}

impl Mesh {
    /// A mesh from its corners and, for each triangle, the indices of its
    /// three.
    ///
    /// # Errors
    /// Refuses a mesh without a triangle that has an area, corners or normals that are not
    /// finite, an index out of range, and normals for another number of
    /// triangles.
    pub fn new(
        vertices: Vec<DVec3>,
        mut faces: Vec<[u32; 3]>,
        normals: Option<MeshNormals>,
        build: Build,
    ) -> Result<Self, Refused> {
        let indices_fit = |faces: &[[u32; 3]], count: usize| {
            faces.iter().flatten().all(|&i| (i as usize) < count)
        };
        let normals_fit = normals.as_ref().is_none_or(|n| {
            n.faces.len() == faces.len()
                && indices_fit(&n.faces, n.normals.len())
                && n.normals.iter().all(|n| n.is_finite())
        });
        Refused::unless([
            vertices.iter().find_map(|&v| point("vertices", v)),
            refuse_unless(!faces.is_empty(), "faces", "at least one triangle", || "none".into()),
            refuse_unless(
                u32::try_from(faces.len()).is_ok(),
                "faces",
                "at most 4294967295 triangles",
                || faces.len().to_string(),
            ),
            refuse_unless(
                indices_fit(&faces, vertices.len()),
                "faces",
                format!("corner indices below {}", vertices.len()),
                || faces.iter().flatten().max().map_or("none".into(), u32::to_string),
            ),
            refuse_unless(
                normals_fit,
                "normals",
                "three indices of finite normals for each triangle",
                || "other ones".into(),
            ),
        ])?;
        let corners = |face: &[u32; 3]| face.map(|i| vertices[i as usize]);
        Refused::unless([refuse_unless(
            faces.iter().any(|f| triangle::normal(corners(f)).is_some()),
            "faces",
            "at least one triangle with an area",
            || format!("{} without", faces.len()),
        )])?;
        // Drawn into one of its corners, a triangle without an area cannot be
        // opened by the rounding of a ray's shear.
        for face in &mut faces {
            if triangle::normal(corners(face)).is_none() {
                *face = [face[0]; 3];
            }
        }
        let boxes: Vec<_> = faces.iter().map(|f| triangle::bounds(corners(f))).collect();
        let bounds = boxes.iter().fold(Aabb::EMPTY, |all, &b| all.union(b));
        let accelerator = Accelerator::build(build, &boxes, 1.0);
        Ok(Self { vertices, faces, normals, bounds, accelerator })
    }

    /// How many triangles it has.
    pub fn triangle_count(&self) -> usize {
        self.faces.len()
    }

    /// How many of its triangles the ray crosses inside `range`, near and far:
    /// odd for a ray from inside a closed mesh, even from outside.
    pub fn crossings(&self, ray: &Ray, range: Interval) -> u32 {
        let shear = Shear::new(ray);
        let mut count = 0;
        self.accelerator.any(ray, range, &Unmetered, |i| {
            count += u32::from(shear.intersect(self.corners(i), range).is_some());
            false
        });
        count
    }

    /// What [`Geometry::intersect`] says of each of these rays, put in its place
    /// in `contacts`, which is as long.
    pub fn intersect_batch(
        &self,
        rays: &[Ray],
        range: Interval,
        _: Coherence,
        contacts: &mut [Option<Contact>],
    ) {
        for (ray, contact) in rays.iter().zip(contacts) {
            *contact = self.intersect(ray, range);
        }
    }

    /// What [`Geometry::occludes`] says of each of these rays, put in its place
    /// in `occluded`, which is as long.
    pub fn occludes_batch(
        &self,
        rays: &[Ray],
        range: Interval,
        _: Coherence,
        occluded: &mut [bool],
    ) {
        for (ray, occluded) in rays.iter().zip(occluded) {
            *occluded = self.occludes(ray, range);
        }
    }

    /// The first contact of a ray, which may leave one of the triangles.
    pub(super) fn closest(
        &self,
        ray: &Ray,
        range: Interval,
        from: Option<Departure>,
        meter: &impl Meter,
    ) -> Option<Contact> {
        let shear = Shear::new(ray);
        let test = |i, range| {
            meter.count(Event::Triangle);
            let contact = shear.intersect(self.corners(i), range);
            contact.filter(|_| self.may_meet(ray.direction, from, i))
        };
        let (part, contact) = self.accelerator.closest(ray, range, meter, test)?;
        Some(Contact { part, ..contact })
    }

    /// A triangle that the ray meets: any, or if it does the one called `only`.
    pub(super) fn occluder(
        &self,
        ray: &Ray,
        range: Interval,
        from: Option<Departure>,
        only: Option<u32>,
        meter: &impl Meter,
    ) -> Option<u32> {
        let shear = Shear::new(ray);
        let is_met = |i| {
            meter.count(Event::Triangle);
            let contact = shear.intersect(self.corners(i), range);
            contact.is_some() && self.may_meet(ray.direction, from, i)
        };
        if let Some(only) = only {
            return (only < self.faces.len() as u32 && is_met(only)).then_some(only);
        }
        let mut found = None;
        self.accelerator.any(ray, range, meter, |i| {
            found = is_met(i).then_some(i);
            found.is_some()
        });
        found
    }

    /// A few boxes that hold all triangles between them.
    pub(super) fn coarse_boxes(&self) -> Vec<Aabb> {
        self.accelerator.coarse_boxes(self.bounds)
    }

    /// Whether a ray along `direction` that leaves `from` may meet triangle
    /// `other`. It never does the one it leaves, nor one that all of it lies in
    /// front of while the ray goes forward, or behind while it goes back: so in
    /// an edge or corner, where the ray starts on several, it meets none that
    /// its start's rounding alone puts in its way.
    fn may_meet(&self, direction: DVec3, from: Option<Departure>, other: u32) -> bool {
        // A part that this mesh has not got is another's.
        let left = from.filter(|from| (from.part as usize) < self.faces.len());
        left.is_none_or(|Departure { part, .. }| {
            let (other_one, start) = (self.corners(other), self.corners(part));
            other != part && !triangle::is_turned_from(other_one, start, direction)
        })
    }

    fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.faces[triangle as usize].map(|i| self.vertices[i as usize])
    }

    /// The normals of the corners, weighted as the point is; `None` where the
    /// mesh has none or they cancel out.
    fn interpolated_normal(&self, contact: &Contact) -> Option<UnitVec> {
        let MeshNormals { normals, faces } = self.normals.as_ref()?;
        let corner = faces[contact.part as usize].map(|i| UnitVec::new(normals[i as usize]));
        let [a, b, c] = [*corner[0]?, *corner[1]?, *corner[2]?];
        let [beta, gamma] = contact.barycentric;
        UnitVec::new((1.0 - beta - gamma) * a + beta * b + gamma * c)
    }
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
        let corners = self.corners(contact.part);
        // A triangle that was hit has an area, and so a normal; the axis is for
        // the compiler.
        let normal = triangle::normal(corners).unwrap_or(UnitVec::Z);
        SurfacePoint {
            shading_normal: self.interpolated_normal(contact).unwrap_or(normal),
            ..triangle::surface(corners, normal, contact)
        }
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
