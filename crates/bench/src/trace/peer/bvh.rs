//! The crate `bvh`, with a triangle test of ours: its own sees front sides
//! only.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use bvh::ray::Ray;
use nalgebra::{Point3, Vector3};

use super::{Job, RayF32, Tracer, TriangleMesh, engine, triangles};

struct Triangle {
    corners: [Point3<f32>; 3],
    node: usize,
}

impl Bounded<f32, 3> for Triangle {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.corners.iter().fold(Aabb::empty(), |all, corner| all.grow(corner))
    }
}

impl BHShape<f32, 3> for Triangle {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Triangle {
    /// Source: Moeller, Trumbore, "Fast, minimum storage ray/triangle
    /// intersection" (1997), seen from both sides.
    fn intersect(&self, ray: &Ray<f32, 3>, far: f32) -> Option<f32> {
        let [a, b, c] = self.corners;
        let (e1, e2) = (b - a, c - a);
        let p = ray.direction.cross(&e2);
        let inverse = e1.dot(&p).recip();
        let s = ray.origin - a;
        let u = s.dot(&p) * inverse;
        let q = s.cross(&e1);
        let v = ray.direction.dot(&q) * inverse;
        let t = e2.dot(&q) * inverse;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t <= far).then_some(t)
    }
}

struct Binary {
    bvh: Bvh<f32, 3>,
    triangles: Vec<Triangle>,
}

pub(super) fn prepare(mesh: &TriangleMesh) -> Job {
    let triangle =
        |corners: [[f32; 3]; 3]| Triangle { corners: corners.map(Point3::from), node: 0 };
    let mut triangles: Vec<Triangle> = triangles(mesh).map(triangle).collect();
    Box::new(move || {
        let bvh = Bvh::build(&mut triangles);
        Ok(engine(Binary { bvh, triangles }))
    })
}

impl Tracer for Binary {
    type Ray = Ray<f32, 3>;

    /// Not through the constructor, which would change the direction's length.
    fn ray(ray: &RayF32, _: f32) -> Self::Ray {
        let direction = Vector3::from(ray.direction);
        let inv_direction = direction.map(f32::recip);
        Ray { origin: Point3::from(ray.origin), direction, inv_direction }
    }

    fn closest(&self, ray: &Self::Ray, far: f32) -> Option<f32> {
        let mut found = None;
        for triangle in self.bvh.traverse_iterator(ray, &self.triangles) {
            found = triangle.intersect(ray, found.unwrap_or(far)).or(found);
        }
        found
    }

    fn any(&self, ray: &Self::Ray, far: f32) -> bool {
        let mut met = self.bvh.traverse_iterator(ray, &self.triangles);
        met.any(|triangle| triangle.intersect(ray, far).is_some())
    }
}
