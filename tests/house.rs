//! The invariants of `ARCHITECTURE.md` that can be read off the sources.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use conformance::{repository, repository_suite};
use harness::fixture::{Build, Fixture};
use harness::metric::corpus;
use harness::relation::{self, Relation};
use harness::suite::Suite;
use harness::{golden, judge, picture, run, sample_mesh, sample_texture, template};

/// Every Rust file below a folder of the repository, with its text.
fn sources(folder: &str) -> Vec<(PathBuf, String)> {
    fn walk(folder: &Path, found: &mut Vec<(PathBuf, String)>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                // What is built of a workspace of its own is not ours to judge.
                if !path.ends_with("target") {
                    walk(&path, found);
                }
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                found.push((path.clone(), fs::read_to_string(&path).unwrap()));
            }
        }
    }
    let mut found = Vec::new();
    walk(&repository().join(folder), &mut found);
    assert!(!found.is_empty(), "{folder}");
    found.sort();
    found
}

fn all_sources() -> Vec<(PathBuf, String)> {
    ["crates", "xtask", "tests"].into_iter().flat_map(sources).collect()
}

/// The names under a heading of a manifest.
fn dependencies(manifest: &str, heading: &str) -> Vec<String> {
    let text = fs::read_to_string(repository().join(manifest)).unwrap();
    let lines = text.lines().skip_while(|line| *line != heading).skip(1);
    let lines = lines.take_while(|line| !line.starts_with('['));
    let name = |line: &str| line.split(['.', ' ', '=']).next().unwrap_or("").to_owned();
    lines.map(name).filter(|name| !name.is_empty()).collect()
}

#[test]
fn the_tracer_depends_on_nothing_that_does_io() {
    let found = dependencies("crates/tracer/Cargo.toml", "[dependencies]");
    assert_eq!(found, ["glam", "libm", "rayon"]);
}

#[test]
fn crates_import_only_downwards() {
    let ours = [
        "tracer",
        "scene",
        "interchange",
        "harness",
        "conform",
        "stress",
        "xtask",
        "xtask-stress",
        "conformance",
    ];
    let below = |manifest: &str| -> Vec<String> {
        let all = dependencies(manifest, "[dependencies]");
        all.into_iter().filter(|name| ours.contains(&name.as_str())).collect()
    };
    assert_eq!(below("crates/tracer/Cargo.toml"), [""; 0]);
    assert_eq!(below("crates/scene/Cargo.toml"), ["tracer"]);
    assert_eq!(below("crates/harness/Cargo.toml"), ["scene", "tracer"]);
    assert_eq!(below("crates/interchange/Cargo.toml"), ["scene", "tracer"]);
    assert_eq!(below("crates/conform/Cargo.toml"), ["harness", "interchange", "scene", "tracer"]);
    assert_eq!(below("crates/stress/Cargo.toml"), ["tracer"]);
    assert_eq!(below("xtask/Cargo.toml"), ["conform", "harness", "interchange"]);
    assert_eq!(below("xtask/stress/Cargo.toml"), ["harness", "stress", "xtask"]);
}

#[test]
fn one_file_opens_files() {
    for (path, text) in ["crates", "xtask/src", "xtask/stress/src"].into_iter().flat_map(sources) {
        let stores = ["crates/harness/src/store.rs", "crates/bench/src/files.rs"];
        let is_store = stores.iter().any(|store| path.ends_with(store));
        let opens = ["std::fs", "fs::read", "fs::write", "File::open"];
        let found = opens.iter().find(|opens| text.contains(**opens));
        assert!(is_store || found.is_none(), "{} says {found:?}", path.display());
    }
}

#[test]
fn every_file_says_what_it_is_and_is_one_idea_long() {
    for (path, text) in all_sources() {
        assert!(text.starts_with("//! "), "{}: expected `//! ` at the start", path.display());
        let lines = text.lines().count();
        assert!(lines <= 420, "{}: {lines} lines", path.display());
    }
}

/// What only the tracer's module of vectors may say, and where the bench calls
/// Embree.
const UNSAFE: &str = "unsafe ";
const MAY_BE_UNSAFE: [&str; 2] =
    ["crates/tracer/src/simd/", "crates/bench/src/trace/embree/api.rs"];

#[test]
fn nothing_is_unfinished_ignored_or_unsafe() {
    // Put together, so that this file does not name them.
    let words = ["todo!", "unimplemented!", "dbg!", "#[ignore", "FIXME", "XXX"];
    for (path, text) in all_sources() {
        if path.ends_with("tests/house.rs") {
            continue;
        }
        let found = words.iter().find(|word| text.contains(**word));
        assert!(found.is_none(), "{} says {found:?}", path.display());
        let may_be_unsafe = MAY_BE_UNSAFE.iter().any(|part| path.to_string_lossy().contains(part));
        assert!(may_be_unsafe || !text.contains(UNSAFE), "{} says {UNSAFE}", path.display());
    }
}

#[test]
fn the_contact_sheet_shows_the_goldens_of_today() {
    let suite = repository_suite();
    let golden = |name: String| {
        let found = run::find_golden(&suite.golden_path(&name));
        let picture = found.picture().cloned();
        let picture =
            picture.unwrap_or_else(|| panic!("no golden to draw: cargo xtask bless {name}"));
        (name, picture)
    };
    let pictures: Vec<_> = suite.select(&[]).unwrap().fixtures.into_iter().map(golden).collect();
    let committed = fs::read(repository().join("docs/contact-sheet.png")).unwrap();
    assert!(
        golden::from_png(&committed).unwrap().picture == picture::contact_sheet(&pictures),
        "docs/contact-sheet.png is out of date: cargo xtask contact-sheet"
    );
}

#[test]
fn the_sample_meshes_and_textures_are_what_the_code_makes() {
    let textures = sample_texture::sample_textures().unwrap();
    for (path, bytes) in sample_mesh::sample_meshes().into_iter().chain(textures) {
        let committed = fs::read(repository().join(path)).unwrap();
        assert!(committed == bytes, "{path} is out of date: cargo xtask meshes");
    }
}

#[test]
fn the_page_about_metrics_is_what_they_say() {
    let committed = fs::read_to_string(repository().join("docs/metrics.md")).unwrap();
    let command = "cargo xtask list --metrics --markdown > docs/metrics.md";
    assert!(committed == corpus::document(), "docs/metrics.md is out of date: {command}");
}

#[test]
fn the_fixtures_in_the_documents_are_good_and_keep_their_word() {
    for document in ["README.md", "docs/scene-format.md"] {
        let all = fs::read_to_string(repository().join(document)).unwrap();
        let text = all.split("```ron\n").nth(1).unwrap().split("```").next().unwrap();
        let files = std::collections::BTreeMap::new();
        let fixture = Fixture::read(document, text, &files, Build::Bvh).unwrap();
        assert!(!fixture.check.expect.is_empty(), "{document}");
        let picture = fixture.render().unwrap();
        assert_eq!(judge::broken_expectations(&fixture, &picture), [""; 0], "{document}");
        assert_eq!(relation::broken(&fixture, &picture), [""; 0], "{document}");
    }
}

#[test]
fn every_relation_is_asked_of_several_fixtures() {
    let suite = repository_suite();
    let mut counts = BTreeMap::new();
    for name in suite.select(&[]).unwrap().fixtures {
        let path = suite.fixture_path(&name);
        let fixture = Fixture::open(&Suite::fixture_label(&name), &path, Build::Bvh).unwrap();
        for relation in &fixture.check.relations {
            *counts.entry(relation.name()).or_insert(0) += 1;
        }
    }
    for name in Relation::NAMES {
        let found = counts.get(name).copied().unwrap_or(0);
        assert!(found >= 4, "{name}: expected four fixtures or more that say it, found {found}");
    }
}

#[test]
fn every_fixture_says_first_what_would_be_seen_if_it_broke() {
    let suite = repository_suite();
    for name in suite.select(&[]).unwrap().fixtures {
        let text = fs::read_to_string(suite.fixture_path(&name)).unwrap();
        let comment: String = text.lines().take_while(|line| line.starts_with("//")).collect();
        let letters = comment.chars().filter(|c| c.is_alphanumeric()).count();
        let is_template = template::TEMPLATE.starts_with(&comment);
        assert!(
            letters >= 60 && !is_template,
            "fixtures/{name}.ron: expected `//` lines at the top, of 60 letters or more, that say so"
        );
    }
}
