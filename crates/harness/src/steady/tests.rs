//! An unsteady renderer is noticed, whatever it does.

use std::cell::Cell;

use tracer::{LinearImage, Rgb};

use super::*;
use crate::bless::bless;
use crate::judge::Judgment;
use crate::verdict::Verdict;
use crate::{golden, store};

/// White on black: a corner's channels are zeros.
const BALL: &str = "(version: 1, image: (8, 6), show: Silhouette,
    camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 3),
    objects: [Sphere(center: (0, 0, 0), radius: 1)])";

/// A suite with one fixture `a`, blessed.
fn blessed() -> (tempfile::TempDir, Suite) {
    let folder = tempfile::tempdir().unwrap();
    store::write(&folder.path().join("fixtures/a.ron"), BALL.as_bytes()).unwrap();
    let suite = Suite::open(folder.path()).unwrap();
    bless(&suite, &suite.select(&[]).unwrap(), false).unwrap();
    (folder, suite)
}

/// The same picture with this bit of a pixel's red flipped.
fn disturbed(picture: &Rendered, at: (u32, u32), bit: u32) -> Rendered {
    let linear = LinearImage::from_fn(picture.linear.size(), |x, y| {
        let [r, g, b] = picture.linear.get(x, y).unwrap().channels();
        let flipped = f64::from_bits(r.to_bits() ^ (1 << bit));
        if (x, y) == at { Rgb::new(flipped, g, b) } else { Rgb::new(r, g, b) }
    });
    Rendered { linear, encoded: picture.encoded.clone() }
}

/// Judged with a renderer that disturbs each of these repeats.
fn judged(disturbances: &[Option<((u32, u32), u32)>]) -> Judged {
    let (_folder, suite) = blessed();
    let next = Cell::new(0);
    judge_repeatedly(&suite, "a", 1 + disturbances.len() as u32, &mut |fixture| {
        let picture = fixture.render_again()?;
        let disturbance = disturbances[next.replace(next.get() + 1)];
        Ok(disturbance.map_or(picture.clone(), |(at, bit)| disturbed(&picture, at, bit)))
    })
}

#[track_caller]
fn check(disturbances: &[Option<((u32, u32), u32)>], expected: &str) {
    let Judgment { verdict, findings, .. } = judged(disturbances).judgment;
    assert_eq!((verdict, findings.join("|").as_str()), (Verdict::Unsteady, expected));
    assert!(!verdict.can_be_blessed());
}

#[test]
fn the_same_bits_each_time_are_steady() {
    for steady in [&[][..], &[None], &[None; 5]] {
        let judgment = judged(steady).judgment;
        assert_eq!((judgment.verdict, judgment.findings), (Verdict::Match, vec![]));
    }
}

#[test]
fn the_last_bit_of_one_pixel_in_one_repeat_is_noticed() {
    let words = |of: &str, pixels: u32, first: &str| {
        format!(
            "{of} renders differ from the first: {pixels} of 48 pixels have other bits, first \
             {first}"
        )
    };
    check(&[Some(((3, 4), 0))], &words("1 of 2", 1, "(3, 4)"));
    check(&[None, None, Some(((3, 4), 0))], &words("1 of 4", 1, "(3, 4)"));
    let two = [Some(((5, 2), 0)), None, Some(((3, 4), 1)), Some(((5, 2), 0))];
    check(&two, &words("3 of 5", 2, "(5, 2)"));
    // Minus zero is another bit.
    check(&[Some(((0, 0), 63))], &words("1 of 2", 1, "(0, 0)"));
}

#[test]
fn other_codes_sizes_and_refusals_are_noticed() {
    let (_folder, suite) = blessed();
    let (fixture, first) = run::render_fixture(&suite, "a").unwrap();
    let again = || fixture.render_again();
    assert_eq!(difference(&first, [again(), again()]), None);

    let mut other = first.clone();
    other.encoded = crate::encode::EncodedImage::from_fn(first.encoded.size(), |x, y| {
        let [r, g, b] = first.encoded.get(x, y).unwrap();
        [r ^ u8::from((x, y) == (1, 0)), g, b]
    });
    let said = difference(&first, [again(), Ok(other)]).unwrap();
    assert!(said.starts_with("1 of 3 renders differ from the first: 1 of "), "{said}");
    assert!(said.ends_with("first (1, 0)"), "{said}");

    let said = difference(&first, [Err("pixel (0, 0) is NaN".to_owned())]).unwrap();
    let expected =
        "1 of 2 renders differ from the first: a render was refused: pixel (0, 0) is NaN";
    assert_eq!(said, expected);
}

#[test]
fn it_is_the_verdict_whatever_else_is_wrong_and_leaves_a_strip() {
    let (_folder, suite) = blessed();
    let picture =
        golden::from_png(&store::read(&suite.golden_path("a"), 1 << 20).unwrap().unwrap());
    let black =
        crate::encode::EncodedImage::from_fn(picture.unwrap().picture.size(), |_, _| [0; 3]);
    store::write(&suite.golden_path("a"), &golden::to_png(&black, None).unwrap()).unwrap();
    let judge = |suite: &Suite, name: &str| {
        judge_repeatedly(suite, name, 2, &mut |fixture| {
            fixture.render_again().map(|picture| disturbed(&picture, (0, 0), 0))
        })
    };
    let selection = suite.select(&[]).unwrap();
    let outcomes = run::run_by(&suite, &selection, &judge, &|_| ()).unwrap();
    let outcome = &outcomes[0];
    assert_eq!(outcome.verdict, Verdict::Unsteady);
    assert!(outcome.findings.len() > 1, "{:?}", outcome.findings);
    assert_eq!(outcome.remedy(), None, "blessing settles nothing");
    assert!(store::is_file(&suite.root().join(outcome.strip.as_ref().unwrap())));
}

#[test]
fn a_real_run_is_steady() {
    let (_folder, suite) = blessed();
    let outcomes = run_repeatedly(&suite, &suite.select(&[]).unwrap(), 3, &|_| ()).unwrap();
    assert_eq!(outcomes[0].verdict, Verdict::Match);
}
