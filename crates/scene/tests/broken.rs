//! A folder of broken files, each with the message that people see.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;

use scene::{Unchecked, load, report};
use tracer::accel::Build;

/// Everything that is said about a file of `tests/broken`.
fn problems_of(name: &str, text: &str) -> String {
    let files = BTreeMap::from([
        ("bad.obj".to_owned(), b"v 0 0 0\nv 1 0\nf 1 2 3\n".to_vec()),
        ("empty.obj".to_owned(), b"# nothing\n".to_vec()),
        ("scene.gltf".to_owned(), b"{}".to_vec()),
    ]);
    let problems = load::<Unchecked>(text, &files, Build::Bvh).unwrap_err();
    report(name, text, &problems)
}

macro_rules! broken {
    ($($test:ident: $file:literal,)*) => {$(
        #[test]
        fn $test() {
            let text = include_str!(concat!("broken/", $file));
            insta::assert_snapshot!($file, problems_of($file, text));
        }
    )*};
}

broken! {
    numbers_that_make_no_sense: "numbers.ron",
    names_that_are_not_known: "names.ron",
    names_that_are_given_twice: "given-twice.ron",
    slips_of_the_hand: "syntax.ron",
    files_and_sizes: "files.ron",
    a_file_cut_short: "cut-short.ron",
    samplers_and_filters: "sampling.ron",
    numbers_of_samples_and_radii: "samples.ron",
    shares_and_indices: "mirrors.ron",
    samples_beside_an_error: "samples-and-error.ron",
}

#[test]
fn a_file_that_is_too_large_is_not_read() {
    let text = " ".repeat(scene::MAX_SCENE_BYTES + 1);
    let problems = load::<Unchecked>(&text, &scene::NoAssets, Build::Bvh).unwrap_err();
    assert_eq!(problems.len(), 1);
    assert!(problems[0].message.contains("at most"), "{problems:?}");
}

#[test]
fn nesting_has_an_end() {
    let mut text = "(version: 1, image: (4, 4), camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), \
                    fov_deg: 40), objects: ["
        .to_owned();
    text += &"Group(objects: [".repeat(50_000);
    let problems = load::<Unchecked>(&text, &scene::NoAssets, Build::Bvh).unwrap_err();
    assert!(problems.iter().any(|p| p.message.contains("nested")), "{problems:?}");
}
