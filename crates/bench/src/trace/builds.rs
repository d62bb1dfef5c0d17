//! What building costs: CPU time on one thread and on two, and the bytes that
//! are kept.
//!
//! A thread that waits for another may do so busily: with a core to spare,
//! Embree 4 on one thread was seen to take twice the wall's time of the
//! processor's. So it is the busiest thread's time that is compared.

use super::engine::{Libraries, SHARING};
use super::report::Build;
use super::threads::taken;
use crate::measure::{Spread, wall_and_processor};
use crate::meshes::SceneMesh;

/// Threads that are built with.
const THREADS: [usize; 2] = [1, 2];
const MILLI: f64 = 1e-3;

/// What one build took, in milliseconds, and keeps, in bytes.
struct Built {
    busiest: f64,
    all: f64,
    wall: f64,
    bytes: usize,
}

/// Builds each engine's hierarchy `reps` times after a first one that is not
/// counted, with each number of threads, by turns. What cannot be built is left
/// out, as is what builds on one thread only where two are asked for.
pub(crate) fn measure(
    scene: &SceneMesh,
    names: &[&'static str],
    libraries: &Libraries,
    reps: usize,
) -> Vec<Build> {
    let own = names.iter().filter(|name| !SHARING.contains(name));
    let subjects: Vec<_> = own.flat_map(|&name| THREADS.map(|threads| (name, threads))).collect();
    let mut found: Vec<Vec<Built>> = subjects.iter().map(|_| Vec::new()).collect();
    // The first repetition warms up.
    for rep in 0..=reps {
        for turn in 0..subjects.len() {
            let number = (turn + rep) % subjects.len();
            let (name, threads) = subjects[number];
            let built = build(scene, name, threads, libraries);
            found[number].extend(built.filter(|_| rep > 0));
        }
    }
    let triangles = scene.mesh.faces.len();
    let built = subjects.into_iter().zip(found).filter_map(|((name, threads), found)| {
        let of =
            |value: fn(&Built) -> f64| Spread::of(&found.iter().map(value).collect::<Vec<_>>());
        let ms = of(|built| built.busiest);
        Some(Build {
            scene: scene.name.clone(),
            triangles,
            engine: name.to_owned(),
            threads,
            ms: ms.median,
            spread: [ms.low, ms.high],
            all_threads_ms: of(|built| built.all).median,
            wall_ms: of(|built| built.wall).median,
            bytes_per_triangle: found.last()?.bytes as f64 / triangles as f64,
        })
    });
    built.collect()
}

/// Builds once. A library counts its own bytes; what is built in Rust is seen
/// by this program's allocator, and its input, which it may keep, is made by
/// `prepare`.
fn build(scene: &SceneMesh, name: &str, threads: usize, libraries: &Libraries) -> Option<Built> {
    let before = crate::ALLOCATOR.allocated();
    let job = libraries.prepare(name, threads, &scene.mesh).ok()?;
    let ((engine, wall, _), taken) = taken(|| wall_and_processor(job));
    let engine = engine.ok()?;
    let kept = crate::ALLOCATOR.allocated().saturating_sub(before);
    Some(Built {
        busiest: taken.busiest / MILLI,
        all: taken.all / MILLI,
        wall: wall / MILLI,
        bytes: engine.bytes().unwrap_or(kept),
    })
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
