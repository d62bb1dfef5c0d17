//! Each verdict on a golden, and which of several is said.

use scene::NoAssets;
use tracer::Size;
use tracer::accel::Build;

use super::*;
use crate::digest;

/// A white square on black, and what is checked of it.
fn fixture(check: &str) -> (Fixture, Rendered) {
    let text = format!(
        "(version: 1, image: (16, 12), show: Silhouette,
        camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 3),
        objects: [Box(min: (-1, -1, -1), max: (1, 1, 1))], check: ({check}))"
    );
    let fixture = Fixture::read("a", &text, &NoAssets, Build::Bvh).unwrap();
    let picture = fixture.render().unwrap();
    (fixture, picture)
}

/// The golden that `bless` would write.
fn golden(fixture: &Fixture, picture: &Rendered) -> Golden {
    Golden {
        picture: picture.encoded.clone(),
        provenance: Some(fixture.provenance.clone()),
        accepted: Some(digest::of_encoded(&picture.encoded)),
        file_bytes: 300,
    }
}

/// The verdict after something was done to the golden, and how many findings.
#[track_caller]
fn check(check: &str, damage: impl FnOnce(&mut Golden), expected: (Verdict, usize)) {
    let (fixture, picture) = fixture(check);
    let mut golden = golden(&fixture, &picture);
    damage(&mut golden);
    let judgment = judge(&fixture, &picture, &Found::Golden(golden));
    let found = (judgment.verdict, judgment.findings.len());
    assert_eq!(found, expected, "{:?}", judgment.findings);
    let broken = broken_expectations(&fixture, &picture);
    assert_eq!(judgment.breaks_expectations, !broken.is_empty());
}

const RIGHT: &str = "expect: [Count(rgb: (255, 255, 255), pixels: 64)]";
const WRONG: &str = "expect: [Count(rgb: (255, 255, 255), pixels: 63)]";

/// Other pixels, accepted as they are.
fn repaint(golden: &mut Golden, size: Size) {
    golden.picture = EncodedImage::from_fn(size, |_, _| [1, 2, 3]);
    golden.accepted = Some(digest::of_encoded(&golden.picture));
}

const SAME: Size = Size { width: 16, height: 12 };
const OTHER: Size = Size { width: 12, height: 16 };

#[test]
fn each_verdict_alone() {
    check(RIGHT, |_| (), (Verdict::Match, 0));
    check(WRONG, |_| (), (Verdict::ExpectationFailed, 1));
    check(RIGHT, |golden| golden.provenance = None, (Verdict::StaleGolden, 1));
    // That the picture is today's is said as well.
    check(RIGHT, |golden| golden.accepted = Some("other".into()), (Verdict::TamperedGolden, 2));
    check(RIGHT, |golden| repaint(golden, SAME), (Verdict::Differs, 1));
    check(RIGHT, |golden| repaint(golden, OTHER), (Verdict::WrongSize, 1));
    let largest = crate::check::Check::MAX_FILE_BYTES;
    check(RIGHT, |golden| golden.file_bytes = largest, (Verdict::Match, 0));
    check(RIGHT, |golden| golden.file_bytes = largest + 1, (Verdict::GoldenFileSize, 1));
    check("large: \"why\"", |golden| golden.file_bytes = largest + 1, (Verdict::Match, 0));
    check("large: \"why\"", |golden| golden.file_bytes = largest, (Verdict::GoldenFileSize, 1));
}

#[test]
fn of_several_the_first_is_said_and_all_are_found() {
    let stale = |golden: &mut Golden| {
        if let Some(note) = &mut golden.provenance {
            note.scene = "other".to_owned();
        }
    };
    // That the picture is the same is said of a stale one.
    check(RIGHT, stale, (Verdict::StaleGolden, 2));
    let both = |golden: &mut Golden| {
        stale(golden);
        repaint(golden, SAME);
    };
    check(RIGHT, both, (Verdict::StaleGolden, 2));
    check(WRONG, both, (Verdict::StaleGolden, 3));
    check(WRONG, |golden| repaint(golden, OTHER), (Verdict::WrongSize, 2));
    check(WRONG, |golden| golden.provenance = None, (Verdict::ExpectationFailed, 1));
    let large = crate::check::Check::MAX_FILE_BYTES + 1;
    check(WRONG, |golden| golden.file_bytes = large, (Verdict::ExpectationFailed, 2));
}

#[test]
fn what_is_no_golden_is_said() {
    let (fixture, picture) = fixture(WRONG);
    for (found, verdict) in [
        (Found::Nothing, Verdict::MissingGolden),
        (Found::Unreadable("is odd".to_owned()), Verdict::Unreadable),
    ] {
        let judgment = judge(&fixture, &picture, &found);
        assert_eq!((judgment.verdict, judgment.findings.len()), (verdict, 2));
        assert_eq!(judgment.comparison, None);
        assert_eq!(found.picture(), None);
    }
    let golden = golden(&fixture, &picture);
    assert_eq!(Found::Golden(golden).picture(), Some(&picture.encoded));
}

#[test]
fn a_broken_relation_is_the_verdict_of_what_would_match() {
    let why = || vec!["relation Threads: why".to_owned()];
    let of = |check: &str| {
        let (fixture, picture) = fixture(check);
        judge(&fixture, &picture, &Found::Golden(golden(&fixture, &picture)))
    };
    let broken = of(RIGHT).with_relations(why());
    assert_eq!((broken.verdict, broken.findings.len()), (Verdict::RelationFailed, 1));
    assert_eq!(broken.broken_relations, why());
    assert_eq!(of(RIGHT).with_relations(Vec::new()).verdict, Verdict::Match);
    let both = of(WRONG).with_relations(why());
    assert_eq!((both.verdict, both.findings.len()), (Verdict::ExpectationFailed, 2));
}

#[test]
fn limits_decide_what_is_caught() {
    let (_, picture) = fixture(RIGHT);
    let golden = &picture.encoded;
    let one = EncodedImage::from_fn(SAME, |x, y| {
        let color = golden.get(x, y).unwrap();
        if (x, y) == (0, 0) { [3; 3] } else { color }
    });
    let limits = |max_abs| Limits {
        max_abs: Some(max_abs),
        reason: "a test".to_owned(),
        ..Limits::default()
    };
    assert!(!is_caught(None, golden, golden) && is_caught(None, golden, &one));
    assert!(is_caught(Some(&limits(2)), golden, &one));
    assert!(!is_caught(Some(&limits(3)), golden, &one));
    let other = EncodedImage::from_fn(OTHER, |_, _| [0; 3]);
    assert!(is_caught(Some(&limits(254)), golden, &other), "of another size");
}
