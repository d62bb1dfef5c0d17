//! A harness never seen to fail is not trusted: each verdict provoked once.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use conformance::{SQUARE, Scratch};
use harness::bless::Blessed;
use harness::encode::EncodedImage;
use harness::golden::{from_png, to_png};
use harness::steady::judge_repeatedly;
use harness::store;
use harness::suite::Selection;
use harness::verdict::Outcome;
use tracer::{LinearImage, Rgb, Size};

/// One blessed fixture, `a`, after some damage: the verdicts of all names.
fn after(damage: impl FnOnce(&Scratch)) -> Vec<(String, &'static str)> {
    let scratch = Scratch::blessed(&[("a", SQUARE)]);
    assert_eq!(scratch.verdicts(), [("a".to_owned(), "match")], "before the damage");
    damage(&scratch);
    scratch.verdicts()
}

fn outcomes(scratch: &Scratch) -> Vec<Outcome> {
    let selection = scratch.suite().select(&[]).unwrap();
    harness::run::run(scratch.suite(), &selection, &|_| ()).unwrap()
}

#[track_caller]
fn check(damage: impl FnOnce(&Scratch), verdict: &str) {
    assert_eq!(after(damage), [("a".to_owned(), verdict)]);
}

/// Rewrites the golden's picture and keeps its note.
fn repaint(scratch: &Scratch, paint: impl Fn(&EncodedImage) -> EncodedImage) {
    let golden = from_png(&scratch.golden("a")).unwrap();
    let png = to_png(&paint(&golden.picture), golden.provenance.as_ref()).unwrap();
    scratch.set_golden("a", &png);
}

/// The picture read through another grid.
fn resampled(
    picture: &EncodedImage,
    size: Size,
    from: impl Fn(u32, u32) -> (u32, u32),
) -> EncodedImage {
    EncodedImage::from_fn(size, |x, y| {
        let (x, y) = from(x, y);
        picture.get(x, y).unwrap_or_default()
    })
}

#[test]
fn one_step_in_one_channel_of_one_pixel_differs() {
    for channel in 0..3 {
        check(
            |scratch| {
                repaint(scratch, |picture| {
                    EncodedImage::from_fn(picture.size(), |x, y| {
                        let mut color = picture.get(x, y).unwrap();
                        if (x, y) == (15, 11) {
                            color[channel] ^= 1;
                        }
                        color
                    })
                });
            },
            "differs",
        );
    }
}

#[test]
fn shifted_swapped_and_flipped_pictures_differ() {
    let square = SQUARE.replace("max: (1, 1, 1)", "max: (1, 0.5, 1)").replace("64", "48");
    let colored = square.replace("show: Silhouette", "show: SurfaceColor, background: (1, 0.5, 0)");
    let colored =
        colored.replace("check: (expect: [Count(rgb: (255, 255, 255), pixels: 48)]),", "");
    for paint in [
        |p: &EncodedImage| resampled(p, p.size(), |x, y| (x.saturating_sub(1), y)),
        |p: &EncodedImage| resampled(p, p.size(), |x, y| (x, 11 - y)),
        |p: &EncodedImage| {
            EncodedImage::from_fn(p.size(), |x, y| {
                let [r, g, b] = p.get(x, y).unwrap();
                [b, g, r]
            })
        },
    ] {
        let scratch = Scratch::blessed(&[("a", &colored)]);
        assert_eq!(scratch.verdicts()[0].1, "match");
        repaint(&scratch, paint);
        assert_eq!(scratch.verdicts()[0].1, "differs");
    }
}

#[test]
fn a_cropped_golden_has_the_wrong_size() {
    let crop = |scratch: &Scratch| {
        repaint(scratch, |p| resampled(p, Size { width: 16, height: 11 }, |x, y| (x, y)));
    };
    check(crop, "wrong_size");
}

#[test]
fn a_cropped_golden_without_a_note_has_the_wrong_size_too() {
    let crop = |scratch: &Scratch| {
        let picture = from_png(&scratch.golden("a")).unwrap().picture;
        let cropped = resampled(&picture, Size { width: 15, height: 12 }, |x, y| (x, y));
        scratch.set_golden("a", &to_png(&cropped, None).unwrap());
    };
    check(crop, "wrong_size");
}

#[test]
fn a_picture_that_comes_out_otherwise_is_unsteady() {
    let scratch = Scratch::blessed(&[("a", SQUARE)]);
    for (bit, verdict) in [(None, "match"), (Some(0), "unsteady"), (Some(63), "unsteady")] {
        let judged = judge_repeatedly(scratch.suite(), "a", 3, &mut |fixture| {
            let mut picture = fixture.render_again()?;
            let pixels = picture.linear.pixels().iter().enumerate().map(|(i, color)| {
                let [r, g, b] = color.channels();
                // The last pixel's blue in another bit, which no code shows.
                let flip = bit.filter(|_| i == 16 * 12 - 1).map_or(0, |bit| 1_u64 << bit);
                Rgb::new(r, g, f64::from_bits(b.to_bits() ^ flip))
            });
            let pixels = pixels.collect();
            picture.linear = LinearImage::from_pixels(picture.linear.size(), pixels).unwrap();
            Ok(picture)
        });
        assert_eq!(judged.judgment.verdict.id(), verdict, "{:?}", judged.judgment.findings);
        assert!(verdict == "match" || !judged.judgment.verdict.can_be_blessed());
    }
}

#[test]
fn a_deleted_golden_is_missing() {
    check(|s| store::remove(&s.suite().golden_path("a")).unwrap(), "missing_golden");
}

#[test]
fn a_golden_without_a_fixture_is_an_orphan() {
    let verdicts = after(|s| s.set_golden("gone/b", &s.golden("a")));
    assert_eq!(verdicts, [("a".into(), "match"), ("gone/b".into(), "orphan_golden")]);
}

#[test]
fn a_truncated_or_damaged_golden_is_unreadable() {
    for damage in [
        |bytes: &mut Vec<u8>| bytes.truncate(bytes.len() - 1),
        |bytes: &mut Vec<u8>| bytes.truncate(9),
        |bytes: &mut Vec<u8>| bytes.clear(),
        |bytes: &mut Vec<u8>| flip_a_bit_of_the_picture(bytes),
        |bytes: &mut Vec<u8>| *bytes = b"version https://git-lfs.github.com/spec/v1\n".to_vec(),
    ] {
        let apply = |s: &Scratch| {
            let mut bytes = s.golden("a");
            damage(&mut bytes);
            s.set_golden("a", &bytes);
        };
        check(apply, "unreadable");
    }
}

/// In the compressed pixels, which end before the 12 bytes of the end mark.
fn flip_a_bit_of_the_picture(bytes: &mut [u8]) {
    let at = bytes.len() - 30;
    bytes[at] ^= 0x20;
}

#[test]
fn an_edited_fixture_makes_its_golden_stale_and_a_comment_does_not() {
    let edited = SQUARE.replace("view_width: 4", "view_width: 5").replace("check:", "//");
    let edited = edited.replace("// (expect", "// expect");
    check(|s| s.set_fixture("a", &edited), "stale_golden");
    let same_picture = SQUARE.replace("(-1, -1, -1)", "(-1, -1, -2)");
    check(|s| s.set_fixture("a", &same_picture), "stale_golden");
    check(|s| s.set_fixture("a", &format!("// why\n{SQUARE}")), "match");
    let larger = SQUARE.replace("(16, 12)", "(32, 24)").replace("64", "256");
    check(|s| s.set_fixture("a", &larger), "stale_golden");
}

#[test]
fn a_golden_without_a_note_is_stale_although_it_looks_right() {
    let strip_note = |s: &Scratch| {
        let picture = from_png(&s.golden("a")).unwrap().picture;
        s.set_golden("a", &to_png(&picture, None).unwrap());
    };
    check(strip_note, "stale_golden");
}

#[test]
fn a_broken_expectation_is_said_although_the_golden_matches() {
    let wrong = SQUARE.replace("pixels: 64", "pixels: 65");
    check(|s| s.set_fixture("a", &wrong), "expectation_failed");
}

#[test]
fn every_expectation_is_checked_and_every_broken_one_said() {
    let three = SQUARE.replace(
        "Count(rgb: (255, 255, 255), pixels: 64)",
        "Count(rgb: (255, 255, 255), pixels: 64), Pixel(at: (0, 0), rgb: (9, 9, 9)), \
         Count(rgb: (0, 0, 0), pixels: 9)",
    );
    let scratch = Scratch::blessed(&[("a", SQUARE)]);
    scratch.set_fixture("a", &three);
    let outcome = &outcomes(&scratch)[0];
    assert_eq!(outcome.verdict.id(), "expectation_failed");
    assert_eq!(outcome.findings.len(), 2, "{:?}", outcome.findings);
    assert_eq!(outcome.remedy(), None, "blessing would be refused");
    // Whatever else is wrong, the expectations are said as well.
    store::remove(&scratch.suite().golden_path("a")).unwrap();
    let outcome = &outcomes(&scratch)[0];
    assert_eq!(outcome.verdict.id(), "missing_golden");
    assert_eq!(outcome.findings.len(), 3, "{:?}", outcome.findings);
    assert_eq!(outcome.remedy(), None);
}

#[test]
fn a_broken_expectation_outranks_a_missing_note() {
    let both = |s: &Scratch| {
        let picture = from_png(&s.golden("a")).unwrap().picture;
        s.set_golden("a", &to_png(&picture, None).unwrap());
        s.set_fixture("a", &SQUARE.replace("pixels: 64", "pixels: 65"));
    };
    check(both, "expectation_failed");
}

/// [`SQUARE`] with a half of it twice: the order decides which color it has.
fn tie() -> String {
    let left = "Box(min: (-1, -1, -1), max: (0, 1, 1), material: Constant(color: (1, 0, 0)))";
    let colored = SQUARE.replace("Silhouette", "SurfaceColor");
    let twice = colored.replace("objects: [", &format!("objects: [{left}, "));
    twice.replace("pixels: 64", "pixels: 32")
}

#[test]
fn a_broken_relation_is_said_although_the_golden_matches() {
    let related = |text: &str, relations: &str| {
        text.replace("check: (", &format!("check: (relations: [{relations}], "))
    };
    let scratch = Scratch::blessed(&[("a", &tie())]);
    assert_eq!(scratch.verdicts(), [("a".to_owned(), "match")]);
    scratch.set_fixture("a", &related(&tie(), "IdentityGroup, NoAccelerator"));
    assert_eq!(scratch.verdicts(), [("a".to_owned(), "match")]);
    scratch.set_fixture("a", &related(&tie(), "IdentityGroup, PermuteObjects()"));
    let outcome = &outcomes(&scratch)[0];
    assert_eq!(outcome.verdict.id(), "relation_failed");
    let found = "relation PermuteObjects(): pixel (4, 2): expected [1.0, 0.0, 0.0], found \
                 [1.0, 1.0, 1.0]; 32 of 192 pixels differ";
    assert_eq!(outcome.findings, [found]);
    assert_eq!(outcome.remedy(), None, "blessing would be refused");

    // Expectations come first, and both are said.
    let both = related(&tie(), "PermuteObjects()").replace("pixels: 32", "pixels: 33");
    scratch.set_fixture("a", &both);
    let outcome = &outcomes(&scratch)[0];
    assert_eq!((outcome.verdict.id(), outcome.findings.len()), ("expectation_failed", 2));

    // Whatever else is wrong, relations are said as well, and nothing is blessed.
    scratch.set_fixture("a", &related(&tie(), "PermuteObjects()"));
    store::remove(&scratch.suite().golden_path("a")).unwrap();
    let outcome = &outcomes(&scratch)[0];
    assert_eq!((outcome.verdict.id(), outcome.findings.len()), ("missing_golden", 2));
    assert_eq!(outcome.remedy(), None);
    let selection = scratch.suite().select(&[]).unwrap();
    let blessed = harness::bless::bless(scratch.suite(), &selection, false).unwrap();
    assert_eq!(blessed[0].1, Blessed::Refused(vec![found.to_owned()]));
}

#[test]
fn relations_do_not_make_a_golden_stale() {
    let related = SQUARE.replace("check: (", "check: (relations: [Translate(by: (1, 2, 4))], ");
    check(|s| s.set_fixture("a", &related), "match");
}

#[test]
fn outcomes_are_in_the_order_of_names_orphans_among_them() {
    let scratch = Scratch::blessed(&[("b", SQUARE), ("d", SQUARE)]);
    for orphan in ["a", "c", "e"] {
        scratch.set_golden(orphan, &scratch.golden("b"));
    }
    let names: Vec<_> = scratch.verdicts().into_iter().map(|v| v.0).collect();
    assert_eq!(names, ["a", "b", "c", "d", "e"]);
}

#[test]
fn what_cannot_be_written_or_removed_is_refused() {
    let scratch = Scratch::blessed(&[("a", SQUARE)]);
    let golden = scratch.suite().golden_path("a");
    store::remove(&golden).unwrap();
    // A folder in the golden's place.
    store::write(&golden.join("x"), b"").unwrap();
    let selection = Selection { fixtures: vec!["a".into()], orphans: vec!["gone".into()] };
    let blessed = harness::bless::bless(scratch.suite(), &selection, true).unwrap();
    for (name, blessed) in blessed {
        assert!(matches!(blessed, Blessed::Refused(_)), "{name}: {blessed:?}");
    }
}

#[test]
fn a_check_that_makes_no_sense_is_refused_with_its_place() {
    for (from, to, expected) in [
        (
            "check: (",
            "check: (limits: (max_abs: 255, reason: \"x\"), ",
            "expected a number from 1 to 254",
        ),
        ("pixels: 64)", "pixels: 64), Pixel(at: (16, 0), rgb: (0, 0, 0))", "which is 16 x 12"),
        (
            "check: (",
            "check: (relations: [SumOfLights()], ",
            "expected two lights or more, found 0",
        ),
        (
            "check: (",
            "check: (same_as: {\"b\": \"one\", \"c\": \"x\", \"b\": \"other\"}, ",
            "fixtures/a.ron:7:45: \"b\" is given twice",
        ),
        (
            "check: (",
            "check: (idle: {\"objects[0]\": \"x\", \"objects[0]\": \"x\"}, ",
            "fixtures/a.ron:7:39: \"objects[0]\" is given twice",
        ),
    ] {
        let scratch = Scratch::blessed(&[("a", SQUARE)]);
        scratch.set_fixture("a", &SQUARE.replace(from, to));
        let outcome = &outcomes(&scratch)[0];
        assert_eq!(outcome.verdict.id(), "render_refused");
        let said = outcome.findings.concat();
        assert!(said.contains(expected) && said.contains("fixtures/a.ron:7:"), "{said}");
    }
}

#[test]
fn a_limit_of_flip_lets_pass_what_is_hardly_seen_and_no_more() {
    let limited = SQUARE.replace("check: (", "check: (limits: (flip: 0.05, reason: \"x\"), ");
    let scratch = Scratch::blessed(&[("a", &limited)]);
    let paint_corner = |by: u8| {
        repaint(&scratch, |picture| {
            EncodedImage::from_fn(picture.size(), |x, y| {
                picture
                    .get(x, y)
                    .unwrap()
                    .map(|code| if (x, y) == (0, 0) { code ^ by } else { code })
            })
        });
        outcomes(&scratch).remove(0)
    };
    let faint = paint_corner(1);
    assert_eq!(faint.verdict.id(), "match", "{faint:?}");
    let strong = paint_corner(0x80);
    assert_eq!(strong.verdict.id(), "differs", "{strong:?}");
    assert!(strong.findings[0].starts_with("worst pixel's FLIP"), "{:?}", strong.findings);
}

#[test]
fn a_broken_fixture_is_refused_and_the_others_judged() {
    let scratch = Scratch::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    scratch.set_fixture("a", "(version: 1,");
    let expected = [("a".into(), "render_refused"), ("b".into(), "match")];
    assert_eq!(scratch.verdicts(), expected);
}

#[test]
fn a_failure_leaves_a_strip_and_a_later_run_takes_it_away() {
    let scratch = Scratch::blessed(&[("area/a", SQUARE)]);
    let strip = scratch.suite().artifacts().join("area/a.png");
    let there = || store::read(&strip, 1 << 20).unwrap().is_some();
    scratch.verdicts();
    assert!(!there());
    let golden = scratch.golden("area/a");
    store::remove(&scratch.suite().golden_path("area/a")).unwrap();
    scratch.verdicts();
    assert!(there());
    scratch.set_golden("area/a", &golden);
    scratch.verdicts();
    assert!(!there());
}

#[test]
fn bless_writes_only_what_is_no_match_and_refuses_what_is_wrong() {
    let wrong = SQUARE.replace("pixels: 64", "pixels: 65");
    let scratch = Scratch::blessed(&[("a", SQUARE), ("b", SQUARE), ("wrong", &wrong)]);
    // The first blessing refused the broken expectation.
    let missing = ("wrong".to_owned(), "missing_golden");
    assert_eq!(scratch.verdicts()[2], missing);

    let a = scratch.golden("a");
    scratch.set_fixture("b", &SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)").replace("64", "48"));
    let selection = scratch.suite().select(&[]).unwrap();
    let blessed = harness::bless::bless(scratch.suite(), &selection, false).unwrap();
    let names: Vec<_> = blessed.iter().map(|(name, b)| format!("{name}: {b:?}")).collect();
    assert!(names[0].starts_with("a: Untouched"), "{names:?}");
    assert!(names[1].starts_with("b: Replaced"), "{names:?}");
    assert!(names[2].starts_with("wrong: Refused"), "{names:?}");
    assert_eq!(scratch.golden("a"), a, "not a byte of a match is written");
    assert_eq!(scratch.verdicts()[2], missing);
}
