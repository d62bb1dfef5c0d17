//! One body in every format gives one picture, to the bit.

use std::collections::BTreeMap;

use scene::format::Show;

use super::super::{gltf, obj, ply, stl};
use super::*;

/// The body in every format that holds it, with names that tell the format.
pub(super) fn files(has_normals: bool) -> Vec<(&'static str, Vec<u8>)> {
    let mut files = vec![
        ("a.obj", obj::tests::sample(has_normals).into_bytes()),
        ("a.ply", ply::tests::sample(ply::tests::Stored::Text, has_normals)),
        ("b.ply", ply::tests::sample(ply::tests::Stored::Little, has_normals)),
        ("c.ply", ply::tests::sample(ply::tests::Stored::Big, has_normals)),
        ("a.gltf", gltf::tests::text(gltf::tests::sample(has_normals)).into_bytes()),
        ("a.glb", gltf::tests::glb(&gltf::tests::sample(has_normals))),
    ];
    if !has_normals {
        files.push(("a.stl", stl::tests::text().into_bytes()));
        files.push(("b.stl", stl::tests::binary("solid")));
    }
    files
}

/// What the picture shows of a file.
fn shown(name: &str, bytes: &[u8], assets: &dyn Assets, show: Show) -> (Imported, LinearImage) {
    let mut imported = import(Source { name, bytes }, &Wishes::default(), assets).unwrap();
    imported.scene.show = show;
    let picture = picture(&imported);
    (imported, picture)
}

#[test]
fn all_formats_give_the_same_picture() {
    for show in [Show::Normals, Show::Silhouette, Show::Depth { near: 1.0, far: 9.0 }] {
        for has_normals in [false, true] {
            let none = BTreeMap::new();
            let pictures: Vec<_> = files(has_normals)
                .iter()
                .map(|(name, bytes)| (*name, shown(name, bytes, &none, show).1))
                .collect();
            for (name, picture) in &pictures[1..] {
                assert!(*picture == pictures[0].1, "{name} differs in {show:?}");
            }
        }
    }
}

#[test]
fn what_was_imported_is_imported_again_as_it_is() {
    for has_normals in [false, true] {
        for (name, bytes) in files(has_normals) {
            let (first, picture) = shown(name, &bytes, &BTreeMap::new(), Show::Normals);
            for (mesh, text) in &first.files {
                let (again, same) = shown(mesh, text, &BTreeMap::new(), Show::Normals);
                assert_eq!(again.files.values().next(), Some(text), "{name}");
                assert!(same == picture, "{name}");
            }
        }
    }
}

#[test]
fn other_files_are_refused() {
    for name in ["a.blend", "a", ""] {
        let result = import(Source { name, bytes: b"" }, &Wishes::default(), &scene::NoAssets);
        check_refused(&result, "expected a file that ends in ");
    }
}

#[test]
fn everything_is_in_view() {
    for image in [(40, 10), (10, 40), (20, 20)] {
        let text = "v -3 0 0\nv 5 1 0\nv 0 9 2\nf 1 2 3\nf 3 2 1\n";
        let wishes = Wishes { image: Some(image), ..Wishes::default() };
        let source = Source { name: "a.obj", bytes: text.as_bytes() };
        let mut imported = import(source, &wishes, &scene::NoAssets).unwrap();
        imported.scene.show = Show::Silhouette;
        let text = scene::write(&imported.scene).unwrap();
        let loaded = scene::load::<Unchecked>(&text, &imported.files, Build::Bvh).unwrap();
        let picture = tracer::render(&loaded.scene);
        let is_seen = |x, y| picture.get(x, y).unwrap().channels() != [0.0; 3];
        let (w, h) = image;
        let rim = (0..w).flat_map(|x| [(x, 0), (x, h - 1)]);
        let rim = rim.chain((0..h).flat_map(|y| [(0, y), (w - 1, y)]));
        assert!(!rim.into_iter().any(|(x, y)| is_seen(x, y)), "{image:?}: cut off");
        assert!((0..w).any(|x| (0..h).any(|y| is_seen(x, y))), "{image:?}: nothing");
    }
}

#[test]
fn the_shading_is_the_formats_unless_wished() {
    use scene::format::Shading::{Attenuated, Classic, Radiometric};
    for (name, bytes) in files(false) {
        let with = |shading| {
            let wishes = Wishes { shading, ..Wishes::default() };
            import(Source { name, bytes: &bytes }, &wishes, &scene::NoAssets).unwrap()
        };
        let own = if name.contains(".gl") { Radiometric } else { Classic };
        assert_eq!(with(None).scene.shading, own, "{name}");
        assert!(with(None).chosen.iter().any(|said| said.contains("shading")), "{name}");
        assert_eq!(with(Some(Attenuated)).scene.shading, Attenuated, "{name}");
    }
}
