//! A plan from a file, for the fixtures of a suite.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use harness::fixture::{Build, Fixture};
use harness::store;
use harness::suite::Suite;
use interchange::Feature;
use rayon::prelude::*;

use super::Plan;
use super::plan::MAX_BYTES;
use crate::asks;

impl Plan {
    /// The plan of the rubric in the file at `path` for these fixtures of a suite.
    ///
    /// # Errors
    /// Everything that is wrong with the rubric, or a fixture that is none; as text for
    /// people.
    pub fn open(path: &Path, suite: &Suite, names: &[String]) -> Result<Self, String> {
        let label = path.display();
        let bytes = store::read(path, MAX_BYTES as u64).map_err(|error| error.to_string())?;
        let bytes =
            bytes.ok_or_else(|| format!("{label}: expected a rubric, found no such file"))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            format!("{label}: expected UTF-8 text, found another byte at offset {at}")
        })?;
        // Each is rendered to be known, so many at a time.
        let fixtures: Vec<_> = names.par_iter().map(|name| asked(suite, name)).collect();
        let fixtures = names.iter().zip(fixtures).map(|(name, asked)| Ok((name.clone(), asked?)));
        let fixtures: BTreeMap<_, _> = fixtures.collect::<Result<_, String>>()?;
        Self::read(&text, &fixtures)
            .map_err(|problems| scene::report(&label.to_string(), &text, &problems))
    }
}

/// What a fixture's picture asks for.
fn asked(suite: &Suite, name: &str) -> Result<BTreeSet<Feature>, String> {
    let label = Suite::fixture_label(name);
    let fixture = Fixture::open(&label, &suite.fixture_path(name), Build::default())?;
    Ok(asks(&fixture, &fixture.render_linear()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: &str = "(version: 1, image: (4, 4), show: Silhouette,
        camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40),
        objects: [Sphere(center: (0, 0, 0), radius: 1)])";

    #[track_caller]
    fn check(rubric: Option<&[u8]>, expected: &str) {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, bytes: &[u8]| {
            store::write(&folder.path().join(name), bytes).unwrap();
        };
        write("fixtures/ball.ron", BALL.as_bytes());
        if let Some(rubric) = rubric {
            write("rubric.ron", rubric);
        }
        let suite = Suite::open(folder.path()).unwrap();
        let path = folder.path().join("rubric.ron");
        let found = match Plan::open(&path, &suite, &["ball".to_owned()]) {
            Ok(plan) => format!("{} parts of {:?}", plan.parts.len(), plan.asked()),
            Err(why) => {
                let why = why.replace(&path.display().to_string(), "R");
                // Behind the first line is the place, drawn.
                why.lines().next().unwrap_or_default().to_owned()
            }
        };
        assert_eq!(found, expected);
    }

    #[test]
    fn a_rubric_is_read_or_told_why_not() {
        check(None, "R: expected a rubric, found no such file");
        check(Some(b"(\xff"), "R: expected UTF-8 text, found another byte at offset 1");
        check(
            Some(b"(version: 1, title: \"t\", parts: [(name: \"a\", points: 1, fixtures: [\"bal1\"])])"),
            "R:1:68: the filter \"bal1\" selects nothing; did you mean \"ball\"?",
        );
        let good =
            b"(version: 1, title: \"t\", parts: [(name: \"a\", points: 1, features: [Sphere])])";
        check(Some(good), "1 parts of {\"ball\"}");
    }
}
