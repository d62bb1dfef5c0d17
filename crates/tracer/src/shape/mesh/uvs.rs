//! A mesh's texture coordinates: checked, and found between corners.

use super::{Contact, Mesh, MeshUvs, triangle};
use crate::Refused;
use crate::refused::{MAX_LENGTH, refuse_unless};

impl Mesh {
    /// The same mesh with texture coordinates.
    ///
    /// # Errors
    /// Refuses (as `uvs`) those for another number of triangles, an index out of
    /// range, and numbers that are not finite.
    pub fn with_uvs(mut self, uvs: MeshUvs) -> Result<Self, Refused> {
        let highest = uvs.faces.as_flattened().iter().copied().max();
        let count = uvs.uvs.len();
        Refused::unless([
            refuse_unless(
                uvs.faces.len() == self.triangle_count(),
                "uvs",
                format!("those of {} triangles", self.triangle_count()),
                || uvs.faces.len().to_string(),
            ),
            refuse_unless(
                highest.is_none_or(|i| (i as usize) < count),
                "uvs",
                format!("indices below {count}"),
                || highest.map_or("none".into(), |i| i.to_string()),
            ),
            uvs.uvs.iter().find_map(|uv| {
                let is_finite = uv.iter().all(|x| x.abs() <= MAX_LENGTH);
                let expected = format!("two finite numbers of at most {MAX_LENGTH:e}");
                refuse_unless(is_finite, "uvs", expected, || format!("{uv:?}"))
            }),
        ])?;
        self.uvs = Some(uvs);
        Ok(self)
    }

    /// Whether it has texture coordinates.
    pub fn has_uv(&self) -> bool {
        self.uvs.is_some()
    }

    /// Those of the corners, weighted as the point is.
    pub(super) fn interpolated_uv(&self, contact: &Contact) -> Option<[f64; 2]> {
        let MeshUvs { uvs, faces } = self.uvs.as_ref()?;
        let [a, b, c] = faces.get(contact.part as usize)?.map(|i| uvs[i as usize]);
        let [beta, gamma] = triangle::weights(contact);
        let alpha = 1.0 - beta - gamma;
        Some(std::array::from_fn(|i| alpha * a[i] + beta * b[i] + gamma * c[i]))
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, dvec3};

    use super::*;
    use crate::accel::Build;
    use crate::shape::Geometry;
    use crate::{Interval, Ray};

    /// The unit square in two triangles.
    fn square() -> Mesh {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let vertices = corners.map(|[x, y]| dvec3(x, y, 0.0)).to_vec();
        Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]], None, Build::Bvh).unwrap()
    }

    fn uvs(uvs: &[[f64; 2]], faces: &[[u32; 3]]) -> MeshUvs {
        MeshUvs { uvs: uvs.to_vec(), faces: faces.to_vec() }
    }

    const FACES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

    #[test]
    fn coordinates_are_interpolated_with_indices_of_their_own() {
        // Twice as large, and a quarter turn further.
        let pairs = [[0.0, 2.0], [0.0, 0.0], [2.0, 0.0], [2.0, 2.0]];
        let mesh = square().with_uvs(uvs(&pairs, &FACES)).unwrap();
        for (x, y) in [(0.25, 0.5), (0.75, 0.5), (0.125, 0.75), (0.5, 0.5)] {
            let ray = Ray::new(dvec3(x, y, 1.0), -DVec3::Z);
            let contact = mesh.intersect(&ray, Interval::AHEAD).unwrap();
            let surface = mesh.surface(&ray, &contact);
            assert_eq!(mesh.uv(&contact, &surface), Some([2.0 * y, 2.0 - 2.0 * x]));
        }
        assert!(mesh.has_uv() && !square().has_uv());
    }

    #[track_caller]
    fn check(pairs: &[[f64; 2]], faces: &[[u32; 3]], expected: &str) {
        let refused = square().with_uvs(uvs(pairs, faces)).unwrap_err().to_string();
        assert!(refused.starts_with(expected), "{refused}");
    }

    #[test]
    fn bad_coordinates_are_refused() {
        check(&[[0.0; 2]], &FACES[..1], "`uvs`: expected those of 2 triangles, found 1");
        check(&[[0.0; 2]; 3], &FACES, "`uvs`: expected indices below 3, found 3");
        check(&[[0.0, f64::NAN]; 4], &FACES, "`uvs`: expected two finite numbers");
        check(&[[1e61, 0.0]; 4], &FACES, "`uvs`: expected two finite numbers");
    }
}
