//! What is committed is what was proposed.

use super::*;
use crate::golden::from_png;
use crate::store;
use crate::template::TEMPLATE;

/// Two fixtures without goldens, and a golden without a fixture.
fn suite() -> (tempfile::TempDir, Suite) {
    let folder = tempfile::tempdir().unwrap();
    for file in ["fixtures/a.ron", "fixtures/b.ron"] {
        store::write(&folder.path().join(file), TEMPLATE.as_bytes()).unwrap();
    }
    store::write(&folder.path().join("golden/gone.png"), b"x").unwrap();
    let suite = Suite::open(folder.path()).unwrap();
    (folder, suite)
}

fn all(suite: &Suite) -> Proposals {
    propose(suite, &suite.select(&[]).unwrap(), true, &|_| ())
}

#[test]
fn a_golden_that_appears_changes_or_goes_in_between_stops_everything() {
    for (change, name, found) in [
        (Some(&b"other"[..]), "b", "b: the golden's file: expected none, found "),
        (Some(b"y"), "gone", "gone: the golden's file: expected "),
        (None, "gone", "gone: the golden's file: expected "),
    ] {
        let (_folder, suite) = suite();
        let proposals = all(&suite);
        let path = suite.golden_path(name);
        match change {
            Some(bytes) => store::write(&path, bytes).unwrap(),
            None => store::remove(&path).unwrap(),
        }
        let moved = commit(&suite, proposals).unwrap_err();
        assert_eq!(moved.len(), 1);
        assert!(moved[0].to_string().starts_with(found), "{}", moved[0]);
        assert!(!store::is_file(&suite.golden_path("a")), "nothing is written");
        assert_eq!(store::read(&path, 9).unwrap().as_deref(), change, "nor removed");
    }
}

#[test]
fn the_plan_has_the_hashes_of_what_is_written() {
    let (_folder, suite) = suite();
    let proposals = all(&suite);
    let plan = Plan::of(&proposals);
    let text = serde_json::to_vec(&plan).unwrap();
    assert_eq!(Plan::parse(&text).unwrap(), plan, "it comes back from its file");
    let again = propose_again(&suite, &plan, &|_| ()).unwrap();
    assert_eq!(again, proposals, "and proposes the same");
    let names: Vec<_> = commit(&suite, again).unwrap().into_iter().map(|b| b.0).collect();
    assert_eq!(names, ["a", "b", "gone"]);
    for step in &plan.goldens[..2] {
        let png = store::read(&suite.golden_path(&step.name), 1 << 20).unwrap().unwrap();
        let note = from_png(&png).unwrap().provenance.unwrap();
        assert_eq!(step.after, Some(crate::hash::content_hash(&png)));
        assert_eq!((&step.scene, &step.assets), (&Some(note.scene), &Some(note.assets)));
    }
    assert!(!store::is_file(&suite.golden_path("gone")));
}

#[test]
fn a_plan_may_say_which_objects_are_to_blame() {
    let (_folder, suite) = suite();
    let mut plan = Plan::of(&all(&suite));
    plan.goldens[0].blamed = Some(serde_json::json!(["objects[0]"]));
    let text = serde_json::to_vec(&plan).unwrap();
    assert_eq!(Plan::parse(&text).unwrap(), plan);
    assert!(propose_again(&suite, &plan, &|_| ()).is_ok(), "it decides nothing");
}
