//! `Check`: what a fixture's `check` says, beside its scene.

use std::collections::BTreeMap;

use scene::Step;
use serde::{Deserialize, Serialize};

use crate::expectation::Expectation;
use crate::limits::Limits;

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
    /// Other fixtures that are meant to have the very same golden, each with
    /// the reason.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub same_as: BTreeMap<String, String>,
    /// Objects and lights that are meant to change nothing in the picture, such
    /// as `"objects[1]"`, each with the reason. See [`Part`](crate::lint::Part).
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub idle: BTreeMap<String, String>,
}

impl scene::Check for Check {
    fn examine(&self, image: (u32, u32), report: &mut dyn FnMut(Vec<Step>, String)) {
        if let Some(limits) = &self.limits {
            for (field, message) in limits.problems(u64::from(image.0) * u64::from(image.1)) {
                report(vec!["limits".into(), field.into()], message);
            }
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
}
