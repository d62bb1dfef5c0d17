//! What is asked of each primitive, one file each.
//!
//! To add a primitive: its file here with a `families` function, its line in
//! [`all`], and its exact formula in [`crate::truth`].

mod axis_box;
mod camera;
mod chain;
mod closest;
mod cone;
mod cylinder;
mod disk;
mod frustum;
mod image;
mod instance;
mod mesh;
mod plane;
mod spawn;
mod sphere;
mod sphere_surface;
mod textbook_frustum;
mod textbook_torus;
mod torus;
mod triangle;
mod triangle_flat;

use crate::Family;

/// Every family of every primitive.
pub fn all() -> Vec<Family> {
    [
        sphere::families(),
        triangle::families(),
        axis_box::families(),
        plane::families(),
        disk::families(),
        cylinder::families(),
        cone::families(),
        torus::families(),
        mesh::families(),
        instance::families(),
        spawn::families(),
        camera::families(),
        image::families(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
