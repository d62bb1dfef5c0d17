//! `visible-defect`: damage that people see must not pass a fixture's limits.

use super::{Around, Finding, Rule, finding, limits_path};
use crate::called::command;
use crate::case::Case;
use crate::sensitivity::{DEFECTS, missed, with_unit};

pub(super) const RULE: Rule =
    Rule { name: "visible-defect", asks: "no damage that people see passes the limits", find };

fn find(case: &Case, around: &Around<'_>) -> Vec<Finding> {
    let limits = case.fixture.check.limits.as_ref();
    let one = |defect| {
        let miss = missed(defect, limits, &case.golden.picture, around.visible)?;
        let seen = with_unit(around.visible.strength(defect), defect.unit);
        let found = with_unit(miss.strength, defect.unit);
        let message = format!(
            "expected limits that catch `{}` from {seen} on, found that {found} {} passes, which \
             changes codes by up to {}",
            defect.name, miss.place, miss.change
        );
        let help = format!(
            "tighten the limits, or leave them out: `{} calibrate` says what the tracer needs",
            command()
        );
        Some(finding(case, &RULE, &limits_path(), message, help))
    };
    DEFECTS.iter().filter_map(one).collect()
}
