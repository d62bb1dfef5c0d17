//! `loose-limit`: a limit is at most as loose as pictures of the scene are apart
//! when nothing but the way of making them changes, times a margin.

use super::{Around, Finding, Rule, finding, limits_path};
use crate::calibrate::{MARGIN, calibrate_fixture};
use crate::called::command;
use crate::case::Case;

pub(super) const RULE: Rule = Rule {
    name: "loose-limit",
    asks: "no limit is looser than the calibrated spread times its margin",
    find,
};

/// Measured anew, as only fixtures with limits need it: threads and
/// instructions, in the build that runs.
fn find(case: &Case, around: &Around<'_>) -> Vec<Finding> {
    let Some(limits) = &case.fixture.check.limits else { return Vec::new() };
    let calibrated = match calibrate_fixture(around.suite, &case.name, around.ways) {
        Ok(calibrated) => calibrated,
        Err(why) => {
            let message = format!("expected a fixture that can be calibrated, found: {why}");
            return vec![finding(case, &RULE, &limits_path(), message, "mend the fixture")];
        }
    };
    let looser = calibrated.spread.looser(limits).into_iter().map(|(field, may_be, found)| {
        let message = format!(
            "`{field}`: expected at most {MARGIN} times the measured spread, {may_be}, found \
             {found}"
        );
        let help = format!("{} calibrate {} says what is justified", command(), case.name);
        let path = ["check".into(), "limits".into(), field.into()];
        finding(case, &RULE, &path, message, help)
    });
    looser.collect()
}
