//! Outcomes as lines for people.

use crate::blame::Blamed;
use crate::called;
use crate::metric::{Comparison, METRICS};
use crate::suite::Suite;
use crate::verdict::{Origin, Outcome, Verdict, shell_word};

/// Where a report is read: what to put into paths and commands so that they
/// work there.
#[derive(Debug, Clone, Default)]
pub struct Reader {
    /// Before a path relative to the suite: empty in the suite's own folder.
    pub path_prefix: String,
    /// After `cargo xtask`: ` --root ...` where the suite was named so.
    pub root_flag: String,
}

/// One line for an outcome: verdict, name, numbers, where to look, what to do.
/// A fixture with problems is followed by them, indented. JSON has all
/// findings; a line has the first three.
///
/// ```
/// use harness::report::{Reader, outcome_line};
/// use harness::verdict::{Origin, Outcome, Verdict};
///
/// let outcome = Outcome {
///     name: "sphere/far".to_owned(),
///     verdict: Verdict::MissingGolden,
///     findings: vec!["there is no golden".to_owned()],
///     breaks_expectations: false,
///     breaks_relations: false,
///     keeps_golden: false,
///     comparison: None,
///     blamed: vec![],
///     place: None,
///     size: Some((64, 48)),
///     render_ms: 1.0,
///     compare_ms: 0.0,
///     relate_ms: 0.0,
///     strip: Some("target/goldray/sphere/far.png".to_owned()),
///     evidence: None,
///     origin: Origin::Rendered,
/// };
/// assert_eq!(
///     outcome_line(&outcome, &Reader::default()),
///     "missing golden      sphere/far: there is no golden | \
///      see target/goldray/sphere/far.png | if meant: cargo xtask bless sphere/far"
/// );
/// ```
pub fn outcome_line(outcome: &Outcome, reader: &Reader) -> String {
    // A refused fixture says itself where to look and what to do.
    let hints = match outcome.verdict {
        Verdict::RenderRefused => Vec::new(),
        _ => hints(outcome, reader),
    };
    join(&brief_line(outcome, reader), &hints)
}

/// The same without where to look and what to do.
pub fn brief_line(outcome: &Outcome, reader: &Reader) -> String {
    let head = format!("{:<19} {}", outcome.verdict.words(), outcome.name);
    if outcome.verdict == Verdict::RenderRefused {
        let details = outcome.findings.iter().flat_map(|f| f.lines());
        let details = details.map(|line| format!("\n    {line}"));
        return std::iter::once(head).chain(details).collect::<String>().trim_end().to_owned();
    }
    let parts = reasons_and_place(outcome, reader);
    if parts.is_empty() { head } else { format!("{head}: {}", parts.join(" | ")) }
}

/// The same as [`outcome_line`] with how long it took, and for a match, how
/// close it is.
pub fn full_line(outcome: &Outcome, reader: &Reader) -> String {
    let line = outcome_line(outcome, reader);
    let identical = outcome.comparison.as_ref().is_some_and(Comparison::is_identical);
    let mut parts = Vec::from_iter(identical.then(|| "identical".to_owned()));
    match (outcome.origin, outcome.size) {
        (Origin::Unchanged, _) => parts.push("unchanged since its last match".to_owned()),
        (_, None) => {}
        (_, Some((width, height))) => {
            let Outcome { render_ms, compare_ms, relate_ms, .. } = outcome;
            parts.push(format!(
                "{width} x {height}, rendered in {render_ms:.1} ms, compared in {compare_ms:.1}, \
                 relations in {relate_ms:.1}"
            ));
        }
    }
    join(&line, &parts)
}

fn join(line: &str, parts: &[String]) -> String {
    match parts.join(" | ") {
        more if more.is_empty() => line.to_owned(),
        more if line.contains(": ") => format!("{line} | {more}"),
        more => format!("{line}: {more}"),
    }
}

/// What [`outcome_line`] says after the name, each part for itself: findings,
/// numbers, what it lies on, where to look, what to do. Of a fixture with
/// problems, the lines that say them.
pub fn outcome_parts(outcome: &Outcome, reader: &Reader) -> Vec<String> {
    if outcome.verdict == Verdict::RenderRefused {
        return outcome.findings.iter().flat_map(|f| f.lines()).map(str::to_owned).collect();
    }
    [reasons_and_place(outcome, reader), hints(outcome, reader)].concat()
}

fn reasons_and_place(outcome: &Outcome, reader: &Reader) -> Vec<String> {
    let mut parts = reasons(outcome, reader);
    // Of objects it was just said where they are.
    let is_said = outcome.blamed.iter().any(|blamed| blamed.object.is_some());
    if let (Some((line, column)), false) = (outcome.place, is_said) {
        parts.push(format!("at {}:{line}:{column}", file(outcome, reader)));
    }
    parts
}

/// Why, in as many parts as there are: findings, numbers, what is to blame.
pub(super) fn reasons(outcome: &Outcome, reader: &Reader) -> Vec<String> {
    let findings = &outcome.findings;
    let mut parts = Vec::new();
    if !findings.is_empty() {
        let more = match findings.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!("; and {more} more, see --json"),
        };
        let shown = &findings[..findings.len().min(SHOWN)];
        parts.push(format!("{}{more}", shown.join("; ")));
    }
    parts.extend(evidence(outcome, reader));
    parts
}

/// The numbers that say most, and what is to blame.
pub(super) fn evidence(outcome: &Outcome, reader: &Reader) -> Vec<String> {
    let Outcome { name, comparison, blamed, .. } = outcome;
    let mut parts = Vec::new();
    if let Some(comparison) = comparison.as_ref().filter(|c| !c.is_identical()) {
        parts.push(numbers(comparison));
    }
    if !blamed.is_empty() {
        let shown = blamed.iter().take(SHOWN).map(|blamed| blame_words(name, blamed, reader));
        parts.push(format!("on {}", shown.collect::<Vec<_>>().join(", ")));
    }
    parts
}

/// Where to look and what to do.
fn hints(outcome: &Outcome, reader: &Reader) -> Vec<String> {
    let mut parts = Vec::new();
    if let Some(strip) = &outcome.strip {
        parts.push(format!("see {}{strip}", reader.path_prefix));
    }
    parts.extend(advice(outcome, reader));
    parts
}

/// What to do about it, where that is known.
pub(super) fn advice(outcome: &Outcome, reader: &Reader) -> Option<String> {
    if let Some(command) = command(outcome, reader) {
        // Nobody draws by hand what a golden shows.
        let is_damaged = matches!(outcome.verdict, Verdict::TamperedGolden | Verdict::Unreadable);
        let restore = if is_damaged {
            format!("restore {} from the repository, or ", golden(outcome, reader))
        } else {
            String::new()
        };
        return Some(format!("{restore}if meant: {command}"));
    }
    if outcome.verdict == Verdict::Unsteady {
        return Some("mend the tracer: the same scene must give the same bits".to_owned());
    }
    let breaks = outcome.breaks_its_word();
    breaks.then(|| "mend the scene, the tracer, or what the fixture expects".to_owned())
}

/// The whole command that settles it, if it was meant.
pub(super) fn command(outcome: &Outcome, reader: &Reader) -> Option<String> {
    outcome.remedy().map(|remedy| format!("{}{} {remedy}", called::command(), reader.root_flag))
}

/// The command that judges it again.
pub(super) fn rerun(name: &str, reader: &Reader) -> String {
    format!("{}{} check {}", called::command(), reader.root_flag, shell_word(name))
}

fn golden(outcome: &Outcome, reader: &Reader) -> String {
    format!("{}{}", reader.path_prefix, Suite::golden_label(&outcome.name))
}

/// The file that a failure is about, where the reader finds it.
pub(super) fn file(outcome: &Outcome, reader: &Reader) -> String {
    match outcome.verdict {
        Verdict::OrphanGolden => golden(outcome, reader),
        _ => format!("{}{}", reader.path_prefix, Suite::fixture_label(&outcome.name)),
    }
}

/// Of findings, and of objects that are blamed.
const SHOWN: usize = 3;

/// `the Sphere of fixtures/a.ron:14:9 (62 %)`.
fn blame_words(name: &str, blamed: &Blamed, reader: &Reader) -> String {
    let percent = (100.0 * blamed.share).round();
    match &blamed.object {
        None => format!("the background ({percent} %)"),
        Some((_, place)) => {
            let (file, prefix) = (Suite::fixture_label(name), &reader.path_prefix);
            let scene::Place { kind, line, column } = place;
            format!("the {kind} of {prefix}{file}:{line}:{column} ({percent} %)")
        }
    }
}

/// The numbers of a comparison that say most, in one line.
pub fn numbers(c: &Comparison) -> String {
    let (wx, wy) = c.ssim_min_at;
    let first = c.first_differing.map_or(String::new(), |(x, y)| format!(", first ({x}, {y})"));
    format!(
        "{} px differ{first}, by up to {}/255, ssim {:.6}, worst window {:.6} at ({wx}, {wy})",
        c.differing_pixels, c.max_abs, c.ssim_mean, c.ssim_min
    )
}

/// Every metric of a comparison, a line each.
pub fn comparison_lines(c: &Comparison) -> String {
    let line = |m: &crate::metric::Metric| {
        let value = (m.value)(c).map_or("-".to_owned(), |v| format!("{v}"));
        let note = if m.limit.is_some() { "" } else { " (reported only)" };
        format!("{:<22} {value}{note}\n", m.name)
    };
    METRICS.iter().map(line).collect()
}
