//! Outcomes as lines for people.

use std::collections::BTreeMap;
use std::fmt;

use crate::blame::Blamed;
use crate::metric::{Comparison, METRICS};
use crate::suite::Suite;
use crate::verdict::{Origin, Outcome, Verdict};

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
///     has_later_golden: false,
///     comparison: None,
///     blamed: vec![],
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
    let head = format!("{:<19} {}", outcome.verdict.words(), outcome.name);
    let parts = outcome_parts(outcome, reader);
    if outcome.verdict == Verdict::RenderRefused {
        let details = parts.iter().map(|line| format!("    {line}\n"));
        return format!("{head}\n{}", details.collect::<String>()).trim_end().to_owned();
    }
    if parts.is_empty() { head } else { format!("{head}: {}", parts.join(" | ")) }
}

/// What [`outcome_line`] says after the name, each part for itself: findings,
/// numbers, what it lies on, where to look, what to do. Of a fixture with
/// problems, the lines that say them.
pub fn outcome_parts(outcome: &Outcome, reader: &Reader) -> Vec<String> {
    let Outcome { name, verdict, findings, comparison, blamed, strip, .. } = outcome;
    if *verdict == Verdict::RenderRefused {
        return findings.iter().flat_map(|f| f.lines()).map(str::to_owned).collect();
    }
    let mut parts = Vec::new();
    if !findings.is_empty() {
        let more = match findings.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!("; and {more} more, see --json"),
        };
        let shown = &findings[..findings.len().min(SHOWN)];
        parts.push(format!("{}{more}", shown.join("; ")));
    }
    if let Some(comparison) = comparison.as_ref().filter(|c| !c.is_identical()) {
        parts.push(numbers(comparison));
    }
    if !blamed.is_empty() {
        let shown = blamed.iter().take(SHOWN).map(|blamed| blame_words(name, blamed, reader));
        parts.push(format!("on {}", shown.collect::<Vec<_>>().join(", ")));
    }
    if let Some(strip) = strip {
        parts.push(format!("see {}{strip}", reader.path_prefix));
    }
    if let Some(remedy) = outcome.remedy() {
        let flag = &reader.root_flag;
        parts.push(format!("if meant: cargo xtask{flag} {remedy}"));
    } else if outcome.breaks_its_word() {
        parts.push("mend the scene, the tracer, or what the fixture expects".to_owned());
    }
    parts
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

/// How many of each verdict.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Summary {
    /// How many fixtures and orphan goldens were judged.
    pub total: usize,
    /// How many of each verdict there is one of.
    pub counts: BTreeMap<Verdict, usize>,
    /// How many of them were unchanged since their last match.
    pub unchanged: usize,
    /// How many of the unchanged were rendered again as an audit.
    pub audited: usize,
    /// How many of the audited were no match, against what was recorded.
    pub belied: usize,
}

impl Summary {
    /// Whether everything matches and there was something to match.
    pub fn is_green(&self) -> bool {
        self.total > 0 && self.counts.get(&Verdict::Match) == Some(&self.total)
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} judged:", self.total)?;
        for (i, (verdict, count)) in self.counts.iter().enumerate() {
            let comma = if i == 0 { "" } else { "," };
            write!(f, "{comma} {count} {}", verdict.words())?;
        }
        if self.unchanged > 0 {
            let Self { unchanged, audited, .. } = self;
            write!(f, " ({unchanged} unchanged since their last match, {audited} of them ")?;
            write!(f, "rendered again as an audit)")?;
        }
        Ok(())
    }
}

/// Counts the verdicts.
pub fn summarize(outcomes: &[Outcome]) -> Summary {
    let mut counts = BTreeMap::new();
    for outcome in outcomes {
        *counts.entry(outcome.verdict).or_default() += 1;
    }
    let count = |of: &[Origin]| outcomes.iter().filter(|o| of.contains(&o.origin)).count();
    Summary {
        total: outcomes.len(),
        counts,
        unchanged: count(&[Origin::Unchanged, Origin::Audited, Origin::Belied]),
        audited: count(&[Origin::Audited, Origin::Belied]),
        belied: count(&[Origin::Belied]),
    }
}
