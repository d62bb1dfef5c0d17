//! Nothing but the scene decides a picture: not the number of threads, not
//! the accelerator, not the run, not the compiler or the processor.
#![allow(clippy::unwrap_used)]

use conformance::repository_suite;
use harness::fixture::{Build, Fixture};
use harness::suite::Suite;
use harness::{counts, digest};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use tracer::{Interval, LinearImage, Scene, Size, pixel_center};

/// Every fixture's linear picture, made on this many threads.
fn pictures(threads: usize) -> Vec<(String, LinearImage)> {
    let suite = repository_suite();
    let names = suite.select(&[]).unwrap().fixtures;
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let render = |name: String| {
        let label = Suite::fixture_label(&name);
        let fixture = Fixture::open(&label, &suite.fixture_path(&name), Build::Bvh).unwrap();
        let picture = fixture.render_linear();
        (name, picture)
    };
    pool.install(|| names.into_iter().map(render).collect())
}

#[track_caller]
fn assert_same_bits(one: &[(String, LinearImage)], other: &[(String, LinearImage)]) {
    assert_eq!(one.len(), other.len());
    for ((name, one), (_, other)) in one.iter().zip(other) {
        let bits = |picture: &LinearImage| {
            let channels = picture.pixels().iter().flat_map(|p| p.channels());
            channels.map(f64::to_bits).collect::<Vec<_>>()
        };
        assert!(bits(one) == bits(other), "{name}");
    }
}

#[test]
fn threads_and_runs_do_not_matter() {
    let one = pictures(1);
    for threads in [1, 2, 7] {
        assert_same_bits(&one, &pictures(threads));
    }
}

/// The table is the same for every target that runs this test, debug and
/// release; `.ci/digests` asks the same of others.
#[test]
fn every_picture_has_the_bits_of_the_table() {
    let suite = repository_suite();
    let names = suite.select(&[]).unwrap().fixtures;
    let table = digest::read_table(&suite).unwrap().unwrap();
    let today = digest::of_fixtures(&suite, &names, &|_| ());
    let today = today.into_iter().map(|(name, digest)| (name, digest.unwrap())).collect();
    let differences = digest::differences(&table, &names, &today);
    let lines: Vec<_> = differences.iter().map(ToString::to_string).collect();
    assert!(lines.is_empty(), "{}\nif meant: cargo xtask digest --write", lines.join("\n"));
}

#[test]
fn skipping_does_not_matter() {
    let suite = repository_suite();
    let names = suite.select(&[]).unwrap().fixtures;
    let pairs = counts::with_and_without(&suite, &names, &|_| ()).unwrap();
    let other: Vec<_> = pairs.iter().filter(|pair| !pair.same_bits).map(|p| &p.scene).collect();
    assert!(other.is_empty(), "{other:?}");
    // It would not matter either if nothing were skipped.
    let tests = |counts: &counts::ByName| -> u64 {
        counts.iter().filter(|(name, _)| name.ends_with("_tests")).map(|(_, n)| n).sum()
    };
    for pair in &pairs {
        assert!(tests(&pair.with) <= tests(&pair.without), "{}", pair.scene);
    }
    let with: u64 = pairs.iter().map(|pair| tests(&pair.with)).sum();
    let without: u64 = pairs.iter().map(|pair| tests(&pair.without)).sum();
    assert!(10 * with < 9 * without, "{with} of {without} tests are left");
}

#[test]
fn the_accelerator_does_not_matter() {
    let suite = repository_suite();
    let names = suite.select(&[]).unwrap().fixtures;
    names.into_par_iter().for_each(|name| {
        let scene = |build| {
            let label = Suite::fixture_label(&name);
            Fixture::open(&label, &suite.fixture_path(&name), build).unwrap().scene
        };
        let (bvh, list) = (scene(Build::Bvh), scene(Build::List));
        let Size { width, height } = bvh.size();
        let camera = bvh.camera();
        for j in 0..height {
            // A sprinkling of pixels: the list needs thousands of tests a ray.
            for i in (0..width).filter(|i| (i + 3 * j) % 11 == 0) {
                let a = pixel_center(i, width, camera.view_width());
                let b = pixel_center(j, height, camera.view_height());
                let ray = camera.ray(a, b);
                let color = |scene: &Scene| scene.trace(&ray, Interval::AHEAD);
                assert_eq!(color(&bvh), color(&list), "{name} ({i}, {j})");
            }
        }
    });
}
