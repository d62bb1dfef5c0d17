//! `judge`: a fixture's picture against its golden and its expectations.
//!
//! A mismatch is a value here, never an error.

use crate::encode::EncodedImage;
use crate::expectation::Rendered;
use crate::fixture::Fixture;
use crate::golden::Golden;
use crate::limits::Limits;
use crate::metric::{Comparison, compare};
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
    /// The metrics, where they could be had.
    pub comparison: Option<Comparison>,
}

/// Judges a picture. Where several things are wrong, the verdict is the first
/// of: unreadable golden, missing golden, stale golden, wrong size, differs,
/// broken expectation, golden without provenance; all of them are findings.
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
    let breaks_expectations = !broken.is_empty();
    findings.extend(broken);
    Judgment { verdict, findings, breaks_expectations, comparison }
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
    if let Some(provenance) = &golden.provenance {
        let now = &fixture.provenance;
        let parts = [
            ("the scene", provenance.scene == now.scene),
            ("a file that the scene names", provenance.assets == now.assets),
            ("the way of hashing", provenance.schema == now.schema),
        ];
        let changed: Vec<_> = parts.iter().filter(|part| !part.1).map(|part| part.0).collect();
        if !changed.is_empty() {
            findings
                .push(format!("{} changed since the golden was accepted", changed.join(" and ")));
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
