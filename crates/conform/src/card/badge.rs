//! `badge`: one line of a renderer's card as a picture for a README.

use std::fmt::Write as _;

use super::{Column, Selection};
use crate::result::held_to;
use crate::xml;

/// What stands on the left.
const LABEL: &str = "goldray";

/// Space beside the words, in pixels.
const MARGIN: u32 = 7;

/// The badge of a renderer, an SVG file: so many of its fixtures pass. Those that its
/// adapter does not support are among the others, and its title says how many they are.
/// Where only a part of the suite was asked for, it says so.
pub fn badge(column: &Column, selection: Option<&Selection>) -> String {
    let tally = &column.tally;
    let (passed, total) = (tally.passed(), tally.total());
    let words = match total {
        0 => "no fixtures".to_owned(),
        _ if selection.is_some() => format!("{passed} of {total} pass, a part of the suite"),
        _ => format!("{passed} of {total} pass"),
    };
    let rest = tally.rest_words();
    let rest = if rest.is_empty() { rest } else { format!(" ({rest})") };
    let held_to = held_to(column.tolerance, column.edge_reach);
    let part = selection.map_or(String::new(), |part| format!("; {}", part.words()));
    let name = scene::visible(&column.info.name);
    let title = format!("{LABEL}: {name}: {words}{rest}, held to {held_to}{part}");
    draw(&title, &words, color(passed, total))
}

/// Whether a file begins as those of [`badge`] do, whatever it tells.
pub(super) fn is_badge(file: &[u8]) -> bool {
    let head = &file[..file.len().min(HEAD_BYTES)];
    let head = String::from_utf8_lossy(head);
    head.starts_with("<svg ") && head.contains(&format!("<title id=\"t\">{LABEL}: "))
}

/// The beginning of a badge, up to its title, is no longer.
const HEAD_BYTES: usize = 256;

/// Colors that white letters can be read on: their contrast is 4.5 or more.
fn color(passed: u64, total: u64) -> &'static str {
    const GRAY: &str = "#6a6a6a";
    const GREEN: &str = "#18703a";
    const YELLOW: &str = "#7d6400";
    const RED: &str = "#b3261e";
    match (passed, total) {
        (_, 0) => GRAY,
        (passed, total) if passed == total => GREEN,
        (passed, total) if 2 * passed >= total => YELLOW,
        _ => RED,
    }
}

fn draw(title: &str, words: &str, color: &str) -> String {
    const HEIGHT: u32 = 20;
    let (left, right) = (width(LABEL) + 2 * MARGIN, width(words) + 2 * MARGIN);
    let all = left + right;
    let title = xml::text(title);
    let mut svg = String::new();
    // Writing to a String cannot fail.
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{all}\" height=\"{HEIGHT}\" \
         viewBox=\"0 0 {all} {HEIGHT}\" role=\"img\" aria-labelledby=\"t\">\n\
         <title id=\"t\">{title}</title>\n\
         <clipPath id=\"r\"><rect width=\"{all}\" height=\"{HEIGHT}\" rx=\"3\"/></clipPath>\n\
         <g clip-path=\"url(#r)\">\n\
         <rect width=\"{left}\" height=\"{HEIGHT}\" fill=\"#3a3a3e\"/>\n\
         <rect x=\"{left}\" width=\"{right}\" height=\"{HEIGHT}\" fill=\"{color}\"/>\n\
         </g>\n\
         <g fill=\"#fff\" font-family=\"Verdana,DejaVu Sans,Geneva,sans-serif\" font-size=\"11\" \
         aria-hidden=\"true\">"
    );
    for (text, start) in [(LABEL, MARGIN), (words, left + MARGIN)] {
        // Other letters than these were measured for are pressed to their width.
        let _ = writeln!(
            svg,
            "<text x=\"{start}\" y=\"14\" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\">{}</text>",
            width(text),
            xml::text(text)
        );
    }
    svg + "</g>\n</svg>\n"
}

/// About how wide a text is in Verdana at 11 pixels.
fn width(text: &str) -> u32 {
    let tenths = |c: char| match c {
        'i' | 'j' | 'l' => 30,
        ' ' | 'f' | 't' | 'r' | '.' | ',' => 41,
        's' | 'c' | 'z' => 58,
        'm' | 'w' => 98,
        _ => 69,
    };
    text.chars().map(tenths).sum::<u32>().div_ceil(10)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::card::Tally;
    use crate::trial::{result, run};
    use crate::{Outcome, RendererInfo};

    fn of(name: &str, outcomes: &[Outcome]) -> String {
        let results: Vec<_> = outcomes.iter().map(|&outcome| result(outcome, 0.0)).collect();
        let run = run("r");
        let tally = Tally::of(std::iter::repeat("f").zip(&results));
        let info = RendererInfo { name: name.to_owned(), ..run.renderer };
        badge(&Column { info, tolerance: 0.0, edge_reach: 0.0, tally }, None)
    }

    #[track_caller]
    fn check(outcomes: &[Outcome], words: &str, title: &str, color: &str) {
        let svg = of("R", outcomes);
        assert!(svg.contains(&format!(">{words}</text>")), "{svg}");
        assert!(svg.contains(&format!("<title id=\"t\">{title}, held to 0</title>")), "{svg}");
        assert!(svg.contains(&format!("fill=\"{color}\"")), "{svg}");
    }

    #[test]
    fn it_says_how_many_pass_and_what_became_of_the_rest() {
        use Outcome::{Crashed, Fail, Pass, Unsupported};
        check(&[], "no fixtures", "goldray: R: no fixtures", "#6a6a6a");
        check(&[Pass; 3], "3 of 3 pass", "goldray: R: 3 of 3 pass", "#18703a");
        let most = [Pass, Fail, Pass, Unsupported];
        let title = "goldray: R: 2 of 4 pass (1 fail, 1 unsupported)";
        check(&most, "2 of 4 pass", title, "#7d6400");
        check(
            &[Pass, Crashed, Crashed],
            "1 of 3 pass",
            "goldray: R: 1 of 3 pass (2 crashed)",
            "#b3261e",
        );
    }

    #[test]
    fn a_name_is_text_and_nothing_else() {
        let svg = of("<script>&\"\u{202e}\u{1}", &[]);
        assert!(svg.contains("goldray: &lt;script&gt;&amp;&quot;\\u{202e}\\u{1}: no"), "{svg}");
        assert_eq!(svg.matches('<').count(), svg.matches('>').count());
    }
}
