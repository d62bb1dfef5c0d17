//! Tracers out of crates, all asked ray by ray.

mod bvh;
mod obvhs;
mod parry3d;

use super::engine::{Engine, Job};
use super::rays::{Query, RayF32, RaySet};
use crate::meshes::TriangleMesh;

/// What such a crate can do with one ray.
trait Tracer {
    /// The crate's own ray.
    type Ray;

    /// A ray that ends at `far`.
    fn ray(ray: &RayF32, far: f32) -> Self::Ray;

    /// Where it hits first, before `far`.
    fn closest(&self, ray: &Self::Ray, far: f32) -> Option<f32>;

    /// Whether it hits before `far`.
    fn any(&self, ray: &Self::Ray, far: f32) -> bool;
}

/// What builds the engine of this name.
///
/// # Errors
/// A mesh that the crate refuses, and a name that is no crate's.
pub(super) fn prepare(name: &str, mesh: &TriangleMesh) -> Result<Job, String> {
    match name {
        "obvhs" => Ok(obvhs::prepare(mesh)),
        "bvh" => Ok(bvh::prepare(mesh)),
        "parry3d" => Ok(parry3d::prepare(mesh)),
        _ => Err(format!("no engine is called {name}")),
    }
}

/// A crate's tracer with the rays to send.
struct Single<T: Tracer> {
    tracer: T,
    rays: Vec<T::Ray>,
    query: Query,
    far: f32,
    found: Vec<Option<f32>>,
}

fn engine<T: Tracer + 'static>(tracer: T) -> Box<dyn Engine> {
    let (rays, found) = (Vec::new(), Vec::new());
    Box::new(Single { tracer, rays, query: Query::Closest, far: f32::INFINITY, found })
}

impl<T: Tracer> Engine for Single<T> {
    fn load(&mut self, set: &RaySet) {
        self.rays = set.rays.iter().map(|ray| T::ray(ray, set.far)).collect();
        (self.query, self.far) = (set.query, set.far);
        self.found = vec![None; set.rays.len()];
    }

    fn trace(&mut self) {
        let each = self.rays.iter().zip(&mut self.found);
        match self.query {
            Query::Closest => {
                each.for_each(|(ray, found)| *found = self.tracer.closest(ray, self.far));
            }
            Query::Any => each.for_each(|(ray, found)| {
                *found = self.tracer.any(ray, self.far).then_some(0.0);
            }),
        }
    }

    fn answers(&self) -> Vec<Option<f64>> {
        self.found.iter().map(|t| t.map(f64::from)).collect()
    }
}

/// The three corners of each triangle.
fn triangles(mesh: &TriangleMesh) -> impl Iterator<Item = [[f32; 3]; 3]> {
    mesh.faces.iter().map(|face| face.map(|i| mesh.vertices[i as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meshes;
    use crate::trace::goldray;
    use crate::trace::measure::count_wrong;
    use crate::trace::rays::{self, Kind};

    /// On a round thing, far from edges, all agree with the exact answers but
    /// for what grazes.
    #[test]
    fn crates_are_asked_in_the_right_way() {
        const GRAZING: usize = 3;
        let scene = meshes::named("bumpy-1000").unwrap().unwrap();
        let exact = goldray::build(&scene.mesh, tracer::accel::Build::Bvh).unwrap();
        for set in rays::sets(&scene, &exact, 24, &Kind::ALL) {
            let mut reference =
                goldray::prepare(&scene.mesh, tracer::accel::Build::List, 1).unwrap()().unwrap();
            reference.load(&set);
            reference.trace();
            let hits = reference.answers().iter().flatten().count();
            assert!(hits > 0, "{}", set.name);
            for name in ["obvhs", "bvh", "parry3d"] {
                let mut engine = prepare(name, &scene.mesh).unwrap()().unwrap();
                engine.load(&set);
                engine.trace();
                let wrong = count_wrong(&engine.answers(), &reference.answers(), set.query).total();
                assert!(wrong <= GRAZING, "{name} {}: {wrong} of {}", set.name, set.rays.len());
            }
        }
    }
}
