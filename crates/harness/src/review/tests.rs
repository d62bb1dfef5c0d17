//! What is accepted is what was shown, and nothing is lost by it.

use std::collections::BTreeMap;
use std::path::Path;

use super::*;
use crate::bless::bless;
use crate::run::run;
use crate::store;
use crate::template::TEMPLATE;

/// A suite of one fixture of every kind: `added` has no golden, `broken` breaks
/// its word, `changed` has the golden of another scene, `gone` has no fixture,
/// `refused` is no scene, `same` is a match.
struct Reviewed {
    folder: tempfile::TempDir,
    suite: Suite,
    review: Review,
}

const ALL: [&str; 6] = ["added", "broken", "changed", "gone", "refused", "same"];

/// The template with another view.
fn other(image: &str) -> String {
    assert!(TEMPLATE.contains("image: (96, 72)"), "{TEMPLATE}");
    TEMPLATE.replace("image: (96, 72)", image)
}

fn judged(suite: &Suite) -> Vec<Outcome> {
    run(suite, &suite.select(&[]).unwrap(), &|_| ()).unwrap()
}

impl Reviewed {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| {
            store::write(&folder.path().join(format!("fixtures/{name}.ron")), text.as_bytes())
                .unwrap();
        };
        for name in ["changed", "gone", "same"] {
            write(name, &other("image: (16, 12)"));
        }
        let suite = Suite::open(folder.path()).unwrap();
        bless(&suite, &suite.select(&[]).unwrap(), false).unwrap();
        store::remove(&suite.fixture_path("gone")).unwrap();
        write("changed", &other("image: (20, 16)"));
        write("added", &other("image: (16, 12)"));
        write("refused", "()");
        let broken = other("image: (16, 12)").replace("rgb: (0.2,", "rgb: (0.9,");
        write("broken", &broken);
        let review = Review::new(&suite, &judged(&suite));
        Self { folder, suite, review }
    }

    fn write(&self, file: &str, bytes: &[u8]) {
        store::write(&self.folder.path().join(file), bytes).unwrap();
    }

    /// Every golden by its name.
    fn goldens(&self) -> BTreeMap<String, Vec<u8>> {
        let read = |name: String| {
            let bytes = read_golden(&self.suite.golden_path(&name)).unwrap().unwrap();
            (name, bytes)
        };
        store::names(Path::new(&self.suite.golden_folder()), "png")
            .unwrap()
            .into_iter()
            .map(read)
            .collect()
    }

    fn judge_again(&mut self) {
        let mut later = Review::new(&self.suite, &judged(&self.suite));
        later.inherit(&self.review);
        self.review = later;
    }

    fn decided(&self) -> Vec<(&str, Decision)> {
        let decided = |name: &&'static str| Some((*name, self.review.decision(name)?));
        ALL.iter().filter_map(decided).collect()
    }
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|&name| name.to_owned()).collect()
}

/// The goldens that differ, with whether each is there before and after.
fn changed(
    before: &BTreeMap<String, Vec<u8>>,
    after: &BTreeMap<String, Vec<u8>>,
) -> Vec<(String, bool, bool)> {
    let all: BTreeSet<_> = before.keys().chain(after.keys()).collect();
    let differs = all.into_iter().filter(|name| before.get(*name) != after.get(*name));
    differs.map(|n| (n.clone(), before.contains_key(n), after.contains_key(n))).collect()
}

#[test]
fn accepting_changes_one_golden_and_undoing_changes_it_back() {
    for (name, had, has) in [("added", false, true), ("changed", true, true), ("gone", true, false)]
    {
        let mut all = Reviewed::new();
        let before = all.goldens();
        assert!(all.review.can_accept(name));
        assert_eq!(all.review.accept(&names(&[name])), [""; 0]);
        assert_eq!(changed(&before, &all.goldens()), [(name.to_owned(), had, has)]);
        assert_eq!(all.decided(), [(name, Decision::Accepted)]);
        assert!(!all.review.can_accept(name) && all.review.wrote(name));
        assert_eq!(all.review.accept(&names(&[name])), [""; 0], "done is done");
        let verdict = judged(&all.suite).into_iter().find(|o| o.name == name).map(|o| o.verdict);
        assert_eq!(verdict, has.then_some(Verdict::Match));

        assert_eq!(all.review.undo(&names(&[name])), [""; 0]);
        assert_eq!(all.goldens(), before, "{name}: the very bytes");
        assert_eq!(all.decided(), []);
        assert!(all.review.can_accept(name), "{name}: as it was");
        assert_eq!(all.review.accept(&names(&[name])), [""; 0]);
        assert_eq!(all.review.reject(&names(&[name])), [""; 0]);
        assert_eq!(all.decided(), [(name, Decision::Rejected)]);
        assert_eq!(all.goldens(), before, "{name}: rejecting takes it back");
    }
}

#[test]
fn what_cannot_be_accepted_says_why_and_keeps_no_other() {
    let mut all = Reviewed::new();
    let before = all.goldens();
    let asked = names(&["../same", "added", "broken", "refused", "same"]);
    let said = all.review.accept(&asked);
    let begins = [
        "../same is not accepted: it is none of the fixtures",
        "broken is not accepted: ",
        "refused is not accepted: there is no picture",
        "same is not accepted: it is a match",
    ];
    assert_eq!(said.len(), begins.len(), "{said:?}");
    for (said, begin) in said.iter().zip(begins) {
        assert!(said.starts_with(begin), "{said}");
    }
    assert_eq!(changed(&before, &all.goldens()), [("added".to_owned(), false, true)]);
    assert_eq!(all.review.undo(&names(&["same"])).len(), 1);
    assert_eq!(all.review.reject(&names(&["same", "nowhere"])).len(), 2);
    assert_eq!(all.review.reject(&names(&["broken", "refused"])), [""; 0]);
    let tally = all.review.tally();
    assert_eq!(tally.to_string(), "1 accepted, 2 rejected, 2 left");
    assert_eq!(tally.left, ["changed", "gone"]);
    assert!(!tally.is_settled());
}

/// After this change, accepting the name is refused with these words, and writes
/// nothing.
#[track_caller]
fn moved(name: &str, change: impl Fn(&Reviewed), expected: &str) {
    let mut all = Reviewed::new();
    change(&all);
    let before = all.goldens();
    let said = all.review.accept(&names(&[name]));
    assert!(!said.is_empty(), "{name} was accepted");
    assert!(said.iter().any(|said| said.contains(expected)), "{said:?}");
    assert_eq!(all.goldens(), before);
    assert_eq!(all.decided(), []);
}

#[test]
fn what_moved_since_it_was_shown_is_not_accepted() {
    let fixture = |name, text: String| {
        move |all: &Reviewed| all.write(&format!("fixtures/{name}.ron"), text.as_bytes())
    };
    moved(
        "changed",
        fixture("changed", other("image: (8, 6)")),
        "changed is not accepted: the scene and ",
    );
    moved(
        "changed",
        fixture("changed", "()".into()),
        "changed is not accepted: the verdict changed since it was shown",
    );
    moved(
        "gone",
        fixture("gone", other("image: (8, 6)")),
        "its fixture changed since it was shown",
    );
    for name in ["added", "changed", "gone"] {
        let golden = |all: &Reviewed| all.write(&format!("golden/{name}.png"), b"other");
        moved(name, golden, "the golden's file changed since it was shown; review it again");
    }
    let remove = |all: &Reviewed| store::remove(&all.suite.fixture_path("added")).unwrap();
    moved("added", remove, "added is not accepted: the verdict changed since it was shown");
}

#[test]
fn an_acceptance_that_somebody_wrote_over_is_not_taken_back() {
    let mut all = Reviewed::new();
    let accepted = names(&["added", "changed", "gone"]);
    assert_eq!(all.review.accept(&accepted), [""; 0]);
    for name in &accepted {
        all.write(&format!("golden/{name}.png"), b"other");
    }
    let before = all.goldens();
    assert_eq!(all.review.undo(&accepted).len(), 3);
    assert_eq!(all.review.reject(&accepted).len(), 3);
    assert_eq!(all.review.accept(&accepted).len(), 3, "nor is it said to be accepted");
    assert_eq!(all.goldens(), before);
    assert!(accepted.iter().all(|name| !all.review.wrote(name)));
}

#[test]
fn decisions_outlive_what_is_judged_later_where_they_still_hold() {
    let mut all = Reviewed::new();
    assert_eq!(all.review.accept(&names(&["added", "gone"])), [""; 0]);
    assert_eq!(all.review.reject(&names(&["changed"])), [""; 0]);
    all.judge_again();
    let kept = [
        ("added", Decision::Accepted),
        ("changed", Decision::Rejected),
        ("gone", Decision::Accepted),
    ];
    assert_eq!(all.decided(), kept);
    assert!(!all.review.wrote("added"), "it was judged since");
    assert_eq!(all.review.undo(&names(&["added"])), [""; 0]);
    assert!(!all.goldens().contains_key("added"));
    assert!(!all.review.wrote("added"), "it was said to be a match");

    all.write("fixtures/changed.ron", other("image: (8, 6)").as_bytes());
    all.write("golden/gone.png", b"other");
    all.judge_again();
    assert_eq!(all.decided(), [], "another picture, another golden");
    assert!(all.review.can_accept("added"), "as of today");
}

#[test]
fn a_golden_is_known_until_it_is_judged_again() {
    let mut all = Reviewed::new();
    assert_eq!(all.review.accept(&names(&["changed"])), [""; 0]);
    let accepted = all.goldens()["changed"].clone();
    all.write("fixtures/changed.ron", other("image: (8, 6)").as_bytes());
    all.judge_again();
    bless(&all.suite, &all.suite.select(&names(&["changed"])).unwrap(), false).unwrap();
    all.judge_again();
    all.write("golden/changed.png", &accepted);
    assert!(!all.review.wrote("changed"), "it was said to be a match with another golden");
}

#[test]
fn an_acceptance_is_taken_back_for_as_long_as_its_golden_is_there() {
    let mut all = Reviewed::new();
    let before = all.goldens();
    assert_eq!(all.review.accept(&names(&["changed"])), [""; 0]);
    let scene = other("image: (20, 16)");
    // Another picture, and then the accepted one again.
    for scene in [other("image: (8, 6)"), scene] {
        all.write("fixtures/changed.ron", scene.as_bytes());
        all.judge_again();
    }
    assert_eq!(all.decided(), [("changed", Decision::Accepted)]);
    all.write("fixtures/changed.ron", other("image: (8, 6)").as_bytes());
    all.judge_again();
    assert_eq!(all.decided(), [], "there is another picture to decide about");
    assert_eq!(all.review.reject(&names(&["changed"])), [""; 0]);
    assert_eq!(all.review.undo(&names(&["changed"])), [""; 0], "what was decided last");
    assert_eq!(changed(&before, &all.goldens()).len(), 1);
    assert_eq!(all.review.undo(&names(&["changed"])), [""; 0]);
    assert_eq!(all.goldens(), before, "the very bytes");
    assert!(!all.review.wrote("changed"), "it was judged by the accepted one");
    assert_eq!(all.review.undo(&names(&["changed"])).len(), 1);
}

#[test]
fn what_is_no_longer_as_accepted_is_left() {
    let mut all = Reviewed::new();
    let before = all.goldens();
    assert_eq!(all.review.accept(&names(&["changed", "gone"])), [""; 0]);
    all.write("golden/changed.png", &before["changed"]);
    all.write("golden/gone.png", b"other");
    let tally = all.review.tally();
    assert_eq!(tally.accepted, [""; 0]);
    assert_eq!(tally.left, ["added", "broken", "changed", "gone", "refused"]);
    let said = all.review.undo(&names(&["changed", "gone"]));
    assert!(said.iter().all(|said| said.ends_with("review it again")), "{said:?}");
    let said = all.review.accept(&names(&["changed", "gone"]));
    assert!(said.len() == 1 && said[0].starts_with("gone is not accepted"), "{said:?}");
    assert!(said[0].ends_with("review it again"), "{said:?}");
    assert_eq!(all.review.tally().accepted, ["changed"]);
}

#[test]
fn what_cannot_be_accepted_stays_rejected_for_the_same_reason() {
    let mut all = Reviewed::new();
    assert_eq!(all.review.reject(&names(&["broken", "refused"])), [""; 0]);
    all.judge_again();
    let both = [("broken", Decision::Rejected), ("refused", Decision::Rejected)];
    assert_eq!(all.decided(), both);
    all.write("fixtures/broken.ron", other("image: (8, 6)").as_bytes());
    all.judge_again();
    assert_eq!(all.decided(), [("refused", Decision::Rejected)], "another reason");
}

#[test]
fn the_state_is_a_document() {
    let mut all = Reviewed::new();
    all.review.accept(&names(&["added"]));
    all.review.reject(&names(&["broken"]));
    let state = all.review.to_json(&["a sentence".to_owned()]);
    assert_eq!(
        state.to_string(),
        r#"{"schema":1,"decisions":{"added":"accepted","broken":"rejected"},"#.to_owned()
            + r#""can_accept":["changed","gone"],"can_undo":["added","broken"],"messages":["a sentence"]}"#
    );
}
