//! The sweeps: generated inputs of every size, timed in turns.

use tracer::accel::Build;
use tracer::shape::{Geometry, Mesh};
use tracer::{Group, Interval, Ray, Scene, render};

use super::{Point, Sweep, Threads};
use crate::inputs;
use crate::measure::{Effort, Pass, Spread, in_turns, wall_and_processor};

/// Spheres in a group, triangles in a mesh, pixels, lights.
const SPHERES: [usize; 5] = [10, 100, 1_000, 10_000, 100_000];
const TRIANGLES: [usize; 7] = [1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000];
const PIXELS: [usize; 6] = [10_000, 40_000, 160_000, 640_000, 1_000_000, 4_000_000];
const LIGHTS: [usize; 6] = [1, 2, 4, 8, 16, 32];

/// Rays of a pass.
const RAYS: usize = 10_000;

/// The picture whose lights or threads grow.
const PICTURE: (u32, u32) = (320, 240);

/// For passes of milliseconds.
const SHORT: Effort = Effort { rounds: 7, turn: 0.02 };
/// For passes of up to a second.
const LONG: Effort = Effort { rounds: 3, turn: 0.02 };

/// Nanoseconds and milliseconds of a second.
const NANOSECONDS: f64 = 1e9;
const MILLISECONDS: f64 = 1e3;

/// Which sizes of a sweep are taken.
pub(super) type Keep<'a> = &'a (dyn Fn(&[usize]) -> Vec<usize> + Sync);

/// All but that of threads. What grows is timed in turns: a slow spell of the
/// machine meets all sizes alike.
pub(super) fn all(keep: Keep<'_>) -> Result<Vec<Sweep>, String> {
    on_one_thread(|| {
        let mut sweeps = spheres(&keep(&SPHERES))?;
        sweeps.extend(triangles(&keep(&TRIANGLES))?);
        sweeps.push(builds(&keep(&TRIANGLES)));
        sweeps.push(pixels(&keep(&PIXELS))?);
        sweeps.push(lights(&keep(&LIGHTS))?);
        Ok(sweeps)
    })?
}

/// Does this in a pool of this thread alone, so that its clock sees all of it.
fn on_one_thread<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, String> {
    pool(1).map(|pool| pool.install(work))
}

fn pool(threads: usize) -> Result<rayon::ThreadPool, String> {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().map_err(|error| error.to_string())
}

/// The points of a sweep, each time multiplied by `factor`.
fn points(sizes: &[usize], passes: &mut [Pass<'_>], effort: Effort, factor: f64) -> Vec<Point> {
    let times = in_turns(passes, effort);
    let point =
        |(size, time): (&usize, Spread)| Point { size: *size as f64, time: time.times(factor) };
    sizes.iter().zip(times).map(point).collect()
}

fn spheres(sizes: &[usize]) -> Result<Vec<Sweep>, String> {
    eprintln!("spheres");
    let groups = sizes.iter().map(|&n| inputs::spheres(n)).collect::<Result<Vec<_>, _>>()?;
    let rays = inputs::rays(RAYS);
    let t =
        |group: &Group, ray: &Ray| group.intersect(ray, Interval::AHEAD).map_or(0.0, |hit| hit.t);
    let mut closest = Vec::new();
    let mut any = Vec::new();
    for group in &groups {
        closest.push(over(&rays, move |ray| t(group, ray)));
        any.push(over(&rays, |ray| f64::from(group.occludes(ray, Interval::AHEAD))));
    }
    let per_ray = NANOSECONDS / RAYS as f64;
    Ok(vec![
        Sweep::new(
            "spheres",
            "closest hit in a group",
            "ns a ray",
            points(sizes, &mut closest, SHORT, per_ray),
        ),
        Sweep::new(
            "spheres",
            "any hit in a group",
            "ns a ray",
            points(sizes, &mut any, SHORT, per_ray),
        ),
    ])
}

/// A pass over all rays.
fn over<'a>(rays: &'a [Ray], test: impl Fn(&Ray) -> f64 + 'a) -> Pass<'a> {
    Box::new(move || rays.iter().map(&test).sum())
}

fn triangles(sizes: &[usize]) -> Result<Vec<Sweep>, String> {
    eprintln!("triangles");
    let per_ray = NANOSECONDS / RAYS as f64;
    let rays = inputs::rays(RAYS);
    let mut sweeps = Vec::new();
    for (build, mode) in [(Build::Bvh, "accurate"), (Build::Fast, "fast")] {
        let meshes: Vec<Mesh> =
            sizes.iter().map(|&n| inputs::bumpy_ball(n, build)).collect::<Result<_, _>>()?;
        let mut closest = Vec::new();
        let mut any = Vec::new();
        for mesh in &meshes {
            closest.push(over(&rays, |ray| {
                mesh.intersect(ray, Interval::AHEAD).map_or(0.0, |contact| contact.t)
            }));
            any.push(over(&rays, |ray| f64::from(mesh.occludes(ray, Interval::AHEAD))));
        }
        for (passes, what) in [(&mut closest, "closest hit"), (&mut any, "any hit")] {
            let name = format!("{what}, {mode}");
            let points = points(sizes, passes, SHORT, per_ray);
            sweeps.push(Sweep::new("triangles", &name, "ns a ray", points));
        }
    }
    Ok(sweeps)
}

/// Building the mesh with its hierarchy.
fn builds(sizes: &[usize]) -> Sweep {
    eprintln!("builds");
    let parts: Vec<_> = sizes.iter().map(|&n| inputs::bumpy_ball_parts(n)).collect();
    let mut passes: Vec<Pass<'_>> = Vec::new();
    for (vertices, faces) in &parts {
        passes.push(Box::new(|| {
            let mesh = Mesh::new(vertices.clone(), faces.clone(), None, Build::Bvh);
            mesh.map_or(0.0, |mesh| mesh.triangle_count() as f64)
        }));
    }
    let points = points(sizes, &mut passes, LONG, MILLISECONDS);
    Sweep::new("triangles", "build, accurate", "ms", points)
}

/// The sum of a picture, which nothing of it may be missing from.
fn sum(scene: &Scene) -> f64 {
    render(scene).pixels().iter().map(|pixel| pixel.channels()[0]).sum()
}

fn renders(sizes: &[usize], scenes: &[Scene]) -> Vec<Point> {
    let mut passes: Vec<Pass<'_>> = Vec::new();
    for scene in scenes {
        passes.push(Box::new(|| sum(scene)));
    }
    points(sizes, &mut passes, LONG, MILLISECONDS)
}

fn pixels(sizes: &[usize]) -> Result<Sweep, String> {
    eprintln!("pixels");
    // Pictures of 4 by 3.
    let size = |pixels: usize| {
        let height = (pixels as f64 * 0.75).sqrt().round();
        (pixels as f64 / height).round() as u32
    };
    let scene = |&pixels: &usize| {
        let width = size(pixels);
        inputs::scene((width, (pixels as f64 / f64::from(width)).round() as u32), 2)
    };
    let scenes = sizes.iter().map(scene).collect::<Result<Vec<_>, _>>()?;
    let name = "a picture of 13 objects and 2 lights";
    Ok(Sweep::new("pixels", name, "ms", renders(sizes, &scenes)))
}

fn lights(sizes: &[usize]) -> Result<Sweep, String> {
    eprintln!("lights");
    let scene = |&lights: &usize| inputs::scene(PICTURE, lights);
    let scenes = sizes.iter().map(scene).collect::<Result<Vec<_>, _>>()?;
    let name = "a picture of 320 x 240 and 13 objects";
    Ok(Sweep::new("lights", name, "ms", renders(sizes, &scenes)))
}

/// One picture with 1 thread and with 2, in turns.
pub(super) fn threads() -> Result<Vec<Threads>, String> {
    /// Rounds, as the wall's clock is another program's as well.
    const ROUNDS: usize = 11;
    const MANY: [usize; 2] = [1, 2];
    eprintln!("threads");
    let scene = inputs::scene((640, 480), 4)?;
    let pools = MANY.iter().map(|&n| pool(n)).collect::<Result<Vec<_>, _>>()?;
    let mut rounds: Vec<Vec<(f64, f64)>> = vec![Vec::new(); MANY.len()];
    for _ in 0..ROUNDS {
        for (pool, turns) in pools.iter().zip(&mut rounds) {
            let (_, wall, processor) = wall_and_processor(|| pool.install(|| sum(&scene)));
            turns.push((wall, processor));
        }
    }
    let of = |turns: &[(f64, f64)], value: fn(&(f64, f64)) -> f64| {
        Spread::of(&turns.iter().map(value).collect::<Vec<_>>())
    };
    let result = |(&count, turns): (&usize, &Vec<(f64, f64)>)| {
        // Each turn beside that of one thread in the same round.
        let beside = |ratio: fn(&(f64, f64), &(f64, f64)) -> f64| {
            let ratios = rounds[0].iter().zip(turns).map(|(one, these)| ratio(one, these));
            Spread::of(&ratios.collect::<Vec<_>>())
        };
        Threads {
            count,
            wall: of(turns, |turn| turn.0),
            processor: of(turns, |turn| turn.1),
            speedup: beside(|one, these| one.0 / these.0),
            overhead: beside(|one, these| these.1 / one.1),
        }
    };
    Ok(MANY.iter().zip(&rounds).map(result).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sweep_has_a_time_for_each_size() {
        let sweeps = all(&|sizes| sizes[..2].to_vec()).unwrap();
        assert_eq!(sweeps.len(), 9);
        for sweep in &sweeps {
            assert_eq!(sweep.points.len(), 2, "{}", sweep.name);
            assert!(sweep.points.iter().all(|p| p.time.median > 0.0), "{}", sweep.name);
            assert!(sweep.slope.is_some(), "{}", sweep.name);
        }
        let pixels = sweeps.iter().find(|sweep| sweep.over == "pixels").unwrap();
        assert!(pixels.slope.unwrap() > 0.5, "{pixels:?}");
    }
}
