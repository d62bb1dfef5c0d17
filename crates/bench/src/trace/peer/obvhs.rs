//! The crate `obvhs`: its compressed hierarchy of eight children, built at the
//! setting that it says takes about Embree's time.

use std::time::Duration;

use obvhs::BvhBuildParams;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray, RayHit};
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;

use super::{Job, RayF32, Tracer, TriangleMesh, engine, triangles};

struct Obvhs {
    bvh: CwBvh,
    /// In the hierarchy's order.
    triangles: Vec<RtTriangle>,
}

pub(super) fn prepare(mesh: &TriangleMesh) -> Job {
    let triangle =
        |[v0, v1, v2]: [[f32; 3]; 3]| Triangle { v0: v0.into(), v1: v1.into(), v2: v2.into() };
    let input: Vec<Triangle> = triangles(mesh).map(triangle).collect();
    Box::new(move || {
        let params = BvhBuildParams::medium_build();
        let bvh = build_cwbvh_from_tris(&input, params, &mut Duration::default());
        let ordered = bvh.primitive_indices.iter().map(|&i| (&input[i as usize]).into());
        let triangles = ordered.collect();
        Ok(engine(Obvhs { bvh, triangles }))
    })
}

impl Tracer for Obvhs {
    type Ray = Ray;

    fn ray(ray: &RayF32, far: f32) -> Ray {
        Ray::new(ray.origin.into(), ray.direction.into(), 0.0, far)
    }

    fn closest(&self, ray: &Ray, _: f32) -> Option<f32> {
        let mut hit = RayHit::none();
        let test = |ray: &Ray, i: usize| self.triangles[i].intersect(ray);
        self.bvh.ray_traverse(*ray, &mut hit, test).then_some(hit.t)
    }

    fn any(&self, ray: &Ray, _: f32) -> bool {
        !self.bvh.ray_traverse_miss(*ray, |ray, i| self.triangles[i].intersect(ray))
    }
}
