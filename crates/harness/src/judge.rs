//! `judge`: a fixture's picture against its golden and its expectations.
//!
//! A mismatch is a value here, never an error.

use crate::called::command;
use crate::encode::EncodedImage;
use crate::expectation::Rendered;
use crate::fixture::Fixture;
use crate::golden::{self, Golden, Provenance};
use crate::lfs::is_of_pointer;
use crate::limits::Limits;
use crate::metric::{Comparison, compare};
use crate::store::StoreError;
use crate::verdict::Verdict;

/// What was found in the golden's place.
#[derive(Debug, Clone, PartialEq)]
pub enum Found {
    /// Nothing.
    Nothing,
    /// A file that is no golden, and why.
    Unreadable(String),
    /// A golden.
    Golden(Golden),
}

impl Found {
    /// What the file in the golden's place holds.
    pub(crate) fn in_file(file: Result<Option<Vec<u8>>, StoreError>) -> Self {
        match file {
            Ok(None) => Self::Nothing,
            Ok(Some(bytes)) => match golden::from_png(&bytes) {
                Ok(golden) => Self::Golden(golden),
                Err(why) => Self::Unreadable(why),
            },
            Err(error) => Self::Unreadable(error.what),
        }
    }

    /// The golden's picture, if there is one.
    pub fn picture(&self) -> Option<&EncodedImage> {
        match self {
            Self::Golden(golden) => Some(&golden.picture),
            Self::Nothing | Self::Unreadable(_) => None,
        }
    }
}

/// A verdict with what led to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgment {
    /// What is said.
    pub verdict: Verdict,
    /// Why, in sentences.
    pub findings: Vec<String>,
    /// Whether the picture breaks what its fixture expects.
    pub breaks_expectations: bool,
    /// The relations that the picture breaks, in words.
    pub broken_relations: Vec<String>,
    /// The metrics, where they could be had.
    pub comparison: Option<Comparison>,
}

/// Judges a picture. Where several things are wrong, the verdict is the first
/// of: unreadable golden, missing golden, tampered golden, stale golden, wrong
/// size, differs, broken expectation, golden without provenance, size of the
/// golden's file; all of them are findings.
/// Nothing is rendered: relations are asked by [`crate::relation::broken`], and
/// come after all these.
pub fn judge(fixture: &Fixture, picture: &Rendered, found: &Found) -> Judgment {
    let broken = broken_expectations(fixture, picture);
    let (verdict, mut findings, comparison) = against_golden(fixture, picture, found);
    let verdict = match verdict {
        Verdict::Match if !broken.is_empty() => Verdict::ExpectationFailed,
        Verdict::Match if no_provenance(found) => {
            findings.push("the golden does not say for which scene it was accepted".to_owned());
            Verdict::StaleGolden
        }
        verdict => verdict,
    };
    let verdict = match file_size_problem(fixture, found) {
        None => verdict,
        Some(problem) => {
            findings.push(problem);
            if verdict == Verdict::Match { Verdict::GoldenFileSize } else { verdict }
        }
    };
    let breaks_expectations = !broken.is_empty();
    findings.extend(broken);
    Judgment { verdict, findings, breaks_expectations, broken_relations: Vec::new(), comparison }
}

impl Judgment {
    /// The same with the relations that the picture breaks: they are findings,
    /// and the verdict where it would be a match.
    #[must_use]
    pub fn with_relations(mut self, broken: Vec<String>) -> Self {
        if self.verdict == Verdict::Match && !broken.is_empty() {
            self.verdict = Verdict::RelationFailed;
        }
        self.findings.extend(broken.iter().cloned());
        self.broken_relations = broken;
        self
    }

    /// The same with how renders of the fixture differ, if they do: that is the
    /// verdict then, as no other can be trusted.
    #[must_use]
    pub fn with_steadiness(mut self, difference: Option<String>) -> Self {
        if let Some(difference) = difference {
            self.verdict = Verdict::Unsteady;
            self.findings.insert(0, difference);
        }
        self
    }
}

/// Whether a picture in a golden's place is not within these limits: what
/// [`judge`] says of it, without the metrics that no limit asks for.
pub fn is_caught(limits: Option<&Limits>, golden: &EncodedImage, picture: &EncodedImage) -> bool {
    if limits.is_none() {
        return golden != picture;
    }
    let comparison = compare(golden, picture);
    comparison.is_none_or(|comparison| !Limits::broken_by(limits, &comparison).is_empty())
}

/// The expectations that the picture breaks, in words.
pub fn broken_expectations(fixture: &Fixture, picture: &Rendered) -> Vec<String> {
    let expectations = fixture.check.expect.iter();
    expectations.filter_map(|expectation| expectation.check(picture).err()).collect()
}

fn file_size_problem(fixture: &Fixture, found: &Found) -> Option<String> {
    let Found::Golden(golden) = found else { return None };
    fixture.check.file_size_problem(golden.file_bytes)
}

/// Why a golden must not be replaced: nobody here has looked at it. A newer
/// goldray accepted it, or Git LFS has not fetched it.
pub fn keeps(found: &Found) -> Option<String> {
    match found {
        Found::Unreadable(why) if is_of_pointer(why) => Some(format!("the golden {why}")),
        found => later_note(found),
    }
}

/// What is said of a golden that a newer goldray accepted: no verb of this one
/// settles it, and `bless` would throw away what was accepted.
fn later_note(found: &Found) -> Option<String> {
    let Found::Golden(Golden { provenance: Some(note), .. }) = found else { return None };
    note.is_later().then(|| {
        format!(
            "the golden's note is of version {}, expected at most {}: a newer goldray wrote it, \
             use that one",
            note.schema,
            Provenance::SCHEMA
        )
    })
}

fn no_provenance(found: &Found) -> bool {
    matches!(found, Found::Golden(Golden { provenance: None, .. }))
}

fn against_golden(
    fixture: &Fixture,
    picture: &Rendered,
    found: &Found,
) -> (Verdict, Vec<String>, Option<Comparison>) {
    let golden = match found {
        Found::Nothing => {
            return (Verdict::MissingGolden, vec!["there is no golden".into()], None);
        }
        Found::Unreadable(why) => {
            return (Verdict::Unreadable, vec![format!("the golden {why}")], None);
        }
        Found::Golden(golden) => golden,
    };
    let comparison = compare(&golden.picture, &picture.encoded);
    let mut findings = Vec::new();
    let mut verdicts = Vec::new();
    if golden.is_tampered() {
        let what = "the golden's picture is not the one that its note was written for: another \
                    program has changed the file";
        findings.push(what.to_owned());
        verdicts.push(Verdict::TamperedGolden);
    }
    if let Some(why) = later_note(found) {
        findings.push(why);
        verdicts.push(Verdict::StaleGolden);
    } else if let Some(provenance) = &golden.provenance {
        let now = &fixture.provenance;
        let parts = [
            ("the scene", provenance.scene == now.scene),
            ("a file that the scene names", provenance.assets == now.assets),
        ];
        let changed: Vec<_> = parts.iter().filter(|part| !part.1).map(|part| part.0).collect();
        if !changed.is_empty() {
            findings
                .push(format!("{} changed since the golden was accepted", changed.join(" and ")));
            verdicts.push(Verdict::StaleGolden);
        }
        if provenance.schema != now.schema {
            findings.push(format!(
                "the golden's note is of version {}, expected {}: `{} bless --repack` renews notes of \
                 an earlier version",
                provenance.schema,
                now.schema,
                command()
            ));
            verdicts.push(Verdict::StaleGolden);
        }
    }
    let (expected, actual) = (golden.picture.size(), picture.encoded.size());
    if let Some(comparison) = &comparison {
        let broken = Limits::broken_by(fixture.check.limits.as_ref(), comparison);
        if comparison.is_identical() && !verdicts.is_empty() {
            findings.push("the picture is the same".to_owned());
        }
        if !broken.is_empty() {
            findings.extend(broken);
            verdicts.push(Verdict::Differs);
        }
    } else {
        findings.push(format!(
            "the golden is {} x {}, the picture {} x {}",
            expected.width, expected.height, actual.width, actual.height
        ));
        verdicts.push(Verdict::WrongSize);
    }
    (verdicts.first().copied().unwrap_or(Verdict::Match), findings, comparison)
}

#[cfg(test)]
mod tests;
