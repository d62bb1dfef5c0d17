//! `Part`: triangles of one material, written as an OBJ file.
//!
//! Numbers are written so that reading them gives the same bits.

use std::io::Write as _;

use tracer::glam::DVec3;

/// The most corners and triangles that an import may have together; a file of
/// [`scene::MAX_ASSET_BYTES`] has no more room.
pub(in crate::import) const MOST_ELEMENTS: usize = 1 << 24;

/// The largest coordinate, the tracer's own limit.
pub(in crate::import) const LARGEST: f64 = 1e60;

/// Whether a point may be one of a mesh.
pub(in crate::import) fn is_point(p: DVec3) -> bool {
    p.abs().max_element() <= LARGEST && !p.is_nan()
}

/// Triangles with what is known of their corners. Where the normals' triples
/// are not as many as the triangles there are none, and so with coordinates of
/// textures.
#[derive(Debug, Clone, Default, PartialEq)]
pub(in crate::import) struct Part {
    /// Corners.
    pub(in crate::import) vertices: Vec<DVec3>,
    /// Triangles by their corners.
    pub(in crate::import) faces: Vec<[u32; 3]>,
    /// Normals.
    pub(in crate::import) normals: Vec<DVec3>,
    /// For each triangle its corners' normals.
    pub(in crate::import) normal_faces: Vec<[u32; 3]>,
    /// Coordinates of textures, from the lower left.
    pub(in crate::import) uvs: Vec<[f64; 2]>,
    /// For each triangle its corners' coordinates.
    pub(in crate::import) uv_faces: Vec<[u32; 3]>,
}

impl Part {
    /// Its text as an OBJ file; `None` where that is larger than a mesh may be.
    pub(in crate::import) fn obj(&self) -> Option<Vec<u8>> {
        let has_normals = self.normal_faces.len() == self.faces.len();
        let has_uvs = self.uv_faces.len() == self.faces.len();
        let mut text = Vec::new();
        for v in &self.vertices {
            put(&mut text, "v", &v.to_array());
        }
        for uv in self.uvs.iter().filter(|_| has_uvs) {
            put(&mut text, "vt", uv);
        }
        for n in self.normals.iter().filter(|_| has_normals) {
            put(&mut text, "vn", &n.to_array());
        }
        for (i, face) in self.faces.iter().enumerate() {
            text.push(b'f');
            for k in 0..3 {
                // Counted from 1. Writing into memory cannot fail.
                let number = |list: &[[u32; 3]]| u64::from(list[i][k]) + 1;
                let v = u64::from(face[k]) + 1;
                let _ = match (has_uvs, has_normals) {
                    (false, false) => write!(text, " {v}"),
                    (true, false) => write!(text, " {v}/{}", number(&self.uv_faces)),
                    (false, true) => write!(text, " {v}//{}", number(&self.normal_faces)),
                    (true, true) => {
                        let (t, n) = (number(&self.uv_faces), number(&self.normal_faces));
                        write!(text, " {v}/{t}/{n}")
                    }
                };
            }
            text.push(b'\n');
            if text.len() as u64 > scene::MAX_ASSET_BYTES {
                return None;
            }
        }
        Some(text)
    }
}

fn put(text: &mut Vec<u8>, keyword: &str, numbers: &[f64]) {
    /// Numbers of this size are as short without a power of ten.
    const PLAIN: std::ops::Range<f64> = 1e-5..1e16;
    text.extend(keyword.as_bytes());
    for x in numbers {
        let is_plain = *x == 0.0 || PLAIN.contains(&x.abs());
        let _ = if is_plain { write!(text, " {x}") } else { write!(text, " {x:e}") };
    }
    text.push(b'\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_has_every_digit() {
        let third = 1.0 / 3.0;
        let mut part = Part {
            vertices: vec![DVec3::new(1.0, -2.5, third), DVec3::new(1e-300, 5e17, 0.0), DVec3::Y],
            faces: vec![[0, 1, 2]],
            ..Part::default()
        };
        let text = String::from_utf8(part.obj().unwrap()).unwrap();
        assert_eq!(text, "v 1 -2.5 0.3333333333333333\nv 1e-300 5e17 0\nv 0 1 0\nf 1 2 3\n");
        part.normals = vec![DVec3::Z];
        part.normal_faces = vec![[0; 3]];
        let text = String::from_utf8(part.obj().unwrap()).unwrap();
        assert!(text.ends_with("vn 0 0 1\nf 1//1 2//1 3//1\n"), "{text}");
        part.uvs = vec![[0.0, 0.5]];
        part.uv_faces = vec![[0; 3]];
        let text = String::from_utf8(part.obj().unwrap()).unwrap();
        assert!(text.ends_with("vt 0 0.5\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"), "{text}");
    }

    #[test]
    fn points_are_numbers_that_a_mesh_takes() {
        assert!(is_point(DVec3::new(1e60, -1e60, 0.0)));
        for bad in [f64::NAN, f64::INFINITY, 1.1e60] {
            assert!(!is_point(DVec3::new(0.0, bad, 0.0)), "{bad}");
        }
    }
}
