//! `failures`: what is no match, the worst first.

use std::cmp::Ordering;

use crate::verdict::{Outcome, Verdict};

/// What is no match, the worst first: what has no picture, what is wrong
/// whatever its golden says, what has no golden to be compared with, what is not
/// its golden, and the rest, of which the golden's file is to be seen to. Within each by the worst window of SSIM, then
/// by name.
pub(super) fn failures(outcomes: &[Outcome]) -> Vec<&Outcome> {
    let mut failures: Vec<_> = outcomes.iter().filter(|o| o.verdict != Verdict::Match).collect();
    failures.sort_by(|a, b| order(a, b));
    failures
}

fn order(a: &Outcome, b: &Outcome) -> Ordering {
    let ssim = |o: &Outcome| o.comparison.as_ref().map_or(f64::NEG_INFINITY, |c| c.ssim_min);
    kind(a).cmp(&kind(b)).then(ssim(a).total_cmp(&ssim(b))).then_with(|| a.name.cmp(&b.name))
}

fn kind(outcome: &Outcome) -> u8 {
    let differs = outcome.comparison.as_ref().is_some_and(|c| !c.is_identical());
    match outcome.verdict {
        Verdict::RenderRefused => 0,
        Verdict::Unsteady => 1,
        _ if outcome.breaks_its_word() => 1,
        Verdict::MissingGolden | Verdict::Unreadable | Verdict::TamperedGolden => 2,
        Verdict::WrongSize => 3,
        _ if differs => 3,
        _ => 4,
    }
}

#[cfg(test)]
mod tests {
    use tracer::Size;

    use super::*;
    use crate::encode::EncodedImage;
    use crate::metric::compare;

    /// A failure whose picture is so far from its golden.
    fn outcome(name: &str, verdict: Verdict, codes: Option<u8>) -> Outcome {
        let size = Size { width: 12, height: 12 };
        let golden = EncodedImage::from_fn(size, |_, _| [100; 3]);
        let comparison = codes.and_then(|codes| {
            let actual =
                EncodedImage::from_fn(size, |x, _| if x < 6 { [100 + codes; 3] } else { [100; 3] });
            compare(&golden, &actual)
        });
        Outcome { comparison, ..Outcome::unrendered(name, verdict) }
    }

    #[test]
    fn the_worst_comes_first_and_matches_not_at_all() {
        let wrong = Outcome {
            breaks_relations: true,
            ..outcome("wrong", Verdict::RelationFailed, Some(0))
        };
        let all = [
            outcome("fine", Verdict::Match, Some(0)),
            outcome("stale", Verdict::StaleGolden, Some(0)),
            outcome("b-same", Verdict::Differs, Some(90)),
            outcome("a-same", Verdict::Differs, Some(90)),
            outcome("faint", Verdict::Differs, Some(1)),
            outcome("crop", Verdict::WrongSize, None),
            outcome("lost", Verdict::MissingGolden, None),
            outcome("edited", Verdict::TamperedGolden, Some(1)),
            wrong,
            outcome("unsteady", Verdict::Unsteady, None),
            outcome("orphan", Verdict::OrphanGolden, None),
            outcome("refused", Verdict::RenderRefused, None),
        ];
        let names: Vec<_> = failures(&all).iter().map(|o| o.name.as_str()).collect();
        let expected = [
            "refused", "unsteady", "wrong", "lost", "edited", "crop", "a-same", "b-same", "faint",
            "orphan", "stale",
        ];
        assert_eq!(names, expected);
    }
}
