//! Files that are cut anywhere or have any byte changed: a scene or an error, at
//! once.

use std::collections::BTreeMap;

use super::round_trip::files;
use super::*;

/// A library, and a buffer, beside the file.
fn assets() -> BTreeMap<String, Vec<u8>> {
    let library = super::super::obj::tests::LIBRARY.as_bytes().to_vec();
    BTreeMap::from([("lib.mtl".to_owned(), library)])
}

/// Either is fine, but not an error without a reason, nor a scene that panics.
#[track_caller]
fn check(name: &str, bytes: &[u8], assets: &dyn Assets) {
    match import(Source { name, bytes }, &Wishes::default(), assets) {
        Err(errors) => {
            assert!(!errors.is_empty(), "{name}");
            assert!(errors.iter().all(|error| !error.message.is_empty()), "{name}");
        }
        Ok(imported) => {
            let text = scene::write(&imported.scene).unwrap();
            // It may have no area, which reading tells.
            let _ = scene::load::<Unchecked>(&text, &imported.files, Build::List);
        }
    }
}

fn all_files() -> Vec<(&'static str, Vec<u8>)> {
    let mut all = files(true);
    all.extend(files(false));
    let mut rich = b"mtllib lib.mtl\nusemtl gloss\ns 1\n".to_vec();
    rich.extend(super::super::obj::tests::sample(true).bytes());
    rich.extend(b"usemtl red\nf 1 2 4 7 # x\\\nl 1 2\nf 1/ 2/ 3/\n");
    all.push(("rich.obj", rich));
    all
}

#[test]
fn files_cut_at_every_byte() {
    for (name, bytes) in all_files() {
        for end in 0..bytes.len() {
            check(name, &bytes[..end], &assets());
        }
    }
}

#[test]
fn libraries_cut_at_every_byte() {
    let whole = assets().remove("lib.mtl").unwrap();
    let text = b"mtllib lib.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl gloss\nf 1 2 3\n";
    for end in 0..whole.len() {
        let assets = BTreeMap::from([("lib.mtl".to_owned(), whole[..end].to_vec())]);
        check("a.obj", text, &assets);
    }
}

#[test]
fn files_with_any_bytes_changed() {
    let mut rng = fastrand::Rng::with_seed(11);
    let mut change = |bytes: &mut Vec<u8>| {
        for _ in 0..rng.usize(1..4) {
            let at = rng.usize(0..bytes.len());
            match rng.u8(0..4) {
                0 => bytes[at] = rng.u8(..),
                1 => bytes[at] ^= 1 << rng.u8(0..8),
                2 => bytes.insert(at, b"0123456789-./ \n{}[]\",:"[rng.usize(0..22)]),
                _ => drop(bytes.drain(at..(at + rng.usize(0..9)).min(bytes.len()))),
            }
        }
    };
    for (name, whole) in all_files() {
        for _ in 0..1_000 {
            let mut bytes = whole.clone();
            change(&mut bytes);
            check(name, &bytes, &assets());
        }
    }
    let whole = assets().remove("lib.mtl").unwrap();
    let text = b"mtllib lib.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl gloss\nf 1 2 3\n";
    for _ in 0..1_000 {
        let mut bytes = whole.clone();
        change(&mut bytes);
        check("a.obj", text, &BTreeMap::from([("lib.mtl".to_owned(), bytes)]));
    }
}

#[test]
fn random_bytes_of_every_name() {
    let mut rng = fastrand::Rng::with_seed(12);
    for name in ["a.obj", "a.ply", "a.stl", "a.gltf", "a.glb"] {
        for _ in 0..500 {
            let bytes: Vec<u8> = (0..rng.usize(0..200)).map(|_| rng.u8(..)).collect();
            check(name, &bytes, &scene::NoAssets);
        }
    }
}
