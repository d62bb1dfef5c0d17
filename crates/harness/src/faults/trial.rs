//! `Trial`: one fixture held against its golden and what it expects, by a
//! renderer with a fault.

use serde::{Deserialize, Serialize};

/// What one fixture says of one fault.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The fixture's name.
    pub fixture: String,
    /// Whether the place of the fault was reached at all.
    pub reached: bool,
    /// What came of it.
    pub fate: Fate,
}

/// What came of a trial.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fate {
    /// The fixture matches: it does not notice.
    Survived,
    /// The fixture fails.
    Killed(Evidence),
    /// There is no picture to judge: the scene was refused, or its picture has a
    /// NaN in it.
    Refused(String),
    /// The renderer panicked, or had not come to an end in time.
    Crashed(String),
}

/// Why a fixture fails.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Evidence {
    /// Whether the picture is farther from its golden than the limits allow.
    pub golden: bool,
    /// How many expectations and relations the picture breaks, which need no
    /// golden.
    pub on_paper: u32,
    /// How many pixels differ from the golden.
    pub differing_pixels: u64,
    /// The largest difference of a channel, in codes.
    pub max_abs: u8,
    /// The lowest SSIM of any window.
    pub ssim_min: f64,
}

/// Those of the fixtures that are no match without any fault, so that they can
/// say nothing of one.
#[cfg(feature = "faults")]
pub fn not_matching(suite: &crate::suite::Suite, names: &[String]) -> Vec<String> {
    use rayon::prelude::*;

    tracer::fault::seed(None);
    let is_match = |name: &&String| {
        crate::run::judge_fixture(suite, name).judgment.verdict == crate::verdict::Verdict::Match
    };
    names.par_iter().filter(|name| !is_match(name)).cloned().collect()
}

/// Renders and judges these fixtures with a fault, one after the other;
/// `on_each` hears of each as it is done. The fault is on for the whole process,
/// and off again in the end.
#[cfg(feature = "faults")]
pub fn try_fault(
    suite: &crate::suite::Suite,
    names: &[String],
    fault: tracer::fault::Fault,
    on_each: &mut dyn FnMut(Trial),
) {
    use std::panic::{AssertUnwindSafe, catch_unwind};

    for name in names {
        tracer::fault::seed(Some(fault));
        let judged = catch_unwind(AssertUnwindSafe(|| crate::run::judge_fixture(suite, name)));
        let reached = tracer::fault::was_reached();
        let fate = match judged {
            Ok(judged) => fate(&judged),
            Err(_) => Fate::Crashed("panicked".to_owned()),
        };
        on_each(Trial { fixture: name.clone(), reached, fate });
    }
    tracer::fault::seed(None);
}

#[cfg(feature = "faults")]
fn fate(judged: &crate::run::Judged) -> Fate {
    use crate::judge::broken_expectations;
    use crate::verdict::Verdict;

    let (fixture, picture) = match &judged.rendered {
        Ok(rendered) => rendered,
        Err(why) => return Fate::Refused(why.lines().next().unwrap_or_default().to_owned()),
    };
    let judgment = &judged.judgment;
    if judgment.verdict == Verdict::Match {
        return Fate::Survived;
    }
    let comparison = judgment.comparison.as_ref();
    Fate::Killed(Evidence {
        golden: matches!(judgment.verdict, Verdict::Differs | Verdict::WrongSize),
        on_paper: (broken_expectations(fixture, picture).len() + judgment.broken_relations.len())
            as u32,
        differing_pixels: comparison.map_or(0, |c| c.differing_pixels),
        max_abs: comparison.map_or(0, |c| c.max_abs),
        ssim_min: comparison.map_or(1.0, |c| c.ssim_min),
    })
}
