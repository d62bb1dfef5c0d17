//! goldray's tracer: a pure function from a [`Scene`] to a [`LinearImage`].
//!
//! The tracer starts from the lecture "Ray Tracing Basics" (Cornell
//! CS4620/5620, 2011). Each of its items has one place here; the table in
//! [`lecture`] says where. All geometry is `f64`.
//!
//! It promises:
//! - **Rendering cannot fail.** Constructors refuse bad numbers
//!   ([`Refused`]); [`render`] returns no `Result`.
//! - **Same scene, same bits**, whatever the number of threads: no
//!   transcendental function of the system, no sum whose order depends on
//!   scheduling.
//! - **No IO**: no file, clock, environment, printing or global state.
//!
//! ```
//! use tracer::{Camera, Group, Interval, Material, Member, Object, Projection, Ray, Rgb, View};
//! use tracer::glam::DVec3;
//! use tracer::shape::{Shape, Sphere};
//!
//! let ball = Sphere::new(DVec3::ZERO, 1.0)?;
//! let world = Group::world(vec![Member::Object(Object::new(
//!     Shape::Sphere(ball),
//!     Material::Constant(Rgb::WHITE),
//! ))]);
//! let ray = Ray::new(DVec3::new(0.0, 0.0, 5.0), DVec3::new(0.0, 0.0, -2.0));
//! // The direction has length 2, so the near side at distance 4 is at t = 2.
//! let hit = world.intersect(&ray, Interval::AHEAD).unwrap();
//! assert_eq!(hit.t, 2.0);
//! # Ok::<(), tracer::Refused>(())
//! ```

mod aabb;
pub mod accel;
mod camera;
mod color;
#[cfg(test)]
mod exact;
pub mod fault;
mod group;
mod hit;
mod image;
mod interval;
pub mod lecture;
mod light;
mod material;
mod math;
mod meter;
mod object;
mod plan;
mod ray;
mod refused;
mod render;
mod scene;
mod shading;
pub mod shape;
mod show;
mod simd;
mod specular;
pub mod texture;
mod transform;
mod unit;

pub use aabb::Aabb;
pub use camera::{Camera, Projection, View, pixel_center};
pub use color::Rgb;
pub use glam;
pub use group::{Group, Member};
pub use hit::{Hit, ObjectId};
pub use image::{LinearImage, Size};
pub use interval::Interval;
pub use light::{Falloff, Light};
pub use material::Material;
pub use meter::{Event, Stats};
pub use object::Object;
pub use plan::{Plan, Skipping};
pub use ray::Ray;
pub use refused::{Refusal, Refused};
pub use render::{Around, Filter, Sampler, Samples, edges, objects_seen, render, render_counted};
pub use scene::{Scene, SceneParts};
pub use shading::Convention;
pub use show::{Show, id_color};
pub use simd::Instructions;
pub use specular::rays_sent_on;
pub use texture::Texture;
pub use transform::Transform;
pub use unit::UnitVec;
