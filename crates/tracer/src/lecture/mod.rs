//! The lecture's textbook formulas, as on the slides, and where each of its
//! items lives.
//!
//! Source: "Ray Tracing Basics", lecture 7 of Cornell CS4620/5620, fall 2011
//! (Kavita Bala, after James and Marschner).
//!
//! | item | here |
//! |---|---|
//! | Generating eye rays: perspective, parallel | [`Camera::ray`](crate::Camera::ray) |
//! | Pixel-to-image mapping | [`pixel_center`](crate::pixel_center) |
//! | PA1 camera | [`View`](crate::View) |
//! | Ray-sphere: algebraic | [`sphere_algebraic`] |
//! | Ray-sphere: geometric | [`sphere_geometric`] |
//! | Ray-triangle: plane, inside-edge test | [`triangle_inside_edges`] |
//! | Ray-triangle: linear systems | [`triangle_linear_system`] |
//! | Ray-slab, `d` positive or negative | [`ray_slab`] |
//! | Ray-box: three slabs | [`ray_box`] |
//! | Image so far: white on a hit | [`Show::Silhouette`](crate::Show::Silhouette) |
//! | `Group.intersect` | [`Group::intersect`](crate::Group::intersect), [`accel::List`](crate::accel::List) |
//! | Acceleration structures | [`accel`](crate::accel) |
//! | `Scene.trace` | [`Scene::trace`](crate::Scene::trace) |
//! | Shading inputs, Lambert's cosine law | [`Material::reflect`](crate::Material::reflect) |
//!
//! The functions of this module work with any direction length and return the
//! closest `t` inside the interval. The sphere and triangle forms are kept for
//! what they teach and as a second opinion in tests. What renders is the
//! stable form beside them in [`shape`](crate::shape), which keeps its digits
//! where these lose them: far away, at grazing angles and on shared edges. The
//! slab formula is stable as it stands, and renders.

mod slab;
mod sphere;
mod triangle;

pub use slab::{ray_box, ray_slab};
pub use sphere::{sphere_algebraic, sphere_geometric};
pub use triangle::{triangle_inside_edges, triangle_linear_system};
