//! `annotations`: failures as GitHub's runner shows them, beside the lines that
//! they are about.

use std::fmt::Write;

use super::text::{Reader, advice, file, reasons, rerun};
use super::worst::failures;
use crate::verdict::Outcome;

/// GitHub shows so many errors of a step and drops the others.
const SHOWN: usize = 10;

/// A workflow command for each failure, a line each, the worst first. Of more
/// than ten, the first ten and a notice of how many more. The reader's path
/// prefix is taken from the repository.
///
/// Source: GitHub's documentation, "Workflow commands for GitHub Actions".
pub fn annotations(outcomes: &[Outcome], reader: &Reader) -> String {
    let failures = failures(outcomes);
    let mut text = String::new();
    for outcome in failures.iter().take(SHOWN) {
        let (line, column) = outcome.place.unwrap_or((1, 1));
        let title = format!("{}: {}", outcome.verdict.words(), outcome.name);
        let reasons = reasons(outcome, reader);
        let mut message: Vec<_> = reasons.iter().map(|why| why.trim_end().to_owned()).collect();
        message.extend(advice(outcome, reader));
        message.push(format!("again: {}", rerun(&outcome.name, reader)));
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "::error file={},line={line},col={column},title={}::{}",
            property(&file(outcome, reader)),
            property(&title),
            data(&message.join("\n"))
        );
    }
    if let Some(more @ 1..) = failures.len().checked_sub(SHOWN) {
        let _ = writeln!(
            text,
            "::notice title=goldray::{more} more of the {} failures are not shown here: all \
             are in the log",
            failures.len()
        );
    }
    text
}

/// What stands after the second `::`.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property before it.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verdict::Verdict;

    fn missing(name: &str) -> Outcome {
        Outcome {
            findings: vec!["there is no golden".to_owned()],
            ..Outcome::unrendered(name, Verdict::MissingGolden)
        }
    }

    #[track_caller]
    fn check(outcome: Outcome, expected: &str) {
        assert_eq!(annotations(&[outcome], &Reader::default()), format!("{expected}\n"));
    }

    #[test]
    fn what_the_runner_takes_for_its_own_is_escaped() {
        let ugly = Outcome {
            findings: vec!["100 %: a,\r\nb::c".to_owned()],
            place: Some((14, 9)),
            ..Outcome::unrendered("x,y:z%0A", Verdict::RenderRefused)
        };
        check(
            ugly,
            "::error file=fixtures/x%2Cy%3Az%250A.ron,line=14,col=9,title=render refused%3A \
             x%2Cy%3Az%250A::100 %25: a,%0D%0Ab::c%0Aagain: cargo xtask check 'x,y:z%250A'",
        );
    }

    #[test]
    fn a_failure_without_a_place_is_on_the_first_line() {
        check(
            missing("a/b"),
            "::error file=fixtures/a/b.ron,line=1,col=1,title=missing golden%3A a/b::there is no \
             golden%0Aif meant: cargo xtask bless a/b%0Aagain: cargo xtask check a/b",
        );
        let orphan = Outcome::unrendered("a", Verdict::OrphanGolden);
        let reader = Reader { path_prefix: "sub/".to_owned(), root_flag: " --root sub".to_owned() };
        let said = annotations(&[orphan], &reader);
        let expected = "::error file=sub/golden/a.png,line=1,col=1,title=orphan golden%3A a::if \
                        meant: cargo xtask --root sub bless --prune a%0Aagain: cargo xtask --root \
                        sub check a\n";
        assert_eq!(said, expected);
    }

    #[test]
    fn no_more_than_github_shows_and_how_many_are_left() {
        let all: Vec<_> = (0..12).map(|i| missing(&format!("f{i:02}"))).collect();
        let lines = |n: usize| annotations(&all[..n], &Reader::default());
        assert_eq!(lines(0), "");
        assert_eq!(lines(10).lines().count(), 10);
        assert!(!lines(10).contains("::notice"));
        assert_eq!(lines(12).lines().filter(|line| line.starts_with("::error ")).count(), 10);
        let last = lines(12).lines().last().unwrap().to_owned();
        assert!(last.starts_with("::notice title=goldray::2 more of the 12 failures"), "{last}");
        assert_eq!(
            annotations(&[Outcome::unrendered("a", Verdict::Match)], &Reader::default()),
            ""
        );
    }
}
