//! What building costs: CPU time on one thread and on two, and the bytes that
//! are kept.

use super::engine::{Libraries, SHARING};
use super::report::Build;
use crate::measure::{Spread, wall_and_processor};
use crate::meshes::SceneMesh;

/// Threads that are built with.
const THREADS: [usize; 2] = [1, 2];
const MILLI: f64 = 1e-3;

/// Builds each engine's hierarchy `reps` times after a first
/// one that is not counted, with each number of threads, by
/// turns. What cannot be built is left out, as is what builds on one thread
/// only where two are asked for.
pub(crate) fn measure(
    scene: &SceneMesh,
    names: &[&'static str],
    libraries: &Libraries,
    reps: usize,
) -> Vec<Build> {
    let own = names.iter().filter(|name| !SHARING.contains(name));
    let subjects: Vec<_> = own.flat_map(|&name| THREADS.map(|threads| (name, threads))).collect();
    let mut found = vec![(Vec::new(), Vec::new(), 0); subjects.len()];
    // The first repetition warms up.
    for rep in 0..=reps {
        for turn in 0..subjects.len() {
            let number = (turn + rep) % subjects.len();
            let (name, threads) = subjects[number];
            if let Some((ms, wall_ms, bytes)) = build(scene, name, threads, libraries) {
                found[number].2 = bytes;
                if rep > 0 {
                    found[number].0.push(ms);
                    found[number].1.push(wall_ms);
                }
            }
        }
    }
    let triangles = scene.mesh.faces.len();
    let built =
        subjects.into_iter().zip(found).filter_map(|((name, threads), (ms, wall_ms, bytes))| {
            let found = (!ms.is_empty()).then(|| Spread::of(&ms))?;
            Some(Build {
                scene: scene.name.clone(),
                triangles,
                engine: name.to_owned(),
                threads,
                ms: found.median,
                spread: [found.low, found.high],
                wall_ms: Spread::of(&wall_ms).median,
                bytes_per_triangle: bytes as f64 / triangles as f64,
            })
        });
    built.collect()
}

/// Builds once: milliseconds of CPU and of the wall's clock, and the bytes kept. A library counts its own;
/// what is built in Rust is seen by this program's allocator, and its input,
/// which it may keep, is made by `prepare`.
fn build(
    scene: &SceneMesh,
    name: &str,
    threads: usize,
    libraries: &Libraries,
) -> Option<(f64, f64, usize)> {
    let before = crate::ALLOCATOR.allocated();
    let job = libraries.prepare(name, threads, &scene.mesh).ok()?;
    let (engine, wall, cpu) = wall_and_processor(job);
    let engine = engine.ok()?;
    let kept = crate::ALLOCATOR.allocated().saturating_sub(before);
    Some((cpu / MILLI, wall / MILLI, engine.bytes().unwrap_or(kept)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meshes;

    #[test]
    fn a_mesh_takes_at_least_its_corners_and_faces() {
        // Three numbers of 4 bytes for each triangle, and of 8 for each corner
        // of which there are half as many.
        const AT_LEAST: f64 = 24.0;
        const AT_MOST: f64 = 1000.0;
        let scene = meshes::named("bumpy-10000").unwrap().unwrap();
        let names = ["goldray-accurate", "goldray-accurate-single"];
        let built = measure(&scene, &names, &Libraries::open(), 2);
        let threads: Vec<_> = built.iter().map(|build| build.threads).collect();
        assert_eq!(threads, THREADS, "one that shares is not built again");
        for build in built {
            assert!(build.spread[0] > 0.0 && build.spread[0] <= build.ms);
            let bytes = build.bytes_per_triangle;
            assert!(AT_LEAST < bytes && bytes < AT_MOST, "{bytes}");
        }
    }
}
