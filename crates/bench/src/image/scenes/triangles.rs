//! `Triangles`: a mesh as all renderers are given it, in numbers of `f32`.

/// Corners, the indices of three for each triangle, and a normal for each
/// corner, or none at all.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Triangles {
    pub(crate) vertices: Vec<[f32; 3]>,
    pub(crate) normals: Vec<[f32; 3]>,
    pub(crate) faces: Vec<[u32; 3]>,
}

impl Triangles {
    /// As a binary PLY file.
    pub(crate) fn ply(&self) -> Vec<u8> {
        let names: &[&str] = match self.normals.len() {
            0 => &["x", "y", "z"],
            _ => &["x", "y", "z", "nx", "ny", "nz"],
        };
        let numbers: Vec<_> = names
            .iter()
            .map(|name| {
                format!(
                    "property float {name}
"
                )
            })
            .collect();
        let numbers = numbers.concat();
        let mut bytes = format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex {}\n{numbers}element face {}\n\
             property list uchar int vertex_indices\nend_header\n",
            self.vertices.len(),
            self.faces.len()
        )
        .into_bytes();
        for (i, vertex) in self.vertices.iter().enumerate() {
            let normal = self.normals.get(i).into_iter().flatten();
            bytes.extend(vertex.iter().chain(normal).flat_map(|number| number.to_le_bytes()));
        }
        for face in &self.faces {
            bytes.push(face.len() as u8);
            bytes.extend(face.iter().flat_map(|corner| corner.to_le_bytes()));
        }
        bytes
    }

    /// Adds a flat polygon, its corners counter-clockwise from outside, with
    /// corners of its own.
    pub(crate) fn add(&mut self, corners: &[[f64; 3]]) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(corners.iter().map(|corner| corner.map(|x| x as f32)));
        let fan = 1..(corners.len() as u32).saturating_sub(1);
        self.faces.extend(fan.map(|k| [first, first + k, first + k + 1]));
    }

    /// Adds the six sides of a box.
    pub(crate) fn add_box(&mut self, lo: [f64; 3], hi: [f64; 3]) {
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            for is_high in [false, true] {
                let corner = |a: bool, b: bool| {
                    let mut corner = lo;
                    for (k, high) in [(axis, is_high), (u, a), (v, b)] {
                        corner[k] = if high { hi[k] } else { lo[k] };
                    }
                    corner
                };
                let mut side = [(false, false), (true, false), (true, true), (false, true)]
                    .map(|(a, b)| corner(a, b));
                if !is_high {
                    side.reverse();
                }
                self.add(&side);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use tracer::glam::DVec3;

    use super::*;

    #[test]
    fn a_box_is_twelve_triangles_that_look_out() {
        let mut triangles = Triangles::default();
        triangles.add_box([-1.0, -2.0, -3.0], [1.0, 2.0, 3.0]);
        assert_eq!(triangles.faces.len(), 12);
        let mut area = 0.0;
        for face in &triangles.faces {
            let [a, b, c] =
                face.map(|i| DVec3::from(triangles.vertices[i as usize].map(f64::from)));
            let across = (b - a).cross(c - a);
            assert!(across.dot(a + b + c) > 0.0, "{face:?}");
            area += 0.5 * across.length();
        }
        assert_eq!(area, 2.0 * (2.0 * 4.0 + 4.0 * 6.0 + 6.0 * 2.0));
    }

    #[test]
    fn files_have_the_promised_bytes() {
        let mut triangles = Triangles::default();
        triangles.add(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        let ply = triangles.ply();
        let text = String::from_utf8_lossy(&ply).into_owned();
        assert!(text.contains("element vertex 3\nproperty float x\n"), "{text}");
        assert!(text.contains("element face 1\n"), "{text}");
        assert_eq!(ply.len(), text.find("end_header").unwrap() + 11 + 3 * 12 + 13);
    }
}
