//! The hot paths, each as a fixed piece of work.
#![expect(clippy::unnecessary_wraps, reason = "some works cannot fail to be readied")]
#![allow(clippy::needless_pass_by_value, reason = "`map_err` passes errors by value")]

use std::hint::black_box;

use harness::encode::{Transfer, encode};
use harness::metric::{Pair, compare, ssim};
use tracer::accel::{Build, Coherence};
use tracer::glam::DVec3;
use tracer::shape::{AxisBox, Geometry, Mesh, Sphere, Triangle};
use tracer::{Interval, Ray, render};

use crate::inputs;

/// Part of the name of the one function whose instructions are counted.
pub(super) const COUNTED: &str = "counted_work";

/// Something ready to be done, which returns a number that depends on all of
/// it, so that none is left out.
type Ready = Box<dyn Fn() -> f64>;

/// One piece of work.
pub(crate) struct Work {
    /// Its name in tables and in the baseline.
    pub(crate) name: &'static str,
    /// What is done.
    pub(crate) what: &'static str,
    ready: fn() -> Result<Ready, String>,
}

/// Rays against one primitive.
const RAYS: usize = 20_000;
/// Rays through a structure.
const FEW_RAYS: usize = 4_000;
/// Triangles of a mesh.
const TRIANGLES: usize = 20_000;
/// A side of a picture that is compared or encoded.
const SIDE: u32 = 160;

/// Every work, in the order of the table.
pub(crate) const ALL: &[Work] = &[
    Work { name: "sphere", what: "20,000 rays against a sphere", ready: sphere },
    Work { name: "box", what: "20,000 rays against a box", ready: axis_box },
    Work { name: "triangle", what: "20,000 rays against a triangle", ready: triangle },
    Work { name: "group-closest", what: "4,000 rays, 1,000 spheres", ready: group_closest },
    Work { name: "group-any", what: "4,000 shadow rays, 1,000 spheres", ready: group_any },
    Work { name: "mesh-closest", what: "4,000 rays, 20,000 triangles", ready: mesh_closest },
    Work { name: "mesh-any", what: "4,000 shadow rays, 20,000 triangles", ready: mesh_any },
    Work { name: "mesh-tiles", what: "64 x 64 eye rays, 20,000 triangles", ready: mesh_tiles },
    Work { name: "mesh-fast", what: "4,000 rays in f32, 20,000 triangles", ready: mesh_fast },
    Work { name: "mesh-build", what: "a hierarchy over 20,000 triangles", ready: mesh_build },
    Work { name: "render", what: "96 x 72 pixels, 13 objects, 2 lights", ready: render_scene },
    Work { name: "ssim", what: "two pictures of 160 x 160", ready: ssim_pair },
    Work { name: "compare", what: "every metric of the same two", ready: compare_pair },
    Work { name: "encode", what: "a picture of 160 x 160", ready: encode_picture },
    Work { name: "scene-parse", what: "a scene of 13 objects and 32 lights", ready: parse },
];

/// Readies a work and does it once, counted.
///
/// # Errors
/// No such work, and what readying it refuses.
pub(super) fn do_once(name: &str) -> Result<(), String> {
    let Some(work) = ALL.iter().find(|work| work.name == name) else {
        let names: Vec<_> = ALL.iter().map(|work| work.name).collect();
        return Err(format!("expected a work of {}; found {name}", names.join(", ")));
    };
    // All of it on this thread: callgrind's toggle is for the thread it is in.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread();
    pool.build_global().map_err(|error| error.to_string())?;
    let ready = (work.ready)()?;
    black_box(counted_work(&ready));
    Ok(())
}

/// Never inlined, and the call is not its last act: else there would be no
/// entry or no exit to see.
#[inline(never)]
fn counted_work(ready: &Ready) -> f64 {
    black_box(ready()) + 1.0
}

/// Tests every ray, and adds up where it hits.
fn closest(shape: impl Geometry + 'static, rays: Vec<Ray>) -> Ready {
    Box::new(move || {
        let t = |ray| shape.intersect(ray, Interval::AHEAD).map_or(0.0, |contact| contact.t);
        rays.iter().map(t).sum()
    })
}

fn any(shape: impl Geometry + 'static, rays: Vec<Ray>) -> Ready {
    Box::new(move || {
        let occluded = rays.iter().filter(|ray| shape.occludes(ray, Interval::AHEAD));
        occluded.count() as f64
    })
}

fn refused(refused: impl std::fmt::Display) -> String {
    refused.to_string()
}

fn sphere() -> Result<Ready, String> {
    let sphere = Sphere::new(DVec3::new(0.1, 0.2, -0.1), 0.8).map_err(refused)?;
    Ok(closest(sphere, inputs::rays(RAYS)))
}

fn axis_box() -> Result<Ready, String> {
    let axis_box = AxisBox::new(DVec3::splat(-0.6), DVec3::splat(0.7)).map_err(refused)?;
    Ok(closest(axis_box, inputs::rays(RAYS)))
}

fn triangle() -> Result<Ready, String> {
    let [a, b, c] = [(-1.3, -1.1, 0.2), (1.4, -0.9, -0.3), (0.1, 1.5, 0.4)].map(DVec3::from);
    Ok(closest(Triangle::new(a, b, c).map_err(refused)?, inputs::rays(RAYS)))
}

fn group_closest() -> Result<Ready, String> {
    let (group, rays) = (inputs::spheres(1_000)?, inputs::rays(FEW_RAYS));
    Ok(Box::new(move || {
        let t = |ray| group.intersect(ray, Interval::AHEAD).map_or(0.0, |hit| hit.t);
        rays.iter().map(t).sum()
    }))
}

fn group_any() -> Result<Ready, String> {
    let (group, rays) = (inputs::spheres(1_000)?, inputs::rays(FEW_RAYS));
    Ok(Box::new(move || {
        rays.iter().filter(|ray| group.occludes(ray, Interval::AHEAD)).count() as f64
    }))
}

fn mesh_closest() -> Result<Ready, String> {
    Ok(closest(inputs::bumpy_ball(TRIANGLES, Build::Bvh)?, inputs::rays(FEW_RAYS)))
}

fn mesh_fast() -> Result<Ready, String> {
    Ok(closest(inputs::bumpy_ball(TRIANGLES, Build::Fast)?, inputs::rays(FEW_RAYS)))
}

fn mesh_any() -> Result<Ready, String> {
    Ok(any(inputs::bumpy_ball(TRIANGLES, Build::Bvh)?, inputs::rays(FEW_RAYS)))
}

fn mesh_tiles() -> Result<Ready, String> {
    let mesh = inputs::bumpy_ball(TRIANGLES, Build::Bvh)?;
    let rays = inputs::eye_rays(64);
    Ok(Box::new(move || {
        let mut contacts = vec![None; rays.len()];
        mesh.intersect_batch(&rays, Interval::AHEAD, Coherence::Coherent, &mut contacts);
        contacts.iter().flatten().map(|contact| contact.t).sum()
    }))
}

fn mesh_build() -> Result<Ready, String> {
    let (vertices, faces) = inputs::bumpy_ball_parts(TRIANGLES);
    Ok(Box::new(move || {
        let mesh = Mesh::new(vertices.clone(), faces.clone(), None, Build::Bvh);
        mesh.map_or(0.0, |mesh| mesh.triangle_count() as f64)
    }))
}

fn render_scene() -> Result<Ready, String> {
    let scene = inputs::scene((96, 72), 2)?;
    Ok(Box::new(move || render(&scene).pixels().iter().map(|pixel| pixel.channels()[0]).sum()))
}

fn ssim_pair() -> Result<Ready, String> {
    let [golden, actual] = inputs::unlike_pictures(SIDE, SIDE);
    Ok(Box::new(move || Pair::new(&golden, &actual).map_or(0.0, |pair| ssim(&pair).mean)))
}

fn compare_pair() -> Result<Ready, String> {
    let [golden, actual] = inputs::unlike_pictures(SIDE, SIDE);
    Ok(Box::new(move || compare(&golden, &actual).map_or(0.0, |found| found.rmse)))
}

fn encode_picture() -> Result<Ready, String> {
    let linear = inputs::linear_picture(SIDE, SIDE);
    Ok(Box::new(move || {
        let encoded = encode(&linear, Transfer::Gamma22);
        encoded.map_or(0.0, |picture| {
            picture.bytes().iter().next_back().map_or(0.0, |&b| f64::from(b))
        })
    }))
}

fn parse() -> Result<Ready, String> {
    let text = inputs::scene_text((96, 72), 32);
    inputs::parse(&text)?;
    Ok(Box::new(move || inputs::parse(&text).map_or(0.0, |scene| scene.exposure())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_work_does_something_and_the_same_each_time() {
        for work in ALL {
            let ready = (work.ready)().unwrap();
            let first = ready();
            assert!(first > 0.0, "{}: {first}", work.name);
            assert_eq!(first, ready(), "{}", work.name);
        }
    }

    #[test]
    fn names_are_told_apart() {
        let mut names: Vec<_> = ALL.iter().map(|work| work.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ALL.len());
        let known = do_once("sfere").unwrap_err();
        assert!(known.contains("expected a work of sphere, ") && known.contains("found sfere"));
    }
}
