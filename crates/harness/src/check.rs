//! `Check`: what a fixture's `check` says, beside its scene.

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
