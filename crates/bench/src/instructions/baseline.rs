//! The committed counts, and what another run's are against them.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde::{Deserialize, Serialize};

/// Counts by the name of the work.
pub(crate) type Counts = BTreeMap<String, u64>;

/// By what share a count may grow. Runs of one build differ by less than 0.1 %,
/// where a hash table's seed has a say, and most not at all. The C library's
/// memory functions are counted with the rest: with those for a processor
/// without AVX, counts move by up to 1.9 %, and with an allocator that takes
/// other ways by up to 0.9 %. valgrind has no AVX-512 and shows none to the
/// program, so whether the processor has it makes no difference.
pub(super) const TOLERANCE: f64 = 0.03;

/// What is committed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Baseline {
    /// The version of this form.
    pub(super) schema: u32,
    /// By what share of itself a count may grow.
    pub(super) tolerance: f64,
    /// The levels of the processor that the program could choose among.
    pub(super) levels: Vec<String>,
    /// The compiler.
    pub(super) rustc: String,
    /// Instructions by the name of the work.
    pub(super) instructions: Counts,
}

impl Baseline {
    /// The baseline in this text of the file at `path`.
    pub(super) fn read(path: &Path, text: &str) -> Result<Self, String> {
        let refuse = |why: String| format!("{}: {why}", path.display());
        let read: Self = serde_json::from_str(text).map_err(|error| {
            refuse(format!("expected a baseline as --write makes it, found another text: {error}"))
        })?;
        if read.schema != 1 {
            return Err(refuse(format!("expected schema 1, found {}", read.schema)));
        }
        if !(0.0..1.0).contains(&read.tolerance) {
            return Err(refuse(format!(
                "expected a tolerance from 0 to 1, found {}",
                read.tolerance
            )));
        }
        Ok(read)
    }
}

/// What is said of one count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Within the tolerance.
    Same,
    /// By more than the tolerance.
    Grew,
    /// By more than the tolerance.
    Shrank,
    /// Not in the baseline.
    Unknown,
    /// In the baseline only.
    Gone,
}

impl Verdict {
    /// Whether the guard fails for it.
    pub(super) fn is_bad(self) -> bool {
        matches!(self, Self::Grew | Self::Unknown | Self::Gone)
    }

    fn words(self) -> &'static str {
        match self {
            Self::Same => "",
            Self::Grew => "GREW",
            Self::Shrank => "shrank: --write keeps it so",
            Self::Unknown => "NOT IN THE BASELINE",
            Self::Gone => "IN THE BASELINE, BUT THERE IS NO SUCH WORK",
        }
    }
}

/// One work in the baseline and in this run.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub(super) name: String,
    pub(super) before: Option<u64>,
    pub(super) after: Option<u64>,
    pub(super) verdict: Verdict,
}

/// Every work of either, by name.
pub(super) fn judge(baseline: &Baseline, counts: &Counts) -> Vec<Row> {
    let old = &baseline.instructions;
    let mut names: Vec<_> = old.keys().chain(counts.keys()).collect();
    names.sort();
    names.dedup();
    let row = |name: &String| {
        let (before, after) = (old.get(name).copied(), counts.get(name).copied());
        let verdict = match (before, after) {
            (Some(before), Some(after)) => {
                let allowed = before as f64 * baseline.tolerance;
                match after as f64 - before as f64 {
                    grown if grown > allowed => Verdict::Grew,
                    grown if grown < -allowed => Verdict::Shrank,
                    _ => Verdict::Same,
                }
            }
            (None, _) => Verdict::Unknown,
            (Some(_), None) => Verdict::Gone,
        };
        Row { name: name.clone(), before, after, verdict }
    };
    names.into_iter().map(row).collect()
}

/// The rows for people.
pub(super) fn table(rows: &[Row], tolerance: f64) -> String {
    let mut text = format!("{:<18} {:>13} {:>13} {:>9}\n", "instructions", "baseline", "here", "");
    let number = |count: Option<u64>| count.map_or("-".to_owned(), |count| count.to_string());
    for Row { name, before, after, verdict } in rows {
        let change = match (before, after) {
            (Some(before), Some(after)) => {
                format!("{:+.2} %", (*after as f64 / *before as f64 - 1.0) * 100.0)
            }
            _ => String::new(),
        };
        let line = format!(
            "{name:<18} {:>13} {:>13} {change:>9}  {}",
            number(*before),
            number(*after),
            verdict.words()
        );
        // Writing into a string does not fail.
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let _ = writeln!(text, "each may grow by {} %", tolerance * 100.0);
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn baseline(counts: &[(&str, u64)]) -> Baseline {
        Baseline {
            schema: 1,
            tolerance: TOLERANCE,
            levels: vec!["avx2".into()],
            rustc: "rustc".into(),
            instructions: of(counts),
        }
    }

    fn of(counts: &[(&str, u64)]) -> Counts {
        counts.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect()
    }

    #[test]
    fn only_what_grows_beyond_the_tolerance_fails() {
        let verdict = |after| judge(&baseline(&[("a", 1_000)]), &of(&[("a", after)]))[0].verdict;
        assert_eq!(verdict(1_000), Verdict::Same);
        assert_eq!(verdict(1_030), Verdict::Same);
        assert_eq!(verdict(1_031), Verdict::Grew);
        assert_eq!(verdict(970), Verdict::Same);
        assert_eq!(verdict(969), Verdict::Shrank);
        assert!(Verdict::Grew.is_bad() && !Verdict::Shrank.is_bad() && !Verdict::Same.is_bad());
    }

    #[test]
    fn what_is_on_one_side_only_fails_and_is_named() {
        let rows = judge(&baseline(&[("a", 5), ("b", 5)]), &of(&[("b", 5), ("c", 5)]));
        let verdicts: Vec<_> = rows.iter().map(|row| row.verdict).collect();
        assert_eq!(verdicts, [Verdict::Gone, Verdict::Same, Verdict::Unknown]);
        assert_eq!(rows.iter().filter(|row| row.verdict.is_bad()).count(), 2);
        let text = table(&rows, TOLERANCE);
        assert!(text.contains("c  ") && text.contains("NOT IN THE BASELINE"), "{text}");
        assert!(text.contains("each may grow by 3 %"), "{text}");
    }

    #[test]
    fn a_baseline_comes_back_and_another_text_is_refused() {
        let path = Path::new("baseline.json");
        let text = serde_json::to_string(&baseline(&[("a", 5)])).unwrap();
        assert_eq!(Baseline::read(path, &text), Ok(baseline(&[("a", 5)])));
        let refused = |text: &str| Baseline::read(path, text).unwrap_err();
        assert!(refused("{}").contains("baseline.json: expected a baseline"));
        assert!(refused(&text.replace("\"schema\":1", "\"schema\":2")).contains("found 2"));
        assert!(refused(&text.replace("0.03", "3.0")).contains("tolerance from 0 to 1, found 3"));
    }
}
