//! The crate `parry3d`: its triangle mesh.

use parry3d::math::Vector;
use parry3d::query::{Ray, RayCast};
use parry3d::shape::TriMesh;

use super::{Job, RayF32, Tracer, TriangleMesh, engine};

struct Parry(TriMesh);

pub(super) fn prepare(mesh: &TriangleMesh) -> Job {
    let vertices = mesh.vertices.iter().map(|&v| Vector::from_array(v)).collect();
    let faces = mesh.faces.clone();
    Box::new(move || {
        let made = TriMesh::new(vertices, faces);
        Ok(engine(Parry(made.map_err(|why| format!("parry3d refuses the mesh: {why}"))?)))
    })
}

impl Tracer for Parry {
    type Ray = Ray;

    fn ray(ray: &RayF32, _: f32) -> Ray {
        Ray::new(Vector::from_array(ray.origin), Vector::from_array(ray.direction))
    }

    fn closest(&self, ray: &Ray, far: f32) -> Option<f32> {
        self.0.cast_local_ray(ray, far.min(f32::MAX), false)
    }

    fn any(&self, ray: &Ray, far: f32) -> bool {
        self.0.intersects_local_ray(ray, far.min(f32::MAX))
    }
}
