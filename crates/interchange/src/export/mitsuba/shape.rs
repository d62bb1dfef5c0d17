//! Shapes, in the world's space.

use std::collections::BTreeMap;

use tracer::glam::DVec3;

use super::matrix;
use super::xml::{boolean, float, point, string};
use crate::export::plain::Solid;

/// A plane is so much larger than what is needed of it: its rim is nowhere near.
const MARGIN: f64 = 2.0;

/// One object, by as many of Mitsuba's shapes as it takes; triangles become a
/// file.
pub(super) fn shape(solid: &Solid, look: &str, files: &mut BTreeMap<String, Vec<u8>>) -> String {
    let shape =
        |kind: &str, inside: &str| format!("<shape type=\"{kind}\">{inside}{look}</shape>\n");
    let at = |name: &str, p: DVec3| point(name, p.to_array());
    match solid {
        Solid::Sphere { center, radius } => {
            shape("sphere", &(at("center", *center) + &float("radius", *radius)))
        }
        Solid::Disk { center, normal, radius } => shape("disk", &flat(*center, *normal, *radius)),
        Solid::Plane { point, normal, reach } => {
            // A plane that nothing needs is there all the same.
            let half = if *reach > 0.0 { MARGIN * reach } else { 1.0 };
            shape("rectangle", &flat(*point, *normal, half))
        }
        Solid::Cylinder { a, b, radius, open } => {
            let inside = at("p0", *a) + &at("p1", *b) + &float("radius", *radius);
            let mut all = shape("cylinder", &inside);
            if !open {
                all += &shape("disk", &flat(*a, *a - *b, *radius));
                all += &shape("disk", &flat(*b, *b - *a, *radius));
            }
            all
        }
        Solid::Triangles(triangles) => {
            let name = format!("triangles-{}.ply", files.len());
            let is_flat = triangles.normals.is_empty();
            files.insert(name.clone(), triangles.ply());
            shape("ply", &(string("filename", &name) + &boolean("face_normals", is_flat)))
        }
        // It has no words for them; that was asked before.
        Solid::Torus { .. } | Solid::Cone { .. } => String::new(),
    }
}

/// Disks and rectangles reach 1 from the origin and look along z.
fn flat(center: DVec3, normal: DVec3, half: f64) -> String {
    let z = normal.normalize_or_zero();
    let x = z.any_orthonormal_vector();
    let y = z.cross(x);
    let columns = [x * half, y * half, z, center].map(|v| v.to_array());
    format!("<transform name=\"to_world\">{}</transform>", matrix(columns))
}
