//! `markdown`: a run as a page of Markdown, such as GitHub's summary of a step.

use std::fmt::Write;

use super::summary::summarize;
use super::text::{Reader, advice, command, file, reasons, rerun};
use super::worst::failures;
use crate::verdict::Outcome;

/// So many failures are shown at once; the others are folded.
const OPEN: usize = 50;

/// Kept for what closes the page where it is cut.
const CLOSING_BYTES: usize = 256;

/// How it ended, how many of each verdict, and a table of failures, the worst
/// first, of those beyond fifty folded. At most `max_bytes` bytes, by leaving
/// out the last rows and saying how many; `None` where not even the head fits.
///
/// Whatever a fixture says is shown as it is written: no name, finding or
/// command is taken for Markdown, HTML or a mention.
pub fn markdown(
    outcomes: &[Outcome],
    elapsed_ms: f64,
    reader: &Reader,
    max_bytes: usize,
) -> Option<String> {
    let failures = failures(outcomes);
    let mut page = head(outcomes, failures.len(), elapsed_ms);
    let room = max_bytes.checked_sub(CLOSING_BYTES)?;
    if page.len() > room {
        return None;
    }
    let mut shown = 0;
    for (i, outcome) in failures.iter().enumerate() {
        let table = if i == 0 || i == OPEN { TABLE } else { "" };
        let fold = if i == OPEN { fold(failures.len() - OPEN) } else { String::new() };
        let row = format!("{fold}{table}{}", row(outcome, reader));
        if page.len() + row.len() > room {
            break;
        }
        page += &row;
        shown += 1;
    }
    if shown > OPEN {
        page += "\n</details>\n";
    }
    if shown < failures.len() {
        let more = failures.len() - shown;
        // Writing to a String cannot fail.
        let _ = writeln!(page, "\n{more} more are left out, as the page would be too large.");
    }
    Some(page)
}

const TABLE: &str = "\n| fixture | verdict | why | what to do |\n|---|---|---|---|\n";

fn fold(more: usize) -> String {
    format!("\n<details><summary>{more} more</summary>\n")
}

fn head(outcomes: &[Outcome], failed: usize, elapsed_ms: f64) -> String {
    let summary = summarize(outcomes);
    let title = match (summary.total, failed) {
        (total, 0) => format!("goldray: all {total} match"),
        (total, failed) => format!("goldray: {failed} of {total} do not match"),
    };
    format!("### {title}\n\n{summary} ({:.2} s)\n", elapsed_ms / 1e3)
}

fn row(outcome: &Outcome, reader: &Reader) -> String {
    let file = file(outcome, reader);
    let place = outcome.place.map_or(String::new(), |(line, column)| format!(":{line}:{column}"));
    let why = reasons(outcome, reader).iter().map(|reason| prose(reason)).collect::<Vec<_>>();
    let what = match (command(outcome, reader), advice(outcome, reader)) {
        (Some(command), _) => format!("if meant: {}", code(&command)),
        (None, Some(advice)) => prose(&advice),
        (None, None) => code(&rerun(&outcome.name, reader)),
    };
    format!(
        "| {} | {} | {} | {what} |\n",
        code(&format!("{file}{place}")),
        outcome.verdict.words(),
        why.join("<br>")
    )
}

/// Text in a cell of a table, or in any line of Markdown, that is nothing but text.
pub fn prose(text: &str) -> String {
    // Without the space of no width, a name behind the one would be mentioned, and
    // a word between two of the others be a little picture.
    plain(text).replace("&#64;", "&#64;&#8203;").replace("&#58;", "&#58;&#8203;")
}

/// A name or a command in a cell of a table, to be copied letter by letter: no
/// mention is made of what stands in it.
pub fn code(text: &str) -> String {
    format!("<code>{}</code>", plain(text))
}

/// What may mean something inside a line, on GitHub or elsewhere; so may some colons.
const SIGNS: &str = "\\`*_[]<>|~#@&$";

/// Text in which every sign is itself, in one line as cells are.
///
/// Source: CommonMark, 2.5: no reference to a character is taken for structure.
fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let text = text.trim_end();
    for (at, c) in text.char_indices() {
        match c {
            ':' if !has_meaning(&text[at + 1..]) => out.push(c),
            '\n' => out.push_str("<br>"),
            // GitHub makes links of `www.` and `GH-1`, unless there is something between.
            '.' | '-' if ["www", "gh"].iter().any(|word| ends_in(&out, word)) => {
                let _ = write!(out, "&#8203;{c}");
            }
            c if c.is_control() => out.push('\u{fffd}'),
            c if c == ':' || SIGNS.contains(c) => {
                let _ = write!(out, "&#{};", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out
}

/// Whether a colon before this is more than a colon: that of an address, or the first of
/// a little picture's name, such as `:ball:`. Places as in `a.ron:3:9` are none.
fn has_meaning(rest: &str) -> bool {
    /// The little pictures whose names have no letter.
    const WITHOUT: [&str; 4] = ["100", "1234", "+1", "-1"];
    let is_of_a_name = |c: char| c.is_ascii_alphanumeric() || "_+-".contains(c);
    let word = rest.split_once(':').map_or("", |(word, _)| word);
    let is_name = word.contains(|c: char| c.is_ascii_alphabetic()) || WITHOUT.contains(&word);
    rest.starts_with("//") || is_name && word.chars().all(is_of_a_name)
}

/// Whether the text ends in these letters, in upper or lower case.
fn ends_in(text: &str, letters: &str) -> bool {
    let end = text.len().checked_sub(letters.len()).and_then(|at| text.get(at..));
    end.is_some_and(|end| end.eq_ignore_ascii_case(letters))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verdict::Verdict;

    const LARGE: usize = 1 << 20;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        assert_eq!(prose(text), expected, "{text:?}");
    }

    #[test]
    fn no_sign_means_anything() {
        check("a|b", "a&#124;b");
        check("`rm -rf`", "&#96;rm -rf&#96;");
        check("<img src=x>", "&#60;img src=x&#62;");
        check("@octocat", "&#64;&#8203;octocat");
        check("see Www.a.b, gh-12", "see Www&#8203;.a.b, gh&#8203;-12");
        check("&lt;*_#$~[x](y)\\", "&#38;lt;&#42;&#95;&#35;&#36;&#126;&#91;x&#93;(y)&#92;");
        check("a:100:b", "a&#58;&#8203;100:b");
        check(":ball::+1:", "&#58;&#8203;ball:&#58;&#8203;+1:");
        check("see https://a.b", "see https&#58;&#8203;//a.b");
        check("a: b, at: 10:20:30, a.ron:3:9", "a: b, at: 10:20:30, a.ron:3:9");
        check("a: no name: b", "a: no name: b");
        check("one\ntwo\n", "one<br>two");
        check("a\r\u{1b}[1m", "a\u{fffd}\u{fffd}&#91;1m");
        assert_eq!(code("bless 'a|`@b`'"), "<code>bless 'a&#124;&#96;&#64;b&#96;'</code>");
    }

    fn failing(n: usize) -> Vec<Outcome> {
        let outcome = |i: usize| Outcome {
            findings: vec!["expected identical pictures".to_owned()],
            place: Some((14, 9)),
            ..Outcome::unrendered(&format!("a/f{i:03}"), Verdict::Differs)
        };
        (0..n).map(outcome).collect()
    }

    fn rows(page: &str) -> usize {
        page.lines().filter(|line| line.starts_with("| <code>")).count()
    }

    #[test]
    fn a_row_for_each_failure_and_none_for_a_match() {
        let mut all = failing(1);
        all.push(Outcome::unrendered("fine", Verdict::Match));
        let page = markdown(&all, 1234.0, &Reader::default(), LARGE).unwrap();
        let expected = "### goldray: 1 of 2 do not match\n\n2 judged: 1 match, 1 differs (1.23 s)\n\n\
                        | fixture | verdict | why | what to do |\n|---|---|---|---|\n\
                        | <code>fixtures/a/f000.ron:14:9</code> | differs | expected \
                        identical pictures | if meant: <code>cargo xtask bless a/f000</code> |\n";
        assert_eq!(page, expected);
        let green = markdown(&all[1..], 0.0, &Reader::default(), LARGE).unwrap();
        assert_eq!(green, "### goldray: all 1 match\n\n1 judged: 1 match (0.00 s)\n");
    }

    #[test]
    fn what_is_beyond_fifty_is_folded() {
        let page = |n| markdown(&failing(n), 0.0, &Reader::default(), LARGE).unwrap();
        assert!(!page(50).contains("<details>") && rows(&page(50)) == 50);
        let page = page(53);
        assert_eq!(rows(&page), 53);
        let (open, folded) =
            page.split_once("\n<details><summary>3 more</summary>\n\n| fixture").unwrap();
        assert_eq!((rows(open), rows(folded)), (50, 3));
        assert!(folded.ends_with("|\n\n</details>\n"), "{folded}");
    }

    #[test]
    fn it_is_cut_between_rows_and_says_so() {
        let all = failing(90);
        let whole = markdown(&all, 0.0, &Reader::default(), LARGE).unwrap();
        for max_bytes in (400..whole.len()).step_by(97) {
            let page = markdown(&all, 0.0, &Reader::default(), max_bytes).unwrap();
            assert!(page.len() <= max_bytes, "{} of {max_bytes}", page.len());
            let left = 90 - rows(&page);
            assert!(page.ends_with(&format!(
                "\n{left} more are left out, as the page would be too large.\n"
            )));
            let count = |tag| page.matches(tag).count();
            assert_eq!(count("<details>"), count("</details>"));
        }
        assert_eq!(markdown(&all, 0.0, &Reader::default(), 300), None);
        assert_eq!(markdown(&all, 0.0, &Reader::default(), 0), None);
    }
}
