//! `Facets`: triangles corner by corner, and how they are welded.

use tracer::glam::DVec3;

use crate::import::mesh::part::{LARGEST, MOST_ELEMENTS, Part, is_point};

/// Triangles one after the other.
#[derive(Debug, Default)]
pub(super) struct Facets {
    corners: Vec<DVec3>,
    /// How many have a normal that says the opposite of their corners.
    pub(super) against: usize,
}

impl Facets {
    /// Adds a facet.
    ///
    /// # Errors
    /// What is wrong with its numbers.
    pub(super) fn add(&mut self, normal: DVec3, corners: [DVec3; 3]) -> Result<(), String> {
        if let Some(bad) = corners.iter().find(|&&p| !is_point(p)) {
            return Err(format!(
                "expected a corner of three finite numbers of at most {LARGEST:e}, found {bad}"
            ));
        }
        if self.corners.len() >= MOST_ELEMENTS {
            return Err(format!("expected at most {} facets", MOST_ELEMENTS / 3));
        }
        let [a, b, c] = corners;
        self.against += usize::from(normal.dot((b - a).cross(c - a)) < 0.0);
        // A zero is the same with either sign.
        self.corners.extend(corners.map(|p| p + DVec3::ZERO));
        Ok(())
    }

    /// The mesh, with the corners in the order in which they first come.
    pub(super) fn welded(self) -> Part {
        let corners = &self.corners;
        let key = |i: u32| corners[i as usize].to_array().map(f64::to_bits);
        let mut order: Vec<u32> = (0..corners.len() as u32).collect();
        order.sort_unstable_by_key(|&i| (key(i), i));
        let mut first: Vec<u32> = (0..corners.len() as u32).collect();
        for pair in order.windows(2) {
            if key(pair[0]) == key(pair[1]) {
                first[pair[1] as usize] = first[pair[0] as usize];
            }
        }
        let mut part = Part::default();
        let mut number = vec![0; corners.len()];
        for (i, &first) in first.iter().enumerate() {
            if first as usize == i {
                number[i] = part.vertices.len() as u32;
                part.vertices.push(corners[i]);
            } else {
                number[i] = number[first as usize];
            }
        }
        part.faces = number.as_chunks::<3>().0.to_vec();
        part
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_of_the_same_bits_are_one() {
        let mut facets = Facets::default();
        let [a, b, c] = [DVec3::X, DVec3::Y, DVec3::Z];
        facets.add(DVec3::ONE, [a, b, c]).unwrap();
        facets.add(-DVec3::ONE, [c, b, -DVec3::ZERO]).unwrap();
        facets.add(DVec3::ZERO, [DVec3::ZERO, a, a * 1.0_f64.next_up()]).unwrap();
        assert_eq!(facets.against, 0);
        let part = facets.welded();
        assert_eq!(part.vertices, [a, b, c, DVec3::ZERO, a * 1.0_f64.next_up()]);
        assert_eq!(part.faces, [[0, 1, 2], [2, 1, 3], [3, 0, 4]]);
    }
}
