//! What a check may leave unrendered: proofs that it never costs a verdict.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use conformance::{SQUARE, Scratch};
use harness::recheck::{AUDIT_ONE_IN, recheck};
use harness::store;
use harness::suite::Suite;
use harness::verdict::{Origin, Outcome};

/// So many that most are skipped while a few are audited.
const COUNT: usize = 2 * AUDIT_ONE_IN;

fn names() -> Vec<String> {
    (0..COUNT).map(|i| format!("f{i:02}")).collect()
}

/// Blessed fixtures that a first check has recorded as matches.
fn recorded() -> Scratch {
    let names = names();
    let fixtures: Vec<_> = names.iter().map(|name| (name.as_str(), SQUARE)).collect();
    let scratch = Scratch::blessed(&fixtures);
    assert_eq!(origins(&check(&scratch, 0)), [COUNT, 0, 0, 0], "a first check");
    scratch
}

fn check(scratch: &Scratch, seed: u64) -> Vec<Outcome> {
    let selection = scratch.suite().select(&[]).unwrap();
    recheck(scratch.suite(), &selection, seed, &|_| ()).unwrap().outcomes
}

/// How many were rendered, unchanged, audited and belied.
fn origins(outcomes: &[Outcome]) -> [usize; 4] {
    [Origin::Rendered, Origin::Unchanged, Origin::Audited, Origin::Belied]
        .map(|origin| outcomes.iter().filter(|outcome| outcome.origin == origin).count())
}

/// All but matches, by name.
fn failures(outcomes: &[Outcome]) -> BTreeMap<&str, &'static str> {
    let verdicts = outcomes.iter().map(|o| (o.name.as_str(), o.verdict.id()));
    verdicts.filter(|(_, verdict)| *verdict != "match").collect()
}

fn record(scratch: &Scratch) -> Option<String> {
    let bytes = store::read(&scratch.suite().record_path(), 1 << 20).unwrap()?;
    Some(String::from_utf8(bytes).unwrap())
}

fn set_record(scratch: &Scratch, text: &str) {
    store::write(&scratch.suite().record_path(), text.as_bytes()).unwrap();
}

#[test]
fn what_is_unchanged_is_judged_and_a_few_are_rendered_all_the_same() {
    let scratch = recorded();
    let mut audited = BTreeSet::new();
    for seed in 0..300 {
        let outcomes = check(&scratch, seed);
        assert_eq!(origins(&outcomes), [0, COUNT - 2, 2, 0]);
        assert_eq!(failures(&outcomes), BTreeMap::new());
        assert_eq!(outcomes.iter().map(|o| &o.name).collect::<Vec<_>>(), Vec::from_iter(&names()));
        let is_audited = |o: &Outcome| o.origin == Origin::Audited;
        audited.extend(outcomes.into_iter().filter(is_audited).map(|o| o.name));
    }
    assert_eq!(audited.len(), COUNT, "every fixture has its turn");
}

/// After a change, how many fixtures are rendered for it, and the failures.
#[track_caller]
fn after(change: impl Fn(&Scratch), rendered: usize, expected: &[(&str, &'static str)]) {
    let scratch = recorded();
    change(&scratch);
    let outcomes = check(&scratch, 7);
    assert_eq!(failures(&outcomes), expected.iter().copied().collect());
    assert_eq!(outcomes.iter().filter(|o| o.origin == Origin::Rendered).count(), rendered);
    let again = check(&scratch, 8);
    assert_eq!(failures(&again), expected.iter().copied().collect(), "a second time");
}

#[test]
fn every_change_is_seen() {
    let golden = |s: &Scratch| s.suite().golden_path("f05");
    after(|s| s.set_fixture("f05", &format!("// why\n{SQUARE}")), 1, &[]);
    let moved = SQUARE.replace("(-1, -1, -1)", "(-1, -1, -2)");
    after(|s| s.set_fixture("f05", &moved), 1, &[("f05", "stale_golden")]);
    let stricter = SQUARE.replace("pixels: 64", "pixels: 65");
    after(|s| s.set_fixture("f05", &stricter), 1, &[("f05", "expectation_failed")]);
    after(|s| s.set_fixture("f05", "()"), 1, &[("f05", "render_refused")]);
    after(|s| _ = store::remove(&golden(s)), 1, &[("f05", "missing_golden")]);
    after(
        |s| {
            let mut bytes = s.golden("f06");
            bytes.pop();
            s.set_golden("f05", &bytes);
        },
        1,
        &[("f05", "unreadable")],
    );
    // Under another name, an orphan is left and a golden is missing.
    after(
        |s| {
            s.set_fixture("g05", SQUARE);
            let _ = store::remove(&s.suite().fixture_path("f05"));
        },
        // The orphan is judged without a picture.
        2,
        &[("f05", "orphan_golden"), ("g05", "missing_golden")],
    );
}

#[test]
fn a_file_that_scenes_name_is_seen_by_those_and_no_others() {
    const SHAPE: &str = "Box(min: (-1, -1, -1), max: (1, 1, 1))";
    const MESH: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
    let with = |mesh: &str| SQUARE.replace(SHAPE, &format!("Mesh(file: \"{mesh}\")"));
    let (a, b) = (with("a.obj"), with("b.obj"));
    let scratch =
        Scratch::blessed(&[("a1", &a), ("a2", &a), ("b1", &b), ("c1", SQUARE), ("c2", SQUARE)]);
    let set = |mesh: &str, text: &str| {
        let path = scratch.suite().root().join("fixtures").join(mesh);
        store::write(&path, text.as_bytes()).unwrap();
    };
    set("a.obj", MESH);
    set("b.obj", MESH);
    let selection = scratch.suite().select(&[]).unwrap();
    harness::bless::bless(scratch.suite(), &selection, false).unwrap();
    assert_eq!(origins(&check(&scratch, 0)), [5, 0, 0, 0]);
    assert_eq!(origins(&check(&scratch, 1)), [0, 4, 1, 0]);
    // Another content of the same size.
    set("a.obj", &MESH.replace("v 1 1 0", "v 1 0 0"));
    let outcomes = check(&scratch, 2);
    let rendered = outcomes.iter().filter(|o| o.origin == Origin::Rendered);
    assert_eq!(rendered.map(|o| o.name.as_str()).collect::<Vec<_>>(), ["a1", "a2"]);
    assert_eq!(failures(&outcomes), [("a1", "stale_golden"), ("a2", "stale_golden")].into());
    set("a.obj", MESH);
    store::remove(&scratch.suite().root().join("fixtures/b.obj")).unwrap();
    assert_eq!(failures(&check(&scratch, 3)), [("b1", "render_refused")].into());
}

#[test]
fn a_record_that_cannot_be_believed_is_none() {
    let scratch = recorded();
    let good = record(&scratch).unwrap();
    let other = |from: &str| {
        assert!(good.contains(from), "{from}");
        good.replacen(from, "\"x", 1)
    };
    let root = format!("{:?}", scratch.suite().root().canonicalize().unwrap());
    let program = good.split("\"program\": ").nth(1).unwrap().split(',').next().unwrap();
    let bad = [
        String::new(),
        good[..good.len() / 2].to_owned(),
        good[..good.len() - 1].to_owned(),
        good.replacen("\"schema\": 1", "\"schema\": 2", 1),
        good.replacen(&root, "\"/elsewhere\"", 1),
        good.replacen(program, "\"another\"", 1),
        other("\"sources"),
        "[]".to_owned(),
    ];
    for bad in bad {
        assert_ne!(bad, good);
        set_record(&scratch, &bad);
        assert_eq!(origins(&check(&scratch, 0)), [COUNT, 0, 0, 0], "{bad:.200}");
        assert_eq!(record(&scratch).unwrap(), good, "it is written anew");
    }
}

#[test]
fn a_record_that_lies_is_removed_and_everything_rendered() {
    let scratch = recorded();
    // Every golden is replaced by one that is no match of any fixture, and the
    // record says that they are.
    let hash = |text: &str| text.split("\"golden\": ").nth(1).unwrap()[..34].to_owned();
    let before = hash(&record(&scratch).unwrap());
    let larger = SQUARE.replace("(-1, -1, -1)", "(-1, -1, -2)");
    let other = Scratch::blessed(&[("a", &larger)]);
    for name in names() {
        scratch.set_golden(&name, &other.golden("a"));
    }
    other.set_fixture("a", &larger);
    check(&other, 0);
    let after = hash(&record(&other).unwrap());
    set_record(&scratch, &record(&scratch).unwrap().replace(&before, &after));

    let outcomes = check(&scratch, 0);
    assert_eq!(origins(&outcomes), [COUNT - 2, 0, 0, 2]);
    assert_eq!(failures(&outcomes).len(), COUNT, "all are said, not only the audited");
    let belied = outcomes.iter().find(|o| o.origin == Origin::Belied).unwrap();
    assert!(belied.findings.last().unwrap().contains("record of matches"), "{belied:?}");
    assert_eq!(record(&scratch), None);
    assert_eq!(origins(&check(&scratch, 0)), [COUNT, 0, 0, 0]);
}

#[test]
fn only_matches_are_recorded_and_others_are_rendered_each_time() {
    let scratch = recorded();
    let selection = |filter: &str| scratch.suite().select(&[filter.to_owned()]).unwrap();
    let golden = scratch.golden("f05");
    store::remove(&scratch.suite().golden_path("f05")).unwrap();
    for _ in 0..2 {
        assert_eq!(origins(&check(&scratch, 0))[0], 1);
    }
    // A check of one fixture leaves the record of the others.
    scratch.set_golden("f05", &golden);
    let one = recheck(scratch.suite(), &selection("f05"), 0, &|_| ()).unwrap().outcomes;
    assert_eq!(origins(&one), [1, 0, 0, 0]);
    assert_eq!(origins(&check(&scratch, 0)), [0, COUNT - 2, 2, 0]);
    assert_eq!(Suite::RECORD, "target/goldray-cache/matches.json");
}

#[test]
fn a_record_that_cannot_be_kept_costs_no_verdict() {
    let in_the_way = |path: &str, put: fn(&Path), found: &str| {
        let scratch = Scratch::blessed(&[("a", SQUARE), ("b", SQUARE)]);
        store::remove(&scratch.suite().golden_path("b")).unwrap();
        put(&scratch.folder().join(path));
        let selection = scratch.suite().select(&[]).unwrap();
        for _ in 0..2 {
            let judged = recheck(scratch.suite(), &selection, 0, &|_| ()).unwrap();
            assert_eq!(failures(&judged.outcomes), [("b", "missing_golden")].into());
            assert_eq!(origins(&judged.outcomes), [2, 0, 0, 0]);
            let why = judged.unkept.unwrap().to_string();
            assert!(why.contains(found), "{why}");
        }
    };
    in_the_way("target/goldray-cache", |path| store::write(path, b"").unwrap(), "goldray-cache");
    in_the_way(Suite::RECORD, |path| store::write(&path.join("x"), b"").unwrap(), "is no file");
    #[cfg(unix)]
    {
        let link = |path: &Path| {
            let suite = path.parent().and_then(Path::parent).unwrap();
            store::write(&suite.join("theirs/x"), b"").unwrap();
            store::write(&suite.join("target/x"), b"").unwrap();
            std::os::unix::fs::symlink(suite.join("theirs"), path).unwrap();
        };
        in_the_way("target/goldray-cache", link, "is a link");
    }
    let scratch = recorded();
    let selection = scratch.suite().select(&[]).unwrap();
    assert!(recheck(scratch.suite(), &selection, 0, &|_| ()).unwrap().unkept.is_none());
}
