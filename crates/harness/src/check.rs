//! `Check`: what a fixture's `check` says, beside its scene.

use std::collections::BTreeMap;

use scene::format::by_name;
use scene::{SceneFile, Step};
use serde::{Deserialize, Serialize};

use crate::expectation::Expectation;
use crate::limits::Limits;
use crate::relation::Relation;

/// A fixture as it was written.
pub type File = SceneFile<Check>;

/// The part of a fixture that is about its picture. All of it may be left out:
/// the picture is then held to be identical to its golden.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// How far the picture may be from its golden.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limits: Option<Limits>,
    /// What is known of the picture on paper.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub expect: Vec<Expectation>,
    /// Which other scenes' pictures it must be like.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub relations: Vec<Relation>,
    /// Why the golden's file may be larger than [`Check::MAX_FILE_BYTES`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub large: Option<String>,
    /// Other fixtures that are meant to have the very same golden, each with
    /// the reason.
    #[serde(
        default,
        skip_serializing_if = "BTreeMap::is_empty",
        deserialize_with = "by_name::deserialize"
    )]
    pub same_as: BTreeMap<String, String>,
    /// Objects and lights that are meant to change nothing in the picture, such
    /// as `"objects[1]"`, each with the reason. See [`Part`](crate::lint::Part).
    #[serde(
        default,
        skip_serializing_if = "BTreeMap::is_empty",
        deserialize_with = "by_name::deserialize"
    )]
    pub idle: BTreeMap<String, String>,
}

impl Check {
    /// The largest file of a golden whose fixture does not say why it is
    /// large, in bytes. Goldens stay in the repository's history for good; a
    /// picture of one idea takes about a tenth of this.
    pub const MAX_FILE_BYTES: usize = 20 << 10;

    /// What is wrong with a golden's file of so many bytes; `None` where it is
    /// small enough, or large for a reason.
    pub fn file_size_problem(&self, bytes: usize) -> Option<String> {
        let max = Self::MAX_FILE_BYTES;
        match &self.large {
            None if bytes > max => Some(format!(
                "the golden takes {bytes} bytes, expected at most {max}: make the picture smaller \
                 or plainer, or say why it must be so large: check: (large: \"...\")"
            )),
            Some(_) if bytes <= max => Some(format!(
                "the fixture's check says `large`, but its golden takes {bytes} bytes, no more than \
                 the {max} that any may: take `large` out"
            )),
            _ => None,
        }
    }
}

impl scene::Check for Check {
    fn examine(&self, image: (u32, u32), report: &mut dyn FnMut(Vec<Step>, String)) {
        if let Some(limits) = &self.limits {
            for (field, message) in limits.problems(u64::from(image.0) * u64::from(image.1)) {
                report(vec!["limits".into(), field.into()], message);
            }
        }
        if self.large.as_ref().is_some_and(|why| why.trim().is_empty()) {
            let message = "`large`: expected why the golden is large".to_owned();
            report(vec!["large".into()], message);
        }
        for (i, expectation) in self.expect.iter().enumerate() {
            for (field, message) in expectation.problems(image) {
                report(vec!["expect".into(), i.into(), field.into()], message);
            }
        }
        for (field, reasons) in [("same_as", &self.same_as), ("idle", &self.idle)] {
            for (key, _) in reasons.iter().filter(|(_, reason)| reason.trim().is_empty()) {
                report(vec![field.into(), Step::key(key)], format!("\"{key}\": expected why"));
            }
        }
    }

    fn examine_beside(&self, file: &File, report: &mut dyn FnMut(Vec<Step>, String)) {
        for (i, relation) in self.relations.iter().enumerate() {
            for (field, message) in relation.problems(file) {
                let place = ["relations".into(), i.into()].into_iter();
                report(place.chain(field.map(Step::from)).collect(), message);
            }
        }
    }
}
